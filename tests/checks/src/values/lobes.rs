//! Lobes and diffuse surfaces.

use std::f64::consts::{FRAC_1_PI, PI};

use brdf::{
    BlinnPhong, Brdf, ClassicPhong, OrenNayar, ParameterError, Phong, SchlickPower, from_spherical,
};
use glam::DVec3;

use super::reference::{Case, each};
use super::{Check, Number, Verdict, vector};

pub(super) fn all<T: Number>() -> [Check; 5] {
    [
        ("Phong and Blinn–Phong", phong_family::<T>),
        ("half the angle, four times the exponent", half_angle::<T>),
        ("Schlick's power", schlick_power::<T>),
        ("Oren–Nayar", oren_nayar::<T>),
        ("albedo of Oren–Nayar", oren_nayar_albedo::<T>),
    ]
}

/// The value of a model of one channel.
fn value<T: Number>(model: &impl Brdf<T, Color = T>, [wi, wo]: [DVec3; 2]) -> f64 {
    model.eval(vector::<T>(wi), vector::<T>(wo)).into()
}

fn phong_family<T: Number>() -> Verdict {
    each("phong_family", |case| {
        let pair = ["i", "o"].map(|which| case.direction(which));
        let (one, n, exponent) = (T::one(), case.number("n"), case.input::<T>("n"));
        // Exponent 1 is the cosine itself.
        let cosine = value(&ClassicPhong::new(one, one)?, pair) * pair[0].z;
        case.same("r_dot_v", cosine)?;
        case.same("n_dot_h", value(&BlinnPhong::unnormalized(one, one)?, pair))?;
        case.same("phong_1975_over_cos", value(&ClassicPhong::new(one, exponent)?, pair))?;
        case.same("phong_modified", value(&Phong::new(one, exponent)?, pair))?;
        case.same("blinn_phong_normalised", value(&BlinnPhong::new(one, exponent)?, pair))?;
        let blinn = value(&BlinnPhong::unnormalized(one, exponent)?, pair);
        case.same("blinn_phong_8pi", blinn * (n + 8.0) / (8.0 * PI))?;
        case.same("schlick_power", value(&SchlickPower::unnormalized(one, exponent)?, pair))
    })
}

/// Light and viewer in one plane with the normal, the viewer off the mirror direction by β.
fn in_plane(beta: f64) -> [DVec3; 2] {
    [from_spherical(0.5 * beta, 0.0); 2]
}

fn half_angle<T: Number>() -> Verdict {
    each("phong_half_angle_relation", |case| {
        let (h, pair) = (case.number("h"), in_plane(case.number("beta")));
        let phong = ClassicPhong::new(T::one(), T::lit(h))?;
        case.same("lhs", value(&phong, pair) * pair[0].z)?;
        case.same("rhs", value(&BlinnPhong::unnormalized(T::one(), T::lit(4.0 * h))?, pair))
    })
}

fn schlick_power<T: Number>() -> Verdict {
    each("schlick_power", |case| {
        let exponent = case.input::<T>("h");
        let pair = in_plane(case.number("s").acos());
        case.same("value", value(&SchlickPower::unnormalized(T::one(), exponent)?, pair))?;
        case.same("norm", value(&SchlickPower::new(T::one(), exponent)?, [DVec3::Z; 2]))
    })
}

fn rough<T: Number>(case: &Case<'_>, albedo: T) -> Result<OrenNayar<T, T>, ParameterError> {
    OrenNayar::new(albedo, case.input("sigma"))
}

fn oren_nayar<T: Number>() -> Verdict {
    each("oren_nayar", |case| {
        let pair = ["i", "o"].map(|which| case.direction(which));
        let (albedo, sigma) = (case.input::<T>("rho"), case.input::<T>("sigma"));
        case.same("qualitative_033", value(&rough(case, albedo)?, pair))?;
        let interreflecting = OrenNayar::with_interreflection(albedo, sigma)?;
        case.same("qualitative_057", value(&interreflecting, pair))?;

        let white = rough(case, T::one())?;
        let a = value(&white, [DVec3::Z; 2]) / FRAC_1_PI;
        case.same("A", a)?;
        // Back to the light from 45°, sinα tanβ = 1/√2.
        let w = DVec3::new(0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt());
        case.same("B", (value(&white, [w; 2]) / FRAC_1_PI - a) * 2.0_f64.sqrt())
    })
}

fn oren_nayar_albedo<T: Number>() -> Verdict {
    each("oren_nayar_qualitative_albedo", |case| {
        let wo = from_spherical(case.number("theta"), 0.3);
        case.same("value", rough(case, T::one())?.albedo(vector::<T>(wo)))
    })
}
