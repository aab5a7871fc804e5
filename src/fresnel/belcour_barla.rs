use super::term::Fresnel;
use crate::block::{Block, ColorBlock};
use crate::colorimetry::xyz_to_linear_srgb;
use crate::error::{ParameterError, range};
use crate::parameter::{Kind, Parameter, model};
use crate::polarization::{Bounces, Complex, check_index};
use crate::real::{Color, Lift, Real, Vector, in_place};

/// The colour of a thin film integrated over the visible spectrum, by the approximation of Belcour and
/// Barla: no grain of three wavelengths, however thick the film.
///
/// # Formula
/// Per polarisation, averaged over both, with R₁₂ and R₂₃ of the two boundaries:
/// ```text
/// XYZ = C₀ Ŝ(0, 0) + 2 Σ_{m=1..3} C_m Ŝ(m𝒟, mφ)       𝒟 = 2 n₂ d cosθ₂    φ = arg r₂₁ + arg r₂₃
/// C₀ = R₁₂ + R*    C_m = (R* − T)(R₁₂R₂₃)^{m/2}        R* = T² R₂₃/(1 − R₁₂R₂₃)    T = 1 − R₁₂
/// Ŝ(𝒟, φ) = a cos(p w + φ) exp(−v w²)                  w = 2π 𝒟 [nm] 10⁻⁹
/// ```
/// a, p and v are fits to the integrals of the colour matching functions, with two terms for X. R = 1
/// where the film reflects all that arrives. RGB = M·XYZ/M·(1, 1, 1), channel by channel, M the matrix
/// from XYZ to linear sRGB: XYZ are those of a perfect reflector under equal energy, and white is (1,
/// 1, 1).
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | n₂ | `film` | index of the film | 10⁻⁴ … 10⁴ |
/// | d | `thickness` | its thickness, nm | 0 … 10⁹ |
/// | n₃ | `substrate` | complex index behind the film, at all wavelengths | n 10⁻⁴ … 10⁴, k 0 … 10⁴ |
/// | n₁ | `outside` | index in front of it | 10⁻⁴ … 10⁴ |
/// | u | `cos_theta` | cosine of the angle of incidence | −1 … 1, the sign is ignored |
///
/// # Energy
/// Reciprocal. The colours of films leave those that sRGB can show: [`reflectance`](Fresnel::reflectance)
/// is **not clamped** and has channels below 0 and above 1. Where it is a part of a surface, what is
/// below 0 counts as 0. White of C₀ = 1 has XYZ of 1.0005, 1.0002, 1.0011.
///
/// # Accuracy
/// The indices do not depend on the wavelength. The series leaves out m > 3, and the fits replace the colour
/// matching functions: against [`Layers`](crate::polarization::Layers) integrated over the spectrum X, Y
/// and Z are off by up to 0.014 for soap in air (0.001 in the mean), 0.019 for an oxide on titanium,
/// 0.024 for a film on gold, from 10 nm and up to 72°. Towards grazing thin films are off by more: soap of
/// 10 nm by 0.06 at 84°.
///
/// # Limits
/// A film of an index below that outside reflects all light beyond its own critical angle, however thin
/// it is; a real one lets the wave tunnel through to the substrate.
/// [`Layers`](crate::polarization::Layers) has that.
///
/// # Sources
/// L. Belcour, P. Barla, *A Practical Extension to Microfacet Theory for the Modeling of Varying
/// Iridescence*, ACM TOG 36(4), 2017, doi:10.1145/3072959.3073620. Their program takes the index of
/// the substrate as n(1 + iκ), with κ = k/n.
///
/// ```
/// use brdf::{BelcourBarla, Fresnel};
/// use glam::DVec3;
///
/// let soap: BelcourBarla<DVec3, f64> = BelcourBarla::new(1.33, 300.0, [1.0, 0.0], 1.0)?;
/// let [x, y, z] = soap.xyz(0.8_f64.cos());
/// assert!((x - 0.0334591938782781).abs() < 1e-14 && (z - 0.0973727238397775).abs() < 1e-14);
/// assert!(soap.reflectance(0.8_f64.cos()).z > 2.0 * y);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BelcourBarla<C = glam::Vec3, T = f32> {
    film: T,
    thickness: T,
    substrate: Complex<T>,
    outside: T,
    /// The colours of X, Y and Z, whose sum is white.
    x: C,
    y: C,
    z: C,
}

impl<C, T> BelcourBarla<C, T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        model!(@row film: T, ETA, "n₂", "index of the film"),
        model!(@row thickness: T, THICKNESS, "d", "thickness of the film, nm"),
        Parameter::new(
            "substrate",
            "n₃",
            "index behind the film, the same in all channels",
            Kind::Medium(range::ETA, range::K),
        ),
        model!(@row outside: T, ETA = 1.0, "n₁", "index in front of the film"),
    ];
}

/// The colours of X, Y and Z in linear sRGB, such that their sum is (1, 1, 1).
pub(crate) fn xyz_in_linear_srgb() -> [[f64; 3]; 3] {
    let white = xyz_to_linear_srgb(glam::DVec3::ONE);
    [glam::DVec3::X, glam::DVec3::Y, glam::DVec3::Z]
        .map(|axis| (xyz_to_linear_srgb(axis) / white).to_array())
}

impl<T: Real, C: Color<T> + Vector<T>> BelcourBarla<C, T> {
    /// A film of index `film` and a thickness in nanometres on a substrate of index n + ik,
    /// `[n, k]`, seen from a transparent medium.
    ///
    /// # Errors
    /// If `film`, `outside` or n are not in 10⁻⁴ … 10⁴, `thickness` not in 0 … 10⁹ or k not in
    /// 0 … 10⁴.
    pub fn new(
        film: T,
        thickness: T,
        substrate: [T; 2],
        outside: T,
    ) -> Result<Self, ParameterError> {
        let colors = xyz_in_linear_srgb().map(|[r, g, b]| C::new(T::lit(r), T::lit(g), T::lit(b)));
        Self::with_colors(film, thickness, substrate, outside, colors)
    }
}

impl<T: Real, C: Color<T>> BelcourBarla<C, T> {
    /// The same in channels of choice: the colours of X, Y and Z.
    ///
    /// # Errors
    /// As of [`new`](Self::new).
    pub fn with_colors(
        film: T,
        thickness: T,
        substrate: [T; 2],
        outside: T,
        [x, y, z]: [C; 3],
    ) -> Result<Self, ParameterError> {
        range::ETA.check::<T, _>("film", film)?;
        range::THICKNESS.check::<T, _>("thickness", thickness)?;
        let [eta, k] = substrate;
        check_index("substrate", Complex::new(eta, k))?;
        range::ETA.check::<T, _>("outside", outside)?;
        Ok(Self { film, thickness, substrate: Complex::new(eta, k), outside, x, y, z })
    }

    /// XYZ relative to those of a perfect reflector.
    #[inline(always)]
    #[must_use]
    pub fn xyz(&self, cos_theta: T) -> [T; 3] {
        let (outside, film) = (Complex::real(self.outside), Complex::real(self.film));
        let Bounces { normal, upper, entering, lower } =
            Bounces::new(outside, film, self.substrate, cos_theta);
        let path = normal.re * (self.thickness + self.thickness);
        let s = Orders::new(upper.s, entering.s, lower.s);
        let p = Orders::new(upper.p, entering.p, lower.p);
        let first = (s.first + p.first) * T::lit(0.5);
        // Twice C_m, and half of each polarisation.
        let second = [s.turned.squared(), p.turned.squared()];
        let third = [second[0] * s.turned, second[1] * p.turned];
        let waves = [
            s.turned * s.later + p.turned * p.later,
            second[0] * s.later + second[1] * p.later,
            third[0] * s.later + third[1] * p.later,
        ];
        [
            X[0].seen(first, path, waves) + X[1].seen(first, path, waves),
            Y.seen(first, path, waves),
            Z.seen(first, path, waves),
        ]
    }
}

/// What the reflections of one polarisation come to.
struct Orders<T> {
    /// C₀.
    first: T,
    /// R* − T.
    later: T,
    /// √(R₁₂R₂₃) e^(iφ), whose powers are what the series needs.
    turned: Complex<T>,
}

impl<T: Real> Orders<T> {
    #[inline(always)]
    fn new(upper: Complex<T>, entering: T, lower: Complex<T>) -> Self {
        let (r12, r23) = (upper.norm_squared(), lower.norm_squared());
        let rest = T::one() - r12 * r23;
        // Where nothing enters, nothing returns.
        let returns = rest.gt(T::zero());
        let rest = T::select(returns, rest, T::one());
        let returned = (entering * entering * r23 / rest).only_where(returns);
        Self { first: r12 + returned, later: returned - entering, turned: -(upper * lower) }
    }
}

/// A Gaussian that stands for a colour matching function over the wave number, and its Fourier
/// transform.
struct Lobe {
    /// val √(2π var)/1.0685·10⁻⁷.
    scale: f64,
    /// pos 10⁻⁹: turns for each nanometre of the path.
    turns: f64,
    /// var (2π 10⁻⁹)².
    decay: f64,
}

const X: [Lobe; 2] = [
    Lobe { scale: 0.8465900023036574, turns: 1.6810e-3, decay: 1.708546957081381e-7 },
    Lobe { scale: 0.15386830651283523, turns: 2.2399e-3, decay: 1.7876617059605132e-7 },
];
const Y: Lobe = Lobe { scale: 1.0002218935839293, turns: 1.7953e-3, decay: 3.673308844415042e-7 };
const Z: Lobe = Lobe { scale: 1.0011224857215686, turns: 2.2084e-3, decay: 2.6103524504177177e-7 };

impl Lobe {
    /// What is seen of light without delay and of three waves that are behind by a path, by twice and
    /// by three times that path.
    #[inline(always)]
    fn seen<T: Real>(&self, first: T, path: T, [one, two, three]: [Complex<T>; 3]) -> T {
        // The factor of one path: of twice and three times the path it is to the powers 4 and 9.
        let damped = (-(path * path * T::lit(self.decay))).exp();
        let (sin, cos) = (path * T::lit(self.turns)).sin_cos_turns();
        let turn = Complex::new(cos, sin);
        let turns = turn * turn;
        let (squared, fourth) = (damped * damped, (damped * damped) * (damped * damped));
        let ninth = fourth * squared * squared * damped;
        let sum = first
            + (one * turn).re * damped
            + (two * turns).re * fourth
            + (three * (turns * turn)).re * ninth;
        sum * T::lit(self.scale)
    }
}

impl<T: Real, C: Color<T>> Fresnel<T> for BelcourBarla<C, T> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        let [x, y, z] = self.xyz(cos_theta);
        self.x * x + self.y * y + self.z * z
    }

    #[inline(always)]
    fn reflected(&self, cos: T, scale: T) -> C {
        in_place!(
            T,
            #[inline(always)]
            || {
                let value = self.reflectance(cos) * scale;
                value.map(|value| value.clamp(T::zero(), T::max_finite()))
            },
        )
    }

    fn reflected_block(&self, mirrored: Block<'_, T, 2>, values: &mut ColorBlock<T, C>) {
        let [cos, scale] = mirrored.planes;
        mirrored.colors(
            values,
            #[inline(always)]
            |index| self.reflected(cos[index], scale[index]),
        );
    }
}

impl<T: Real, C: Color<T>> Lift<T> for BelcourBarla<C, T> {
    type Over<U: Real> = BelcourBarla<C::Over<U>, U>;

    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> Self::Over<U> {
        BelcourBarla {
            film: lift(self.film),
            thickness: lift(self.thickness),
            substrate: self.substrate.lift(lift),
            outside: lift(self.outside),
            x: self.x.lift(lift),
            y: self.y.lift(lift),
            z: self.z.lift(lift),
        }
    }
}
