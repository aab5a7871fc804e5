//! The elementary functions: their error in units in the last place (ulp), their limits, and
//! that lanes, builds and machines agree to the bit.

use brdf::{Lanes, Real};

/// Error of a single-precision value in ulp of the exact result.
fn ulps_single(got: f32, exact: f64) -> f64 {
    if f64::from(got) == exact || (exact.abs() > 3.402823567797337e38 && got.is_infinite()) {
        return 0.0;
    }
    let exponent = exact.abs().max(f64::from(f32::MIN_POSITIVE)).log2().floor();
    (f64::from(got) - exact).abs() / (exponent - 23.0).exp2()
}

/// Pseudo-random 64-bit words (Weyl sequence through a mixer).
fn words(seed: u64) -> impl Iterator<Item = u64> {
    (1_u64..).map(move |i| {
        let x = (i.wrapping_add(seed << 32)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    })
}

/// Arguments in `lower..=upper`: evenly spread, of every magnitude, and close to both ends, to 1
/// and to −1.
fn sweep(lower: f32, upper: f32) -> Vec<f32> {
    const EVEN: usize = 200_000;
    let (low, high) = (f64::from(lower), f64::from(upper));
    let even = (0..=EVEN).map(|i| (low + (high - low) * i as f64 / EVEN as f64) as f32);
    let patterns = words(1).take(400_000).map(|word| f32::from_bits(word as u32));
    let near = [lower, upper, 1.0, -1.0, 0.0, 0.5, -0.5].into_iter().flat_map(|center: f32| {
        (0..2_000_u32).flat_map(move |i| {
            let bits = center.to_bits();
            [f32::from_bits(bits.wrapping_add(i)), f32::from_bits(bits.wrapping_sub(i))]
        })
    });
    even.chain(patterns).chain(near).filter(|x| (lower..=upper).contains(x)).collect()
}

/// All numbers from one on until the double of it.
fn octave(first: f32) -> Vec<f32> {
    (first.to_bits()..(2.0 * first).to_bits()).map(f32::from_bits).collect()
}

/// Asserts the largest error over the arguments.
fn check_single(
    name: &str,
    arguments: &[f32],
    bound: f64,
    function: impl Fn(f32) -> f32,
    exact: impl Fn(f64) -> f64,
) {
    assert!(arguments.len() > 10_000, "{name}: only {} arguments", arguments.len());
    let mut worst = (0.0, 0.0_f32);
    for &x in arguments {
        let error = ulps_single(function(x), exact(f64::from(x)));
        if error.is_nan() || error > worst.0 {
            worst = (error, x);
        }
    }
    println!("{name}: {:.3} ulp at {:e}", worst.0, worst.1);
    assert!(worst.0 <= bound, "{name}: {} ulp at {:e}, bound {bound}", worst.0, worst.1);
}

#[test]
fn exponential_single() {
    check_single("exp", &sweep(-110.0, 90.0), 1.0, Real::exp, f64::exp);
    check_single("exp_m1", &sweep(-110.0, 90.0), 1.3, Real::exp_m1, f64::exp_m1);
    check_single("exp_m1", &octave(0.25), 1.3, Real::exp_m1, f64::exp_m1);
}

#[test]
fn logarithm_single() {
    check_single("ln", &sweep(0.0, f32::MAX), 0.85, Real::ln, f64::ln);
    check_single("ln near 1", &octave(1.0), 0.85, Real::ln, f64::ln);
    check_single("ln_1p", &sweep(-1.0, f32::MAX), 1.4, Real::ln_1p, f64::ln_1p);
    check_single("ln_1p near 0", &sweep(-1.0, 4.0), 1.4, Real::ln_1p, f64::ln_1p);
}

#[test]
fn power_single() {
    for exponent in [0.1_f32, 1.0 / 3.0, 0.5, 1.0, 2.0, 2.4, 5.0, 50.0, 500.0, -1.0, -3.7, -40.0] {
        for arguments in [sweep(0.0, f32::MAX), sweep(0.0, 2.0)] {
            check_single(
                &format!("powf {exponent}"),
                &arguments,
                0.55,
                |x| Real::powf(x, exponent),
                |x| x.powf(f64::from(exponent)),
            );
        }
    }
    for base in [1e-40_f32, 1e-3, 0.5, 0.9999, 1.0001, 7.3, 1e30] {
        check_single(
            &format!("{base} to the power"),
            &sweep(-2000.0, 2000.0),
            0.55,
            |y| Real::powf(base, y),
            |y| f64::from(base).powf(y),
        );
    }
}

#[test]
fn trigonometric_single() {
    for range in [1.6, 7.0, 1e4] {
        let arguments = sweep(-range, range);
        check_single("sin", &arguments, 1.1, Real::sin, f64::sin);
        check_single("cos", &arguments, 1.1, Real::cos, f64::cos);
        check_single("tan", &arguments, 0.55, Real::tan, f64::tan);
    }
}

/// Where an angle has lost its meaning, what is answered is still a sine and a cosine.
#[test]
fn trigonometric_of_huge_angles() {
    let single = (1e4_f32.to_bits()..f32::MAX.to_bits()).step_by(997).map(f32::from_bits);
    for x in single.chain([-1.7718401e11, 3.9975183e12, f32::MAX]) {
        let ((sin, cos), (turn_sin, turn_cos)) = (Real::sin_cos(x), x.sin_cos_turns());
        assert!(sin.abs() <= 1.0 && cos.abs() <= 1.0, "{x:e}: {sin}, {cos}");
        assert!(turn_sin.abs() <= 1.0 && turn_cos.abs() <= 1.0, "{x:e}: {turn_sin}, {turn_cos}");
    }
    let step = (f64::MAX.to_bits() - 1e6_f64.to_bits()) / 1_000_003;
    for x in (0..1_000_003).map(|i| f64::from_bits(1e6_f64.to_bits() + i * step)) {
        let ((sin, cos), (turn_sin, turn_cos)) = (Real::sin_cos(x), x.sin_cos_turns());
        assert!(sin.abs() <= 1.0 && cos.abs() <= 1.0, "{x:e}: {sin}, {cos}");
        assert!(turn_sin.abs() <= 1.0 && turn_cos.abs() <= 1.0, "{x:e}: {turn_sin}, {turn_cos}");
    }
}

/// Sine and cosine of turns, with the quarters taken out before anything is rounded.
fn exact_turns(x: f64) -> (f64, f64) {
    let quarters = (4.0 * x).round();
    let (sin, cos) = (std::f64::consts::TAU * (x - 0.25 * quarters)).sin_cos();
    match quarters.rem_euclid(4.0) {
        0.0 => (sin, cos),
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[test]
fn turns_single() {
    let worst = octave(1.0 / 1024.0);
    for arguments in [worst, sweep(-0.5, 0.5), sweep(-1.0, 1.0), sweep(-1e3, 1e3)] {
        check_single("sin_turns", &arguments, 2.2, |x| x.sin_cos_turns().0, |x| exact_turns(x).0);
        check_single("cos_turns", &arguments, 2.0, |x| x.sin_cos_turns().1, |x| exact_turns(x).1);
    }
}

#[test]
fn arc_single() {
    let arguments = sweep(-1.0, 1.0);
    check_single("asin", &arguments, 0.55, Real::asin, f64::asin);
    check_single("acos", &arguments, 1.2, Real::acos, f64::acos);
    for other in [1e-30_f32, 1e-3, 0.5, 1.0, 3.0, 1e10] {
        for other in [other, -other] {
            for arguments in [sweep(-f32::MAX, f32::MAX), sweep(-4.0, 4.0)] {
                check_single(
                    "atan2",
                    &arguments,
                    1.6,
                    |y| Real::atan2(y, other),
                    |y| y.atan2(f64::from(other)),
                );
            }
        }
    }
}

#[test]
fn reciprocal_root_single() {
    let arguments = sweep(f32::MIN_POSITIVE, f32::MAX);
    check_single("rsqrt", &arguments, 1.5, Real::rsqrt, |x| 1.0 / x.sqrt());
    // All that differ by more than an even power of two.
    for first in [1.0, 2.0] {
        check_single("rsqrt", &octave(first), 1.5, Real::rsqrt, |x| 1.0 / x.sqrt());
    }
    assert!(Real::rsqrt(0.0_f32) < f32::MAX);
}

#[test]
fn reciprocal_root_double() {
    let exponents = (-1022..=1020).map(|exponent| 2.0_f64.powi(exponent));
    let ends = [f64::MIN_POSITIVE, f64::MAX, 1.0, 2.0, 4.0];
    let arguments = exponents.zip(words(6)).map(|(power, word)| power * mantissa(word));
    let octaves = words(7).take(1_000_000).map(|word| mantissa(word) * (1 + word % 2) as f64);
    let mut worst = 0.0_f64;
    for x in ends.into_iter().chain(arguments).chain(octaves) {
        let y = Real::rsqrt(x);
        // 1 − xy² with twice the digits is twice the relative error.
        let product = x * y;
        let rest = (-product).mul_add(y, 1.0) - x.mul_add(y, -product) * y;
        let ulp = f64::from_bits(y.to_bits() + 1) - y;
        worst = worst.max((0.5 * rest * y / ulp).abs());
    }
    assert!(worst > 0.5 && worst <= 1.5, "{worst} ulp");
    assert!(Real::rsqrt(0.0_f64) < f64::MAX);
}

/// Of a word, in [1, 2).
fn mantissa(word: u64) -> f64 {
    f64::from_bits(1.0_f64.to_bits() | (word >> 12))
}

#[test]
fn angle_squared_single() {
    // acos(1 − x) = 2 asin √(x/2), which has digits near 0.
    let exact = |x: f64| (2.0 * (0.5 * x).sqrt().asin()).powi(2);
    check_single("angle_squared", &sweep(0.0, 1.0), 1.0, Real::angle_squared, exact);
}

/// The largest error of the logarithm in (x/(x + rest))ⁿ, in units of the logarithm's last place,
/// and that of the exponential, seen where the logarithm is small.
#[test]
fn power_of_part_single() {
    let mut worst = 0.0_f64;
    for (x, y) in words(8).take(2_000_000).zip(words(9)) {
        let unit = |word: u64| (word >> 40) as f64 / (1 << 24) as f64;
        let (x, rest) =
            (2.0_f64.powf(60.0 * unit(x) - 30.0), 2.0_f64.powf(160.0 * unit(y) - 100.0));
        let (x, rest) = (x as f32, rest as f32);
        let exact = -(f64::from(rest) / f64::from(x)).ln_1p();
        // As large an exponent as the result can bear.
        for power in [0.01, 1.0, 80.0] {
            let exponent = (power / -exact) as f32;
            let depth = -exact * f64::from(exponent);
            let want = (-depth).exp();
            let got = f64::from(Real::power_of_part(x, rest, exponent));
            let unit = 0.5 * f64::from(f32::EPSILON);
            worst = worst.max(((got / want - 1.0).abs() / unit - 2.0) / depth.max(1.0));
        }
    }
    println!("power_of_part: {worst:.3} units of rounding for each unit of the logarithm");
    assert!(worst < 9.0, "{worst}");
    assert_eq!(Real::power_of_part(0.25_f32, 0.75, 0.0), 1.0);
    assert_eq!(Real::power_of_part(1e-30_f32, 1.0, 1e8), 0.0);
}

#[test]
fn power_of_part_double() {
    let mut worst = 0.0_f64;
    for (x, y) in words(8).take(200_000).zip(words(9)) {
        let unit = |word: u64| (word >> 40) as f64 / (1 << 24) as f64;
        let (x, rest) =
            (2.0_f64.powf(60.0 * unit(x) - 30.0), 2.0_f64.powf(160.0 * unit(y) - 100.0));
        let exact = -(rest / x).ln_1p();
        for power in [0.01, 1.0, 80.0, 600.0] {
            let exponent = power / -exact;
            let got = Real::power_of_part(x, rest, exponent);
            let unit = 0.5 * f64::EPSILON;
            worst = worst.max(((got / (-power).exp() - 1.0).abs() / unit - 2.0) / power.max(1.0));
        }
    }
    println!("power_of_part: {worst:.3} units of rounding for each unit of the logarithm");
    assert!(worst < 7.0, "{worst}");
    assert_eq!(Real::power_of_part(0.25_f64, 0.75, 0.0), 1.0);
    assert_eq!(Real::power_of_part(1e-300_f64, 1.0, 1e8), 0.0);
}

#[test]
fn error_function_single() {
    check_single("erf", &sweep(-12.0, 12.0), 0.55, Real::erf, libm::erf);
    check_single("erfc", &sweep(-12.0, 12.0), 0.6, Real::erfc, libm::erfc);
    // The reference: one step of Newton's method in f64, from the value found.
    let below_one = 1.0 - f32::EPSILON / 2.0;
    let exact = |x: f64| {
        let y = f64::from(Real::erf_inv(x as f32));
        let excess = if y.abs() < 0.5 {
            libm::erf(y) - x
        } else {
            ((1.0 - x.abs()) - libm::erfc(y.abs())) * x.signum()
        };
        y - excess / (core::f64::consts::FRAC_2_SQRT_PI * (-y * y).exp())
    };
    check_single("erf_inv", &sweep(-below_one, below_one), 3.5, Real::erf_inv, exact);
}

#[test]
fn scaled_error_function_single() {
    let mut worst = 0.0_f64;
    let dense = (1e-3_f32.to_bits()..20.0_f32.to_bits()).step_by(41).map(f32::from_bits);
    for x in dense.chain(sweep(0.0, 20.0)).chain(sweep(0.0, f32::MAX)) {
        let exact = Real::erfcx(f64::from(x));
        // Below the least normal number there are fewer digits.
        let allowed = exact.max(f64::from(f32::MIN_POSITIVE));
        worst = worst.max(((f64::from(Real::erfcx(x)) - exact) / allowed).abs());
    }
    assert!(worst < 3.5e-7, "{worst:e}");
}

/// In `f32` it is accurate relative to the sum it serves.
#[test]
fn integral_of_the_error_function_single() {
    let mut worst = 0.0_f64;
    for x in sweep(0.0, 8.0) {
        let sum = f64::from(x) + Real::ierfc(f64::from(x));
        worst = worst.max((f64::from(x + Real::ierfc(x)) / sum - 1.0).abs());
    }
    assert!(worst < 3.2e-7, "{worst:e}");
    assert_eq!(1e3 + Real::ierfc(1e3_f32), 1e3);
    assert!(Real::ierfc(f32::MAX) < 1e-8);
}

/// Of normally distributed numbers, with z = 0 and with z far above the deviation.
#[test]
fn mean_magnitude_single() {
    let mut worst = 0.0_f64;
    for z in [1e-6_f32, 0.1, 0.7, 1.0] {
        for ratio in sweep(-4.0, 12.0) {
            let square = z * z * Real::exp(-ratio);
            let exact = Real::mean_magnitude(f64::from(z), f64::from(square));
            worst = worst.max((f64::from(Real::mean_magnitude(z, square)) / exact - 1.0).abs());
        }
    }
    assert!(worst < 3.8e-7, "{worst:e}");
    assert_eq!(Real::mean_magnitude(0.0_f32, 0.25), 0.5);
    assert_eq!(Real::mean_magnitude(1.0_f32, 1e-36), 1.0);
}

/// z erf ν + √Q exp(−ν²) itself.
#[test]
fn mean_magnitude_double() {
    let mut worst = 0.0_f64;
    for nu in (0..600).map(|i| 0.01 * f64::from(i)) {
        let deviation = 0.3;
        let z = nu * deviation * core::f64::consts::PI.sqrt();
        let exact = z * libm::erf(nu) + deviation * libm::exp(-nu * nu);
        let found = Real::mean_magnitude(z, deviation * deviation);
        worst = worst.max((found / exact - 1.0).abs());
    }
    assert!(worst < 1e-15, "{worst:e}");
}

/// Powers of two that keep their digits until the product is below the least normal number.
#[test]
fn decay_single() {
    let mut worst = 0.0_f64;
    for x in sweep(0.0, 160.0) {
        for factor in [1e-6_f32, 1.0, 0.3, 1e9, 3e20] {
            let exact = libm::exp2(-f64::from(x)) * f64::from(factor);
            let found = f64::from(Real::decay(x, factor));
            if exact > 1.2e-38 {
                worst = worst.max((found / exact - 1.0).abs());
            } else {
                assert!(found < 1.2e-38, "{x} {factor}");
            }
        }
    }
    assert!(worst < 1.7e-7, "{worst:e}");
    assert_eq!(Real::decay(f32::MAX, 1e30), 0.0);
    assert_eq!(Real::decay(f32::NAN, 1.0), 0.0);
}

#[test]
fn decay_double() {
    let mut worst = 0.0_f64;
    for x in (0..20000).map(|i| 0.037 * f64::from(i)) {
        worst = worst.max((Real::decay(x, 3.0) / (libm::exp2(-x) * 3.0) - 1.0).abs());
    }
    assert!(worst < 3.4e-16, "{worst:e}");
    assert_eq!(Real::decay(f64::MAX, 1e30), 0.0);
    assert_eq!(Real::decay(f64::NAN, 1.0), 0.0);
}

/// In `f64` it is accurate also relative to its own size.
#[test]
fn integral_of_the_error_function_double() {
    let mut rows = 0;
    for reference in references("ierfc") {
        let x = reference.x;
        let error = reference.error(Real::ierfc(x)).abs();
        assert!(error <= 1e-15 * (x + reference.high), "{x:e}: {error:e} of the sum");
        assert!(error <= (1e-15 + 1.2e-16 * x * x) * reference.high, "{x:e}: {error:e}");
        rows += 1;
    }
    assert!(rows >= 250, "{rows} rows");
}

/// One row of the reference table: value = `high` + `low`.
struct Reference<'a> {
    function: &'a str,
    x: f64,
    y: f64,
    high: f64,
    low: f64,
}

impl<'a> Reference<'a> {
    fn parse(line: &'a str) -> Self {
        let mut fields = line.split(',');
        let function = fields.next().unwrap();
        let mut bits = || f64::from_bits(u64::from_str_radix(fields.next().unwrap(), 16).unwrap());
        let (x, y, high) = (bits(), bits(), bits());
        Self { function, x, y, high, low: fields.next().unwrap().parse().unwrap() }
    }

    /// By how much a value exceeds the exact one.
    fn error(&self, got: f64) -> f64 {
        (got - self.high) - self.low
    }

    /// Error of a value in ulp of the exact result.
    fn ulps(&self, got: f64) -> f64 {
        // The ulp of the exact value, which may lie just below a power of two that `high` is.
        let magnitude = self.high.abs();
        let below = self.low * self.high.signum() < 0.0;
        let bits = magnitude.to_bits() - u64::from(below);
        let ulp = f64::from_bits(bits + 1) - f64::from_bits(bits);
        self.error(got).abs() / ulp
    }
}

/// The rows of the reference table for a function.
fn references(function: &str) -> impl Iterator<Item = Reference<'static>> {
    const TABLE: &str = include_str!("data/elementary.csv");
    let rows = TABLE.lines().filter(|line| !line.starts_with('#')).map(Reference::parse);
    rows.filter(move |row| row.function == function)
}

#[test]
fn double() {
    type Function = fn(f64, f64) -> f64;
    let functions: [(&str, f64, Function); 17] = [
        ("exp", 1.0, |x, _| Real::exp(x)),
        ("exp_m1", 1.25, |x, _| Real::exp_m1(x)),
        ("ln", 0.8, |x, _| Real::ln(x)),
        ("ln_1p", 1.4, |x, _| Real::ln_1p(x)),
        ("powf", 1.4, |x, y| Real::powf(x, y)),
        ("sin", 1.0, |x, _| Real::sin(x)),
        ("cos", 1.0, |x, _| Real::cos(x)),
        ("sin_turns", 1.7, |x, _| Real::sin_cos_turns(x).0),
        ("cos_turns", 1.7, |x, _| Real::sin_cos_turns(x).1),
        ("tan", 1.3, |x, _| Real::tan(x)),
        ("asin", 1.0, |x, _| Real::asin(x)),
        ("acos", 1.25, |x, _| Real::acos(x)),
        ("angle_squared", 1.0, |x, _| Real::angle_squared(x)),
        ("atan2", 1.4, |y, x| Real::atan2(y, x)),
        ("erf", 1.25, |x, _| Real::erf(x)),
        ("erfc", 1.5, |x, _| Real::erfc(x)),
        ("erf_inv", 2.0, |x, _| Real::erf_inv(x)),
    ];
    for (name, bound, function) in functions {
        let (mut worst, mut rows) = ((0.0, 0.0, 0.0), 0);
        for reference in references(name) {
            let error = reference.ulps(function(reference.x, reference.y));
            rows += 1;
            if error.is_nan() || error > worst.0 {
                worst = (error, reference.x, reference.y);
            }
        }
        println!("{name}: {:.3} ulp at {:e}, {:e}", worst.0, worst.1, worst.2);
        assert!(rows >= 250, "{name}: {rows} rows");
        assert!(worst.0 <= bound, "{name}: {worst:?}, bound {bound}");
    }
}

/// Limits, zeros, infinities and arguments outside the domain.
macro_rules! limits {
    ($name:ident, $float:ident, $overflow:literal, $underflow:literal, $huge:literal) => {
        #[test]
        fn $name() {
            use core::$float::consts::{FRAC_PI_2, PI};
            const NAN: $float = $float::NAN;
            const INFINITY: $float = $float::INFINITY;
            let negative = |x: $float| x == 0.0 && x.is_sign_negative();

            assert_eq!(Real::exp(0.0 as $float), 1.0);
            assert_eq!(Real::exp($overflow as $float), INFINITY);
            assert_eq!(Real::exp($underflow as $float), 0.0);
            assert_eq!(Real::exp(INFINITY), INFINITY);
            assert_eq!(Real::exp(-INFINITY), 0.0);
            assert!(Real::exp(NAN).is_nan());
            assert_eq!(Real::exp_m1(INFINITY), INFINITY);
            assert_eq!(Real::exp_m1(-$float::MAX), -1.0);
            assert!(negative(Real::exp_m1(-0.0 as $float)));

            assert_eq!(Real::ln(1.0 as $float), 0.0);
            assert_eq!(Real::ln(0.0 as $float), -INFINITY);
            assert_eq!(Real::ln(INFINITY), INFINITY);
            assert!(Real::ln(-1.0 as $float).is_nan());
            assert!(Real::ln(NAN).is_nan());
            assert_eq!(Real::ln_1p(-1.0 as $float), -INFINITY);
            assert!(Real::ln_1p(-1.5 as $float).is_nan());
            assert!(negative(Real::ln_1p(-0.0 as $float)));

            assert_eq!(Real::powf(0.0 as $float, 0.0), 1.0);
            assert_eq!(Real::powf(0.0 as $float, 1e-3), 0.0);
            assert_eq!(Real::powf(0.0 as $float, -2.0), INFINITY);
            assert_eq!(Real::powf(1.0 as $float, $huge), 1.0);
            assert_eq!(Real::powf(0.5 as $float, $huge), 0.0);
            assert_eq!(Real::powf(0.5 as $float, -$huge), INFINITY);
            assert_eq!(Real::powf(INFINITY, 2.0), INFINITY);
            assert_eq!(Real::powf(INFINITY, -2.0), 0.0);
            assert_eq!(Real::powf(3.0 as $float, 1.0), 3.0);
            assert!(Real::powf(-1.0 as $float, 0.5).is_nan());

            assert!(negative(Real::sin(-0.0 as $float)));
            assert!(negative(Real::tan(-0.0 as $float)));
            for x in words(2).take(100_000).map(|word| $float::from_bits(word as _)) {
                let (sin, cos) = Real::sin_cos(x);
                if x.is_finite() {
                    assert!(sin.abs() <= 1.0 && cos.abs() <= 1.0, "{x:e}: {sin:e} {cos:e}");
                }
            }

            assert_eq!(Real::acos(1.0 as $float), 0.0);
            assert_eq!(Real::acos(2.0 as $float), 0.0);
            assert_eq!(Real::acos(-2.0 as $float), PI);
            assert_eq!(Real::asin(2.0 as $float), FRAC_PI_2);
            assert_eq!(Real::asin(-2.0 as $float), -FRAC_PI_2);
            assert!(negative(Real::asin(-0.0 as $float)));
            assert_eq!(Real::atan2(0.0 as $float, 0.0), 0.0);
            assert_eq!(Real::atan2(0.0 as $float, -1.0), PI);
            let near = |a: $float, b: $float| (a - b).abs() <= b.abs() * $float::EPSILON;
            assert!(near(Real::atan2($float::MAX, $float::MAX), PI / 4.0));
            assert!(near(Real::atan2(-$float::MAX, $float::MAX), -PI / 4.0));
            assert!(near(Real::atan2(INFINITY, -INFINITY), 0.75 * PI));
            assert_eq!(Real::atan2(1.0, -INFINITY), PI);
            assert_eq!(Real::atan2(-1.0 as $float, 0.0), -FRAC_PI_2);
            assert!(negative(Real::atan2(-0.0 as $float, 1.0)));

            assert_eq!(Real::erf($float::MAX), 1.0);
            assert_eq!(Real::erfc($float::MAX), 0.0);
            assert_eq!(Real::erfc(-$float::MAX), 2.0);
            assert_eq!(Real::erfc(0.0 as $float), 1.0);
            assert!(negative(Real::erf(-0.0 as $float)));
            assert!(Real::erf_inv(1.0 as $float) < 6.0);
            assert_eq!(Real::erf_inv(1.0 as $float), Real::erf_inv(1.0 - $float::EPSILON / 2.0));
            assert_eq!(Real::erf_inv(-7.0 as $float), -Real::erf_inv(1.0 as $float));
            assert!(negative(Real::erf_inv(-0.0 as $float)));

            // The square root and the largest integer below, against the standard library.
            for x in words(3).take(100_000).map(|word| $float::from_bits(word as _)) {
                if !x.is_nan() {
                    assert_eq!(Real::floor(x).to_bits(), $float::floor(x).to_bits(), "{x:e}");
                    assert!(x < 0.0 || Real::sqrt(x) == $float::sqrt(x), "{x:e}");
                }
            }
            for i in -4000..4000 {
                let x = i as $float / 64.0;
                assert_eq!(Real::floor(x), $float::floor(x), "{x:e}");
            }
        }
    };
}
limits!(limits_single, f32, 89.0, -104.0, 1e30);
limits!(limits_double, f64, 710.0, -746.0, 1e300);

/// FNV-1a over 64-bit words.
fn checksum(bits: impl Iterator<Item = u64>) -> u64 {
    bits.fold(0xcbf2_9ce4_8422_2325, |hash, word| {
        word.to_le_bytes()
            .into_iter()
            .fold(hash, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    })
}

/// Every function on 4096 arguments: lanes against scalars, and a checksum of the bits that every
/// build on every machine must reproduce.
macro_rules! bits {
    ($name:ident, $float:ident, $lanes:literal, $($function:ident($lower:literal, $upper:literal) $checksum:literal)*) => {
        #[test]
        fn $name() {
            let arguments = |seed: u64, lower: f64, upper: f64| -> Vec<$float> {
                words(seed)
                    .take(4096)
                    .map(|word| {
                        let unit = (word >> 11) as f64 / (1_u64 << 53) as f64;
                        (lower + (upper - lower) * unit) as $float
                    })
                    .collect()
            };
            let mut wrong = Vec::new();
            $(
                // The second argument, for functions of two.
                let (x, y) = (arguments(4, $lower, $upper), arguments(5, -3.0, 3.0));
                let function = function!($function $float);
                let scalars: Vec<$float> = x.iter().zip(&y).map(|(&x, &y)| function(x, y)).collect();
                assert!(scalars.iter().all(|value| !value.is_nan()), stringify!($function));
                for ((x, y), scalar) in
                    x.chunks($lanes).zip(y.chunks($lanes)).zip(scalars.chunks($lanes))
                {
                    let (x, y) = (x.try_into().unwrap(), y.try_into().unwrap());
                    let lanes = function!($function Lanes<$float, $lanes>)(Lanes(x), Lanes(y)).0;
                    for (lane, scalar) in lanes.iter().zip(scalar) {
                        assert_eq!(lane.to_bits(), scalar.to_bits(), stringify!($function));
                    }
                }
                let found = checksum(scalars.iter().map(|value| u64::from(value.to_bits())));
                if found != $checksum {
                    wrong.push(format!("{} {found:#018x}", stringify!($function)));
                }
            )*
            assert!(wrong.is_empty(), "other bits than recorded: {wrong:#?}");
        }
    };
}

macro_rules! function {
    (powf $number:ty) => {
        |x: $number, y: $number| Real::powf(x, y)
    };
    (atan2 $number:ty) => {
        |y: $number, x: $number| Real::atan2(y, x)
    };
    (decay $number:ty) => {
        |x: $number, y: $number| Real::decay(x, y * y)
    };
    (mean_magnitude $number:ty) => {
        |x: $number, y: $number| Real::mean_magnitude(x, y * y)
    };
    (sin_turns $number:ty) => {
        |x: $number, _: $number| Real::sin_cos_turns(x).0
    };
    (cos_turns $number:ty) => {
        |x: $number, _: $number| Real::sin_cos_turns(x).1
    };
    ($function:ident $number:ty) => {
        |x: $number, _: $number| Real::$function(x)
    };
}

bits! {
    bits_single, f32, 16,
    floor(-100.0, 100.0) 0x6daa728019430034
    sqrt(0.0, 100.0) 0xbe8511ed962c8179
    rsqrt(0.0, 100.0) 0xa91233ab80788659
    exp(-100.0, 80.0) 0x71f66844adf19f4b
    exp_m1(-20.0, 80.0) 0x22cd1a779bb21fd0
    ln(0.0, 100.0) 0xe7e9dcc2e410daa6
    ln_1p(-1.0, 10.0) 0xe157c65ff11c5242
    powf(0.0, 40.0) 0xd131e9dcdbe2f3ea
    sin(-100.0, 100.0) 0xf9e8231218653f09
    cos(-100.0, 100.0) 0x251f782682e4f670
    sin_turns(-10.0, 10.0) 0x1e61989bc2b875f6
    cos_turns(-10.0, 10.0) 0x40294a94f45f7e71
    tan(-100.0, 100.0) 0xb40d43947750bd3b
    asin(-1.0, 1.0) 0x4568fe929415346d
    acos(-1.0, 1.0) 0x368d677894e142ba
    angle_squared(0.0, 1.0) 0xe4805b1a54c19d4e
    atan2(-3.0, 3.0) 0x432e0f954736f8b5
    erf(-5.0, 5.0) 0x38afbd3e4995d575
    erfc(-5.0, 9.0) 0xb8c5b4a7cb067efb
    erfcx(0.0, 20.0) 0x41571d90ad5ffc7e
    ierfc(0.0, 5.0) 0x38977ac123be2c3a
    decay(0.0, 150.0) 0xb1d2dc765ff8019b
    mean_magnitude(0.0, 5.0) 0xe4849ca444dee9ba
    erf_inv(-1.0, 1.0) 0x57bab2d979817fb5
}
bits! {
    bits_double, f64, 8,
    floor(-100.0, 100.0) 0xd849e256ba110ab2
    sqrt(0.0, 100.0) 0xf33b453c4cfc614e
    rsqrt(0.0, 100.0) 0xd7d75042468144f7
    exp(-100.0, 80.0) 0xd5d034de45a250cf
    exp_m1(-20.0, 80.0) 0x74e921db96ca46d6
    ln(0.0, 100.0) 0x5a0003c6cf289280
    ln_1p(-1.0, 10.0) 0xa668d0d5bb76a746
    powf(0.0, 40.0) 0xaab4ff0832e4dff0
    sin(-100.0, 100.0) 0x73ee920376a39332
    cos(-100.0, 100.0) 0x6e8f56999a689284
    sin_turns(-10.0, 10.0) 0x43948adc6e1419aa
    cos_turns(-10.0, 10.0) 0x2fd868a494313c16
    tan(-100.0, 100.0) 0xfdb5c51e7595681b
    asin(-1.0, 1.0) 0x48c456ca6daf2443
    acos(-1.0, 1.0) 0x542ed0d5a7e2e6a8
    angle_squared(0.0, 1.0) 0xb475227bf52b31a2
    atan2(-3.0, 3.0) 0x689baba004159ade
    erf(-5.0, 5.0) 0x3fe314bcfabfd621
    erfc(-5.0, 9.0) 0xfa862b7188b6eb79
    erfcx(0.0, 20.0) 0xf6cf434b879929c5
    ierfc(0.0, 5.0) 0x59b38d9c8612da74
    decay(0.0, 150.0) 0x8027ae0b975d537e
    mean_magnitude(0.0, 5.0) 0xfd77ea94f996ac4d
    erf_inv(-1.0, 1.0) 0x12a6c429103578c5
}
