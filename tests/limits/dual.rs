//! Numbers with derivatives: every function has its slope, and what has none has a stated answer.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_SQRT_PI, PI};

use brdf::{Dual, Lanes, Real, gradient};
use brdf_checks::measure::differences::{Difference, Steps};

type One = Dual<f64, 1>;

/// The slope of a formula over duals is that of its values.
fn assert_slope(name: &str, x: f64, plain: impl Fn(f64) -> f64, dual: impl Fn(One) -> One) {
    let got = dual(One::variable(x, 0));
    assert_eq!(got.value.to_bits(), plain(x).to_bits(), "{name} of {x}");
    let size = if x == 0.0 { 1.0 } else { x.abs() };
    let steps = Steps::of(0.05 * size);
    let Difference { slope, error, .. } =
        steps.difference(&steps.map(|step| Some(plain(x + step))));
    let [got] = got.derivatives;
    assert!(
        (got - slope).abs() <= 4.0 * error + 1e-9 * slope.abs(),
        "{name} of {x}: {got} {slope}"
    );
    assert!(error <= 1e-7 * slope.abs().max(plain(x).abs() / size), "{name} of {x}: {error}");
}

macro_rules! slopes {
    ($($function:ident: $($x:expr),+;)+) => {$(
        for x in [$($x),+] {
            assert_slope(stringify!($function), x, |x| Real::$function(x), |x| x.$function());
        }
    )+};
}

#[test]
fn every_function_has_its_slope() {
    slopes! {
        abs: -3.0, 0.2;
        floor: 0.5, -7.3;
        sqrt: 1e-20, 0.3, 4.0, 1e200;
        rsqrt: 1e-20, 0.3, 4.0, 1e200;
        exp: -30.0, -0.1, 0.0, 5.0;
        exp_m1: -3.0, -1e-5, 0.0, 5.0;
        ln: 1e-30, 0.4, 1.0, 1e9;
        ln_1p: -0.9, -1e-9, 0.3, 1e9;
        sin: -0.3, 0.0, 1.2, 100.0;
        cos: -0.3, 0.1, 1.2, 100.0;
        tan: -0.3, 0.0, 1.2;
        asin: -0.9, 0.0, 0.5;
        acos: -0.9, 0.0, 0.5;
        angle_squared: 1e-12, 0.01, 0.3, 0.9;
        erf: -2.0, 0.0, 0.4;
        erfc: -2.0, 0.0, 0.4, 5.0, 20.0;
        erfcx: 0.0, 0.4, 5.0, 1e3, 1e7;
        ierfc: 0.0, 0.4, 5.0, 20.0;
        erf_inv: -0.9, 0.0, 0.3, 0.99;
        squared: -3.0, 0.2;
    }
    for x in [0.01, 0.3, 0.99, 1.0, 7.0] {
        assert_slope("part of a turn", x, |x| x.sin_cos_turns().0, |x| x.sin_cos_turns().0);
        assert_slope("part of a turn", x, |x| x.sin_cos_turns().1, |x| x.sin_cos_turns().1);
        assert_slope("a power", x, |x| Real::powi(x, 7), |x| x.powi(7));
    }
    // Differences from −1 have no digits there.
    assert_eq!(One::variable(-40.0, 0).exp_m1().derivatives, [Real::exp(-40.0)]);
}

macro_rules! slopes_of_two {
    ($($function:ident: $(($x:expr, $y:expr)),+;)+) => {$(
        for (x, y) in [$(($x, $y)),+] {
            let (name, first, second) = (stringify!($function), One::constant(x), One::constant(y));
            assert_slope(name, x, |x| Real::$function(x, y), |x| x.$function(second));
            assert_slope(name, y, |y| Real::$function(x, y), |y| first.$function(y));
        }
    )+};
}

#[test]
fn functions_of_two_numbers_have_both_slopes() {
    slopes_of_two! {
        min: (0.2, 0.3), (0.3, 0.2), (-1.0, 2.0);
        max: (0.2, 0.3), (0.3, 0.2), (-1.0, 2.0);
        copysign: (2.0, -3.0), (-2.0, -3.0), (-2.0, 3.0), (2.0, 3.0);
        powf: (0.3, 2.5), (1.7, -0.4), (1e-9, 0.5), (0.99, 100.0);
        atan2: (0.3, 0.4), (-0.3, -0.4), (1e-170, 1e-170), (1e170, -2e170), (0.3, 0.0);
        decay: (0.0, 2.0), (0.7, 0.3), (30.0, 1e4);
        mean_magnitude: (0.3, 0.1), (1.0, 0.4), (0.2, 5.0), (1e-6, 1.0);
    }
    for (x, rest, n) in [(0.3, 0.1, 2.5), (1e-9, 1.0, 1.5), (1.0, 1e-3, 1e3), (0.2, 0.7, 30.0)] {
        let [part, other, exponent] = [x, rest, n].map(One::constant);
        let name = "power_of_part";
        assert_slope(
            name,
            x,
            |x| Real::power_of_part(x, rest, n),
            |x| x.power_of_part(other, exponent),
        );
        assert_slope(
            name,
            rest,
            |y| Real::power_of_part(x, y, n),
            |y| part.power_of_part(y, exponent),
        );
        assert_slope(
            name,
            n,
            |n| Real::power_of_part(x, rest, n),
            |n| part.power_of_part(other, n),
        );
    }
    for (x, y) in [(0.3, 0.7), (-2.0, 1e-3), (1e9, -4.0)] {
        let (first, second) = (One::constant(x), One::constant(y));
        assert_slope("+", x, |x| x + y, |x| x + second);
        assert_slope("−", y, |y| x - y, |y| first - y);
        assert_slope("·", x, |x| x * y, |x| x * second);
        assert_slope("/", x, |x| x / y, |x| x / second);
        assert_slope("/", y, |y| x / y, |y| first / y);
    }
}

/// At a kink the mean of both sides, where the slope is infinite 0.
#[test]
fn singular_points_have_a_derivative() {
    let [x, y] = [Dual::<f64, 2>::variable(0.5, 0), Dual::variable(0.5, 1)];
    assert_eq!(x.min(y).derivatives, [0.5, 0.5]);
    assert_eq!(x.max(y).derivatives, [0.5, 0.5]);
    assert_eq!((x - y).abs().derivatives, [0.0, 0.0]);
    assert_eq!(x.clamp(Dual::zero(), Dual::lit(0.5)).derivatives, [0.5, 0.0]);

    let at = |x: f64| Dual::<f64, 1>::variable(x, 0);
    let flat = [
        at(0.0).sqrt(),
        at(0.0).rsqrt(),
        at(0.0).ln(),
        at(-1.0).ln_1p(),
        at(1.0).asin(),
        at(-1.0).acos(),
        at(2.0).acos(),
        at(0.0).atan2(Dual::zero()),
        Dual::zero().atan2(at(0.0)),
        at(0.0).powf(Dual::lit(0.5)),
        at(0.0).powf(Dual::lit(2.0)),
        Dual::zero().powf(at(0.0)),
    ];
    for (index, number) in flat.into_iter().enumerate() {
        assert_eq!(number.derivatives, [0.0], "{index}");
    }
    assert_eq!(at(0.0).powf(Dual::one()).derivatives, [1.0]);
    assert_eq!(at(0.0).angle_squared().derivatives, [2.0]);
    // An infinite derivative does not come through a flat function.
    let steep = Dual { value: 3.0, derivatives: [f64::INFINITY] };
    assert_eq!((steep.acos().derivatives, steep.floor().derivatives), ([0.0], [0.0]));
}

#[test]
fn bounds_that_only_rounding_reaches_keep_the_slope() {
    let above: One = Dual { value: 1.0 + f64::EPSILON, derivatives: [3.0] };
    assert_eq!(above.at_most(Dual::one()), Dual { value: 1.0, derivatives: [3.0] });
    assert_eq!(above.min(Dual::one()), Dual { value: 1.0, derivatives: [0.0] });
    for nowhere in [f64::NAN, f64::INFINITY] {
        let bound = Dual { value: nowhere, derivatives: [f64::NAN] }.at_most(One::one());
        assert_eq!(bound, Dual::one());
    }
    assert_eq!(Real::at_most(1.5_f32, 1.0), 1.0);
    assert_eq!(above.held(), One::constant(above.value));
    assert_eq!(One::one().with_derivatives_of(above), Dual { value: 1.0, derivatives: [3.0] });
    let lanes = Lanes([above, Dual::zero()]).at_most(Lanes::one());
    assert_eq!(lanes.0, [Dual { value: 1.0, derivatives: [3.0] }, Dual::zero()]);
}

/// Whatever the steps of an iteration did to the derivatives.
#[test]
fn a_solution_has_the_derivatives_of_its_equation() {
    let root = gradient([2.0, 3.0], |[square, cube]| {
        // x² = square, y³ = cube.
        let x = Dual { value: 2.0_f64.sqrt(), derivatives: [f64::NAN; 2] };
        let y = Dual { value: 3.0_f64.cbrt(), derivatives: [7.0; 2] };
        let twice = |x: Dual<f64, 2>| x + x;
        vec![
            x.as_solution_of(|x| (x * x - square, twice(x))),
            y.as_solution_of(|y| (y * y * y - cube, y * y * Dual::lit(3.0))),
            // A slope of 0 gives none.
            y.as_solution_of(|y| (y - square, Dual::zero())),
        ]
    });
    let [by_square, by_cube] = root.derivatives;
    assert_eq!(root.value, [2.0_f64.sqrt(), 3.0_f64.cbrt(), 3.0_f64.cbrt()]);
    assert!((by_square[0] - 0.5 * FRAC_1_SQRT_2).abs() < 1e-15 && by_cube[0] == 0.0);
    assert!((by_cube[1] - 1.0 / (3.0 * 3.0_f64.cbrt().powi(2))).abs() < 1e-15);
    assert_eq!((by_square[2], by_cube[2]), (0.0, 0.0));
    assert_eq!(2.0_f64.as_solution_of(|_| panic!("floats have no derivatives")), 2.0);
}

#[test]
fn duals_of_duals_have_second_derivatives() {
    let at = |x: f64| Dual::<Dual<f64, 1>, 1>::variable(Dual::variable(x, 0), 0);
    let second = |y: Dual<Dual<f64, 1>, 1>| y.derivatives[0].derivatives[0];
    let x = 0.7_f64;
    assert!((second(at(x).sin() * at(x)) - (2.0 * x.cos() - x * x.sin())).abs() < 1e-14);
    assert!((second(at(x).sqrt()) + 0.25 * x.powf(-1.5)).abs() < 1e-14);
    let gauss = FRAC_2_SQRT_PI * (-x * x).exp();
    assert!((second(at(x).erf()) + 2.0 * x * gauss).abs() < 1e-14);
    // d²/dx² x^x.
    let power = x.powf(x);
    let want = power * ((x.ln() + 1.0).powi(2) + 1.0 / x);
    assert!((second(at(x).powf(at(x))) - want).abs() < 1e-13);
    // x³ = p by one of its solutions.
    let p = at(2.0);
    let x =
        Dual::constant(Dual { value: 2.0_f64.cbrt(), derivatives: [1.0 / (3.0 * 4.0_f64.cbrt())] });
    let x = x.as_solution_of(|x| (x * x * x - p, x * x * Dual::lit(3.0)));
    assert!((second(x) + 2.0 / 9.0 * 2.0_f64.powf(-5.0 / 3.0)).abs() < 1e-14);
}

/// In lanes and in single precision.
#[test]
fn duals_are_made_of_any_number() {
    let formula = |x: f64| {
        let x = One::variable(x, 0);
        (x * x + One::lit(PI)).sqrt().atan2(x.exp())
    };
    let lanes = Dual::<Lanes<f64, 2>, 1>::variable(Lanes([0.3, -2.0]), 0);
    let got = (lanes * lanes + Dual::lit(PI)).sqrt().atan2(lanes.exp());
    for (lane, x) in [0.3, -2.0].into_iter().enumerate() {
        let want = formula(x);
        assert_eq!(got.value.0[lane], want.value);
        assert_eq!(got.derivatives[0].0[lane], want.derivatives[0]);
    }
    let single = Dual::<f32, 1>::variable(0.3, 0);
    let single = (single * single + Dual::lit(PI)).sqrt().atan2(single.exp());
    let want = formula(f64::from(0.3_f32));
    assert!((f64::from(single.derivatives[0]) - want.derivatives[0]).abs() < 1e-7);
    assert_eq!(One::constant(0.3).outside(0.5, 1.0), Some(0.3));
    assert_eq!(Dual::<f64, 2>::variable(0.3, 2), Dual::constant(0.3));
}
