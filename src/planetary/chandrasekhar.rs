//! Light that grains scatter more than once.

use crate::real::{Real, lift};

/// Approximations of Chandrasekhar's H, of grains that scatter evenly.
///
/// ```text
/// H = (1 + 2x)/(1 + 2x γ)                                             1981
/// H = 1/(1 − w x (r₀ + (1 − 2r₀x)/2 · ln((1 + x)/x)))                 1993
/// γ = √(1 − w)      r₀ = (1 − γ)/(1 + γ)
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum HFunction {
    /// Within 4 %, too bright.
    Of1981,
    /// Within 1 %.
    #[default]
    Of1993,
}

lift! { HFunction }

impl HFunction {
    /// H(x) H(y) − 1 without the difference.
    #[inline(always)]
    pub(super) fn product_less_one<T: Real>(self, w: T, cosines: [T; 2]) -> T {
        let [a, b] = cosines.map(|x| self.less_one(w, x));
        a + b + a * b
    }

    /// H(x) − 1.
    #[inline(always)]
    fn less_one<T: Real>(self, w: T, x: T) -> T {
        let (one, two, half) = (T::one(), T::lit(2.0), T::lit(0.5));
        // A root has no derivative at 0.
        let gamma = (one - w).max(T::lit(1e-36)).sqrt();
        let sum = one + gamma;
        match self {
            Self::Of1981 => two * x * (w / sum) / (one + two * x * gamma),
            Self::Of1993 => {
                let r0 = w / sum.squared();
                let x = x.max(T::lit(1e-30));
                let logarithm = (one / x).ln_1p();
                let d = w * x * (r0 + half * (one - two * r0 * x) * logarithm);
                d / (one - d)
            }
        }
    }
}
