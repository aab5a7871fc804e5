use alloc::vec::Vec;

use super::beckmann::Beckmann;
use super::blinn::Blinn;
use super::gaussian::Gaussian;
use super::ggx::Ggx;
use super::gtr::Gtr;
use super::mixture::{Mixture, weights};
use super::spread::Spreads;
use super::student_t::StudentT;
use super::traits::Distribution;
use crate::block::{DirectionBlock, Plane, UniformBlock};
use crate::error::ParameterError;
use crate::real::{Lift, Real, members};

members! {
    ($) each_distribution
    /// Any distribution of this crate, chosen at run time.
    ///
    /// One type for all of them, without a box. A call costs one `match`, a
    /// [batch](crate::batch) one for each block, and the answers have the bits of the distribution
    /// inside.
    ///
    /// ```
    /// use brdf::{AnyDistribution, Beckmann, Distribution, Ggx};
    /// use glam::Vec3;
    ///
    /// let scene: [AnyDistribution; 2] = [Ggx::new(0.3)?.into(), Beckmann::new(0.2)?.into()];
    /// assert_eq!(scene[0].density(Vec3::Z), Ggx::new(0.3)?.density(Vec3::Z));
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub enum AnyDistribution[T: Real = f32][T: Real] AnyDistribution<T> => AnyDistribution<U> {
        /// Torrance and Sparrow's distribution of the angle.
        Gaussian(Gaussian<T>),
        /// Beckmann's distribution.
        Beckmann(Beckmann<T>),
        /// The distribution of Trowbridge and Reitz.
        Ggx(Ggx<T>),
        /// Blinn's power of the cosine.
        Blinn(Blinn<T>),
        /// The generalised distribution of Trowbridge and Reitz.
        Gtr(Gtr<T>),
        /// Slopes of Student's t-distribution.
        StudentT(StudentT<T>),
        /// A weighted mean of the others.
        Mixture(AnyMixture<T>),
    }
}

/// The same expression for every single distribution for which Smith's shadowing is known, another
/// one for the others and for mixtures.
macro_rules! each_single_smith {
    ($any:expr, $one:ident => $known:expr, $unknown:expr) => {
        match $any {
            $crate::distribution::AnyDistribution::Beckmann($one) => $known,
            $crate::distribution::AnyDistribution::Ggx($one) => $known,
            _ => $unknown,
        }
    };
}

/// The same expression for every distribution for which Smith's shadowing is known, mixtures
/// included, another one for the others.
macro_rules! each_smith {
    ($any:expr, $one:ident => $known:expr, $unknown:expr) => {
        match $any {
            $crate::distribution::AnyDistribution::Mixture(mixture) => match mixture.as_smith() {
                Some(mixture) => {
                    let $one = &mixture;
                    $known
                }
                None => $unknown,
            },
            single => $crate::distribution::each_single_smith!(single, $one => $known, $unknown),
        }
    };
}
pub(crate) use {each_distribution, each_single_smith, each_smith};

impl<T: Real> AnyDistribution<T> {
    /// Whether Smith's shadowing is known for this distribution, so that it can be asked for by
    /// [`AnyShadowing`](crate::AnyShadowing).
    #[must_use]
    pub fn has_smith(&self) -> bool {
        each_smith!(self, _one => true, false)
    }
}

impl<T: Real> Distribution<T> for AnyDistribution<T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        each_distribution!(self, distribution => distribution.density(h))
    }

    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        each_distribution!(self, distribution => distribution.density_along(m))
    }

    #[inline]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        each_distribution!(self, distribution => distribution.sample(u))
    }

    #[inline(always)]
    fn sample_along(&self, u: [T; 2]) -> T::Vec3 {
        each_distribution!(self, distribution => distribution.sample_along(u))
    }

    fn spreads(&self) -> Option<Spreads<T>> {
        each_distribution!(self, distribution => distribution.spreads())
    }

    fn density_block(&self, h: DirectionBlock<'_, T>, densities: &mut Plane<T>) {
        each_distribution!(self, distribution => distribution.density_block(h, densities));
    }

    fn density_along_block(&self, m: DirectionBlock<'_, T>, densities: &mut Plane<T>) {
        each_distribution!(self, distribution => distribution.density_along_block(m, densities));
    }

    fn sample_block(&self, uniforms: UniformBlock<'_, T>, h: &mut [Plane<T>; 4]) {
        each_distribution!(self, distribution => distribution.sample_block(uniforms, h));
    }

    fn sample_along_block(&self, uniforms: UniformBlock<'_, T>, h: &mut [Plane<T>; 4]) {
        each_distribution!(self, distribution => distribution.sample_along_block(uniforms, h));
    }
}

/// A weighted mean of any number of distributions of any kinds: [`Mixture`](crate::Mixture) at run
/// time.
///
/// # Formula
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
/// assert!((rough.density(DVec3::Z) - 4.0830472729).abs() < 1e-10);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AnyMixture<T: Real = f32> {
    pub(super) terms: Vec<(T, AnyDistribution<T>)>,
    /// Whether Smith's shadowing is known for all terms.
    pub(super) has_smith: bool,
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
        Ok(Self::of(given.into_iter().map(|(weight, each)| (weight / total, each))))
    }

    /// Of weights whose sum is 1.
    fn of(given: impl Iterator<Item = (T, AnyDistribution<T>)>) -> Self {
        let mut terms = Vec::new();
        for (weight, distribution) in given {
            match distribution {
                AnyDistribution::Mixture(Self { terms: inner, .. }) => {
                    terms.extend(inner.into_iter().map(|(part, each)| (weight * part, each)));
                }
                distribution => terms.push((weight, distribution)),
            }
        }
        let has_smith = terms.iter().all(|(_, distribution)| distribution.has_smith());
        Self { terms, has_smith }
    }

    /// The weights, whose sum is 1, and the distributions.
    #[must_use]
    pub fn terms(&self) -> &[(T, AnyDistribution<T>)] {
        &self.terms
    }
}

impl<T: Real> Lift<T> for AnyMixture<T> {
    type Over<U: Real> = AnyMixture<U>;

    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> AnyMixture<U> {
        let terms = self.terms.iter().map(|(weight, each)| (lift(*weight), each.lift(lift)));
        AnyMixture { terms: terms.collect(), has_smith: self.has_smith }
    }
}

impl<T: Real, D: Into<Self>, const N: usize> From<Mixture<T, D, N>> for AnyDistribution<T> {
    fn from(mixture: Mixture<T, D, N>) -> Self {
        let (weights, distributions) = mixture.into_parts();
        let terms = weights.into_iter().zip(distributions);
        AnyMixture::of(terms.map(|(weight, each)| (weight, each.into()))).into()
    }
}
