use super::spread::{Spreads, mixed};
use super::traits::{Distribution, Smith};
use crate::error::{ParameterError, range};
use crate::real::{Lift, Mask, Real, Vector, lift};
use crate::sampling::uniform;

/// A weighted mean of distributions: surfaces with roughness on several scales.
///
/// # Formula
/// ```text
/// D = Σ wᵢ Dᵢ,  Λ = Σ wᵢ Λᵢ,  Σ wᵢ = 1
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | wᵢ | first of each pair | weight, divided by the sum of all | 0 … 10¹⁰, not all 0 |
/// | Dᵢ | second of each pair | distribution | |
///
/// Normalised, because its terms are. Cook and Torrance mix Beckmann distributions in this way.
///
/// # Sampling
/// The facets of kind i that are visible from ω take up the part wᵢ (1 + Λᵢ)/(1 + Λ) of what is
/// visible, and not wᵢ: visible normals are drawn with these probabilities, which is exact.
///
/// # Sources
/// R. L. Cook, K. E. Torrance, "A Reflectance Model for Computer Graphics", ACM TOG 1(1), 1982,
/// [doi:10.1145/357290.357293](https://doi.org/10.1145/357290.357293), section 4.
///
/// ```
/// use brdf::{Beckmann, Distribution, Mixture};
/// use glam::DVec3;
///
/// let mixture = Mixture::new([(0.4, Beckmann::new(0.2_f64)?), (0.6, Beckmann::new(0.5_f64)?)])?;
/// assert!((mixture.density(DVec3::Z) - 3.9470425887).abs() < 1e-10);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mixture<T, D, const N: usize> {
    weights: [T; N],
    distributions: [D; N],
}

impl<T: Real, D, const N: usize> Mixture<T, D, N> {
    /// A mixture of distributions with their weights.
    ///
    /// # Errors
    /// If a weight is not in 0 … 10¹⁰ or the sum of the weights is not in 10⁻³⁰ … 10³⁰.
    pub fn new(components: [(T, D); N]) -> Result<Self, ParameterError> {
        let weights = components.each_ref().map(|(weight, _)| *weight);
        let total = self::weights(weights)?;
        Ok(Self {
            weights: weights.map(|weight| weight / total),
            distributions: components.map(|(_, distribution)| distribution),
        })
    }

    pub(super) fn into_parts(self) -> ([T; N], [D; N]) {
        (self.weights, self.distributions)
    }

    /// The weights, whose sum is 1.
    #[must_use]
    pub fn weights(&self) -> &[T; N] {
        &self.weights
    }

    /// The distributions, in the order of the weights.
    #[must_use]
    pub fn distributions(&self) -> &[D; N] {
        &self.distributions
    }

    /// Σ wᵢ `term`(Dᵢ).
    #[inline(always)]
    fn sum(&self, term: impl Fn(&D) -> T) -> T {
        let mut sum = T::zero();
        for (&weight, distribution) in self.weights.iter().zip(&self.distributions) {
            sum = sum + weight * term(distribution);
        }
        sum
    }
}

/// The sum of the weights of a mixture, if they are in range.
pub(super) fn weights<T: Real>(weights: impl IntoIterator<Item = T>) -> Result<T, ParameterError> {
    let mut total = T::zero();
    for weight in weights {
        range::WEIGHT.check("weight", weight)?;
        total = total + weight;
    }
    range::TOTAL_WEIGHT.check("sum of weights", total)?;
    Ok(total)
}

/// A draw from one of several distributions, offered one after the other with probabilities that
/// add up to 1.
///
/// The first uniform number chooses, and its place within the part of the chosen distribution
/// serves as a fresh uniform number.
pub(crate) struct Choice<T: Real> {
    u: [T; 2],
    /// The sum of the probabilities so far.
    start: T,
    chosen: T::Vec3,
}

impl<T: Real> Choice<T> {
    #[inline(always)]
    pub(crate) fn new(u: [T; 2]) -> Self {
        let zero = T::zero();
        Self { u: uniform(u), start: zero, chosen: Vector::new(zero, zero, T::one()) }
    }

    /// What the next distribution draws from, and where the number reaches it.
    #[inline(always)]
    pub(super) fn reach(&mut self, probability: T) -> ([T; 2], T::Mask) {
        let (place, reached) = reach(self.u[0], self.start, probability);
        self.start = self.start + probability;
        ([place, self.u[1]], reached)
    }

    /// Takes what a distribution draws where the number reaches it. A later distribution replaces
    /// an earlier one, so that rounding of the sum of probabilities leaves no gap at the end.
    #[inline(always)]
    pub(super) fn take(&mut self, reached: T::Mask, drawn: T::Vec3) {
        self.chosen = Vector::select(reached, drawn, self.chosen);
    }

    #[inline(always)]
    pub(crate) fn offer(&mut self, probability: T, draw: impl FnOnce([T; 2]) -> T::Vec3) {
        let (u, reached) = self.reach(probability);
        self.take(reached, draw(u));
    }

    #[inline(always)]
    pub(crate) fn chosen(self) -> T::Vec3 {
        self.chosen
    }
}

/// The place of a number in the part of a distribution that begins at `start`, and where the number
/// lies at or behind the beginning.
#[inline(always)]
pub(super) fn reach<T: Real>(u: T, start: T, probability: T) -> (T, T::Mask) {
    let place = (u - start) / probability.max(T::lit(1e-37));
    (place.clamp(T::zero(), T::one()), u.ge(start).and(probability.gt(T::zero())))
}

/// What the distributions of a mixture have in common where visible normals are drawn.
///
/// 1/G₁ = Σ wᵢ/G₁ᵢ, hence G₁ (wo·h) D/cos = Σ (wᵢ G₁/G₁ᵢ) times the same of component i.
pub(crate) struct Visible<T: Real> {
    cos: T,
    /// cos/G₁ of the mixture.
    all: T,
}

impl<T: Real> Visible<T> {
    /// For a mixture with the given [`Smith::lambda_cos`].
    #[inline(always)]
    pub(crate) fn new(wo: T::Vec3, lambda_cos: T) -> Self {
        let cos = wo.z().max(T::zero());
        Self { cos, all: (cos + lambda_cos).max(T::lit(1e-37)) }
    }

    /// The probability that a visible facet is of a kind with this weight and this
    /// [`Smith::lambda_cos`].
    #[inline(always)]
    pub(crate) fn probability(&self, weight: T, lambda_cos: T) -> T {
        weight * ((self.cos + lambda_cos) / self.all)
    }
}

lift! {
    [T: Real, D: Lift<T>, const N: usize] Mixture<T, D, N> => Mixture<U, D::Over<U>, N>:
    Mixture { weights: numbers, distributions: parts }
}

impl<T: Real, D: Distribution<T>, const N: usize> Distribution<T> for Mixture<T, D, N> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        self.sum(|distribution| distribution.density(h)).min(T::max_finite())
    }

    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        self.sum(|distribution| distribution.density_along(m)).min(T::max_finite())
    }

    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let mut choice = Choice::new(u);
        for (&weight, distribution) in self.weights.iter().zip(&self.distributions) {
            choice.offer(weight, |u| distribution.sample(u));
        }
        choice.chosen()
    }

    #[inline(always)]
    fn sample_along(&self, u: [T; 2]) -> T::Vec3 {
        let mut choice = Choice::new(u);
        for (&weight, distribution) in self.weights.iter().zip(&self.distributions) {
            choice.offer(weight, |u| distribution.sample_along(u));
        }
        choice.chosen()
    }

    fn spreads(&self) -> Option<Spreads<T>> {
        mixed(
            self.weights
                .iter()
                .zip(&self.distributions)
                .map(|(&weight, each)| (weight, each.spreads())),
        )
    }
}

impl<T: Real, D: Smith<T>, const N: usize> Smith<T> for Mixture<T, D, N> {
    #[inline(always)]
    fn lambda_cos(&self, w: T::Vec3) -> T {
        self.sum(|distribution| distribution.lambda_cos(w)).min(T::max_finite())
    }

    #[inline(always)]
    fn projected_area(&self, w: T::Vec3) -> T {
        self.sum(|distribution| distribution.projected_area(w)).min(T::max_finite())
    }

    #[inline(always)]
    fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        self.choose_visible(wo, u, |distribution, u| distribution.sample_visible(wo, u))
    }

    #[inline(always)]
    fn sample_visible_along(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        self.choose_visible(wo, u, |distribution, u| distribution.sample_visible_along(wo, u))
    }
}

impl<T: Real, D: Smith<T>, const N: usize> Mixture<T, D, N> {
    /// What one of the distributions draws, chosen as the viewer sees them.
    #[inline(always)]
    fn choose_visible(
        &self,
        wo: T::Vec3,
        u: [T; 2],
        draw: impl Fn(&D, [T; 2]) -> T::Vec3,
    ) -> T::Vec3 {
        let (visible, mut choice) = (Visible::new(wo, self.lambda_cos(wo)), Choice::new(u));
        for (&weight, distribution) in self.weights.iter().zip(&self.distributions) {
            let probability = visible.probability(weight, distribution.lambda_cos(wo));
            choice.offer(probability, |u| draw(distribution, u));
        }
        choice.chosen()
    }
}
