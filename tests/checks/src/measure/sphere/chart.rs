//! Cells of the whole sphere.

use std::f64::consts::TAU;

use brdf::Frame;
use glam::DVec3;

/// Directions of both sides by their distance from the mirror direction, or from its mirror image below,
/// crowded there: 1 − cosθ ~ x³.
pub struct Chart {
    frame: Frame<DVec3>,
}

impl Chart {
    /// Cells along x and around it.
    const PARTS: [usize; 2] = [12, 16];
    pub const CELLS: usize = 2 * Self::PARTS[0] * Self::PARTS[1];
    /// Steps of the integral along either.
    const STEPS: usize = 480;

    pub fn new(wo: DVec3) -> Self {
        Self { frame: Frame::from_normal(DVec3::new(-wo.x, -wo.y, wo.z.abs())) }
    }

    fn index(below: bool, place: [f64; 2]) -> usize {
        let [x, around] = [0, 1].map(|axis| {
            let parts = Self::PARTS[axis];
            ((place[axis] * parts as f64) as usize).min(parts - 1)
        });
        (usize::from(below) * Self::PARTS[0] + x) * Self::PARTS[1] + around
    }

    pub fn cell(&self, w: DVec3) -> usize {
        let local = self.frame.to_local(DVec3::new(w.x, w.y, w.z.abs()));
        // 1 − cosθ without the difference.
        let sin_squared = local.x * local.x + local.y * local.y;
        let near = sin_squared / (1.0 + local.z.max(0.0));
        let versine = if local.z > 0.0 { near } else { 1.0 - local.z };
        Self::index(
            w.z < 0.0,
            [(versine * 0.5).cbrt(), local.y.atan2(local.x).rem_euclid(TAU) / TAU],
        )
    }

    /// Every direction with its cell and the solid angle around it.
    pub fn visit(&self, mut visit: impl FnMut(usize, DVec3, f64)) {
        let place = |index: usize| (index as f64 + 0.5) / Self::STEPS as f64;
        for i in 0..Self::STEPS {
            let x = place(i);
            let (versine, width) = (2.0 * x.powi(3), 6.0 * x * x / Self::STEPS as f64);
            let sin = (versine * (2.0 - versine)).sqrt();
            for j in 0..Self::STEPS {
                let around = place(j);
                let (s, c) = (TAU * around).sin_cos();
                let w = self.frame.to_world(DVec3::new(sin * c, sin * s, 1.0 - versine));
                if w.z > 0.0 {
                    let angle = width * TAU / Self::STEPS as f64;
                    visit(Self::index(false, [x, around]), w, angle);
                    visit(Self::index(true, [x, around]), DVec3::new(w.x, w.y, -w.z), angle);
                }
            }
        }
    }
}
