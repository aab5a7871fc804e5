//! Models of arbitrary parameters.

use arbitrary::Arbitrary;
use brdf::{
    Beckmann, Blinn1977, Blinn1977Printed, BlinnPhong, Brdf, ClassicPhong, CookTorrance,
    CookTorrance1982Printed, Lambert, OrenNayar, ParameterError, Phong, Real, SchlickPower,
    SmithCorrelated, SmithSeparable, WeightedSum,
};

use crate::numbers::{Channels, Number};
use crate::terms::{OtherNormals, SmithNormals, Term, color};

pub type AnyModel<T> = Box<dyn Brdf<T, Color = <T as Real>::Vec3>>;

#[derive(Arbitrary, Clone, Debug)]
pub enum Model {
    Lambert(Channels),
    OrenNayar(Channels, Number, bool),
    Phong(Channels, Number),
    ClassicPhong(Channels, Number),
    BlinnPhong(Channels, Number),
    ClassicBlinnPhong(Channels, Number),
    Schlick(Channels, Number),
    ClassicSchlick(Channels, Number),
    Smith(SmithNormals, Term),
    SmithSeparable(SmithNormals, Term),
    VCavity(SmithNormals, Term),
    VCavityOfOthers(OtherNormals, Term),
    TorranceSparrow(Number, Term),
    CookTorrancePrinted(Number, Number, Term),
    BlinnPrinted(u8, Number, Term),
    Sum(Box<[(Channels, Model); 2]>),
    LongSum(Vec<(Channels, Model)>),
}

/// What a model promises.
#[derive(Clone, Copy, Debug)]
pub struct Promise {
    pub reciprocal: bool,
    /// The largest directional albedo.
    pub albedo: f64,
    /// The largest weight of a sample, and what is added to it over the larger cosine.
    pub weight: f64,
    pub grooves: f64,
}

impl Promise {
    const fn new(albedo: f64, weight: f64) -> Self {
        Self { reciprocal: true, albedo, weight, grooves: 0.0 }
    }

    pub fn largest_weight(self, cos_i: f64, cos_o: f64) -> f64 {
        self.weight + self.grooves / cos_i.max(cos_o)
    }
}

const PI: f64 = std::f64::consts::PI;

impl Model {
    pub fn build<T: Real>(&self) -> Result<AnyModel<T>, ParameterError> {
        let color = color::<T>;
        let lit = |Number(value)| T::lit(value);
        Ok(match self {
            Self::Lambert(albedo) => Box::new(Lambert::new(color(*albedo))?),
            Self::OrenNayar(albedo, sigma, true) => {
                Box::new(OrenNayar::with_interreflection(color(*albedo), lit(*sigma))?)
            }
            Self::OrenNayar(albedo, sigma, false) => {
                Box::new(OrenNayar::new(color(*albedo), lit(*sigma))?)
            }
            Self::Phong(specular, n) => Box::new(Phong::new(color(*specular), lit(*n))?),
            Self::ClassicPhong(specular, n) => {
                Box::new(ClassicPhong::new(color(*specular), lit(*n))?)
            }
            Self::BlinnPhong(specular, n) => Box::new(BlinnPhong::new(color(*specular), lit(*n))?),
            Self::ClassicBlinnPhong(specular, n) => {
                Box::new(BlinnPhong::unnormalized(color(*specular), lit(*n))?)
            }
            Self::Schlick(specular, n) => Box::new(SchlickPower::new(color(*specular), lit(*n))?),
            Self::ClassicSchlick(specular, n) => {
                Box::new(SchlickPower::unnormalized(color(*specular), lit(*n))?)
            }
            Self::Smith(normals, term) => Box::new(
                CookTorrance::new(normals.build::<T>()?, term.build::<T>()?)
                    .with_shadowing(SmithCorrelated),
            ),
            Self::SmithSeparable(normals, term) => Box::new(
                CookTorrance::new(normals.build::<T>()?, term.build::<T>()?)
                    .with_shadowing(SmithSeparable),
            ),
            Self::VCavity(normals, term) => {
                Box::new(CookTorrance::new(normals.build::<T>()?, term.build::<T>()?))
            }
            Self::VCavityOfOthers(normals, term) => {
                Box::new(CookTorrance::new(normals.build::<T>()?, term.build::<T>()?))
            }
            Self::TorranceSparrow(c, term) => {
                Box::new(CookTorrance::torrance_sparrow_1967(lit(*c), term.build::<T>()?)?)
            }
            Self::CookTorrancePrinted(x, y, term) => Box::new(CookTorrance1982Printed::new(
                Beckmann::anisotropic(lit(*x), lit(*y))?,
                term.build::<T>()?,
            )),
            Self::BlinnPrinted(which, beta, term) => {
                let (blinn, term) = (Blinn1977::new(lit(*beta))?, term.build::<T>()?);
                match which % 3 {
                    0 => Box::new(Blinn1977Printed::d1(blinn, term)?),
                    1 => Box::new(Blinn1977Printed::d2(blinn, term)?),
                    _ => Box::new(Blinn1977Printed::d3(blinn, term)?),
                }
            }
            Self::Sum(terms) => sum::<T>(terms.as_slice())?,
            Self::LongSum(terms) => sum::<T>(terms)?,
        })
    }

    /// What must hold of the model, if its parameters were accepted.
    pub fn promise(&self) -> Promise {
        match self {
            Self::Lambert(_) => Promise::new(1.0, 1.0),
            Self::OrenNayar(_, _, interreflection) => Promise {
                grooves: 0.45,
                ..Promise::new(if *interreflection { 1.0444 } else { 1.0152 }, 1.0)
            },
            Self::Phong(..) => Promise::new(1.0, 2.0),
            Self::ClassicPhong(_, Number(n)) => {
                let weight = 2.0 * PI / (n + 1.0);
                Promise { reciprocal: false, ..Promise::new(weight, weight) }
            }
            Self::BlinnPhong(..) => Promise::new(1.0, 8.0),
            Self::ClassicBlinnPhong(..) => Promise::new(PI, 8.0 * PI),
            Self::Schlick(..) => Promise::new(1.0, 3.0),
            Self::ClassicSchlick(..) => Promise::new(PI, 2.0 * PI),
            Self::Smith(_, term)
            | Self::SmithSeparable(_, term)
            | Self::VCavity(_, term)
            | Self::VCavityOfOthers(_, term)
            | Self::TorranceSparrow(_, term) => Promise::new(term.largest(), term.largest()),
            Self::CookTorrancePrinted(_, _, term) => {
                Promise::new(4.0 * term.largest(), 4.0 * term.largest())
            }
            // 4/D(N), which is at most that of the flattest distribution.
            Self::BlinnPrinted(_, _, term) => {
                Promise::new(4.0 * PI * term.largest(), 4.0 * PI * term.largest())
            }
            Self::Sum(terms) => sum_promise(terms.as_slice()),
            Self::LongSum(terms) => sum_promise(terms),
        }
    }
}

fn sum<T: Real>(terms: &[(Channels, Model)]) -> Result<AnyModel<T>, ParameterError> {
    let mut built = Vec::new();
    for (weight, model) in terms {
        built.push((color::<T>(*weight), model.build::<T>()?));
    }
    Ok(Box::new(WeightedSum::new(built)?))
}

fn sum_promise(terms: &[(Channels, Model)]) -> Promise {
    let mut all = Promise::new(0.0, 0.0);
    let mut total = 0.0;
    for (Channels(weight), model) in terms {
        let promise = model.promise();
        let largest = weight.iter().copied().fold(0.0, f64::max);
        total += weight.iter().sum::<f64>();
        all.albedo += largest * promise.albedo;
        all.weight = all.weight.max(promise.weight);
        all.grooves = all.grooves.max(promise.grooves);
        all.reciprocal &= promise.reciprocal;
    }
    // A channel weighs at most three times the mean that its probability is made of. Where the
    // density is a subnormal number its rounding counts.
    let scaled = |value: f64| (value * (total * 2.0).min(f64::MAX)).min(f64::MAX);
    Promise { weight: scaled(all.weight), grooves: scaled(all.grooves), ..all }
}
