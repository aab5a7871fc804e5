//! Measured refractive indices.

use std::error::Error;

use brdf::Conductor;
use glam::Vec3;

const GOLD: &str = include_str!("data/Au.csv");
const SILVER: &str = include_str!("data/Ag.csv");
const COPPER: &str = include_str!("data/Cu.csv");

/// The wavelengths that stand for red, green and blue, nm.
const WAVELENGTHS: [f32; 3] = [650.0, 550.0, 450.0];

/// Gold.
pub fn gold() -> Result<Conductor, Box<dyn Error>> {
    conductor(GOLD)
}

/// Silver.
pub fn silver() -> Result<Conductor, Box<dyn Error>> {
    conductor(SILVER)
}

/// Copper.
pub fn copper() -> Result<Conductor, Box<dyn Error>> {
    conductor(COPPER)
}

fn conductor(table: &str) -> Result<Conductor, Box<dyn Error>> {
    let mut rows = Vec::new();
    for line in table.lines().skip_while(|line| !line.starts_with("wavelength_nm")).skip(1) {
        let numbers = line.split(',').map(str::parse).collect::<Result<Vec<f32>, _>>()?;
        let [wavelength, eta, k] = numbers[..] else {
            return Err(format!("not wavelength, n, k: {line}").into());
        };
        rows.push([wavelength, eta, k]);
    }
    let channel = |column: usize| -> Result<Vec3, Box<dyn Error>> {
        let mut values = [0.0; 3];
        for (value, wavelength) in values.iter_mut().zip(WAVELENGTHS) {
            *value = interpolate(&rows, wavelength, column)
                .ok_or_else(|| format!("the table does not reach {wavelength} nm"))?;
        }
        Ok(Vec3::from_array(values))
    };
    Ok(Conductor::new(channel(1)?, channel(2)?)?)
}

fn interpolate(rows: &[[f32; 3]], wavelength: f32, column: usize) -> Option<f32> {
    let pair = rows.windows(2).find(|pair| pair[0][0] <= wavelength && wavelength <= pair[1][0])?;
    let at = (wavelength - pair[0][0]) / (pair[1][0] - pair[0][0]);
    Some(pair[0][column] + (pair[1][column] - pair[0][column]) * at)
}
