//! Fresnel's equations with the index of silicon against ellipsometry of a silicon wafer.
//!
//! An ellipsometer measures tan ψ = |r_p|/|r_s|. The wafer carries its native oxide, which turns
//! the phase but hardly changes ψ; the second wafer of the file is coated on purpose and left out.
//!
//! R. Robertson, I. Gresham, A. Nelson: refellips 0.0.6, measured with an Accurion EP4 at 658 nm.

use brdf::fresnel::conductor_polarized;
use brdf::materials::SILICON;

use brdf_checks::tables::{number, rows};

#[test]
fn silicon_reflects_as_fresnel_says() {
    let silicon = SILICON.refractive_index(658.0_f64).expect("in range");
    let zones = rows("tests/data/ellipsometry_si_658nm.csv");
    let wafer: Vec<_> = zones.iter().filter(|row| row["sample"] == "19-1-1").collect();
    assert_eq!(wafer.len(), 44);
    for angle in (50..=70).step_by(2) {
        let psi: Vec<f64> = wafer
            .iter()
            .filter(|row| number(row, "aoi_deg") == f64::from(angle))
            .map(|row| number(row, "psi_deg"))
            .collect();
        assert_eq!(psi.len(), 4, "four zones at {angle}°");
        let measured = psi.iter().sum::<f64>() / 4.0;
        let reflected =
            conductor_polarized(silicon.eta, silicon.k, f64::from(angle).to_radians().cos());
        let predicted = (reflected.p / reflected.s).sqrt().atan().to_degrees();
        let difference = predicted - measured;
        println!("{angle}°: measured {measured:.3}, Fresnel {predicted:.3}, {difference:+.3}");
        // At 70°, next to the pseudo-Brewster angle, the oxide is felt.
        let allowed = if angle < 70 { 0.1 } else { 0.15 };
        assert!(difference.abs() < allowed, "{angle}°: off by {difference}°");
    }
}
