//! The elementary functions against more precise values, in units in the last place (ulp).

use brdf::Real;

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

/// Asserts the largest error over the arguments.
fn check_single(
    name: &str,
    arguments: &[f32],
    bound: f64,
    function: impl Fn(f32) -> f32,
    exact: impl Fn(f64) -> f64,
) {
    assert!(arguments.len() > 10_000, "{name}: only {} arguments", arguments.len());
    let mut worst = (0.0, 0.0);
    for &x in arguments {
        let error = ulps_single(function(x), exact(f64::from(x)));
        if !(error <= worst.0) {
            worst = (error, x);
        }
    }
    println!("{name}: {:.3} ulp at {:e}", worst.0, worst.1);
    assert!(worst.0 <= bound, "{name}: {} ulp at {:e}, bound {bound}", worst.0, worst.1);
}

#[test]
fn exponential_single() {
    check_single("exp", &sweep(-110.0, 90.0), 1.5, Real::exp, f64::exp);
    check_single("exp_m1", &sweep(-110.0, 90.0), 1.5, Real::exp_m1, f64::exp_m1);
}

#[test]
fn logarithm_single() {
    check_single("ln", &sweep(0.0, f32::MAX), 1.5, Real::ln, f64::ln);
    check_single("ln near 1", &sweep(0.3, 3.0), 1.5, Real::ln, f64::ln);
    check_single("ln_1p", &sweep(-1.0, f32::MAX), 1.5, Real::ln_1p, f64::ln_1p);
    check_single("ln_1p near 0", &sweep(-1.0, 4.0), 1.5, Real::ln_1p, f64::ln_1p);
}

#[test]
fn power_single() {
    for exponent in [0.1_f32, 1.0 / 3.0, 0.5, 1.0, 2.0, 2.4, 5.0, 50.0, 500.0, -1.0, -3.7, -40.0] {
        for arguments in [sweep(0.0, f32::MAX), sweep(0.0, 2.0)] {
            check_single(
                &format!("powf {exponent}"),
                &arguments,
                1.0,
                |x| x.powf(exponent),
                |x| x.powf(f64::from(exponent)),
            );
        }
    }
    for base in [1e-40_f32, 1e-3, 0.5, 0.9999, 1.0001, 7.3, 1e30] {
        check_single(
            &format!("{base} to the power"),
            &sweep(-2000.0, 2000.0),
            1.0,
            |y| Real::powf(base, y),
            |y| f64::from(base).powf(y),
        );
    }
}

#[test]
fn trigonometric_single() {
    for range in [1.6, 7.0, 1e4] {
        let arguments = sweep(-range, range);
        check_single("sin", &arguments, 1.5, Real::sin, f64::sin);
        check_single("cos", &arguments, 1.5, Real::cos, f64::cos);
        check_single("tan", &arguments, 1.5, Real::tan, f64::tan);
    }
}

#[test]
fn arc_single() {
    let arguments = sweep(-1.0, 1.0);
    check_single("asin", &arguments, 1.5, Real::asin, f64::asin);
    check_single("acos", &arguments, 1.5, Real::acos, f64::acos);
    for other in [1e-30_f32, 1e-3, 0.5, 1.0, 3.0, 1e10] {
        for other in [other, -other] {
            for arguments in [sweep(-f32::MAX, f32::MAX), sweep(-4.0, 4.0)] {
                check_single(
                    "atan2",
                    &arguments,
                    1.5,
                    |y| Real::atan2(y, other),
                    |y| y.atan2(f64::from(other)),
                );
            }
        }
    }
}

#[test]
fn error_function_single() {
    check_single("erf", &sweep(-12.0, 12.0), 1.5, Real::erf, libm::erf);
    check_single("erfc", &sweep(-12.0, 12.0), 1.5, Real::erfc, libm::erfc);
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
    check_single("erf_inv", &sweep(-below_one, below_one), 4.0, Real::erf_inv, exact);
}
