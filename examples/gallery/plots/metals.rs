//! Measured optical constants of metals.

use std::error::Error;

/// A metal and its table of wavelength in nm, n and k.
#[derive(Clone, Copy, Debug)]
pub(super) struct Metal {
    pub(super) name: &'static str,
    table: &'static str,
}

pub(super) const GOLD: Metal = Metal { name: "gold", table: include_str!("../data/Au.csv") };
pub(super) const COPPER: Metal = Metal { name: "copper", table: include_str!("../data/Cu.csv") };
pub(super) const SILVER: Metal = Metal { name: "silver", table: include_str!("../data/Ag.csv") };

impl Metal {
    /// n and k at a wavelength in nm, interpolated linearly between the measured ones.
    pub(super) fn index(&self, wavelength: f64) -> Result<(f64, f64), Box<dyn Error>> {
        let mut rows = Vec::new();
        for line in self.table.lines().filter(|l| l.starts_with(|c: char| c.is_ascii_digit())) {
            let numbers = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
            let [wavelength, eta, k] = numbers[..] else {
                return Err(format!("{}: not three columns: {line}", self.name).into());
            };
            rows.push([wavelength, eta, k]);
        }
        let between = rows.windows(2).find(|pair| (pair[0][0]..=pair[1][0]).contains(&wavelength));
        let Some([low, high]) = between else {
            return Err(format!("{}: no data at {wavelength} nm", self.name).into());
        };
        let part = (wavelength - low[0]) / (high[0] - low[0]);
        let blend = |column: usize| low[column] + (high[column] - low[column]) * part;
        Ok((blend(1), blend(2)))
    }
}
