use alloc::vec::Vec;

use super::amplitudes::Amplitudes;
use super::complex::Complex;
use super::medium::{Incidence, Medium, check_index};
use super::wave::Wave;
use crate::block::{BLOCK, CosineBlock, Plane};
use crate::error::{ParameterError, Range, range};
use crate::real::{Lift, Real};

/// The most layers of a stack.
pub const MAX_LAYERS: usize = 64;

/// A plane layer between two others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer<V = f32, T = V> {
    /// The complex index n + ik, a number or one for each channel of a colour.
    pub index: Complex<V>,
    /// The thickness in nanometres.
    pub thickness: T,
}

/// A stack of plane layers between two half spaces at one wavelength, coherent: films of soap and
/// oil, antireflection coatings, oxides on metals, interference filters.
///
/// # Formula
/// From the substrate up, with q_j = √(n_j² − n₀² sin²θ) of positive Re + Im and e = e^(2πi q d/λ) of
/// the layer that the boundary is in front of:
/// ```text
/// r ← (ρ + r e²)/(1 + ρ r e²)    t ← τ e t/(1 + ρ r e²)
/// T_s = |t_s|² Re q_N/Re q₀      T_p = |t_p|² Re(n_N* q_N/n_N)/Re(n₀* q₀/n₀)
/// ```
/// ρ and τ are the amplitudes of the single boundary, as of an [`Interface`](super::Interface).
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | n₀ | `outside` | complex index of the medium that the light comes from | n 10⁻⁴ … 10⁴, k 0 … 10⁴ |
/// | n_j | `index` | complex index of a layer | the same |
/// | d | `thickness` | its thickness, nm | 0 … 10⁹ |
/// | n_N | `substrate` | complex index of the last medium | as n₀ |
/// | λ | `wavelength` | wavelength in vacuum, nm | 1 … 10⁹ |
///
/// There are at most [`MAX_LAYERS`] layers. Without any it is the bare interface, and so it is with
/// layers of thickness 0.
///
/// # Energy
/// Passive: R + T ≤ 1 where the first medium is transparent, and 1 to 10⁻¹³ where all are. See
/// [`Interface`](super::Interface) for an absorbing first medium.
///
/// # Accuracy
/// e decays in an absorbing layer, so that a layer of any thickness is stable, unlike products of
/// matrices. In `f32` the phase 4π q d/λ carries the rounding of its own size.
///
/// # Sources
/// G. B. Airy 1833; P. Rouard, *Études des propriétés optiques des lames métalliques très minces*,
/// Annales de Physique 1937. M. Born, E. Wolf, *Principles of Optics*, section 1.6.
///
/// ```
/// use brdf::polarization::{Complex, Layer, Layers};
///
/// // A quarter of a wavelength of magnesium fluoride on glass.
/// let coating = Layer { index: Complex::real(1.38_f64), thickness: 99.6 };
/// let (air, glass) = (Complex::real(1.0), Complex::real(1.52));
/// let coated = Layers::new(air, &[coating], glass, 550.0)?.amplitudes(1.0);
/// assert!((coated.reflectance().s - 0.01260).abs() < 1e-4);
/// assert!((coated.reflectance().s + coated.transmittance.s - 1.0).abs() < 1e-15);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Layers<T = f32> {
    outside: Complex<T>,
    films: Vec<Film<T>>,
    substrate: Medium<T>,
}

/// A medium of a certain thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Film<T> {
    medium: Medium<T>,
    /// d/λ.
    waves: T,
}

/// Whether there may be so many layers.
pub(crate) fn check_count(layers: usize) -> Result<(), ParameterError> {
    Range::new(0.0, MAX_LAYERS as f64).check("number of layers", layers as f64)
}

impl<T: Real> Layers<T> {
    /// Layers in the order in which the light meets them, at a wavelength in nanometres.
    ///
    /// # Errors
    /// If a parameter is not in its range, or there are more than 64 layers. The error of a layer
    /// has its [position](ParameterError::position).
    pub fn new(
        outside: Complex<T>,
        layers: &[Layer<T>],
        substrate: Complex<T>,
        wavelength: T,
    ) -> Result<Self, ParameterError> {
        check_index("outside", outside)?;
        check_count(layers.len())?;
        for (position, layer) in layers.iter().enumerate() {
            check_index("index", layer.index)
                .and_then(|()| range::THICKNESS.check::<T, _>("thickness", layer.thickness))
                .map_err(|error| error.at(position))?;
        }
        check_index("substrate", substrate)?;
        range::WAVELENGTH.check::<T, _>("wavelength", wavelength)?;
        let mut front = outside;
        let mut behind = |index| Medium::new(outside, core::mem::replace(&mut front, index), index);
        let film = |layer: &Layer<T>| Film {
            medium: behind(layer.index),
            waves: layer.thickness / wavelength,
        };
        let films = layers.iter().map(film).collect();
        Ok(Self { outside, films, substrate: behind(substrate) })
    }

    /// All amplitudes at the given cosine of the angle of incidence, of which the sign is ignored.
    #[must_use]
    pub fn amplitudes(&self, cos_theta: T) -> Amplitudes<T> {
        let incidence = Incidence::new(self.outside, cos_theta);
        let mut behind = &self.substrate;
        let bottom = behind.normal(&incidence);
        let mut wave = Wave::leaving(bottom);
        for film in self.films.iter().rev() {
            let normal = film.medium.normal(&incidence);
            wave = wave.above(&incidence, behind, film.medium.index, normal).across(film.waves);
            behind = &film.medium;
        }
        wave.above(&incidence, behind, self.outside, self.outside * incidence.cos).amplitudes(
            &incidence,
            self.outside,
            self.substrate.index,
            bottom,
        )
    }

    /// (R_s + R_p)/2 at the given cosine of the angle of incidence, of which the sign is ignored.
    #[inline(always)]
    #[must_use]
    pub fn reflectance(&self, cos_theta: T) -> T {
        let incidence = Incidence::new(self.outside, cos_theta);
        let mut behind = &self.substrate;
        let mut wave = Wave::leaving(behind.normal(&incidence));
        for film in self.films.iter().rev() {
            let normal = film.medium.normal(&incidence);
            wave = wave.above(&incidence, behind, film.medium.index, normal).across(film.waves);
            behind = &film.medium;
        }
        self.reflected(&incidence, behind, wave)
    }

    /// The reflectance of the whole, from the wave below the first boundary.
    #[inline(always)]
    fn reflected(&self, incidence: &Incidence<T>, first: &Medium<T>, wave: Wave<T>) -> T {
        let r = wave.above(incidence, first, self.outside, self.outside * incidence.cos).r;
        let sum = r.map(Complex::norm_squared).unpolarized();
        // At most 1, but for rounding, where the light comes from a transparent medium.
        let transparent = self.outside.im.le(T::zero());
        T::select(transparent, sum.min(T::one()), sum.min(T::max_finite()))
    }

    /// [`reflectance`](Self::reflectance) for a block of cosines, film by film: each is a loop over
    /// the block.
    pub(crate) fn reflectance_block(&self, cosines: CosineBlock<'_, T>, values: &mut Plane<T>) {
        let mut behind = &self.substrate;
        let mut planes = [[T::zero(); BLOCK]; 6];
        for (place, film) in self.films.iter().rev().enumerate() {
            let first = place == 0;
            cosines.changed(
                &mut planes,
                &mut [],
                #[inline(always)]
                |index, before| {
                    let incidence = Incidence::new(self.outside, cosines.cos(index));
                    let below = if first {
                        Wave::leaving(behind.normal(&incidence))
                    } else {
                        Wave::of_planes(before)
                    };
                    let normal = film.medium.normal(&incidence);
                    let wave = below.above(&incidence, behind, film.medium.index, normal);
                    (wave.across(film.waves).planes(), [])
                },
            );
            behind = &film.medium;
        }
        cosines.numbers(
            core::array::from_mut(values),
            #[inline(always)]
            |index| {
                let incidence = Incidence::new(self.outside, cosines.cos(index));
                let below = if self.films.is_empty() {
                    Wave::leaving(behind.normal(&incidence))
                } else {
                    Wave::of_planes(core::array::from_fn(|plane| planes[plane][index]))
                };
                [self.reflected(&incidence, behind, below)]
            },
        );
    }
}

impl<T: Real> Lift<T> for Layers<T> {
    type Over<U: Real> = Layers<U>;

    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> Layers<U> {
        let film =
            |film: &Film<T>| Film { medium: film.medium.lift(lift), waves: lift(film.waves) };
        Layers {
            outside: self.outside.lift(lift),
            films: self.films.iter().map(film).collect(),
            substrate: self.substrate.lift(lift),
        }
    }
}
