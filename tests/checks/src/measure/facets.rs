//! Directional albedo of microfacet models by adaptive quadrature of `eval` over the facets, in polar
//! coordinates around the viewer: another order of integration than any model's own.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use glam::DVec3;

use super::Model64;
use super::hemisphere::both_sides;

/// Halvings of an interval.
const DEPTH: u32 = 22;

/// ∫ f cosθᵢ dωᵢ of a lobe as wide as `width` in the angle of its facets, with an error of about
/// `tolerance`; `angles` are those of incidence where the reflectance is not smooth.
pub fn albedo(model: &Model64, wo: DVec3, width: f64, angles: &[f64], tolerance: f64) -> DVec3 {
    let (cos, sin) = (wo.z, wo.x.hypot(wo.y));
    let theta = sin.atan2(cos);
    let to_normal =
        if sin > 0.0 { DVec3::new(-wo.x * cos, -wo.y * cos, sin * sin) / sin } else { DVec3::X };
    let aside = wo.cross(to_normal);
    let mut ring = |angle: f64| {
        let (sin_d, cos_d) = angle.sin_cos();
        // Where the facet mirrors the horizon.
        let last = (cos / (2.0 * cos_d) - cos * cos_d) / (sin * sin_d).max(1e-300);
        if last >= 1.0 {
            return DVec3::ZERO;
        }
        let end = last.max(-1.0).acos();
        let mut value = |turn: f64| {
            let (across, along) = turn.sin_cos();
            let h = (wo * cos_d + (to_normal * along + aside * across) * sin_d).normalize();
            let wi = (h * (2.0 * wo.dot(h)) - wo).normalize();
            model.eval(wi, wo) * wi.z.max(0.0)
        };
        let narrow = (width / (sin * sin_d).max(1e-9).sqrt().max(sin_d)).min(3.0);
        let quarters = [-PI, -FRAC_PI_2, 0.0, FRAC_PI_2, PI];
        let centers = if sin < 0.02 { &quarters[..] } else { &quarters[2..3] };
        let edges = centers.iter().flat_map(|&center| graded(center, narrow, -end, end)).collect();
        let scale = 4.0 * cos_d * sin_d;
        integral(edges, 0.02 * tolerance / scale.max(1e-12), &mut value) * scale
    };
    let last = 0.5 * theta + FRAC_PI_4;
    let mut edges = graded(theta, width, 0.0, last);
    edges.extend(angles.iter().copied().filter(|angle| *angle < last));
    // From here on a part of the ring mirrors what is below the horizon.
    let whole = |angle: f64| 2.0 * angle.cos() * (theta + angle).cos() > cos;
    let (mut low, mut high) = (0.0, last);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if whole(middle) { low = middle } else { high = middle }
    }
    edges.push(low);
    integral(edges, 0.1 * tolerance, &mut ring)
}

/// Both ends, the center and ever wider distances from it.
fn graded(center: f64, width: f64, low: f64, high: f64) -> Vec<f64> {
    let widths = std::iter::successors(Some(width), |width| Some(3.0 * width));
    let steps = widths.take_while(|width| *width < high - low);
    let inner = steps.flat_map(|step| [center - step, center + step]).chain([center]);
    inner.filter(|edge| low < *edge && *edge < high).chain([low, high]).collect()
}

fn integral(mut edges: Vec<f64>, tolerance: f64, f: &mut dyn FnMut(f64) -> DVec3) -> DVec3 {
    edges.sort_by(f64::total_cmp);
    let pieces = edges.windows(2).filter(|ends| ends[1] - ends[0] > 1e-15);
    pieces.map(|ends| adaptive(ends[0], ends[1], tolerance, DEPTH, f)).sum()
}

fn adaptive(a: f64, b: f64, tolerance: f64, depth: u32, f: &mut dyn FnMut(f64) -> DVec3) -> DVec3 {
    let (center, half) = (0.5 * (a + b), 0.5 * (b - a));
    let (mut fine, mut coarse) = (DVec3::ZERO, DVec3::ZERO);
    for (node, kronrod, gauss) in both_sides() {
        let value = f(center + half * node);
        fine += value * (kronrod * half);
        coarse += value * (gauss * half);
    }
    let (error, size) = ((fine - coarse).abs().max_element(), fine.abs().max_element());
    // The estimate of QUADPACK.
    let error = if size > 0.0 { error.min(size * (200.0 * error / size).powf(1.5)) } else { 0.0 };
    if error <= tolerance || depth == 0 {
        return fine;
    }
    let tolerance = 0.7 * tolerance;
    adaptive(a, center, tolerance, depth - 1, f) + adaptive(center, b, tolerance, depth - 1, f)
}
