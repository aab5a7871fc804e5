//! What a Fresnel term can do.

use alloc::boxed::Box;
use alloc::sync::Arc;

use crate::block::{BatchError, Block, ColorBlock, ColorBuffer, CosineBlock, Cosines, run};
use crate::quadrature::integrate;
use crate::real::{Color, Real, in_place};

/// The reflectance of a smooth surface for unpolarised light.
///
/// On a microfacet surface the angle is that between the light and the facet (V·H), not the one
/// to the macroscopic normal.
///
/// The trait is object safe:
///
/// ```
/// use brdf::{Conductor, Fresnel, Schlick};
/// use glam::Vec3;
///
/// let f0 = Vec3::new(0.95, 0.64, 0.54);
/// let terms: [Box<dyn Fresnel<Color = Vec3>>; 2] = [
///     Box::new(Schlick::new(f0)?),
///     Box::new(Conductor::new(Vec3::new(0.2, 1.0, 1.2), Vec3::new(3.7, 2.6, 2.4))?),
/// ];
/// assert_eq!(terms[0].reflectance(1.0), f0);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
pub trait Fresnel<T: Real = f32>: Send + Sync {
    /// What a reflectance has channels for.
    type Color: Color<T>;

    /// Reflectance at the cosine of the angle of incidence, in 0 … 1 with three exceptions: the answer of
    /// [`Cook`](super::Cook) contains the light, [`BelcourBarla`](super::BelcourBarla) has colours that
    /// sRGB cannot show, and what arrives in an absorbing medium above a [`Stack`](super::Stack) is no
    /// measure of what returns.
    ///
    /// A cosine beyond ±1 counts as ±1. A negative one means light from the other side to
    /// [`Dielectric`](super::Dielectric); the other models have one side only and ignore the sign.
    fn reflectance(&self, cos_theta: T) -> Self::Color;

    /// Cosine-averaged reflectance 2 ∫₀¹ F(μ) μ dμ: the fraction reflected of light that arrives
    /// with the same radiance from everywhere.
    ///
    /// By default 48 Gauss–Legendre nodes in √μ, which crowd near grazing, where a reflectance
    /// changes fastest.
    fn average(&self) -> Self::Color {
        average_over_cosine(|cos| self.reflectance(cos))
    }

    /// The cosine at which each channel is not smooth, 0 where there is none, if any channel may have
    /// one: what a quadrature over angles has to know.
    #[doc(hidden)]
    fn kinks(&self) -> Option<Self::Color> {
        None
    }

    /// [`reflectance`](Self::reflectance) for a block of cosines, as
    /// [`Brdf::eval_block`](crate::Brdf::eval_block).
    fn reflectance_block(
        &self,
        cosines: CosineBlock<'_, T>,
        values: &mut ColorBlock<T, Self::Color>,
    ) {
        cosines.colors(
            values,
            #[inline(always)]
            |index| self.reflectance(cosines.cos(index)),
        );
    }

    /// The reflectance at a cosine in 0 … 1 times all else that a facet's reflection consists of. A
    /// Fresnel term that contains the light exceeds 1.
    #[doc(hidden)]
    #[inline(always)]
    fn reflected(&self, cos: T, scale: T) -> Self::Color {
        in_place!(
            T,
            #[inline(always)]
            || scaled(self.reflectance(cos), scale),
        )
    }

    /// [`reflected`](Self::reflected) for a block of facets: cosines and what they are multiplied
    /// with.
    #[doc(hidden)]
    #[inline(never)]
    fn reflected_block(&self, mirrored: Block<'_, T, 2>, values: &mut ColorBlock<T, Self::Color>) {
        let [cos, scale] = mirrored.planes;
        mirrored.colors(
            values,
            #[inline(always)]
            |index| self.reflected(cos[index], scale[index]),
        );
    }

    /// [`reflectance`](Self::reflectance) for many cosines, bit for bit, at the speed of SIMD code: see
    /// [`batch`](crate::batch).
    ///
    /// # Errors
    /// If slices differ in length.
    fn reflectance_batch(
        &self,
        cos_theta: &[T],
        values: ColorBuffer<'_, T, Self::Color>,
    ) -> Result<(), BatchError> {
        run(Cosines(cos_theta), values, &mut |cosines, _, values| {
            self.reflectance_block(cosines, values);
            Ok(())
        })
    }
}

macro_rules! forward {
    ($pointer:ty) => {
        impl<T: Real, F: Fresnel<T> + ?Sized> Fresnel<T> for $pointer {
            type Color = F::Color;
            #[inline(always)]
            fn reflectance(&self, cos_theta: T) -> F::Color {
                (**self).reflectance(cos_theta)
            }
            #[inline(always)]
            fn average(&self) -> F::Color {
                (**self).average()
            }
            fn kinks(&self) -> Option<F::Color> {
                (**self).kinks()
            }
            fn reflectance_block(
                &self,
                cosines: CosineBlock<'_, T>,
                values: &mut ColorBlock<T, F::Color>,
            ) {
                (**self).reflectance_block(cosines, values);
            }
            #[inline(always)]
            fn reflected(&self, cos: T, scale: T) -> F::Color {
                (**self).reflected(cos, scale)
            }
            fn reflected_block(
                &self,
                mirrored: Block<'_, T, 2>,
                values: &mut ColorBlock<T, F::Color>,
            ) {
                (**self).reflected_block(mirrored, values);
            }
        }
    };
}
forward!(Arc<F>);
forward!(Box<F>);
forward!(&F);

/// A reflectance times all else that a facet's reflection consists of.
#[inline(always)]
pub(super) fn scaled<T: Real, C: Color<T>>(reflectance: C, scale: T) -> C {
    (reflectance * scale).map(|value| value.min(T::max_finite()))
}

/// 2 ∫₀¹ F(μ) μ dμ by quadrature over √μ.
#[inline(always)]
pub(super) fn average_over_cosine<T: Real, C: Color<T>>(reflectance: impl Fn(T) -> C) -> C {
    integrate(T::zero(), T::one(), |root| {
        let cos = root * root;
        reflectance(cos) * (cos * root * T::lit(4.0))
    })
}

/// The cosine of a surface with one side: |cosθ|, and at most 1 although rounding of a scalar
/// product may have made it larger.
#[inline(always)]
pub(super) fn incident_cosine<T: Real>(cos_theta: T) -> T {
    cos_theta.abs().at_most(T::one())
}
