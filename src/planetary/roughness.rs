//! Hapke's macroscopic roughness: slopes too small to be seen, which tilt, shade and hide.

use core::f64::consts::{FRAC_1_PI, FRAC_2_PI, PI};

use crate::real::{Real, Vector, lift};

/// Roughness of a mean slope θ̄.
///
/// With a the smaller and b the larger of both angles i and e, and ψ the azimuth between them,
///
/// ```text
/// χ = 1/√(1 + π tan²θ̄)    E₁(x) = exp(−(2/π) cotθ̄ cot x)    E₂(x) = exp(−(1/π) cot²θ̄ cot² x)
/// Δ = 2 − E₁(b) − (ψ/π) E₁(a)                              F = exp(−2 tan(ψ/2))
/// aₑ = χ (cos a + sin a tanθ̄ (cosψ E₂(b) + sin²(ψ/2) E₂(a))/Δ)
/// bₑ = χ (cos b + sin b tanθ̄ (E₂(b) − sin²(ψ/2) E₂(a))/Δ)
/// η(x) = χ (cos x + sin x tanθ̄ E₂(x)/(2 − E₁(x)))
/// S = (μₑ/η(e)) (μ₀/η(i)) χ/(1 − F + F χ cos a/η(a))
/// ```
///
/// which is one formula for the two cases of the paper, i ≤ e and e ≤ i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Roughness<T> {
    tan: T,
    cot: T,
    chi: T,
}

lift! {
    [T: Real] Roughness<T> => Roughness<U>: Roughness { tan: number, cot: number, chi: number }
}

/// What the roughness makes of a pair of directions.
pub(super) struct Seen<T> {
    /// μ₀ₑ and μₑ, in either order.
    pub(super) cosines: [T; 2],
    /// S μ₀ₑ/(μ₀ (μ₀ₑ + μₑ)).
    pub(super) scale: T,
}

/// An angle: its sine and cosine, E₁ − 1 and E₂ with the exponent of the latter, and η/χ.
struct Angle<T> {
    sin: T,
    cos: T,
    less: T,
    exponent: T,
    second: T,
    eta: T,
}

impl<T: Real> Roughness<T> {
    pub(super) fn new(theta_bar: T) -> Self {
        let one = T::one();
        let tan = theta_bar.tan();
        // Of no slope all exponentials are 0, next to the horizon too.
        let cot = one / tan.max(T::lit(1e-18));
        Self { tan, cot, chi: one / (one + T::lit(PI) * tan.squared()).sqrt() }
    }

    #[inline(always)]
    fn angle(&self, sin: T, cos: T) -> Angle<T> {
        let (one, most) = (T::one(), T::lit(1e4));
        let product = self.cot * (cos / sin).min(T::lit(1e18));
        let first = (product * T::lit(FRAC_2_PI)).min(most);
        let exponent = (product.min(most).squared() * T::lit(FRAC_1_PI)).min(most);
        let (less, second) = ((-first).exp_m1(), (-exponent).exp());
        let eta = cos + sin * self.tan * second / (one - less);
        Angle { sin, cos, less, exponent, second, eta }
    }

    /// For two directions above the surface.
    #[inline(always)]
    pub(super) fn seen(&self, wi: T::Vec3, wo: T::Vec3) -> Seen<T> {
        let (zero, half, one, tiny) = (T::zero(), T::lit(0.5), T::one(), T::lit(1e-36));
        let sine = |w: T::Vec3| (w.x().squared() + w.y().squared()).max(tiny).sqrt();
        let cosine = |w: T::Vec3| w.z().max(T::lit(1e-37));
        let ([sin_i, sin_o], [cos_i, cos_o]) = ([sine(wi), sine(wo)], [cosine(wi), cosine(wo)]);
        // At a tie either angle is as much one as the other, for the derivatives.
        let a = self.angle(sin_i.min(sin_o), cos_i.max(cos_o));
        let b = self.angle(sin_i.max(sin_o), cos_i.min(cos_o));

        // At the normal, where there is no azimuth, any serves.
        let along = wi.x() * wo.x() + wi.y() * wo.y();
        let across = (wi.x() * wo.y() - wi.y() * wo.x()).abs();
        let product = (sin_i * sin_o).max(T::lit(1e-30));
        let same_side = along.ge(zero);
        let toward = (product + along).max(tiny);
        let away = (product - along).max(tiny);
        // tan(ψ/2) and cos²(ψ/2), of sums alone.
        let tangent = T::select(same_side, across / toward, away / across.max(tiny));
        let cos_squared = half * T::select(same_side, toward, across.squared() / away) / product;
        let cos_squared = cos_squared.at_most(one);
        let rest = across.max(tiny).atan2(-along) * T::lit(FRAC_1_PI);

        let delta = rest * (one + a.less) - a.less - b.less;
        let slope = self.tan / delta.max(T::lit(1e-30));
        // E₂(b) − E₂(a).
        let step = -b.second * (b.exponent - a.exponent).at_most(zero).exp_m1();
        let of_a = cos_squared * (b.second + step) - step;
        let of_b = cos_squared * a.second + step;
        let a_eff = (a.cos + a.sin * slope * of_a).max(zero);
        let b_eff = (b.cos + b.sin * slope * of_b).max(zero);

        let twice = (tangent + tangent).min(T::lit(100.0));
        let shaded = (-twice).exp() * (a.cos / a.eta) - (-twice).exp_m1();
        let sum = (self.chi * (a_eff + b_eff)).max(T::lit(1e-37));
        let scale = (a_eff / a.eta) * (b_eff / b.eta) * self.chi / (sum * shaded);
        Seen { cosines: [self.chi * a_eff, self.chi * b_eff], scale: scale.min(T::max_finite()) }
    }
}
