//! The table of a model's parameters: what its type, constructors and descriptions follow from.

mod model;

use crate::error::{Range, range};
pub(crate) use model::model;

/// A parameter of a model, as the table of the model has it.
///
/// ```
/// use brdf::OrenNayar;
/// use brdf::parameter::Kind;
///
/// let sigma = &<OrenNayar>::PARAMETERS[1];
/// assert_eq!((sigma.name, sigma.symbol), ("sigma", "σ"));
/// assert!(matches!(sigma.kind, Kind::Number(range) if range.lower == 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Parameter {
    /// The name of the argument of constructors and of the key of descriptions.
    pub name: &'static str,
    /// The symbol in the formula, which may be empty.
    pub symbol: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// What values it has.
    pub kind: Kind,
    /// The value in a description without the key. Without a default the key must be there.
    pub default: Option<Preset>,
}

/// The values that a parameter may have.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Kind {
    /// A number.
    Number(Range),
    /// A number for all channels, or one for each.
    Color(Range),
    /// The three components of a vector.
    Vector(Range),
    /// A number for all directions, or one along the tangent and one along the bitangent.
    Roughness(Range),
    /// A refractive index: the real part, or the real and the imaginary part.
    Index(Range, Range),
    /// The refractive index of a medium: a real number, a real and an imaginary part, those of each
    /// channel, or that of a measured material or of samples.
    Medium(Range, Range),
    /// The index of a transparent medium: a number, or a list of so many if that is above 1, or that of a
    /// measured material or of samples.
    RealIndex(Range, usize),
    /// The same, relative to what is around it: a material and samples may have an index outside.
    RelativeIndex(Range, usize),
    /// The name of a measured metal, or an object with a material or samples and the index outside.
    Metal,
    /// A list of samples of the optical constants, each a wavelength in nanometres, n and k.
    Samples,
    /// A list of objects, each with a key for each parameter.
    List(&'static [Parameter]),
    /// True or false.
    Flag,
    /// One of a few words.
    Word(&'static [&'static str]),
    /// Any text.
    Text,
    /// A model, Fresnel term or distribution.
    Part(Part),
}

/// What a model consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Part {
    /// A model of reflection.
    Brdf,
    /// A model over the whole sphere of directions.
    Bsdf,
    /// A Fresnel term.
    Fresnel,
    /// A distribution of facet normals.
    Distribution,
}

/// The value of a parameter that is not given.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Preset {
    /// Of a number, or of all numbers of a colour, roughness or index.
    Number(f64),
    /// Of a colour, channel by channel.
    Color([f64; 3]),
    /// Of a flag.
    Flag(bool),
    /// Of a word.
    Word(&'static str),
    /// Of a Fresnel term: the `constant` 1.
    White,
    /// Of a shadowing: `smith` for a distribution for which Smith's term is known, `v_cavity` for
    /// any other.
    Shadowing,
}

impl Parameter {
    pub(crate) const fn new(
        name: &'static str,
        symbol: &'static str,
        meaning: &'static str,
        kind: Kind,
    ) -> Self {
        Self { name, symbol, meaning, kind, default: None }
    }

    /// This parameter with a value that it has where it is not given.
    pub(crate) const fn or(self, default: Preset) -> Self {
        Self { default: Some(default), ..self }
    }

    /// This parameter of another kind.
    #[cfg(feature = "serde")]
    pub(crate) const fn of(self, kind: Kind) -> Self {
        Self { kind, ..self }
    }
}

impl Kind {
    /// How many numbers the value has at most: 0 if it has none.
    #[must_use]
    pub const fn most(self) -> usize {
        match self {
            Self::Number(_) => 1,
            Self::Roughness(_) | Self::Index(..) | Self::Medium(..) => 2,
            Self::Color(_) | Self::Vector(_) | Self::Samples => 3,
            Self::RealIndex(_, most) | Self::RelativeIndex(_, most) => most,
            Self::List(_)
            | Self::Flag
            | Self::Word(_)
            | Self::Text
            | Self::Metal
            | Self::Part(_) => 0,
        }
    }

    /// The range of one of the numbers.
    #[must_use]
    pub const fn range(self, index: usize) -> Option<Range> {
        match self {
            Self::Index(_, k) | Self::Medium(_, k) if index == 1 => Some(k),
            Self::Samples => match index {
                0 => Some(range::WAVELENGTH),
                1 => Some(range::ETA),
                2 => Some(range::K),
                _ => None,
            },
            Self::Number(range)
            | Self::Color(range)
            | Self::Vector(range)
            | Self::Roughness(range)
            | Self::Index(range, _)
            | Self::Medium(range, _)
            | Self::RealIndex(range, _)
            | Self::RelativeIndex(range, _)
                if index < self.most() =>
            {
                Some(range)
            }
            _ => None,
        }
    }
}
