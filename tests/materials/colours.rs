//! The colours of all materials at normal incidence against a table.

use brdf::colorimetry::WAVELENGTHS;
use brdf::materials::{Material, find};
use brdf::{Conductor, Fresnel, Illuminant, Observer, Spectrum};
use glam::DVec3;

use brdf_checks::path;
use brdf_checks::tables::{Row, number, rows};

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

/// How far the colour of gold moves if every second sample is left out. The error of straight lines
/// grows with the square of the distance of the samples, so that a third of this is the error left.
#[test]
fn the_samples_of_gold_are_dense_enough() {
    let gold = find("Au").expect("is there");
    let daylight = Observer::new(Illuminant::D65, WAVELENGTHS).expect("ascending");
    let exact = daylight.linear_srgb(normal_incidence(gold).0);
    let samples: Vec<_> = gold.samples().collect();
    let visible = samples.iter().filter(|one| (380.0..=780.0).contains(&one.wavelength)).count();
    let mut moved = DVec3::ZERO;
    for first in [0, 1] {
        let kept: Vec<_> = samples.iter().skip(first).step_by(2).collect();
        let spectrum = WAVELENGTHS.map(|at| {
            let above = kept.partition_point(|one| one.wavelength <= at);
            let (a, b) = (kept[above - 1], kept[above]);
            let part = (at - a.wavelength) / (b.wavelength - a.wavelength);
            let line = |a: f64, b: f64| a * (1.0 - part) + b * part;
            let (eta, k) = (line(a.index.eta, b.index.eta), line(a.index.k, b.index.k));
            Conductor::new(eta, k).expect("in range").reflectance(1.0)
        });
        moved = moved.max((daylight.linear_srgb(Spectrum(spectrum)) - exact).abs());
    }
    println!("{visible} samples, moved by {moved}");
    let apart = samples.windows(2).map(|pair| (pair[0].wavelength, pair[1].wavelength));
    let apart: Vec<f64> = apart
        .filter(|(one, next)| *one > 380.0 && *next < 780.0)
        .map(|(one, next)| next - one)
        .collect();
    let (nearest, widest) = apart
        .iter()
        .fold((f64::MAX, 0.0_f64), |(least, most), &step| (least.min(step), most.max(step)));
    let documented = format!(
        "{visible} samples of gold in the visible range, {nearest:.0} to {widest:.0} nm apart"
    );
    let page = std::fs::read_to_string(path("src/colorimetry/observer.rs")).expect("is there");
    let page = page.replace("\n/// ", " ");
    assert!(page.contains(&documented), "{documented}");
    let moved = moved.max_element();
    let documented = format!("without every second of them it moves by up to {moved:.3}");
    assert!(page.contains(&documented), "{documented}");
    assert!(page.contains(&format!("about {:.3}", moved / 3.0)), "{}", moved / 3.0);
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
