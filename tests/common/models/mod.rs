//! The registry: every model with representative parameters, in any number. What holds of all
//! models is tested over this list; a new model gets the whole suite by its line here.

mod diffuse;
mod glossy;
mod historical;
mod microfacet;
mod sums;

use brdf::{Brdf, ParameterError, Real, Vector};

type Boxed<T> = Box<dyn Brdf<T, Color = <T as Real>::Vec3>>;
type Entries<T> = Result<Vec<Entry<T>>, ParameterError>;

/// One model under test.
pub struct Entry<T: Real> {
    pub name: &'static str,
    pub model: Boxed<T>,
    /// The Rust type of the model, with the types of its parts.
    pub type_name: &'static str,
    /// f(wi, wo) = f(wo, wi).
    pub reciprocal: bool,
    /// Where the directional albedo exceeds 1; `None` for a model that promises it never does.
    pub gain: Option<Gain>,
}

/// The largest directional albedo of a model that is not conserving, brightest channel.
#[derive(Clone, Copy, Debug)]
pub struct Gain {
    pub albedo: f64,
    /// The polar angle of the viewer where it is reached.
    pub degrees: f64,
}

impl<T: Real> Entry<T> {
    fn new<M: Brdf<T, Color = T::Vec3> + 'static>(name: &'static str, model: M) -> Self {
        Self {
            name,
            model: Box::new(model),
            type_name: std::any::type_name::<M>(),
            reciprocal: true,
            gain: None,
        }
    }

    fn not_reciprocal(mut self) -> Self {
        self.reciprocal = false;
        self
    }

    /// Not conserving: the albedo reaches this much at this angle of the viewer.
    fn gains(mut self, albedo: f64, degrees: f64) -> Self {
        self.gain = Some(Gain { albedo, degrees });
        self
    }
}

/// All models.
pub fn all<T: Real>() -> Vec<Entry<T>> {
    let lists = [
        diffuse::entries(),
        glossy::entries(),
        microfacet::entries(),
        historical::entries(),
        sums::entries(),
    ];
    lists.into_iter().flat_map(|list| list.expect("the parameters are in range")).collect()
}

/// A literal that `f32` and `f64` round alike, so that they can be compared.
#[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
fn lit<T: Real>(value: f64) -> T {
    T::lit(f64::from(value as f32))
}

fn rgb<T: Real>(r: f64, g: f64, b: f64) -> T::Vec3 {
    Vector::new(lit(r), lit(g), lit(b))
}
