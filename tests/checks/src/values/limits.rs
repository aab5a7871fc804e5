//! Integrals and limits whose values are known.

use std::f64::consts::{FRAC_1_PI, TAU};

use brdf::{
    Beckmann, Blinn, BlinnPhong, Brdf, Distribution, Frame, Gaussian, Ggx, Lambert, OrenNayar,
    Phong, Smith, Vector, WeightedSum, from_spherical, reflect,
};
use glam::DVec3;

use super::{Check, Number, Verdict, near, plain, vector};
use crate::slopes::Facing;

pub(super) fn all<T: Number>() -> [Check; 5] {
    [
        ("Frame", frames::<T>),
        ("densities integrate to 1", densities::<T>),
        ("visible facets fill the projected area", furnace::<T>),
        ("diffuse limits", diffuse_limits::<T>),
        ("weighted sum", weighted_sum::<T>),
    ]
}

/// Orthonormal, right-handed, with the normal along z and the tangent where it was asked for.
fn frames<T: Number>() -> Verdict {
    for normal in [DVec3::Z, -DVec3::Z, DVec3::new(0.3, -1.2, 0.4), DVec3::new(-2.0, 0.1, -0.7)] {
        let tangent = DVec3::new(0.2, 1.0, 0.5);
        let around = Frame::from_normal(vector::<T>(normal));
        let along = Frame::from_normal_and_tangent(vector::<T>(normal), vector::<T>(tangent));
        let toward = tangent - normal * tangent.dot(normal) / normal.length_squared();
        for (frame, tangent) in [(around, None), (along, Some(toward.normalize()))] {
            let [x, y, z] =
                [frame.tangent(), frame.bitangent(), frame.normal()].map(|w| plain::<T>(w));
            let off = (x.cross(y) - z).length()
                + (z - normal.normalize()).length()
                + (x.length() - 1.0).abs()
                + (y.length() - 1.0).abs()
                + x.dot(z).abs()
                + tangent.map_or(0.0, |tangent| (x - tangent).length());
            near("axes", off, 0.0, 1e-14)?;
            let w = DVec3::new(0.1, 0.2, 0.3);
            let there = plain::<T>(frame.to_local(frame.to_world(vector::<T>(w))));
            near("there and back", (there - w).abs().max_element(), 0.0, 1e-15)?;
        }
    }
    Ok(())
}

fn densities<T: Number>() -> Verdict {
    fn check<T: Number>(what: &str, scale: f64, distribution: &dyn Distribution<T>) -> Verdict {
        let facing = Facing::new(DVec3::Z, [scale, scale]);
        let whole = facing.integral(facing.chi, facing.psi, 4, |h| {
            distribution.density(vector::<T>(h)).into() * h.z
        });
        near(what, whole, 1.0, 1e-8)
    }
    for roughness in [0.05, 0.4, 1.5] {
        let scale = T::lit(roughness);
        check("Beckmann", roughness, &Beckmann::new(scale)?)?;
        check("GGX", roughness, &Ggx::new(scale)?)?;
        check("Gaussian", roughness, &Gaussian::new(scale)?)?;
    }
    for exponent in [0.0, 3.0, 400.0_f64] {
        check("Blinn", (2.0 / (exponent + 2.0)).sqrt(), &Blinn::new(T::lit(exponent))?)?;
    }
    Ok(())
}

/// ∫ (w·h)₊ D dω = N·w (1 + Λ).
fn furnace<T: Number>() -> Verdict {
    fn check<T: Number>(what: &str, scale: [f64; 2], distribution: &dyn Smith<T>) -> Verdict {
        for theta in [0.3, 1.0, 1.5] {
            let wo = from_spherical(theta, 0.8);
            let facing = Facing::new(wo, scale);
            let visible = facing.integral(facing.chi, facing.psi, 3, |h| {
                distribution.density(vector::<T>(h)).into() * wo.dot(h).max(0.0)
            });
            let claimed = wo.z + distribution.lambda_cos(vector::<T>(wo)).into();
            near(what, claimed / visible, 1.0, 1e-8)?;
        }
        Ok(())
    }
    let scale = [0.2, 0.5];
    let [x, y] = scale.map(T::lit);
    check("Beckmann", scale, &Beckmann::anisotropic(x, y)?)?;
    check("GGX", scale, &Ggx::anisotropic(x, y)?)
}

type Gray<T> = Box<dyn Brdf<T, Color = T>>;

/// Lambert's surface, and those that it is a limit of.
fn diffuse_limits<T: Number>() -> Verdict {
    let pair = [from_spherical(0.4, 1.0), from_spherical(1.3, 2.0)];
    let [wi, wo] = pair.map(|w| vector::<T>(w));
    let (half, zero) = (T::lit(0.5), T::zero());
    let models: [(&str, Gray<T>); 4] = [
        ("Lambert", Box::new(Lambert::new(half)?)),
        ("Oren–Nayar, σ = 0", Box::new(OrenNayar::new(half, zero)?)),
        ("Phong, n = 0", Box::new(Phong::new(half, zero)?)),
        ("Blinn–Phong, n = 0", Box::new(BlinnPhong::new(half, zero)?)),
    ];
    models
        .iter()
        .try_for_each(|(what, model)| near(what, model.eval(wi, wo), 0.5 * FRAC_1_PI, 1e-15))?;
    // Both at the horizon, where the slope of a rough surface has no bound.
    let horizon = vector::<T>(DVec3::new(1.0, 0.0, f64::MIN_POSITIVE / 1e15));
    let smooth = OrenNayar::new(half, zero)?;
    near("Oren–Nayar at the horizon", smooth.eval(horizon, horizon), 0.5 * FRAC_1_PI, 1e-15)
}

/// Weights that do not add up to 1: the probabilities still do, and each is met by as many numbers.
fn weighted_sum<T: Number>() -> Verdict {
    let lobe = |exponent| Phong::new(vector::<T>(DVec3::ONE), T::lit(exponent));
    let terms = [(0.3, 4.0), (0.9, 40.0)];
    let weight = |term: usize| vector::<T>(DVec3::splat(terms[term].0));
    let sum = WeightedSum::new([(weight(0), lobe(terms[0].1)?), (weight(1), lobe(terms[1].1)?)])?;
    let (wi, wo) = (from_spherical(0.5, 0.2), from_spherical(0.4, 3.2));
    let cos = reflect(wi, DVec3::Z).dot(wo);
    let (mut value, mut pdf) = (0.0, 0.0);
    for (weight, exponent) in terms {
        value += weight * (exponent + 2.0) / TAU * cos.powf(exponent);
        pdf += weight / 1.2 * (exponent + 1.0) / TAU * cos.powf(exponent);
    }
    let [wi, wo] = [wi, wo].map(|w| vector::<T>(w));
    near("f", sum.eval(wi, wo).x(), value, 1e-14 * value)?;
    near("density", sum.pdf(wi, wo), pdf, 1e-14 * pdf)?;
    // The first term takes the first quarter of the numbers, and all of each lobe is drawn.
    for (u, versine) in [(0.125, 1.0 - 0.5_f64.powf(0.2)), (0.625, 1.0 - 0.5_f64.powf(1.0 / 41.0))]
    {
        let drawn = sum.sample(vector::<T>(DVec3::Z), [u, 0.1].map(T::lit)).wi;
        near("sample", drawn.z(), 1.0 - versine, 1e-14)?;
    }
    Ok(())
}
