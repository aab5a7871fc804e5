//! Deep and long descriptions: an error, in every format, and on a small stack.

use brdf::Fresnel;
use brdf::description::{
    BrdfDescription, DistributionDescription, FresnelDescription, MAX_DEPTH, MAX_TERMS,
};

/// Sums in sums, `depth` of them.
fn nested_sums(depth: usize) -> String {
    let lambert = r#"{"lambert":{"albedo":0.5}}"#;
    let open = r#"{"sum":[{"weight":1,"brdf":"#.repeat(depth);
    format!("{open}{lambert}{}", "}]}".repeat(depth))
}

fn nested_mixtures(depth: usize) -> String {
    let ggx = r#"{"ggx":{"roughness":0.5}}"#;
    let open = r#"{"mixture":[{"weight":1,"distribution":"#.repeat(depth);
    format!("{open}{ggx}{}", "}]}".repeat(depth))
}

/// Without the limit that serde_json has of its own.
fn read<V: serde::de::DeserializeOwned>(text: &str) -> Result<V, serde_json::Error> {
    let mut reader = serde_json::Deserializer::from_str(text);
    reader.disable_recursion_limit();
    V::deserialize(&mut reader)
}

/// On a stack of 256 KiB, an eighth of that of a thread.
fn on_a_small_stack(test: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(256 * 1024).spawn(test);
    thread.expect("a thread").join().expect("no panic");
}

#[test]
fn depth_is_bounded() {
    on_a_small_stack(|| {
        let deepest: BrdfDescription = read(&nested_sums(MAX_DEPTH)).expect("deep enough");
        assert!(deepest.build::<f32>().is_ok());
        read::<DistributionDescription>(&nested_mixtures(MAX_DEPTH)).expect("deep enough");
        for depth in [MAX_DEPTH + 1, 1_000, 100_000] {
            let error = read::<BrdfDescription>(&nested_sums(depth)).expect_err("too deep");
            let error = error.to_string();
            assert!(error.starts_with("sum[0].brdf.sum[0]."), "{error}");
            assert!(
                error.contains(
                    "at most 32 sums and mixtures may stand inside each other, and here is one of \
                     depth 33"
                ),
                "{error}"
            );
            let error = read::<DistributionDescription>(&nested_mixtures(depth));
            assert!(error.expect_err("too deep").to_string().contains("at most 32 sums"));
        }
    });
}

#[test]
fn depth_is_bounded_in_cbor() {
    // An array of one map of two texts, again and again.
    let mut deep = Vec::new();
    for _ in 0..200 {
        deep.extend(b"\xa1\x63sum\x81\xa2\x66weight\x01\x64brdf");
    }
    let error = ciborium::from_reader::<BrdfDescription, _>(&*deep).expect_err("too deep");
    assert!(error.to_string().contains("at most 32 sums"), "{error}");
}

#[test]
fn the_number_of_terms_is_bounded() {
    let sum = |terms: usize| {
        let term = r#"{"weight":1,"brdf":{"lambert":{"albedo":0.5}}}"#;
        format!(r#"{{"sum":[{}]}}"#, vec![term; terms].join(","))
    };
    assert!(read::<BrdfDescription>(&sum(MAX_TERMS)).is_ok());
    let error = read::<BrdfDescription>(&sum(MAX_TERMS + 1)).expect_err("too long").to_string();
    assert!(
        error.starts_with(
            "sum: sums and mixtures may have at most 1024 terms altogether, and here is one of \
             number 1025"
        ),
        "{error}"
    );

    // The bound is on all lists together.
    let half = sum(MAX_TERMS / 2);
    let two = format!(r#"{{"sum":[{{"weight":1,"brdf":{half}}},{{"weight":1,"brdf":{half}}}]}}"#);
    let error = read::<BrdfDescription>(&two).expect_err("too long").to_string();
    assert!(error.contains("at most 1024 terms"), "{error}");
}

/// A length that is announced and not there reserves no memory.
#[test]
fn announced_lengths_are_not_believed() {
    let list = b"\xa1\x63sum\x9b\x7f\xff\xff\xff\xff\xff\xff\xff";
    assert!(ciborium::from_reader::<BrdfDescription, _>(&list[..]).is_err());
    let color = b"\xa1\x67lambert\xa1\x66albedo\x9b\x7f\xff\xff\xff\xff\xff\xff\xff";
    assert!(ciborium::from_reader::<BrdfDescription, _>(&color[..]).is_err());
    let name = b"\xa1\x65metal\x7b\x7f\xff\xff\xff\xff\xff\xff\xff";
    assert!(ciborium::from_reader::<FresnelDescription, _>(&name[..]).is_err());
}

/// Error messages stay short whatever the key.
#[test]
fn long_keys_are_not_repeated() {
    let text = format!(r#"{{"{}": 1}}"#, "k".repeat(1_000_000));
    let error = serde_json::from_str::<BrdfDescription>(&text).expect_err("unknown").to_string();
    // The names of all models, and nothing of the key.
    assert!(error.len() < 600, "{}", error.len());
}

/// Nor whatever the name of a metal.
#[test]
fn long_names_are_not_repeated() {
    let name = "\n".repeat(60) + &"W".repeat(1_000_000);
    let text = serde_json::json!({"metal": name}).to_string();
    let read = serde_json::from_str::<FresnelDescription>(&text).expect_err("unknown").to_string();
    assert_eq!(read, format!("metal: no material is called \"{}…\"", "W".repeat(40)));
}

/// A metal whose name stands between many spaces is found when read, when built and when read again.
#[test]
fn a_name_is_read_as_it_was_written() {
    let spaces = "\n".repeat(60);
    let text = serde_json::json!({"metal": format!("{spaces}W{spaces}")}).to_string();
    let description: FresnelDescription = serde_json::from_str(&text).expect("tungsten");
    let normal = description.build::<f64>().expect("tungsten").reflectance(1.0);
    assert!(normal.x > 0.4 && normal.x < 0.6, "{normal}");
    let written = serde_json::to_string(&description).expect("it can be written");
    assert_eq!(written, text);
    let read: FresnelDescription = serde_json::from_str(&written).expect("it can be read");
    assert_eq!(read, description);
}

/// RON has a bound of its own, which its options lift.
#[test]
fn ron_needs_its_own_bound_lifted() {
    let nested = |depth: usize| {
        let open = "sum([(weight: 1, brdf: ".repeat(depth);
        format!("{open}lambert(albedo: 0.5){}", ")])".repeat(depth))
    };
    ron::from_str::<BrdfDescription>(&nested(20)).expect("within RON's bound");
    let deepest = nested(MAX_DEPTH);
    let error = ron::from_str::<BrdfDescription>(&deepest).expect_err("beyond it").to_string();
    assert!(error.contains("recursion_limit"), "{error}");
    let unbounded = ron::Options::default().without_recursion_limit();
    unbounded.from_str::<BrdfDescription>(&deepest).expect("deep enough");
    let error = unbounded.from_str::<BrdfDescription>(&nested(MAX_DEPTH + 1));
    assert!(error.expect_err("too deep").to_string().contains("at most 32 sums"));
}
