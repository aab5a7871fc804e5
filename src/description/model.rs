//! From checked parts to objects: every combination of parts is a type of its own, compiled as if
//! it were written out, behind one dispatch.

use alloc::boxed::Box;

use super::any::AnyBrdf;
use super::fresnel::{Reflectance, each_fresnel};
use super::normals::{Normals, SmithNormals, each_distribution, each_smith};
use crate::diffuse::{Lambert, OrenNayar};
use crate::distribution::{Beckmann, Blinn, Gaussian, Ggx};
use crate::glossy::{BlinnPhong, ClassicPhong, Phong, SchlickPower};
use crate::microfacet::{
    Blinn1977Printed, CookTorrance, CookTorrance1982Printed, SmithCorrelated, SmithSeparable,
};
use crate::real::Real;
use crate::sum::WeightedSum;

/// A checked model.
pub(super) enum Model<T: Real> {
    Lambert(Lambert<T::Vec3>),
    OrenNayar(OrenNayar<T::Vec3, T>),
    Lobe(Lobe<T>),
    CookTorrance(Shadowed<T>, Reflectance<T>),
    CookTorrance1982Printed(Beckmann<T>, Reflectance<T>),
    Blinn1977Printed(Blinn1977Form<T>, Reflectance<T>),
    Sum(WeightedSum<Self, T::Vec3, T>),
}

/// A lobe without microfacets.
pub(super) enum Lobe<T: Real> {
    Phong(Phong<T::Vec3, T>),
    ClassicPhong(ClassicPhong<T::Vec3, T>),
    BlinnPhong(BlinnPhong<T::Vec3, T>),
    SchlickPower(SchlickPower<T::Vec3, T>),
}

/// A distribution with a shadowing that fits it.
pub(super) enum Shadowed<T: Real> {
    VCavity(Normals<T>),
    Smith(SmithNormals<T>),
    SmithSeparable(SmithNormals<T>),
}

/// One of Blinn's models of 1977, still without a Fresnel term.
pub(super) enum Blinn1977Form<T: Real> {
    D1(Blinn1977Printed<Blinn<T>, (), T>),
    D2(Blinn1977Printed<Gaussian<T>, (), T>),
    D3(Blinn1977Printed<Ggx<T>, (), T>),
}

impl<T: Real> Model<T> {
    pub(super) fn boxed(self) -> AnyBrdf<T> {
        match self {
            Self::Lambert(lambert) => Box::new(lambert),
            Self::OrenNayar(oren_nayar) => Box::new(oren_nayar),
            Self::Lobe(lobe) => lobe.boxed(),
            Self::CookTorrance(shadowed, reflectance) => shadowed.boxed(reflectance),
            Self::CookTorrance1982Printed(beckmann, reflectance) => {
                each_fresnel!(reflectance, fresnel => {
                    Box::new(CookTorrance1982Printed::new(beckmann, fresnel))
                })
            }
            Self::Blinn1977Printed(form, reflectance) => form.boxed(reflectance),
            Self::Sum(sum) => Box::new(sum.map(Self::boxed)),
        }
    }
}

impl<T: Real> Lobe<T> {
    fn boxed(self) -> AnyBrdf<T> {
        match self {
            Self::Phong(lobe) => Box::new(lobe),
            Self::ClassicPhong(lobe) => Box::new(lobe),
            Self::BlinnPhong(lobe) => Box::new(lobe),
            Self::SchlickPower(lobe) => Box::new(lobe),
        }
    }
}

impl<T: Real> Shadowed<T> {
    fn boxed(self, reflectance: Reflectance<T>) -> AnyBrdf<T> {
        match self {
            Self::VCavity(normals) => each_distribution!(normals, distribution => {
                each_fresnel!(reflectance, fresnel => {
                    Box::new(CookTorrance::new(distribution, fresnel))
                })
            }),
            Self::Smith(normals) => each_smith!(normals, distribution => {
                each_fresnel!(reflectance, fresnel => Box::new(
                    CookTorrance::new(distribution, fresnel).with_shadowing(SmithCorrelated)
                ))
            }),
            Self::SmithSeparable(normals) => each_smith!(normals, distribution => {
                each_fresnel!(reflectance, fresnel => Box::new(
                    CookTorrance::new(distribution, fresnel).with_shadowing(SmithSeparable)
                ))
            }),
        }
    }
}

impl<T: Real> Blinn1977Form<T> {
    fn boxed(self, reflectance: Reflectance<T>) -> AnyBrdf<T> {
        match self {
            Self::D1(form) => {
                each_fresnel!(reflectance, fresnel => Box::new(form.with_fresnel(fresnel)))
            }
            Self::D2(form) => {
                each_fresnel!(reflectance, fresnel => Box::new(form.with_fresnel(fresnel)))
            }
            Self::D3(form) => {
                each_fresnel!(reflectance, fresnel => Box::new(form.with_fresnel(fresnel)))
            }
        }
    }
}
