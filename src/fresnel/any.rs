use super::amplitudes::PolarizedFresnel;
use super::belcour_barla::BelcourBarla;
use super::conductor::Conductor;
use super::constant::Constant;
use super::dielectric::Dielectric;
use super::f82::{F82, F82Tint};
use super::general_schlick::GeneralSchlick;
use super::gulbrandsen::Gulbrandsen;
use super::interpolation::{Cook, Hall};
use super::lazanyi::Lazanyi;
use super::schlick::Schlick;
use super::stack::Stack;
use super::term::Fresnel;
use crate::block::{Block, ColorBlock, CosineBlock};
use crate::polarization::{Complex, Polarized};
use crate::real::{Color, Real, call, members};

members! {
    ($) each
    /// Any Fresnel term of this crate, chosen at run time.
    ///
    /// One type for all of them: a surface of described parts is a single type too, and lives
    /// without a box. A call costs one `match`, a [batch](crate::batch) one for each block, and
    /// the answers have the bits of the term inside.
    ///
    /// ```
    /// use brdf::{AnyFresnel, Conductor, Fresnel, Schlick};
    /// use glam::Vec3;
    ///
    /// let terms: [AnyFresnel; 2] = [
    ///     Schlick::new(Vec3::splat(0.04))?.into(),
    ///     Conductor::new(Vec3::new(0.2, 1.0, 1.2), Vec3::new(3.7, 2.6, 2.4))?.into(),
    /// ];
    /// assert_eq!(terms[0].reflectance(1.0), Vec3::splat(0.04));
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub enum AnyFresnel[T: Real = f32, C: Color<T> = <T as Real>::Vec3][T: Real, C: Color<T>]
        AnyFresnel<T, C> => AnyFresnel<U, C::Over<U>>
    {
        /// The same reflectance at all angles.
        Constant(Constant<C>),
        /// A transparent medium.
        Dielectric(Dielectric<C>),
        /// An absorbing medium.
        Conductor(Conductor<C>),
        /// Schlick's approximation.
        Schlick(Schlick<C>),
        /// Schlick's approximation with a colour at the edge and an exponent.
        GeneralSchlick(GeneralSchlick<C, T>),
        /// Lazányi and Szirmay-Kalos' correction of it.
        Lazanyi(Lazanyi<C>),
        /// Hoffman's correction of it.
        F82(F82<C>),
        /// The same by a tint.
        F82Tint(F82Tint<C>),
        /// Gulbrandsen's metals for artists.
        Gulbrandsen(Gulbrandsen<C>),
        /// Hall's interpolation, driven by a transparent medium.
        Hall(Hall<C, Dielectric<T>>),
        /// Hall's interpolation, driven by an absorbing medium.
        HallOfConductor(Hall<C, Conductor<T>>),
        /// Cook's interpolation, driven by a transparent medium.
        Cook(Cook<C, Dielectric<T>>),
        /// Cook's interpolation, driven by an absorbing medium.
        CookOfConductor(Cook<C, Conductor<T>>),
        /// Coherent films.
        Stack(Stack<C, T>),
        /// A film seen in the light of the whole spectrum.
        BelcourBarla(BelcourBarla<C, T>),
    }
}

impl<T: Real, C: Color<T>> AnyFresnel<T, C> {
    /// r_s and r_p of a term that knows them, as [`PolarizedFresnel::amplitudes`]; `None` of the
    /// approximations.
    #[must_use]
    pub fn amplitudes(&self, cos_theta: T) -> Option<Polarized<Complex<C>>> {
        match self {
            Self::Dielectric(term) => Some(term.amplitudes(cos_theta)),
            Self::Conductor(term) => Some(term.amplitudes(cos_theta)),
            Self::Gulbrandsen(term) => Some(term.amplitudes(cos_theta)),
            Self::Stack(term) => Some(term.amplitudes(cos_theta)),
            _ => None,
        }
    }
}

impl<T: Real, C: Color<T>> Fresnel<T> for AnyFresnel<T, C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        each!(self, term => term.reflectance(cos_theta))
    }

    #[inline]
    fn reflected(&self, cos: T, scale: T) -> C {
        match self {
            // Shorter than a call.
            Self::Constant(term) => term.reflected(cos, scale),
            Self::Schlick(term) => term.reflected(cos, scale),
            _ => each!(self, term => call!(|| term.reflected(cos, scale))),
        }
    }

    fn average(&self) -> C {
        each!(self, term => term.average())
    }

    fn kinks(&self) -> Option<C> {
        each!(self, term => term.kinks())
    }

    fn reflectance_block(&self, cosines: CosineBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        each!(self, term => term.reflectance_block(cosines, values));
    }

    fn reflected_block(&self, mirrored: Block<'_, T, 2>, values: &mut ColorBlock<T, C>) {
        each!(self, term => term.reflected_block(mirrored, values));
    }
}
