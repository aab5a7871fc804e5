//! The measured slices.

use glam::DVec3;

/// What each key of the file is.
pub const TITLES: [(&str, &str); 7] = [
    ("paper_white", "white paper, A4, 160 g/m²"),
    ("colodur_napoli_4f", "wall paint, Colodur Napoli 4F"),
    ("satin_rosaline", "satin film, TeckWrap Rosaline"),
    ("cg_sunflower", "glossy film, TeckWrap Sunflower CG12"),
    ("vch_golden_yellow", "metallic vinyl, TeckWrap Golden Yellow"),
    ("cc_ibiza_sunset", "colour-shifting film, TeckWrap Ibiza Sunset"),
    ("cc_iris_purple_gem", "colour-shifting film, TeckWrap Iris Purple Gem RD03"),
];

/// One measured value.
#[derive(Clone, Copy)]
pub struct Point {
    /// Angles in degrees; azimuth 180 is the mirror side.
    pub theta_i: f64,
    pub theta_o: f64,
    pub azimuth: f64,
    pub wi: DVec3,
    pub wo: DVec3,
    /// f_r in sr⁻¹, linear sRGB; negative where the colour is out of gamut.
    pub value: DVec3,
}

/// A material with all that was measured.
pub struct Material {
    pub key: String,
    pub title: &'static str,
    pub points: Vec<Point>,
}

impl Material {
    /// The angles of incidence, increasing.
    pub fn incidences(&self) -> Vec<f64> {
        let mut angles: Vec<f64> = self.points.iter().map(|point| point.theta_i).collect();
        angles.sort_by(f64::total_cmp);
        angles.dedup();
        angles
    }

    /// Share of channels that are negative.
    pub fn negative(&self) -> f64 {
        let negative = |point: &Point| point.value.to_array().iter().filter(|v| **v < 0.0).count();
        let count: usize = self.points.iter().map(negative).sum();
        count as f64 / (3 * self.points.len()) as f64
    }
}

/// A unit vector from spherical coordinates in degrees.
pub fn direction(theta: f64, azimuth: f64) -> DVec3 {
    let (sin, cos) = theta.to_radians().sin_cos();
    let (sin_azimuth, cos_azimuth) = azimuth.to_radians().sin_cos();
    DVec3::new(sin * cos_azimuth, sin * sin_azimuth, cos)
}

/// All materials, dull ones first.
pub fn read() -> Vec<Material> {
    let path = crate::path("tests/data/rgl_slices.csv");
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_path(&path)
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut materials: Vec<Material> = TITLES
        .iter()
        .map(|&(key, title)| Material { key: key.to_owned(), title, points: Vec::new() })
        .collect();
    for row in reader.deserialize() {
        let row: (String, f64, f64, f64, f64, f64, f64) = row.expect("a row of seven columns");
        let (key, theta_i, theta_o, azimuth, r, g, b) = row;
        let material = materials.iter_mut().find(|material| material.key == key);
        material.expect("a material with a title").points.push(Point {
            theta_i,
            theta_o,
            azimuth,
            wi: direction(theta_i, 0.0),
            wo: direction(theta_o, azimuth),
            value: DVec3::new(r, g, b),
        });
    }
    materials
}
