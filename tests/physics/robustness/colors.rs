//! Colours, integrals and measured materials for odd inputs.

use brdf::colorimetry::{clamp_to_srgb, linear_srgb_to_xyz, xyz_to_linear_srgb};
use brdf::quadrature::{integrate, mean_over_square};
use brdf::{Illuminant, Observer, Spectrum};
use glam::DVec3;

use super::inputs::NUMBERS;

#[test]
fn observers_of_odd_wavelengths() {
    let refused = |wavelengths: [f64; 3]| {
        let error = Observer::<f64, 3>::new(Illuminant::E, wavelengths).unwrap_err();
        assert_eq!(error.parameter(), "wavelength", "{wavelengths:?}");
        error.value()
    };
    assert_eq!(refused([500.0, 500.0, 600.0]), 500.0);
    assert_eq!(refused([600.0, 500.0, 700.0]), 500.0);
    assert_eq!(refused([0.0, 500.0, 700.0]), 0.0);
    assert_eq!(refused([400.0, 500.0, f64::INFINITY]), f64::INFINITY);
    assert!(refused([400.0, f64::NAN, 700.0]).is_nan());
    // No overlap with what the eye sees, neighbours in the last bit, one wavelength, none.
    let white = |wavelengths: [f64; 3]| {
        let observer = Observer::<f64, 3>::new(Illuminant::D65, wavelengths).unwrap();
        observer.xyz(Spectrum([1.0; 3])).y
    };
    for wavelengths in [
        [100.0, 100.0_f64.next_up(), 101.0],
        [1e4, 1e5_f64.next_down(), 1e5],
        [555.0, 555.0_f64.next_up(), 555.0_f64.next_up().next_up()],
        [100.0, 555.0, 1e5],
    ] {
        assert!((white(wavelengths) - 1.0).abs() < 1e-12, "{wavelengths:?}");
    }
    let one = Observer::<f32, 1>::new(Illuminant::A, [600.0]).unwrap();
    assert!((one.xyz(Spectrum([0.5])).y - 0.5).abs() < 1e-6);
    assert!(Observer::<f32, 0>::new(Illuminant::A, []).is_err());
}

#[test]
fn colours_of_any_numbers() {
    for a in NUMBERS {
        let shown = clamp_to_srgb(DVec3::new(a, -a, 0.5));
        assert!((DVec3::ZERO.cmple(shown) & shown.cmple(DVec3::ONE)).all(), "{a}: {shown}");
        // Too small and too large numbers lose digits on the way, the others come back.
        if a.abs() > 1e-300 && a.abs() < 1e300 {
            let color = DVec3::new(a, 0.25 * a, -a);
            let back = xyz_to_linear_srgb(linear_srgb_to_xyz(color));
            assert!((back - color).abs().max_element() <= 1e-14 * a.abs(), "{a}: {back}");
        }
    }
}

#[test]
fn integrals_over_odd_intervals() {
    let cube = |x: f64| x * x * x;
    assert_eq!(integrate(0.5, 0.5, cube), 0.0);
    assert!((integrate(2.0, 0.0, cube) + 4.0).abs() < 1e-14);
    assert!((integrate(-1e100, 1e100, |_| 1.0_f64) / 2e100 - 1.0).abs() < 1e-14);
    assert_eq!(integrate(0.0, 5e-324, |_| 1.0_f64), 0.0);
    assert!(integrate(0.0, f64::NAN, cube).is_nan());
    // The ends are never asked for.
    assert!((integrate(0.0, 1.0, |x: f64| x.sqrt().recip()) - 2.0).abs() < 0.03);
    assert!(mean_over_square(|[x, y]: [f32; 2]| 1.0 / (x * y * (1.0 - x) * (1.0 - y))).is_finite());
    // The sum of the lattice's 4181 values stays in range.
    let large = f32::MAX / 8192.0;
    assert!((mean_over_square(|_: [f32; 2]| large) / large - 1.0).abs() < 2e-7);
}

#[cfg(feature = "materials")]
#[test]
fn materials_of_odd_names_and_wavelengths() {
    use brdf::materials::{GOLD, LookupError, find};

    for name in ["", " ", "(", ",", "()", "Au\0", "A\u{f9}", "\u{1F947}", "au au", "\"", "\\"] {
        let error = find(name).unwrap_err();
        assert!(matches!(error, LookupError::Unknown { .. }), "{name:?}: {error}");
    }
    assert_eq!(find("\t GoLd\n").unwrap().key(), "Au");
    for wavelength in NUMBERS {
        let error = GOLD.refractive_index(wavelength).unwrap_err();
        assert_eq!(error.parameter(), "wavelength", "{wavelength}");
    }
    let ends = GOLD.range();
    for wavelength in [*ends.start(), *ends.end()] {
        // The end rounded to f32 may lie beyond it, and is its end all the same.
        let (double, single) = (
            GOLD.refractive_index(wavelength).unwrap(),
            GOLD.refractive_index(wavelength as f32).unwrap(),
        );
        assert!((double.eta / f64::from(single.eta) - 1.0).abs() < 1e-6, "{wavelength}");
        assert!((double.k / f64::from(single.k) - 1.0).abs() < 1e-6, "{wavelength}");
    }
    // Beyond the rounding of a product or a sum.
    for (end, beyond) in [(*ends.start(), 1.0 - 1e-14), (*ends.end(), 1.0 + 1e-14)] {
        assert!(GOLD.refractive_index(end * beyond).is_err());
        let at_end = GOLD.refractive_index(end).unwrap();
        assert_eq!(GOLD.refractive_index(end * (1.0 + 0.01 * (beyond - 1.0))).unwrap(), at_end);
    }
}
