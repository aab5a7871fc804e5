//! One index per channel in place of a spectrum: the error that the documentation states.

use std::fmt::Write;

use brdf::colorimetry::WAVELENGTHS;
use brdf::materials::{ALL, Kind, Material};
use brdf::{Fresnel, Illuminant, Observer, Spectrum};
use glam::DVec3;

use brdf_checks::path;

const ANGLES: [f64; 6] = [0.0, 30.0, 60.0, 75.0, 85.0, 89.0];
const SHOWN: [&str; 5] = ["Ag", "Al", "Cu", "Au", "brass_Cu70Zn30"];

/// Red, green and blue of the shortcut.
const LINES: DVec3 = DVec3::new(650.0, 550.0, 450.0);

/// Shortcut minus exact, at each of the angles.
fn errors(material: &Material, lines: DVec3) -> [DVec3; ANGLES.len()] {
    let observer = Observer::new(Illuminant::D65, WAVELENGTHS).expect("ascending");
    let exact = material.conductor(Spectrum(WAVELENGTHS)).expect("in range");
    let shortcut = material.conductor(lines).expect("in range");
    ANGLES.map(|angle| {
        let cos = angle.to_radians().cos();
        shortcut.reflectance(cos) - observer.linear_srgb(exact.reflectance(cos))
    })
}

fn metals() -> impl Iterator<Item = &'static Material> {
    let kinds = [Kind::Metal, Kind::Alloy, Kind::Alternative];
    ALL.into_iter().filter(move |material| kinds.contains(&material.kind()))
}

/// A row of the table: its head, and a cell for each angle.
fn row(head: &str, cells: [String; ANGLES.len()]) -> String {
    let mut text = format!("//! | {head} |");
    for cell in cells {
        write!(text, " {cell} |").expect("a string takes all text");
    }
    text.replace('-', "−")
}

#[test]
fn the_documented_errors_are_those_of_the_metals() {
    let documentation =
        std::fs::read_to_string(path("src/colorimetry/mod.rs")).expect("it is in the repository");
    let (mut wanted, mut largest, mut sum, mut count) = (Vec::new(), [0.0_f64; 6], [0.0; 6], 0.0);
    for material in metals() {
        let errors = errors(material, LINES);
        for (angle, error) in errors.iter().enumerate() {
            largest[angle] = largest[angle].max(error.abs().max_element());
            sum[angle] += error.abs().max_element();
        }
        count += 1.0;
        if SHOWN.contains(&material.key()) {
            let cells = errors.map(|e| format!("{:+.3} {:+.3} {:+.3}", e.x, e.y, e.z));
            wanted.push(row(material.name(), cells));
        }
    }
    wanted.push(row(
        &format!("largest channel, largest of {count}"),
        largest.map(|error| format!("{error:.3}")),
    ));
    wanted.push(row(
        &format!("largest channel, mean of {count}"),
        sum.map(|sum| format!("{:.3}", sum / count)),
    ));
    println!("{}", wanted.join("\n"));
    for line in wanted {
        assert!(documentation.contains(&format!("{line}\n")), "not documented: {line}");
    }
}

/// The wavelengths on the line from white through a primary of sRGB.
#[test]
fn dominant_wavelengths_are_no_better() {
    let mean = |lines: DVec3| {
        let worst: Vec<f64> =
            metals().map(|metal| errors(metal, lines)[0].abs().max_element()).collect();
        worst.iter().sum::<f64>() / worst.len() as f64
    };
    let (usual, dominant) = (mean(LINES), mean(DVec3::new(611.4, 549.1, 464.2)));
    println!("{usual:.4} {dominant:.4}");
    assert_eq!(format!("{usual:.3} {dominant:.3}"), "0.013 0.023");
}
