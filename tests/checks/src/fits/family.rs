//! The families of models that are fitted, and their parameters.

use brdf::{
    Beckmann, BlinnPhong, Brdf, CookTorrance, Ggx, Lambert, OrenNayar, ParameterError, Schlick,
    SmithCorrelated, WeightedSum,
};
use glam::DVec3;

pub type Model = Box<dyn Brdf<f64, Color = DVec3>>;

/// Bounds of a parameter, and how the solver moves between them.
#[derive(Clone, Copy)]
pub struct Parameter {
    pub name: &'static str,
    pub lower: f64,
    pub upper: f64,
    /// Whether equal steps are equal ratios.
    pub ratios: bool,
}

impl Parameter {
    const fn color(name: &'static str) -> Self {
        Self { name, lower: 0.0, upper: 1.0, ratios: false }
    }

    /// The parameter for a number without bounds.
    pub fn bounded(&self, free: f64) -> f64 {
        let part = 1.0 / (1.0 + (-free).exp());
        if self.ratios {
            self.lower * (self.upper / self.lower).powf(part)
        } else {
            self.lower + (self.upper - self.lower) * part
        }
    }

    /// The number without bounds for a parameter between its bounds.
    pub fn free(&self, bounded: f64) -> f64 {
        let part = if self.ratios {
            (bounded / self.lower).ln() / (self.upper / self.lower).ln()
        } else {
            (bounded - self.lower) / (self.upper - self.lower)
        };
        (part / (1.0 - part)).ln()
    }
}

const DIFFUSE: [Parameter; 3] =
    [Parameter::color("diffuse R"), Parameter::color("diffuse G"), Parameter::color("diffuse B")];
const SIGMA: Parameter =
    Parameter { name: "σ", lower: 0.0, upper: std::f64::consts::FRAC_PI_2, ratios: false };
const EXPONENT: Parameter = Parameter { name: "exponent", lower: 1.0, upper: 1e5, ratios: true };
const ROUGHNESS: Parameter = Parameter { name: "roughness", lower: 1e-3, upper: 2.0, ratios: true };

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

    /// The diffuse colour, the specular colour, the shape of the lobe: what there is of them.
    pub fn parameters(self) -> Vec<Parameter> {
        let specular = |names: [&'static str; 3]| names.map(Parameter::color);
        let mut parameters = DIFFUSE.to_vec();
        match self {
            Self::Lambert => {}
            Self::OrenNayar => parameters.push(SIGMA),
            Self::BlinnPhong => {
                parameters.extend(specular(["specular R", "specular G", "specular B"]));
                parameters.push(EXPONENT);
            }
            Self::Beckmann | Self::Ggx => {
                parameters.extend(specular(["F₀ R", "F₀ G", "F₀ B"]));
                parameters.push(ROUGHNESS);
            }
        }
        parameters
    }

    /// Where the solver starts; the best end counts.
    pub fn starts(self) -> Vec<Vec<f64>> {
        let glossy = |shapes: [f64; 4]| {
            shapes.map(|shape| vec![0.1, 0.1, 0.1, 0.1, 0.1, 0.1, shape]).to_vec()
        };
        match self {
            Self::Lambert => vec![vec![0.5; 3]],
            Self::OrenNayar => [0.1, 0.5].map(|sigma| vec![0.5, 0.5, 0.5, sigma]).to_vec(),
            Self::BlinnPhong => glossy([20.0, 300.0, 5e3, 8e4]),
            Self::Beckmann | Self::Ggx => glossy([0.005, 0.02, 0.08, 0.32]),
        }
    }

    /// The model with these parameters.
    pub fn model(self, values: &[f64]) -> Result<Model, ParameterError> {
        let diffuse = DVec3::from_slice(values);
        let glossy = |gloss: Model| -> Result<Model, ParameterError> {
            let base: Model = Box::new(Lambert::new(diffuse)?);
            Ok(Box::new(WeightedSum::new([(DVec3::ONE, base), (DVec3::ONE, gloss)])?))
        };
        let (specular, shape) = (&values[3..], values[values.len() - 1]);
        Ok(match self {
            Self::Lambert => Box::new(Lambert::new(diffuse)?),
            Self::OrenNayar => Box::new(OrenNayar::new(diffuse, shape)?),
            Self::BlinnPhong => {
                glossy(Box::new(BlinnPhong::new(DVec3::from_slice(specular), shape)?))?
            }
            Self::Beckmann => {
                let fresnel = Schlick::new(DVec3::from_slice(specular))?;
                let facets = CookTorrance::new(Beckmann::new(shape)?, fresnel);
                glossy(Box::new(facets.with_shadowing(SmithCorrelated)))?
            }
            Self::Ggx => {
                let fresnel = Schlick::new(DVec3::from_slice(specular))?;
                let facets = CookTorrance::new(Ggx::new(shape)?, fresnel);
                glossy(Box::new(facets.with_shadowing(SmithCorrelated)))?
            }
        })
    }
}
