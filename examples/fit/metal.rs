//! The n and k of a metal from its reflectance over the angle.

use std::error::Error;
use std::fmt::Write;

use brdf::description::FresnelDescription;
use brdf::fit::{Fit, MeasuredReflectance};
use brdf::materials::{ALUMINIUM, COPPER, GOLD, Material, SILVER};
use brdf::{Conductor, Fresnel};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Nanometres.
const WAVELENGTH: f64 = 550.0;

/// The spread of the measurement, as of a good photometer.
const SPREAD: f64 = 0.001;

/// A table of what is found from a reflectance every 5° with noise, up to two largest angles.
pub fn table() -> Result<String, Box<dyn Error>> {
    let mut text =
        "| metal | measured to | n | true | k | true |\n|---|--:|---|--:|---|--:|\n".to_owned();
    for (name, material) in
        [("gold", &GOLD), ("copper", &COPPER), ("silver", &SILVER), ("aluminium", &ALUMINIUM)]
    {
        for largest in [40, 85] {
            row(&mut text, name, material, largest)?;
        }
    }
    Ok(text)
}

fn row(
    text: &mut String,
    name: &str,
    material: &Material,
    largest: u16,
) -> Result<(), Box<dyn Error>> {
    let index = material.refractive_index(WAVELENGTH)?;
    let metal = Conductor::new(index.eta, index.k)?;
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let measured: Vec<MeasuredReflectance> = (0..=largest)
        .step_by(5)
        .map(|angle| {
            let cos = f64::from(angle).to_radians().cos();
            // The sum of twelve uniform numbers is close to a normal one.
            let noise: f64 = (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0;
            MeasuredReflectance::new(cos, metal.reflectance(cos) + SPREAD * noise)
        })
        .collect();
    // From several starts: the least squares of a metal have more than one minimum.
    let starts = [(0.1, 3.0), (0.5, 2.0), (1.0, 5.0), (3.0, 3.0)];
    let ends = starts.iter().filter_map(|(eta, k)| {
        let start = format!(r#"{{"conductor": {{"eta": {eta}, "k": {k}}}}}"#);
        let start: FresnelDescription = serde_json::from_str(&start).ok()?;
        let fit = Fit::of(&start)
            .free_within("conductor.eta", 0.01..=10.0)
            .free_within("conductor.k", 0.0..=20.0);
        fit.to(&measured).ok()
    });
    let best = ends.min_by(|a, b| a.residual().total_cmp(&b.residual())).ok_or("no fit")?;
    let shown = |place: usize| {
        let found = &best.parameters()[place];
        match found.standard_error {
            Some(error) => format!("{:.3} ± {error:.3}", found.value),
            None => format!("{:.3}, not told", found.value),
        }
    };
    writeln!(
        text,
        "| {name} | {largest}° | {} | {:.3} | {} | {:.3} |",
        shown(0),
        index.eta,
        shown(1),
        index.k
    )?;
    Ok(())
}
