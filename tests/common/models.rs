//! Every model with representative parameters, in any number: what the tests run over.

use brdf::{Brdf, Lambert, ParameterError, Real, Vector};

/// One model under test.
pub struct Entry<T: Real> {
    pub name: &'static str,
    pub model: Box<dyn Brdf<T, Color = T::Vec3>>,
    /// f(wi, wo) = f(wo, wi).
    pub reciprocal: bool,
    /// Directional albedo never above 1.
    pub conserving: bool,
    /// Largest relative difference of `f32` from `f64`.
    pub precision: f64,
}

impl<T: Real> Entry<T> {
    fn new(name: &'static str, model: impl Brdf<T, Color = T::Vec3> + 'static) -> Self {
        Self { name, model: Box::new(model), reciprocal: true, conserving: true, precision: 2e-6 }
    }

    fn not_reciprocal(mut self) -> Self {
        self.reciprocal = false;
        self
    }

    fn not_conserving(mut self) -> Self {
        self.conserving = false;
        self
    }

    fn precision(mut self, precision: f64) -> Self {
        self.precision = precision;
        self
    }
}

/// All models.
pub fn all<T: Real>() -> Vec<Entry<T>> {
    build().expect("the parameters are in range")
}

/// A literal that `f32` and `f64` round alike, so that they can be compared.
#[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
fn lit<T: Real>(value: f64) -> T {
    T::lit(f64::from(value as f32))
}

fn rgb<T: Real>(r: f64, g: f64, b: f64) -> T::Vec3 {
    Vector::new(lit(r), lit(g), lit(b))
}

fn build<T: Real>() -> Result<Vec<Entry<T>>, ParameterError> {
    let (lit, rgb) = (lit::<T>, rgb::<T>);
    Ok(vec![Entry::new("Lambert", Lambert::new(rgb(0.8, 0.5, 0.2))?)])
}
