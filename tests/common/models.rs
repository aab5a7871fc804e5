//! Every model with representative parameters, in any number: what the tests run over.

use brdf::{
    Beckmann, Blinn, Blinn1977, Blinn1977Printed, BlinnPhong, Brdf, ClassicPhong, Conductor,
    Constant, Cook, CookTorrance, CookTorrance1982Printed, Dielectric, Gaussian, Ggx, Hall,
    Lambert, Mixture, OrenNayar, ParameterError, Phong, Real, Schlick, SchlickPower,
    SmithCorrelated, SmithSeparable, Vector, WeightedSum,
};

type Boxed<T> = Box<dyn Brdf<T, Color = <T as Real>::Vec3>>;

/// One model under test.
pub struct Entry<T: Real> {
    pub name: &'static str,
    pub model: Boxed<T>,
    /// f(wi, wo) = f(wo, wi).
    pub reciprocal: bool,
    /// Directional albedo never above 1.
    pub conserving: bool,
    /// Largest relative difference of `f32` from `f64` down to 1e-3 of the largest value, and
    /// down to 1e-12.
    pub lobe_precision: f64,
    pub tail_precision: f64,
}

impl<T: Real> Entry<T> {
    fn new(name: &'static str, model: impl Brdf<T, Color = T::Vec3> + 'static) -> Self {
        Self {
            name,
            model: Box::new(model),
            reciprocal: true,
            conserving: true,
            lobe_precision: 2e-6,
            tail_precision: 2e-6,
        }
    }

    fn not_reciprocal(mut self) -> Self {
        self.reciprocal = false;
        self
    }

    fn not_conserving(mut self) -> Self {
        self.conserving = false;
        self
    }

    fn precision(mut self, lobe: f64, tail: f64) -> Self {
        self.lobe_precision = lobe;
        self.tail_precision = tail;
        self
    }
}

/// All models.
pub fn all<T: Real>() -> Vec<Entry<T>> {
    let mut models = lobes().expect("the parameters are in range");
    models.extend(microfacets().expect("the parameters are in range"));
    models
}

/// A literal that `f32` and `f64` round alike, so that they can be compared.
#[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
fn lit<T: Real>(value: f64) -> T {
    T::lit(f64::from(value as f32))
}

fn rgb<T: Real>(r: f64, g: f64, b: f64) -> T::Vec3 {
    Vector::new(lit(r), lit(g), lit(b))
}

fn lobes<T: Real>() -> Result<Vec<Entry<T>>, ParameterError> {
    let (lit, rgb) = (lit::<T>, rgb::<T>);
    let sum = {
        let terms: [(T::Vec3, Boxed<T>); 3] = [
            (rgb(0.5, 0.25, 0.125), Box::new(Lambert::new(rgb(0.8, 0.5, 0.2))?)),
            (rgb(0.25, 0.5, 0.5), Box::new(Phong::new(rgb(1.0, 1.0, 1.0), lit(30.0))?)),
            (rgb(0.25, 0.25, 0.375), Box::new(SchlickPower::new(rgb(1.0, 0.9, 0.8), lit(8.0))?)),
        ];
        WeightedSum::new(terms)?
    };
    // The rounding of N·H or R·V comes back multiplied by the logarithm of the power, 7 at the edge
    // of the lobe. Where R·V passes through 0 its relative error grows without bound, and a lobe
    // that is broad enough to have a value there follows it.
    Ok(vec![
        Entry::new("Lambert", Lambert::new(rgb(0.8, 0.5, 0.2))?),
        Entry::new("Oren-Nayar", OrenNayar::new(rgb(1.0, 0.5, 0.2), lit(0.3))?).not_conserving(),
        Entry::new(
            "Oren-Nayar with interreflection",
            OrenNayar::with_interreflection(rgb(0.9, 0.5, 0.2), lit(0.5))?,
        ),
        Entry::new("Phong 10", Phong::new(rgb(1.0, 0.9, 0.8), lit(10.0))?).precision(2e-6, 5e-5),
        Entry::new("Phong 2000", Phong::new(rgb(1.0, 0.9, 0.8), lit(2000.0))?)
            .precision(2e-6, 1e-5),
        Entry::new("classic Phong 3", ClassicPhong::new(rgb(1.0, 0.9, 0.8), lit(3.0))?)
            .not_reciprocal()
            .not_conserving()
            .precision(2e-6, 3e-4),
        Entry::new("Blinn-Phong 40", BlinnPhong::new(rgb(1.0, 0.9, 0.8), lit(40.0))?)
            .precision(4e-6, 2e-5),
        Entry::new("Blinn-Phong 1e5", BlinnPhong::new(rgb(1.0, 0.9, 0.8), lit(1e5))?)
            .precision(4e-6, 2e-5),
        Entry::new(
            "unnormalised Blinn-Phong 5",
            BlinnPhong::unnormalized(rgb(1.0, 0.9, 0.8), lit(5.0))?,
        )
        .not_conserving(),
        Entry::new("Schlick's power 10", SchlickPower::new(rgb(1.0, 0.9, 0.8), lit(10.0))?)
            .precision(2e-5, 2e-4),
        Entry::new("Schlick's power 1000", SchlickPower::new(rgb(1.0, 0.9, 0.8), lit(1000.0))?)
            .precision(2e-6, 2e-4),
        Entry::new(
            "unnormalised Schlick's power 2",
            SchlickPower::unnormalized(rgb(1.0, 0.9, 0.8), lit(2.0))?,
        )
        .not_conserving()
        .precision(5e-5, 2e-4),
        Entry::new("weighted sum", sum),
    ])
}

fn microfacets<T: Real>() -> Result<Vec<Entry<T>>, ParameterError> {
    let (lit, rgb) = (lit::<T>, rgb::<T>);
    let white = || Constant::new(rgb(1.0, 1.0, 1.0));
    let gold = || Conductor::new(rgb(0.143, 0.374, 1.442), rgb(3.983, 2.386, 1.603));
    let glass = || Dielectric::new(rgb(1.5, 1.5, 1.5));
    let plastic = || Schlick::new(rgb(0.04, 0.05, 0.06));
    let wide = Blinn1977::new(lit(1.0))?;
    // In the tail of an exponential the rounding of its argument counts as often as the argument is
    // large: 27 where the value has fallen to 1e-12.
    let tail = 1.2e-5;
    Ok(vec![
        Entry::new("Beckmann 0.25, gold", CookTorrance::new(Beckmann::new(lit(0.25))?, gold()?))
            .precision(2e-6, tail),
        Entry::new("Beckmann 1, white", CookTorrance::new(Beckmann::new(lit(1.0))?, white()?))
            .precision(2e-6, tail),
        Entry::new(
            "Beckmann 0.01, Smith, plastic",
            CookTorrance::new(Beckmann::new(lit(0.01))?, plastic()?)
                .with_shadowing(SmithCorrelated),
        )
        .precision(2e-6, tail),
        Entry::new(
            "Beckmann 0.1 0.5, Smith separable, Hall",
            CookTorrance::new(
                Beckmann::anisotropic(lit(0.1), lit(0.5))?,
                Hall::new(rgb(0.95, 0.64, 0.54), lit(1.5))?,
            )
            .with_shadowing(SmithSeparable),
        )
        .precision(2e-6, tail),
        Entry::new(
            "GGX 0.3, Smith, gold",
            CookTorrance::new(Ggx::new(lit(0.3))?, gold()?).with_shadowing(SmithCorrelated),
        ),
        Entry::new(
            "GGX 1, Smith separable, white",
            CookTorrance::new(Ggx::new(lit(1.0))?, white()?).with_shadowing(SmithSeparable),
        ),
        Entry::new(
            "GGX 0.05 0.4, Smith, glass",
            CookTorrance::new(Ggx::anisotropic(lit(0.05), lit(0.4))?, glass()?)
                .with_shadowing(SmithCorrelated),
        ),
        Entry::new(
            "Gaussian 0.25, plastic",
            CookTorrance::new(Gaussian::new(lit(0.25))?, plastic()?),
        )
        .precision(2e-6, tail),
        Entry::new("Gaussian 1, white", CookTorrance::new(Gaussian::new(lit(1.0))?, white()?)),
        Entry::new("Blinn 50, white", CookTorrance::new(Blinn::new(lit(50.0))?, white()?))
            .precision(2e-6, tail),
        Entry::new(
            "mixture of Beckmann, Smith, gold",
            CookTorrance::new(
                Mixture::new([
                    (lit(0.75), Beckmann::new(lit(0.125))?),
                    (lit(0.25), Beckmann::new(lit(0.5))?),
                ])?,
                gold()?,
            )
            .with_shadowing(SmithCorrelated),
        )
        .precision(2e-6, tail),
        Entry::new(
            "mixture of Gaussians, glass",
            CookTorrance::new(
                Mixture::new([
                    (lit(0.5), Gaussian::new(lit(0.1))?),
                    (lit(0.25), Gaussian::new(lit(0.3))?),
                    (lit(0.25), Gaussian::new(lit(0.6))?),
                ])?,
                glass()?,
            ),
        ),
        Entry::new(
            "GGX 0.001, Cook",
            CookTorrance::new(
                Ggx::new(lit(0.001))?,
                Cook::new(rgb(0.9, 0.6, 0.3), rgb(1.0, 0.9, 0.8), lit(1.5))?,
            ),
        ),
        Entry::new(
            "Torrance-Sparrow 1967, glass",
            CookTorrance::torrance_sparrow_1967(lit(0.05), glass()?)?,
        )
        .precision(2e-6, tail),
        Entry::new("Blinn 8, gold", CookTorrance::new(Blinn::new(lit(8.0))?, gold()?))
            .precision(2e-6, tail),
        Entry::new(
            "Cook-Torrance as printed in 1982, gold",
            CookTorrance1982Printed::new(Beckmann::new(lit(0.2))?, gold()?),
        )
        .not_conserving()
        .precision(2e-6, tail),
        Entry::new("Blinn 1977 as printed, D1, gold", Blinn1977Printed::d1(wide, gold()?)?)
            .not_conserving()
            .precision(2e-6, tail),
        Entry::new("Blinn 1977 as printed, D2, gold", Blinn1977Printed::d2(wide, gold()?)?)
            .not_conserving()
            .precision(2e-6, tail),
        Entry::new("Blinn 1977 as printed, D3, gold", Blinn1977Printed::d3(wide, gold()?)?)
            .not_conserving(),
    ])
}
