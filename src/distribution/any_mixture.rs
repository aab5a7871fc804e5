use alloc::vec::Vec;

use super::any::{AnyDistribution, each_smith};
use super::mixture::{Choice, Visible, weights};
use super::traits::{Distribution, Smith};
use crate::error::ParameterError;
use crate::real::{Lift, Real};

/// A weighted mean of any number of distributions of any kinds: [`Mixture`](crate::Mixture) at run
/// time.
///
/// ```text
/// D = Σ wᵢ Dᵢ,  Σ wᵢ = 1
/// ```
///
/// A mixture in a mixture is taken apart into its terms. Smith's shadowing is known if it is for
/// all terms.
///
/// ```
/// use brdf::{AnyMixture, Beckmann, Distribution, Gaussian};
/// use glam::DVec3;
///
/// let rough = AnyMixture::new([
///     (0.4, Beckmann::new(0.2_f64)?.into()),
///     (0.6, Gaussian::new(0.5)?.into()),
/// ])?;
/// assert!((rough.density(DVec3::Z) - 4.0830472717).abs() < 1e-10);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AnyMixture<T: Real = f32> {
    terms: Vec<(T, AnyDistribution<T>)>,
}

impl<T: Real> AnyMixture<T> {
    /// A mixture of distributions with their weights, which are divided by their sum.
    ///
    /// # Errors
    /// If a weight is not in 0 … 10¹⁰ or the sum of the weights is not in 10⁻³⁰ … 10³⁰.
    pub fn new(
        terms: impl IntoIterator<Item = (T, AnyDistribution<T>)>,
    ) -> Result<Self, ParameterError> {
        let given: Vec<_> = terms.into_iter().collect();
        let total = weights(given.iter().map(|(weight, _)| *weight))?;
        let mut terms = Vec::new();
        for (weight, distribution) in given {
            let weight = weight / total;
            match distribution {
                AnyDistribution::Mixture(Self { terms: inner }) => {
                    terms.extend(inner.into_iter().map(|(part, each)| (weight * part, each)));
                }
                distribution => terms.push((weight, distribution)),
            }
        }
        Ok(Self { terms })
    }

    /// The weights, whose sum is 1, and the distributions.
    #[must_use]
    pub fn terms(&self) -> &[(T, AnyDistribution<T>)] {
        &self.terms
    }

    /// The mixture as one with Smith's shadowing, if that is known for all terms.
    pub(crate) fn as_smith(&self) -> Option<SmithMixture<'_, T>> {
        let known = self.terms.iter().all(|(_, distribution)| distribution.has_smith());
        known.then_some(SmithMixture(self))
    }

    /// Σ wᵢ `term`(Dᵢ).
    #[inline(always)]
    fn sum(&self, term: impl Fn(&AnyDistribution<T>) -> T) -> T {
        self.terms.iter().fold(T::zero(), |sum, (weight, each)| sum + *weight * term(each))
    }
}

impl<T: Real> Lift<T> for AnyMixture<T> {
    type Over<U: Real> = AnyMixture<U>;

    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> AnyMixture<U> {
        let terms = self.terms.iter().map(|(weight, each)| (lift(*weight), each.lift(lift)));
        AnyMixture { terms: terms.collect() }
    }
}

// Calls and no code in place: the terms of a mixture are of the type that contains it.
impl<T: Real> Distribution<T> for AnyMixture<T> {
    #[inline(never)]
    fn density(&self, h: T::Vec3) -> T {
        self.sum(|each| each.density(h)).min(T::max_finite())
    }

    #[inline(never)]
    fn density_along(&self, m: T::Vec3) -> T {
        self.sum(|each| each.density_along(m)).min(T::max_finite())
    }

    #[inline(never)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let mut choice = Choice::new(u);
        for (weight, each) in &self.terms {
            choice.offer(*weight, |u| each.sample(u));
        }
        choice.chosen()
    }
}

/// A mixture of distributions for which Smith's shadowing is known.
#[derive(Clone, Copy)]
pub(crate) struct SmithMixture<'a, T: Real>(&'a AnyMixture<T>);

impl<T: Real> Distribution<T> for SmithMixture<'_, T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        self.0.density(h)
    }

    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        self.0.density_along(m)
    }

    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        self.0.sample(u)
    }
}

impl<T: Real> Smith<T> for SmithMixture<'_, T> {
    #[inline(never)]
    fn lambda_cos(&self, w: T::Vec3) -> T {
        let term =
            |each: &AnyDistribution<T>| each_smith!(each, one => one.lambda_cos(w), T::zero());
        self.0.sum(term).min(T::max_finite())
    }

    #[inline(never)]
    fn projected_area(&self, w: T::Vec3) -> T {
        let term =
            |each: &AnyDistribution<T>| each_smith!(each, one => one.projected_area(w), T::zero());
        self.0.sum(term).min(T::max_finite())
    }

    #[inline(never)]
    fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let (visible, mut choice) = (Visible::new(wo, self.lambda_cos(wo)), Choice::new(u));
        for (weight, each) in &self.0.terms {
            each_smith!(each, one => visible.offer(&mut choice, *weight, one), ());
        }
        choice.chosen()
    }
}
