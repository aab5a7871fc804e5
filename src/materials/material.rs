//! The measured index of one material.

use core::fmt;
use core::ops::Deref;

use super::constants::OpticalConstants;

/// What a material is, and whether it is a good choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// A pure metal.
    Metal,
    /// A mixture of metals.
    Alloy,
    /// A semiconductor.
    Semiconductor,
    /// A transparent or weakly absorbing medium.
    Dielectric,
    /// A second opinion on a metal that has another set.
    Alternative,
    /// A set not to be used for colour; [`Material::remark`] says why. These are tantalum and zinc.
    Caution,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Metal => "metal",
            Self::Alloy => "alloy",
            Self::Semiconductor => "semiconductor",
            Self::Dielectric => "dielectric",
            Self::Alternative => "alternative",
            Self::Caution => "caution",
        })
    }
}

/// The form in which the source gives its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Form {
    /// A table: the samples are the numbers of the source.
    Table,
    /// A dispersion formula: the samples are its values every 5 nm.
    Formula,
}

/// A material whose index was measured: the table, and where that comes from.
///
/// The statics of [`materials`](super) are all there are. A material hands out the methods of its
/// [`OpticalConstants`], of which one's own can be made.
pub struct Material {
    pub(super) key: &'static str,
    pub(super) name: &'static str,
    pub(super) kind: Kind,
    pub(super) citation: &'static str,
    pub(super) license: &'static str,
    pub(super) form: Form,
    pub(super) preparation: &'static str,
    pub(super) remark: Option<&'static str>,
    pub(super) constants: OpticalConstants,
}

impl Material {
    /// A short unique key: the chemical symbol of an element, with the author after `_` for a
    /// second opinion.
    #[must_use]
    pub const fn key(&self) -> &'static str {
        self.key
    }

    /// Name in English, unique too.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Chemical symbol, if the material is an element.
    #[must_use]
    pub fn symbol(&self) -> Option<&'static str> {
        let element = matches!(
            self.kind,
            Kind::Metal | Kind::Semiconductor | Kind::Alternative | Kind::Caution
        );
        element.then(|| self.key.split_once('_').map_or(self.key, |(symbol, _)| symbol))
    }

    /// What it is.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        self.kind
    }

    /// The publication to cite.
    #[must_use]
    pub const fn citation(&self) -> &'static str {
        self.citation
    }

    /// SPDX identifier of the licence of the data.
    #[must_use]
    pub const fn license(&self) -> &'static str {
        self.license
    }

    /// Whether the source is a table or a formula.
    #[must_use]
    pub const fn form(&self) -> Form {
        self.form
    }

    /// How the samples were made of the source, and whether k is zero only because the source does
    /// not give it.
    #[must_use]
    pub const fn preparation(&self) -> &'static str {
        self.preparation
    }

    /// What to know before use, if anything.
    #[must_use]
    pub const fn remark(&self) -> Option<&'static str> {
        self.remark
    }
}

impl Deref for Material {
    type Target = OpticalConstants;

    fn deref(&self) -> &OpticalConstants {
        &self.constants
    }
}

impl fmt::Debug for Material {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Material({})", self.key)
    }
}

impl fmt::Display for Material {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}
