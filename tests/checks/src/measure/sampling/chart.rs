//! The hemisphere as a rectangle.

use std::f64::consts::PI;

use glam::DVec3;

use super::partition::Rectangle;

/// Coordinates (q, φ) of directions: q from 0 at the normal to 1 at the horizon with
/// (1 − q)² = 1 − s and s = √(1 − cosθ), φ the azimuth from that of the mirror direction, cut
/// opposite to it. The map is smooth, dω = 2 s ds dφ, and q gives room to the last thousandths
/// above the horizon, where models have kinks for a viewer who grazes.
pub struct Chart {
    /// Cosine and sine of the azimuth of the mirror direction.
    mirror: [f64; 2],
}

impl Chart {
    /// All of it.
    pub const WHOLE: Rectangle = Rectangle { from: [0.0, -PI], to: [1.0, PI] };

    /// The hemisphere as seen with the mirror direction of `wo` in front.
    pub fn new(wo: DVec3) -> Self {
        let spread = wo.x.hypot(wo.y);
        Self { mirror: if spread > 0.0 { [-wo.x / spread, -wo.y / spread] } else { [1.0, 0.0] } }
    }

    /// Where a direction lies; 1 − cosθ and 1 − s without a difference.
    pub fn place(&self, w: DVec3) -> [f64; 2] {
        let [cos, sin] = self.mirror;
        let s = ((w.x * w.x + w.y * w.y) / (1.0 + w.z)).sqrt();
        let q = s / (1.0 + (w.z / (1.0 + s)).sqrt());
        [q, (cos * w.y - sin * w.x).atan2(cos * w.x + sin * w.y)]
    }

    /// The direction at a place, and the solid angle that belongs to dq dφ there.
    pub fn direction(&self, [q, phi]: [f64; 2]) -> (DVec3, f64) {
        let [cos, sin] = self.mirror;
        let s = q * (2.0 - q);
        let sin_theta = s * (2.0 - s * s).sqrt();
        let (y, x) = phi.sin_cos();
        let (x, y) = (x * cos - y * sin, x * sin + y * cos);
        let z = (1.0 - q) * (1.0 - q) * (1.0 + s);
        (DVec3::new(sin_theta * x, sin_theta * y, z), 4.0 * s * (1.0 - q))
    }
}
