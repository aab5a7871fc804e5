//! How far the facets of a surface are tilted, and which part of them by how much: what an integral
//! over all facets needs to place its nodes where they are.

use core::f64::consts::PI;

use alloc::vec;
use alloc::vec::Vec;

use crate::real::Real;

/// Facets of one kind: along an ellipse of slopes, (α_x cosψ, α_y sinψ) times any length, they are
/// equally likely.
///
/// In the plane of ψ a tilt is counted by q, in which integrands are smooth from the steepest part
/// of the distribution to the end of its tail.
#[derive(Clone, Copy, Debug)]
pub struct Spread<T> {
    along: [T; 2],
    tail: Tail<T>,
}

/// All kinds of facets of a surface, with the part of each.
pub(super) type Spreads<T> = Vec<(T, Spread<T>)>;

/// The part of the facets that is tilted by more than a slope of r = tanθ_h/α.
#[derive(Clone, Copy, Debug)]
enum Tail<T> {
    /// exp(−r²); q = r.
    Normal,
    /// 1/(1 + r²); q = asinh r.
    Ellipsoid,
    /// cosⁿ⁺²θ_h = (1 + tan²θ_h)^(−g), of g; q = asinh tanθ_h.
    Power(T),
    /// (1 + r²/g)^(−g), of g; q = asinh(r/√g).
    Student(T),
    /// ∫ 2π `peak` (1 + …)^(−`gamma`) cosθ_h sinθ_h dθ_h, the generalised ellipsoid; q = asinh(tanθ_h/`roughness`).
    Trowbridge { roughness: T, gamma: T, peak: T },
    /// ∫ `peak` π sin 2θ_h exp(−θ_h² `steepness`) dθ_h; q = θ_h.
    Angle { peak: T, steepness: T },
}

/// A facet in a given plane, and how many there are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tilt<T> {
    /// tanθ_h = B `sin`/`cos` where the slopes of the plane have the length B.
    pub(crate) sin: T,
    pub(crate) cos: T,
    /// The part of all facets per unit of q, all planes together.
    pub(crate) density: T,
}

/// Beyond this q the tail of a normal distribution is below 2·10⁻¹².
const NORMAL_END: f64 = 5.2;
/// Beyond this tangent a density that is even towards grazing leaves out 10⁻¹² of the facets.
const LAST_TANGENT: f64 = 1e6;
/// −ln of the part of the facets, 10⁻¹², that is left out at the end of the other tails.
const LEFT_OUT: f64 = 27.631021115928547;

impl<T: Real> Spread<T> {
    pub(super) fn normal(along: [T; 2]) -> Self {
        Self { along, tail: Tail::Normal }
    }

    pub(crate) fn ellipsoid(along: [T; 2]) -> Self {
        Self { along, tail: Tail::Ellipsoid }
    }

    /// For the exponent n of D.
    pub(super) fn power(exponent: T) -> Self {
        let half = (exponent + T::lit(2.0)) * T::lit(0.5);
        Self { along: [T::one(); 2], tail: Tail::Power(half) }
    }

    /// For D = `peak` exp(−θ_h² `steepness`).
    pub(super) fn angle(peak: T, steepness: T) -> Self {
        Self { along: [T::one(); 2], tail: Tail::Angle { peak, steepness } }
    }

    /// For the g = γ − 1 of Student's slopes.
    pub(super) fn student(along: [T; 2], degrees: T) -> Self {
        Self { along, tail: Tail::Student(degrees) }
    }

    /// For D that is `peak` where it is largest.
    pub(super) fn trowbridge(roughness: T, gamma: T, peak: T) -> Self {
        Self { along: [T::one(); 2], tail: Tail::Trowbridge { roughness, gamma, peak } }
    }

    /// All facets, if they are of this kind.
    pub(super) fn of_all(self) -> Option<Spreads<T>> {
        Some(vec![(T::one(), self)])
    }

    /// α_x and α_y.
    pub(crate) fn along(&self) -> [T; 2] {
        self.along
    }

    /// Whether there are steep facets, as many as the square of the cotangent of their tilt.
    pub(crate) fn has_steep_facets(&self) -> bool {
        matches!(self.tail, Tail::Ellipsoid | Tail::Student(_) | Tail::Trowbridge { .. })
    }

    /// q of the tangent `tan` where the slopes of the plane have the length `per_r`, at most the q up
    /// to which practically all facets are.
    #[inline]
    pub(crate) fn coordinate(&self, tan: T, per_r: T) -> T {
        match self.tail {
            Tail::Normal => (tan / per_r).min(T::lit(NORMAL_END)),
            Tail::Ellipsoid => asinh((tan / per_r).min(last_tangent(T::one()))),
            Tail::Student(g) => asinh((tan / (per_r * g.sqrt())).min(last_tangent(g))),
            Tail::Trowbridge { roughness, .. } => asinh(tan.min(T::lit(LAST_TANGENT)) / roughness),
            Tail::Power(g) => asinh(tan.min(last_tangent(g))),
            Tail::Angle { steepness, .. } => {
                tan.atan2(T::one()).min(T::lit(NORMAL_END) / steepness.sqrt())
            }
        }
    }

    /// The facets at q.
    #[inline]
    pub(crate) fn at(&self, q: T) -> Tilt<T> {
        let (one, two) = (T::one(), T::lit(2.0));
        match self.tail {
            Tail::Normal => Tilt { sin: q, cos: one, density: two * q * (-q.squared()).exp() },
            Tail::Ellipsoid => {
                let rising = q.exp();
                let falling = one / rising;
                let r = T::lit(0.5) * (rising - falling);
                let inverse = two / (rising + falling);
                Tilt { sin: r, cos: one, density: two * r * (inverse * inverse * inverse) }
            }
            Tail::Student(g) => {
                let rising = q.exp();
                let falling = one / rising;
                let (sinh, cosh) =
                    (T::lit(0.5) * (rising - falling), T::lit(0.5) * (rising + falling));
                let beyond = (-(cosh.ln() * (two * g + one))).exp();
                Tilt { sin: g.sqrt() * sinh, cos: one, density: two * g * sinh * beyond }
            }
            Tail::Trowbridge { roughness, gamma, peak } => {
                let rising = q.exp();
                let falling = one / rising;
                let (sinh, cosh) =
                    (T::lit(0.5) * (rising - falling), T::lit(0.5) * (rising + falling));
                let tan = roughness * sinh;
                let whole = one + tan.squared();
                // From where D is largest: the normal for a roughness below 1, else the horizon.
                let rough = one.lt(roughness);
                let part = T::select(rough, roughness.squared() * cosh.squared(), cosh.squared());
                let power = (-(gamma * (part / whole).ln())).exp();
                let density = peak * T::lit(2.0 * PI) * tan * power / whole.squared();
                Tilt { sin: tan, cos: one, density: density * (roughness * cosh) }
            }
            Tail::Power(g) => {
                let tan = sinh(q);
                let squared = tan.squared();
                let beyond = one.power_of_part(squared, g);
                let density = two * g * (tan / (one + squared).sqrt()) * beyond;
                Tilt { sin: tan, cos: one, density }
            }
            Tail::Angle { peak, steepness } => {
                let (sin, cos) = q.sin_cos();
                // The number nearest to π/2 may lie above it.
                let cos = cos.max(T::lit(1e-18));
                let falling = (-q.squared() * steepness).exp();
                Tilt { sin, cos, density: peak * T::lit(2.0 * PI) * sin * cos * falling }
            }
        }
    }
}

/// All facets of several surfaces, of which each has the given part.
pub(super) fn mixed<T: Real>(
    terms: impl IntoIterator<Item = (T, Option<Spreads<T>>)>,
) -> Option<Spreads<T>> {
    let mut all = Vec::new();
    for (weight, spreads) in terms {
        all.extend(spreads?.into_iter().map(|(part, spread)| (weight * part, spread)));
    }
    Some(all)
}

/// The tangent beyond which (1 + tan²θ_h)^(−g) is next to nothing.
fn last_tangent<T: Real>(g: T) -> T {
    (T::lit(LEFT_OUT) / g).exp_m1().sqrt()
}

/// The x ≥ 0 with sinh x = `sinh`, for 0 ≤ `sinh` ≤ 10⁹.
pub(crate) fn asinh<T: Real>(sinh: T) -> T {
    let squared = sinh.squared();
    (sinh + squared / (T::one() + (T::one() + squared).sqrt())).ln_1p()
}

/// (eˣ − e⁻ˣ)/2 for x ≥ 0.
pub(crate) fn sinh<T: Real>(x: T) -> T {
    let rise = x.exp_m1();
    T::lit(0.5) * (rise + rise / (T::one() + rise))
}
