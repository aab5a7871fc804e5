//! The planes through the normal in which an integral over facets counts them.

use core::array;
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use core::ops::{Add, Mul};

use super::shadowing::Kinks;
use crate::direction::above_or_normal;
use crate::distribution::{Spread, asinh, sinh};
use crate::quadrature::{NODES_32, NODES_48, integrate_with};
use crate::real::{Mask, Real, Vector};

/// The viewer, above the surface.
pub(super) struct Viewer<T: Real> {
    pub(super) wo: T::Vec3,
    sin: T,
    /// Cosine and sine of the azimuth.
    azimuth: [T; 2],
}

impl<T: Real> Viewer<T> {
    pub(super) fn new(wo: T::Vec3) -> Self {
        let wo = above_or_normal::<T, _>(wo);
        // What is closer to the horizon looks the same.
        let wo: T::Vec3 = Vector::new(wo.x(), wo.y(), wo.z().max(T::lit(1e-9)));
        let (azimuth, sin) = unit([wo.x(), wo.y()]);
        Self { wo, sin, azimuth }
    }
}

/// The unit vector of the same direction, and the length. (1, 0) where there is no direction.
fn unit<T: Real>([x, y]: [T; 2]) -> ([T; 2], T) {
    let squared = x.squared() + y.squared();
    let usable = squared.gt(T::lit(1e-36));
    let length = T::select(usable, squared, T::one()).sqrt();
    let inverse = T::one() / length;
    let direction = [T::select(usable, x * inverse, T::one()), (y * inverse).only_where(usable)];
    (direction, length.only_where(usable))
}

/// The planes of one kind of facets, as seen by a viewer.
///
/// The plane of ψ has slopes r (α_x cosψ, α_y sinψ). With B for their length per r, and A r for
/// what of a facet's 1 + A r turns towards the viewer, the last facet of the plane is that of
/// r = (A + √Q)/B² with Q = A² + B². Counted from the axis where it is largest,
/// Q ~ 1 + sinh²Y cos²ψ, which turns from A² into B² within a narrow angle if the viewer grazes or
/// the surface has grain. By
///
/// ```text
/// cosψ = sinh(Y cosζ)/sinh Y
/// ```
///
/// √Q becomes a cosh, and what was narrow in ψ is wide in ζ.
pub(super) struct Planes<T: Real> {
    along: [T; 2],
    /// α_x and α_y over the larger of the two.
    shape: [T; 2],
    /// Cosine and sine of the ψ of the axis.
    axis: [T; 2],
    /// Y, and 1 − exp(−2Y).
    length: T,
    whole: T,
    /// Where the integral over ζ is cut, in the order of ζ: the first two or all six.
    cuts: [Cut<T>; 6],
    count: usize,
    /// Whether the first of two cuts takes fewer nodes.
    steep: bool,
    /// Where the surface has grain. Elsewhere both sides of the axis are alike.
    grain: T::Mask,
}

/// A place to cut the integral.
#[derive(Clone, Copy)]
struct Cut<T> {
    zeta: T,
    /// The width of what is to be resolved here.
    width: T,
}

/// One of the planes.
pub(super) struct Plane<T> {
    /// Slopes of a facet of r = 1.
    pub(super) slopes: [T; 2],
    /// dψ/dζ.
    density: T,
}

impl<T: Real> Planes<T> {
    /// For facets whose shadowing has these kinks and whose reflectance has one at a cosine.
    pub(super) fn new(
        spread: &Spread<T>,
        kinks: Kinks,
        reflectance: Option<T>,
        viewer: &Viewer<T>,
    ) -> Self {
        let (one, along, wo) = (T::one(), spread.along(), viewer.wo);
        let scale = one / along[0].max(along[1]);
        let shape = along.map(|along| along * scale);

        // The matrix of Q (N·V)², its larger eigenvalue and twice the angle of its axis.
        let (cos, cross) = (wo.z(), shape[0] * shape[1] * wo.x() * wo.y());
        let diagonal = |shape: T, w: T| shape.squared() * (cos.squared() + w.squared());
        let (xx, yy) = (diagonal(shape[0], wo.x()), diagonal(shape[1], wo.y()));
        let (double, root) = unit([xx - yy, cross + cross]);
        let largest = (xx + yy + root) * T::lit(0.5);
        // The root of the quotient of both, cosh Y. The determinant is a square.
        let cosh = (largest / (cos * shape[0] * shape[1])).clamp(T::lit(1.2), T::lit(1e17));
        let length = (cosh + ((cosh - one) * (cosh + one)).sqrt()).ln();

        let grain = along[0].lt(along[1]).or(along[1].lt(along[0]));
        let cut = |zeta: f64| Cut { zeta: T::lit(zeta), width: T::lit(WIDE) };
        let mut planes = Self {
            along,
            shape,
            axis: half(double),
            length,
            whole: -(-(length + length)).exp_m1(),
            cuts: [-FRAC_PI_2, FRAC_PI_2, 0.0, 0.0, 0.0, 0.0].map(cut),
            count: 2,
            steep: false,
            grain,
        };
        match kinks {
            Kinks::Grooves => planes.cut_at_grooves(viewer),
            Kinks::None if spread.has_steep_facets() => planes.cut_at_smooth_axis(viewer),
            Kinks::None => {}
        }
        if let Some(cos) = reflectance {
            let [a, b] = planes.at_reflectance(viewer, cos);
            let [c, d] = planes.at_horizon(viewer, cos);
            planes.cuts = [planes.cuts[0], planes.cuts[1], a, b, c, d];
            planes.count = 6;
            planes.sort();
        }
        planes
    }

    /// Cuts where tanθ_o cosΔφ = 1: there begin the planes in which facets are masked.
    fn cut_at_grooves(&mut self, viewer: &Viewer<T>) {
        let cos = viewer.wo.z();
        let there = viewer.sin.gt(cos);
        let cos = T::select(there, cos / T::select(there, viewer.sin, T::one()), T::one());
        let zetas = self.beside(viewer, cos);
        for (cut, zeta) in self.cuts.iter_mut().zip(zetas) {
            cut.zeta = T::select(there, zeta, cut.zeta);
        }
    }

    /// Cuts where the planes begin that have facets of an angle, sinθ_d = sinθ_o |sinΔφ|, or across
    /// the viewer, where the smaller facets of that angle run along the planes.
    fn at_reflectance(&self, viewer: &Viewer<T>, cos: T) -> [Cut<T>; 2] {
        let (one, floor) = (T::one(), T::lit(1e-12));
        let difference = (cos - viewer.wo.z()) * (cos + viewer.wo.z());
        let squared = difference / viewer.sin.squared().max(T::lit(1e-6));
        let begin = squared.clamp(floor, one).sqrt();
        let width = squared.abs().max(floor).sqrt();
        let zetas = self.beside(viewer, begin);
        let others = self.beside(viewer, (begin + width).min(one));
        array::from_fn(|side| {
            let width = (zetas[side] - others[side]).abs();
            Cut { zeta: zetas[side], width: width.max(T::lit(1e-4)) }
        })
    }

    /// Cuts where a facet of an angle mirrors the horizon, cosθ_h = cosθ_o/(2 cosθ_d).
    fn at_horizon(&self, viewer: &Viewer<T>, cos: T) -> [Cut<T>; 2] {
        let (one, cos_o) = (T::one(), viewer.wo.z());
        let cos_h = T::lit(0.5) * cos_o / cos.max(T::lit(1e-9));
        let sines = viewer.sin * ((one - cos_h) * (one + cos_h)).max(T::lit(1e-30)).sqrt();
        let quotient = (cos - cos_o * cos_h) / sines.max(T::lit(1e-15));
        let there = cos_h.lt(one).and(quotient.abs().lt(one));
        let zetas = self.beside(viewer, quotient.only_where(there));
        let elsewhere = [-0.75 * PI, 0.75 * PI];
        array::from_fn(|side| {
            let zeta = T::select(there, zetas[side], T::lit(elsewhere[side]));
            Cut { zeta, width: T::lit(WIDE) }
        })
    }

    /// ζ of both azimuths with this cosine from the viewer, in their order.
    fn beside(&self, Viewer { azimuth: [x, y], .. }: &Viewer<T>, cos: T) -> [T; 2] {
        let sin = ((T::one() - cos) * (T::one() + cos)).max(T::lit(1e-30)).sqrt();
        let sides = [-sin, sin].map(|sin| self.zeta([*x * cos - *y * sin, *y * cos + *x * sin]));
        [sides[0].min(sides[1]), sides[0].max(sides[1])]
    }

    /// Orders the cuts.
    fn sort(&mut self) {
        let (pi, turn) = (T::lit(PI), T::lit(TAU));
        let cuts = &mut self.cuts[..self.count];
        for cut in &mut *cuts {
            cut.zeta = T::select(cut.zeta.lt(-pi), cut.zeta + turn, cut.zeta);
        }
        for end in (1..cuts.len()).rev() {
            for low in 0..end {
                let [a, b] = [cuts[low], cuts[low + 1]];
                let swapped = b.zeta.lt(a.zeta);
                let choose = |yes: &Cut<T>, no: &Cut<T>| Cut {
                    zeta: T::select(swapped, yes.zeta, no.zeta),
                    width: T::select(swapped, yes.width, no.width),
                };
                (cuts[low], cuts[low + 1]) = (choose(&b, &a), choose(&a, &b));
            }
        }
    }

    /// Cuts where steep facets mirror the viewer into the axis along which the surface is smoother:
    /// that way Smith's shadowing changes within a narrow angle.
    fn cut_at_smooth_axis(&mut self, viewer: &Viewer<T>) {
        let [x, y] = viewer.azimuth;
        let one = T::one();
        let smooth_x = self.shape[0].lt(self.shape[1]);
        let between = [
            T::select(smooth_x, x + one.copysign(x), x),
            T::select(smooth_x, y, y + one.copysign(y)),
        ];
        let zeta = self.zeta(between);
        let narrow = T::lit(0.5) * self.shape[0].min(self.shape[1]).squared();
        let width = narrow.max(T::lit(0.04)) / self.at(zeta).density;
        let [first, second, ..] = &mut self.cuts;
        first.zeta = T::select(self.grain, zeta - T::lit(PI), first.zeta);
        self.steep = true;
        second.zeta = T::select(self.grain, zeta, second.zeta);
        second.width = T::select(self.grain, width, second.width);
    }

    /// ζ of facets that are tilted in this azimuth.
    fn zeta(&self, [x, y]: [T; 2]) -> T {
        let ([x, y], _) = unit([x * self.shape[1], y * self.shape[0]]);
        let [axis_x, axis_y] = self.axis;
        let (cos, sin) = (x * axis_x + y * axis_y, y * axis_x - x * axis_y);
        let part = asinh(cos.abs() * sinh(self.length)) / self.length;
        // The arc cosine has no derivative at its end.
        part.min(T::lit(1.0 - 1e-7)).copysign(cos).acos().copysign(sin)
    }

    pub(super) fn at(&self, zeta: T) -> Plane<T> {
        let two = T::lit(2.0);
        let (sin_half, cos_half) = (zeta * T::lit(0.5)).sin_cos();
        // Y (1 − cosζ) and Y (1 + cosζ), with x/(1 − exp(−2x)) of both.
        let ends = [sin_half, cos_half].map(|half| two * self.length * half.squared());
        let [front, back] = ends.map(|end| (-end).exp());
        let [of_front, of_back] = ends.map(|end| {
            let end = end.max(T::lit(1e-12));
            end / -(-(end + end)).exp_m1()
        });
        let root = (of_front * of_back).sqrt();
        let cos = (front - back) / self.whole;
        let sin = self.length * (two * sin_half * cos_half) / (self.whole * root);
        let [axis_x, axis_y] = self.axis;
        Plane {
            slopes: [
                self.along[0] * (axis_x * cos - axis_y * sin),
                self.along[1] * (axis_y * cos + axis_x * sin),
            ],
            density: (front + back) * root,
        }
    }

    /// ∫ dψ of what the facets of a plane sum up to.
    pub(super) fn integral<A>(&self, of_plane: &impl Fn(&Plane<T>) -> A, choose: Choose<T, A>) -> A
    where
        A: Copy + Add<Output = A> + Mul<T, Output = A>,
    {
        let (half, turn) = (self.count / 2, T::lit(TAU));
        let part = |index: usize| {
            let zeta = |index: usize| self.cuts[index % self.count].zeta;
            let before = if index == 0 { zeta(self.count - 1) - turn } else { zeta(index - 1) };
            let after = if index + 1 == self.count { zeta(0) + turn } else { zeta(index + 1) };
            let middles = [before, after].map(|other| (other + zeta(index)) * T::lit(0.5));
            let fine = self.count == 2 && (index == 1 || !self.steep);
            self.to_cut(&self.cuts[index], fine, middles, of_plane)
        };
        let sum = |first: usize| (1..half).fold(part(first), |sum, next| sum + part(first + next));
        let upper = sum(half);
        if self.grain.is_never() {
            return upper + upper;
        }
        upper + choose(self.grain, sum(0), upper)
    }

    /// The part between a cut and the middles of both arcs that it ends.
    #[inline(never)]
    fn to_cut<A>(
        &self,
        cut: &Cut<T>,
        fine: bool,
        middles: [T; 2],
        of_plane: &impl Fn(&Plane<T>) -> A,
    ) -> A
    where
        A: Copy + Add<Output = A> + Mul<T, Output = A>,
    {
        let (zero, one) = (T::zero(), T::one());
        let [near, far] = middles.map(|middle| {
            let arc = middle - cut.zeta;
            let crowding = asinh(arc.abs() / cut.width).max(T::lit(0.3));
            let inverse = one / sinh(crowding);
            // From the cut on, where nodes are as dense as its width is narrow.
            let of_part = |part: T| {
                let sinh = sinh(crowding * part);
                let cosh = (one + sinh.squared()).sqrt();
                let plane = self.at(cut.zeta + arc * (sinh * inverse));
                let density = plane.density * (arc.abs() * crowding * inverse * cosh);
                of_plane(&plane) * density
            };
            if fine {
                integrate_with(&NODES_48, zero, one, of_part)
            } else {
                integrate_with(&NODES_32, zero, one, of_part)
            }
        });
        near + far
    }
}

/// Wider than any arc.
const WIDE: f64 = 100.0;

/// One of two values by a mask.
pub(super) type Choose<T, A> = fn(<T as Real>::Mask, A, A) -> A;

/// Half of an angle in −π … π, both as cosine and sine.
fn half<T: Real>([cos, sin]: [T; 2]) -> [T; 2] {
    let larger = ((T::one() + cos.abs()) * T::lit(0.5)).sqrt();
    let smaller = sin.abs() * T::lit(0.5) / larger;
    let front = cos.ge(T::zero());
    [T::select(front, larger, smaller), T::select(front, smaller, larger).copysign(sin)]
}
