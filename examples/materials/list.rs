//! The materials as text.

use brdf::colorimetry::WAVELENGTHS;
use brdf::materials::{ALL, Material};
use brdf::{Fresnel, Illuminant, Observer, ParameterError, Spectrum};

/// One line for each material, then the notes.
pub fn print() -> Result<(), ParameterError> {
    let observer = Observer::new(Illuminant::D65, WAVELENGTHS)?;
    // Two blanks behind the longest.
    let width = |text: fn(&Material) -> &'static str| {
        ALL.into_iter().map(|material| text(material).chars().count()).max().unwrap_or(0) + 2
    };
    let (keys, names) = (width(Material::key), width(Material::name));
    println!(
        "{:<keys$}{:<names$}{:<15}{:>17}{:>9}   linear sRGB at normal incidence, D65",
        "key", "name", "kind", "range in nm", "samples"
    );
    for material in ALL {
        let color = material.conductor(Spectrum(WAVELENGTHS)).map_or_else(
            |_| "part of the visible range only".to_owned(),
            |conductor| {
                let color = observer.linear_srgb(conductor.reflectance(1.0));
                format!("{:.3} {:.3} {:.3}", color.x, color.y, color.z)
            },
        );
        let (lower, upper) = material.range().into_inner();
        println!(
            "{:<keys$}{:<names$}{:<15}{:>17}{:>9}   {color}",
            material.key(),
            material.name(),
            material.kind(),
            format!("{lower}–{upper}"),
            material.samples().len(),
        );
    }
    println!();
    for material in ALL {
        if let Some(remark) = material.remark() {
            println!("{}: {remark}", material.key());
        }
    }
    Ok(())
}
