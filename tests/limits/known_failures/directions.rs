//! Frames, refraction and angles where they have no direction to follow.

use brdf::{Frame, Pair, Vector, critical_angle, reflect, refract, to_spherical};

use super::{Number, assert_near, in_both_numbers, vector};

in_both_numbers! {
    /// pbrt-v3 #254, glm #1451, #1452: NaN from refraction where the reflection is total.
    total_reflection_is_a_mirror(total_reflection);
    /// OpenPBR #142: the two indices change places for light from below.
    light_from_below_takes_the_indices_in_its_order(from_below);
    /// ByroRedux #820, #3984: a tangent along the normal, or a normal without length, makes a
    /// frame of NaN.
    frames_of_useless_vectors(useless_frames);
    /// coreBlackbird #64, adobe/openpbr-bsdf #24: the azimuth of the normal itself.
    the_normal_has_azimuth_zero(azimuths);
    /// The half vector of two opposite directions is 0/0.
    half_vectors_of_opposite_directions(opposite);
}

fn numbers<T: Number>(v: T::Vec3) -> [f64; 3] {
    [v.x(), v.y(), v.z()].map(Number::double)
}

#[track_caller]
fn assert_close<T: Number>(got: T::Vec3, want: [f64; 3], tolerance: f64) {
    for (got, want) in numbers::<T>(got).into_iter().zip(want) {
        assert!((got - want).abs() <= tolerance, "{got} instead of {want}");
    }
}

fn total_reflection<T: Number>() {
    let normal = vector::<T>(0.0, 0.0, 1.0);
    let (glass, air) = (T::lit(1.5), T::lit(1.0));
    let critical: f64 = critical_angle(glass, air).double();
    for beyond in [1e-3, 0.1, std::f64::consts::FRAC_PI_2 - critical] {
        let theta = critical + beyond;
        let w = vector::<T>(theta.sin(), 0.0, theta.cos());
        let answer = refract(w, normal, glass, air);
        assert!(answer.total_internal_reflection);
        assert_close::<T>(answer.direction, [-theta.sin(), 0.0, theta.cos()], 1e-6);
    }
    // Just before it the refracted direction grazes: its cosine is √(1 − n² sin²θ).
    for before in [1e-3, 1e-2, 0.2] {
        let theta = critical - before;
        let w = vector::<T>(theta.sin(), 0.0, theta.cos());
        let answer = refract(w, normal, glass, air);
        assert!(!answer.total_internal_reflection);
        let sin = 1.5 * theta.sin();
        assert_close::<T>(answer.direction, [-sin, 0.0, -(1.0 - sin * sin).sqrt()], 1e-5);
    }
    // At the horizon light enters the denser medium under the critical angle.
    let answer = refract(vector::<T>(1.0, 0.0, 0.0), normal, air, glass);
    assert_close::<T>(answer.direction, [-1.0 / 1.5, 0.0, -(5.0_f64.sqrt() / 3.0)], 1e-6);
}

fn from_below<T: Number>() {
    let normal = vector::<T>(0.0, 0.0, 1.0);
    let (above, below) = (T::lit(1.2), T::lit(1.7));
    for theta in [0.0, 1e-4, 0.3, 1.0, 1.57] {
        let (sin, cos): (f64, f64) = (f64::sin(theta), f64::cos(theta));
        let w = vector::<T>(sin, 0.0, cos);
        let down = refract(w, normal, above, below);
        let sin_t = 1.2 / 1.7 * sin;
        assert_close::<T>(down.direction, [-sin_t, 0.0, -(1.0 - sin_t * sin_t).sqrt()], 1e-6);
        // The way back: from there the light comes out along w.
        let up = refract(down.direction, normal, above, below);
        assert!(!up.total_internal_reflection);
        assert_close::<T>(up.direction, [sin, 0.0, cos], 4e-4 * cos.mul_add(-1.0, 1.0) + 2e-6);
        // The mirror direction stays on its own side, whichever it is.
        assert_close::<T>(reflect(w, normal), [-sin, 0.0, cos], T::EPSILON);
        assert_close::<T>(reflect(-w, normal), [sin, 0.0, -cos], T::EPSILON);
    }
}

fn useless_frames<T: Number>() {
    let n = vector::<T>(0.48, 0.6, 0.64);
    let around = Frame::from_normal(n);
    let useless = [[0.0; 3], [f64::NAN, 0.0, 1.0], [0.0, 1.0, f64::INFINITY]];
    let along = [n, -n, n * T::lit(1e-30)];
    for tangent in useless.map(|[x, y, z]| vector::<T>(x, y, z)).into_iter().chain(along) {
        let frame = Frame::from_normal_and_tangent(n, tangent);
        assert_close::<T>(frame.tangent(), numbers::<T>(around.tangent()), 1e-6);
        assert_close::<T>(frame.normal(), [0.48, 0.6, 0.64], 1e-6);
        assert_close::<T>(frame.to_local(n), [0.0, 0.0, 1.0], 1e-6);
    }
    for normal in [[0.0; 3], [1e-45, 0.0, -1e-45], [f64::NAN; 3], [f64::INFINITY, 0.0, 1.0]] {
        let frame = Frame::from_normal(vector::<T>(normal[0], normal[1], normal[2]));
        assert_close::<T>(frame.normal(), [0.0, 0.0, 1.0], 0.0);
        assert_close::<T>(frame.to_world(n), [0.48, 0.6, 0.64], 1e-6);
    }
    // Straight down, where formulas divide by 1 + n_z.
    let frame = Frame::from_normal(vector::<T>(0.0, 0.0, -1.0));
    assert_close::<T>(frame.to_local(vector::<T>(0.0, 0.0, -1.0)), [0.0, 0.0, 1.0], 0.0);
    let handed = Vector::dot(Vector::cross(frame.tangent(), frame.bitangent()), frame.normal());
    assert_near(handed, 1.0, 1e-6);
}

fn azimuths<T: Number>() {
    let (theta, phi) = to_spherical(vector::<T>(0.0, 0.0, 1.0));
    assert_eq!([theta, phi].map(Number::double), [0.0, 0.0]);
    let (theta, phi) = to_spherical(vector::<T>(0.0, 0.0, -1.0));
    assert_near(theta, std::f64::consts::PI, T::EPSILON);
    assert_near(phi, 0.0, 0.0);
    let (theta, _) = to_spherical(vector::<T>(0.0, 1e-18, 1.0));
    assert_near(theta, 1e-18, 2.0 * T::EPSILON);
    let (theta, phi) = to_spherical(vector::<T>(1e-15, -1e-15, 1.0));
    assert_near(theta, 2.0_f64.sqrt() * 1e-15, 4.0 * T::EPSILON);
    assert_near(phi, -std::f64::consts::FRAC_PI_4, 4.0 * T::EPSILON);
}

fn opposite<T: Number>() {
    // Both at the horizon, as far above it as the number allows: h is the normal.
    let up = T::LEAST;
    let pair = Pair::<T>::new(vector::<T>(1.0, 0.0, up), vector::<T>(-1.0, 0.0, up));
    assert!(pair.above);
    assert_close::<T>(pair.h, [0.0, 0.0, 1.0], 0.0);
    assert!(pair.cos_d > T::lit(0.0));
    // Opposite through the surface: no pair, and a finite h all the same.
    let w = vector::<T>(0.6, 0.0, 0.8);
    let pair = Pair::<T>::new(w, -w);
    assert!(!pair.above);
    assert_near(Vector::length_squared(pair.h), 1.0, 0.0);
}
