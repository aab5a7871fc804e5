//! The questions and answers of the example `evaluate`.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::io::BufReader;

use brdf_checks::models;
use indicatif::{ProgressBar, ProgressDrawTarget};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use serde::Serialize;
use serde_json::{Value, json};

use crate::command::{self, Streams};
use crate::question::Precision;
use crate::stream::{self, MAX_LINE, Tally};

const PAGE: &str = include_str!("../../docs/evaluate.md");
const QUESTIONS: &str = include_str!("../../examples/evaluate/questions.jsonl");

fn ask_all(questions: &[u8], precision: Precision) -> (Vec<Value>, Tally) {
    let mut answers = Vec::new();
    let mut input = BufReader::new(questions);
    let progress = ProgressBar::hidden();
    let tally = stream::answer_all(&mut input, &mut answers, precision, &progress);
    let answers = String::from_utf8(answers).expect("text");
    let answers = answers.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
    (answers, tally.expect("nothing fails in memory"))
}

fn ask(question: &str) -> Value {
    let (mut answers, tally) = ask_all(question.as_bytes(), Precision::Double);
    assert_eq!((answers.len(), tally.questions), (1, 1), "{question}");
    answers.remove(0)
}

fn error(question: &str) -> String {
    let answer = ask(question);
    assert_eq!(answer.as_object().map(serde_json::Map::len), Some(2), "{answer}");
    assert_eq!(answer["line"], 1, "{answer}");
    answer["error"].as_str().expect(question).into()
}

/// What an answer to a question must look like.
fn expected_keys(question: &Value) -> &'static [&'static str] {
    let has = |key| question.get(key).is_some();
    match () {
        () if has("specular") => &["lobes"],
        () if has("mueller") => &["mueller"],
        () if has("gradient") => &["value", "gradient"],
        () if has("wgsl") => &["text"],
        () if has("surface") => &["r", "t", "reflectance", "transmittance"],
        () if has("stokes") => &["stokes", "degree_of_polarization"],
        () if has("optics") => &["mueller", "jones"],
        () if has("wi") => &["value", "pdf"],
        () if has("u") => &["wi", "weight", "pdf"],
        () if has("brdf") => &["albedo"],
        () if has("bsdf") => &["reflectance", "transmittance"],
        () if question.pointer("/fresnel/belcour_barla").is_some() && has("cos") => {
            &["reflectance", "xyz"]
        }
        () if has("cos") => &["reflectance"],
        () if has("fresnel") => &["average"],
        () => &["density"],
    }
}

fn numbers(answer: &Value) -> Vec<f64> {
    match answer {
        Value::Object(object) => object.values().flat_map(numbers).collect(),
        Value::Array(list) => list.iter().flat_map(numbers).collect(),
        Value::Number(number) => number.as_f64().into_iter().collect(),
        _ => Vec::new(),
    }
}

/// Every kind of question in the file has an answer of its kind; single precision agrees.
#[test]
fn the_questions_of_the_example_have_answers() {
    let (answers, tally) = ask_all(QUESTIONS.as_bytes(), Precision::Double);
    let (single, _) = ask_all(QUESTIONS.as_bytes(), Precision::Single);
    assert_eq!(tally, Tally { questions: QUESTIONS.lines().count() as u64, failed: 0 });
    assert_eq!(answers.len(), QUESTIONS.lines().count());
    for ((question, answer), single) in QUESTIONS.lines().zip(&answers).zip(&single) {
        let parsed: Value = serde_json::from_str(question).expect(question);
        let keys: Vec<_> = answer.as_object().expect(question).keys().collect();
        let mut expected = expected_keys(&parsed).to_vec();
        expected.sort_unstable();
        assert_eq!(keys, expected, "{question}");
        for (double, single) in numbers(answer).into_iter().zip(numbers(single)) {
            assert!(
                (double - single).abs() <= 2e-5 * double.abs().max(0.1),
                "{question}: {single}"
            );
        }
    }
}

/// What the page shows is asked in the file, but for the mistake, and answered so.
#[test]
fn the_page_shows_questions_with_their_answers() {
    let lines: Vec<&str> = PAGE.lines().collect();
    let shown = lines.windows(2).filter_map(|pair| Some((pair[0], pair[1].strip_prefix("  {")?)));
    let (mut kinds, mut mistakes) = (BTreeSet::new(), 0);
    for (question, answer) in shown {
        let (status, given, _) = command_line(&[], question.as_bytes());
        assert_eq!(given, format!("{{{answer}\n"), "{question}");
        if status == 0 {
            assert!(QUESTIONS.lines().any(|line| line == question), "{question}");
            kinds.insert(expected_keys(&serde_json::from_str(question).expect(question)));
        }
        mistakes += status;
    }
    assert_eq!((kinds.len(), mistakes), (7, 1));
}

#[test]
fn the_questions_of_the_example_are_of_every_kind() {
    let kinds: BTreeSet<_> = QUESTIONS
        .lines()
        .map(|line| expected_keys(&serde_json::from_str(line).expect(line)))
        .collect();
    assert_eq!(kinds.len(), 15, "{kinds:?}");
}

/// Every model of the registry, asked in JSON, answers to the last bit what it answers in Rust.
#[test]
fn every_model_of_the_registry_answers() {
    let (wi, wo, u) = ([0.6, 0.0, 0.8], [0.0, -0.28, 0.96], [0.25, 0.75]);
    let questions: String = models::rows()
        .iter()
        .flat_map(|row| {
            let brdf = &row.brdf;
            [
                json!({"brdf": brdf, "wi": wi, "wo": wo}),
                json!({"brdf": brdf, "wo": wo, "u": u}),
                json!({"brdf": brdf, "wo": wo}),
            ]
        })
        .map(|question| format!("{question}\n"))
        .collect();
    let (double, tally) = ask_all(questions.as_bytes(), Precision::Double);
    assert_eq!(tally.failed, 0);
    let (single, _) = ask_all(questions.as_bytes(), Precision::Single);
    // As it is written, with the digits that the number needs.
    fn written(value: impl Serialize) -> Value {
        serde_json::from_str(&serde_json::to_string(&value).expect("JSON")).expect("JSON")
    }
    macro_rules! compare {
        ($answers:expr, $models:expr, $number:ident, $vector:ident) => {
            for (answers, entry) in $answers.chunks(3).zip($models) {
                let [wi, wo] = [wi, wo].map(|w| glam::$vector::from_array(w.map(|x| x as $number)));
                let (model, u) = (&entry.model, u.map(|u| u as $number));
                let sample = model.sample(wo, u);
                let (drawn, weight) = (sample.wi.to_array(), sample.weight.to_array());
                let value = model.eval(wi, wo).to_array();
                let want = [
                    json!({"value": written(value), "pdf": written(model.pdf(wi, wo))}),
                    json!({
                        "wi": written(drawn),
                        "weight": written(weight),
                        "pdf": written(sample.pdf),
                    }),
                    json!({"albedo": written(model.albedo(wo).to_array())}),
                ];
                assert_eq!(answers, want, "{}", entry.name);
            }
        };
    }
    compare!(double, models::double(), f64, DVec3);
    compare!(single, models::single(), f32, Vec3);
}

#[test]
fn answers_have_known_values() {
    let close = |question: &str, key: &str, want: &[f64]| {
        let answer = ask(question);
        let got = match &answer[key] {
            Value::Array(list) => list.iter().filter_map(Value::as_f64).collect(),
            one => one.as_f64().into_iter().collect::<Vec<_>>(),
        };
        assert_eq!(got.len(), want.len(), "{question}: {answer}");
        for (got, want) in got.iter().zip(want) {
            assert!((got - want).abs() < 1e-9, "{question}: {answer}");
        }
    };
    let lambert = r#"{"brdf": {"lambert": {"albedo": [1, 0.5, 0]}}, "wo": [0, 0, 1]"#;
    let per_pi = std::f64::consts::FRAC_1_PI;
    close(&format!("{lambert}, \"wi\": [0.6, 0, 0.8]}}"), "value", &[per_pi, per_pi / 2.0, 0.0]);
    close(&format!("{lambert}, \"wi\": [0.6, 0, 0.8]}}"), "pdf", &[per_pi * 0.8]);
    close(&format!("{lambert}, \"wi\": [0.6, 0, -0.8]}}"), "value", &[0.0, 0.0, 0.0]);
    close(&format!("{lambert}}}"), "albedo", &[1.0, 0.5, 0.0]);
    close(&format!("{lambert}, \"u\": [0.5, 0.25]}}"), "weight", &[1.0, 0.5, 0.0]);
    close(r#"{"fresnel": {"dielectric": {"ior": 1.5}}, "cos": 1}"#, "reflectance", &[0.04; 3]);
    close(r#"{"fresnel": {"dielectric": {"ior": 1.5}}}"#, "average", &[0.0917779593423512; 3]);
    close(
        r#"{"optics": {"chain": [{"polarizer": 0}, {"rotation": 0.5}]}, "stokes": [2, 0, 0, 0]}"#,
        "stokes",
        &[1.0, 1_f64.cos(), -1_f64.sin(), 0.0],
    );
    close(
        r#"{"optics": {"retarder": {"retardance": 1.5707963267948966}}, "stokes": [1, 0, 1, 0]}"#,
        "stokes",
        &[1.0, 0.0, 0.0, 1.0],
    );
    close(
        r#"{"distribution": {"beckmann": {"roughness": 0.5}}, "h": [0, 0, 1]}"#,
        "density",
        &[4.0 * per_pi],
    );
    let frosted =
        r#"{"rough_dielectric": {"distribution": {"ggx": {"roughness": 0.3}}, "ior": 1.5}}"#;
    let through = format!("{{\"bsdf\": {frosted}, \"wi\": [0, 0, -1], \"wo\": [0, 0, 1]");
    // T D/(1 − 1.5)², and of that the radiance that leaves glass has 1/1.5².
    let importance = 30.557749073643908;
    close(&format!("{through}}}"), "value", &[importance / 2.25; 3]);
    close(&format!("{through}, \"mode\": \"importance\"}}"), "value", &[importance; 3]);
    close(
        r#"{"bsdf": {"dielectric": {"ior": 1.5}}, "wo": [0, 0, -1]}"#,
        "transmittance",
        &[0.96; 3],
    );
    close(
        r#"{"bsdf": {"thin_dielectric": {"ior": 1.5}}, "wo": [0, 0, 1]}"#,
        "reflectance",
        &[0.08 / 1.04; 3],
    );
}

/// A specular lobe has no density; value and albedo of a model over the hemisphere leave it out and
/// have it in.
/// The direction of a lobe is a vector, each of whose components moves all channels.
#[test]
fn the_gradient_has_each_component_of_a_vector() {
    let value = |c: [f64; 3]| {
        let lobes = json!([{"specular": [0.5, 0.4, 0.3], "c": c, "exponent": 3}]);
        let model = json!({"lafortune": {"diffuse": [0.3, 0.2, 0.1], "lobes": lobes}});
        let pair = json!({"wi": [0.6, 0, 0.8], "wo": [-0.48, 0.36, 0.8]});
        let question = |key: &str| {
            let mut question = pair.clone();
            question[key] = model.clone();
            ask(&question.to_string())
        };
        (numbers(&question("brdf")["value"]), question("gradient")["gradient"].clone())
    };
    let at = [-1.0, -1.0, 0.9];
    let (_, gradient) = value(at);
    let keys: Vec<_> = gradient.as_object().expect("an object").keys().collect();
    assert_eq!(
        keys,
        [
            "lafortune.diffuse",
            "lafortune.lobes[0].c[0]",
            "lafortune.lobes[0].c[1]",
            "lafortune.lobes[0].c[2]",
            "lafortune.lobes[0].exponent",
            "lafortune.lobes[0].specular",
        ]
    );
    for place in 0..3 {
        let moved = |by: f64| {
            let mut c = at;
            c[place] += by;
            value(c).0
        };
        let derivatives = numbers(&gradient[format!("lafortune.lobes[0].c[{place}]")]);
        for ((above, below), derivative) in
            moved(1e-5).into_iter().zip(moved(-1e-5)).zip(derivatives)
        {
            let difference = (above - below) / 2e-5;
            assert!((difference - derivative).abs() < 1e-8, "{place}: {difference} {derivative}");
        }
    }
}

#[test]
fn lobes_have_no_density() {
    let glass = r#"{"bsdf": {"dielectric": {"ior": 1.5}}, "wo": [0, 0, 1], "u": [0.5, 0.5,"#;
    let drawn = |u: f64, mode: &str| ask(&format!("{glass} {u}], \"mode\": \"{mode}\"}}"));
    let (back, through) = (drawn(0.039, "radiance"), drawn(0.041, "radiance"));
    assert_eq!((&back["pdf"], &back["wi"]), (&Value::Null, &json!([0.0, 0.0, 1.0])));
    assert_eq!((&through["pdf"], &through["wi"]), (&Value::Null, &json!([0.0, 0.0, -1.0])));
    assert_eq!(back["weight"], json!([1.0, 1.0, 1.0]));
    assert_eq!(drawn(0.041, "importance")["weight"], json!([1.0, 1.0, 1.0]));
    assert!((through["weight"][0].as_f64().expect("a number") - 1.0 / 2.25).abs() < 1e-15);

    let plastic = r#"{"brdf": {"plastic": {"diffuse": 0}}, "wo": [0, 0, 1]"#;
    assert_eq!(ask(&format!("{plastic}, \"wi\": [0, 0, 1]}}"))["value"], json!([0.0, 0.0, 0.0]));
    let albedo = &ask(&format!("{plastic}}}"))["albedo"][0];
    assert!((albedo.as_f64().expect("a number") - 0.04).abs() < 1e-15);
    assert_eq!(ask(&format!("{plastic}, \"u\": [0.03, 0.5]}}"))["pdf"], Value::Null);
    assert!(ask(&format!("{plastic}, \"u\": [0.05, 0.5]}}"))["pdf"].is_number());

    let lobes = |model: &str| ask(&format!("{{\"specular\": {model}, \"wo\": [0.8, 0, -0.6]}}"));
    let count = |model| lobes(model)["lobes"].as_array().expect("a list").len();
    assert_eq!(count(r#"{"dielectric": {"ior": 1.5}}"#), 1); // total reflection
    assert_eq!(count(r#"{"dielectric": {"ior": 0.5}}"#), 2);
    assert_eq!(count(r#"{"mirror": {}}"#), 0);
    assert_eq!(count(r#"{"lambert": {"albedo": 1}}"#), 0);
}

#[test]
fn errors_say_what_and_where_and_what_is_allowed() {
    for (question, message) in [
        ("", None),
        (
            "{}",
            Some(
                "a question has the keys brdf, wi, wo; or brdf, wo, u; or brdf, wo; or bsdf, wi, wo \
                 and perhaps mode; or bsdf, wo, u and perhaps mode; or bsdf, wo; or specular, wo and \
                 perhaps mode; or mueller, wi, wo; or gradient, wi, wo; or wgsl, name; or fresnel, \
                 cos; or fresnel; or distribution, h; or surface, cos and perhaps wavelength; or \
                 optics and perhaps stokes, wavelength",
            ),
        ),
        (
            r#"{"brdf": {"lambert": {"albedo": 2}}, "wo": [0, 0, 1]}"#,
            Some("brdf: lambert.albedo must be between 0 and 1, not 2"),
        ),
        (
            r#"{"brdf": {"lambert": {"albedo": "2"}}, "wo": [0, 0, 1]}"#,
            Some(
                "brdf: lambert.albedo: invalid type: string \"2\", expected a number or a list \
                  of 3 numbers at column 35",
            ),
        ),
        (
            r#"{"brdf": {"lambert": {"albedo": 0.5}}, "wo": [0, 0]}"#,
            Some("wo must be a list of 3 numbers, not of 2"),
        ),
        (
            r#"{"brdf": {"lambert": {"albedo": 0.5}}, "wo": [0, 0, 1, 0]}"#,
            Some("wo must be a list of 3 numbers, not of 4"),
        ),
        (
            r#"{"brdf": {"lambert": {"albedo": 0.5}}, "wo": [0, 0, 1], "u": [0]}"#,
            Some("u must be a list of 2 numbers, not of 1"),
        ),
        (
            r#"{"brdf": {"lambert": {"albedo": 0.5}}, "wo": [0, 0, 1], "u": [0, -1e-300]}"#,
            Some("u[1] must be at least 0 and below 1, not -1e-300"),
        ),
        (
            "null",
            Some("invalid type: null, expected an object with the keys of a question at column 4"),
        ),
        (
            r#"{"brdf": {}, "wo": [0, 0, 1]}"#,
            Some(
                "brdf: expected a model, such as {\"lambert\": {\"albedo\": 0.5}}: expected value at \
                 column 11",
            ),
        ),
        (
            r#"{"brdf": {"lambert": {"albedo": 0.5}}, "wo": [0, 0, 3]}"#,
            Some(
                "wo must be a unit vector (squared length between 0.99 and 1.01, in single precision \
                 too), not of squared length 9",
            ),
        ),
        (
            r#"{"brdf": {"lambert": {"albedo": 0.5}}, "wo": [0, 0, 1], "u": [0, 1]}"#,
            Some("u[1] must be at least 0 and below 1, not 1"),
        ),
        (
            r#"{"wgsl": {"lambert": {"albedo": 2}}, "name": "chalk"}"#,
            Some("wgsl: lambert.albedo must be between 0 and 1, not 2"),
        ),
        (
            r#"{"wgsl": {"lambert": {"albedo": 1}}, "name": "var"}"#,
            Some(
                "name must be a letter, then letters, digits and single underscores, no word of \
                 WGSL and not begin with `brdf`; it is \"var\"",
            ),
        ),
        (
            r#"{"fresnel": {"metal": "Au"}, "cos": 1.5}"#,
            Some("cos must be between -1 and 1, not 1.5"),
        ),
        (
            r#"{"fresnel": {"metal": "Au"}, "cosine": 1}"#,
            Some(
                "unknown field `cosine`, expected one of `brdf`, `bsdf`, `specular`, `fresnel`, \
                 `distribution`, `wi`, `wo`, `u`, `cos`, `h`, `mueller`, `gradient`, `wgsl`, `name`, \
                 `surface`, `optics`, `stokes`, `wavelength`, `mode` at column 37",
            ),
        ),
        (
            r#"{"specular": {"mirror": {}}, "wo": [0, 0, 1], "mode": "light"}"#,
            Some("mode must be radiance or importance, not light"),
        ),
        (
            r#"{"bsdf": {"rough_dielectric": {"distribution": {"blinn": {"exponent": 9}}, "ior": 1}}, "wo": [0, 0, 1]}"#,
            Some("bsdf: rough_dielectric.distribution: must be `beckmann` or `ggx`, not `blinn`"),
        ),
        (
            r#"{"fresnel": {"metal": "Au"}, "cos": null}"#,
            Some("cos: invalid type: null, expected f64 at column 40"),
        ),
    ] {
        match message {
            Some(message) => assert_eq!(error(question), message, "{question}"),
            None => assert_eq!(ask_all(question.as_bytes(), Precision::Double).0.len(), 0),
        }
    }
    for (question, message) in [
        (
            r#"{"mueller": {"lambert": {"albedo": 0.5}}, "wi": [0, 0, 1], "wo": [0, 0, 1]}"#,
            "mueller: the model must consist of facets with a Fresnel term that knows amplitudes",
        ),
        (
            r#"{"surface": {"interface": {"to": 1.5}}, "cos": 0}"#,
            "cos must be above 0 and at most 1",
        ),
        (
            r#"{"surface": {"interface": {"to": 0}}, "cos": 1}"#,
            "surface: interface: to must be between",
        ),
        (
            r#"{"surface": {"interface": {"to": "Au"}}, "cos": 1}"#,
            "surface: an index is n, [n, k], {\"eta\": n, \"k\": k}, {\"material\": \"Au\"} or \
             {\"samples\": [[nm, n, k], …]}",
        ),
        (
            r#"{"surface": {"interface": {"to": {"material": "Xx"}}}, "cos": 1}"#,
            "surface: interface.to.material: no material is called",
        ),
        (
            r#"{"surface": {"plates": {"index": 1.5, "count": 0}}, "cos": 1}"#,
            "surface: plates: count must be between 1 and",
        ),
        (
            r#"{"surface": {"interface": {"to": 1.5}}, "cos": 1, "wavelength": 0}"#,
            "wavelength must be between 1 and 1e9, not 0",
        ),
        (r#"{"optics": {"lens": 1}}"#, "optics: unknown variant `lens`"),
        (
            r#"{"optics": {"rotation": 1}, "stokes": [1, 1, 1, 0]}"#,
            "stokes must have an I of at least",
        ),
        (r#"{"optics": {"rotation": 1}, "cos": 1}"#, "a question has the keys"),
    ] {
        let error = error(question);
        assert!(error.starts_with(message), "{question}: {error}");
    }
    // One thing at a time.
    for question in [
        r#"{"brdf": {"lambert": {"albedo": 1}}, "wo": [0,0,1], "wi": [0,0,1], "u": [0,0]}"#,
        r#"{"brdf": {"lambert": {"albedo": 1}}, "wo": [0,0,1], "cos": 1}"#,
        r#"{"brdf": {"lambert": {"albedo": 1}}, "wi": [0,0,1]}"#,
        r#"{"fresnel": {"constant": 1}, "cos": 1, "h": [0,0,1]}"#,
        r#"{"distribution": {"ggx": {"roughness": 1}}}"#,
        r#"{"bsdf": {"lambert": {"albedo": 1}}, "wo": [0,0,1], "mode": "radiance"}"#,
    ] {
        assert!(error(question).starts_with("a question has the keys"), "{question}");
    }
}

/// A line that fails answers with an error in its place, and the run goes on.
#[test]
fn a_run_goes_on_after_an_error() {
    let fresnel = r#"{"fresnel": {"constant": 0.5}, "cos": 1}"#;
    let long = "x".repeat(MAX_LINE + 1);
    let longest = format!("{fresnel}{}", " ".repeat(MAX_LINE - fresnel.len()));
    let questions = format!(
        "{fresnel}\nnonsense\n\n{fresnel}\r\n{long}\n  \n{longest}\n{long}{long}\n{fresnel}"
    );
    let (answers, tally) = ask_all(questions.as_bytes(), Precision::Double);
    let right: Vec<bool> = answers.iter().map(|answer| answer.get("error").is_none()).collect();
    assert_eq!(right, [true, false, true, false, true, false, true]);
    assert_eq!(tally, Tally { questions: 7, failed: 3 });
    assert_eq!(answers[3]["error"], "a line may have at most 1048576 bytes");
    let numbers: Vec<_> = answers.iter().filter_map(|answer| answer["line"].as_u64()).collect();
    assert_eq!(numbers, [2, 5, 8], "lines are counted with the blank ones");
    let (answers, tally) = ask_all(b"\xff\xfe\n", Precision::Single);
    assert!(answers[0]["error"].is_string());
    assert_eq!(tally, Tally { questions: 1, failed: 1 });
}

/// A mark in front of the text is no part of it; anywhere else it is.
#[test]
fn a_byte_order_mark_is_skipped() {
    let fresnel = r#"{"fresnel": {"constant": 0.5}, "cos": 1}"#;
    let text = format!("\u{feff}{fresnel}\n\u{feff}{fresnel}\n{fresnel}");
    let (answers, tally) = ask_all(text.as_bytes(), Precision::Double);
    assert_eq!(tally, Tally { questions: 3, failed: 1 });
    assert!(answers[1]["error"].is_string() && answers[1]["line"] == 2, "{answers:?}");
}

/// Single and double precision agree on what is a unit vector, to the last bit of its length.
#[test]
fn both_numbers_take_the_same_directions() {
    let (mut taken, mut refused) = (0, 0);
    for (length, steps) in [(1.01_f64, -60..60), (0.99, -60..60)] {
        for step in steps {
            let z = (length + f64::from(step) * 4e-9).sqrt();
            let question = format!(
                r#"{{"brdf": {{"lambert": {{"albedo": 0.5}}}}, "wi": [0,0,{z}], "wo": [0,0,1]}}"#
            );
            let of = |precision| ask_all(question.as_bytes(), precision).0.remove(0);
            let (single, double) = (of(Precision::Single), of(Precision::Double));
            assert_eq!(single.get("error"), double.get("error"), "{question}");
            if single.get("error").is_none() {
                taken += 1;
                for answer in [single, double] {
                    assert!(numbers(&answer)[1] > 0.0, "{question}: {answer}");
                }
            } else {
                refused += 1;
            }
        }
    }
    assert!(taken > 50 && refused > 50, "{taken} {refused}");
}

/// Runs the command and gives its exit status, its answers and its complaints.
fn command_line(words: &[&str], input: impl std::io::Read) -> (u8, String, String) {
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams {
        input,
        output: &mut output,
        errors: &mut errors,
        progress: ProgressDrawTarget::hidden(),
    };
    let status = command::run(words.iter().map(OsString::from), streams);
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (status, text(output), text(errors))
}

#[test]
fn the_exit_status_tells_whether_every_question_has_an_answer() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/evaluate/questions.jsonl");
    let (status, from_file, errors) = command_line(&[file], std::io::empty());
    assert_eq!((status, errors.as_str()), (0, ""));
    assert_eq!(from_file.lines().count(), QUESTIONS.lines().count());
    for words in [&[][..], &["-"], &["--f64", "-"]] {
        assert_eq!(
            command_line(words, QUESTIONS.as_bytes()),
            (0, from_file.clone(), String::new())
        );
    }
    let (status, single, _) = command_line(&["--f32"], QUESTIONS.as_bytes());
    assert!(status == 0 && single != from_file);

    // One mistake in the middle: the others keep their answers and their order.
    let lines: Vec<&str> = QUESTIONS.lines().collect();
    let (before, after) = lines.split_at(lines.len() / 2);
    let mixed = [before, &["{}"], after].concat().join("\n");
    let (status, answers, errors) = command_line(&[], mixed.as_bytes());
    assert_eq!(status, 1);
    assert_eq!(errors, format!("1 of {} questions have no answer\n", lines.len() + 1));
    let (wrong, right): (Vec<_>, Vec<_>) =
        answers.lines().enumerate().partition(|(index, _)| *index == before.len());
    assert!(wrong[0].1.starts_with(r#"{"error":"#));
    assert!(right.into_iter().map(|(_, answer)| answer).eq(from_file.lines()));
}

#[test]
fn the_exit_status_tells_whether_the_command_can_run() {
    assert_eq!(command_line(&["--help"], std::io::empty()).0, 0);
    for words in [&["--f16"][..], &["a", "b"], &["no such file"]] {
        let (status, answers, errors) = command_line(words, std::io::empty());
        assert_eq!((status, answers.as_str()), (2, ""));
        assert!(!errors.is_empty());
    }
    struct Broken;
    impl std::io::Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("the line is dead"))
        }
    }
    assert_eq!(command_line(&[], Broken), (2, String::new(), "the line is dead\n".into()));
}

/// Depth that would overflow the stack of a reader without bounds.
#[test]
fn deep_questions_are_errors() {
    for open in [r#"{"sum":[{"weight":1,"brdf":"#, "[", r#"{"a":"#, r#"{"brdf":"#] {
        let deep = open.repeat(20_000);
        error(&deep);
        error(&format!(r#"{{"wo": [0,0,1], "brdf": {deep}}}"#));
    }
}

/// A question and what was changed in it.
fn damaged() -> impl Strategy<Value = Vec<u8>> {
    let lines: Vec<&'static str> = QUESTIONS.lines().collect();
    let line = proptest::sample::select(lines);
    let bytes = proptest::collection::vec(any::<u8>(), 0..6);
    let tokens = proptest::sample::select(vec![
        "",
        "-1",
        "1e999",
        "1e308",
        "1e-320",
        "NaN",
        "null",
        "true",
        "{}",
        "[]",
        "\"\"",
        "\"Au\"",
        ",",
        ":",
        "}",
        "]",
        "\\u0000",
        "0",
        "2",
        "[0,0,1]",
        "{\"ggx\":{\"roughness\":1e-8}}",
    ]);
    let insert = prop_oneof![bytes, tokens.prop_map(|token| token.as_bytes().to_vec())];
    (line, any::<proptest::sample::Index>(), 0..12_usize, insert).prop_map(
        |(line, at, removed, insert)| {
            let at = at.index(line.len());
            let end = (at + removed).min(line.len());
            let mut bytes = line.as_bytes().to_vec();
            bytes.splice(at..end, insert);
            bytes
        },
    )
}

/// Lines that are no question.
fn nonsense() -> impl Strategy<Value = Vec<u8>> {
    let json = any::<String>().prop_map(|text| serde_json::json!([text]).to_string());
    let words = proptest::collection::vec(
        proptest::sample::select(vec![
            "{", "}", "[", "]", ":", ",", "\"brdf\"", "\"sum\"", "\"wo\"", "1", "-", "e9", "null",
        ]),
        0..40,
    );
    prop_oneof![
        proptest::collection::vec(any::<u8>(), 0..200),
        any::<String>().prop_map(String::into_bytes),
        json.prop_map(String::into_bytes),
        words.prop_map(|words| words.concat().into_bytes()),
    ]
}

fn run<S: Strategy<Value = Vec<u8>>>(
    cases: u32,
    strategy: S,
    check: impl Fn(&Value) -> bool,
) -> u64 {
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    let failures = std::cell::Cell::new(0);
    let result = TestRunner::new(config).run(&strategy, |question| {
        for precision in [Precision::Single, Precision::Double] {
            let (answers, tally) = ask_all(&question, precision);
            prop_assert_eq!(answers.len() as u64, tally.questions);
            for answer in answers {
                prop_assert!(check(&answer), "{}", answer);
            }
            failures.set(failures.get() + tally.failed);
        }
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    failures.get()
}

#[test]
fn nonsense_has_no_answer() {
    let is_error = |answer: &Value| {
        answer["error"].is_string() && answer.as_object().is_some_and(|keys| keys.len() == 2)
    };
    // Each in both numbers; some are blank.
    assert!(run(10_000, nonsense(), is_error) > 15_000);
}

/// A changed question may still be one: then its answer is made of finite numbers.
#[test]
fn damaged_questions_have_an_error_or_a_finite_answer() {
    let fine = |answer: &Value| {
        answer["error"].is_string() || numbers(answer).iter().all(|number| number.is_finite())
    };
    assert!(run(10_000, damaged(), fine) > 10_000);
}
