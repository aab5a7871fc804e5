//! Distributions of facet normals.

use std::f64::consts::{FRAC_1_PI, FRAC_PI_4, PI, TAU};

use brdf::{
    Beckmann, Blinn, Blinn1977, Distribution, Gaussian, Ggx, Gtr, Mixture, ParameterError, Smith,
    StudentT, Vector, from_spherical, to_spherical,
};
use glam::DVec3;

use super::reference::{Case, each};
use super::{Check, Number, Verdict, fail, near, plain, vector};

pub(super) fn all<T: Number>() -> [Check; 14] {
    [
        ("density of Beckmann", beckmann::<T>),
        ("density of GGX", ggx::<T>),
        ("density of Gaussian", gaussian::<T>),
        ("density of Blinn", blinn::<T>),
        ("density of GTR", gtr::<T>),
        ("density of Student's t and its Λ", student_t::<T>),
        ("samples of GTR and Student's t", samples_of_tails::<T>),
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

fn gtr<T: Number>() -> Verdict {
    each("D_gtr", |case| {
        let gtr = Gtr::new(case.input::<T>("alpha_g"), case.input("gamma"))?;
        case.same("value", gtr.density(case.vector::<T>("m")))
    })?;
    // What is 0/0 in print: roughness 1, and γ = 1 beside its neighbours.
    let h = vector::<T>(from_spherical(0.7, 0.3));
    for gamma in [0.5, 1.0, 2.0, 3.0] {
        let even = Gtr::new(T::one(), T::lit(gamma))?.density(h);
        near("GTR of roughness 1", even, FRAC_1_PI, 1e-14)?;
    }
    let of =
        |gamma| Ok::<f64, ParameterError>(Gtr::new(T::lit(0.2), T::lit(gamma))?.density(h).into());
    let mean = 0.5 * (of(1.0 - 1e-4)? + of(1.0 + 1e-4)?);
    near("GTR of γ = 1", T::lit(of(1.0)?), mean, 1e-6 * mean)
}

fn student_t<T: Number>() -> Verdict {
    each("D_student_t", |case| {
        let student = StudentT::new(case.input::<T>("alpha_g"), case.input("gamma"))?;
        let h = from_spherical(case.input::<T>("theta_m"), T::lit(0.3));
        case.same("D", student.density(h))?;
        let w = from_spherical(case.input::<T>("theta"), T::lit(0.7));
        case.same("Lambda", student.lambda(w))
    })?;
    // With grain, γ = 2 is GGX, and no tail at all is Beckmann's.
    let h = vector::<T>(from_spherical(0.5, 0.8));
    let (x, y) = (T::lit(0.2), T::lit(0.5));
    let ggx = Ggx::anisotropic(x, y)?.density(h).into();
    near("γ = 2", StudentT::anisotropic(x, y, T::lit(2.0))?.density(h), ggx, 1e-13 * ggx)?;
    let beckmann: f64 = Beckmann::anisotropic(x, y)?.density(h).into();
    let short = StudentT::anisotropic(x, y, T::lit(1e6))?.density(h);
    near("γ = 10⁶", short, beckmann, 1e-5 * beckmann)
}

/// Numbers along the distribution function: with tan²θ_h the part beyond goes like the printed one.
fn samples_of_tails<T: Number>() -> Verdict {
    for (gamma, u) in [(0.6, 0.3), (1.0, 0.7), (1.5, 0.2), (3.0, 0.9), (8.0, 0.6)] {
        for alpha in [0.1_f64, 0.9, 2.0] {
            let gtr = Gtr::new(T::lit(alpha), T::lit(gamma))?;
            let h = plain::<T>(gtr.sample([T::lit(u), T::lit(0.2)]));
            let square = alpha * alpha;
            let q = 1.0 + (square - 1.0) * h.z * h.z;
            let whole: f64 =
                if gamma == 1.0 { square.ln() } else { square.powf(1.0 - gamma) - 1.0 };
            let part: f64 = if gamma == 1.0 { q.ln() } else { q.powf(1.0 - gamma) - 1.0 };
            near("GTR", T::lit(1.0 - part / whole), u, 1e-9)?;
        }
        let student = StudentT::new(T::lit(0.4), T::lit(gamma + 1.0))?;
        let h = plain::<T>(student.sample([T::lit(u), T::lit(0.2)]));
        let square = (1.0 - h.z * h.z) / (h.z * h.z) / 0.16;
        let beyond = (1.0 + square / gamma).powf(-gamma);
        near("Student", T::lit(1.0 - beyond), u, 1e-12)?;
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
