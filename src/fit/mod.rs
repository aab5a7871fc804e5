//! Descriptions fitted to measured values (feature `fit`).
//!
//! Any number of any description can be free. The best values are those of least squares, by the
//! method of Levenberg and Marquardt with exact [derivatives](crate::Dual) within the ranges of the
//! parameters, and come with their standard errors.
//!
//! The n and k of a metal from its reflectance over the angle:
//!
//! ```
//! use brdf::description::FresnelDescription;
//! use brdf::fit::{Fit, MeasuredReflectance};
//!
//! // Copper at 550 nm, rounded to three digits.
//! let measured = [(0.0, 0.634), (30.0, 0.634), (50.0, 0.633), (60.0, 0.636), (70.0, 0.656), (80.0, 0.739)]
//!     .map(|(angle, reflectance): (f64, f64)| {
//!         MeasuredReflectance::new(angle.to_radians().cos(), reflectance)
//!     });
//! let metal: FresnelDescription = serde_json::from_str(r#"{"conductor": {"eta": 1, "k": 3}}"#)?;
//! let copper = Fit::of(&metal).free("conductor.eta").free("conductor.k").to(&measured)?;
//! let [eta, k] = copper.parameters() else { panic!() };
//! let off = |found: f64, true_value: f64, error: Option<f64>| {
//!     (found - true_value).abs() / error.unwrap_or(f64::MAX)
//! };
//! assert!(off(eta.value, 0.958, eta.standard_error) < 3.0);
//! assert!(off(k.value, 2.577, k.standard_error) < 3.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What a fit can tell
//! The numbers that the measured values depend on, each in its own way. The standard error is `None`
//! where they do not: where a number has no influence, where it is at a bound, and where several
//! numbers act as one.
//!
//! - The weight of a term and the colour of its model are one factor: free one of both. If both are free
//!   their product is found, and neither has a standard error.
//! - Only the ratios of the weights of a mixture of distributions count. If all are free their ratios are
//!   found, none has a standard error, and their sum is what the solver came by.
//! - Two terms that begin alike are told apart by rounding alone: give them different starts.
//! - The reflectance of a metal at one angle is one equation for n and k. Over the angle it tells both, the
//!   better the closer it comes to the minimum of R_p, about 70° to 80°; near normal incidence alone it
//!   tells only their combination.
//! - The reflectance at normal incidence (`f0`, `ior`) and the roughness of facets share the height of
//!   the peak: what tells them apart is its width, so measure the flank. A lobe narrower than the steps
//!   between the directions has no width, and the roughness means little.
//! - σ of Oren and Nayar shows in the retro-reflection at grazing light, and is next to nothing
//!   elsewhere; the fourth digit of σ below 0.1 is noise.
//! - Colours of a diffuse and of a wide glossy term are told apart by what happens towards grazing.
//!
//! # Where a fit ends
//! At a minimum near its start, which is the description: start from several and keep the one of the
//! smallest [`residual`](Fitted::residual). A start at a bound is as good as any other.
//!
//! Within the bounds the derivatives of the residual are zero; at a bound they point out of it, or the
//! residual is no smaller at any of nine places from 10⁻⁹ to 10⁻¹ of the way to the other bound, by which
//! a number is found that has no slope where it stands, as σ = 0. Where the search ends elsewhere,
//! [`is_minimum`](Fitted::is_minimum) says so. Numbers that no constructor accepts together are no
//! improvement to the solver, which stops before them: a sum with one weight, fitted to black, ends with
//! a weight next to zero.
//!
//! # What is compared
//! Both directions of a measurement must be [directions](crate::check_direction) above the surface: a BRDF
//! has no value elsewhere, and what was measured there tells nothing about any number. Cosines lie in
//! 0 … 1, values in −10¹⁰⁰ … 10¹⁰⁰, weights in 0 … 10¹⁰⁰. Anything else is an error that names the
//! measurement. A channel of weight 0 is not looked at.

mod counting;
mod error;
mod face;
mod fitted;
mod free;
mod measured;
mod problem;
mod solve;

use counting::Counting;
pub use error::{FitError, Unfit};
pub use fitted::{Fitted, FittedParameter};
use free::Free;
pub use measured::{Fittable, Measured, MeasuredReflectance, Metric};
use problem::Problem;

use crate::description::Number;
use crate::error::Range;

/// What is fitted, and which of its numbers are free.
///
/// ```
/// use brdf::Brdf;
/// use brdf::description::BrdfDescription;
/// use brdf::fit::{Fit, Measured, Metric};
/// use glam::DVec3;
///
/// let described = |text| serde_json::from_str::<BrdfDescription>(text);
/// let clay = described(r#"{"oren_nayar": {"albedo": [0.7, 0.4, 0.3], "sigma": 0.4}}"#)?;
/// let model = clay.build::<f64>()?;
/// let measured: Vec<Measured> = (1..80)
///     .map(|angle| {
///         let (sin, cos) = f64::from(angle).to_radians().sin_cos();
///         let (wi, wo) = (DVec3::new(sin, 0.0, cos), DVec3::new(0.6, 0.0, 0.8));
///         Measured::new(wi, wo, model.eval(wi, wo))
///     })
///     .collect();
///
/// let start = described(r#"{"oren_nayar": {"albedo": [0.5, 0.5, 0.5], "sigma": 0.1}}"#)?;
/// let fitted = Fit::of(&start)
///     .free("oren_nayar.albedo")
///     .free_within("oren_nayar.sigma", 0.0..=1.5)
///     .by(Metric::CubeRoot)
///     .to(&measured)?;
/// assert!((fitted.parameters()[3].value - 0.4).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Fit<'a, D> {
    description: &'a D,
    numbers: Vec<Number>,
    free: Vec<Free>,
    metric: Metric,
    failure: Option<FitError>,
}

impl<'a, D: Fittable> Fit<'a, D> {
    /// Starts from a description.
    #[must_use]
    pub fn of(description: &'a D) -> Self {
        Self {
            description,
            numbers: description.all_numbers(),
            free: Vec::new(),
            metric: Metric::default(),
            failure: None,
        }
    }

    /// Frees the number at a place, or all numbers of the colour, part or list there, within the
    /// ranges of their parameters.
    #[must_use]
    pub fn free(self, path: &str) -> Self {
        self.freed(path, None)
    }

    /// The same within bounds of one's own.
    #[must_use]
    pub fn free_within(self, path: &str, bounds: core::ops::RangeInclusive<f64>) -> Self {
        self.freed(path, Some(Range { lower: *bounds.start(), upper: *bounds.end() }))
    }

    /// What is compared: the values themselves if nothing is said.
    #[must_use]
    pub fn by(self, metric: Metric) -> Self {
        Self { metric, ..self }
    }

    fn freed(mut self, path: &str, bounds: Option<Range>) -> Self {
        let below = |number: &&Number| {
            let rest = number.path.strip_prefix(path);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        let before = self.free.len();
        for number in self.numbers.iter().filter(below) {
            let Range { lower, upper } = bounds.unwrap_or(number.range);
            let allowed =
                lower < upper && number.range.lower <= lower && upper <= number.range.upper;
            if !allowed {
                self.failure.get_or_insert(FitError::Bounds {
                    path: number.path.clone(),
                    bounds: Range { lower, upper },
                    allowed: number.range,
                });
            }
            self.free.retain(|free| free.path != number.path);
            self.free.push(Free {
                path: number.path.clone(),
                range: Range { lower, upper },
                start: number.value,
            });
        }
        if self.free.len() == before && !self.numbers.iter().any(|number| below(&number)) {
            self.failure.get_or_insert_with(|| FitError::NoSuchNumber(path.to_owned()));
        }
        self
    }

    /// The fit to what was measured.
    ///
    /// # Errors
    /// If a place has no number, if bounds are no range of their parameter, if nothing is free, if a
    /// measurement is out of range, if fewer values count than numbers are free, or if the description
    /// cannot be built with its numbers moved into the bounds.
    pub fn to(&self, measured: &[D::Point]) -> Result<Fitted<D>, FitError> {
        if let Some(failure) = &self.failure {
            return Err(failure.clone());
        }
        let free = self.free.len();
        if free == 0 {
            return Err(FitError::NothingFree);
        }
        let Counting { points, count, unit } = D::counting(measured)?;
        if count < free {
            return Err(FitError::TooFew { measured: count, free });
        }
        let problem = Problem {
            description: self.description,
            points: &points,
            metric: self.metric,
            free: &self.free,
        };
        let size = D::size(&points, self.metric);
        Fitted::of(&problem, problem.minimize(size)?, count, [unit, size])
    }
}
