//! What a distribution of facet normals can do.

use alloc::boxed::Box;
use alloc::sync::Arc;
use core::array;

use super::spread::Spreads;
use crate::block::{
    BatchError, DirectionBlock, Directions, DrawBlock, Normals, Numbers, Plane, UniformBlock, run,
};
use crate::real::{Real, Vector};

/// A distribution of facet normals, D(h) in sr⁻¹, normalised to ∫ D(h) (N·h) dω_h = 1.
///
/// D(h) is the same for `h` and its mirror image across the normal, (−h_x, −h_y, h_z). The trait is
/// object safe. Where nothing but numbers is given, one of them says which kind it is:
///
/// ```
/// use brdf::{Distribution, Ggx, from_spherical};
///
/// let facets: Vec<Box<dyn Distribution>> = vec![Box::new(Ggx::new(0.3_f32)?)];
/// assert!(facets[0].density(from_spherical(0.3, 0.2)) > 0.0);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("NDF", "normal distribution function", "microfacet distribution"))]
pub trait Distribution<T: Real = f32>: Send + Sync {
    /// D(h) for a unit `h`; zero where `h` lies below the surface. Finite and never negative for
    /// any finite `h`.
    fn density(&self, h: T::Vec3) -> T;

    /// D of the unit vector along `m`, whatever the length of `m`: for distributions that do not
    /// need it, models are spared its normalisation. Where the square of the length does not lie in
    /// 10⁻²⁸ … 10²², finite and never negative but of no meaning.
    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        self.density(m.normalize_or_normal())
    }

    /// Draws `h` with density D(h) (N·h) from two uniform numbers in [0, 1). It is a unit vector
    /// that does not lie below the surface. Numbers outside [0, 1) are taken as by
    /// [`Brdf::sample`](crate::Brdf::sample).
    fn sample(&self, u: [T; 2]) -> T::Vec3;

    /// A vector of any length along [`sample`](Self::sample), whose square lies in 10⁻³⁶ … 10³⁶: for
    /// those who do not need the unit vector.
    #[doc(hidden)]
    #[inline(always)]
    fn sample_along(&self, u: [T; 2]) -> T::Vec3 {
        self.sample(u)
    }

    /// The facets, kind by kind, with the part of each kind: what a quadrature over facets needs to
    /// place its nodes. `None`, the default, is a distribution of which that is not known.
    #[doc(hidden)]
    fn spreads(&self) -> Option<Spreads<T>> {
        None
    }

    /// [`density`](Self::density) for a block of directions, as
    /// [`Brdf::eval_block`](crate::Brdf::eval_block).
    fn density_block(&self, h: DirectionBlock<'_, T>, densities: &mut Plane<T>) {
        h.numbers(
            array::from_mut(densities),
            #[inline(always)]
            |index| [self.density(h.at(index))],
        );
    }

    /// [`density_along`](Self::density_along) for a block of vectors.
    #[doc(hidden)]
    #[inline(never)]
    fn density_along_block(&self, m: DirectionBlock<'_, T>, densities: &mut Plane<T>) {
        m.numbers(
            array::from_mut(densities),
            #[inline(always)]
            |index| [self.density_along(m.at(index))],
        );
    }

    /// [`sample`](Self::sample) for a block of uniform numbers, as
    /// [`Brdf::eval_block`](crate::Brdf::eval_block): the components of `h` fill the first three
    /// planes.
    #[inline(never)]
    fn sample_block(&self, uniforms: UniformBlock<'_, T>, h: &mut [Plane<T>; 4]) {
        uniforms.numbers(
            h,
            #[inline(always)]
            |index| components(self.sample(uniforms.u(index))),
        );
    }

    /// [`sample_along`](Self::sample_along) for a block of uniform numbers.
    #[doc(hidden)]
    #[inline(never)]
    fn sample_along_block(&self, uniforms: UniformBlock<'_, T>, h: &mut [Plane<T>; 4]) {
        uniforms.numbers(
            h,
            #[inline(always)]
            |index| components(self.sample_along(uniforms.u(index))),
        );
    }

    /// [`density`](Self::density) for many directions, bit for bit, at the speed of SIMD code: see
    /// [`batch`](crate::batch).
    ///
    /// # Errors
    /// If slices differ in length.
    fn density_batch(&self, h: Directions<'_, T>, densities: &mut [T]) -> Result<(), BatchError> {
        let output = Numbers(densities, "densities");
        run(Normals(h), output, &mut |h, _, densities| {
            self.density_block(h, densities);
            Ok(())
        })
    }
}

/// A normal, and a number without meaning beside it.
#[inline(always)]
fn components<T: Real>(h: T::Vec3) -> [T; 4] {
    [h.x(), h.y(), h.z(), T::zero()]
}

/// A distribution for which Smith's shadowing is known in closed form.
#[doc(alias("Lambda"))]
pub trait Smith<T: Real = f32>: Distribution<T> {
    /// Λ(w) cosθ of a direction above the surface: what Smith's Λ (the ratio of hidden to visible
    /// projected facet area) becomes when multiplied by N·w. Stays finite at grazing.
    fn lambda_cos(&self, w: T::Vec3) -> T;

    /// (1 + 2Λ(w)) cosθ of a direction above the surface: the projected area of all facets, those
    /// that face `w` and those that face away, ∫ |w·h| D(h) dω.
    #[inline(always)]
    fn projected_area(&self, w: T::Vec3) -> T {
        w.z().max(T::zero()) + T::lit(2.0) * self.lambda_cos(w)
    }

    /// Draws `h` with the density of the normals visible from `wo`, G₁(wo) (wo·h) D(h) / (N·wo),
    /// from two uniform numbers in [0, 1), taken as by [`Brdf::sample`](crate::Brdf::sample). It is
    /// a unit vector that does not lie below the surface. A `wo` that is no direction above the
    /// surface counts as the normal.
    #[doc(alias("VNDF", "visible normals"))]
    fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3;

    /// A vector of any length along [`sample_visible`](Self::sample_visible) of a viewer above the
    /// surface; any answer for another.
    #[doc(hidden)]
    #[inline(always)]
    fn sample_visible_along(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        self.sample_visible(wo, u)
    }

    /// [`projected_area`](Self::projected_area) for a block of directions.
    #[doc(hidden)]
    #[inline(never)]
    fn projected_area_block(&self, w: DirectionBlock<'_, T>, areas: &mut Plane<T>) {
        w.numbers(
            array::from_mut(areas),
            #[inline(always)]
            |index| [self.projected_area(w.at(index))],
        );
    }

    /// [`sample_visible`](Self::sample_visible) for a block of viewers, as
    /// [`Distribution::sample_block`], but of any length.
    #[inline(never)]
    fn sample_visible_block(&self, draws: DrawBlock<'_, T>, h: &mut [Plane<T>; 4]) {
        draws.numbers(
            h,
            #[inline(always)]
            |index| components(self.sample_visible_along(draws.wo(index), draws.u(index))),
        );
    }
}

macro_rules! forward {
    ($pointer:ty) => {
        impl<T: Real, D: Distribution<T> + ?Sized> Distribution<T> for $pointer {
            #[inline(always)]
            fn density(&self, h: T::Vec3) -> T {
                (**self).density(h)
            }
            #[inline(always)]
            fn density_along(&self, m: T::Vec3) -> T {
                (**self).density_along(m)
            }
            #[inline(always)]
            fn sample(&self, u: [T; 2]) -> T::Vec3 {
                (**self).sample(u)
            }
            #[inline(always)]
            fn sample_along(&self, u: [T; 2]) -> T::Vec3 {
                (**self).sample_along(u)
            }
            fn spreads(&self) -> Option<Spreads<T>> {
                (**self).spreads()
            }
            fn density_block(&self, h: DirectionBlock<'_, T>, densities: &mut Plane<T>) {
                (**self).density_block(h, densities);
            }
            fn density_along_block(&self, m: DirectionBlock<'_, T>, densities: &mut Plane<T>) {
                (**self).density_along_block(m, densities);
            }
            fn sample_block(&self, uniforms: UniformBlock<'_, T>, h: &mut [Plane<T>; 4]) {
                (**self).sample_block(uniforms, h);
            }
            fn sample_along_block(&self, uniforms: UniformBlock<'_, T>, h: &mut [Plane<T>; 4]) {
                (**self).sample_along_block(uniforms, h);
            }
        }

        impl<T: Real, D: Smith<T> + ?Sized> Smith<T> for $pointer {
            #[inline(always)]
            fn lambda_cos(&self, w: T::Vec3) -> T {
                (**self).lambda_cos(w)
            }
            #[inline(always)]
            fn projected_area(&self, w: T::Vec3) -> T {
                (**self).projected_area(w)
            }
            #[inline(always)]
            fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
                (**self).sample_visible(wo, u)
            }
            #[inline(always)]
            fn sample_visible_along(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
                (**self).sample_visible_along(wo, u)
            }
            fn projected_area_block(&self, w: DirectionBlock<'_, T>, areas: &mut Plane<T>) {
                (**self).projected_area_block(w, areas);
            }
            fn sample_visible_block(&self, draws: DrawBlock<'_, T>, h: &mut [Plane<T>; 4]) {
                (**self).sample_visible_block(draws, h);
            }
        }
    };
}
forward!(Arc<D>);
forward!(Box<D>);
forward!(&D);
