//! How directions are drawn for the diffuse part.

use core::f64::consts::FRAC_1_PI;

use super::orders::{Order, Orders};
use super::surface::Surface;
use crate::direction::{Pair, above_surface};
use crate::microfacet::{Shadowing, SmithSeparable};
use crate::real::{Color, Mask, Real, Vector};
use crate::sampling::{cosine_hemisphere, ln_of_rest, uniform};

/// Draws for a viewer, which are a mixture: in each channel alike of the orders of scattering at the mirror
/// direction, each of which makes (wi + wo)_xy normally distributed, and of the facets of the geometric
/// limit that the viewer sees; and of cosθ/π, the more the steeper the slopes are.
///
/// The orders alone fail on rough surfaces at grazing, where g grows towards the normal, and the facets of
/// steep slopes send much below the horizon.
pub(super) struct Proposal<'a, T: Real, C> {
    surface: &'a Surface<C, T>,
    wo: T::Vec3,
    /// g of the mirror direction.
    g: C,
    /// The share of cosθ/π.
    even: T,
}

/// What is decided before a direction is drawn.
pub(super) struct Choice<T: Real> {
    /// Where it is cosθ/π.
    even: T::Mask,
    /// Where it is an order of scattering.
    scattered: T::Mask,
    /// The variance of (wi + wo)_xy along either axis, twice.
    variance: T,
    /// What is left of the number that decided: it is uniform again.
    pub(super) rest: T,
}

impl<'a, T: Real, C: Color<T>> Proposal<'a, T, C> {
    #[inline(always)]
    pub(super) fn new(surface: &'a Surface<C, T>, wo: T::Vec3) -> Self {
        let steep = surface.slope().squared().min(T::lit(1e6));
        let even = T::lit(0.5) * steep / (steep + T::lit(0.25));
        Self { surface, wo, g: surface.mirrored(wo), even }
    }

    /// The share of the orders.
    #[inline(always)]
    fn share(g: T) -> T {
        T::one() / (T::one() + g * T::lit(0.25))
    }

    /// The density of directions.
    #[inline(always)]
    pub(super) fn pdf(&self, wi: T::Vec3) -> T {
        let facets = &self.surface.facets;
        let mirrored = SmithSeparable.pdf(facets, wi, self.wo);
        let sum = Pair::<T>::new(wi, self.wo).sum;
        let across = (sum.x().squared() + sum.y().squared()) * T::lit(0.25);
        let density = self.g.zip(self.surface.wavelength, |g, wavelength| {
            let length_squared = self.surface.length(wavelength).squared();
            let spread = length_squared * across;
            let (mut all, mut scattered) = (T::zero(), T::zero());
            Orders::new(g, T::zero()).visit(|Order { inverse, factor, exponent }| {
                let mass = factor * exponent.exp();
                all = all + mass;
                scattered = scattered + mass * (inverse * (-spread * inverse).exp());
            });
            let some = all.gt(T::zero());
            let normal = (scattered / T::select(some, all, T::one())).only_where(some);
            let scattered = normal * length_squared * T::lit(FRAC_1_PI * 0.25) * wi.z();
            let share = Self::share(g);
            share * scattered.min(T::max_finite()) + (T::one() - share) * mirrored
        });
        let even = self.even * wi.z() * T::lit(FRAC_1_PI);
        let density = even + (T::one() - self.even) * density.mean().min(T::max_finite());
        density.min(T::max_finite()).only_where(above_surface::<T, _>(wi))
    }

    /// Decides by a number in 0 … 1.
    #[inline(always)]
    pub(super) fn choose(&self, chance: T) -> Choice<T> {
        let (zero, one) = (T::zero(), T::one());
        let (all, wavelengths) = (self.g.channels(), self.surface.wavelength.channels());
        let count = all.as_ref().len();
        let chance = chance.clamp(zero, one);
        let is_even = chance.lt(self.even);
        let others = ((chance - self.even) / (one - self.even)).clamp(zero, one);
        let place = others * T::lit(count as f64);
        let (mut g, mut wavelength, mut rest) = (zero, one, zero);
        for (index, (this, of)) in all.as_ref().iter().zip(wavelengths.as_ref()).enumerate() {
            let beyond = place - T::lit(index as f64);
            let here = beyond.ge(zero);
            g = T::select(here, *this, g);
            wavelength = T::select(here, *of, wavelength);
            rest = T::select(here, beyond, rest);
        }
        let (rest, share) = (rest.at_most(one), Self::share(g));
        let scattered = rest.lt(share);
        let mirrored = (rest - share) / T::select(share.lt(one), one - share, one);
        let rest = T::select(scattered, rest / share, mirrored);

        let orders = Orders::new(g, zero);
        let mut all = zero;
        orders.visit(|Order { factor, exponent, .. }| all = all + factor * exponent.exp());
        let (mut left, mut chosen, mut within) = (rest * all, one, rest);
        orders.visit(|Order { inverse, factor, exponent }| {
            let mass = factor * exponent.exp();
            let some = mass.gt(zero);
            let here = left.ge(zero).and(some);
            chosen = T::select(here, inverse, chosen);
            within = T::select(here, left / T::select(some, mass, one), within);
            left = left - mass;
        });
        let variance = T::lit(4.0) / (chosen * self.surface.length(wavelength).squared());
        let rest = T::select(scattered, within.clamp(zero, one), rest);
        let rest = T::select(is_even, chance / T::select(is_even, self.even, one), rest);
        Choice { even: is_even, scattered, variance, rest }
    }

    /// A direction, which may lie below the surface or be none.
    #[inline(always)]
    pub(super) fn draw(&self, choice: &Choice<T>, u: [T; 2]) -> T::Vec3 {
        let (zero, one) = (T::zero(), T::one());
        let [radius, turn] = uniform(u);
        let length = (-ln_of_rest(radius) * choice.variance).max(T::lit(1e-36)).sqrt();
        let (sin, cos) = turn.sin_cos_turns();
        let (x, y) = (length * cos - self.wo.x(), length * sin - self.wo.y());
        let beyond = x.squared() + y.squared();
        let exists = beyond.lt(one);
        let z = T::select(exists, one - beyond, one).sqrt();
        let none = <T::Vec3 as Vector<T>>::new(zero, zero, -one);
        let scattered = Vector::select(exists, Vector::new(x, y, z), none);

        let facets = &self.surface.facets;
        let h = SmithSeparable.sample_visible(facets, self.wo, u);
        let mirrored = SmithSeparable.mirror(facets, self.wo, h).wi;
        let around = Vector::select(choice.scattered, scattered, mirrored);
        Vector::select(choice.even, cosine_hemisphere(u), around)
    }
}
