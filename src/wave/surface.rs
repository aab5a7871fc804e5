//! The surface of both models: normally distributed heights with a normal correlation.

use core::f64::consts::PI;

use super::lambert_w::lambert_w;
use super::masking::{Masked, Masking};
use super::orders::{Orders, are_many};
use super::scattering::pair_of;
use super::series::{scattered, scattered_block};
use crate::block::{BLOCK, Block, PairBlock, Plane};
use crate::direction::Pair;
use crate::distribution::Beckmann;
use crate::error::{ParameterError, range};
use crate::real::{Color, Real, Vector, lift};

/// The surface, the wavelengths, and what hides what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Surface<C, T> {
    pub(super) sigma: T,
    pub(super) correlation: T,
    pub(super) wavelength: C,
    /// Without one everything is seen.
    pub(super) masking: Hiding,
    /// The facets of the geometric limit, of roughness 2σ/τ.
    pub(super) facets: Beckmann<T>,
}

/// Whether the surface hides parts of itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Hiding {
    Nothing,
    He(Masking),
}

lift! { Hiding }
lift! {
    [T: Real, C: Color<T>] Surface<C, T> => Surface<C::Over<U>, U>: Surface {
        sigma: number, correlation: number, wavelength: color, masking: part, facets: part,
    }
}

/// What a wavelength sees of the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wave<T> {
    /// kσ, where k = 2π/λ.
    height: T,
    /// kτ.
    pub(super) length: T,
}

/// What a pair of directions has, whatever the wavelength is.
#[derive(Clone, Copy, Debug)]
struct View<T> {
    /// The product of both S₁/cosθ.
    visible: T,
    /// σ of what is seen.
    sigma: T,
    /// v̂_z, of v̂ = wi + wo.
    cosines: T,
    /// v̂_x² + v̂_y².
    across: T,
    /// |v̂|⁴/(16 π).
    whole: T,
}

impl<T: Real> View<T> {
    /// One of a block.
    #[inline(always)]
    fn of(Block { planes, .. }: Block<'_, T, 5>, index: usize) -> Self {
        let [visible, sigma, cosines, across, whole] = planes.map(
            #[inline(always)]
            |plane| plane[index],
        );
        Self { visible, sigma, cosines, across, whole }
    }
}

impl<T: Real, C: Color<T>> Surface<C, T> {
    pub(super) fn new(
        sigma: T,
        correlation: T,
        wavelength: C,
        masking: Hiding,
    ) -> Result<Self, ParameterError> {
        range::HEIGHT.check("sigma", sigma)?;
        range::CORRELATION.check("correlation", correlation)?;
        range::WAVELENGTH.check("wavelength", wavelength)?;
        let slope = (sigma + sigma) / correlation;
        let facets = Beckmann::new(slope.clamp(T::lit(1e-6), T::lit(1e3)))?;
        Ok(Self { sigma, correlation, wavelength, masking, facets })
    }

    /// 2σ/τ, √2 times the root-mean-square slope.
    #[inline(always)]
    pub(super) fn slope(&self) -> T {
        (self.sigma + self.sigma) / self.correlation
    }

    #[inline(always)]
    pub(super) fn masked(&self, w: T::Vec3) -> Masked<T> {
        match self.masking {
            Hiding::Nothing => {
                let visible = (T::one() / w.z()).min(T::max_finite());
                Masked { visible, hidden: T::zero() }
            }
            Hiding::He(masking) => masking.at(self.slope(), w),
        }
    }

    /// σ, the roughness of what is seen.
    ///
    /// ```text
    /// σ = σ₀/√(1 + (z₀/σ₀)²)   (z₀/σ₀)² = W((Kᵢ + Kₒ)²/(8π))
    /// ```
    #[inline(always)]
    pub(super) fn seen(&self, hidden: T) -> T {
        match self.masking {
            Hiding::Nothing => self.sigma,
            Hiding::He(_) => {
                let w = (hidden.squared() * T::lit(1.0 / (8.0 * PI))).max(T::lit(1e-30));
                self.sigma / (T::one() + lambert_w(w)).sqrt()
            }
        }
    }

    #[inline(always)]
    fn wave(&self, sigma: T, wavelength: T) -> Wave<T> {
        Wave { height: sigma * wave_number(wavelength), length: self.length(wavelength) }
    }

    /// kτ.
    #[inline(always)]
    pub(super) fn length(&self, wavelength: T) -> T {
        self.correlation * wave_number(wavelength)
    }

    /// The value of the diffuse part where everything is reflected.
    #[inline(always)]
    pub(super) fn diffuse(&self, pair: &Pair<T>) -> C {
        let view = self.view(pair);
        self.wavelength.map(|wavelength| self.wave(view.sigma, wavelength).diffuse(&view))
    }

    /// What of a pair of directions all wavelengths have in common.
    #[inline(always)]
    fn view(&self, pair: &Pair<T>) -> View<T> {
        let (light, viewer) = (self.masked(pair.wi), self.masked(pair.wo));
        let sum = pair.sum;
        View {
            visible: (light.visible * viewer.visible).min(T::max_finite()),
            sigma: self.seen(light.hidden + viewer.hidden),
            cosines: sum.z(),
            across: sum.x().squared() + sum.y().squared(),
            // |v̂| = 2 cosθ_d.
            whole: pair.cos_d.squared().squared() * T::lit(1.0 / PI),
        }
    }

    /// [`diffuse`](Self::diffuse) for a block of pairs, channel by channel.
    pub(super) fn diffuse_block(&self, pairs: PairBlock<'_, T>, values: &mut [Plane<T>]) {
        let mut views = [[T::zero(); BLOCK]; 5];
        pairs.numbers(
            &mut views,
            #[inline(always)]
            |index| {
                let View { visible, sigma, cosines, across, whole } =
                    self.view(&pair_of(pairs, index));
                [visible, sigma, cosines, across, whole]
            },
        );
        let views = pairs.of(views.each_ref());
        for (value, wavelength) in values.iter_mut().zip(self.wavelength.channels().as_ref()) {
            self.channel_block(views, *wavelength, value);
        }
    }

    #[inline(never)]
    fn channel_block(&self, views: Block<'_, T, 5>, wavelength: T, values: &mut Plane<T>) {
        let mut exponents = [[T::zero(); BLOCK]; 2];
        views.numbers(
            &mut exponents,
            #[inline(always)]
            |index| {
                let view = View::of(views, index);
                let wave = self.wave(view.sigma, wavelength);
                [wave.phase_variance(view.cosines), wave.spread(view.across)]
            },
        );
        let mut series = [T::zero(); BLOCK];
        scattered_block(views.of(exponents.each_ref()), &mut series);
        views.numbers(
            core::array::from_mut(values),
            #[inline(always)]
            |index| {
                let view = View::of(views, index);
                [self.wave(view.sigma, wavelength).value(&view, exponents[0][index], series[index])]
            },
        );
    }

    /// e^(−g) S of the mirror direction of a direction above the surface.
    #[inline(always)]
    pub(super) fn coherent(&self, w: T::Vec3) -> C {
        let fraction = self.seen_by(w).squared();
        self.mirrored(w).map(|g| (-g).exp() * fraction)
    }

    /// S₁ of a direction above the surface.
    #[inline(always)]
    pub(super) fn seen_by(&self, w: T::Vec3) -> T {
        match self.masking {
            Hiding::Nothing => T::one(),
            Hiding::He(_) => (self.masked(w).visible * w.z()).at_most(T::one()),
        }
    }

    /// About how much of what arrives along a direction above the surface is scattered around the lobe:
    /// S₁ (1 − e^(−g)), with the g of a direction as far from the horizon as the light may go.
    #[inline(always)]
    pub(super) fn scattered(&self, w: T::Vec3) -> C {
        let (one, cos) = (T::one(), w.z());
        let sigma = self.seen(self.masked(w).hidden);
        let seen = self.seen_by(w);
        self.wavelength.map(|wavelength| {
            let wave = self.wave(sigma, wavelength);
            let off = self.slope() + one / wave.length;
            let g = wave.phase_variance(cos + (cos + off).min(one));
            -(-g).exp_m1() * seen
        })
    }

    /// g of the mirror direction.
    #[inline(always)]
    pub(super) fn mirrored(&self, w: T::Vec3) -> C {
        let hidden = self.masked(w).hidden;
        let sigma = self.seen(hidden + hidden);
        let cosines = w.z() + w.z();
        self.wavelength.map(|wavelength| self.wave(sigma, wavelength).phase_variance(cosines))
    }
}

impl<T: Real> Wave<T> {
    /// g, the variance of the phase, of the sum of both cosines.
    #[inline(always)]
    pub(super) fn phase_variance(&self, cosines: T) -> T {
        (self.height * cosines).squared()
    }

    /// v_xy² τ²/4 of the squared length of (wi + wo)_xy.
    #[inline(always)]
    fn spread(&self, across: T) -> T {
        self.length.squared() * across * T::lit(0.25)
    }

    /// The value of the diffuse part where everything is reflected:
    ///
    /// ```text
    /// f = S/(cosθᵢ cosθₒ) · τ² k² |v̂|⁴/(16 π v̂_z²) Σ gᵐ e^(−g)/(m! m) e^(−v_xy² τ²/(4m))   v̂ = wi + wo
    /// ```
    #[inline(always)]
    fn diffuse(&self, view: &View<T>) -> T {
        let (g, spread) = (self.phase_variance(view.cosines), self.spread(view.across));
        self.value(view, g, scattered(&Orders::new(g, spread), spread))
    }

    /// The value from g and the sum over the orders.
    #[inline(always)]
    fn value(&self, view: &View<T>, g: T, series: T) -> T {
        // g is (kσ v̂_z)².
        let few = (self.length * self.height).squared();
        let rise = (self.height * view.cosines.squared()).max(T::lit(1e-15));
        let many = (self.length / rise).squared();
        let scale = T::select(are_many(g), many, few).min(T::max_finite());
        let value = (view.whole * series * scale).min(T::max_finite()) * view.visible;
        value.min(T::max_finite())
    }
}

/// k = 2π/λ.
#[inline(always)]
fn wave_number<T: Real>(wavelength: T) -> T {
    T::lit(2.0 * PI) / wavelength
}
