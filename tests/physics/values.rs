//! Every formula against reference values of 50 digits.

use brdf_checks::values::{double, unread};

#[test]
fn every_formula_has_its_values() {
    let wrong: Vec<String> = double()
        .into_iter()
        .filter_map(|(name, check)| Some(format!("{name}: {}", check().err()?)))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Groups of values whose formulas are still to come.
const WAITING: [&str; 3] = ["albedo_ggx_correlated", "kulla_conty", "sample_vndf_ggx_heitz2018"];

#[test]
fn no_group_of_values_is_left_out() {
    double().into_iter().for_each(|(_, check)| drop(check()));
    assert_eq!(unread(), WAITING);
}
