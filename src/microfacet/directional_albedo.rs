//! The directional albedo of a surface of facets, as an integral over the facets.
//!
//! In a plane through the normal, with t = tanθ_h, and a = tanθ_o times the cosine of the azimuth
//! between plane and viewer,
//!
//! ```text
//! E = ∫ D cosθ_h F G (1 + a t) dω_h,  0 < t < a + √(1 + a²)
//! ```
//!
//! over the facets whose mirror direction lies above the surface. Among them the integrand is smooth
//! but for known kinks, where integrals are cut: products of Gauss–Legendre rules do the rest.

use core::f64::consts::{FRAC_PI_6, TAU};
use core::ops::{Add, Mul};

use super::planes::{Plane, Planes, Viewer};
use super::shadowing::{Kinks, Shadowing};
use crate::direction::{Pair, above_surface};
use crate::distribution::{Distribution, Spread, Tilt};
use crate::fresnel::Fresnel;
use crate::quadrature::{NODES_16, NODES_24, NODES_32, integrate_with};
use crate::real::{Color, Mask, Real, Vector};

/// ∫ f cosθᵢ dωᵢ, if what it takes is known of distribution and shadowing.
#[inline(never)]
pub(super) fn albedo<T, D, F, S>(
    distribution: &D,
    fresnel: &F,
    shadowing: &S,
    wo: T::Vec3,
) -> Option<F::Color>
where
    T: Real,
    D: Distribution<T>,
    F: Fresnel<T>,
    S: Shadowing<T, D>,
{
    let kinks = shadowing.kinks(distribution)?;
    let (spreads, viewer) = (distribution.spreads()?, Viewer::new(wo));
    let reflected = |facet: &Pair<T>, scale: T| {
        let white = scale * facet.cos_i * shadowing.visibility(distribution, facet);
        Reflected { color: fresnel.reflected(facet.cos_d.min(T::one()), white), white }
    };
    let of_kink = |reflectance: Option<T>| {
        let mut all = Reflected::<T, F::Color>::none();
        for (part, spread) in &spreads {
            let rays = Rays { spread: *spread, kinks, reflectance, wo: viewer.wo };
            let planes = Planes::new(spread, kinks, reflectance, &viewer);
            let of_plane = |plane: &Plane<T>| rays.integral(plane, &reflected);
            let sum = planes.integral(&of_plane, Reflected::choose);
            // 4 of the Jacobian, and the mean over all azimuths.
            all = all + sum * (*part * T::lit(4.0 / TAU));
        }
        // White facets reflect no more than they receive. What exceeds it is rounding and the rule's
        // error.
        let scale = T::one() / all.white.max(T::one());
        (all.color * scale).map(|value| value.min(T::max_finite()))
    };
    let color = match fresnel.kinks() {
        None => of_kink(None),
        Some(kinks) => channel_by_channel(kinks, of_kink),
    };
    Some(color.only_where(above_surface::<T, _>(wo)))
}

/// ∫ f cosθᵢ dωᵢ of a lobe f = D v, of v cosθᵢ for the mirror image of the viewer in a facet, which is
/// smooth but for a root at the horizon.
pub(crate) fn over_facets<T: Real, C: Color<T>>(
    spreads: &[(T, Spread<T>)],
    wo: T::Vec3,
    value: impl Fn(&Pair<T>) -> C,
) -> C {
    let viewer = Viewer::new(wo);
    let reflected =
        |facet: &Pair<T>, scale: T| Reflected { color: value(facet) * scale, white: T::zero() };
    let mut all = C::splat(T::zero());
    for (part, spread) in spreads {
        let kinks = Kinks::None;
        let rays = Rays { spread: *spread, kinks, reflectance: None, wo: viewer.wo };
        let planes = Planes::new(spread, kinks, None, &viewer);
        let of_plane = |plane: &Plane<T>| rays.up_to_the_horizon(plane, &reflected);
        let sum = planes.integral(&of_plane, Reflected::choose);
        all = all + sum.color * (*part * T::lit(4.0 / TAU));
    }
    all
}

/// Every channel by the integral that is cut at its own kink, or by that without, where the kink is
/// at 0.
fn channel_by_channel<T: Real, C: Color<T>>(kinks: C, of_kink: impl Fn(Option<T>) -> C) -> C {
    let zero = T::zero();
    let smooth = of_kink(None);
    let (color, _) = kinks.fold((smooth, zero), |(color, before), kink| {
        // Neighbours often have the same.
        let other = kink.gt(zero).and(kink.lt(before).or(before.lt(kink)));
        if other.is_never() {
            return (color, kink);
        }
        let same = |other: T| kink.gt(zero).and(other.le(kink)).and(kink.le(other));
        let rest = color.zip(kinks, |value, other| value.only_where(same(other).not()));
        let here = of_kink(Some(kink)).zip(kinks, |value, other| value.only_where(same(other)));
        (rest + here, kink)
    });
    color
}

/// What facets reflect, and what they would if they were white.
#[derive(Clone, Copy)]
struct Reflected<T, C> {
    color: C,
    white: T,
}

impl<T: Real, C: Color<T>> Reflected<T, C> {
    fn none() -> Self {
        Self { color: C::splat(T::zero()), white: T::zero() }
    }

    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self {
            color: C::choose(mask, yes.color, no.color),
            white: T::select(mask, yes.white, no.white),
        }
    }
}

impl<T: Real, C: Color<T>> Add for Reflected<T, C> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { color: self.color + other.color, white: self.white + other.white }
    }
}

impl<T: Real, C: Color<T>> Mul<T> for Reflected<T, C> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self { color: self.color * factor, white: self.white * factor }
    }
}

/// The facets of a kind, plane by plane.
struct Rays<T: Real> {
    spread: Spread<T>,
    kinks: Kinks,
    /// The cosine at which the reflectance has a kink.
    reflectance: Option<T>,
    wo: T::Vec3,
}

impl<T: Real> Rays<T> {
    /// The sum over the facets of a plane.
    fn integral<C: Color<T>>(
        &self,
        plane: &Plane<T>,
        reflected: &impl Fn(&Pair<T>, T) -> Reflected<T, C>,
    ) -> Reflected<T, C> {
        let (zero, [x, y]) = (T::zero(), plane.slopes);
        let per_r = (x.squared() + y.squared()).sqrt();
        let a = (x * self.wo.x() + y * self.wo.y()) / (self.wo.z() * per_r);
        let tangents = ends(a);
        let [first, second, last] = tangents.map(|tan| self.spread.coordinate(tan, per_r));
        let value = |q: T| self.facet(plane, self.spread.at(q), reflected);
        if let Some(cos) = self.reflectance {
            let kinks = crossings(a, cos / self.wo.z(), tangents[2]);
            let [near, far] = kinks.map(|tan| self.spread.coordinate(tan, per_r));
            return match self.kinks {
                Kinks::None => pieces([zero, near, far, last], value),
                Kinks::Grooves => {
                    let [low, high] = [first.min(near), second.max(far)];
                    let [a, b] = [first.max(near), second.min(far)];
                    pieces([zero, low, a.min(b), a.max(b), high, last], value)
                }
            };
        }
        match self.kinks {
            Kinks::None => integrate_with(&NODES_32, zero, last, value),
            Kinks::Grooves => {
                let mut sum = integrate_with(&NODES_32, zero, first, value);
                if !second.gt(first).is_never() {
                    sum = sum + integrate_with(&NODES_32, first, second, value);
                }
                if !last.gt(second).is_never() {
                    sum = sum + integrate_with(&NODES_16, second, last, value);
                }
                sum
            }
        }
    }

    /// The same of a formula with a root at the horizon.
    fn up_to_the_horizon<C: Color<T>>(
        &self,
        plane: &Plane<T>,
        reflected: &impl Fn(&Pair<T>, T) -> Reflected<T, C>,
    ) -> Reflected<T, C> {
        let [x, y] = plane.slopes;
        let per_r = (x.squared() + y.squared()).sqrt();
        let a = (x * self.wo.x() + y * self.wo.y()) / (self.wo.z() * per_r);
        let [_, _, last] = ends(a);
        let last = self.spread.coordinate(last, per_r);
        pieces([T::zero(), last], |q| self.facet(plane, self.spread.at(q), reflected))
    }

    #[inline(never)]
    fn facet<C: Color<T>>(
        &self,
        plane: &Plane<T>,
        tilt: Tilt<T>,
        reflected: &impl Fn(&Pair<T>, T) -> Reflected<T, C>,
    ) -> Reflected<T, C> {
        let ([x, y], wo) = (plane.slopes, self.wo);
        let m: T::Vec3 = Vector::new(x * tilt.sin, y * tilt.sin, tilt.cos);
        let inverse_square = T::one() / Vector::length_squared(m);
        // The facets of the integral face the viewer.
        let along = Vector::dot(wo, m).max(T::zero());
        let sum = m * (T::lit(2.0) * along * inverse_square);
        let wi = sum - wo;
        let cos_i = wi.z().max(T::zero());
        let inverse = inverse_square.sqrt();
        let (h, cos_d, above) = (m * inverse, along * inverse, cos_i.gt(T::zero()));
        let pair = Pair { wi, wo, cos_i, cos_o: wo.z(), sum, h, cos_h: h.z(), cos_d, above };
        reflected(&pair, tilt.density * (along / tilt.cos))
    }
}

/// The tangents at which an integral over the facets of a plane is cut if the surface has grooves,
/// and the last one, of the facet that mirrors the horizon.
///
/// In a plane with tanβ = a, G (1 + a t) is the least of 1 + a t, 2 and 2 N·L/N·V. As θ_h grows, the
/// first is succeeded by the third at π/6 + β/3 if β < π/4, else by the second at π/2 − β and that
/// by the third at β.
fn ends<T: Real>(a: T) -> [T; 3] {
    let (zero, one) = (T::zero(), T::one());
    let root = (one + a.squared()).sqrt();
    let last = T::select(a.gt(zero), a + root, one / (root - a.min(zero)));
    let three = a.gt(one);
    let single = (T::lit(FRAC_PI_6) + a.atan2(one) * T::lit(1.0 / 3.0)).tan();
    let first = T::select(three, one / a.max(one), single);
    [first, T::select(three, a, first), last]
}

/// The tangents of the facets in a plane that the viewer sees at an angle whose cosine is `ratio`
/// times that of the surface: none, one or two, the others at an end.
///
/// In a plane with tanβ = a that is where cos(θ_h − β) = κ = `ratio`/√(1 + a²).
fn crossings<T: Real>(a: T, ratio: T, last: T) -> [T; 2] {
    let (zero, one) = (T::zero(), T::one());
    let kappa = ratio / (one + a.squared()).sqrt();
    let there = kappa.lt(one);
    let tan = ((one - kappa) * (one + kappa)).max(T::lit(1e-30)).sqrt() / kappa.max(T::lit(1e-9));
    let product = a * tan;
    let before = there.and(a.gt(tan));
    let near = T::select(before, (a - tan) / T::select(before, one + product, one), zero);
    let after = product.lt(one);
    let far = T::select(after, (a + tan) / T::select(after, one - product, one), last);
    [near.min(last), T::select(there, far.clamp(zero, last), zero)]
}

/// An integral over pieces at whose ends the formula may go with the root of the distance.
fn pieces<T: Real, C: Color<T>, const N: usize>(
    ends: [T; N],
    value: impl Fn(T) -> Reflected<T, C>,
) -> Reflected<T, C> {
    let (zero, one) = (T::zero(), T::one());
    let mut sum = Reflected::none();
    for index in 1..N {
        let [from, to] = [ends[index - 1], ends[index]];
        if to.gt(from).is_never() {
            continue;
        }
        let length = (to - from).max(zero);
        sum = sum
            + integrate_with(&NODES_24, zero, one, |part: T| {
                let step = part.squared() * (T::lit(3.0) - part - part);
                value(from + length * step) * (length * T::lit(6.0) * part * (one - part))
            });
    }
    sum
}
