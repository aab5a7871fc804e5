//! Fresnel terms and distributions of arbitrary parameters.

use arbitrary::Arbitrary;
use brdf::{
    Beckmann, Blinn, Conductor, Constant, Cook, Dielectric, Distribution, Fresnel, Gaussian, Ggx,
    Hall, Mixture, ParameterError, Real, Schlick, Smith, Vector,
};

use crate::numbers::{Channels, Number};

pub type AnyTerm<T> = Box<dyn Fresnel<T, Color = <T as Real>::Vec3>>;

#[derive(Arbitrary, Clone, Debug)]
pub enum Term {
    Constant(Channels),
    Schlick(Channels),
    Dielectric(Channels),
    Conductor(Channels, Channels),
    Hall(Channels, Number),
    HallOfMetal(Channels, Number, Number),
    Cook(Channels, Channels, Number),
}

pub fn color<T: Real>(Channels([r, g, b]): Channels) -> T::Vec3 {
    Vector::new(T::lit(r), T::lit(g), T::lit(b))
}

impl Term {
    pub fn build<T: Real>(&self) -> Result<AnyTerm<T>, ParameterError> {
        let color = color::<T>;
        let lit = |Number(value)| T::lit(value);
        Ok(match *self {
            Self::Constant(f0) => Box::new(Constant::new(color(f0))?),
            Self::Schlick(f0) => Box::new(Schlick::new(color(f0))?),
            Self::Dielectric(ior) => Box::new(Dielectric::new(color(ior))?),
            Self::Conductor(eta, k) => Box::new(Conductor::new(color(eta), color(k))?),
            Self::Hall(f0, ior) => Box::new(Hall::new(color(f0), lit(ior))?),
            Self::HallOfMetal(f0, eta, k) => {
                let metal = Conductor::new(lit(eta), lit(k))?;
                Box::new(Hall::with_reference(color(f0), metal)?)
            }
            Self::Cook(f0, light, ior) => Box::new(Cook::new(color(f0), color(light), lit(ior))?),
        })
    }

    /// The largest reflectance.
    pub fn largest(&self) -> f64 {
        match self {
            Self::Cook(_, Channels(light), _) => light.iter().copied().fold(0.0, f64::max),
            _ => 1.0,
        }
    }
}

#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum SmithNormals {
    Beckmann(Number, Number),
    Ggx(Number, Number),
    Beckmanns([(Number, Number); 3]),
    Ggxs([(Number, Number); 2]),
}

#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum OtherNormals {
    Gaussian(Number),
    Blinn(Number),
    BlinnOfRoughness(Number),
    Gaussians([(Number, Number); 2]),
}

impl SmithNormals {
    pub fn build<T: Real>(&self) -> Result<Box<dyn Smith<T>>, ParameterError> {
        let lit = |Number(value)| T::lit(value);
        Ok(match *self {
            Self::Beckmann(x, y) => Box::new(Beckmann::anisotropic(lit(x), lit(y))?),
            Self::Ggx(x, y) => Box::new(Ggx::anisotropic(lit(x), lit(y))?),
            Self::Beckmanns([(u, a), (v, b), (w, c)]) => Box::new(Mixture::new([
                (lit(u), Beckmann::new(lit(a))?),
                (lit(v), Beckmann::new(lit(b))?),
                (lit(w), Beckmann::new(lit(c))?),
            ])?),
            Self::Ggxs([(u, a), (v, b)]) => {
                Box::new(Mixture::new([(lit(u), Ggx::new(lit(a))?), (lit(v), Ggx::new(lit(b))?)])?)
            }
        })
    }
}

impl OtherNormals {
    pub fn build<T: Real>(&self) -> Result<Box<dyn Distribution<T>>, ParameterError> {
        let lit = |Number(value)| T::lit(value);
        Ok(match *self {
            Self::Gaussian(m) => Box::new(Gaussian::new(lit(m))?),
            Self::Blinn(n) => Box::new(Blinn::new(lit(n))?),
            Self::BlinnOfRoughness(m) => Box::new(Blinn::from_roughness(lit(m))?),
            Self::Gaussians([(u, a), (v, b)]) => Box::new(Mixture::new([
                (lit(u), Gaussian::new(lit(a))?),
                (lit(v), Gaussian::new(lit(b))?),
            ])?),
        })
    }
}
