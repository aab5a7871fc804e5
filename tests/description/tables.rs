//! What holds for every form and every parameter of the tables.

use std::fmt::Debug;

use brdf::description::{
    BrdfDescription, BsdfDescription, Content, DistributionDescription, Form, FresnelDescription,
    forms,
};
use brdf::parameter::{Kind, Parameter, Part, Preset};
use proptest::prelude::*;
use proptest::strategy::Union;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

/// Reads a description of a part, writes it and builds it.
fn attempt(part: Part, text: &str) -> Result<Value, String> {
    fn read<V: DeserializeOwned + Serialize + Debug + PartialEq, M, E: Debug>(
        text: &str,
        build: impl Fn(&V) -> Result<M, E>,
    ) -> Result<Value, String> {
        let described: V = serde_json::from_str(text).map_err(|error| error.to_string())?;
        build(&described).unwrap_or_else(|error| panic!("{text}: {error:?}"));
        let written = serde_json::to_string(&described).expect("JSON");
        let again: V = serde_json::from_str(&written).expect(&written);
        assert_eq!(again, described, "{text}");
        Ok(serde_json::from_str(&written).expect("JSON"))
    }
    match part {
        Part::Brdf => read(text, BrdfDescription::build::<f64>),
        Part::Bsdf => read(text, BsdfDescription::build::<f64>),
        Part::Fresnel => read(text, FresnelDescription::build::<f64>),
        Part::Distribution => read(text, DistributionDescription::build::<f64>),
        other => panic!("{other:?} has no description"),
    }
}

fn parameters(form: &Form) -> &'static [Parameter] {
    match form.content() {
        Content::Keys(parameters) | Content::Terms(parameters) => parameters,
        Content::Value(parameter) => std::slice::from_ref(parameter),
        other => panic!("{other:?} is new"),
    }
}

/// A value of a parameter that is allowed. The form taken of a part has no parts; of distributions it is
/// one that every model takes, Beckmann's.
fn example(parameter: &Parameter) -> Value {
    let range = |index| parameter.kind.range(index).expect("a number");
    let inside = |index| {
        (range(index).lower * 0.5 + range(index).upper * 0.5).min(0.75).max(range(index).lower)
    };
    match parameter.kind {
        Kind::Part(part) => {
            let of_part = |(other, form): &(Part, &Form)| {
                *other == part && (part != Part::Distribution || form.name() == "beckmann")
            };
            let (_, form) = forms().find(of_part).expect("a form");
            whole(form, values(form))
        }
        Kind::List(parameters) => {
            let keys = parameters.iter().map(|it| (it.name.to_owned(), example(it)));
            json!([Value::Object(keys.collect())])
        }
        Kind::Vector(_) => json!([inside(0), inside(0), inside(0)]),
        Kind::Flag => json!(true),
        Kind::Word(words) => json!(words[0]),
        Kind::Text | Kind::Metal => json!("Au"),
        _ => json!(inside(0)),
    }
}

/// A list of numbers, one for each that the parameter may have; none where it has one only.
fn list(parameter: &Parameter) -> Option<Value> {
    let most = parameter.kind.most();
    (most > 1).then(|| json!(vec![example(parameter); most]))
}

fn values(form: &Form) -> Vec<Value> {
    parameters(form).iter().map(example).collect()
}

/// A form with given values.
fn whole(form: &Form, values: Vec<Value>) -> Value {
    let keys = parameters(form).iter().map(|parameter| parameter.name.to_owned());
    let object = || Value::Object(keys.zip(values.clone()).collect::<Map<_, _>>());
    let content = match form.content() {
        Content::Keys(_) => object(),
        Content::Terms(_) => json!([object()]),
        _ => values[0].clone(),
    };
    json!({ form.name(): content })
}

/// The place of a parameter, as errors write it.
fn place(form: &Form, parameter: &Parameter) -> String {
    match form.content() {
        Content::Keys(_) => format!("{}.{}", form.name(), parameter.name),
        Content::Terms(_) => format!("{}[0].{}", form.name(), parameter.name),
        _ => form.name().to_owned(),
    }
}

/// Every form with every parameter.
fn each(mut check: impl FnMut(Part, &Form, usize, &'static Parameter)) -> usize {
    let mut count = 0;
    for (part, form) in forms() {
        for (index, parameter) in parameters(form).iter().enumerate() {
            check(part, form, index, parameter);
            count += 1;
        }
    }
    count
}

/// With one value changed.
fn changed(form: &Form, index: usize, value: Value) -> String {
    let mut values = values(form);
    values[index] = value;
    whole(form, values).to_string()
}

#[test]
fn every_form_can_be_read_written_and_built() {
    for (part, form) in forms() {
        let text = whole(form, values(form)).to_string();
        assert_eq!(
            attempt(part, &text).expect(&text),
            serde_json::from_str::<Value>(&text).unwrap()
        );
    }
    let lists = each(|part, form, index, parameter| {
        if let Some(list) = list(parameter) {
            let text = changed(form, index, list);
            attempt(part, &text).expect(&text);
        }
    });
    assert!(lists > 40, "{lists}");
}

#[test]
fn every_number_has_its_range() {
    let mut refused = 0;
    each(|part, form, index, parameter| {
        let place = place(form, parameter);
        let mut refuse = |value: Value, place: &str, wrong: f64, range: brdf::Range| {
            let text = changed(form, index, value);
            let error = attempt(part, &text).expect_err(&text);
            assert!(error.starts_with(&format!("{place} must be between ")), "{text}: {error}");
            // Numbers are shown with an exponent or without.
            for number in [range.lower, range.upper, wrong] {
                let shown = [format!("{number}"), format!("{number:e}")];
                assert!(shown.iter().any(|shown| error.contains(shown)), "{text}: {error}");
            }
            refused += 1;
        };
        for at in 0..parameter.kind.most() {
            let range = parameter.kind.range(at).expect("a number");
            for wrong in [range.lower.next_down(), range.upper.next_up(), -1e300, 1e300] {
                if at == 0 {
                    refuse(json!(wrong), &place, wrong, range);
                }
                if let Some(mut list) = list(parameter) {
                    list[at] = json!(wrong);
                    refuse(list, &format!("{place}[{at}]"), wrong, range);
                }
            }
        }
        // The ends are in the range, but a sum of weights may not be 0.
        for end in parameter.kind.range(0).into_iter().flat_map(|range| [range.lower, range.upper])
        {
            if parameter.name != "weight" || end != 0.0 {
                let text = changed(form, index, json!(end));
                attempt(part, &text).expect(&text);
            }
        }
    });
    assert!(refused > 300, "{refused}");
}

/// Samples that are none, and a material that is not known.
fn refuse_samples(refuse: &impl Fn(Value, &str)) {
    let nothing = ".samples: number of samples must be at least 2, not 0";
    refuse(json!({"samples": []}), nothing);
    refuse(
        json!({"samples": 1}),
        ".samples: invalid type: integer `1`, expected a list of samples",
    );
    for (second, message) in [
        (json!(500), "[1]: invalid type: integer `500`, expected a"),
        (json!([500, 1.5]), "[1]: invalid length 2, expected a"),
        (json!([500, 1.5, 0, 0]), "[1]: invalid length, more than 3, expected a"),
        (json!([500, 1.5, -1]), "[1][2] must be between 0 and 10000, not -1"),
        (json!([500, 0, 0]), "[1][1] must be between 0.0001 and 10000, not 0"),
        (json!([400, 1.5, 0]), "[1][0] must be above 400, the one before it, not 400"),
    ] {
        refuse(json!({"samples": [[400, 1.5, 0], second]}), &format!(".samples{message}"));
    }
    refuse(json!({"material": "Xx"}), ".material: no material is called \"Xx\"");
    let short = json!({"samples": [[600, 1.5, 0], [700, 1.5, 0]]});
    refuse(short, ".samples: wavelength must be between 600 and 700, not ");
    let both = json!({"material": "BK7", "samples": [[400, 1.5, 0], [700, 1.5, 0]]});
    refuse(both, ".samples: `material` and `samples` exclude each other");
}

#[test]
fn every_value_has_its_type() {
    each(|part, form, index, parameter| {
        let place = place(form, parameter);
        let refuse = |value: Value, message: &str| {
            let text = changed(form, index, value);
            let error = attempt(part, &text).expect_err(&text);
            assert!(error.starts_with(&format!("{place}{message}")), "{text}: {error}");
        };
        match parameter.kind {
            Kind::Number(_) => {
                refuse(json!("red"), ": invalid type: string \"red\", expected a number at");
                refuse(json!([1]), ": invalid type: sequence, expected a number at");
            }
            Kind::Vector(_) => {
                refuse(json!(-1), ": invalid type: integer `-1`, expected a list of 3 numbers at");
                refuse(json!([1, 1]), ": invalid length 2, expected a list of 3 numbers at");
            }
            Kind::Color(_) | Kind::Roughness(_) | Kind::Index(..) => {
                let most = parameter.kind.most();
                let expected = format!("expected a number or a list of {most} numbers at");
                refuse(json!(null), &format!(": invalid type: null, {expected}"));
                refuse(json!(true), &format!(": invalid type: boolean `true`, {expected}"));
                let Some(Value::Array(mut list)) = list(parameter) else { unreachable!() };
                list.push(list[0].clone());
                refuse(json!(list), &format!(": invalid length, more than {most}, {expected}"));
                list.truncate(most - 1);
                refuse(json!(list), &format!(": invalid length {}, {expected}", most - 1));
                list.push(json!("red"));
                let message = ": invalid type: string \"red\", expected a number at";
                refuse(json!(list), &format!("[{}]{message}", most - 1));
            }
            Kind::Medium(..) => {
                let expected = "expected a number, a list of 2 numbers, or an object with the keys \
                                `eta` and `k` or with the key `material` or `samples` at";
                refuse(json!(null), &format!(": invalid type: null, {expected}"));
                refuse(json!("Au"), &format!(": invalid type: string \"Au\", {expected}"));
                refuse(
                    json!([1]),
                    ": invalid length 1, expected a number or a list of 2 numbers at",
                );
                refuse(json!([1, 1, 1]), ": invalid length, more than 2, expected a number or a");
                refuse(
                    json!([1, "red"]),
                    "[1]: invalid type: string \"red\", expected a number at",
                );
                refuse(json!({}), ".material: this key is missing");
                refuse(json!({"eta": 1}), ".k: this key is missing");
                refuse(json!({"k": 1}), ".eta: this key is missing");
                refuse(json!({"eta": 1, "k": [0, 0, -1]}), ".k[2] must be between 0 and 10000");
                refuse(
                    json!({"n": 1}),
                    ".n: unknown name, expected one of `eta`, `k`, `material`, ",
                );
                let both = json!({"eta": 1, "k": 0, "material": "Au"});
                refuse(both, ".material: `eta` and `material` exclude each other");
                // Its index is the same at all wavelengths, and no material is.
                if form.name() != "belcour_barla" {
                    refuse_samples(&refuse);
                }
            }
            Kind::RealIndex(_, most) | Kind::RelativeIndex(_, most) => {
                let expected = match most {
                    1 => "expected a number or an object with the key `material` or `samples` at",
                    _ => {
                        "expected a number, a list of 3 numbers, or an object with the key `material` or \
                         `samples` at"
                    }
                };
                refuse(json!("BK7"), &format!(": invalid type: string \"BK7\", {expected}"));
                refuse(
                    json!([1]),
                    match most {
                        1 => ": invalid type: sequence, expected a number or an object",
                        _ => ": invalid length 1, expected a number or a list of 3 numbers at",
                    },
                );
                refuse(
                    json!({"eta": 1}),
                    ".eta: unknown name, expected one of `material`, `samples`",
                );
                refuse(json!({"material": "Au"}), ".material: k must be between 0 and 0.001, not ");
                refuse_samples(&refuse);
            }
            Kind::Metal => {
                let expected =
                    "expected a text or an object with the key `material` or `samples` at";
                refuse(json!(0), &format!(": invalid type: integer `0`, {expected}"));
                refuse(json!([1]), &format!(": invalid type: sequence, {expected}"));
                refuse(json!({"outside": 1}), ".material: this key is missing");
                let air = json!({"material": "Au", "outside": 0});
                refuse(air, ".outside must be between 0.0001 and 10000, not 0");
                refuse_samples(&refuse);
            }
            Kind::List(parameters) => {
                let name = parameter.name;
                let list = format!(": invalid type: integer `0`, expected a list of {name} at");
                refuse(json!(0), &list);
                refuse(
                    json!([0]),
                    "[0]: invalid type: integer `0`, expected an object with the keys",
                );
                let keys = parameters.iter().map(|it| (it.name.to_owned(), example(it)));
                let term = Value::Object(keys.collect());
                let (least, most) = match (form.name(), name) {
                    ("schlick_1994", _) => (1, 2),
                    _ => (0, 64),
                };
                let many = json!(vec![term; most + 1]);
                let count = format!("between {least} and {most}, not {}", most + 1);
                refuse(many, &format!(": number of {name} must be {count}"));
                if form.name() == "stack" {
                    refuse(json!([{"index": 1}]), "[0].thickness: this key is missing");
                    let thick =
                        json!([{"index": 1, "thickness": 1}, {"index": 1, "thickness": -1}]);
                    refuse(thick, "[1].thickness must be between 0 and 1e9, not -1");
                }
            }
            Kind::Flag => refuse(json!(0), ": invalid type: integer `0`, expected a boolean at"),
            Kind::Text => refuse(json!(0), ": invalid type: integer `0`, expected a text at"),
            Kind::Word(words) => {
                refuse(json!("?"), ": unknown name \"?\", expected one of `");
                let texts = words.join("\" \"");
                refuse(json!(0), &format!(": expected a text, one of \"{texts}\""));
            }
            Kind::Part(_) => {
                refuse(json!({"?": 0}), ".?: unknown name, expected one of `");
                refuse(json!(null), ": expected a ");
            }
            other => panic!("{other:?} is new"),
        }
    });
}

#[test]
fn every_key_is_given_once_or_has_its_default() {
    let mut defaults = 0;
    each(|part, form, index, parameter| {
        if let Content::Value(_) = form.content() {
            return;
        }
        let (all, place) = (whole(form, values(form)), place(form, parameter));
        let pointer = match form.content() {
            Content::Terms(_) => format!("/{}/0", form.name()),
            _ => format!("/{}", form.name()),
        };
        let object = |text: &mut Value, change: &dyn Fn(&mut Map<String, Value>)| {
            change(text.pointer_mut(&pointer).and_then(Value::as_object_mut).expect("an object"));
            text.to_string()
        };
        let without = object(&mut all.clone(), &|keys| drop(keys.remove(parameter.name)));
        match parameter.default {
            None => {
                let error = attempt(part, &without).expect_err(&without);
                assert!(error.starts_with(&format!("{place}: this key is missing")), "{error}");
            }
            Some(default) => {
                let value = match default {
                    Preset::Number(number) => json!(number),
                    Preset::Color(numbers) => json!(numbers),
                    Preset::Flag(flag) => json!(flag),
                    Preset::Word(word) => json!(word),
                    // The distribution of the example is Beckmann's.
                    Preset::Shadowing => json!("smith"),
                    Preset::White => json!({"constant": 1.0}),
                    other => panic!("{other:?} is new"),
                };
                assert_eq!(attempt(part, &without), attempt(part, &changed(form, index, value)));
                defaults += 1;
            }
        }
        let surplus = object(&mut all.clone(), &|keys| drop(keys.insert("?".into(), json!(0))));
        let error = attempt(part, &surplus).expect_err(&surplus);
        let object_place = place.strip_suffix(&format!(".{}", parameter.name)).expect("a key");
        assert!(
            error.starts_with(&format!("{object_place}.?: unknown name, expected ")),
            "{error}"
        );

        let pair = format!("{}:{},", json!(parameter.name), example(parameter));
        let text = all.to_string();
        let start = text.find(&pair[..pair.len() - 1]).expect(&text);
        let twice = format!("{}{pair}{}", &text[..start], &text[start..]);
        let error = attempt(part, &twice).expect_err(&twice);
        assert!(error.starts_with(&format!("{place}: this key is given twice")), "{error}");
    });
    assert!(defaults > 6, "{defaults}");
}

/// A value of a parameter, whose parts are at most `depth` deep.
fn any_value(parameter: &'static Parameter, depth: u32) -> BoxedStrategy<Value> {
    // Sums of weights are never 0.
    let lower = |lower: f64| if parameter.name == "weight" { 0.1 } else { lower };
    let number = |index| {
        let range = parameter.kind.range(index).expect("a number");
        (lower(range.lower)..=range.upper).prop_map(|number| json!(number))
    };
    match parameter.kind {
        Kind::Part(part) => any_form(part, depth),
        Kind::List(parameters) => {
            let keys = parameters
                .iter()
                .map(|it| any_value(it, depth).prop_map(|value| (it.name.to_owned(), value)));
            let object =
                keys.collect::<Vec<_>>().prop_map(|keys| Value::Object(keys.into_iter().collect()));
            let least = usize::from(parameters.iter().any(|it| it.name == "isotropy"));
            proptest::collection::vec(object, least..3).prop_map(Value::from).boxed()
        }
        Kind::Flag => any::<bool>().prop_map(Value::from).boxed(),
        Kind::Text | Kind::Metal => {
            proptest::sample::select(vec!["Au", "copper"]).prop_map(Value::from).boxed()
        }
        // Smith's shadowing is not known for every distribution.
        Kind::Word(words) if parameter.name == "shadowing" => Just(json!(words[0])).boxed(),
        Kind::Word(words) => proptest::sample::select(words).prop_map(Value::from).boxed(),
        _ => {
            let all: Vec<_> = (0..parameter.kind.most()).map(number).collect();
            match parameter.kind {
                Kind::Vector(_) => all.prop_map(Value::from).boxed(),
                _ if all.len() == 1 => number(0).boxed(),
                _ => prop_oneof![number(0), all.prop_map(Value::from)].boxed(),
            }
        }
    }
}

fn any_form(part: Part, depth: u32) -> BoxedStrategy<Value> {
    let has_parts = |form: &Form| {
        parameters(form).iter().any(|parameter| matches!(parameter.kind, Kind::Part(_)))
    };
    let forms = forms().filter(|(other, form)| *other == part && (depth > 0 || !has_parts(form)));
    Union::new(forms.map(|(_, form)| {
        let values = parameters(form).iter().map(|it| any_value(it, depth.saturating_sub(1)));
        values.collect::<Vec<_>>().prop_map(|values| whole(form, values))
    }))
    .boxed()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// To the last bit of every number, with defaults written out.
    #[test]
    fn any_description_goes_round(model in any_form(Part::Brdf, 3)) {
        let text = model.to_string();
        crate::forms::goes_round::<BrdfDescription>(&text);
        prop_assert_eq!(attempt(Part::Brdf, &text).expect(&text), all_real(model));
    }
}

/// With all numbers as the writer writes them.
fn all_real(value: Value) -> Value {
    match value {
        Value::Number(number) => json!(number.as_f64().expect("a number of JSON")),
        Value::Array(list) => list.into_iter().map(all_real).collect(),
        Value::Object(keys) => keys
            .into_iter()
            .map(|(key, value)| (key, all_real(value)))
            .collect::<Map<_, _>>()
            .into(),
        other => other,
    }
}

/// The documentation of the module shows every form and every key.
#[test]
fn every_form_is_documented() {
    let shown = include_str!("../../src/description/mod.rs");
    each(|_, form, _, parameter| {
        let row = format!("{{\"{}\": ", form.name());
        let at = shown.find(&row).unwrap_or_else(|| panic!("{} is not shown", form.name()));
        let row = shown[at..].lines().next().expect("a line");
        let keyed = !matches!(form.content(), Content::Value(_));
        let key = format!("\"{}\": ", parameter.name);
        assert!(!keyed || row.contains(&key), "{row} does not show {}", parameter.name);
    });
}
