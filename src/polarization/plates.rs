use super::complex::Complex;
use super::interface::Interface;
use super::mueller::Mueller;
use super::polarized::Polarized;
use crate::error::{ParameterError, Range, range};
use crate::real::Real;

/// The most plates of a pile.
pub const MAX_PLATES: u32 = 1 << 20;

/// A pile of equal plane plates in air, too thick or too uneven for interference: a window pane, a
/// polariser of glass plates.
///
/// # Formula
/// For each polarisation, with R₁ and T₁ = 1 − R₁ of one surface and t = e^(−a/cosθ₂):
/// ```text
/// R = R₁ + T₁² R₁ t²/(1 − R₁² t²)      T = T₁² t/(1 − R₁² t²)          (one plate)
/// R_ab = R_a + T_a² R_b/(1 − R_a R_b)  T_ab = T_a T_b/(1 − R_a R_b)    (a over b)
/// ```
/// All orders add as intensities, and each keeps its polarisation. What happens to U and V is the
/// same series with r_s r_p in the place of R₁ and √(T_s T_p) in the place of T₁, so that a pile
/// depolarises.
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | n | `index` | index of the plates | 10⁻⁴ … 10⁴ |
/// | m | `count` | number of plates | 1 … 2²⁰ |
/// | a | `absorption` | 4πk d/λ, the absorption exponent of one plate along its normal | 0 … 10⁴ |
///
/// # Energy
/// R + T = 1 to 10⁻¹³ without absorption. m transparent plates reflect 2mR₁/(1 + (2m − 1)R₁).
///
/// # Limits
/// The surfaces reflect as those of a transparent medium, which leaves out O(k²).
///
/// # Sources
/// G. G. Stokes, *On the intensity of the light reflected from or transmitted through a pile of
/// plates*, Proc. R. Soc. 11, 1862, doi:10.1098/rspl.1860.0119.
///
/// ```
/// use brdf::polarization::Plates;
///
/// // Eight panes at Brewster's angle.
/// let pile = Plates::new(1.5_f64, 8, 0.0)?;
/// let passed = pile.at(brdf::brewster_angle(1.0, 1.5).cos()).transmittance;
/// let polarization = (passed.p - passed.s) / (passed.p + passed.s);
/// assert!((polarization - 0.58139535).abs() < 1e-8);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plates<T = f32> {
    surface: Interface<T>,
    index: T,
    count: u32,
    absorption: T,
}

/// What a pile of plates reflects and transmits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incoherent<T> {
    /// R_s and R_p.
    pub reflectance: Polarized<T>,
    /// T_s and T_p.
    pub transmittance: Polarized<T>,
    /// What is left of U and of V by reflection, which turns the sign of V and U, and by
    /// transmission.
    pub mixed: [T; 2],
}

impl<T: Real> Plates<T> {
    /// A pile of `count` plates.
    ///
    /// # Errors
    /// If `index` is not in 10⁻⁴ … 10⁴, `count` not in 1 … 2²⁰ or `absorption` not in 0 … 10⁴.
    pub fn new(index: T, count: u32, absorption: T) -> Result<Self, ParameterError> {
        range::ETA.check::<T, _>("index", index)?;
        Range::new(1.0, f64::from(MAX_PLATES)).check("count", f64::from(count))?;
        range::K.check::<T, _>("absorption", absorption)?;
        let surface = Interface::between(Complex::real(T::one()), Complex::real(index));
        Ok(Self { surface, index, count, absorption })
    }

    /// What they do at the given cosine of the angle of incidence, of which the sign is ignored.
    #[must_use]
    pub fn at(&self, cos_theta: T) -> Incoherent<T> {
        let (zero, one) = (T::zero(), T::one());
        let surface = self.surface.amplitudes(cos_theta);
        let (r, t) = (surface.reflectance(), surface.transmittance);
        let cos = cos_theta.abs().min(one);
        let sin = (one - cos) * (one + cos);
        // cos²θ₂; not positive where the plate reflects all that arrives.
        let cos_squared = one - sin / self.index.squared();
        let enters = cos_squared.gt(zero);
        let cos = T::select(enters, cos_squared, one).sqrt();
        let through = (-(self.absorption / cos)).exp();
        let pile = |r: T, t: T| Slab::plate(r, t, through).pile(self.count);
        let (s, p) = (pile(r.s, t.s), pile(r.p, t.p));
        let both = surface.r.s * surface.r.p.conj();
        // t_s t_p* with the power factor that both share.
        let root = surface.t.s * surface.t.p.conj();
        let factor = t.s / surface.t.s.norm_squared().max(T::lit(1e-37));
        let mixed = pile(both.re, root.re * factor);
        Incoherent {
            reflectance: Polarized { s: s.reflected, p: p.reflected },
            transmittance: Polarized { s: s.passed, p: p.passed },
            mixed: [mixed.reflected, mixed.passed],
        }
    }
}

impl<T: Real> Incoherent<T> {
    /// The Mueller matrix of the reflection.
    #[must_use]
    pub fn mueller_reflection(&self) -> Mueller<T> {
        diagonal_blocks(self.reflectance, self.mixed[0])
    }

    /// The Mueller matrix of the transmission.
    #[must_use]
    pub fn mueller_transmission(&self) -> Mueller<T> {
        diagonal_blocks(self.transmittance, self.mixed[1])
    }
}

fn diagonal_blocks<T: Real>(power: Polarized<T>, mixed: T) -> Mueller<T> {
    let zero = T::zero();
    let (a, b) = (power.unpolarized(), (power.s - power.p) * T::lit(0.5));
    Mueller {
        rows: [
            [a, b, zero, zero],
            [b, a, zero, zero],
            [zero, zero, mixed, zero],
            [zero, zero, zero, mixed],
        ],
    }
}

/// What a slab reflects and transmits of one component of the light, the same from both sides.
#[derive(Clone, Copy)]
struct Slab<T> {
    reflected: T,
    passed: T,
}

impl<T: Real> Slab<T> {
    /// Two surfaces and what is between them.
    fn plate(r: T, t: T, through: T) -> Self {
        let inside = r * through;
        let turns = t * through * quotient(T::one(), inside * inside);
        Self { reflected: r + t * inside * turns, passed: t * turns }
    }

    /// This slab over another one.
    fn over(self, below: Self) -> Self {
        let turns = self.passed * quotient(T::one(), self.reflected * below.reflected);
        Self {
            reflected: self.reflected + self.passed * below.reflected * turns,
            passed: turns * below.passed,
        }
    }

    /// This slab so many times, by doubling.
    fn pile(self, count: u32) -> Self {
        let (mut pile, mut double, mut rest) = (None, self, count);
        while rest > 0 {
            if rest & 1 == 1 {
                pile = Some(pile.map_or(double, |pile: Self| double.over(pile)));
            }
            double = double.over(double);
            rest >>= 1;
        }
        pile.unwrap_or(self)
    }
}

/// 1/(one − part), 0 where nothing is left: there nothing has passed either.
fn quotient<T: Real>(one: T, part: T) -> T {
    let rest = one - part;
    let some = rest.gt(T::zero());
    (one / T::select(some, rest, one)).only_where(some)
}
