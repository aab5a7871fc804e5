//! The families of models that are fitted: descriptions, and which of their numbers are free.

use std::f64::consts::FRAC_PI_2;

use brdf::description::BrdfDescription;
use brdf::fit::{Fit, Metric};
use serde_json::{Value, json};

/// The number that gives a lobe its shape.
#[derive(Clone, Copy)]
pub struct Shape {
    pub name: &'static str,
    pub path: &'static str,
    pub lower: f64,
    pub upper: f64,
    /// Where the solver starts; the best end counts.
    starts: &'static [f64],
}

const SIGMA: Shape = Shape {
    name: "σ",
    path: "oren_nayar.sigma",
    lower: 0.0,
    upper: FRAC_PI_2,
    starts: &[0.1, 0.5],
};
const EXPONENT: Shape = Shape {
    name: "exponent",
    path: "sum[1].brdf.blinn_phong.exponent",
    lower: 1.0,
    upper: 1e5,
    starts: &[20.0, 300.0, 5e3, 8e4],
};
const BECKMANN: Shape = Shape {
    name: "roughness",
    path: "sum[1].brdf.cook_torrance.distribution.beckmann.roughness",
    lower: 1e-3,
    upper: 2.0,
    starts: &[0.005, 0.02, 0.08, 0.32],
};
const GGX: Shape =
    Shape { path: "sum[1].brdf.cook_torrance.distribution.ggx.roughness", ..BECKMANN };

/// A family of models.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    Lambert,
    OrenNayar,
    BlinnPhong,
    Beckmann,
    Ggx,
}

impl Family {
    pub const ALL: [Self; 5] =
        [Self::Lambert, Self::OrenNayar, Self::BlinnPhong, Self::Beckmann, Self::Ggx];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Lambert => "Lambert",
            Self::OrenNayar => "Oren–Nayar",
            Self::BlinnPhong => "Blinn–Phong",
            Self::Beckmann => "Cook–Torrance, Beckmann",
            Self::Ggx => "Cook–Torrance, GGX",
        }
    }

    pub const fn shape(self) -> Option<Shape> {
        match self {
            Self::Lambert => None,
            Self::OrenNayar => Some(SIGMA),
            Self::BlinnPhong => Some(EXPONENT),
            Self::Beckmann => Some(BECKMANN),
            Self::Ggx => Some(GGX),
        }
    }

    /// The places of the diffuse colour and of the specular one, if there is one.
    const fn colors(self) -> (&'static str, Option<&'static str>) {
        match self {
            Self::Lambert => ("lambert.albedo", None),
            Self::OrenNayar => ("oren_nayar.albedo", None),
            Self::BlinnPhong => {
                ("sum[0].brdf.lambert.albedo", Some("sum[1].brdf.blinn_phong.specular"))
            }
            Self::Beckmann | Self::Ggx => {
                ("sum[0].brdf.lambert.albedo", Some("sum[1].brdf.cook_torrance.fresnel.schlick.f0"))
            }
        }
    }

    fn described(self, shape: f64) -> Value {
        let glossy = |gloss: Value| {
            let base = json!({"lambert": {"albedo": [0.1, 0.1, 0.1]}});
            json!({"sum": [{"weight": 1, "brdf": base}, {"weight": 1, "brdf": gloss}]})
        };
        let facets = |distribution: &str| {
            glossy(json!({"cook_torrance": {
                "distribution": {distribution: {"roughness": shape}},
                "fresnel": {"schlick": {"f0": [0.1, 0.1, 0.1]}},
            }}))
        };
        match self {
            Self::Lambert => json!({"lambert": {"albedo": [0.5, 0.5, 0.5]}}),
            Self::OrenNayar => json!({"oren_nayar": {"albedo": [0.5, 0.5, 0.5], "sigma": shape}}),
            Self::BlinnPhong => {
                glossy(json!({"blinn_phong": {"specular": [0.1, 0.1, 0.1], "exponent": shape}}))
            }
            Self::Beckmann => facets("beckmann"),
            Self::Ggx => facets("ggx"),
        }
    }

    /// Where the solver starts.
    pub fn starts(self) -> Vec<BrdfDescription> {
        let shapes = self.shape().map_or(&[0.0][..], |shape| shape.starts);
        let start = |shape: &f64| {
            serde_json::from_value(self.described(*shape)).expect("a description of a start")
        };
        shapes.iter().map(start).collect()
    }

    /// The fit that starts from a description.
    pub fn fit(self, start: &BrdfDescription) -> Fit<'_, BrdfDescription> {
        let (diffuse, specular) = self.colors();
        let mut fit = Fit::of(start).by(Metric::CubeRoot).free(diffuse);
        if let Some(specular) = specular {
            fit = fit.free_within(specular, 0.0..=1.0);
        }
        match self.shape() {
            Some(Shape { path, lower, upper, .. }) => fit.free_within(path, lower..=upper),
            None => fit,
        }
    }
}
