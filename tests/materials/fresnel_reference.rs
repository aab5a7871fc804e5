//! Fresnel's equations for thirteen materials against a table in complex arithmetic.

use brdf::fresnel::conductor_polarized;
use brdf::materials::find;
use brdf::{Conductor, Fresnel};

use brdf_checks::tables::{number, rows};

#[test]
fn reflectances_are_those_of_complex_arithmetic() {
    let rows = rows("tests/data/fresnel_reference.csv");
    assert_eq!(rows.len(), 390);
    for row in rows {
        let material = find(&row["key"]).expect("is there");
        let wavelength = number(&row, "wavelength_nm");
        let cos = number(&row, "theta_deg").to_radians().cos();
        let index = material.refractive_index(wavelength).expect("in range");
        for (got, column) in [(index.eta, "n"), (index.k, "k")] {
            let want = number(&row, column);
            // The table prints nine digits of the index that it uses.
            assert!((got - want).abs() <= 1e-8 * want, "{row:?}: {column} is {got}");
        }
        let conductor = Conductor::new(index.eta, index.k).expect("in range");
        let polarized = conductor_polarized(index.eta, index.k, cos);
        for (got, column) in
            [(polarized.s, "Rs"), (polarized.p, "Rp"), (conductor.reflectance(cos), "R")]
        {
            let want = number(&row, column);
            assert!((got - want).abs() < 1e-12, "{row:?}: {column} is {got}");
        }
    }
}
