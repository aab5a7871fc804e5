//! Checked distributions, and mixtures of any number of any kind.
//!
//! The terms of a mixture are sorted by their type, so that no term needs a dispatch: each type has a loop of
//! its own. A mixture in a mixture is taken apart into its terms.

use alloc::vec::Vec;

use crate::distribution::mixture::{Choice, Visible};
use crate::distribution::{Beckmann, Blinn, Distribution, Gaussian, Ggx, Smith};
use crate::real::Real;

/// A checked distribution.
pub(super) enum Normals<T: Real> {
    Gaussian(Gaussian<T>),
    Blinn(Blinn<T>),
    Mixed(Mixed<T>),
    Smith(SmithNormals<T>),
}

/// A checked distribution for which Smith's shadowing is known.
pub(super) enum SmithNormals<T: Real> {
    Beckmann(Beckmann<T>),
    Ggx(Ggx<T>),
    Mixed(MixedSmith<T>),
}

/// The same expression for every type of distribution with Smith's shadowing.
macro_rules! each_smith {
    ($normals:expr, $distribution:ident => $result:expr) => {
        match $normals {
            $crate::description::normals::SmithNormals::Beckmann($distribution) => $result,
            $crate::description::normals::SmithNormals::Ggx($distribution) => $result,
            $crate::description::normals::SmithNormals::Mixed($distribution) => $result,
        }
    };
}
pub(super) use each_smith;

/// The same expression for every type of distribution.
macro_rules! each_distribution {
    ($normals:expr, $distribution:ident => $result:expr) => {
        match $normals {
            $crate::description::normals::Normals::Gaussian($distribution) => $result,
            $crate::description::normals::Normals::Blinn($distribution) => $result,
            $crate::description::normals::Normals::Mixed($distribution) => $result,
            $crate::description::normals::Normals::Smith(normals) => {
                $crate::description::normals::each_smith!(normals, $distribution => $result)
            }
        }
    };
}
pub(super) use each_distribution;

/// Distributions of one type with their weights.
type Terms<T, D> = Vec<(T, D)>;

/// A mixture of distributions for which Smith's shadowing is known. The weights of all terms add
/// up to 1.
pub(super) struct MixedSmith<T> {
    beckmann: Terms<T, Beckmann<T>>,
    ggx: Terms<T, Ggx<T>>,
}

/// A mixture of any distributions. The weights of all terms add up to 1.
pub(super) struct Mixed<T> {
    smith: MixedSmith<T>,
    gaussian: Terms<T, Gaussian<T>>,
    blinn: Terms<T, Blinn<T>>,
}

impl<T: Real> MixedSmith<T> {
    fn add(&mut self, weight: T, normals: SmithNormals<T>) {
        match normals {
            SmithNormals::Beckmann(beckmann) => self.beckmann.push((weight, beckmann)),
            SmithNormals::Ggx(ggx) => self.ggx.push((weight, ggx)),
            SmithNormals::Mixed(mixed) => {
                self.beckmann.extend(scaled(weight, mixed.beckmann));
                self.ggx.extend(scaled(weight, mixed.ggx));
            }
        }
    }

    /// Offers all terms to a choice.
    #[inline(always)]
    fn offer(&self, choice: &mut Choice<T>) {
        offer(choice, &self.beckmann);
        offer(choice, &self.ggx);
    }

    #[inline(always)]
    fn density_from(&self, start: T, m: T::Vec3) -> T {
        let start = sum(start, &self.beckmann, |each| each.density_along(m));
        sum(start, &self.ggx, |each| each.density_along(m))
    }
}

impl<T: Real> Mixed<T> {
    pub(super) const fn new() -> Self {
        let smith = MixedSmith { beckmann: Vec::new(), ggx: Vec::new() };
        Self { smith, gaussian: Vec::new(), blinn: Vec::new() }
    }

    pub(super) fn add(&mut self, weight: T, normals: Normals<T>) {
        match normals {
            Normals::Gaussian(gaussian) => self.gaussian.push((weight, gaussian)),
            Normals::Blinn(blinn) => self.blinn.push((weight, blinn)),
            Normals::Smith(smith) => self.smith.add(weight, smith),
            Normals::Mixed(mixed) => {
                self.smith.add(weight, SmithNormals::Mixed(mixed.smith));
                self.gaussian.extend(scaled(weight, mixed.gaussian));
                self.blinn.extend(scaled(weight, mixed.blinn));
            }
        }
    }

    /// The mixture, with Smith's shadowing if all of its terms have it.
    pub(super) fn into_normals(self) -> Normals<T> {
        if self.gaussian.is_empty() && self.blinn.is_empty() {
            Normals::Smith(SmithNormals::Mixed(self.smith))
        } else {
            Normals::Mixed(self)
        }
    }
}

impl<T: Real> Distribution<T> for MixedSmith<T> {
    #[inline]
    fn density(&self, h: T::Vec3) -> T {
        self.density_along(h)
    }

    #[inline]
    fn density_along(&self, m: T::Vec3) -> T {
        self.density_from(T::zero(), m).min(T::max_finite())
    }

    #[inline]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let mut choice = Choice::new(u);
        self.offer(&mut choice);
        choice.chosen()
    }
}

impl<T: Real> Smith<T> for MixedSmith<T> {
    #[inline]
    fn lambda_cos(&self, w: T::Vec3) -> T {
        let start = sum(T::zero(), &self.beckmann, |each| each.lambda_cos(w));
        sum(start, &self.ggx, |each| each.lambda_cos(w)).min(T::max_finite())
    }

    #[inline]
    fn projected_area(&self, w: T::Vec3) -> T {
        let start = sum(T::zero(), &self.beckmann, |each| each.projected_area(w));
        sum(start, &self.ggx, |each| each.projected_area(w)).min(T::max_finite())
    }

    #[inline]
    fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let (visible, mut choice) = (Visible::new(wo, self.lambda_cos(wo)), Choice::new(u));
        for (weight, each) in &self.beckmann {
            visible.offer(&mut choice, *weight, each);
        }
        for (weight, each) in &self.ggx {
            visible.offer(&mut choice, *weight, each);
        }
        choice.chosen()
    }
}

impl<T: Real> Distribution<T> for Mixed<T> {
    #[inline]
    fn density(&self, h: T::Vec3) -> T {
        let start = self.smith.density_from(T::zero(), h);
        let start = sum(start, &self.gaussian, |each| each.density(h));
        sum(start, &self.blinn, |each| each.density(h)).min(T::max_finite())
    }

    #[inline]
    fn density_along(&self, m: T::Vec3) -> T {
        let start = self.smith.density_from(T::zero(), m);
        let start = sum(start, &self.gaussian, |each| each.density_along(m));
        sum(start, &self.blinn, |each| each.density_along(m)).min(T::max_finite())
    }

    #[inline]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let mut choice = Choice::new(u);
        self.smith.offer(&mut choice);
        offer(&mut choice, &self.gaussian);
        offer(&mut choice, &self.blinn);
        choice.chosen()
    }
}

/// The terms of a mixture that itself has a weight.
fn scaled<T: Real, D>(weight: T, terms: Terms<T, D>) -> impl Iterator<Item = (T, D)> {
    terms.into_iter().map(move |(inner, distribution)| (weight * inner, distribution))
}

/// Σ wᵢ `term`(Dᵢ), counted on from `start`.
#[inline(always)]
fn sum<T: Real, D>(start: T, terms: &Terms<T, D>, term: impl Fn(&D) -> T) -> T {
    terms.iter().fold(start, |sum, (weight, each)| sum + *weight * term(each))
}

#[inline(always)]
fn offer<T: Real, D: Distribution<T>>(choice: &mut Choice<T>, terms: &Terms<T, D>) {
    for (weight, each) in terms {
        choice.offer(*weight, |u| each.sample(u));
    }
}
