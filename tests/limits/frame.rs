//! Shading frames are orthonormal and lead back where they came from.

use brdf::Frame;
use glam::{DVec3, Vec3};
use proptest::prelude::*;

fn unit() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-1.0..1.0_f64)
        .prop_filter("long enough", |v| DVec3::from_array(*v).length() > 1e-3)
        .prop_map(|v| DVec3::from_array(v).normalize())
}

fn assert_orthonormal(frame: &Frame<DVec3>) {
    let (t, b, n) = (frame.tangent(), frame.bitangent(), frame.normal());
    for (axis, other) in [(t, b), (b, n), (n, t)] {
        assert!(axis.dot(other).abs() < 1e-14, "{frame:?}");
        assert!((axis.length() - 1.0).abs() < 1e-14, "{frame:?}");
    }
    assert!(t.cross(b).abs_diff_eq(n, 1e-14), "not right-handed: {frame:?}");
}

proptest! {
    #[test]
    fn from_normal(normal in unit(), w in unit()) {
        let frame = Frame::from_normal(normal);
        assert_orthonormal(&frame);
        prop_assert!(frame.to_world(frame.to_local(w)).abs_diff_eq(w, 1e-14));
        prop_assert!(frame.to_local(normal).abs_diff_eq(DVec3::Z, 1e-14));
    }

    #[test]
    fn from_normal_and_tangent(normal in unit(), tangent in unit(), w in unit()) {
        let frame = Frame::from_normal_and_tangent(normal, tangent);
        assert_orthonormal(&frame);
        prop_assert!(frame.to_world(frame.to_local(w)).abs_diff_eq(w, 1e-14));
        prop_assert!(frame.to_local(tangent).y.abs() < 1e-10);
        prop_assert!(frame.to_local(tangent).x > 0.0);
    }

    #[test]
    fn in_f32(normal in unit(), w in unit()) {
        let frame = Frame::from_normal(normal.as_vec3());
        prop_assert!(frame.to_world(frame.to_local(w.as_vec3())).abs_diff_eq(w.as_vec3(), 1e-6));
    }
}

#[test]
fn degenerate_normals_and_tangents() {
    let poles = [DVec3::Z, DVec3::NEG_Z, DVec3::new(1e-300, 0.0, -1.0), DVec3::X, DVec3::NEG_Y];
    for normal in poles {
        assert_orthonormal(&Frame::from_normal(normal));
        // A tangent along the normal, and none at all.
        assert_orthonormal(&Frame::from_normal_and_tangent(normal, normal));
        assert_orthonormal(&Frame::from_normal_and_tangent(normal, DVec3::ZERO));
    }
    assert_eq!(Frame::from_normal(DVec3::ZERO).normal(), DVec3::Z);
    assert_eq!(Frame::from_normal(Vec3::ZERO).normal(), Vec3::Z);
}

/// A tangent almost along the normal leaves little to make perpendicular, in single precision too.
#[test]
fn tangents_close_to_the_normal() {
    for normal in [Vec3::new(0.3, 0.5, 0.8124038), Vec3::new(0.01039, -0.92697, -0.375)] {
        let normal = normal.normalize();
        for exponent in 0..60 {
            let offset = 0.1_f32 * 0.75_f32.powi(exponent);
            let frame = Frame::from_normal_and_tangent(normal, normal + Vec3::X * offset);
            let (t, b, n) = (frame.tangent(), frame.bitangent(), frame.normal());
            for (axis, other) in [(t, b), (b, n), (n, t)] {
                assert!(axis.dot(other).abs() < 3e-7, "{offset:e}: {frame:?}");
                assert!((axis.length() - 1.0).abs() < 3e-7, "{offset:e}: {frame:?}");
            }
        }
    }
}

#[test]
fn normals_of_any_length_and_of_none() {
    for length in [1e-30_f32, 1e-10, 1e15, 2e19, 1e38] {
        let frame = Frame::from_normal(Vec3::splat(length));
        assert!(frame.normal().abs_diff_eq(Vec3::splat(3.0_f32.sqrt().recip()), 1e-6), "{length}");
    }
    for nothing in [f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
        let frame = Frame::from_normal(Vec3::new(nothing, 0.5, 0.5));
        assert_eq!(frame.normal(), Vec3::Z, "{nothing}");
        let frame = Frame::from_normal_and_tangent(Vec3::X, Vec3::new(0.0, nothing, 0.0));
        assert!(frame.to_world(Vec3::ONE).is_finite(), "{nothing}");
    }
    let frame = Frame::from_normal(DVec3::splat(1e200));
    assert_orthonormal(&frame);
}
