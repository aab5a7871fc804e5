//! What both models are: a specular lobe, a diffuse part around it and a uniform one.

use core::f64::consts::{FRAC_1_PI, PI};

use super::proposal::Proposal;
use super::surface::Surface;
use crate::block::{BLOCK, ColorBlock, PairBlock};
use crate::bsdf::{BsdfSample, Lobes, Power, never};
use crate::direction::{Pair, above_or_normal, above_surface, both_above, mirrored};
use crate::fresnel::Fresnel;
use crate::quadrature::mean_over_square;
use crate::real::{Color, Lift, Mask, Real, Vector, lift};
use crate::sampling::cosine_hemisphere;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scattering<F, C, T> {
    pub(super) surface: Surface<C, T>,
    pub(super) fresnel: F,
    /// f of the uniform part, sr⁻¹.
    pub(super) uniform: C,
}

lift! {
    [T: Real, C: Color<T>, F: Lift<T>] Scattering<F, C, T> => Scattering<F::Over<U>, C::Over<U>, U>: Scattering {
        surface: part, fresnel: part, uniform: color,
    }
}

/// A model that is nothing but its [`Scattering`].
macro_rules! of_scattering {
    ($model:ident) => {
        lift! {
            [T: Real, C: Color<T>, F: Lift<T>] $model<F, C, T> => $model<F::Over<U>, C::Over<U>, U>:
            $model { scattering: part }
        }

        impl<F, C, T> $model<F, C, T> {
            /// The reflectance.
            #[must_use]
            pub const fn fresnel(&self) -> &F {
                &self.scattering.fresnel
            }
        }

        impl<T: Real, C: Color<T>, F: Fresnel<T, Color = C>> $model<F, C, T> {
            /// [`sample`](Bsdf::sample) from two numbers, of which the first also chooses: what it decided is
            /// taken out of it, and what is left is uniform again. It loses the digits that it spends.
            pub fn sample_by_two(&self, wo: T::Vec3, u: [T; 2]) -> BsdfSample<T, C> {
                self.scattering.sample(wo, u, None)
            }
        }

        impl<T: Real, C: Color<T>, F: Fresnel<T, Color = C>> Bsdf<T> for $model<F, C, T> {
            type Color = C;

            #[inline(always)]
            fn eval(&self, wi: T::Vec3, wo: T::Vec3, _: TransportMode) -> C {
                self.scattering.eval(wi, wo)
            }

            #[inline(always)]
            fn pdf(&self, wi: T::Vec3, wo: T::Vec3, _: TransportMode) -> T {
                self.scattering.pdf(wi, wo)
            }

            #[inline(always)]
            fn sample(&self, wo: T::Vec3, [x, y, u]: [T; 3], _: TransportMode) -> BsdfSample<T, C> {
                self.scattering.sample(wo, [x, y], Some(u))
            }

            #[inline(always)]
            fn specular(&self, wo: T::Vec3, _: TransportMode) -> Lobes<T, C> {
                self.scattering.specular(wo)
            }

            fn power(&self, wo: T::Vec3) -> Power<C> {
                self.scattering.power(wo)
            }

            fn eval_block(
                &self,
                pairs: PairBlock<'_, T>,
                _: TransportMode,
                values: &mut ColorBlock<T, C>,
            ) {
                self.scattering.eval_block(pairs, values);
            }
        }
    };
}
pub(super) use of_scattering;

/// A pair of directions, or the normal in the place of what is none.
#[inline(always)]
pub(super) fn pair_above<T: Real>(wi: T::Vec3, wo: T::Vec3) -> Pair<T> {
    let above = both_above::<T>(wi, wo);
    Pair::where_above(above_or_normal(wi), above_or_normal(wo), above)
}

/// The same of a block.
#[inline(always)]
pub(super) fn pair_of<T: Real>(pairs: PairBlock<'_, T>, index: usize) -> Pair<T> {
    pair_above(pairs.wi(index), pairs.wo(index))
}

/// A power of 2 not below the number of weights in [`Scattering::power`], so that their sum stays finite.
const WEIGHTS: f64 = 8192.0;

/// The probabilities of the parts, of a viewer.
#[derive(Clone, Copy, Debug)]
struct Chances<T> {
    /// Of the lobe, and of all else.
    lobe: [T; 2],
    /// Of the uniform part and of the diffuse one, if it is not the lobe.
    rest: [T; 2],
}

impl<T: Real, C: Color<T>, F: Fresnel<T, Color = C>> Scattering<F, C, T> {
    #[inline(always)]
    pub(super) fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let pair = pair_above::<T>(wi, wo);
        let value = self.diffuse(&pair) + self.uniform;
        value.map(|f| f.min(T::max_finite())).only_where(pair.above)
    }

    /// [`eval`](Self::eval) for a block of pairs: the surface and the reflectance by turns, wavelength by
    /// wavelength and order by order.
    pub(super) fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        let mut diffuse = C::by_channel(|_| [T::zero(); BLOCK]);
        self.surface.diffuse_block(pairs, diffuse.as_mut());
        let mut cosines = [[T::zero(); BLOCK]];
        pairs.numbers(
            &mut cosines,
            #[inline(always)]
            |index| [pair_of(pairs, index).cos_d.at_most(T::one())],
        );
        self.fresnel.reflectance_block(pairs.of(cosines.each_ref()), values);
        let parts = values.as_mut().iter_mut().zip(diffuse.as_ref());
        for ((value, diffuse), uniform) in parts.zip(self.uniform.channels().as_ref()) {
            pairs.changed(
                core::array::from_mut(value),
                &mut [],
                #[inline(always)]
                |index, [reflectance]| {
                    let diffuse = (reflectance * diffuse[index]).min(T::max_finite());
                    let value = (diffuse + *uniform).min(T::max_finite());
                    ([value.only_where(pair_of(pairs, index).above)], [])
                },
            );
        }
    }

    /// The diffuse part, which is not uniform.
    #[inline(always)]
    pub(super) fn diffuse(&self, pair: &Pair<T>) -> C {
        let reflectance = self.fresnel.reflectance(pair.cos_d.at_most(T::one()));
        let value = reflectance * self.surface.diffuse(pair);
        value.map(|f| f.min(T::max_finite()))
    }

    /// The weight of the lobe of a viewer above the surface.
    #[inline(always)]
    fn lobe(&self, wo: T::Vec3) -> C {
        self.fresnel.reflectance(wo.z().at_most(T::one())) * self.surface.coherent(wo)
    }

    #[inline(always)]
    pub(super) fn specular(&self, wo: T::Vec3) -> Lobes<T, C> {
        let above = above_surface::<T, _>(wo);
        let wo: T::Vec3 = above_or_normal(wo);
        Lobes::mirror(wo, self.lobe(wo), above)
    }

    /// Shares of the reflected power, those of the diffuse part by a guess.
    #[inline(always)]
    fn chances(&self, wo: T::Vec3) -> Chances<T> {
        let (zero, one) = (T::zero(), T::one());
        let lobe = self.lobe(wo).mean();
        let diffuse = self.fresnel.reflectance(wo.z().at_most(one)) * self.surface.scattered(wo);
        let diffuse = diffuse.mean();
        let some = diffuse.gt(zero);
        let diffuse = diffuse.max(lobe * T::lit(0.02)).only_where(some);
        let uniform = self.uniform.mean() * T::lit(PI);
        let share = |part: T, of: T| {
            let some = of.gt(zero);
            (part / T::select(some, of, one)).at_most(one).only_where(some)
        };
        let spread = diffuse + uniform;
        // Written so that parts that begin at 0 have the derivatives of their probabilities there.
        let by_uniform = T::select(spread.gt(zero), share(uniform, spread), one);
        let by_rest = share(spread, lobe + spread);
        Chances { lobe: [one - by_rest, by_rest], rest: [by_uniform, one - by_uniform] }
    }

    #[inline(always)]
    pub(super) fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let above = both_above::<T>(wi, wo);
        let (wi, wo) = (above_or_normal(wi), above_or_normal(wo));
        self.density(&self.chances(wo), &Proposal::new(&self.surface, wo), wi).only_where(above)
    }

    #[inline(always)]
    fn density(&self, chances: &Chances<T>, proposal: &Proposal<'_, T, C>, wi: T::Vec3) -> T {
        let [uniform, diffuse] = chances.rest;
        let cosine = wi.z() * T::lit(FRAC_1_PI);
        let density = uniform * cosine + (diffuse * proposal.pdf(wi)).min(T::max_finite());
        chances.lobe[1] * density
    }

    /// A sample by a number that chooses and two for a direction; without the former by two that do both.
    #[inline(always)]
    pub(super) fn sample(
        &self,
        wo: T::Vec3,
        [x, y]: [T; 2],
        chance: Option<T>,
    ) -> BsdfSample<T, C> {
        let (zero, one) = (T::zero(), T::one());
        let above = above_surface::<T, _>(wo);
        let wo: T::Vec3 = above_or_normal(wo);
        let chances = self.chances(wo);
        let [of_lobe, of_rest] = chances.lobe;
        let u = chance.unwrap_or(x).clamp(zero, one);
        let is_lobe = u.lt(of_lobe).or(of_rest.le(zero));
        let over = |part: T, whole: T| part / T::select(whole.gt(zero), whole, one);
        let lobe = BsdfSample {
            wi: mirrored::<T, _>(wo),
            weight: self.lobe(wo).map(|weight| over(weight, of_lobe).min(T::max_finite())),
            pdf: zero,
            specular: above,
        };

        let [of_uniform, of_diffuse] = chances.rest;
        let u = over(u - of_lobe, of_rest).clamp(zero, one);
        let is_uniform = u.lt(of_uniform).or(of_diffuse.le(zero));
        let proposal = Proposal::new(&self.surface, wo);
        let choice = proposal.choose(over(u - of_uniform, of_diffuse).clamp(zero, one));
        let rest = T::select(is_uniform, over(u, of_uniform), choice.rest);
        let directions = [if chance.is_some() { x } else { rest }, y];
        let wi = Vector::select(
            is_uniform,
            cosine_hemisphere(directions),
            proposal.draw(&choice, directions),
        );
        let pdf = self.density(&chances, &proposal, above_or_normal(wi));
        let drawn = above_surface::<T, _>(wi).and(pdf.gt(zero));
        let scale = wi.z() / T::select(drawn, pdf, one);
        let weight = (self.eval(wi, wo) * scale).map(|weight| weight.min(T::max_finite()));
        let spread = BsdfSample { wi, weight, pdf, specular: never::<T>() };
        BsdfSample::choose(is_lobe, lobe, spread.only_where(drawn)).only_where(above)
    }

    /// The lobe and the uniform part exactly, the rest as the mean of 4181 weights.
    pub(super) fn power(&self, wo: T::Vec3) -> Power<C> {
        let above = above_surface::<T, _>(wo);
        let wo: T::Vec3 = above_or_normal(wo);
        let proposal = Proposal::new(&self.surface, wo);
        let diffuse = mean_over_square(
            #[inline(always)]
            |u| self.weight(&proposal, wo, u) * T::lit(1.0 / WEIGHTS),
        );
        let whole = diffuse * T::lit(WEIGHTS) + self.lobe(wo) + self.uniform * T::lit(PI);
        let reflectance = whole.map(|value| value.min(T::max_finite()));
        Power { reflectance: reflectance.only_where(above), transmittance: C::splat(T::zero()) }
    }

    /// f cosθ/pdf of the diffuse part at a point of a lattice in the unit cube, of which two places are
    /// given. Its nodes stay where they are, whatever the derivative is by.
    #[inline(never)]
    fn weight(&self, proposal: &Proposal<'_, T, C>, wo: T::Vec3, [x, y]: [T; 2]) -> C {
        let (zero, one) = (T::zero(), T::one());
        // The third component of the lattice's step, of least error for smooth periodic formulas.
        let z = x * T::lit(1116.0);
        let choice = proposal.choose(z - z.floor());
        let wi: T::Vec3 = proposal.draw(&choice, [x, y]);
        let wi: T::Vec3 = Vector::new(wi.x().held(), wi.y().held(), wi.z().held());
        let above = above_surface::<T, _>(wi);
        let wi = above_or_normal(wi);
        let pdf = proposal.pdf(wi).held();
        let drawn = above.and(pdf.gt(zero));
        let scale = wi.z() / T::select(drawn, pdf, one);
        let value = self.diffuse(&Pair::<T>::where_above(wi, wo, drawn)) * scale;
        value.map(|weight| weight.min(T::max_finite())).only_where(drawn)
    }
}

#[cfg(test)]
mod tests {
    use crate::{BeckmannKirchhoff, Bsdf, Constant, He1991};
    use glam::Vec3;

    #[test]
    fn power_is_finite_at_the_horizon() {
        let white = Constant::new(1.0_f32).unwrap();
        for sigma in [50.0, 200.0, 1e9] {
            for z in [1e-30, 1e-37, 1e-40] {
                let wo = Vec3::new(1.0, 0.0, z);
                let open = BeckmannKirchhoff::new(sigma, 2000.0, white, 550.0).unwrap();
                let masked = He1991::new(sigma, 2000.0, white, 550.0).unwrap();
                let power = [open.power(wo), masked.power(wo)].map(|power| power.reflectance);
                assert!(power.iter().all(|it| it.is_finite()), "{sigma} {z:e}: {power:?}");
            }
        }
    }
}
