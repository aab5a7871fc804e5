use alloc::vec::Vec;
use core::marker::PhantomData;

use super::amplitudes::{PolarizedFresnel, by_channel, channel};
use super::term::Fresnel;
use crate::block::{Block, ColorBlock, CosineBlock};
use crate::error::{ParameterError, range};
use crate::parameter::{Kind, Parameter, Preset, model};
use crate::polarization::{Complex, Layer, Layers, Polarized};
use crate::real::{Color, Lift, Real};

/// The reflectance of a stack of coherent films for unpolarised light: soap, oil, a tempered metal,
/// the coating of a lens.
///
/// # Formula
/// ```text
/// F = (|r_s|² + |r_p|²)/2
/// ```
/// with the amplitudes of [`Layers`], one stack for each channel at the wavelength of the channel.
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | n₀ | `outside` | complex index of the medium that the light comes from | n 10⁻⁴ … 10⁴, k 0 … 10⁴ |
/// | n_j | `layers[j].index` | complex index of a layer | the same |
/// | d_j | `layers[j].thickness` | its thickness, nm | 0 … 10⁹ |
/// | n_N | `substrate` | complex index behind the layers | as n₀ |
/// | λ | `wavelength` | wavelength of each channel in vacuum, nm | 1 … 10⁹ |
/// | u | `cos_theta` | cosine of the angle of incidence | −1 … 1, the sign is ignored |
///
/// There are at most 64 layers.
///
/// # Energy
/// Reciprocal. Conserving where the outside is transparent; an absorbing one may give more than 1 next
/// to total reflection.
///
/// # Colour
/// Three wavelengths sample a spectrum that a thick film makes oscillate fast: from about 1 µm
/// on, colours are those of a surface lit by three laser lines. A [`Spectrum`](crate::Spectrum) as the
/// colour and an [`Observer`](crate::Observer) are exact; [`BelcourBarla`](super::BelcourBarla) is the
/// integral over the spectrum, approximated.
///
/// # Accuracy
/// The average is the default quadrature: exact to rounding up to 600 nm of film (n = 1.33 in air, 2.4 on
/// a metal), off by 10⁻¹⁰ at 1 µm, 10⁻⁶ at 2 µm, 10⁻³ at 5 µm and 10⁻² at 10 µm, where it cannot follow
/// the fringes. For `f32` see [`Layers`].
///
/// # Sources
/// M. Born, E. Wolf, *Principles of Optics*, section 1.6.
///
/// ```
/// use brdf::polarization::{Complex, Layer};
/// use brdf::{Beckmann, CookTorrance, Fresnel, Stack};
/// use glam::DVec3;
///
/// // 40 nm of oxide on titanium: anodised to a dark blue.
/// let gray = |n: f64, k: f64| Complex::new(DVec3::splat(n), DVec3::splat(k));
/// let oxide = Layer { index: gray(2.4, 0.0), thickness: 40.0 };
/// let lines = DVec3::new(650.0, 550.0, 450.0);
/// let titanium = Stack::new(gray(1.0, 0.0), &[oxide], gray(2.6, 3.4), lines)?;
/// let normal = titanium.reflectance(1.0);
/// assert!(normal.z > 1.2 * normal.y);
/// let sphere = CookTorrance::new(Beckmann::new(0.2)?, titanium);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Stack<C = glam::Vec3, T = f32> {
    /// The stack at the wavelength of each channel.
    channels: Vec<Layers<T>>,
    color: PhantomData<C>,
}

impl<C, T> Stack<C, T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        Parameter::new("outside", "n₀", "index in front of the layers", MEDIUM)
            .or(Preset::Number(1.0)),
        Parameter::new("layers", "n_j, d_j", "the layers", Kind::List(Self::LAYER)),
        Parameter::new("substrate", "n_N", "index behind the layers", MEDIUM),
        model!(@row wavelength: C, WAVELENGTH, "λ", "wavelength of each channel in vacuum, nm")
            .or(Preset::Color([650.0, 550.0, 450.0])),
    ];

    /// The table of the parameters of a layer.
    pub const LAYER: &'static [Parameter] = &[
        Parameter::new("index", "n_j", "index of the layer", MEDIUM),
        model!(@row thickness: T, THICKNESS, "d_j", "thickness of the layer, nm"),
    ];
}

const MEDIUM: Kind = Kind::Medium(range::ETA, range::K);

impl<T: Real, C: Color<T>> Stack<C, T> {
    /// Layers in the order in which the light meets them, with their indices per channel, at one
    /// wavelength in nanometres for each channel.
    ///
    /// # Errors
    /// If a parameter is not in its range, or there are more than 64 layers. The error of a layer has
    /// its [position](ParameterError::position).
    pub fn new(
        outside: Complex<C>,
        layers: &[Layer<C, T>],
        substrate: Complex<C>,
        wavelength: C,
    ) -> Result<Self, ParameterError> {
        let at = |index: Complex<C>, place: usize| {
            Complex::new(channel(index.re, place), channel(index.im, place))
        };
        let stack = |place: usize| {
            let layer =
                |it: &Layer<C, T>| Layer { index: at(it.index, place), thickness: it.thickness };
            // What is too much is an error, and not copied.
            let some = layers.iter().take(crate::polarization::MAX_LAYERS + 1);
            let layers: Vec<Layer<T>> = some.map(layer).collect();
            let wavelength = channel(wavelength, place);
            Layers::new(at(outside, place), &layers, at(substrate, place), wavelength)
        };
        let count = wavelength.channels().as_ref().len();
        let channels = (0..count).map(stack).collect::<Result<_, _>>()?;
        Ok(Self { channels, color: PhantomData })
    }

    /// The stack at the wavelength of each channel.
    #[must_use]
    pub fn channels(&self) -> &[Layers<T>] {
        &self.channels
    }
}

impl<T: Real, C: Color<T>> Fresnel<T> for Stack<C, T> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        let of = |place: usize| match self.channels.get(place) {
            Some(layers) => layers.reflectance(cos_theta),
            None => T::zero(),
        };
        C::from_channels(C::by_channel(of))
    }

    fn reflectance_block(&self, cosines: CosineBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        for (layers, values) in self.channels.iter().zip(values.as_mut()) {
            layers.reflectance_block(cosines, values);
        }
    }

    fn reflected_block(&self, mirrored: Block<'_, T, 2>, values: &mut ColorBlock<T, C>) {
        let [cos, scale] = mirrored.planes;
        self.reflectance_block(mirrored.of([cos]), values);
        for values in values.as_mut() {
            mirrored.changed(
                core::array::from_mut(values),
                &mut [],
                #[inline(always)]
                |index, [value]| ([(value * scale[index]).min(T::max_finite())], []),
            );
        }
    }
}

impl<T: Real, C: Color<T>> PolarizedFresnel<T> for Stack<C, T> {
    fn amplitudes(&self, cos_theta: T) -> Polarized<Complex<C>> {
        let zero = Complex::real(T::zero());
        by_channel(|place| match self.channels.get(place) {
            Some(layers) => layers.amplitudes(cos_theta).r,
            None => Polarized { s: zero, p: zero },
        })
    }
}

impl<T: Real, C: Color<T>> Lift<T> for Stack<C, T> {
    type Over<U: Real> = Stack<C::Over<U>, U>;

    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> Self::Over<U> {
        let channels = self.channels.iter().map(|layers| layers.lift(lift)).collect();
        Stack { channels, color: PhantomData }
    }
}
