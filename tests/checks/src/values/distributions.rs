//! Distributions of facet normals.

use std::f64::consts::{FRAC_1_PI, FRAC_PI_4, PI, TAU};

use brdf::{
    Beckmann, Blinn, Blinn1977, Distribution, Gaussian, Ggx, Mixture, ParameterError, Smith,
    Vector, from_spherical, to_spherical,
};
use glam::DVec3;

use super::reference::{Case, each};
use super::{Check, Number, Verdict, fail, near, plain, vector};

pub(super) fn all<T: Number>() -> [Check; 11] {
    [
        ("density of Beckmann", beckmann::<T>),
        ("density of GGX", ggx::<T>),
        ("density of Gaussian", gaussian::<T>),
        ("density of Blinn", blinn::<T>),
        ("anisotropic densities", anisotropic::<T>),
        ("Blinn's distributions of 1977", blinn_1977::<T>),
        ("mixtures", mixtures::<T>),
        ("Smith's Λ", lambda::<T>),
        ("samples of half vectors", half_vectors::<T>),
        ("visible normals of GGX", visible_ggx::<T>),
        ("visible normals of Beckmann", visible_beckmann::<T>),
    ]
}

fn beckmann<T: Number>() -> Verdict {
    each("D_beckmann", |case| {
        let h = from_spherical(case.input::<T>("alpha"), T::lit(0.3));
        let density: f64 = Beckmann::new(case.input::<T>("m"))?.density(h).into();
        case.same("D", density)?;
        case.same("D_lecture", FRAC_PI_4 * density)?;
        case.same("D_cook_torrance", PI * density)
    })
}

fn ggx<T: Number>() -> Verdict {
    each("D_ggx", |case| {
        let ggx = Ggx::new(case.input::<T>("alpha_g"))?;
        case.same("value", ggx.density(case.vector::<T>("m")))
    })
}

fn gaussian<T: Number>() -> Verdict {
    each("D_gaussian", |case| {
        let gaussian = Gaussian::new(case.input::<T>("m"))?;
        case.same("c", gaussian.density(vector::<T>(DVec3::Z)))?;
        case.same("D", gaussian.density(from_spherical(case.input::<T>("alpha"), T::lit(0.3))))
    })
}

fn blinn<T: Number>() -> Verdict {
    each("D_blinn_phong", |case| {
        let blinn = Blinn::new(case.input::<T>("n"))?;
        case.same("value", blinn.density(case.vector::<T>("m")))
    })?;
    for roughness in [0.01, 0.3, 1.0] {
        let peak = Blinn::from_roughness(T::lit(roughness))?.density(vector::<T>(DVec3::Z));
        let want = FRAC_1_PI / (roughness * roughness);
        near("peak of Blinn", peak, want, 1e-12 * want)?;
    }
    Ok(())
}

fn anisotropic<T: Number>() -> Verdict {
    each("D_anisotropic", |case| {
        let (along_x, along_y) = (case.input::<T>("ax"), case.input::<T>("ay"));
        let h = case.direction("m");
        let beckmann: f64 = Beckmann::anisotropic(along_x, along_y)?.density(vector::<T>(h)).into();
        let ggx: f64 = Ggx::anisotropic(along_x, along_y)?.density(vector::<T>(h)).into();
        case.same("beckmann", beckmann)?;
        case.same("ggx", ggx)?;
        case.same("P22_beckmann", beckmann * h.z.powi(4))?;
        case.same("P22_ggx", ggx * h.z.powi(4))
    })
}

fn blinn_1977<T: Number>() -> Verdict {
    each("D_blinn_1977", |case| {
        let blinn = Blinn1977::new(case.input::<T>("beta"))?;
        let alpha = case.input("alpha");
        case.same("c1", blinn.c1())?;
        case.same("c2", blinn.c2())?;
        case.same("c3", blinn.c3())?;
        case.same("D1", blinn.d1(alpha))?;
        case.same("D2", blinn.d2(alpha))?;
        case.same("D3", blinn.d3(alpha))
    })
}

fn mixtures<T: Number>() -> Verdict {
    each("D_mixture", |case| {
        let (weights, roughness) = (case.inputs::<T>("w"), case.inputs::<T>("m"));
        let h = from_spherical(case.input::<T>("alpha"), T::lit(0.3));
        let w = from_spherical(case.input::<T>("theta"), T::lit(0.7));
        let check = |mixture: &dyn Smith<T>| {
            case.same("D", mixture.density(h))?;
            case.same("Lambda", ratio(mixture.lambda_cos(w), w.z()))
        };
        let component =
            |i: usize| Ok::<_, ParameterError>((weights[i], Beckmann::new(roughness[i])?));
        match weights.len() {
            2 => check(&Mixture::new([component(0)?, component(1)?])?),
            3 => check(&Mixture::new([component(0)?, component(1)?, component(2)?])?),
            other => fail(format!("a mixture of {other}")),
        }
    })
}

/// A quotient in double precision.
fn ratio<T: Number>(over: T, under: T) -> f64 {
    over.into() / under.into()
}

fn lambda<T: Number>() -> Verdict {
    each("lambda_smith", |case| {
        let (roughness, w) =
            (case.input::<T>("alpha_g"), from_spherical(case.input::<T>("theta"), T::lit(0.7)));
        let beckmann = ratio(Beckmann::new(roughness)?.lambda_cos(w), w.z());
        let ggx = ratio(Ggx::new(roughness)?.lambda_cos(w), w.z());
        case.same("beckmann", beckmann)?;
        case.same("ggx", ggx)?;
        case.same("G1_beckmann", 1.0 / (1.0 + beckmann))?;
        case.same("G1_ggx", 1.0 / (1.0 + ggx))?;
        // Exact, and not Walter's rational fit, which is cut off to zero for small angles.
        let rational = case.output("beckmann_rational").as_f64().expect("a number");
        let exact = (beckmann - rational).abs() > 1e-12 * beckmann;
        if exact { Ok(()) } else { fail(format!("{beckmann} is the rational fit")) }
    })
}

fn half_vectors<T: Number>() -> Verdict {
    each("sample_half_vector", |case| {
        let u = [case.input::<T>("u1"), case.input("u2")];
        let check = |name: &str, distribution: &dyn Distribution<T>| {
            let h = distribution.sample(u);
            let (theta, phi) = to_spherical::<T, _>(h);
            case.same(name, theta)?;
            if theta.into() > 0.0 {
                case.same("phi", phi.into().rem_euclid(TAU))?;
            }
            let density: f64 = distribution.density(h).into();
            case.same(&format!("pdf_{name}"), density * h.z().into())
        };
        let roughness = case.input::<T>("alpha_g");
        check("beckmann", &Beckmann::new(roughness)?)?;
        check("ggx", &Ggx::new(roughness)?)?;
        check("blinn_phong", &Blinn::new(case.input::<T>("n"))?)
    })
}

/// With G₁ (wo·h) D / (N·wo), the density of the normals visible from `wo`.
fn visible<T: Number>(case: &Case<'_>, distribution: &dyn Smith<T>) -> Verdict {
    let wo = case.direction("o");
    let h = distribution.sample_visible(vector::<T>(wo), [case.input("u1"), case.input("u2")]);
    case.same_vector::<T>("m", h)?;
    let facing = wo.dot(plain::<T>(h)).max(0.0);
    let seen = wo.z + distribution.lambda_cos(vector::<T>(wo)).into();
    let density: f64 = distribution.density(h).into();
    case.same("pdf_m", facing * density / seen)
}

fn visible_ggx<T: Number>() -> Verdict {
    each("sample_vndf_ggx_caps", |case| {
        visible(case, &Ggx::anisotropic(case.input::<T>("ax"), case.input("ay"))?)
    })
}

fn visible_beckmann<T: Number>() -> Verdict {
    each("sample_vndf_beckmann", |case| {
        visible(case, &Beckmann::anisotropic(case.input::<T>("ax"), case.input("ay"))?)
    })
}
