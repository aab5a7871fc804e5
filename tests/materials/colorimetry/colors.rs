//! What is made of spectra.

use brdf::colorimetry::{WAVELENGTHS, clamp_to_srgb, linear_srgb_to_xyz, xyz_to_linear_srgb};
use brdf::{Illuminant, Observer, Spectrum};
use glam::{DMat3, DVec3};

use brdf_checks::tables::{number, rows};

const ILLUMINANTS: [Illuminant; 3] = [Illuminant::D65, Illuminant::A, Illuminant::E];

/// Chromaticities of CIE 15 for the 2° observer.
#[test]
fn whites_have_the_chromaticities_of_the_standard() {
    for (illuminant, x, y) in [
        (Illuminant::D65, 0.31272, 0.32903),
        (Illuminant::A, 0.44758, 0.40745),
        (Illuminant::E, 0.33333, 0.33333),
    ] {
        let white = DVec3::from(illuminant.white());
        let got = white / white.element_sum();
        // The sums from 380 to 780 nm in place of 360 to 830 nm.
        assert!((got.x - x).abs() < 2e-5 && (got.y - y).abs() < 2e-5, "{illuminant:?}: {got}");
    }
}

/// The matrix of IEC 61966-2-1, which prints four decimals.
#[test]
fn the_matrix_is_that_of_the_standard() {
    let columns = [DVec3::X, DVec3::Y, DVec3::Z].map(xyz_to_linear_srgb);
    let want = DMat3::from_cols_array_2d(&[
        [3.2406, -0.9689, 0.0557],
        [-1.5372, 1.8758, -0.2040],
        [-0.4986, 0.0415, 1.0570],
    ]);
    let got = DMat3::from_cols(columns[0], columns[1], columns[2]);
    assert!(got.abs_diff_eq(want, 4e-4), "{got}");
}

#[test]
fn there_and_back_is_nothing() {
    for color in [DVec3::ONE, DVec3::new(1.038, 0.728, 0.364), DVec3::new(-0.2, 0.5, 7.0)] {
        let back = xyz_to_linear_srgb(linear_srgb_to_xyz(color));
        assert!(back.abs_diff_eq(color, 1e-14), "{back}");
    }
}

#[test]
fn white_stays_white_for_the_adapted_eye() {
    let white = Spectrum([1.0_f64; 81]);
    for illuminant in ILLUMINANTS {
        let observer = Observer::new(illuminant, WAVELENGTHS).expect("ascending");
        assert!(observer.adapted_linear_srgb(white).abs_diff_eq(DVec3::ONE, 1e-12));
        let seen = observer.xyz(white);
        assert!(seen.abs_diff_eq(DVec3::from(illuminant.white()), 1e-12));
    }
    let lamp = Observer::new(Illuminant::A, WAVELENGTHS).expect("ascending");
    let orange = lamp.linear_srgb(white);
    assert!(orange.x > 1.5 && orange.z < 0.3, "{orange}");
}

/// 24 measured patches, one of them outside sRGB.
#[test]
fn patches_have_the_colours_of_the_table() {
    let rows = rows("tests/data/colorchecker_ohta.csv");
    let (spectra, colors) = rows.split_at(81);
    let observer = Observer::new(Illuminant::D65, WAVELENGTHS).expect("ascending");
    let mut outside = 0;
    let patches: Vec<&String> = rows[0].keys().filter(|name| *name != "wavelength_nm").collect();
    assert_eq!(patches.len(), 24);
    for patch in patches {
        let spectrum = Spectrum(std::array::from_fn(|index| number(&spectra[index], patch)));
        let got: DVec3 = observer.linear_srgb(spectrum);
        let want = DVec3::new(
            number(&colors[0], patch),
            number(&colors[1], patch),
            number(&colors[2], patch),
        );
        assert!(got.abs_diff_eq(want, 6e-6), "{patch}: {got} instead of {want}");
        let clamped = clamp_to_srgb(got);
        assert!(clamped.min_element() >= 0.0 && clamped.max_element() <= 1.0);
        outside += usize::from(clamped != got);
    }
    assert_eq!(outside, 1, "cyan alone lies outside sRGB");
}

/// A spectrum that is a straight line between few wavelengths has the colour of all of them.
#[test]
fn straight_lines_need_few_wavelengths() {
    let at = [300.0, 412.5, 550.0, 561.0, 900.0];
    let values = [0.1, 0.9, 0.3, 0.8, 0.2];
    let line = |wavelength: f64| {
        let end = at.iter().position(|end| wavelength <= *end).expect("inside");
        let part = (wavelength - at[end - 1]) / (at[end] - at[end - 1]);
        values[end - 1] + (values[end] - values[end - 1]) * part
    };
    for illuminant in ILLUMINANTS {
        let exact = Observer::new(illuminant, WAVELENGTHS).expect("ascending");
        let few = Observer::new(illuminant, at).expect("ascending");
        let want: DVec3 = exact.xyz(Spectrum(WAVELENGTHS.map(line)));
        let got = few.xyz(Spectrum(values));
        assert!(got.abs_diff_eq(want, 1e-14), "{got} instead of {want}");
        // One wavelength is the same value everywhere.
        let one = Observer::new(illuminant, [589.3]).expect("ascending");
        let grey: DVec3 = one.xyz(Spectrum([0.25]));
        assert!(grey.abs_diff_eq(DVec3::from(illuminant.white()) * 0.25, 1e-14));
    }
}

#[test]
fn single_precision_is_enough() {
    let double = Observer::new(Illuminant::D65, WAVELENGTHS).expect("ascending");
    let single = Observer::<f32, 81>::new(Illuminant::D65, WAVELENGTHS).expect("ascending");
    let values: [f32; 81] = std::array::from_fn(|index| ((index * 37) % 81) as f32 / 81.0);
    let want: DVec3 = double.linear_srgb(Spectrum(values.map(f64::from)));
    let got = single.linear_srgb(Spectrum(values)).as_dvec3();
    assert!(got.abs_diff_eq(want, 1e-6), "{got} instead of {want}");
}

#[test]
fn wavelengths_out_of_order_are_refused() {
    for (bad, position, message) in [
        ([500.0, 400.0], 1, "wavelength[1] must be above 500, the one before it, not 400"),
        ([500.0, 500.0], 1, "wavelength[1] must be above 500, the one before it, not 500"),
        ([1e5, 1e5], 1, "wavelength[1] must be above 100000, the one before it, not 100000"),
        ([1e5, 2e5], 1, "wavelength[1] must be between 100 and 100000, not 200000"),
        ([f64::NAN, 500.0], 0, "wavelength[0] must be between 100 and 100000, not NaN"),
        ([500.0, f64::INFINITY], 1, "wavelength[1] must be between 100 and 100000, not inf"),
        ([0.0, 1e3], 0, "wavelength[0] must be between 100 and 100000, not 0"),
    ] {
        let error = Observer::<f64, 2>::new(Illuminant::E, bad).unwrap_err();
        assert_eq!((error.parameter(), error.position()), ("wavelength", Some(position)));
        assert_eq!(error.to_string(), message);
        let (lower, upper) = error.range();
        assert!(lower <= upper && !(lower..=upper).contains(&error.value()), "{error}");
    }
}

/// An eye that looks at nothing would see every surface black.
#[test]
fn no_wavelength_is_refused() {
    let error = Observer::<f64, 0>::new(Illuminant::D65, []).unwrap_err();
    assert_eq!(error.to_string(), "number of wavelengths must be at least 1, not 0");
    assert_eq!((error.range(), error.position()), ((1.0, f64::INFINITY), None));
}
