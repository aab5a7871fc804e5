//! Distributions of facet normals: limits, precision, extremes.

use std::f64::consts::{FRAC_1_PI, PI, TAU};
use std::fmt;

use brdf::{
    Beckmann, Blinn, Distribution, Gaussian, Ggx, Mixture, Pair, Real, Smith, Vector,
    from_spherical,
};
use glam::{DVec3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const ROUGHNESS: [f64; 7] = [1e-4, 1e-2, 0.1, 0.5, 1.0, 3.0, 10.0];

#[test]
fn smith_lambda_at_the_normal_and_at_grazing() {
    let grazing = DVec3::new(0.6, 0.8, 1e-20);
    for roughness in ROUGHNESS {
        let (beckmann, ggx) = (Beckmann::new(roughness).unwrap(), Ggx::new(roughness).unwrap());
        assert_eq!((beckmann.lambda_cos(DVec3::Z), ggx.lambda_cos(DVec3::Z)), (0.0, 0.0));
        let want = 0.5 * roughness / PI.sqrt();
        assert!((beckmann.lambda_cos(grazing) / want - 1.0).abs() < 1e-14);
        assert!((ggx.lambda_cos(grazing) / (0.5 * roughness) - 1.0).abs() < 1e-14);
    }
    // Where Λ of GGX itself is the difference of nearly equal numbers: Λ = tan²θ a²/4.
    let near = DVec3::new(1e-6, 0.0, 1.0);
    assert!((Ggx::new(0.1).unwrap().lambda_cos(near) / 0.25e-14 - 1.0).abs() < 1e-13);
}

#[test]
fn constant_limits() {
    for theta in [0.0, 0.5, 1.0, 1.5] {
        let h = from_spherical(theta, 0.4);
        assert!((Ggx::new(1.0).unwrap().density(h) - FRAC_1_PI).abs() < 1e-15);
        assert!((Blinn::new(0.0).unwrap().density(h) - FRAC_1_PI).abs() < 1e-15);
        assert!((Gaussian::new(1e4).unwrap().density(h) - FRAC_1_PI).abs() < 1e-8);
    }
}

#[test]
fn narrow_distributions_agree() {
    // cosⁿα, exp(−α²/m²) and exp(−tan²α/m²)/cos⁴α differ by O(m²) where D is not small.
    let m = 1e-3;
    for part in [0.0, 0.5, 1.0, 2.0] {
        let h = from_spherical(part * m, 1.0);
        let beckmann = Beckmann::new(m).unwrap().density(h);
        let gaussian = Gaussian::new(m).unwrap().density(h);
        let blinn = Blinn::from_roughness(m).unwrap().density(h);
        assert!((gaussian / beckmann - 1.0).abs() < 2e-5, "{part}");
        assert!((blinn / beckmann - 1.0).abs() < 2e-5, "{part}");
    }
}

#[test]
fn equal_roughness_is_isotropic() {
    for phi in [0.0, 1.0, 2.0, 4.0] {
        let h = from_spherical(0.3, phi);
        let pairs: [(&dyn Smith<f64>, &dyn Smith<f64>); 2] = [
            (&Beckmann::new(0.4).unwrap(), &Beckmann::anisotropic(0.4, 0.4).unwrap()),
            (&Ggx::new(0.4).unwrap(), &Ggx::anisotropic(0.4, 0.4).unwrap()),
        ];
        for (isotropic, anisotropic) in pairs {
            assert_eq!(isotropic.density(h), anisotropic.density(h));
            let turned = isotropic.density(from_spherical(0.3, 0.0));
            assert!((isotropic.density(h) / turned - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn a_mixture_of_one_and_bad_weights() {
    let ggx = Ggx::new(0.3).unwrap();
    let one = Mixture::new([(7.0, ggx)]).unwrap();
    let rest = Mixture::new([(0.0, Ggx::new(0.9).unwrap()), (2.0, ggx)]).unwrap();
    let (h, wo, u) = (from_spherical(0.3, 0.2), from_spherical(1.2, 2.0), [0.3, 0.6]);
    for mixture in [&one as &dyn Smith<f64>, &rest] {
        assert_eq!(mixture.density(h), ggx.density(h));
        assert_eq!(mixture.lambda_cos(wo), ggx.lambda_cos(wo));
        assert!(mixture.sample(u).abs_diff_eq(ggx.sample(u), 1e-15));
        assert!(mixture.sample_visible(wo, u).abs_diff_eq(ggx.sample_visible(wo, u), 1e-15));
    }
    let error = Mixture::new([(1.0, ggx), (-0.5, ggx)]).unwrap_err();
    assert_eq!((error.parameter(), error.value()), ("weight", -0.5));
    let error = Mixture::new([(0.0, ggx), (0.0, ggx)]).unwrap_err();
    assert_eq!((error.parameter(), error.value()), ("sum of weights", 0.0));
    assert!(Mixture::new([(f64::NAN, ggx)]).is_err());
    assert!(Mixture::<f64, Ggx<f64>, 0>::new([]).is_err());
}

#[test]
fn parameters_outside_their_range_are_refused() {
    for bad in [0.0, -0.1, 1.1e4, f64::NAN, f64::INFINITY] {
        assert!(Beckmann::new(bad).is_err() && Ggx::new(bad).is_err());
        assert!(Gaussian::new(bad).is_err());
        assert_eq!(Ggx::anisotropic(0.1, bad).unwrap_err().parameter(), "along_y");
        assert_eq!(Beckmann::anisotropic(bad, 0.1).unwrap_err().parameter(), "along_x");
    }
    assert!(Blinn::new(-1e-9).is_err() && Blinn::new(2e8).is_err());
    assert!(Blinn::from_roughness(1.01).is_err() && Blinn::from_roughness(1e-4).is_err());
    assert_eq!(Blinn::from_roughness(1.0).unwrap().exponent(), 0.0);
    assert_eq!(Ggx::anisotropic(0.1, 0.2).unwrap().roughness(), [0.1, 0.2]);
}

/// Single precision against double on the same numbers: on half vectors, and from two directions.
/// `exponent` is that of the exponential in the formula, for a half vector at a tangent.
///
/// The exponential carries the rounding of its exponent in proportion to its size: four roundings
/// of 6·10⁻⁸ from two directions to each side of a slope, all twice for its square, and half as
/// many again within the formula.
fn compare_precision<S, D>(single: &S, double: &D, width: f64, exponent: impl Fn(f64) -> f64)
where
    S: Distribution<f32>,
    D: Distribution<f64>,
{
    let mut rng = Pcg64Mcg::seed_from_u64(7);
    let mut uniform = move || rng.random::<f64>();
    let check = |got: f32, half: DVec3, what: &str| {
        let want = double.density(half);
        let exponent = exponent(half.x.hypot(half.y) / half.z);
        if want > 1e-30 {
            let error = (f64::from(got) / want - 1.0).abs();
            let allowed = 1e-6 + 7e-7 * exponent;
            assert!(error < allowed, "{what}, {width}: {error:e} at {exponent}");
        }
    };
    for _ in 0..20_000 {
        let slope = 10.0 * uniform().powi(2) * width;
        let h = from_spherical(slope.atan(), uniform() * TAU);
        let wo = from_spherical(uniform() * 1.5, uniform() * TAU);
        let wi = h * (2.0 * wo.dot(h)) - wo;
        let (h, wi, wo) = (h.as_vec3(), wi.as_vec3(), wo.as_vec3());
        check(single.density(h), h.as_dvec3(), "half vector");
        if wi.z > 0.0 {
            let half = Pair::<f32>::new(wi, wo).h;
            let exact = Pair::<f64>::new(wi.as_dvec3(), wo.as_dvec3()).h;
            check(single.density(half), exact, "two directions");
        }
    }
}

#[test]
fn single_precision_keeps_its_digits() {
    for roughness in [1e-4_f32, 1e-3, 0.01, 0.1, 0.5, 1.0, 5.0] {
        let m = f64::from(roughness);
        let ggx = (Ggx::new(roughness).unwrap(), Ggx::new(m).unwrap());
        compare_precision(&ggx.0, &ggx.1, m, |_| 0.0);
        let beckmann = (Beckmann::new(roughness).unwrap(), Beckmann::new(m).unwrap());
        compare_precision(&beckmann.0, &beckmann.1, m, |tan| (tan / m).powi(2));
        let gaussian = (Gaussian::new(roughness).unwrap(), Gaussian::new(m).unwrap());
        compare_precision(&gaussian.0, &gaussian.1, m, |tan| (tan.atan() / m).powi(2));
    }
    for exponent in [0.0_f32, 1.0, 30.0, 1e4, 1e6, 1e8] {
        let n = f64::from(exponent);
        let blinn = (Blinn::new(exponent).unwrap(), Blinn::new(n).unwrap());
        let width = (2.0 / (n + 2.0)).sqrt();
        compare_precision(&blinn.0, &blinn.1, width, |tan| 0.5 * n * (tan * tan).ln_1p());
    }
}

/// Numbers from the whole range, signs included.
fn extremes<T: Real>() -> Vec<T> {
    let large = [0.0, 1e-45, 1e-30, 1e-20, 1e-8, 0.6, 0.8, 1.0, 1e19, 1e38];
    large.into_iter().flat_map(|value| [T::lit(value), T::lit(-value)]).collect()
}

/// Uniform numbers from end to end. 1 is not one of them, but careless generators return it.
fn uniform<T: Real>() -> [T; 6] {
    [0.0, 1e-45, 1e-9, 0.5, 1.0 - 1.0 / f64::from(1 << 24), 1.0].map(T::lit)
}

fn assert_harmless<T: Real + Into<f64>>(value: T, what: fmt::Arguments) {
    let value: f64 = value.into();
    assert!(value.is_finite() && value >= 0.0, "{what}: {value}");
}

fn assert_normal<T: Real + Into<f64>>(h: T::Vec3, what: fmt::Arguments) {
    let [x, y, z]: [f64; 3] = [h.x().into(), h.y().into(), h.z().into()];
    let length = (x * x + y * y + z * z).sqrt();
    assert!((length - 1.0).abs() < 1e-6 && z >= 0.0, "{what}: ({x}, {y}, {z})");
}

fn check_extremes<T: Real + Into<f64>>(name: &str, distribution: &dyn Distribution<T>) {
    let numbers = extremes::<T>();
    for &x in &numbers {
        for &y in &numbers {
            for &z in &numbers {
                let h: T::Vec3 = Vector::new(x, y, z);
                let density = distribution.density(h);
                assert_harmless(density, format_args!("{name} at {h:?}"));
                assert!(z.into() > 0.0 || density.into() == 0.0, "{name} at {h:?}");
            }
        }
    }
    for u0 in uniform() {
        for u1 in uniform() {
            let h = distribution.sample([u0, u1]);
            assert_normal::<T>(h, format_args!("{name} by {u0:?}, {u1:?}"));
        }
    }
}

fn check_smith_extremes<T: Real + Into<f64>>(name: &str, distribution: &dyn Smith<T>) {
    let numbers = extremes::<T>();
    for &x in &numbers {
        for &y in &numbers {
            for &z in &numbers {
                let w: T::Vec3 = Vector::new(x, y, z);
                assert_harmless(distribution.lambda_cos(w), format_args!("{name}: Λ at {w:?}"));
                for u0 in uniform() {
                    for u1 in uniform() {
                        let h = distribution.sample_visible(w, [u0, u1]);
                        assert_normal::<T>(h, format_args!("{name} from {w:?} by {u0:?}, {u1:?}"));
                    }
                }
            }
        }
    }
}

fn check_all_extremes<T: Real + Into<f64>>() {
    let ends = [T::lit(1e-8), T::lit(0.3), T::lit(1e4)];
    for x in ends {
        check_extremes("Gaussian", &Gaussian::new(x).unwrap());
        for y in ends {
            let beckmann = Beckmann::anisotropic(x, y).unwrap();
            check_extremes("Beckmann", &beckmann);
            check_smith_extremes("Beckmann", &beckmann);
            let ggx = Ggx::anisotropic(x, y).unwrap();
            check_extremes("GGX", &ggx);
            check_smith_extremes("GGX", &ggx);
        }
    }
    for exponent in [0.0, 0.1, 1.0, 1e4, 1e8] {
        check_extremes("Blinn", &Blinn::new(T::lit(exponent)).unwrap());
    }
    let ends = ends.map(|roughness| (T::lit(1e-20), Ggx::new(roughness).unwrap()));
    let mixture = Mixture::new(ends).unwrap();
    check_extremes("mixture", &mixture);
    check_smith_extremes("mixture", &mixture);
}

#[test]
fn extremes_are_harmless() {
    check_all_extremes::<f32>();
    check_all_extremes::<f64>();
}

#[test]
fn densities_of_directions_at_the_edge() {
    // The last cosine before the surface: where exp(−tan²) meets 1/cos⁴.
    for cos in [1e-3, 1e-6, 1e-12, 1e-30] {
        let h = DVec3::new(1.0, 0.0, cos);
        assert!(Beckmann::new(1.0).unwrap().density(h) < 1e-300);
        assert!((Ggx::new(0.5).unwrap().density(h) * PI / 0.25 - 1.0).abs() < 1e-4);
        let single = Vec3::new(1.0, 0.0, cos as f32);
        assert_eq!(Beckmann::new(1.0_f32).unwrap().density(single), 0.0);
    }
}
