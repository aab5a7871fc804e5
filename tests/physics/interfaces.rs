//! What holds of every model over the whole sphere of directions: the lines of
//! `tests/interfaces.jsonl`.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use brdf::description::forms;
use brdf::parameter::Part;
use brdf::{Bsdf, Ggx, RoughDielectric, SmithSeparable, from_spherical};
use brdf_checks::interfaces::laws::{LAWS, mean_weights};
use brdf_checks::interfaces::{self, rows, viewers};
use brdf_checks::measure::derivatives::{LARGEST, derivatives, questions_over_sphere};
use brdf_checks::measure::sampling::chi_squared::{Verdict, least_of};
use brdf_checks::measure::sphere::sampling;
use brdf_checks::sound::unsound_anywhere;
use glam::DVec3;
use rayon::prelude::*;

#[test]
fn every_form_has_a_line() {
    let written: BTreeSet<String> = rows().iter().map(interfaces::Row::form).collect();
    for (part, form) in forms() {
        assert!(part != Part::Bsdf || written.contains(form.name()), "{}", form.name());
    }
}

#[test]
fn every_law_holds() {
    let cases: Vec<_> =
        interfaces::double().iter().flat_map(|entry| LAWS.map(|law| (entry, law))).collect();
    let wrong: Vec<String> = cases
        .into_par_iter()
        .filter_map(|(entry, (law, holds))| {
            Some(format!("{law}, {}: {}", entry.row.name, holds(entry).err()?))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_answer_in_single_precision_is_sound() {
    for entry in interfaces::single() {
        assert_eq!(unsound_anywhere(&*entry.model), None, "{}", entry.row.name);
    }
}

/// By every number of the description and by both directions, against differences.
#[test]
fn derivatives_over_the_sphere_are_those_of_the_answers() {
    let (mut compared, mut undecided) = (0, 0);
    for row in rows() {
        let found = derivatives(&row.bsdf, &questions_over_sphere(24));
        let name = &row.name;
        assert!(found.faults.is_empty(), "{name}: {}", found.faults.join("\n"));
        assert!(found.largest <= LARGEST, "{name}: {:e}: {}", found.largest, found.place);
        compared += found.compared;
        undecided += found.undecided;
    }
    assert!(undecided * 20 < compared, "differences cannot tell {undecided} of {compared}");
}

/// Draws are distributed as the density says, on both sides of the surface, at critical angles and grazing,
/// in both precisions.
#[test]
fn draws_follow_the_density() {
    const COUNT: u32 = 200_000;
    let models = interfaces::double().iter().zip(interfaces::single());
    let cases: Vec<_> = models
        .filter(|(entry, _)| entry.row.is_rough())
        .flat_map(|(double, single)| viewers().into_iter().map(move |wo| (double, single, wo)))
        .collect();
    assert!(cases.len() > 80, "{}", cases.len());
    let least = least_of(2 * cases.len());
    let wrong: Vec<String> = cases
        .into_par_iter()
        .filter_map(|(double, single, wo)| {
            let seen = sampling(&*double.model, &*single.model, wo, COUNT);
            let good = |verdict: &Verdict| verdict.p_value > least && verdict.terms > 20;
            let good = good(&seen.double) && good(&seen.single) && seen.rest > -1e-4;
            (!good).then(|| format!("{} {wo}: {seen:?}", double.row.name))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// To what its documentation says, by draws that fill the cube evenly.
#[test]
fn the_power_of_rough_glass_is_the_mean_of_many_draws() {
    [
        (0.0, 1.5, 0.1),
        (1.4, 1.5, 0.5),
        (PI - 0.5, 1.5, 0.3),
        (PI - 1.4, 1.5, 0.1),
        (PI, 1.5, 1.0),
        (0.7, 1.0 / 1.5, 0.3),
    ]
    .into_par_iter()
    .for_each(|(theta, ior, roughness)| {
        let wo: DVec3 = from_spherical(theta, 0.3);
        let ggx = Ggx::new(roughness).expect("a roughness");
        let glass = RoughDielectric::new(ggx, ior).expect("an index");
        let [returned, passed] = mean_weights(&glass, wo, 2_000_000);
        let power = glass.power(wo);
        let off = [power.reflectance - returned, power.transmittance - passed];
        println!("{theta:.2} {ior:.2} {roughness}: {off:?}");
        let near = off.iter().all(|off| off.abs().max_element() < 2e-4);
        assert!(near, "{theta} {ior} {roughness}: {power:?} {returned} {passed}");
    });
}

/// Values of the literature: rounded to four and to three digits.
#[test]
fn rough_glass_keeps_what_is_known() {
    for (ior, theta, roughness, correlated, separable) in [
        (1.5, 0.0, 0.1, 0.9988, None),
        (1.5, 0.0, 0.5, 0.9681, None),
        (1.5, 0.0, 1.0, 0.8933, None),
        (1.5, 1.4, 0.1, 0.942, Some(0.940)),
        (1.5, 1.4, 0.5, 0.679, Some(0.750)),
        (1.5, 1.4, 1.0, 0.243, Some(0.456)),
        (1.0 / 1.5, 0.0, 0.5, 0.754, None),
        (1.0 / 1.5, 0.0, 1.0, 0.417, None),
    ] {
        let wo: DVec3 = from_spherical(theta, 0.3);
        let ggx = Ggx::new(roughness).expect("a roughness");
        let glass = RoughDielectric::new(ggx, ior).expect("an index");
        let total = |power: brdf::Power<DVec3>| power.reflectance.x + power.transmittance.x;
        let got = total(glass.power(wo));
        println!("{ior:.2} {theta} {roughness}: {got:.5}");
        // Half a digit of the table and what the power promises.
        assert!((got - correlated).abs() < 7e-4, "{ior} {theta} {roughness}: {got}");
        if let Some(separable) = separable {
            let got = total(glass.with_shadowing(SmithSeparable).power(wo));
            assert!((got - separable).abs() < 7e-4, "{ior} {theta} {roughness}: {got}");
        }
    }
}
