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
