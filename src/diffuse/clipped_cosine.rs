//! The density that samples of rough diffuse surfaces follow: a cosine, stretched and sheared towards the
//! viewer and clipped at the horizon, beside a part of uniform directions.

use core::f64::consts::FRAC_1_PI;

use crate::direction::above_or_normal;
use crate::real::{Real, Vector};
use crate::sampling::uniform;

/// A cosine about the normal that the matrix
///
/// ```text
/// ⎡ a 0 b ⎤
/// ⎢ 0 c 0 ⎥
/// ⎣ d 0 1 ⎦
/// ```
///
/// takes elsewhere, in a frame whose x points below the viewer. Of the cosine only that part is drawn that
/// comes to lie above the surface.
pub(super) struct ClippedCosine<T> {
    a: T,
    b: T,
    c: T,
    d: T,
    /// The part of the cosine that is drawn.
    part: T,
    /// The probability of a uniform direction.
    uniform: T,
    /// x axis of the frame.
    axis: [T; 2],
}

impl<T: Real> ClippedCosine<T> {
    /// For a roughness in 0 … 1. A viewer that is no direction above the surface counts as the normal.
    #[inline(always)]
    pub(super) fn new(r: T, wo: T::Vec3) -> Self {
        let (zero, one) = (T::zero(), T::one());
        let wo = above_or_normal::<T, T::Vec3>(wo);
        let mu = wo.z().at_most(one);
        // At the normal no azimuth is the viewer's, and a root has no derivative at 0.
        let squared = wo.x().squared() + wo.y().squared();
        let tilted = squared.gt(T::lit(1e-36));
        let inverse = one / T::select(tilted, squared, one).sqrt();
        let axis =
            [T::select(tilted, wo.x() * inverse, one), (wo.y() * inverse).only_where(tilted)];

        let lit = T::lit;
        let a = one
            + r * (lit(0.303392)
                + (lit(-0.518982) + lit(0.111709) * mu) * mu
                + (lit(-0.276266) + lit(0.335918) * mu) * r);
        let b = r * (lit(-1.16407) + lit(1.15859) * mu + (lit(0.150815) - lit(0.150105) * mu) * r)
            / (mu.squared() * mu - lit(1.43545));
        let c = one + (lit(0.20013) + (lit(-0.506373) + lit(0.261777) * mu) * mu) * r;
        // The fit, 0.540852 − 1.01625μ + 0.475392μ² over −1.0743 + 0.0725628μ + μ², in powers of 1 − μ:
        // both nearly vanish at the normal, where the fit goes above 0 by 0.004 r.
        let versine = one - mu;
        let above = lit(-6e-6) + versine * (lit(0.065466) + lit(0.475392) * versine);
        let below = lit(-0.0017372) + versine * (lit(-2.0725628) + versine);
        let d = (r * (above / below)).min(zero);

        let rough = r.gt(zero);
        let share =
            lit(0.162925) + mu * (lit(-0.372058) + (lit(0.538233) - lit(0.290822) * mu) * mu);
        // A power of 0 has no derivative.
        let uniform = (T::select(rough, r, one).powf(lit(0.1)) * share).only_where(rough);
        let part = lit(0.5) + lit(0.5) / (d.squared() + one).sqrt();
        Self { a, b, c, d, part, uniform, axis }
    }

    /// Density per steradian of a direction above the surface.
    #[inline(always)]
    pub(super) fn pdf(&self, wi: T::Vec3) -> T {
        let Self { a, b, c, d, part, uniform, axis: [cos, sin] } = *self;
        let (x, y, z) = (wi.x() * cos + wi.y() * sin, wi.y() * cos - wi.x() * sin, wi.z());
        // The inverse matrix times the determinant.
        let minor = a - b * d;
        let [x, y, z] = [c * (x - b * z), minor * y, c * (a * z - d * x)];
        let stretch = c * minor / (x.squared() + y.squared() + z.squared());
        let cosine = stretch.squared() * z.max(T::zero()) * T::lit(FRAC_1_PI) / part;
        uniform * T::lit(0.5 * FRAC_1_PI) + (T::one() - uniform) * cosine
    }

    /// Draws a direction that does not lie below the surface.
    #[inline(always)]
    pub(super) fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let (zero, one, tiny) = (T::zero(), T::one(), T::lit(1e-30));
        let Self { a, b, c, d, part, axis: [cos, sin], .. } = *self;
        let [u, turn] = uniform(u);
        let (sin_phi, cos_phi) = turn.sin_cos_turns();

        let evenly = u.lt(self.uniform);
        let height = (u / T::select(evenly, self.uniform, one)).min(one);
        let radius = ((one - height) * (one + height)).max(tiny).sqrt();

        let rest = ((u - self.uniform) / (one - self.uniform)).max(zero);
        let disk = rest.sqrt();
        let (x, y) = (disk * cos_phi, disk * sin_phi);
        // Each chord of the disk is pressed into the part of it that comes to lie above the surface.
        let half = ((one - y) * (one + y)).max(tiny).sqrt();
        let x = -((one - part) * half + part * x);
        let z = ((half - x) * (half + x)).max(tiny).sqrt();
        let moved: T::Vec3 = Vector::new(a * x + b * z, c * y, (d * x + z).max(zero));
        let moved = Vector::normalize_or_normal(moved);

        let even: T::Vec3 = Vector::new(radius * cos_phi, radius * sin_phi, height);
        let turned = Vector::new(
            moved.x() * cos - moved.y() * sin,
            moved.x() * sin + moved.y() * cos,
            moved.z(),
        );
        Vector::select(evenly, even, turned)
    }
}
