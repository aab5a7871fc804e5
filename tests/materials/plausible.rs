//! Sets that cannot be the material they are named after are marked.

use brdf::Fresnel;
use brdf::colorimetry::WAVELENGTHS;
use brdf::materials::{ALL, Kind, Material, find};

use brdf_checks::path;

/// How far the reflectance of unpolarised light falls below that at normal incidence, at most,
/// within the visible range.
fn dip(material: &Material) -> f64 {
    let (lower, upper) = material.range().into_inner();
    let mut deepest = 0.0_f64;
    for wavelength in WAVELENGTHS.into_iter().filter(|at| (lower..=upper).contains(at)) {
        let conductor = material.conductor(wavelength).expect("in range");
        let normal = conductor.reflectance(1.0);
        for angle in 1..900 {
            let cos = (f64::from(angle) * 0.1).to_radians().cos();
            deepest = deepest.max(normal - conductor.reflectance(cos));
        }
    }
    deepest
}

/// Towards grazing the reflectance of a metal first falls a little. The sets fall into two groups
/// with a wide gap: up to 0.115 (aluminium in the red), and zinc with 0.27.
#[test]
fn sets_with_an_impossible_dip_are_marked() {
    let (mut largest, mut marked) = (0.0_f64, 0);
    for material in ALL.into_iter().filter(|one| one.kind() != Kind::Dielectric) {
        let dip = dip(material);
        if dip > 0.15 {
            println!("{material}: {dip:.3}");
            assert_eq!(material.kind(), Kind::Caution, "{material}: {dip}");
            marked += 1;
        } else {
            largest = largest.max(dip);
        }
        let highest = WAVELENGTHS
            .into_iter()
            .filter_map(|at| material.refractive_index(at).ok())
            .fold(0.0_f64, |n, index| n.max(index.eta));
        // Silicon at 380 nm has the highest index of what is not marked.
        assert!(highest < 6.5 || material.kind() == Kind::Caution, "{material}: n {highest}");
    }
    println!("largest of the others: {largest:.3}");
    assert!(marked == 1 && largest < 0.12, "{marked} {largest}");
}

/// What the remark says of zinc.
#[test]
fn the_remark_on_zinc_is_right() {
    let zinc = find("Zn").expect("is there");
    let conductor = zinc.conductor(560.0).expect("in range");
    let index = zinc.refractive_index(560.0_f64).expect("in range");
    let normal: f64 = conductor.reflectance(1.0);
    let oblique = conductor.reflectance(86.0_f64.to_radians().cos());
    let got = format!("{:.1} {normal:.2} {oblique:.2}", index.eta);
    assert_eq!(got, "13.9 0.77 0.50");
    let remark = zinc.remark().expect("has one");
    for number in got.split(' ').chain(["560 nm", "86 degrees"]) {
        assert!(remark.contains(number), "{number}: {remark}");
    }
}

/// The page of a set says what is wrong with it.
#[test]
fn remarks_are_in_the_documentation() {
    let sets = std::fs::read_to_string(path("src/materials/sets.rs")).expect("in the repository");
    let mut cautions = Vec::new();
    for material in ALL {
        let Some(remark) = material.remark() else { continue };
        let caution = material.kind() == Kind::Caution;
        let words = if caution { "**Not for colour:**" } else { "Remark:" };
        assert!(sets.contains(&format!("\n/// {words} {remark}.\n")), "{material}");
        if caution {
            cautions.push(material.key());
            assert!(remark.ends_with("do not use for colour"), "{material}");
        }
    }
    assert_eq!(cautions, ["Ta", "Zn"]);
    // Whoever picks a metal by its name in a file reads these pages.
    for file in ["src/description/mod.rs", "src/description/described.rs"] {
        let text = std::fs::read_to_string(path(file)).expect("in the repository");
        assert!(text.contains("`Ta` and `Zn` are accepted although"), "{file}");
    }
}
