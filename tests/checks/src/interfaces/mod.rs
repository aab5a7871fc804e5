//! The models over the whole sphere of directions, `tests/interfaces.jsonl`, in any number, and what holds
//! of all of them.

pub mod laws;

use std::f64::consts::PI;
use std::sync::LazyLock;

use brdf::description::BsdfDescription;
use brdf::{
    AnyBsdf, Bsdf, BsdfSample, Lobes, Power, Real, TransportMode, TwoSided, from_spherical,
};
use glam::DVec3;
use serde::Deserialize;

use crate::models::{form, rounded};

pub type Model<T> = dyn Bsdf<T, Color = <T as Real>::Vec3>;

pub const MODES: [TransportMode; 2] = [TransportMode::Radiance, TransportMode::Importance];

/// A line of the file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    pub name: String,
    /// Its numbers rounded to `f32`, so that all kinds of numbers say the same of the same model.
    #[serde(deserialize_with = "rounded")]
    pub bsdf: BsdfDescription,
    /// The index below the surface over that above, where radiance is scaled by it.
    #[serde(default = "one")]
    ior: f32,
    /// Whether a beam keeps all its power, from whatever side the model answers for.
    #[serde(default)]
    pub lossless: bool,
    /// The largest power of the viewers over that of the beam, to three digits, where a model is known to
    /// exceed it.
    #[serde(default = "one")]
    gain: f32,
}

fn one() -> f32 {
    1.0
}

/// One model under test.
pub struct Entry<T: Real> {
    pub row: &'static Row,
    pub model: Box<Model<T>>,
    /// The model on two sides.
    pub two_sided: Box<Model<T>>,
}

struct OneByOne<T: Real>(AnyBsdf<T>);

impl<T: Real> Bsdf<T> for OneByOne<T> {
    type Color = T::Vec3;

    fn eval(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> T::Vec3 {
        self.0.eval(wi, wo, mode)
    }

    fn pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> T {
        self.0.pdf(wi, wo, mode)
    }

    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> (T::Vec3, T) {
        self.0.eval_pdf(wi, wo, mode)
    }

    fn sample(&self, wo: T::Vec3, u: [T; 3], mode: TransportMode) -> BsdfSample<T, T::Vec3> {
        self.0.sample(wo, u, mode)
    }

    fn specular(&self, wo: T::Vec3, mode: TransportMode) -> Lobes<T, T::Vec3> {
        self.0.specular(wo, mode)
    }

    fn power(&self, wo: T::Vec3) -> Power<T::Vec3> {
        self.0.power(wo)
    }
}

impl Row {
    pub fn build<T: Real>(&self) -> AnyBsdf<T> {
        self.bsdf.build().unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }

    /// The model, of which one answer at a time is asked: blocks of answers are not compiled.
    pub fn entry<T: Real>(&'static self) -> Entry<T> {
        self.entry_of(|model| Box::new(OneByOne(model)))
    }

    /// The model with all that batches ask for.
    fn whole<T: Real>(&'static self) -> Entry<T> {
        self.entry_of(|model| Box::new(model))
    }

    fn entry_of<T: Real>(&'static self, boxed: impl Fn(AnyBsdf<T>) -> Box<Model<T>>) -> Entry<T> {
        let two_sided = Box::new(TwoSided::new(boxed(self.build())));
        Entry { row: self, model: boxed(self.build()), two_sided }
    }

    /// What the form of its description is called.
    pub fn form(&self) -> String {
        form(&self.bsdf)
    }

    /// n² on the side of a direction, of a surface that scales radiance.
    pub fn index_squared(&self, w: DVec3) -> f64 {
        if w.z < 0.0 { f64::from(self.ior).powi(2) } else { 1.0 }
    }

    /// Whether the model scatters into all directions of both sides.
    pub fn is_rough(&self) -> bool {
        self.form() == "rough_dielectric" && self.ior != 1.0
    }

    /// Whether the model is one of wave optics that scatters around its lobe.
    #[inline(never)]
    pub fn is_wave(&self) -> bool {
        let form = self.form();
        let up = from_spherical(0.3, 0.0);
        (form == "beckmann_kirchhoff_1963" || form == "he_1991")
            && self.build::<f64>().eval(up, up, TransportMode::Radiance) != DVec3::ZERO
    }

    /// The most that viewers see of a beam.
    pub fn gain(&self) -> f64 {
        f64::from(self.gain)
    }

    /// Whether the model scatters, and not into single directions only.
    pub fn scatters(&self) -> bool {
        let form = self.form();
        self.is_rough() || self.has_parts() || matches!(form.as_str(), "lambert" | "plastic")
    }

    /// Whether a direction may be drawn by several parts of the model, whose densities add.
    pub fn has_parts(&self) -> bool {
        self.is_wave() || self.form() == "schlick_1994"
    }

    /// Whether the model answers for viewers below the surface.
    pub fn is_open(&self) -> bool {
        self.form().ends_with("dielectric")
    }
}

/// All lines.
pub fn rows() -> &'static [Row] {
    static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| {
        let text = crate::text("tests/interfaces.jsonl");
        let row =
            |line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{line}: {error}"));
        text.lines().map(row).collect()
    });
    &ROWS
}

/// All models in double precision.
#[inline(never)]
pub fn double() -> &'static [Entry<f64>] {
    static ALL: LazyLock<Vec<Entry<f64>>> =
        LazyLock::new(|| rows().iter().map(Row::whole).collect());
    &ALL
}

/// All models in single precision.
#[inline(never)]
pub fn single() -> &'static [Entry<f32>] {
    static ALL: LazyLock<Vec<Entry<f32>>> =
        LazyLock::new(|| rows().iter().map(Row::whole).collect());
    &ALL
}

/// Viewers on both sides, near the normal, at critical angles and grazing.
pub fn viewers() -> Vec<DVec3> {
    let critical = (1.0_f64 / 1.5).asin();
    let thetas = [0.05, 0.5, critical - 1e-3, critical + 1e-3, 1.1, 1.4, 1.55];
    let sides = thetas.into_iter().flat_map(|theta| [theta, PI - theta]);
    sides.enumerate().map(|(index, theta)| from_spherical(theta, 0.7 * index as f64)).collect()
}

/// Pairs of directions all over the sphere.
pub fn pairs() -> Vec<(DVec3, DVec3)> {
    let all: Vec<DVec3> = (0..40)
        .map(|index| {
            let index = f64::from(index);
            from_spherical((1.0 - (index + 0.5) / 20.0).acos(), 2.4 * index)
        })
        .collect();
    all.iter().flat_map(|wi| all.iter().map(move |wo| (*wi, *wo))).collect()
}
