//! The embedded numbers, what lies between them, and how much room they take.

use brdf::materials::{ALL, Material};
use brdf::{Fresnel, Spectrum, Vector3};
use glam::{DVec3, Vec3};

use brdf_checks::tables::{number, rows};

/// Each number of the tables comes back as the `f64` nearest to its decimal digits.
#[test]
fn samples_are_the_numbers_of_the_tables() {
    for (material, entry) in ALL.into_iter().zip(rows("data/ior/index.csv")) {
        let want = rows(&format!("data/ior/{}", entry["file"]));
        assert_eq!(material.key(), entry["key"]);
        assert_eq!(material.samples().len(), want.len());
        assert_eq!(number(&entry, "samples"), want.len() as f64);
        for (got, want) in material.samples().zip(&want) {
            let want = ["wavelength_nm", "n", "k"].map(|column| number(want, column).to_bits());
            let got = [got.wavelength, got.index.eta, got.index.k].map(f64::to_bits);
            assert_eq!(got, want, "{material}");
        }
        let ends = [number(&entry, "lambda_min_nm"), number(&entry, "lambda_max_nm")];
        assert_eq!([*material.range().start(), *material.range().end()], ends, "{material}");
    }
}

#[test]
fn an_index_lies_on_the_line_between_its_neighbours() {
    for material in ALL {
        let samples: Vec<_> = material.samples().collect();
        for pair in samples.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            assert!(a.wavelength < b.wavelength, "{material}");
            for sample in [a, b] {
                let got = material.refractive_index(sample.wavelength).expect("in range");
                assert_eq!(got, sample.index, "{material} at a sample");
            }
            let third = a.wavelength + (b.wavelength - a.wavelength) / 3.0;
            let got = material.refractive_index(third).expect("in range");
            for (got, a, b) in [(got.eta, a.index.eta, b.index.eta), (got.k, a.index.k, b.index.k)]
            {
                let want = (2.0 * a + b) / 3.0;
                assert!((got - want).abs() <= 1e-10 * want, "{material} at {third}: {got} {want}");
            }
        }
    }
}

#[test]
fn nothing_is_extrapolated() {
    for material in ALL {
        let (lower, upper) = (*material.range().start(), *material.range().end());
        for outside in [
            lower * (1.0 - 1e-14),
            upper * (1.0 + 1e-14),
            0.0,
            -550.0,
            f64::NAN,
            f64::INFINITY,
            f64::MAX,
        ] {
            let error = material.refractive_index(outside).unwrap_err();
            assert_eq!((error.parameter(), error.range()), ("wavelength", (lower, upper)));
            assert!(error.value() == outside || outside.is_nan());
            let text = error.to_string();
            assert!(text.contains(&lower.to_string()) && text.contains(&upper.to_string()));
            let inside = 0.5 * (lower + upper);
            assert!(material.conductor(Spectrum([inside, outside, inside])).is_err());
        }
    }
}

/// The numbers nearest to the ends belong to the range, in single precision too.
#[test]
#[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
fn the_ends_belong_to_the_range() {
    for material in ALL {
        let (first, last) = (material.samples().next(), material.samples().next_back());
        for end in [first, last].into_iter().flatten() {
            let single = material.refractive_index(end.wavelength as f32).expect("in range");
            let (eta, k) = (f64::from(single.eta), f64::from(single.k));
            assert!((eta - end.index.eta).abs() < 1e-6 * end.index.eta, "{material}: {eta}");
            assert!((k - end.index.k).abs() <= 1e-5 * end.index.k, "{material}: {k}");
        }
    }
}

/// The same index in every number and every kind of colour.
#[test]
fn all_colours_see_the_same_index() {
    let at = [650.0_f32, 550.0, 450.0];
    for material in ALL {
        let one = at.map(|at| material.refractive_index(f64::from(at)).expect("in range"));
        let single = material.refractive_index(Vec3::from(at)).expect("in range");
        let double = material.refractive_index(DVec3::from(at.map(f64::from))).expect("in range");
        let spectrum = material.refractive_index(Spectrum(at)).expect("in range");
        let vector = Vector3 { x: 650.0, y: 550.0, z: 450.0 };
        let vector = material.refractive_index(vector).expect("in range");
        for (channel, index) in one.into_iter().enumerate() {
            let (eta, k) = (index.eta, index.k);
            assert_eq!((double.eta[channel], double.k[channel]), (eta, k));
            #[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
            let rounded = (eta as f32, k as f32);
            assert_eq!((single.eta[channel], single.k[channel]), rounded);
            assert_eq!((spectrum.eta.0[channel], spectrum.k.0[channel]), rounded);
        }
        assert_eq!([vector.eta.x, vector.eta.y, vector.eta.z], one.map(|index| index.eta));
    }
}

/// The data of all materials, every citation counted although equal ones are stored once.
#[test]
fn the_embedded_data_is_small() {
    let samples: usize = ALL.iter().map(|material| 10 * material.samples().len()).sum();
    let text: usize = ALL
        .iter()
        .map(|one| {
            let remark = one.remark().map_or(0, str::len);
            one.key().len()
                + one.name().len()
                + one.citation().len()
                + one.preparation().len()
                + remark
        })
        .sum();
    let records = ALL.len() * (size_of::<Material>() + size_of::<&Material>());
    println!("samples {samples}, text {text}, records {records}");
    assert_eq!(samples, 73_070);
    assert!(samples + text + records < 110_000, "{}", samples + text + records);
}

/// What is left out where a transparent material is taken for one without absorption.
#[test]
fn a_transparent_material_is_a_dielectric() {
    let (mut largest, mut opaque) = (0.0_f64, 0);
    for material in ALL {
        for sample in material.samples() {
            let exact = material.conductor(sample.wavelength).expect("in range");
            let Ok(clear) = material.dielectric(sample.wavelength) else {
                assert!(sample.index.k > 1e-3, "{material} at {}", sample.wavelength);
                opaque += 1;
                continue;
            };
            for cos in [1.0, 0.7, 0.5, 0.3, 0.1, 0.01] {
                let difference: f64 = clear.reflectance(cos) - exact.reflectance(cos);
                largest = largest.max(difference.abs());
            }
        }
    }
    println!("largest difference {largest:.1e}, {opaque} samples absorb");
    assert!(largest < 1e-7, "{largest:e}");
    assert_eq!(opaque, 3239);
}
