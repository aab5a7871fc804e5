use core::f64::consts::FRAC_2_SQRT_PI;

use crate::real::{Real, Vector, lift};

/// Which form of the shadowing function of He, Torrance, Sillion and Greenberg.
///
/// ```text
/// S₁ = (1 − ½ erfc ν)/(1 + Λ)   ν = τ cotθ/(2 σ₀)
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Masking {
    /// Smith's Λ = ½ (e^(−ν²)/(√π ν) − erfc ν), what equation 25 of the paper means.
    #[default]
    Corrected,
    /// Λ = ½ (1/(√π ν) − erfc ν), as equation 25 is printed: S₁ is 0.7656 and not 0.8988 at ν = 1, 0.914
    /// and not 0.99999 at ν = 3.
    Printed,
}

lift! { Masking }

/// What a surface of a slope m = 2σ₀/τ does to a direction above it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Masked<T> {
    /// S₁/cosθ.
    pub(super) visible: T,
    /// K = tanθ erfc ν, which says how much of the depths is hidden.
    pub(super) hidden: T,
}

impl Masking {
    #[inline(always)]
    pub(super) fn at<T: Real>(self, slope: T, w: T::Vec3) -> Masked<T> {
        let (half, cos) = (T::lit(0.5), w.z());
        // The least square of an f32 that is still precise.
        let least = T::lit(1e-36);
        let sin_squared = (w.x().squared() + w.y().squared()).max(least);
        let rise = (sin_squared * slope.squared()).max(least).sqrt();
        let nu = cos / rise;
        let tail = nu.erfc();
        // (1 + Λ) cosθ, where e^(−ν²)/√π − ν erfc ν is the integral of erfc from ν on.
        let area = match self {
            Self::Corrected => cos + half * rise * nu.ierfc(),
            Self::Printed => cos + half * (rise * T::lit(FRAC_2_SQRT_PI * 0.5) - cos * tail),
        };
        let visible = ((T::one() - half * tail) / area).min(T::max_finite());
        // From 10⁻¹⁸ on W grows by its logarithm no longer.
        Masked { visible, hidden: sin_squared.sqrt() / cos.max(T::lit(1e-18)) * tail }
    }
}
