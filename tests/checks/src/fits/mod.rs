//! Models fitted to measured materials by least squares: for the test that compares with the
//! documented table, and for the example that draws the fits.

pub mod family;
pub mod measured;
pub mod solve;
pub mod table;

use family::Family;
use measured::Material;
use rayon::prelude::*;
use solve::Fit;

/// The fits of all families to one material.
pub struct Row {
    pub material: Material,
    pub fits: Vec<Fit>,
}

impl Row {
    pub fn fit(&self, family: Family) -> &Fit {
        let mut fits = self.fits.iter();
        fits.find(|fit| fit.family == family).expect("every family is fitted")
    }
}

/// Fits every family to every material; `done` hears of each fit.
pub fn all(done: impl Fn() + Sync) -> Vec<Row> {
    let row = |material: Material| {
        let fit = |family: &Family| {
            let fit = solve::fit(*family, &material);
            done();
            fit
        };
        Row { fits: Family::ALL.par_iter().map(fit).collect(), material }
    };
    measured::read().into_par_iter().map(row).collect()
}
