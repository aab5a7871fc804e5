//! Descriptions with a mistake: the error names the place and what is allowed.

use brdf::ParameterError;
use brdf::description::{
    BrdfDescription, DescriptionError, DistributionDescription, FresnelDescription, Path, Problem,
    forms,
};
use brdf::parameter::Part;
use brdf_checks::models;
use serde_json::{Value, json};

fn model_error(text: &str) -> String {
    serde_json::from_str::<BrdfDescription>(text).expect_err(text).to_string()
}

#[test]
fn values_out_of_range_name_their_place_and_the_range() {
    for (text, message) in [
        (
            r#"{"lambert": {"albedo": [0.5, 1.5, 0.5]}}"#,
            "lambert.albedo[1] must be between 0 and 1, not 1.5",
        ),
        (
            r#"{"oren_nayar": {"albedo": 0.5, "sigma": 2}}"#,
            "oren_nayar.sigma must be between 0 and 1.5707963267948966, not 2",
        ),
        (
            r#"{"phong": {"specular": -1, "exponent": 2}}"#,
            "phong.specular must be between 0 and 1, not -1",
        ),
        (
            r#"{"phong": {"specular": 1, "exponent": -2, "normalized": false}}"#,
            "phong.exponent must be between 0 and 1e8, not -2",
        ),
        (
            r#"{"blinn_phong": {"specular": 1, "exponent": 1e9}}"#,
            "blinn_phong.exponent must be between 0 and 1e8, not 1e9",
        ),
        (
            r#"{"sum": [{"weight": 1, "brdf": {"lambert": {"albedo": 1}}},
                {"weight": 1, "brdf": {"cook_torrance": {"distribution":
                {"beckmann": {"roughness": 0}}, "fresnel": {"metal": "Au"}}}}]}"#,
            "sum[1].brdf.cook_torrance.distribution.beckmann.roughness must be between 1e-8 and \
             10000, not 0",
        ),
        (
            r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": [1, -1]}},
                "fresnel": {"constant": 1}}}"#,
            "cook_torrance.distribution.ggx.roughness[1] must be between 1e-8 and 10000, not -1",
        ),
        (
            r#"{"cook_torrance": {"distribution": {"mixture": [{"weight": -1, "distribution":
                {"blinn": {"exponent": 2}}}]}, "fresnel": {"constant": 1}}}"#,
            "cook_torrance.distribution.mixture[0].weight must be between 0 and 1e10, \
             not -1",
        ),
        (
            r#"{"cook_torrance": {"distribution": {"mixture": []}, "fresnel": {"constant": 1}}}"#,
            "cook_torrance.distribution.mixture: sum of weights must be between 1e-30 and 1e30, \
             not 0",
        ),
        (
            r#"{"sum": [{"weight": [0, 0, -1], "brdf": {"lambert": {"albedo": 1}}}]}"#,
            "sum[0].weight[2] must be between 0 and 1e10, not -1",
        ),
        (r#"{"sum": []}"#, "sum: total weight must be between 1e-30 and 1e30, not 0"),
        (
            r#"{"torrance_sparrow_1967": {"c": 0, "fresnel": {"constant": 1}}}"#,
            "torrance_sparrow_1967.c must be between 1e-5 and 100000, not 0",
        ),
        (
            r#"{"blinn_1977_printed": {"distribution": "d1", "beta": 2, "fresnel": {"constant": 1}}}"#,
            "blinn_1977_printed.beta must be between 0.0002 and 1.57, not 2",
        ),
    ] {
        assert_eq!(model_error(text), message);
    }
    for (text, message) in [
        (
            r#"{"dielectric": {"ior": [1, 2, 0]}}"#,
            "dielectric.ior[2] must be between 0.0001 and 10000, not 0",
        ),
        (r#"{"constant": [0, 2, 3]}"#, "constant[1] must be between 0 and 1, not 2"),
        (r#"{"constant": 2}"#, "constant must be between 0 and 1, not 2"),
        (r#"{"dielectric": {"ior": 0}}"#, "dielectric.ior must be between 0.0001 and 10000, not 0"),
        (
            r#"{"conductor": {"eta": 1, "k": [1, 1, -1]}}"#,
            "conductor.k[2] must be between 0 and 10000, not -1",
        ),
        (r#"{"schlick": {"f0": 1.1}}"#, "schlick.f0 must be between 0 and 1, not 1.1"),
        (
            r#"{"hall": {"f0": 1, "ior": 1e5}}"#,
            "hall.ior must be between 0.0001 and 10000, not 100000",
        ),
        (
            r#"{"hall": {"f0": 1, "ior": [0, 3]}}"#,
            "hall.ior[0] must be between 0.0001 and 10000, not 0",
        ),
        (
            r#"{"cook": {"f0": 1, "light": 1, "ior": [0.2, -3]}}"#,
            "cook.ior[1] must be between 0 and 10000, not -3",
        ),
        (r#"{"hall": {"f0": 2, "ior": [0.2, 3]}}"#, "hall.f0 must be between 0 and 1, not 2"),
        (r#"{"cook": {"f0": 1, "light": -1}}"#, "cook.light must be between 0 and 1e10, not -1"),
    ] {
        let error = serde_json::from_str::<FresnelDescription>(text).expect_err(text);
        assert_eq!(error.to_string(), message);
    }
    let text = r#"{"hall": {"f0": 1, "ior": [1, 2, 3]}}"#;
    let error = serde_json::from_str::<FresnelDescription>(text).expect_err(text).to_string();
    let message = "hall.ior: invalid length, more than 2, expected a number or a list of 2 numbers";
    assert!(error.starts_with(message), "{error}");
    let text = r#"{"gaussian": {"roughness": 1e5}}"#;
    let error = serde_json::from_str::<DistributionDescription>(text).expect_err(text);
    assert_eq!(error.to_string(), "gaussian.roughness must be between 1e-8 and 10000, not 100000");
}

#[test]
fn mistakes_of_form_name_their_place() {
    let error = model_error(r#"{"lambret": {"albedo": 1}}"#);
    assert!(error.starts_with("lambret: unknown name, expected one of `lambert`, "), "{error}");
    for row in models::rows() {
        let form = row.form();
        assert!(error.contains(&format!("`{form}`")), "{form}: {error}");
    }
    for (text, message) in [
        (
            r#"{"phong": {"specular": 1, "exponent": 2, "sharpness": 3}}"#,
            "phong.sharpness: unknown name, expected one of `specular`, `exponent`, `normalized`",
        ),
        (
            r#"{"cook_torrance": {"distribution": {"ggx": {"alpha": 1}}}}"#,
            "cook_torrance.distribution.ggx.alpha: unknown name, expected `roughness`",
        ),
        (r#"{"phong": {"specular": 1}}"#, "phong.exponent: this key is missing"),
        (r#"{"phong": {"specular": 1, "specular": 1}}"#, "phong.specular: this key is given twice"),
        (
            r#"{"phong": {"specular": "red", "exponent": 1}}"#,
            "phong.specular: invalid type: string \"red\", expected a number or a list of 3 \
             numbers",
        ),
        (
            r#"{"phong": {"specular": [1, 1], "exponent": 1}}"#,
            "phong.specular: invalid length 2, expected a number or a list of 3 numbers",
        ),
        (
            r#"{"phong": {"specular": [1, 1, 1, 1], "exponent": 1}}"#,
            "phong.specular: invalid length, more than 3, expected a number or a list of 3 numbers",
        ),
        (
            r#"{"phong": {"specular": [1, null, 1], "exponent": 1}}"#,
            "phong.specular[1]: invalid type: null, expected a number",
        ),
        (
            r#"{"phong": {"specular": 1, "exponent": [2]}}"#,
            "phong.exponent: invalid type: sequence, expected a number",
        ),
        (
            r#"{"phong": {"specular": 1, "exponent": 2, "normalized": 0}}"#,
            "phong.normalized: invalid type: integer `0`, expected a boolean",
        ),
        (
            r#"{"phong": [1, 2]}"#,
            "phong: invalid type: sequence, expected an object with the keys `specular` \
             `exponent` `normalized`",
        ),
        (r#"{"sum": {"weight": 1}}"#, "sum: invalid type: map, expected a list of terms"),
        (
            r#"{"sum": [{"weight": 1, "brdf": {"lambert": {"albedo": true}}}]}"#,
            "sum[0].brdf.lambert.albedo: invalid type: boolean `true`, expected a number or a \
             list of 3 numbers",
        ),
        (
            r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": 1}},
                "fresnel": {"constant": 1}, "shadowing": "smyth"}}"#,
            "cook_torrance.shadowing: unknown name \"smyth\", expected one of `v_cavity`, `smith`, \
             `smith_separable`",
        ),
    ] {
        // The reader of JSON adds where in the text.
        let error = model_error(text);
        let (found, position) = error.split_once(" at line ").expect(&error);
        assert_eq!(found, message);
        assert!(position.contains(" column "), "{error}");
    }
}

#[test]
fn unknown_forms_are_answered_by_the_known_ones() {
    let error = model_error(r#"{"lambret": {"albedo": 1}}"#);
    let known = forms().filter(|(part, _)| *part == Part::Brdf);
    let known: Vec<_> = known.map(|(_, form)| format!("`{}`", form.name())).collect();
    let message = format!("lambret: unknown name, expected one of {} at line", known.join(", "));
    assert!(error.starts_with(&message), "{error}");
}

#[test]
fn forms_of_another_description_say_of_which() {
    for (text, hint) in [
        (r#"{"mirror": {}}"#, "mirror: unknown name here, a form of `BsdfDescription`, expected "),
        (
            r#"{"he_1991": {}}"#,
            "he_1991: unknown name here, a form of `BsdfDescription`, expected ",
        ),
        (
            r#"{"torrance_sparrow_1967": {"c": 0.05, "fresnel": {"ggx": {"roughness": 1}}}}"#,
            "torrance_sparrow_1967.fresnel.ggx: unknown name here, a form of \
             `DistributionDescription`, expected ",
        ),
    ] {
        let error = model_error(text);
        assert!(error.starts_with(hint), "{error}");
    }
}

#[test]
fn words_are_texts_and_vectors_have_three_numbers() {
    for (text, message) in [
        (
            r#"{"hapke": {"w": 0.5, "h_function": 1993}}"#,
            "hapke.h_function: expected a text, one of \"1993\" \"1981\"",
        ),
        (
            r#"{"disney_2012": {"base_color": 0.5, "form": 2014}}"#,
            "disney_2012.form: expected a text, one of \"2012\" \"2014\"",
        ),
        (
            r#"{"lafortune": {"lobes": [{"c": -1, "exponent": 2}]}}"#,
            "lafortune.lobes[0].c: invalid type: integer `-1`, expected a list of 3 numbers",
        ),
    ] {
        let error = model_error(text);
        assert!(error.starts_with(message), "{error}");
    }
}

/// Errors that the reader of JSON raises by itself say what is expected, too.
#[test]
fn values_of_a_wrong_form_say_what_is_expected() {
    const MODEL: &str = r#"expected a model, such as {"lambert": {"albedo": 0.5}}: "#;
    for (text, message) in [
        ("{}", format!("{MODEL}expected value")),
        ("null", format!("{MODEL}expected value")),
        ("[]", format!("{MODEL}expected value")),
        ("0.5", format!("{MODEL}expected value")),
        (
            r#"{"lambert": {"albedo": 1}, "phong": {"specular": 1, "exponent": 1}}"#,
            "`lambert` must be the only key of its object: expected value".into(),
        ),
        (
            r#""lambert""#,
            "lambert: expected an object with the keys `albedo`: invalid type: unit variant, \
             expected struct variant"
                .into(),
        ),
        (
            r#"{"sum": [{"weight": 1, "brdf": null}]}"#,
            format!("sum[0].brdf: {MODEL}expected value"),
        ),
        (
            r#"{"sum": [{"weight": 1, "brdf": {"lambert": {"albedo": 1}, "sum": []}}]}"#,
            "sum[0].brdf: `lambert` must be the only key of its object: expected value".into(),
        ),
        (
            r#"{"sum": [null]}"#,
            "sum[0]: invalid type: null, expected an object with the keys `weight` `brdf`".into(),
        ),
        (
            r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": 1}}, "fresnel": {}}}"#,
            "cook_torrance.fresnel: expected a Fresnel term, such as {\"schlick\": {\"f0\": \
             0.04}}: expected value"
                .into(),
        ),
        (
            r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": 1}},
                "fresnel": {"constant": 1}, "shadowing": 3}}"#,
            "cook_torrance.shadowing: expected a text, one of \"v_cavity\" \"smith\" \
             \"smith_separable\": expected value"
                .into(),
        ),
    ] {
        let error = model_error(text);
        let (found, position) = error.split_once(" at line ").unwrap_or((&error, ""));
        assert_eq!(found, message);
        assert!(position.contains(" column ") || text.starts_with('"'), "{error}");
    }
}

#[test]
fn smith_is_refused_where_it_is_not_known() {
    for (distribution, name) in [
        (r#"{"gaussian": {"roughness": 0.3}}"#, "gaussian"),
        (r#"{"blinn": {"exponent": 30}}"#, "blinn"),
        (
            r#"{"mixture": [{"weight": 1, "distribution": {"ggx": {"roughness": 1}}},
                         {"weight": 1, "distribution": {"blinn": {"exponent": 1}}}]}"#,
            "blinn",
        ),
    ] {
        for shadowing in ["smith", "smith_separable"] {
            let text = format!(
                r#"{{"cook_torrance": {{"distribution": {distribution},
                    "fresnel": {{"constant": 1}}, "shadowing": "{shadowing}"}}}}"#
            );
            assert_eq!(
                model_error(&text),
                format!(
                    "cook_torrance.shadowing: Smith's shadowing is known for `beckmann`, `ggx` and \
                     mixtures of them, not for `{name}`; `v_cavity` fits every distribution"
                )
            );
        }
    }
}

#[test]
fn one_index_is_asked_for_where_wavelengths_are_not_told_apart() {
    const RULE: &str = "belcour_barla.substrate: must be one index for all wavelengths, that is a \
                        number, [n, k], or the same eta and k in all channels, not ";
    for (substrate, found) in [
        (r#"{"eta": [0.2, 0.9, 1.1], "k": 3}"#, "eta [0.2, 0.9, 1.1]"),
        (r#"{"eta": 1.5, "k": [3, 3, 2.5]}"#, "k [3.0, 3.0, 2.5]"),
        (r#"{"material": "Au"}"#, r#"the material "Au""#),
        (r#"{"samples": [[400, 1.5, 0], [700, 1.4, 0]]}"#, "samples"),
    ] {
        let text = format!(
            r#"{{"belcour_barla": {{"film": 1.33, "thickness": 300, "substrate": {substrate}}}}}"#
        );
        let error = serde_json::from_str::<FresnelDescription>(&text).expect_err(&text);
        assert_eq!(error.to_string(), format!("{RULE}{found}"));
    }
}

#[test]
fn unknown_metals_are_named() {
    let error =
        |text| serde_json::from_str::<FresnelDescription>(text).expect_err(text).to_string();
    assert_eq!(
        error(r#"{"metal": "unobtainium"}"#),
        "metal: no material is called \"unobtainium\""
    );
    assert_eq!(
        error(r#"{"metal": "water"}"#),
        "metal: water is no metal; describe it as a dielectric by its index"
    );
}

/// The place begins at the description, also where that is a part of something else.
#[test]
fn places_are_counted_from_the_description() {
    #[derive(Debug, serde::Deserialize)]
    struct Object {
        #[serde(rename = "surface")]
        _surface: BrdfDescription,
    }
    let text = r#"{"surface": {"lambert": {"albedo": 2}}}"#;
    let error = serde_json::from_str::<Object>(text).expect_err(text).to_string();
    assert!(
        error.starts_with("lambert.albedo must be between 0 and 1, not 2 at line 1"),
        "{error}"
    );
}

/// Formats that have numbers which JSON does not have.
#[test]
fn numbers_that_are_none_are_out_of_range() {
    for (text, message) in [
        ("lambert(albedo: NaN)", "lambert.albedo must be between 0 and 1, not NaN"),
        ("lambert(albedo: [0, inf, 0])", "lambert.albedo[1] must be between 0 and 1, not inf"),
    ] {
        let error = ron::from_str::<BrdfDescription>(text).expect_err(text);
        assert!(error.to_string().contains(message), "{error}");
    }
}

/// Numbers that building makes of the values are checked again.
#[test]
fn building_checks_too() {
    let text = r#"{"ggx": {"roughness": [0.5, 0.5]}}"#;
    let description: DistributionDescription = serde_json::from_str(text).expect(text);
    let wrong = |path: &Path<'_>, value: f64| {
        if path.to_string() == "ggx.roughness[1]" { f32::NAN } else { value as f32 }
    };
    let error: DescriptionError = description.build_with(wrong).expect_err("out of range");
    assert_eq!(error.path(), "ggx.roughness[1]");
    let Problem::Parameter(error) = error.problem() else { panic!("{error}") };
    let _: &ParameterError = error;
    assert_eq!(error.range(), (1e-8, 1e4));

    let text = r#"{"sum": [{"weight": 1, "brdf": {"lambert": {"albedo": 0.5}}}]}"#;
    let description: BrdfDescription = serde_json::from_str(text).expect(text);
    let error = |number: fn(&Path<'_>, f64) -> f64| {
        description.build_with(number).expect_err("out of range").to_string()
    };
    let above = error(|_, value| 4.0 * value);
    assert_eq!(above, "sum[0].brdf.lambert.albedo must be between 0 and 1, not 2");
    let none = error(|path, value| if path.to_string() == "sum[0].weight" { 0.0 } else { value });
    assert_eq!(none, "sum: total weight must be between 1e-30 and 1e30, not 0");
}

/// A value inside a description: where it stands for a reader and for an error, and what it is.
struct Spot {
    pointer: String,
    path: String,
    /// An object with the keys of a form, not one that names a form.
    has_keys: bool,
}

impl Spot {
    fn inner(&self, key: &str, has_keys: bool) -> Self {
        let dot = if self.path.is_empty() { "" } else { "." };
        let path = match key.parse::<usize>() {
            Ok(index) => format!("{}[{index}]", self.path),
            Err(_) => format!("{}{dot}{key}", self.path),
        };
        Self { pointer: format!("{}/{key}", self.pointer), path, has_keys }
    }

    /// This value and all inside it.
    fn collect(self, value: &Value, all: &mut Vec<Self>) {
        match value {
            Value::Object(keys) => {
                for (key, inner) in keys {
                    self.inner(key, !self.has_keys).collect(inner, all);
                }
            }
            Value::Array(list) => {
                for (index, inner) in list.iter().enumerate() {
                    self.inner(&index.to_string(), true).collect(inner, all);
                }
            }
            Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
        }
        all.push(self);
    }
}

/// Every value of every model of the registry, one mistake at a time: the error begins with its
/// place.
#[test]
fn every_mistake_names_its_place() {
    let mut mistakes = 0;
    for row in models::rows() {
        let right = serde_json::to_value(&row.brdf).expect("JSON");
        let mut refused = |spot: &Spot, mistake: &dyn Fn(&mut Value), message: &str| {
            let mut wrong = right.clone();
            mistake(wrong.pointer_mut(&spot.pointer).expect("it is there"));
            let text = wrong.to_string();
            let error = model_error(&text);
            assert!(error.starts_with(&format!("{}{message}", spot.path)), "{text}: {error}");
            mistakes += 1;
        };
        let mut spots = Vec::new();
        let whole = Spot { pointer: String::new(), path: String::new(), has_keys: false };
        whole.collect(&right, &mut spots);
        for spot in &spots {
            match right.pointer(&spot.pointer).expect("it is there") {
                Value::Number(_) => {
                    for number in [-1e300, 1e300] {
                        refused(spot, &|value| *value = json!(number), " must be between ");
                    }
                    refused(spot, &|value| *value = json!("?"), ": invalid type: string \"?\"");
                }
                Value::Object(_) if spot.has_keys => {
                    let add = |value: &mut Value| value["?"] = json!(0);
                    refused(spot, &add, ".?: unknown name, expected ");
                }
                Value::String(_) => {
                    let word = |value: &mut Value| *value = json!("?");
                    let message = if spot.path.ends_with(".material") {
                        ": no material is called \"?\""
                    } else {
                        ": unknown name \"?\", expected one of "
                    };
                    refused(spot, &word, message);
                }
                Value::Bool(_) => {
                    refused(spot, &|value| *value = json!(1), ": invalid type: integer `1`");
                }
                Value::Null | Value::Array(_) | Value::Object(_) => {}
            }
        }
    }
    assert!(mistakes > 1000, "{mistakes}");
}
