//! Polarised light on facets.

use super::cook_torrance::CookTorrance;
use super::scaled::Scaled;
use super::shadowing::Shadowing;
use crate::direction::{Pair, above_or_normal};
use crate::distribution::Distribution;
use crate::fresnel::PolarizedFresnel;
use crate::polarization::{Complex, Mueller, Polarized};
use crate::polarized_brdf::PolarizedBrdf;
use crate::real::{Color, Mask, Real, Vector};

/// Each facet reflects in its own frame, with ŝ across the plane of light and viewer:
/// M = D G/(4 N·L N·V) · Rot(χ_o) M_R(V·H) Rot(χ_i).
impl<T, D, F, S> PolarizedBrdf<T> for CookTorrance<D, F, S>
where
    T: Real,
    D: Distribution<T>,
    F: PolarizedFresnel<T>,
    S: Shadowing<T, D>,
{
    fn polarization(&self, wi: T::Vec3, wo: T::Vec3) -> Mueller<F::Color> {
        let pair = Pair::<T>::new(wi, wo);
        facet(&pair, self.fresnel().amplitudes(pair.cos_d))
    }
}

impl<T: Real, M: PolarizedBrdf<T>> PolarizedBrdf<T> for Scaled<M, T> {
    fn polarization(&self, wi: T::Vec3, wo: T::Vec3) -> Mueller<M::Color> {
        self.model().polarization(wi, wo)
    }
}

/// The Mueller matrix over its first element of a facet that mirrors one direction of a pair into the
/// other, with these amplitudes.
pub(crate) fn facet<T: Real, C: Color<T>>(pair: &Pair<T>, r: Polarized<Complex<C>>) -> Mueller<C> {
    let [incoming, outgoing] = turns(pair);
    let ([sin_i, cos_i], [sin_o, cos_o]) = (incoming, outgoing);
    let product = |a: C, b: C, c: C, d: C| a * b + c * d;
    let r_s = product(r.s.re, r.s.re, r.s.im, r.s.im);
    let r_p = product(r.p.re, r.p.re, r.p.im, r.p.im);
    // Where nothing is reflected it does not matter how.
    let half = T::lit(0.5);
    let inverse = ((r_s + r_p) * half).map(|mean| {
        let some = mean.gt(T::zero());
        (T::one() / T::select(some, mean, T::one())).only_where(some)
    });
    let n = (r_s - r_p) * half * inverse;
    let c = product(r.s.re, r.p.re, r.s.im, r.p.im) * inverse;
    let s = product(r.s.im, r.p.re, C::splat(-T::one()) * r.s.re, r.p.im) * inverse;
    let (zero, one) = (C::splat(T::zero()), C::splat(T::one()));
    let (c_sin, c_cos) = (c * sin_i, c * cos_i);
    Mueller {
        rows: [
            [one, n * cos_i, n * sin_i, zero],
            [
                n * cos_o,
                one * (cos_o * cos_i) - c_sin * sin_o,
                one * (cos_o * sin_i) + c_cos * sin_o,
                s * sin_o,
            ],
            [
                zero - n * sin_o,
                zero - one * (sin_o * cos_i) - c_sin * cos_o,
                c_cos * cos_o - one * (sin_o * sin_i),
                s * cos_o,
            ],
            [zero, s * sin_i, zero - s * cos_i, c],
        ],
    }
}

/// Sine and cosine of twice the angle from the frame of −wi to that of the facet, and from the facet's
/// to that of wo.
fn turns<T: Real>(pair: &Pair<T>) -> [[T; 2]; 2] {
    // What is no direction reflects nothing, in whatever frame.
    let [wi, wo] = [pair.wi, pair.wo].map(above_or_normal);
    let across_i = across(-wi);
    let across_o = across(wo);
    // −wi × h and wo × h point along this.
    let (m, some) = scaled(Vector::cross(wo, wi));
    let m = <T::Vec3 as Vector<T>>::select(some, m, across_i);
    let twice = |s: T::Vec3, p: T::Vec3, sign: T| {
        let (cos, sin) = (Vector::dot(s, m), Vector::dot(p, m) * sign);
        let squared = cos.squared() + sin.squared();
        let some = squared.gt(T::lit(1e-30));
        let inverse = T::one() / T::select(some, squared, T::one());
        [
            ((cos * sin + cos * sin) * inverse).only_where(some),
            T::select(some, (cos - sin) * (cos + sin) * inverse, T::one()),
        ]
    };
    [
        twice(across_i, Vector::cross(-wi, across_i), T::one()),
        twice(across_o, Vector::cross(wo, across_o), -T::one()),
    ]
}

/// A vector along ŝ = k × N, with N = +z; +y where k is parallel to N.
fn across<T: Real, V: Vector<T>>(k: V) -> V {
    let (zero, one) = (T::zero(), T::one());
    let (s, some) = scaled(V::new(k.y(), -k.x(), zero));
    V::select(some, s, V::new(zero, one, zero))
}

/// A vector with a largest component of 1, where it is not 0.
fn scaled<T: Real, V: Vector<T>>(v: V) -> (V, T::Mask) {
    let largest = v.x().abs().max(v.y().abs()).max(v.z().abs());
    // Of a number beyond all others the inverse is 0.
    let some = largest.gt(T::lit(1e-37)).and(largest.le(T::max_finite()));
    (v * (T::one() / T::select(some, largest, T::one())), some)
}
