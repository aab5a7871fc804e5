//! Integrals over facet normals, in slopes that are scaled so that the distribution is about 1 wide.

use std::f64::consts::FRAC_PI_2;

use brdf::quadrature::integrate;
use glam::DVec3;

/// Coordinates of the normals that face `wo`, in which every distribution here is smooth up to its
/// edges: slopes divided by the scale, turned so that x runs along the azimuth of `wo` and ends
/// where facets turn away; angles χ with x = tan χ and ψ with y = √(1 + x²) tan ψ.
pub struct Facing {
    scale: [f64; 2],
    azimuth: [f64; 2],
    /// The ends of χ.
    pub chi: [f64; 2],
    /// The ends of ψ.
    pub psi: [f64; 2],
}

impl Facing {
    /// The normals that face `wo`, of slopes about as wide as `scale`.
    pub fn new(wo: DVec3, scale: [f64; 2]) -> Self {
        let (x, y) = (scale[0] * wo.x, scale[1] * wo.y);
        let spread = x.hypot(y);
        let azimuth = if spread > 0.0 { [x / spread, y / spread] } else { [1.0, 0.0] };
        Self { scale, azimuth, chi: [-FRAC_PI_2, wo.z.atan2(spread)], psi: [-FRAC_PI_2, FRAC_PI_2] }
    }

    /// The normal at (χ, ψ), and the solid angle that belongs to dχ dψ there.
    pub fn normal(&self, chi: f64, psi: f64) -> (DVec3, f64) {
        let x = chi.tan();
        let hypotenuse = x.hypot(1.0);
        let y = hypotenuse * psi.tan();
        let [cos, sin] = self.azimuth;
        let slopes = [x * cos - y * sin, x * sin + y * cos];
        let h = DVec3::new(-slopes[0] * self.scale[0], -slopes[1] * self.scale[1], 1.0).normalize();
        // d²slope = dω/cos³, dx = (1 + x²) dχ, dy = √(1 + x²) dψ/cos²ψ.
        let area = self.scale[0] * self.scale[1] * hypotenuse.powi(3) / psi.cos().powi(2);
        (h, area * h.z.powi(3))
    }

    /// (χ, ψ) of a normal.
    pub fn coordinates(&self, h: DVec3) -> [f64; 2] {
        let slopes = [-h.x / (h.z * self.scale[0]), -h.y / (h.z * self.scale[1])];
        let [cos, sin] = self.azimuth;
        let (x, y) = (slopes[0] * cos + slopes[1] * sin, slopes[1] * cos - slopes[0] * sin);
        [x.atan(), (y / x.hypot(1.0)).atan()]
    }

    /// ∫ `formula`(h) dω over a rectangle of χ and ψ, cut into `panels`² parts.
    pub fn integral(
        &self,
        chi: [f64; 2],
        psi: [f64; 2],
        panels: u32,
        formula: impl Fn(DVec3) -> f64,
    ) -> f64 {
        composite(chi, panels, |chi| {
            composite(psi, panels, |psi| {
                let (h, area) = self.normal(chi, psi);
                formula(h) * area
            })
        })
    }
}

/// Gauss–Legendre quadrature on each of equal panels.
pub fn composite([from, to]: [f64; 2], panels: u32, formula: impl Fn(f64) -> f64) -> f64 {
    let at = |panel: u32| from + (to - from) * f64::from(panel) / f64::from(panels);
    (0..panels).map(|panel| integrate(at(panel), at(panel + 1), &formula)).sum()
}
