//! Derivatives of models where a formula makes them hard: at ties, at bounds, at the normal, at the
//! ends of ranges. The values are those of the exact formula.

use std::f64::consts::{PI, TAU};

use brdf::{
    AnyMixture, Beckmann, BlinnPhong, Brdf, Bsdf, ClassicPhong, Conductor, Constant, CookTorrance,
    Dielectric, Distribution, Dual, Fresnel, Gaussian, GeneralSchlick, Gradient, Hall,
    LommelSeeliger, Minnaert, OrenNayar, ParameterError, Phong, Plastic, Real, Sample,
    SchlickPower, SmithCorrelated, TransportMode, VCavity, Vector3, gradient,
};
use glam::{DVec3, Vec3};

const UP: DVec3 = DVec3::Z;
const VIEWER: DVec3 = DVec3::new(0.6, 0.0, 0.8);

fn close(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance, "{got} is not {want}");
}

/// Both directions are equally steep: of the two that G chooses from each counts by half.
#[test]
fn v_cavities_have_the_mean_slope_where_light_and_viewer_tie() {
    let f = gradient([0.8, 0.8], |[light, viewer]| {
        let mirrors = CookTorrance::new(
            Beckmann::new(Dual::constant(0.3))?,
            Constant::new(Dual::constant(1.0))?,
        );
        let [x, zero] = [0.6, 0.0].map(Dual::constant);
        let wi = Vector3 { x, y: zero, z: light };
        let wo = Vector3 { x: -x, y: zero, z: viewer };
        Ok::<_, ParameterError>(mirrors.eval(wi, wo))
    });
    for derivative in f.unwrap().derivatives {
        close(derivative, -1.726942, 1e-6);
    }
}

/// Beyond the critical angle the reflectance is 1, a bound that it leaves with k.
#[test]
fn a_weak_absorber_reflects_less_than_all() {
    let average = gradient([0.7, 0.0], |[eta, k]| Conductor::new(eta, k).map(|one| one.average()));
    close(average.unwrap().derivatives[1], -6.1613, 2e-4);
    let beyond = gradient([0.7, 0.0], |[eta, k]| {
        Conductor::new(eta, k).map(|one| one.reflectance(Dual::constant(0.5)))
    });
    let beyond = beyond.unwrap();
    let step = 1e-7;
    let moved = Conductor::new(0.7, step).unwrap().reflectance(0.5);
    close(beyond.value, 1.0, 1e-15);
    close(beyond.derivatives[1], (moved - 1.0) / step, 1e-5);
    // Of a transparent medium it stays 1.
    let glass =
        gradient([0.7, 0.5], |[ior, cos]| Dielectric::new(ior).map(|one| one.reflectance(cos)));
    assert_eq!(glass, Ok(Gradient { value: 1.0, derivatives: [0.0, 0.0] }));
}

/// A number to differentiate by twice.
type Twice = Dual<Dual<f64, 1>, 1>;

fn twice(x: f64) -> Twice {
    Dual::variable(Dual::variable(x, 0), 0)
}

fn second(y: Twice) -> f64 {
    y.derivatives[0].derivatives[0]
}

/// A slope of 0 changes.
#[test]
fn flat_places_have_second_derivatives() {
    assert_eq!(second(twice(0.0).cos()), -1.0);
    assert_eq!(second((twice(0.0) * twice(0.0)).exp()), 2.0);
    // Of a power at 0 only the second one; that below 2 is infinite, and counts as 0.
    for (exponent, want) in [(1.0, 0.0), (1.5, 0.0), (2.0, 2.0), (3.0, 0.0), (5.0, 0.0)] {
        assert_eq!(second(twice(0.0).powf(Real::lit(exponent))), want, "{exponent}");
    }
    let thrice = Dual::<_, 1>::variable(twice(0.0), 0).powf(Real::lit(3.0));
    assert_eq!(thrice.derivatives[0].derivatives[0].derivatives[0], 6.0);
    // A bound that only rounding reaches keeps the curvature, too.
    let bounded = twice(1.0).at_most(Real::one());
    assert_eq!(bounded.value.derivatives, [1.0]);
    assert_eq!(second(bounded * bounded), 2.0);
}

/// At normal incidence the slope is that on the side of the angles.
#[test]
fn general_schlick_has_the_slope_of_its_end() {
    let (f0, f90) = (0.1, 0.9);
    for (exponent, want) in [(0.5, 0.0), (1.0, f0 - f90), (2.0, 0.0), (5.0, 0.0)] {
        let at = gradient([1.0, exponent], |[cos, exponent]| {
            let [f0, f90] = [f0, f90].map(Dual::constant);
            GeneralSchlick::new(f0, f90, exponent).map(|term| term.reflectance(cos))
        });
        let Gradient { value, derivatives: [by_cos, by_exponent] } = at.unwrap();
        assert_eq!(value, f0);
        close(by_cos, want, 1e-15);
        assert_eq!(by_exponent, 0.0);
    }
    let [f0, f90, square] = [f0, f90, 2.0].map(Real::lit);
    let curved = GeneralSchlick::new(f0, f90, square).unwrap().reflectance(twice(1.0));
    close(second(curved), 2.0 * 0.8, 1e-15);
}

/// The series of Fresnel's reflectance about the normal, where s and p cancel to first order:
/// F″ = −4 (n − 1)² (n² − 4n + 1)/(n³ (n + 1)²). Hall's curve is that times (1 − F₀)/(1 − R₀).
#[test]
fn fresnel_terms_are_curved_at_the_normal() {
    for n in [0.3, 0.5, 0.9, 1.5, 2.0, 3.7] {
        let (lower, upper): (f64, f64) = (n - 1.0, n + 1.0);
        let want = -4.0 * lower.powi(2) * (n * n - 4.0 * n + 1.0) / (n.powi(3) * upper.powi(2));
        let exact: Twice = Dielectric::new(Twice::lit(n)).unwrap().reflectance(twice(1.0));
        close(exact.value.derivatives[0], 0.0, 1e-14);
        close(second(exact), want, 1e-12);
        let hall = Hall::new(Twice::lit(0.3), Twice::lit(n)).unwrap().reflectance(twice(1.0));
        close(second(hall), 0.7 * want / (1.0 - (lower / upper).powi(2)), 1e-12);
    }
}

fn drawn<M>(
    model: Result<M, ParameterError>,
) -> Result<Sample<Dual<f64, 1>, M::Color>, ParameterError>
where
    M: Brdf<Dual<f64, 1>>,
{
    Ok(model?.sample(Dual::vector(VIEWER), [0.3, 0.7].map(Dual::constant)))
}

#[test]
fn samples_of_v_cavities_move_with_the_roughness() {
    let sample = gradient([0.3], |[roughness]| {
        drawn(Beckmann::new(roughness).and_then(|facets| {
            let mirrors = Constant::new(Dual::constant(1.0))?;
            Ok(CookTorrance::from_parts(facets, mirrors, VCavity))
        }))
    });
    let want = DVec3::new(0.517351158, 0.843474506, 0.026096838);
    assert!((sample.unwrap().derivatives[0].wi - want).length() < 1e-9);
}

/// An index of 1 is the end of what plastic may have: there is one side only.
#[test]
fn plastic_has_the_slope_of_denser_media_at_index_one() {
    let up = |ior, linear: bool, albedo: f64| {
        let ground = Dual::vector(DVec3::splat(albedo));
        let new = if linear { Plastic::linear } else { Plastic::new };
        new(ground, ior).map(|plastic| {
            plastic.eval(Dual::vector(UP), Dual::vector(UP), TransportMode::Radiance).x
        })
    };
    for (linear, albedo, want) in [
        (false, 0.5, 0.5 / PI * (-2.0 + 7.0 / 6.0)),
        (false, 1.0, 1.0 / PI * (-2.0 + 7.0 / 3.0)),
        (true, 0.5, 0.5 / (3.0 * PI)),
    ] {
        let f = gradient([1.0], |[ior]| up(ior, linear, albedo));
        close(f.unwrap().derivatives[0], want, 1e-12);
    }
    let average = gradient([1.0], |[ior]| Dielectric::new(ior).map(|one| one.average()));
    close(average.unwrap().derivatives[0], 1.0 / 3.0, 1e-12);
}

/// By a lattice of 25 million facets and differences of fourth order.
#[test]
fn the_albedo_of_v_cavities_changes_with_the_roughness() {
    let albedo = gradient([0.5], |[roughness]| {
        Beckmann::new(roughness).and_then(|facets| {
            let mirrors = Constant::new(Dual::constant(1.0))?;
            Ok(CookTorrance::from_parts(facets, mirrors, VCavity).albedo(Dual::vector(VIEWER)))
        })
    });
    close(albedo.unwrap().derivatives[0], -0.5749656, 1e-7);
}

#[test]
fn the_normal_has_derivatives_by_parameters() {
    let up = Dual::vector(UP);
    let density = gradient([0.3], |[m]| Gaussian::new(m).map(|facets| facets.density(up)));
    close(density.unwrap().derivatives[0], -23.543985838, 1e-9);
    let [up, limb] = [UP, DVec3::new(0.8, 0.0, 0.6)].map(Dual::vector);
    let plaster = gradient([0.8, 0.3], |[albedo, sigma]| {
        OrenNayar::new(albedo, sigma).map(|plaster| plaster.albedo(up))
    });
    let [by_albedo, by_sigma] = plaster.unwrap().derivatives;
    close(by_albedo, 0.892857142857, 1e-12);
    close(by_sigma, -0.448980, 1e-6);
    for n in [0.0, 1.0, 10.0, 1000.0] {
        let lobes = gradient([0.5, n], |[specular, n]| {
            Ok::<_, ParameterError>(vec![
                Phong::new(specular, n)?.albedo(up),
                BlinnPhong::new(specular, n)?.albedo(up),
                SchlickPower::new(specular, n)?.albedo(up),
                ClassicPhong::new(specular, n)?.albedo(up),
            ])
        });
        let [by_specular, by_exponent] = lobes.unwrap().derivatives;
        // The first three are made to have the albedo kₛ there.
        for lobe in 0..3 {
            close(by_specular[lobe], 1.0, 1e-12);
            close(by_exponent[lobe], 0.0, 1e-12);
        }
        close(by_specular[3], TAU / (n + 1.0), 1e-12);
        close(by_exponent[3], -0.5 * TAU / (n + 1.0).powi(2), 1e-12);
    }
    // Grains that scatter evenly: of both signs of ξ the one has the slope of the other.
    let dust =
        gradient([0.3, 0.0], |[w, xi]| LommelSeeliger::new(w, xi).map(|dust| dust.eval(up, limb)));
    let dust = dust.unwrap();
    close(dust.derivatives[1], -3.0 * 0.6 * dust.value, 1e-15);
}

/// The end of a tail, of next to no density.
#[test]
fn draws_of_the_number_1_have_derivatives() {
    let ends = gradient([20.0_f64], |[n]| {
        let (one, wo, u) = (Dual::one(), Dual::vector(VIEWER), [1.0, 0.3].map(Dual::constant));
        Ok::<_, ParameterError>(vec![
            Phong::new(one, n)?.sample(wo, u),
            ClassicPhong::new(one, n)?.sample(wo, u),
            BlinnPhong::new(one, n)?.sample(wo, u),
            SchlickPower::new(one, n)?.sample(wo, u),
        ])
    });
    let Gradient { value, derivatives: [by_exponent] } = ends.unwrap();
    for (value, by_exponent) in value.into_iter().zip(by_exponent) {
        assert!(value.wi.is_finite() && by_exponent.wi.is_finite(), "{by_exponent:?}");
        assert!(by_exponent.weight.is_finite() && by_exponent.pdf.is_finite(), "{by_exponent:?}");
    }
}

/// Around exponent 1 its sampled versine is 0 over 0.
#[test]
fn samples_of_schlicks_power_are_smooth_above_1() {
    let at = |exponent| {
        let sample = gradient([exponent], |[h]| drawn(SchlickPower::new(Dual::constant(1.0), h)));
        sample.unwrap().derivatives[0]
    };
    let near = at(1.0 + 1e-9);
    for above in [1e-15, 1e-12, 1e-10] {
        let sample = at(1.0 + above);
        assert!((sample.wi - near.wi).length() < 1e-8, "{above}: {sample:?}");
        close(sample.weight, near.weight, 1e-8);
        close(sample.pdf, near.pdf, 1e-8);
    }
    // Below, samples are those of 1.
    let (below, kink) = (at(1.0 - 1e-9), at(1.0));
    assert_eq!(below.wi, DVec3::ZERO);
    assert!((kink.wi - near.wi * 0.5).length() < 1e-8, "{kink:?}");
}

/// Slopes that overflow in single precision belong to numbers that are still.
#[test]
fn single_precision_has_derivatives_from_the_normal_to_the_horizon() {
    type One = Dual<f32, 1>;
    let [still, moving] = [One::constant, |value| One::variable(value, 0)];
    let facets = |roughness| {
        let gold = Conductor::new(still(0.143), still(3.983)).unwrap();
        CookTorrance::new(Beckmann::new(roughness).unwrap(), gold)
    };
    let models: [Box<dyn Brdf<One, Color = One>>; 7] = [
        Box::new(facets(moving(0.3))),
        Box::new(facets(still(0.3)).with_shadowing(SmithCorrelated)),
        Box::new(facets(moving(1e-3)).with_shadowing(SmithCorrelated)),
        Box::new(Phong::new(still(0.5), moving(40.0)).unwrap()),
        Box::new(BlinnPhong::new(moving(0.5), still(40.0)).unwrap()),
        Box::new(Minnaert::new(moving(0.12), still(0.5)).unwrap()),
        Box::new(Minnaert::new(still(0.12), moving(0.5)).unwrap()),
    ];
    let directions = [1.0, 0.8, 1e-3, 1e-6, 1e-10]
        .map(|cos: f32| One::vector(Vec3::new((1.0 - cos * cos).sqrt(), 0.0, cos)));
    for (index, model) in models.iter().enumerate() {
        for wi in directions {
            for wo in directions {
                let sample = model.sample(wo, [0.3, 0.7].map(still));
                let answers = [model.eval(wi, wo), model.pdf(wi, wo), sample.weight, sample.wi.z];
                for answer in answers {
                    let context = format!("{index}: {answer:?} at {wi:?} {wo:?}");
                    assert!(answer.value.is_finite(), "{context}");
                    assert!(answer.derivatives[0].is_finite(), "{context}");
                }
            }
        }
    }
}

/// A model that does not know its albedo.
struct Sampled<M>(M);

impl<T: Real, M: Brdf<T>> Brdf<T> for Sampled<M> {
    type Color = M::Color;

    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> M::Color {
        self.0.eval(wi, wo)
    }

    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        self.0.pdf(wi, wo)
    }

    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, M::Color> {
        self.0.sample(wo, u)
    }
}

/// The derivative of the integral: not that of the weights of samples, which move, jump from term to
/// term and fall below the surface.
#[test]
fn the_mean_of_samples_has_the_derivative_of_the_integral() {
    let wo = Dual::vector(DVec3::new(0.91_f64.sqrt(), 0.0, 0.3));
    let glass = gradient([0.5, 0.25, 0.25], |weights| {
        let roughness = [0.1, 0.3, 0.6];
        let mut terms = Vec::new();
        for (weight, roughness) in weights.into_iter().zip(roughness) {
            terms.push((weight, Gaussian::new(Dual::constant(roughness))?.into()));
        }
        let facets = AnyMixture::new(terms)?;
        let glass = CookTorrance::new(facets, Dielectric::new(Dual::constant(1.5))?);
        Ok::<_, ParameterError>(Sampled(glass).albedo(wo))
    });
    close(glass.unwrap().derivatives[0], 0.0404, 1e-4);

    // Minnaert's albedo ρ cosᵏ⁻¹θ is known.
    let wo = DVec3::new(0.6, 0.0, 0.8);
    let moon = gradient([0.5, 1.5], |[albedo, k]| {
        Minnaert::new(albedo, k).map(|moon| {
            let viewer =
                Vector3 { x: Dual::constant(wo.x), y: Dual::zero(), z: Dual::constant(wo.z) };
            Sampled(moon).albedo(viewer)
        })
    });
    let moon = moon.unwrap();
    close(moon.derivatives[0], 0.8_f64.sqrt(), 1e-3);
    close(moon.derivatives[1], moon.value * 0.8_f64.ln(), 1e-3);
}
