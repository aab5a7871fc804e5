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
/// R + T = 1 to 10⁻¹³ without absorption. m transparent plates reflect 2mR₁/(1 + (2m − 1)R₁). Plates
/// with n = 1 have no surfaces: R = 0 and T = e^(−ma/cosθ), at grazing 1 if a is 0 and else 0.
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
/// let passed = pile.at(brdf::brewster_angle(1.0_f64, 1.5).cos()).transmittance;
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
        // cos²θ₂; not positive where the plate reflects all that arrives, or does not refract and the
        // way through it is endless. A root has no derivative at 0.
        let cos = (one - sin / self.index.squared()).max(T::lit(1e-30)).sqrt();
        let exponent = -(self.absorption / cos);
        let between = Slab { reflected: zero, passed: exponent.exp(), kept: -exponent.exp_m1() };
        let pile = |reflected: T, passed: T, kept: T| {
            Slab { reflected, passed, kept }.plate(between).pile(self.count)
        };
        let (s, p) = (pile(r.s, t.s, zero), pile(r.p, t.p, zero));
        // r_s r_p, of which the sign is the same for all plates, and √(T_s T_p).
        let product = (surface.r.s * surface.r.p.conj()).re;
        let both = (surface.t.s * surface.t.p.conj()).re;
        let factor = t.s / surface.t.s.norm_squared().max(T::lit(1e-37));
        let (size, both) = (product.abs(), both * factor);
        let mixed = pile(size, both, (one - size - both).max(zero));
        Incoherent {
            reflectance: Polarized { s: s.reflected, p: p.reflected },
            transmittance: Polarized { s: s.passed, p: p.passed },
            mixed: [mixed.reflected.copysign(product), mixed.passed],
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

/// What becomes of one component of the light in a slab, the same from both sides. The three add up to
/// 1; to know each of them by itself keeps the digits of what remains of a pile of many plates.
#[derive(Clone, Copy)]
struct Slab<T> {
    reflected: T,
    passed: T,
    /// What is neither reflected nor passed.
    kept: T,
}

impl<T: Real> Slab<T> {
    /// Two surfaces like this one and what is between them, which does not reflect.
    fn plate(self, between: Self) -> Self {
        let Self { reflected: r, passed: t, kept } = self;
        let inside = r * between.passed;
        // 1 − inside, of positive terms.
        let rest = t + kept + r * between.kept;
        let entered = quotient(t, rest * (T::one() + inside));
        Self {
            reflected: r + entered * inside * between.passed * t,
            passed: entered * between.passed * t,
            kept: kept + quotient(t, rest) * (between.kept + kept * between.passed),
        }
    }

    /// This slab over another one.
    fn over(self, below: Self) -> Self {
        // 1 − R_a R_b, of positive terms.
        let rest = self.passed + self.kept + self.reflected * (below.passed + below.kept);
        let entered = quotient(self.passed, rest);
        Self {
            reflected: self.reflected + entered * below.reflected * self.passed,
            passed: entered * below.passed,
            kept: self.kept + entered * (below.kept + below.reflected * self.kept),
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

/// What enters over what does not come back; 0 where nothing enters.
fn quotient<T: Real>(part: T, rest: T) -> T {
    let some = rest.gt(T::zero());
    (part / T::select(some, rest, T::one())).only_where(some)
}
