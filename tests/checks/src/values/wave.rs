//! Surfaces in wave optics.

use brdf::wave::Masking;
use brdf::{
    Beckmann, BeckmannKirchhoff, Bsdf, Conductor, Constant, Distribution, Fresnel, He1991,
    TransportMode, Vector, from_spherical,
};

use super::reference::{Case, each};
use super::{Check, Number, Verdict, near};

const RADIANCE: TransportMode = TransportMode::Radiance;

pub(super) fn all<T: Number>() -> [Check; 7] {
    [
        ("Beckmann and Kirchhoff", beckmann_kirchhoff::<T>),
        ("He, diffuse", diffuse::<T>),
        ("He, specular", specular::<T>),
        ("He, roughness and shadowing", roughness::<T>),
        ("He, shadowing as printed", printed::<T>),
        ("very rough surfaces", very_rough::<T>),
        ("smooth surfaces", smooth::<T>),
    ]
}

/// A length of a case, which is in micrometres.
fn length<T: Number>(case: &Case<'_>, key: &str) -> T {
    T::lit(1000.0 * case.number(key))
}

fn white<T: Number>() -> Result<Constant<T>, brdf::ParameterError> {
    Constant::new(T::one())
}

fn he<T: Number>(case: &Case<'_>) -> Result<He1991<Conductor<T>, T, T>, brdf::ParameterError> {
    let metal = Conductor::new(case.input("n"), case.input("k"))?;
    He1991::new(length(case, "sigma0"), length(case, "tau"), metal, length(case, "lam"))
}

fn beckmann_kirchhoff<T: Number>() -> Verdict {
    each("beckmann_kirchhoff_1963", |case| {
        let (wi, wo) = (case.vector::<T>("i"), case.vector::<T>("o"));
        let [sigma, correlation, wavelength] = ["sigma", "T", "lam"].map(|key| length(case, key));
        let model = BeckmannKirchhoff::new(sigma, correlation, white::<T>()?, wavelength)?;
        case.same("f", model.eval(wi, wo, RADIANCE).into())?;
        let lobe = model.specular(wo, RADIANCE).reflected.weight;
        let g =
            4.0 * (2.0 * std::f64::consts::PI / case.number("lam") * case.number("sigma")).powi(2);
        let cos: f64 = wo.z().into();
        near("lobe", lobe, (-g * cos * cos).exp(), 1e-13)
    })
}

fn diffuse<T: Number>() -> Verdict {
    each("he_1991_directional_diffuse", |case| {
        polarized::<T>(case)?;
        let (wi, wo) = (case.vector::<T>("i"), case.vector::<T>("o"));
        let model = he::<T>(case)?;
        case.same("f_dd", model.eval(wi, wo, RADIANCE).into())?;
        case.same("sigma", model.effective_roughness(wi, wo).into() / 1000.0)?;
        case.same("S", (model.shadowing(wi) * model.shadowing(wo)).into())?;
        let with = model.with_uniform_diffuse(T::lit(0.1))?.eval(wi, wo, RADIANCE).into();
        near("uniform part", with - model.eval(wi, wo, RADIANCE).into(), 0.1, 1e-14)
    })
}

/// Powers from each state into each, which are half of what a matrix says of unpolarised light and so on; and
/// of U the amplitudes with their phases.
fn polarized<T: Number>(case: &Case<'_>) -> Verdict {
    if case.has("f_dd_ss") {
        let (wi, wo) = (case.vector::<T>("i"), case.vector::<T>("o"));
        let model = he::<T>(case)?.with_uniform_diffuse(T::lit(0.1))?;
        let rows = model.mueller(wi, wo).rows.map(|row| row.map(Into::<f64>::into));
        near("M00", rows[0][0], model.eval(wi, wo, RADIANCE).into(), 0.0)?;
        let [[all, by_in], [by_out, both]] =
            [[rows[0][0] - 0.1, rows[0][1]], [rows[1][0], rows[1][1]]];
        case.same("f_dd_ss", (all + by_in + by_out + both) / 2.0)?;
        case.same("f_dd_sp", (all - by_in + by_out - both) / 2.0)?;
        case.same("f_dd_ps", (all + by_in - by_out - both) / 2.0)?;
        case.same("f_dd_pp", (all - by_in - by_out + both) / 2.0)?;
        let of = |key: &str, part: &str| case.output(key)[part].as_f64().unwrap_or(f64::NAN);
        let product = |a: &str, b: &str| of(a, "re") * of(b, "re") + of(a, "im") * of(b, "im");
        let whole = product("J_ss", "J_ss")
            + product("J_sp", "J_sp")
            + product("J_ps", "J_ps")
            + product("J_pp", "J_pp");
        let want = 2.0 * (product("J_ss", "J_pp") + product("J_sp", "J_ps")) / whole * all;
        case.compare("M22", rows[2][2], want)?;
        let want = 2.0 * (product("J_ss", "J_pp") - product("J_sp", "J_ps")) / whole * all;
        case.compare("M33", rows[3][3], want)?;
    }
    Ok(())
}

fn specular<T: Number>() -> Verdict {
    each("he_1991_specular", |case| {
        let wo: T::Vec3 = from_spherical(case.input("theta"), T::lit(0.7));
        let model = he::<T>(case)?;
        case.same("rho_s", model.specular(wo, RADIANCE).reflected.weight.into())?;
        let rows = model.specular_mueller(wo).rows.map(|row| row.map(Into::<f64>::into));
        case.same("rho_s_s", rows[0][0] + rows[0][1])?;
        case.same("rho_s_p", rows[0][0] - rows[0][1])?;
        case.same("sigma", model.effective_roughness(wo, wo).into() / 1000.0)
    })
}

fn roughness<T: Number>() -> Verdict {
    each("he_1991_roughness", |case| {
        let (wi, wo) = (case.vector::<T>("i"), case.vector::<T>("o"));
        let model = He1991::new(
            length::<T>(case, "sigma0"),
            length(case, "tau"),
            white::<T>()?,
            T::lit(500.0),
        )?;
        case.same("sigma", model.effective_roughness(wi, wo).into() / 1000.0)?;
        case.same("S_i", model.shadowing(wi).into())?;
        case.same("S_o", model.shadowing(wo).into())
    })
}

/// S₁ of both forms at ν = 1 and 3, by 16 digits.
fn printed<T: Number>() -> Verdict {
    for (nu, corrected, printed) in [
        (1.0_f64, 0.8987668387056716, 0.7655939842309021),
        (3.0, 0.9999883955854933, 0.9140495148055077),
    ] {
        let model = He1991::new(T::lit(200.0), T::lit(400.0 * nu), white::<T>()?, T::lit(500.0))?;
        // τ/(2σ) = ν at 45°.
        let w: T::Vec3 = from_spherical(T::lit(std::f64::consts::FRAC_PI_4), T::zero());
        near("corrected", model.shadowing(w), corrected, 1e-14)?;
        near("printed", model.with_masking(Masking::Printed).shadowing(w), printed, 1e-14)?;
    }
    Ok(())
}

/// The geometric limit |F|² S D/(4 cosθ cosθ) of Beckmann's normals of roughness 2σ/τ, with the first order
/// in 1/g; and up to S and the roughness that is seen, both models are the same.
fn very_rough<T: Number>() -> Verdict {
    for g in [1e5, 1e6] {
        for (theta_i, theta_o, phi) in
            [(0.2, 0.5, 2.9), (0.7, 0.7, std::f64::consts::PI), (1.1, 0.4, 2.0)]
        {
            let wi: T::Vec3 = from_spherical(T::lit(theta_i), T::zero());
            let wo: T::Vec3 = from_spherical(T::lit(theta_o), T::lit(phi));
            let (sigma, slope) = (1e4, 0.3);
            let cosines: f64 = (wi.z() + wo.z()).into();
            let correlation = 2.0 * sigma / slope;
            // Of g where everything is seen.
            let k = f64::sqrt(g) / (sigma * cosines);
            let wavelength = T::lit(2.0 * std::f64::consts::PI / k);
            let metal = Conductor::new(T::lit(1.1), T::lit(6.3))?;
            let he = He1991::new(T::lit(sigma), T::lit(correlation), metal, wavelength)?;
            let sum: T::Vec3 = wi + wo;
            let [x, y] = [sum.x().into(), sum.y().into()];
            let seen = he.effective_roughness(wi, wo);
            let ratio: f64 = (seen / T::lit(sigma)).into();
            let (e, g) = ((k * correlation).powi(2) * (x * x + y * y) / 4.0, g * ratio * ratio);
            let facets = Beckmann::new((seen + seen) / T::lit(correlation))?;
            let h = sum.normalize_or_normal();
            let density = facets.density(h) / (T::lit(4.0) * wi.z() * wo.z());
            let limit: f64 = (metal.reflectance(Vector::dot(h, wi)) * density).into();
            let order = 1.0 / g - 2.0 * e / (g * g) + e * e / (2.0 * g * g * g);
            let s: f64 = (he.shadowing(wi) * he.shadowing(wo)).into();
            let got: f64 = he.eval(wi, wo, RADIANCE).into();
            near(
                "He, to the first order",
                got / (limit * s * (1.0 + order)),
                1.0,
                20.0 / (g * g) + 1e-11,
            )?;
            near("He, limit", got / (limit * s), 1.0, 20.0 / g)?;

            let same = BeckmannKirchhoff::new(seen, T::lit(correlation), metal, wavelength)?;
            let same: f64 = same.eval(wi, wo, RADIANCE).into();
            near("Beckmann and Kirchhoff", got / (same * s), 1.0, 1e-12)?;
        }
    }
    Ok(())
}

/// Mirrors; and of g ≪ 1 the first term.
fn smooth<T: Number>() -> Verdict {
    let (wi, wo): (T::Vec3, T::Vec3) =
        (from_spherical(T::lit(0.5), T::zero()), from_spherical(T::lit(0.52), T::lit(3.1)));
    let lit = T::lit;
    let gold = Conductor::new(lit(0.14), lit(3.697))?;
    let mirror = He1991::new(T::zero(), lit(1000.0), gold, lit(650.0))?;
    near("value of a mirror", mirror.eval(wi, wo, RADIANCE), 0.0, 0.0)?;
    let f: f64 = gold.reflectance(wo.z()).into();
    near("a mirror", mirror.specular(wo, RADIANCE).reflected.weight, f, 1e-15)?;
    let (sigma, correlation, wavelength) = (0.01, 2000.0, 650.0);
    let smooth =
        BeckmannKirchhoff::new(lit(sigma), lit(correlation), white::<T>()?, lit(wavelength))?;
    let got: f64 = smooth.eval(wi, wo, RADIANCE).into();
    let sum: T::Vec3 = wi + wo;
    let [x, y, z, cos_i, cos_o] =
        [sum.x(), sum.y(), sum.z(), wi.z(), wo.z()].map(Into::<f64>::into);
    let k = 2.0 * std::f64::consts::PI / wavelength;
    let squared = x * x + y * y + z * z;
    let first = (k * sigma * k * correlation * squared).powi(2)
        / (16.0 * std::f64::consts::PI * cos_i * cos_o)
        * (-(k * correlation).powi(2) * (x * x + y * y) / 4.0).exp();
    near("first term", got / first, 1.0, 1e-7)
}
