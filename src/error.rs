//! The one error of the crate: a parameter outside its range.

use core::error::Error;
use core::fmt;

use crate::real::{Color, Real};

/// A parameter that a constructor did not accept.
///
/// ```
/// use brdf::{Beckmann, ParameterError};
///
/// let error = Beckmann::new(-0.1_f64).unwrap_err();
/// assert_eq!(error.parameter(), "roughness");
/// assert_eq!(error.value(), -0.1);
/// assert_eq!(error.to_string(), "roughness must be between 1e-8 and 10000, not -0.1");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ParameterError {
    parameter: &'static str,
    value: f64,
    lower: f64,
    upper: f64,
    position: Option<usize>,
    previous: Option<f64>,
}

impl ParameterError {
    /// Checks a list whose numbers lie in a range and each above the one before it.
    pub(crate) fn check_ascending(
        parameter: &'static str,
        range: Range,
        list: &[f64],
    ) -> Result<(), Self> {
        Self::check_each(parameter, range, list)?;
        for (before, pair) in list.windows(2).enumerate() {
            if let [previous, value] = *pair {
                let above = previous.next_up();
                Range { lower: above, upper: range.upper.max(above) }
                    .check(parameter, value)
                    .map_err(|error| Self { previous: Some(previous), ..error.at(before + 1) })?;
            }
        }
        Ok(())
    }

    /// Checks a list whose numbers lie in a range.
    pub(crate) fn check_each(
        parameter: &'static str,
        range: Range,
        list: &[f64],
    ) -> Result<(), Self> {
        list.iter().enumerate().try_for_each(|(position, value)| {
            range.check(parameter, *value).map_err(|error: Self| error.at(position))
        })
    }

    /// The same error of a value that stands at a place of a list.
    pub(crate) const fn at(self, position: usize) -> Self {
        Self { position: Some(position), ..self }
    }

    /// The name of the parameter.
    #[must_use]
    pub const fn parameter(&self) -> &'static str {
        self.parameter
    }

    /// The value that was given.
    #[must_use]
    pub const fn value(&self) -> f64 {
        self.value
    }

    /// The smallest and the largest allowed value, both included. Infinity is no upper end.
    #[must_use]
    pub const fn range(&self) -> (f64, f64) {
        (self.lower, self.upper)
    }

    /// Where in the list the value stands, counted from 0, if the parameter is a list.
    #[must_use]
    pub const fn position(&self) -> Option<usize> {
        self.position
    }

    /// What is allowed and was not given, as in `must be between 0 and 1, not 2`.
    pub(crate) const fn rule(&self) -> impl fmt::Display {
        Rule(*self)
    }
}

struct Rule(ParameterError);

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ParameterError { value, lower, upper, previous, .. } = self.0;
        let [value, lower, upper] = [value, lower, upper].map(Number);
        match previous {
            Some(previous) => write!(f, "must be above {}, the one before it", Number(previous)),
            None if upper.0 == f64::INFINITY => write!(f, "must be at least {lower}"),
            None => write!(f, "must be between {lower} and {upper}"),
        }?;
        write!(f, ", not {value}")
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.parameter)?;
        if let Some(position) = self.position {
            write!(f, "[{position}]")?;
        }
        write!(f, " {}", self.rule())
    }
}

/// A number with an exponent where it would have many zeros without.
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let magnitude = self.0.abs();
        if magnitude == 0.0 || (1e-4..1e6).contains(&magnitude) || !magnitude.is_finite() {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

impl Error for ParameterError {}

/// What a parameter may be, both ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The smallest allowed value.
    pub lower: f64,
    /// The largest allowed value.
    pub upper: f64,
}

impl Range {
    pub(crate) const fn new(lower: f64, upper: f64) -> Self {
        Self { lower, upper }
    }

    /// What is said of a value that does not lie in the range.
    pub(crate) const fn refusal(self, parameter: &'static str, value: f64) -> ParameterError {
        let Self { lower, upper } = self;
        ParameterError { parameter, value, lower, upper, position: None, previous: None }
    }

    /// Checks a number, or every channel of a colour.
    #[inline]
    pub(crate) fn check<T: Real, C: Color<T>>(
        self,
        parameter: &'static str,
        value: C,
    ) -> Result<(), ParameterError> {
        match value.outside(self.lower, self.upper) {
            None => Ok(()),
            Some(value) => Err(self.refusal(parameter, value)),
        }
    }
}

/// Declares the ranges of parameters, and how documentation shows them.
macro_rules! ranges {
    ($($(#[$doc:meta])+ $name:ident = $lower:expr, $upper:expr, $shown:literal;)+) => {
        /// Ranges of parameters.
        ///
        /// The ends are where the squares and fourth powers in the formulas still fit an `f32`.
        pub(crate) mod range {
            use super::Range;

            $($(#[$doc])+ pub(crate) const $name: Range = Range::new($lower, $upper);)+
        }

        macro_rules! shown {
            $(($name) => { $shown };)+
        }
        pub(crate) use shown;
    };
}

ranges! {
    /// Albedo, reflectance.
    UNIT = 0.0, 1.0, "0 … 1";
    /// Roughness: the root-mean-square slope or its like.
    ROUGHNESS = 1e-8, 1e4, "10⁻⁸ … 10⁴";
    /// Standard deviation of the tilt of facets, radians.
    SIGMA = 0.0, core::f64::consts::FRAC_PI_2, "0 … π/2";
    /// Weight of a term of a sum.
    WEIGHT = 0.0, 1e10, "0 … 10¹⁰";
    /// Sum of the weights, averaged over the channels: what probabilities are made from.
    TOTAL_WEIGHT = 1e-30, 1e30, "10⁻³⁰ … 10³⁰";
    /// Colour of a light: its products with a reflectance stay far from overflow.
    LIGHT = 0.0, 1e10, "0 … 10¹⁰";
    /// Exponent of a power of a cosine.
    EXPONENT = 0.0, 1e8, "0 … 10⁸";
    /// Real part of a refractive index.
    ETA = 1e-4, 1e4, "10⁻⁴ … 10⁴";
    /// Index of a medium that is not rarer than the one around it.
    DENSER = 1.0, 1e4, "1 … 10⁴";
    /// Imaginary part of a refractive index.
    K = 0.0, 1e4, "0 … 10⁴";
    /// Exponent of the approach to the edge of a Fresnel term.
    EDGE_EXPONENT = 1e-2, 1e4, "10⁻² … 10⁴";
    /// Limb darkening of a planet's disc.
    LIMB_DARKENING = 0.5, 1e8, "½ … 10⁸";
    /// Asymmetry of a phase function.
    PHASE = -0.999999, 0.999999, "−0.999999 … 0.999999";
    /// Angle at which the distributions of 1977 have fallen to one half, radians.
    HALF_WIDTH = 2e-4, 1.57, "2·10⁻⁴ … 1.57";
    /// Sharpness of the distribution of 1967, 1/degree.
    SHARPNESS_1967 = 1e-5, 1e5, "10⁻⁵ … 10⁵";
    /// Thickness of a layer, nm.
    THICKNESS = 0.0, 1e9, "0 … 10⁹";
    /// Root-mean-square height of a surface, nm.
    HEIGHT = 0.0, 1e9, "0 … 10⁹";
    /// Correlation length of the heights of a surface, nm.
    CORRELATION = 1e-3, 1e9, "10⁻³ … 10⁹";
    /// Uniform diffuse part of a value, sr⁻¹.
    UNIFORM = 0.0, 1e10, "0 … 10¹⁰";
    /// Wavelength in vacuum, nm.
    WAVELENGTH = 1.0, 1e9, "1 … 10⁹";
}
