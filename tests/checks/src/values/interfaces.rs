//! Interfaces over the whole sphere of directions.

use brdf::polarization::Plates;
use brdf::quadrature::integrate;
use brdf::{
    Bsdf, Dielectric, Fresnel, Ggx, Plastic, RoughDielectric, SmithSeparable, SmoothDielectric,
    ThinDielectric, TransportMode, Vector, from_spherical, refract,
};

use super::reference::{Case, each};
use super::{Check, Number, Verdict, fail, near, plain};

pub(super) fn all<T: Number>() -> [Check; 4] {
    [
        ("rough dielectric", rough::<T>),
        ("smooth dielectric", smooth::<T>),
        ("thin dielectric", thin::<T>),
        ("plastic", plastic::<T>),
    ]
}

/// The direction of a case below the surface.
fn below<T: Number>(case: &Case<'_>, which: &str) -> T::Vec3 {
    let w = case.direction(which);
    Vector::new(T::lit(w.x), T::lit(w.y), T::lit(-w.z))
}

/// Light arrives from above; and the same with all turned over, the indices exchanged.
fn rough<T: Number>() -> Verdict {
    each("btdf_walter", |case| {
        let facets = Ggx::new(case.input::<T>("alpha_g"))?;
        let (eta_i, eta_t) = (case.input::<T>("eta_i"), case.input::<T>("eta_t"));
        let (wi, wo) = (case.vector::<T>("i"), below::<T>(case, "t"));
        let over = |w: T::Vec3| -> T::Vec3 { Vector::new(w.x(), w.y(), -w.z()) };
        let from_above = RoughDielectric::new(facets, eta_t / eta_i)?;
        let from_below = RoughDielectric::new(facets, eta_i / eta_t)?;
        for (model, wi, wo) in [(from_above, wi, wo), (from_below, over(wi), over(wo))] {
            let separable = model.with_shadowing(SmithSeparable);
            let mode = TransportMode::Radiance;
            case.same("f", separable.eval(wi, wo, mode).x().into())?;
            case.same("f_correlated", model.eval(wi, wo, mode).x().into())?;
            // Seen from the light, importance is the transpose.
            let mode = TransportMode::Importance;
            case.same("f_correlated", model.eval(wo, wi, mode).x().into())?;
        }
        Ok(())
    })
}

/// Directions by Snell's law, weights by Fresnel's reflectance.
fn smooth<T: Number>() -> Verdict {
    for ior in [0.6, 1.0, 1.5, 2.4] {
        let glass = SmoothDielectric::new(T::lit(ior))?;
        let fresnel = Dielectric::new(T::lit(ior))?;
        for theta in [0.1_f64, 0.6, 1.2, 2.0, 2.9] {
            let wo: T::Vec3 = from_spherical(T::lit(theta), T::lit(0.4));
            let lobes = glass.specular(wo, TransportMode::Radiance);
            let reflectance: f64 = fresnel.reflectance(wo.z()).into();
            near("reflected", lobes.reflected.weight.x(), reflectance, 1e-15)?;
            let scale = if theta < 1.5 { ior * ior } else { 1.0 / (ior * ior) };
            let power = lobes.transmitted.weight.x().into() * scale;
            near("transmitted", power, 1.0 - reflectance, 1e-14)?;
            if reflectance < 1.0 {
                let normal: T::Vec3 = Vector::new(T::zero(), T::zero(), T::one());
                let law = refract(wo, normal, T::one(), T::lit(ior)).direction;
                let off = plain::<T>(law).distance(plain::<T>(lobes.transmitted.wi));
                near("direction", off, 0.0, 1e-15)?;
            }
        }
    }
    Ok(())
}

/// One plate of a pile.
fn thin<T: Number>() -> Verdict {
    for (ior, theta) in [(1.5, 0.0_f64), (1.5, 0.9), (1.5, 1.5), (2.4, 0.7), (1.1, 1.2)] {
        let wo: T::Vec3 = from_spherical(T::lit(theta), T::lit(0.4));
        let lobes = ThinDielectric::new(T::lit(ior))?.specular(wo, TransportMode::Radiance);
        let pile = Plates::new(T::lit(ior), 1, T::zero())?.at(wo.z());
        let [r, t] = [pile.reflectance, pile.transmittance].map(|it| it.unpolarized().into());
        near("reflected", lobes.reflected.weight.x(), r, 1e-14)?;
        near("transmitted", lobes.transmitted.weight.x(), t, 1e-14)?;
    }
    Ok(())
}

/// The value at the normal by its formula; the power of a beam by the integral of the value.
fn plastic<T: Number>() -> Verdict {
    let (rho, ior) = (T::lit(0.6), 1.5);
    let average: f64 = Dielectric::new(T::lit(1.0 / ior))?.average().into();
    let up: T::Vec3 = Vector::new(T::zero(), T::zero(), T::one());
    let entering = 0.96 * 0.96 * 0.6 / (std::f64::consts::PI * ior * ior);
    let nonlinear = Plastic::<T, T>::new(rho, T::lit(ior))?;
    let linear = Plastic::<T, T>::linear(rho, T::lit(ior))?;
    let radiance = TransportMode::Radiance;
    for (model, inside) in [(nonlinear, 0.6 * average), (linear, average)] {
        near("value", model.eval(up, up, radiance), entering / (1.0 - inside), 1e-14)?;
        let wo: T::Vec3 = from_spherical(T::lit(0.8), T::lit(0.2));
        let diffuse = integrate(0.0, 1.0, |root: f64| {
            let cos = root * root;
            let wi: T::Vec3 = from_spherical(T::lit(cos.acos()), T::zero());
            let value: f64 = model.eval(wi, wo, radiance).into();
            value * cos * std::f64::consts::TAU * 2.0 * root
        });
        let lobe: f64 = model.specular(wo, radiance).reflected.weight.into();
        near("power", model.power(wo).reflectance, lobe + diffuse, 1e-9)?;
    }
    let white: f64 = Plastic::<T, T>::new(T::one(), T::lit(ior))?.power(up).reflectance.into();
    if white > 1.0 {
        fail(format!("white plastic reflects {white}"))
    } else {
        near("white", white, 1.0, 1e-14)
    }
}
