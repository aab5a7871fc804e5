//! Every model with representative parameters, in any number: what the tests run over.

use brdf::{
    BlinnPhong, Brdf, ClassicPhong, Lambert, OrenNayar, ParameterError, Phong, Real, SchlickPower,
    Vector, WeightedSum,
};

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
    let sum = {
        let terms: [(T::Vec3, Box<dyn Brdf<T, Color = T::Vec3>>); 3] = [
            (rgb(0.5, 0.25, 0.125), Box::new(Lambert::new(rgb(0.8, 0.5, 0.2))?)),
            (rgb(0.25, 0.5, 0.5), Box::new(Phong::new(rgb(1.0, 1.0, 1.0), lit(30.0))?)),
            (rgb(0.25, 0.25, 0.375), Box::new(SchlickPower::new(rgb(1.0, 0.9, 0.8), lit(8.0))?)),
        ];
        WeightedSum::new(terms)?
    };
    // Powers lose digits down their flank, as 1 + n (1 − S)/S, and all lobes where the cosine S of
    // the angle to the mirror direction cancels to nearly 0.
    Ok(vec![
        Entry::new("Lambert", Lambert::new(rgb(0.8, 0.5, 0.2))?),
        Entry::new("Oren-Nayar", OrenNayar::new(rgb(1.0, 0.5, 0.2), lit(0.3))?).not_conserving(),
        Entry::new(
            "Oren-Nayar with interreflection",
            OrenNayar::with_interreflection(rgb(0.9, 0.5, 0.2), lit(0.5))?,
        ),
        Entry::new("Phong 10", Phong::new(rgb(1.0, 0.9, 0.8), lit(10.0))?).precision(5e-5),
        Entry::new("Phong 2000", Phong::new(rgb(1.0, 0.9, 0.8), lit(2000.0))?).precision(1e-5),
        Entry::new("classic Phong 3", ClassicPhong::new(rgb(1.0, 0.9, 0.8), lit(3.0))?)
            .not_reciprocal()
            .not_conserving()
            .precision(3e-4),
        Entry::new("Blinn-Phong 40", BlinnPhong::new(rgb(1.0, 0.9, 0.8), lit(40.0))?)
            .precision(2e-5),
        Entry::new("Blinn-Phong 1e5", BlinnPhong::new(rgb(1.0, 0.9, 0.8), lit(1e5))?)
            .precision(2e-5),
        Entry::new(
            "unnormalised Blinn-Phong 5",
            BlinnPhong::unnormalized(rgb(1.0, 0.9, 0.8), lit(5.0))?,
        )
        .not_conserving(),
        Entry::new("Schlick's power 10", SchlickPower::new(rgb(1.0, 0.9, 0.8), lit(10.0))?)
            .precision(2e-4),
        Entry::new("Schlick's power 1000", SchlickPower::new(rgb(1.0, 0.9, 0.8), lit(1000.0))?)
            .precision(2e-4),
        Entry::new(
            "unnormalised Schlick's power 2",
            SchlickPower::unnormalized(rgb(1.0, 0.9, 0.8), lit(2.0))?,
        )
        .not_conserving()
        .precision(2e-4),
        Entry::new("weighted sum", sum),
    ])
}
