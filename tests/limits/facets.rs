//! Areas of facets: every distribution of normals is normalised, and what is visible of it fills
//! what is visible of the surface, with every shadowing.

use brdf::{
    Beckmann, Blinn, Distribution, Gaussian, Ggx, SmithCorrelated, SmithSeparable, VCavity,
};
use brdf_checks::directions::pairs;
use brdf_checks::distributions::{with_smith, without_smith};
use brdf_checks::measure::furnace::weak_furnace;
use brdf_checks::measure::normalization::{projected_area, projected_area_by_angle};
use glam::{DVec3, Vec3};

/// ∫ D cosα dω = 1 from roughness 10⁻⁴ to 10, isotropic and not.
#[test]
fn every_distribution_is_normalised() {
    let roughness = [1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 1.0, 3.0, 10.0];
    let check = |name: &str, area: f64| {
        assert!((area - 1.0).abs() < 1e-10, "{name}: {:e} off", area - 1.0);
    };
    for x in roughness {
        for surface in without_smith(x) {
            check(&surface.name, projected_area(&surface.distribution, surface.scale));
        }
        for y in roughness {
            for surface in with_smith(x, y) {
                check(&surface.name, projected_area(&surface.distribution, surface.scale));
            }
        }
    }
    // To the ends of the parameters, and closely, since the constant of the Gaussian is made of
    // several formulas.
    for step in -64..=32 {
        let roughness = 10.0_f64.powf(f64::from(step) / 8.0);
        let gaussian = Gaussian::new(roughness).unwrap();
        check(&format!("Gaussian {roughness}"), projected_area_by_angle(&gaussian, roughness));
    }
    for exponent in [0.0, 0.5, 1.0, 10.0, 1e3, 1e6, 1e8_f64] {
        let width = (2.0 / (exponent + 2.0)).sqrt();
        let blinn = Blinn::new(exponent).unwrap();
        check(&format!("Blinn, exponent {exponent}"), projected_area_by_angle(&blinn, width));
    }
}

fn viewer(cos: f64) -> DVec3 {
    DVec3::new(0.6, 0.8, 0.0) * ((1.0 - cos) * (1.0 + cos)).sqrt() + DVec3::Z * cos
}

fn check_furnace(what: &str, wo: DVec3, total: f64) {
    assert!((total - 1.0).abs() < 1e-9, "{what} from {wo}: {:e} off", total - 1.0);
}

/// The weak white furnace of V-shaped cavities, from the normal to cosθ = 10⁻³, off the axes.
#[test]
fn facets_that_are_visible_in_v_cavities_fill_the_projected_area() {
    for x in [1e-3, 0.01, 0.1, 0.3, 1.0] {
        for wo in [1.0, 0.9, 0.5, 0.1, 0.01, 1e-3].map(viewer) {
            for surface in without_smith(x) {
                let total = weak_furnace(&surface.distribution, &VCavity, surface.scale, wo);
                check_furnace(&surface.name, wo, total);
            }
            for surface in with_smith(x, x).into_iter().chain(with_smith(x, 0.2)) {
                let total = weak_furnace(&surface.distribution, &VCavity, surface.scale, wo);
                check_furnace(&surface.name, wo, total);
            }
        }
    }
}

/// That of Smith's shadowing, which holds only with the Λ that belongs to the distribution; to
/// where cosθ is nothing beside the slopes.
#[test]
fn facets_that_are_visible_on_random_surfaces_fill_the_projected_area() {
    for x in [1e-3, 0.01, 0.1, 0.3, 1.0, 3.0] {
        for wo in [1.0, 0.9, 0.5, 0.1, 1e-3, 1e-8, 1e-20].map(viewer) {
            for surface in with_smith(x, x).into_iter().chain(with_smith(x, 0.2)) {
                let (normals, scale) = (&surface.distribution, surface.scale);
                check_furnace(
                    &surface.name,
                    wo,
                    weak_furnace(normals, &SmithCorrelated, scale, wo),
                );
                check_furnace(&surface.name, wo, weak_furnace(normals, &SmithSeparable, scale, wo));
            }
        }
    }
}

/// Far off the normal of a surface that is almost a mirror nothing is left, and the largest
/// factors of the formula meet the smallest.
#[test]
fn nothing_is_left_far_off_the_normal() {
    for roughness in [1e-8_f32, 1e-6, 1e-4] {
        let smooth = Beckmann::new(roughness).unwrap();
        for cos in [1e-9_f32, 1.1e-8, 1e-7, 1e-5, 1e-3] {
            let h = Vec3::new((1.0 - cos * cos).sqrt(), 0.0, cos);
            assert_eq!(smooth.density(h), 0.0, "{roughness:e} {cos:e}");
        }
    }
}

/// In single precision the squares of the lengths may be 10⁻²⁸ … 10²² for any roughness.
#[test]
fn densities_along_vectors_of_any_length_in_single_precision() {
    let ends = [1e-8_f32, 1e-5, 1e-2, 0.5, 10.0, 1e4];
    for (along_x, along_y) in ends.into_iter().flat_map(|x| ends.map(|y| (x, y))) {
        let ggx = Ggx::anisotropic(along_x, along_y).unwrap();
        for (h, _) in pairs(1000) {
            let h = h.as_vec3();
            let density = ggx.density(h);
            for length in [1e-14_f32, 1e-7, 2.0, 1e6, 1e11] {
                let error = (ggx.density_along(h * length) - density).abs();
                // Below, there are fewer digits.
                assert!(
                    error <= 2e-6 * density.max(1e-30),
                    "{along_x:e}, {along_y:e}: {h} {length:e}"
                );
            }
        }
    }
}

/// The length of a vector does not matter where its direction is asked for. An exponential down to
/// e⁻⁷⁰⁰ multiplies the rounding of its argument by as much.
#[test]
fn densities_along_vectors_of_any_length() {
    for x in [0.01, 0.3, 2.0] {
        for surface in with_smith(x, 0.5) {
            let distribution = &surface.distribution;
            for (h, _) in pairs(1000) {
                let density = distribution.density(h);
                for length in [1e-15, 0.3, 2.0, 1e15] {
                    let along = distribution.density_along(h * length);
                    let error = (along - density).abs();
                    assert!(error <= 1e-12 * density, "{}: {h} {length}", surface.name);
                }
            }
        }
    }
}
