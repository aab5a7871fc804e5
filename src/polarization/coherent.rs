use alloc::vec::Vec;

use super::amplitudes::Amplitudes;
use super::complex::Complex;
use super::medium::{Incidence, Medium, check_index};
use super::wave::{Wave, reflectance, reflected};
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
/// layers of thickness 0. Where all media are the same there is no boundary: nothing is reflected at any
/// angle, grazing included, and the layers are what the light passes.
///
/// # Energy
/// Passive: R + T ≤ 1 where the first medium is transparent, and 1 to 10⁻¹³ where all are. See
/// [`Interface`](super::Interface) for an absorbing first medium.
///
/// # Accuracy
/// e decays in an absorbing layer, so that a layer of any thickness is stable, unlike products of
/// matrices. In `f64` R + T = 1 to 10⁻¹⁴ with a few transparent layers; resonances of up to 64 layers make
/// more of rounding, up to some 10⁻¹² in random stacks.
///
/// In `f32` the phase 4π q d/λ carries the rounding of its own size. R of one film is within 2·10⁻⁶ of
/// `f64` for d ≤ λ on glass and in air (cosθ ≥ 0.1), within 4·10⁻⁶ on metals with k up to 5, and grows
/// from there with d, faster where both surfaces reflect much: 10⁻⁵ at ten wavelengths of an oxide on a metal. Eight quarter-wave pairs
/// are at 4·10⁻⁶, 32 pairs at 10⁻⁴.
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
        let incidence = self.incidence(cos_theta);
        let (outside, front) = (self.outside, self.outside * incidence.cos);
        let bottom = self.substrate.normal(&incidence);
        let wave = match self.below(&incidence) {
            Some((first, wave)) => wave.above(&incidence, first, outside, front),
            None => Wave::bare(&incidence, &self.substrate, bottom, outside, front),
        };
        wave.amplitudes(&incidence, outside, self.substrate.index, bottom)
    }

    /// (R_s + R_p)/2 at the given cosine of the angle of incidence, of which the sign is ignored.
    #[inline(always)]
    #[must_use]
    pub fn reflectance(&self, cos_theta: T) -> T {
        let incidence = self.incidence(cos_theta);
        if let Some(film) = self.clear_film() {
            return self.over_clear(film, &incidence);
        }
        match self.below(&incidence) {
            Some((first, wave)) => self.whole(&incidence, first, wave),
            None => self.bare(&incidence),
        }
    }

    /// [`reflectance`](Self::reflectance) for a block of cosines, film by film: each is a loop over
    /// the block.
    pub(crate) fn reflectance_block(&self, cosines: CosineBlock<'_, T>, values: &mut Plane<T>) {
        let values = core::array::from_mut(values);
        let Some((last, films)) = self.films.split_last() else {
            return cosines.numbers(
                values,
                #[inline(always)]
                |index| [self.bare(&self.incidence(cosines.cos(index)))],
            );
        };
        if let Some(film) = self.clear_film() {
            return cosines.numbers(
                values,
                #[inline(always)]
                |index| [self.over_clear(film, &self.incidence(cosines.cos(index)))],
            );
        }
        if films.is_empty() {
            return cosines.numbers(
                values,
                #[inline(always)]
                |index| {
                    let incidence = self.incidence(cosines.cos(index));
                    [self.whole(&incidence, &last.medium, self.bottom(last, &incidence))]
                },
            );
        }
        let mut planes = [[T::zero(); BLOCK]; 6];
        cosines.numbers(
            &mut planes,
            #[inline(always)]
            |index| self.bottom(last, &self.incidence(cosines.cos(index))).planes(),
        );
        let mut behind = &last.medium;
        for film in films.iter().rev() {
            cosines.changed(
                &mut planes,
                &mut [],
                #[inline(always)]
                |index, below| {
                    (
                        film.over(
                            behind,
                            Wave::of_planes(below),
                            &self.incidence(cosines.cos(index)),
                        )
                        .planes(),
                        [],
                    )
                },
            );
            behind = &film.medium;
        }
        cosines.numbers(
            values,
            #[inline(always)]
            |index| {
                let below = Wave::of_planes(core::array::from_fn(
                    #[inline(always)]
                    |plane| planes[plane][index],
                ));
                [self.whole(&self.incidence(cosines.cos(index)), behind, below)]
            },
        );
    }

    #[inline(always)]
    fn incidence(&self, cos_theta: T) -> Incidence<T> {
        Incidence::new(self.outside, cos_theta)
    }

    /// The medium of the first layer and the wave at its top, if there is a layer.
    #[inline(always)]
    fn below(&self, incidence: &Incidence<T>) -> Option<(&Medium<T>, Wave<T>)> {
        let (last, films) = self.films.split_last()?;
        let start = (&last.medium, self.bottom(last, incidence));
        Some(films.iter().rev().fold(start, |(behind, below), film| {
            (&film.medium, film.over(behind, below, incidence))
        }))
    }

    /// The wave at the top of the last layer.
    #[inline(always)]
    fn bottom(&self, last: &Film<T>, incidence: &Incidence<T>) -> Wave<T> {
        let (normal, bottom) = (last.medium.normal(incidence), self.substrate.normal(incidence));
        Wave::bare(incidence, &self.substrate, bottom, last.medium.index, normal).across(last.waves)
    }

    /// The reflectance of the whole, from the wave at the top of the first layer.
    #[inline(always)]
    fn whole(&self, incidence: &Incidence<T>, first: &Medium<T>, wave: Wave<T>) -> T {
        let (outside, front) = (self.outside, self.outside * incidence.cos);
        self.bounded(wave.reflectance_above(incidence, first, outside, front))
    }

    /// The one film, where nothing absorbs or reflects totally.
    #[inline(always)]
    fn clear_film(&self) -> Option<&Film<T>> {
        let [film] = self.films.as_slice() else { return None };
        let clear = film.medium.is_clear(self.outside) && self.substrate.is_clear(self.outside);
        clear.then_some(film)
    }

    /// The reflectance of the whole with this [clear film](Self::clear_film): all but its phase is real.
    #[inline(always)]
    fn over_clear(&self, film: &Film<T>, incidence: &Incidence<T>) -> T {
        let Film { medium, waves } = film;
        let tangential = incidence.tangential_squared.re;
        let [normal, bottom] = [medium, &self.substrate].map(
            #[inline(always)]
            |medium| medium.clear_normal(incidence),
        );
        let (below, _) = reflected(self.substrate.contrast.re, tangential, [normal, bottom]);
        let turns = normal * *waves;
        let round_trip = Complex::from_turns(T::one(), turns + turns);
        let front = self.outside.re * incidence.cos;
        let (above, _) = reflected(medium.contrast.re, tangential, [front, normal]);
        let returned = below.map(
            #[inline(always)]
            |r| round_trip * r,
        );
        self.bounded(reflectance(above, returned))
    }

    /// The reflectance without any layer.
    #[inline(always)]
    fn bare(&self, incidence: &Incidence<T>) -> T {
        let (outside, front) = (self.outside, self.outside * incidence.cos);
        let bottom = self.substrate.normal(incidence);
        let wave = Wave::bare(incidence, &self.substrate, bottom, outside, front);
        self.bounded(wave.r.map(Complex::norm_squared).unpolarized())
    }

    /// At most 1, but for rounding, where the light comes from a transparent medium.
    #[inline(always)]
    fn bounded(&self, reflectance: T) -> T {
        let transparent = self.outside.im.le(T::zero());
        reflectance.min(T::select(transparent, T::one(), T::max_finite()))
    }
}

impl<T: Real> Film<T> {
    /// The wave at the top of this layer, from that at the top of the medium behind it.
    #[inline(always)]
    fn over(&self, behind: &Medium<T>, below: Wave<T>, incidence: &Incidence<T>) -> Wave<T> {
        let normal = self.medium.normal(incidence);
        below.above(incidence, behind, self.medium.index, normal).across(self.waves)
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
