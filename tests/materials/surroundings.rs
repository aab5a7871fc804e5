//! Materials under a medium other than air, against Fresnel's amplitudes
//! r_s = (n₁c₁ − N c₂)/(n₁c₁ + N c₂), r_p = (N c₁ − n₁c₂)/(N c₁ + n₁c₂), N c₂ = √(N² − n₁² sin²θ),
//! evaluated with 40 digits from the tables' own numbers.

use brdf::Fresnel;
use brdf::materials::{GOLD, N_BK7_GLASS_SCHOTT, SILVER, WATER_HALE_QUERRY_1973};
use glam::{DVec3, Vec3};

const LINES: DVec3 = DVec3::new(650.0, 550.0, 450.0);

/// Degrees, and the reflectance at 650, 550 and 450 nm.
type Row = (f64, [f64; 3]);

const GOLD_UNDER_WATER: [Row; 3] = [
    (0.0, [0.9454634312537975, 0.7541406564433753, 0.3317001857536433]),
    (40.0, [0.9446490658183889, 0.7565959682897099, 0.3436961827753057]),
    (75.0, [0.9509237166193798, 0.8387697759012596, 0.5539228458769239]),
];

const SILVER_UNDER_A_COAT: [Row; 3] = [
    (0.0, [0.9856602964232007, 0.9767459524735246, 0.9744289313966463]),
    (40.0, [0.9853808517729281, 0.9764817883655467, 0.9746331204064451]),
    (75.0, [0.9860364050363845, 0.9811239535051713, 0.9843945159555488]),
];

const GLASS_UNDER_WATER: [Row; 3] = [
    (0.0, [0.004159522867671418, 0.004232893891154903, 0.004328690357564672]),
    (40.0, [0.005516897084671269, 0.00560934705855013, 0.005729894185582553]),
    (75.0, [0.1197581994146408, 0.1206726892978277, 0.121847966144238]),
];

fn assert_rows(term: &impl Fresnel<f64, Color = DVec3>, rows: [Row; 3]) {
    for (degrees, want) in rows {
        let got = term.reflectance(degrees.to_radians().cos());
        assert!(got.abs_diff_eq(want.into(), 3e-15), "{degrees}°: {got} instead of {want:?}");
    }
}

#[test]
fn what_lies_above_a_surface_counts() {
    let water = WATER_HALE_QUERRY_1973.refractive_index(LINES).expect("in range").eta;
    assert_rows(&GOLD.conductor_in(water, LINES).expect("in range"), GOLD_UNDER_WATER);
    let coat = DVec3::splat(1.5);
    assert_rows(&SILVER.conductor_in(coat, LINES).expect("in range"), SILVER_UNDER_A_COAT);
    let glass = N_BK7_GLASS_SCHOTT.dielectric_in(water, LINES).expect("in range");
    assert_rows(&glass, GLASS_UNDER_WATER);
}

/// Under air nothing changes, to the last bit.
#[test]
fn air_has_the_index_one() {
    let (air, lines) = (Vec3::ONE, LINES.as_vec3());
    assert_eq!(GOLD.conductor_in(air, lines), GOLD.conductor(lines));
    assert_eq!(N_BK7_GLASS_SCHOTT.dielectric_in(air, lines), N_BK7_GLASS_SCHOTT.dielectric(lines));
}

#[test]
fn a_medium_outside_has_an_index() {
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e5] {
        let error = GOLD.conductor_in(wrong, 550.0).unwrap_err();
        assert_eq!(error.parameter(), "outside");
        let error = N_BK7_GLASS_SCHOTT.dielectric_in(wrong, 550.0).unwrap_err();
        assert_eq!(error.parameter(), "outside");
    }
}
