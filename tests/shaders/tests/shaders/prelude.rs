//! The elementary functions of shaders: their errors against `f64`, and those of the crate in `f32`.

use brdf::Real;
use brdf::wgsl::{Expr, Module};
use brdf_shaders::device::{Device, Program};

/// What a function is in three numbers, and where it is asked.
struct Function {
    name: &'static str,
    symbol: fn(Expr, Expr) -> Expr,
    single: fn(f32, f32) -> f32,
    double: fn(f64, f64) -> f64,
    arguments: Vec<[f32; 2]>,
    /// The largest error allowed, in units in the last place.
    bound: f64,
    /// An error that is allowed beside, relative to 1 + |x|.
    absolute: f64,
}

/// Numbers in a range: evenly spread, of every magnitude, and close to both ends and to 0.
fn sweep(lower: f32, upper: f32) -> Vec<f32> {
    let (low, high) = (f64::from(lower), f64::from(upper));
    let even = (0..=40_000).map(|i| (low + (high - low) * f64::from(i) / 40_000.0) as f32);
    let magnitudes = (0..40_000_u32).map(|i| {
        let magnitude = f32::from_bits(i.wrapping_mul(0x9e37_79b9) >> 1);
        if i % 2 == 0 { magnitude } else { -magnitude }
    });
    let near = [lower, upper, 0.0, 1.0, -1.0, 0.5].into_iter().flat_map(|center: f32| {
        (0..500_u32).flat_map(move |i| {
            let bits = center.to_bits();
            [f32::from_bits(bits.wrapping_add(i)), f32::from_bits(bits.wrapping_sub(i))]
        })
    });
    let all = even.chain(magnitudes).chain(near);
    // Devices may take subnormal numbers for 0.
    all.filter(|x| (lower..=upper).contains(x) && (x.is_normal() || *x == 0.0)).collect()
}

fn of_one(lower: f32, upper: f32) -> Vec<[f32; 2]> {
    sweep(lower, upper).into_iter().map(|x| [x, 0.0]).collect()
}

fn of_two(first: [f32; 2], second: [f32; 2]) -> Vec<[f32; 2]> {
    let (xs, ys) = (sweep(first[0], first[1]), sweep(second[0], second[1]));
    let pairs = (0..200_000_usize).map(|i| [xs[i * 7919 % xs.len()], ys[i * 104_729 % ys.len()]]);
    pairs.collect()
}

macro_rules! function {
    ($method:ident, $bound:expr, $absolute:expr, $arguments:expr) => {
        Function {
            name: stringify!($method),
            symbol: |x, _| Real::$method(x),
            single: |x, _| Real::$method(x),
            double: |x, _| Real::$method(x),
            arguments: $arguments,
            bound: $bound,
            absolute: $absolute,
        }
    };
    (2 $method:ident, $bound:expr, $arguments:expr) => {
        Function {
            name: stringify!($method),
            symbol: |x, y| Real::$method(x, y),
            single: |x, y| Real::$method(x, y),
            double: |x, y| Real::$method(x, y),
            arguments: $arguments,
            bound: $bound,
            absolute: 0.0,
        }
    };
}

fn functions() -> Vec<Function> {
    let tiny = f32::MIN_POSITIVE;
    vec![
        function!(rsqrt, 1.5, 0.0, of_one(tiny, f32::MAX)),
        function!(exp, 1.3, 0.0, of_one(-87.0, 88.7)),
        function!(exp_m1, 1.3, 0.0, of_one(-110.0, 88.7)),
        function!(ln, 0.85, 0.0, of_one(tiny, f32::MAX)),
        function!(ln_1p, 1.4, 0.0, of_one(-0.99999994, f32::MAX)),
        function!(ln_1p, 1.4, 0.0, of_one(-0.99999994, 4.0)),
        function!(sin, 1.1, 0.0, of_one(-7.0, 7.0)),
        function!(sin, 1.1, 0.0, of_one(-1e4, 1e4)),
        function!(cos, 1.1, 0.0, of_one(-7.0, 7.0)),
        function!(cos, 1.1, 0.0, of_one(-1e4, 1e4)),
        function!(tan, 3.0, 0.0, of_one(-1e4, 1e4)),
        function!(asin, 2.2, 0.0, of_one(-1.0, 1.0)),
        function!(acos, 1.25, 0.0, of_one(-1.0, 1.0)),
        function!(angle_squared, 1.0, 0.0, of_one(0.0, 1.0)),
        function!(erf, 2.0, 0.0, of_one(-12.0, 12.0)),
        function!(erfc, 5.0, 0.0, of_one(-12.0, 9.0)),
        function!(erfcx, 6.0, 0.0, of_one(0.0, 1e30)),
        function!(ierfc, 0.0, 3.2e-7, of_one(0.0, 1e30)),
        function!(erf_inv, 3.5, 0.0, of_one(-0.99999994, 0.99999994)),
        function!(floor, 0.0, 0.0, of_one(-1e9, 1e9)),
        function!(2 powf, 1.6, of_two([tiny, 2.0], [-40.0, 40.0])),
        function!(2 powf, 4.5, of_two([0.5, 2.0], [-2000.0, 2000.0])),
        function!(2 powf, 1.6, of_two([tiny, f32::MAX], [-3.0, 3.0])),
        function!(2 atan2, 1.6, of_two([-2.0, 2.0], [-2.0, 2.0])),
        function!(2 decay, 2.0, of_two([0.0, 100.0], [1e-3, 1e9])),
        function!(2 copysign, 0.0, of_two([-2.0, 2.0], [-2.0, 2.0])),
        function!(2 min, 0.0, of_two([-2.0, 2.0], [-2.0, 2.0])),
        Function {
            name: "clamp",
            symbol: |x, y| x.clamp(-y, y),
            single: |x, y| Real::clamp(x, -y, y),
            double: |x, y| Real::clamp(x, -y, y),
            arguments: of_two([-2.0, 2.0], [0.0, 1.0]),
            bound: 0.0,
            absolute: 0.0,
        },
        // Of values above 1/e.
        Function {
            name: "power_of_part",
            symbol: |x, y| Expr::one().power_of_part(x, y),
            single: |x, y| 1.0_f32.power_of_part(x, y),
            double: |x, y| 1.0_f64.power_of_part(x, y),
            arguments: of_two([1e-30, 1e-3], [0.0, 1000.0]),
            bound: 3.0,
            absolute: 0.0,
        },
        Function {
            name: "sin of turns",
            symbol: |x, _| x.sin_cos_turns().0,
            single: |x, _| x.sin_cos_turns().0,
            double: |x, _| x.sin_cos_turns().0,
            arguments: of_one(-1e6, 1e6),
            bound: 2.2,
            absolute: 0.0,
        },
        Function {
            name: "cos of turns",
            symbol: |x, _| x.sin_cos_turns().1,
            single: |x, _| x.sin_cos_turns().1,
            double: |x, _| x.sin_cos_turns().1,
            arguments: of_one(-2.0, 2.0),
            bound: 2.2,
            absolute: 0.0,
        },
    ]
}

/// The error in units in the last place of the exact result.
fn ulps(got: f32, exact: f64) -> f64 {
    let exponent = exact.abs().max(f64::from(f32::MIN_POSITIVE)).log2().floor();
    (f64::from(got) - exact).abs() / (exponent - 23.0).exp2()
}

#[test]
fn every_function_is_as_exact_as_it_says() {
    let Some(device) = Device::find() else { return };
    let mut failures = Vec::new();
    for function in functions() {
        let mut module = Module::new();
        module
            .add_function("tested", ["x", "y"], |(x, y)| (function.symbol)(x, y))
            .expect("a name");
        let given: Vec<f32> = function.arguments.iter().flatten().copied().collect();
        let program = Program {
            text: &module.to_string(),
            statements: "    answers[to] = tested(given[at], given[at + 1u]);",
            inputs: 2,
            outputs: 1,
        };
        let answers = device.compile(&program).run(&given, None);
        let error = |got: f32, [x, y]: [f32; 2]| {
            let exact = (function.double)(x.into(), y.into());
            if exact.abs() > f32::MAX.into()
                || (exact.abs() < f32::MIN_POSITIVE.into() && got.abs() < f32::MIN_POSITIVE)
            {
                return 0.0;
            }
            let beside = function.absolute * (1.0 + f64::from(x.abs()));
            if (f64::from(got) - exact).abs() <= beside { 0.0 } else { ulps(got, exact) }
        };
        let (mut worst, mut at, mut own) = (0.0, [0.0; 2], 0.0_f64);
        for (&arguments, &got) in function.arguments.iter().zip(&answers) {
            let found = error(got, arguments);
            if found.is_nan() || found > worst {
                (worst, at) = (found, arguments);
            }
            own = own.max(error((function.single)(arguments[0], arguments[1]), arguments));
        }
        println!("{:15} {worst:6.2} ulp at {at:?}, crate {own:.2}", function.name);
        let within = worst <= function.bound;
        if !within {
            failures.push(format!("{}: {worst} ulp at {at:?}", function.name));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
