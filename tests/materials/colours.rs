//! The colours of all materials at normal incidence against a table.

use brdf::colorimetry::WAVELENGTHS;
use brdf::materials::{Material, find};
use brdf::{Fresnel, Illuminant, Observer, Spectrum};
use glam::DVec3;

use crate::tables::{Row, number, rows};

fn rgb(row: &Row, columns: [&str; 3]) -> DVec3 {
    DVec3::from(columns.map(|column| number(row, column)))
}

/// The spectrum at normal incidence; where a set does not reach the ends of the visible range,
/// its end values are held, as in the table.
fn normal_incidence(material: &Material) -> (Spectrum<f64, 81>, bool) {
    let held = WAVELENGTHS.map(|at| at.clamp(*material.range().start(), *material.range().end()));
    let conductor = material.conductor(Spectrum(held)).expect("in range");
    (conductor.reflectance(1.0), held != WAVELENGTHS)
}

#[test]
fn colours_at_normal_incidence_are_those_of_the_table() {
    let daylight = Observer::new(Illuminant::D65, WAVELENGTHS).expect("ascending");
    let equal = Observer::new(Illuminant::E, WAVELENGTHS).expect("ascending");
    let (mut worst, mut count) = (0.0_f64, 0);
    for row in rows("tests/data/f0_linear_srgb.csv") {
        let key = &row["key"];
        let (spectrum, clamped) = match key.as_str() {
            "perfect_reflector" => (Spectrum([1.0; 81]), false),
            key => normal_incidence(find(key).expect("is there")),
        };
        assert_eq!(clamped, row["clamped"] == "yes", "{key}");
        for (got, want) in [
            (daylight.linear_srgb(spectrum), rgb(&row, ["r_d65", "g_d65", "b_d65"])),
            (equal.adapted_linear_srgb(spectrum), rgb(&row, ["r_e", "g_e", "b_e"])),
            (DVec3::splat(daylight.xyz(spectrum).y), DVec3::splat(number(&row, "Y_d65"))),
        ] {
            let error = (got - want).abs().max_element();
            worst = worst.max(error);
            assert!(error < 1e-6, "{key}: {got} instead of {want}");
        }
        count += 1;
    }
    println!("largest difference of {count} colours: {worst:.1e}");
    assert_eq!(count, 75);
}

/// Half as many wavelengths and fewer give almost the same colour.
#[test]
fn a_few_wavelengths_are_enough() {
    fn largest_difference<const N: usize>() -> f64 {
        let exact = Observer::new(Illuminant::D65, WAVELENGTHS).expect("ascending");
        let at: [f64; N] =
            std::array::from_fn(|index| 380.0 + 400.0 * index as f64 / (N as f64 - 1.0));
        let few = Observer::new(Illuminant::D65, at).expect("ascending");
        let mut largest = 0.0_f64;
        for key in ["Au", "Cu", "Ag", "Al", "Fe", "brass_Cu70Zn30"] {
            let metal = find(key).expect("is there");
            let want = exact.linear_srgb(normal_incidence(metal).0);
            let conductor = metal.conductor(Spectrum(at)).expect("in range");
            let got = few.linear_srgb(conductor.reflectance(1.0));
            largest = largest.max((got - want).abs().max_element());
        }
        println!("{N} wavelengths: {largest:.1e}");
        largest
    }
    assert!(largest_difference::<41>() < 1e-3);
    assert!(largest_difference::<21>() < 5e-3);
    assert!(largest_difference::<11>() < 2e-2);
}

#[test]
fn the_reflectances_at_three_wavelengths_are_those_of_the_table() {
    for row in rows("tests/data/f0_linear_srgb.csv") {
        if row["key"] == "perfect_reflector" {
            continue;
        }
        let material = find(&row["key"]).expect("is there");
        let conductor = material.conductor(DVec3::new(450.0, 550.0, 650.0)).expect("in range");
        let want = rgb(&row, ["R_450nm", "R_550nm", "R_650nm"]);
        let got = conductor.reflectance(1.0);
        assert!(got.abs_diff_eq(want, 1e-6), "{material}: {got} instead of {want}");
    }
}
