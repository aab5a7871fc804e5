//! Values with their derivatives.

use alloc::vec::Vec;
use core::array;

use crate::brdf::Sample;
use crate::real::{Color, Dual, Real, Spectrum, Vector, Vector3};

/// A value and its derivatives by `N` numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient<V, const N: usize> {
    /// The value.
    pub value: V,
    /// The derivative by each of the numbers, in their order: of a colour by channel, of a sample
    /// those of its direction, weight and density, of a list those of its elements.
    pub derivatives: [V; N],
}

/// What a formula answers for the given numbers, and the derivatives of that by each of them.
///
/// The formula may answer a number, a colour, a [`Sample`], a pair or a list of such, or the
/// `Result` of one: constructors of models take [`Dual`] numbers like any others. What does not
/// change comes in by [`Dual::constant`] and [`Dual::vector`].
///
/// ```
/// use brdf::{Brdf, Conductor, CookTorrance, Dual, Ggx, Gradient, ParameterError, gradient};
/// use glam::DVec3;
///
/// let (wi, wo) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.48, 0.36, 0.8));
/// // Gold at one wavelength by its roughness and its complex index.
/// let Gradient { value, derivatives: [by_roughness, by_eta, by_k] } =
///     gradient([0.3_f64, 0.143, 3.983], |[roughness, eta, k]| {
///         let gold = CookTorrance::new(Ggx::new(roughness)?, Conductor::new(eta, k)?);
///         Ok::<_, ParameterError>(gold.eval(Dual::vector(wi), Dual::vector(wo)))
///     })?;
/// let plain = |roughness| {
///     let gold = CookTorrance::new(Ggx::new(roughness)?, Conductor::new(0.143, 3.983)?);
///     Ok::<_, ParameterError>(gold.eval(wi, wo))
/// };
/// assert_eq!(value, plain(0.3)?);
/// let difference = (plain(0.3 + 1e-5)? - plain(0.3 - 1e-5)?) / 2e-5;
/// assert!((by_roughness - difference).abs() < 1e-8);
/// assert!(by_eta < 0.0 && by_k > 0.0);
/// # Ok::<(), ParameterError>(())
/// ```
///
/// # Batches
/// A list answers a list of values and a list of derivatives by each number: the columns of the
/// Jacobian matrix that a fit asks for.
///
/// ```
/// use brdf::{Brdf, Dual, Minnaert, ParameterError, gradient};
/// use glam::DVec3;
///
/// let wi = [DVec3::Z, DVec3::new(0.6, 0.0, 0.8), DVec3::new(0.8, 0.0, 0.6)];
/// let moon = gradient([0.12_f64, 0.5], |[albedo, k]| {
///     let moon = Minnaert::new(albedo, k)?;
///     let lit = |&wi| moon.eval(Dual::vector(wi), Dual::vector(DVec3::Z));
///     Ok::<_, ParameterError>(wi.iter().map(lit).collect::<Vec<_>>())
/// })?;
/// let [by_albedo, by_k] = moon.derivatives;
/// assert!((by_albedo[2] - moon.value[2] / 0.12).abs() < 1e-15);
/// assert!((by_k[2] / moon.value[2] - (1.0 / 1.5 + 0.6_f64.ln())).abs() < 1e-14);
/// # Ok::<(), ParameterError>(())
/// ```
///
/// # Samples
/// The direction of a sample moves with the parameters while the uniform numbers stay
/// ([reparametrisation](Dual#samples)).
///
/// ```
/// use brdf::{Beckmann, Brdf, Constant, CookTorrance, Dual, ParameterError, VCavity, gradient};
/// use glam::DVec3;
///
/// let wo = Dual::vector(DVec3::new(0.6, 0.0, 0.8));
/// let drawn = gradient([0.3_f64], |[roughness]| {
///     let mirrors = Constant::new(Dual::constant(1.0))?;
///     let grooves = CookTorrance::from_parts(Beckmann::new(roughness)?, mirrors, VCavity);
///     Ok::<_, ParameterError>(grooves.sample(wo, [0.3, 0.7].map(Dual::constant)))
/// })?;
/// // It stays on the sphere.
/// assert!(drawn.value.wi.dot(drawn.derivatives[0].wi).abs() < 1e-15);
/// assert!((drawn.derivatives[0].wi - DVec3::new(0.517351, 0.843475, 0.026097)).length() < 1e-6);
/// # Ok::<(), ParameterError>(())
/// ```
pub fn gradient<T, A, const N: usize>(
    numbers: [T; N],
    formula: impl FnOnce([Dual<T, N>; N]) -> A,
) -> A::Gradient
where
    T: Real,
    A: Differentiated<T, N>,
{
    let variables = array::from_fn(|place| Dual::variable(numbers[place], place));
    formula(variables).into_gradient()
}

/// What a formula of [`Dual`] numbers may answer to [`gradient`].
pub trait Differentiated<T: Real, const N: usize> {
    /// The value and its derivatives.
    type Gradient;

    /// Takes value and derivatives apart.
    fn into_gradient(self) -> Self::Gradient;
}

impl<V, const N: usize> Gradient<V, N> {
    /// Of what reads the same part, the value or one of the derivatives, of every number.
    fn of<T: Real>(read: impl Fn(&dyn Fn(Dual<T, N>) -> T) -> V) -> Self {
        Self {
            value: read(&|number| number.value),
            derivatives: array::from_fn(|place| read(&|number| number.derivatives[place])),
        }
    }
}

/// Colours.
macro_rules! color {
    ([$($generics:tt)*] $color:ty => $plain:ty) => {
        impl<T: Real, const N: usize, $($generics)*> Differentiated<T, N> for $color {
            type Gradient = Gradient<$plain, N>;

            fn into_gradient(self) -> Self::Gradient {
                Gradient::of(|part| self.lift(part))
            }
        }
    };
}
color!([] Dual<T, N> => T);
color!([] Vector3<Dual<T, N>> => T::Vec3);
color!([const M: usize] Spectrum<Dual<T, N>, M> => Spectrum<T, M>);

impl<T, C, const N: usize> Differentiated<T, N> for Sample<Dual<T, N>, C>
where
    T: Real,
    C: Color<Dual<T, N>>,
{
    type Gradient = Gradient<Sample<T, C::Over<T>>, N>;

    fn into_gradient(self) -> Self::Gradient {
        let Self { wi, weight, pdf } = self;
        Gradient::of(|part| Sample {
            wi: Vector::new(part(wi.x), part(wi.y), part(wi.z)),
            weight: weight.lift(part),
            pdf: part(pdf),
        })
    }
}

impl<T, A, V, const N: usize> Differentiated<T, N> for Vec<A>
where
    T: Real,
    A: Differentiated<T, N, Gradient = Gradient<V, N>>,
{
    type Gradient = Gradient<Vec<V>, N>;

    fn into_gradient(self) -> Self::Gradient {
        let column = || Vec::with_capacity(self.len());
        let mut all = Gradient { value: column(), derivatives: array::from_fn(|_| column()) };
        for element in self {
            let Gradient { value, derivatives } = element.into_gradient();
            all.value.push(value);
            for (column, derivative) in all.derivatives.iter_mut().zip(derivatives) {
                column.push(derivative);
            }
        }
        all
    }
}

impl<T, A, B, const N: usize> Differentiated<T, N> for (A, B)
where
    T: Real,
    A: Differentiated<T, N>,
    B: Differentiated<T, N>,
{
    type Gradient = (A::Gradient, B::Gradient);

    fn into_gradient(self) -> Self::Gradient {
        (self.0.into_gradient(), self.1.into_gradient())
    }
}

impl<T, A, E, const N: usize> Differentiated<T, N> for Result<A, E>
where
    T: Real,
    A: Differentiated<T, N>,
{
    type Gradient = Result<A::Gradient, E>;

    fn into_gradient(self) -> Self::Gradient {
        self.map(Differentiated::into_gradient)
    }
}
