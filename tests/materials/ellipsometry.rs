//! Fresnel's equations with the index of silicon against ellipsometry of a silicon wafer.
//!
//! An ellipsometer measures tan ψ e^(iΔ) = r_p/r_s. The first wafer carries its native oxide, which turns
//! the phase but hardly changes ψ; the second is coated on purpose.
//!
//! R. Robertson, I. Gresham, A. Nelson: refellips 0.0.6, measured with an Accurion EP4 at 658 nm.

use std::collections::BTreeMap;

use brdf::fresnel::conductor_polarized;
use brdf::materials::{FUSED_SILICA, SILICON};
use brdf::polarization::{Complex, Layer, Layers};

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

/// ψ and Δ in degrees by the angle of incidence in tenths of a degree, the means of the zones.
fn measured(sample: &str) -> BTreeMap<u32, [f64; 2]> {
    let mut sums: BTreeMap<u32, ([f64; 2], f64)> = BTreeMap::new();
    for row in rows("tests/data/ellipsometry_si_658nm.csv") {
        if row["sample"] == sample {
            let angle = (number(&row, "aoi_deg") * 10.0).round() as u32;
            let (sum, count) = sums.entry(angle).or_default();
            sum[0] += number(&row, "psi_deg");
            sum[1] += number(&row, "delta_deg");
            *count += 1.0;
        }
    }
    sums.into_iter().map(|(angle, (sum, count))| (angle, sum.map(|sum| sum / count))).collect()
}

/// Predicted minus measured ψ and Δ in degrees under a film of silica, root mean squares over the
/// angles.
fn residual(measured: &BTreeMap<u32, [f64; 2]>, thickness: f64) -> [f64; 2] {
    let silica = FUSED_SILICA.refractive_index(658.0_f64).expect("in range");
    let silicon = SILICON.refractive_index(658.0_f64).expect("in range");
    let film = Layer { index: Complex::new(silica.eta, silica.k), thickness };
    let substrate = Complex::new(silicon.eta, silicon.k);
    let wafer = Layers::new(Complex::real(1.0), &[film], substrate, 658.0).expect("in range");
    let mut sums = [0.0; 2];
    for (angle, want) in measured {
        let r = wafer.amplitudes((f64::from(*angle) / 10.0).to_radians().cos()).r;
        let rho = r.p / r.s;
        // The instrument counts phases with e^(+iωt).
        let delta = rho.conj().arg().to_degrees().rem_euclid(360.0);
        let psi = rho.norm_squared().sqrt().atan().to_degrees();
        for (sum, off) in sums.iter_mut().zip([psi - want[0], delta - want[1]]) {
            *sum += off * off / measured.len() as f64;
        }
    }
    sums.map(f64::sqrt)
}

/// The thickness of the film with the smallest residual, by the golden section.
fn fitted(measured: &BTreeMap<u32, [f64; 2]>) -> f64 {
    let cost = |thickness| residual(measured, thickness).map(|off| off * off).iter().sum::<f64>();
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut lower, mut upper) = (0.0, 40.0);
    for _ in 0..60 {
        let (left, right) = (upper - golden * (upper - lower), lower + golden * (upper - lower));
        if cost(left) < cost(right) {
            upper = right;
        } else {
            lower = left;
        }
    }
    0.5 * (lower + upper)
}

/// One film of silica explains both wafers: thickness and residuals are those of the page.
#[test]
fn films_on_wafers_have_a_thickness() {
    let page = include_str!("../../docs/models.md");
    for (sample, bare) in [("19-1-1", 9.0), ("15-1-1", 20.0)] {
        let measured = measured(sample);
        assert_eq!(measured.len(), 11);
        let thickness = fitted(&measured);
        let [psi, delta] = residual(&measured, thickness);
        let [_, uncoated] = residual(&measured, 0.0);
        let row = format!("| {sample} | {thickness:.1} | {psi:.2} | {delta:.2} | {uncoated:.1} |");
        println!("{row}");
        assert!(page.contains(&row), "not documented: {row}");
        assert!(delta < 0.1 * uncoated && uncoated > bare, "{row}");
    }
}
