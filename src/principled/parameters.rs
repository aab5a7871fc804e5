//! The sliders of Disney's material.

use crate::error::{ParameterError, range};
use crate::parameter::{Kind, Parameter, Preset, model};
use crate::real::{Color, Real};

/// The sliders of [`Disney2012`](crate::Disney2012), each in 0 … 1.
///
/// ```
/// use brdf::{Disney2012, DisneyParameters};
/// use glam::Vec3;
///
/// let wax = DisneyParameters::of(Vec3::new(0.9, 0.8, 0.6));
/// let wax = Disney2012::new(DisneyParameters { subsurface: 0.7, ..wax })?;
/// # let _ = wax;
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisneyParameters<C = glam::Vec3, T = f32> {
    /// The colour of the surface, linear. Its tint is itself over its luminance 0.3R + 0.6G + 0.1B where it has
    /// three channels, which count as red, green and blue, and over the mean of its channels otherwise.
    pub base_color: C,
    /// From a dielectric to a metal: 0.
    pub metallic: T,
    /// From a rough diffuse surface to one under which light is scattered: 0.
    pub subsurface: T,
    /// Reflectance at normal incidence of the dielectric, in units of 0.08: 0.5.
    pub specular: T,
    /// Roughness, whose square is that of the distribution: 0.5.
    pub roughness: T,
    /// How much of the tint of the base colour the highlight of the dielectric has: 0.
    pub specular_tint: T,
    /// How much longer the highlight is along the tangent: 0.
    pub anisotropic: T,
    /// Additional light at grazing, of cloth: 0.
    pub sheen: T,
    /// How much of the tint of the base colour the sheen has: 0.5.
    pub sheen_tint: T,
    /// A second highlight: 0.
    pub clearcoat: T,
    /// From a satin to a glossy second highlight: 1.
    pub clearcoat_gloss: T,
}

impl<C, T> DisneyParameters<C, T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        model!(@row base_color: C, UNIT, "", "colour of the surface, linear"),
        model!(@row metallic: T, UNIT = 0.0, "", "from a dielectric to a metal"),
        model!(@row subsurface: T, UNIT = 0.0, "", "from a rough diffuse surface to one that light enters"),
        model!(@row specular: T, UNIT = 0.5, "", "reflectance of the dielectric in units of 0.08"),
        model!(@row roughness: T, UNIT = 0.5, "r", "roughness, the root of that of the distribution"),
        model!(@row specular_tint: T, UNIT = 0.0, "", "tint of the highlight"),
        model!(@row anisotropic: T, UNIT = 0.0, "", "length of the highlight along the tangent"),
        model!(@row sheen: T, UNIT = 0.0, "", "additional light at grazing"),
        model!(@row sheen_tint: T, UNIT = 0.5, "", "tint of the sheen"),
        model!(@row clearcoat: T, UNIT = 0.0, "", "strength of a second highlight"),
        model!(@row clearcoat_gloss: T, UNIT = 1.0, "", "gloss of the second highlight"),
        Parameter::new(
            "form",
            "g",
            "shadowing of the highlight: isotropic of a remapped roughness, or anisotropic",
            Kind::Word(&["2012", "2014"]),
        )
        .or(Preset::Word("2012")),
    ];
}

impl<T: Real, C: Color<T>> DisneyParameters<C, T> {
    /// The default of all sliders but the colour.
    #[must_use]
    pub fn of(base_color: C) -> Self {
        let (zero, half, one) = (T::zero(), T::lit(0.5), T::one());
        Self {
            base_color,
            metallic: zero,
            subsurface: zero,
            specular: half,
            roughness: half,
            specular_tint: zero,
            anisotropic: zero,
            sheen: zero,
            sheen_tint: half,
            clearcoat: zero,
            clearcoat_gloss: one,
        }
    }

    pub(super) fn check(&self) -> Result<(), ParameterError> {
        range::UNIT.check("base_color", self.base_color)?;
        for (name, value) in [
            ("metallic", self.metallic),
            ("subsurface", self.subsurface),
            ("specular", self.specular),
            ("roughness", self.roughness),
            ("specular_tint", self.specular_tint),
            ("anisotropic", self.anisotropic),
            ("sheen", self.sheen),
            ("sheen_tint", self.sheen_tint),
            ("clearcoat", self.clearcoat),
            ("clearcoat_gloss", self.clearcoat_gloss),
        ] {
            range::UNIT.check(name, value)?;
        }
        Ok(())
    }

    /// The luminance of the base colour where its channels are red, green and blue; of any other number of
    /// channels their mean.
    pub(super) fn luminance(&self) -> T {
        match *self.base_color.channels().as_ref() {
            [r, g, b] => luminance([r, g, b]),
            _ => self.base_color.mean(),
        }
    }

    /// The base colour over a luminance, white where that is 0.
    pub(super) fn tint(&self, luminance: T) -> C {
        let some = luminance.gt(T::lit(1e-30));
        let scale = T::one() / T::select(some, luminance, T::one());
        self.base_color.map(|base| T::select(some, base * scale, T::one()))
    }
}

/// The luminance of red, green and blue.
pub(crate) fn luminance<T: Real>([r, g, b]: [T; 3]) -> T {
    T::lit(0.3) * r + T::lit(0.6) * g + T::lit(0.1) * b
}
