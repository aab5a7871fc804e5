//! Schlick's model of 1994.

use std::f64::consts::PI;

use brdf::glossy::{schlick_beckmann, schlick_masking};
use brdf::{
    Brdf, Bsdf, Schlick1994, Schlick1994Layer, SchlickShadowing, SplitSchlick1994, TransportMode,
    from_spherical,
};
use glam::DVec3;

use super::reference::{Case, each};
use super::{Check, Number, Verdict, near, vector};

pub(super) fn all<T: Number>() -> [Check; 4] {
    [
        ("Schlick's model", whole::<T>),
        ("half vectors of Schlick's model", half_vectors::<T>),
        ("the mean of A", evenness::<T>),
        ("Schlick's rational functions", rational::<T>),
    ]
}

type Layer<T> = Schlick1994Layer<T, T>;

fn layer<T: Number>(case: &Case<'_>, [specular, roughness, isotropy]: [&str; 3]) -> Layer<T> {
    Schlick1994Layer {
        specular: case.input(specular),
        roughness: case.input(roughness),
        isotropy: case.input(isotropy),
    }
}

fn whole<T: Number>() -> Verdict {
    each("schlick_1994", |case| {
        let pair = ["i", "o"].map(|which| vector::<T>(case.direction(which)));
        let value = |model: Schlick1994<T, T>| model.eval(pair[0], pair[1]).into();
        let (top, bottom) = (layer(case, ["C", "r", "p"]), layer(case, ["C2", "r2", "p2"]));
        let single = Schlick1994::new(top)?;
        let double = Schlick1994::double(top, bottom)?;
        let plain = SchlickShadowing::None;
        case.same("single_plain", value(single.with_shadowing(plain)))?;
        case.same("double_plain", value(double.with_shadowing(plain)))?;
        case.same("single_shadowed", value(single))?;
        case.same("double_shadowed", value(double))?;
        // White facets answer D itself.
        let white = Schlick1994::new(Layer { specular: T::one(), ..top })?;
        let of = |shadowing| value(white.with_shadowing(shadowing));
        case.same("D_plain", of(plain))?;
        case.same("D_shadowed", of(SchlickShadowing::Schlick))?;
        case.same("D_reemission_printed", of(SchlickShadowing::ReemissionPrinted))?;
        case.same("D_reemission_lambert", of(SchlickShadowing::ReemissionBounded))?;
        let split = white.with_shadowing(plain);
        case.same("D_composed_nonmirror", value(split.with_split(true)))?;
        let wo = pair[1];
        let mode = TransportMode::Radiance;
        let lobe = SplitSchlick1994::new(split).specular(wo, mode).reflected.weight;
        case.same("weight_c", lobe)?;
        case.compare("S", value(single) / of(SchlickShadowing::Schlick), case.number_out("S"))
    })
}

/// The density of half vectors, and the place of one of them: a viewer at the normal sees it mirror what the
/// sample says.
fn half_vectors<T: Number>() -> Verdict {
    each("schlick_1994_sampling", |case| {
        let specular = T::one();
        let (roughness, isotropy) = (case.input("r"), case.input("p"));
        let model = Schlick1994::new(Layer { specular, roughness, isotropy })?;
        let (t, psi) = (case.number_out("t"), case.number_out("psi"));
        // Seen from the half vector itself nothing is turned: wi = wo = h.
        let h = from_spherical(t.acos(), psi);
        let seen = vector::<T>(h);
        let pdf = model.pdf(seen, seen).into() * 4.0;
        near("density", T::lit(pdf), case.number_out("pdf_h"), 1e-9 * pdf)?;
        let u = [case.input::<T>("u1"), case.input("u2")];
        let normal = vector::<T>(DVec3::Z);
        let sample = model.sample(normal, u);
        if sample.pdf.into() <= 0.0 {
            return Ok(());
        }
        let half = (super::plain::<T>(sample.wi) + DVec3::Z).normalize();
        near("t", T::lit(half.z), t, 1e-7)?;
        if half.z > 1.0 - 1e-9 {
            return Ok(());
        }
        let angle = half.y.atan2(half.x).rem_euclid(2.0 * PI);
        near("ψ", T::lit(angle), psi, 1e-7)
    })
}

/// Densities of half vectors with and without grain differ by A over its mean.
fn evenness<T: Number>() -> Verdict {
    each("schlick_A_normaliser", |case| {
        let (specular, roughness) = (T::one(), T::lit(0.3));
        let with = |isotropy| Schlick1994::new(Layer { specular, roughness, isotropy });
        let (grain, even) = (with(case.input("p"))?, with(T::one())?);
        // Along the tangent w = 1 and A = √p.
        let h = vector::<T>(from_spherical(0.6, 0.0));
        let ratio = grain.pdf(h, h).into() / even.pdf(h, h).into();
        case.same("value", case.number("p").sqrt() / ratio)
    })
}

fn rational<T: Number>() -> Verdict {
    each("schlick_rational", |case| {
        let (m, t, v) = (case.input::<T>("m"), case.input("t"), case.input("v"));
        case.same("D_rational", schlick_beckmann(m, t))?;
        case.same("G_rational", schlick_masking(m, v))
    })
}
