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
}

/// All models.
pub fn all<T: Real>() -> Vec<Entry<T>> {
    build().expect("the parameters are in range")
}

fn build<T: Real>() -> Result<Vec<Entry<T>>, ParameterError> {
    let rgb = |r: f64, g: f64, b: f64| <T::Vec3 as Vector<T>>::new(T::lit(r), T::lit(g), T::lit(b));
    let mut entries: Vec<Entry<T>> = Vec::new();
    entries.push(Entry {
        name: "Lambert",
        model: Box::new(Lambert::new(rgb(0.8, 0.5, 0.2))?),
        reciprocal: true,
        conserving: true,
    });
    Ok(entries)
}
