//! The baked table against cubature of the model, and its file.

#[path = "../../examples/tables/bake.rs"]
mod bake;
#[path = "../../examples/tables/chart.rs"]
mod chart;
#[path = "../../examples/tables/file.rs"]
mod file;
#[allow(dead_code, reason = "words that only the gallery needs")]
#[path = "../../examples/gallery/lettering.rs"]
mod lettering;

use std::error::Error;

use bake::{Lattice, Memory, ScaleAndBias, middle};
use brdf::{CookTorrance, Ggx, Schlick, SmithCorrelated, from_spherical};
use brdf_checks::measure::energy::albedo;
use glam::DVec3;

#[test]
fn cells_are_integrals() -> Result<(), Box<dyn Error>> {
    let lattice = Lattice::new(1024);
    let mut memory = Memory::new(&lattice);
    let mut worst = 0.0_f64;
    for (row, column) in [(0, 40), (5, 63), (20, 2), (32, 32), (63, 10), (63, 63)] {
        let (roughness, cos_theta) = (middle(row, 64), middle(column, 64));
        let cell = bake::cell(roughness, cos_theta, &lattice, &mut memory)?;
        let fresnel = Schlick::new(DVec3::new(0.0, 0.5, 1.0))?;
        let model =
            CookTorrance::new(Ggx::new(roughness)?, fresnel).with_shadowing(SmithCorrelated);
        let want = albedo(&model, from_spherical(cos_theta.acos(), 0.0), 1e-6).value;
        let got = DVec3::new(0.0, 0.5, 1.0) * cell.scale + DVec3::splat(cell.bias);
        worst = worst.max((got - want).abs().max_element());
    }
    println!("{worst:e}");
    assert!(worst < 6e-4, "{worst:e}");
    Ok(())
}

#[test]
fn the_file_is_as_described() {
    let cell = |scale, bias| ScaleAndBias { scale, bias };
    let rows = vec![vec![cell(0.5, 0.25), cell(1.0, 0.0), cell(0.75, 0.125)]; 2];
    let bytes = file::bytes(&rows);
    assert_eq!(bytes.len(), 16 + 2 * 3 * 2 * 4);
    assert_eq!(bytes[..8], file::MAGIC);
    assert_eq!(
        (bytes[8..12].to_vec(), bytes[12..16].to_vec()),
        (vec![3, 0, 0, 0], vec![2, 0, 0, 0])
    );
    assert_eq!(bytes[16 + 20..16 + 24], 0.125_f32.to_le_bytes());
}

#[test]
fn the_picture_has_scale_in_red_and_bias_in_green() -> Result<(), Box<dyn Error>> {
    let path = std::env::temp_dir().join(format!("brdf-tables-{}.png", std::process::id()));
    let row = vec![ScaleAndBias { scale: 1.0, bias: 0.0 }, ScaleAndBias { scale: 0.0, bias: 0.2 }];
    chart::draw(&[row.clone(), row], &path)?;
    let picture = image::open(&path)?.into_rgb8();
    std::fs::remove_file(&path)?;
    // Two cells beside each other, each half as wide as the table is high, and axes around them.
    let pixels = |color: [u8; 3]| picture.pixels().filter(|pixel| pixel.0 == color).count();
    assert_eq!((pixels([255, 0, 0]), pixels([0, 51, 0])), (256 * 512, 256 * 512));
    let left_of = |color: [u8; 3]| {
        picture.enumerate_pixels().filter(|(.., pixel)| pixel.0 == color).map(|(x, ..)| x).min()
    };
    assert!(left_of([255, 0, 0]) < left_of([0, 51, 0]));
    assert!(pixels([34; 3]) > 100, "words and ticks");
    Ok(())
}
