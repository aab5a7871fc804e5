//! The text of every model: valid, in other languages too, and not too long.

use brdf::OrenNayar;
use brdf::wgsl::{Binding, Module};
use brdf_checks::models;
use brdf_shaders::recorded::program;
use brdf_shaders::validate::{translate, validate};
use glam::DVec3;

#[path = "../../../../examples/shader.rs"]
mod example;

const PAGE: &str = include_str!("../../../../docs/shaders.md");

/// What no text may contain: names of numbers that are none, and what would be the largest number
/// but lies beyond it.
const WRONG: [&str; 4] = ["NaN", "inf", "3.4028235e38", "3.4028236e38"];

/// Bytes of the functions of a model with constants; a sum or mixture of three has as many for each.
const LONGEST: usize = 33_000;

fn check(name: &str, text: &str) {
    for line in text.lines().filter(|line| !line.starts_with("//")) {
        let wrong = WRONG.into_iter().find(|wrong| line.contains(wrong));
        assert_eq!(wrong, None, "{name}: {line}");
    }
    let shader = program(text).shader();
    let (module, info) = validate(name, &shader);
    let translated = translate(name, &module, &info);
    for text in [translated.glsl, translated.hlsl, translated.msl] {
        assert!(text.contains("model_sample"), "{name}: {text}");
    }
    assert!(translated.spir_v > 1000, "{name}");
}

#[test]
fn every_model_is_a_valid_shader_in_all_languages() {
    for row in models::rows() {
        let mut module = Module::new();
        module.add_described("model", &row.brdf).expect(&row.name);
        module.add_albedo("model").expect(&row.name);
        let text = module.to_string();
        let lines = text.lines().count();
        println!("{:45} {:6} bytes {lines:4} lines", row.name, text.len());
        assert!(text.len() <= LONGEST, "{}: {}", row.name, text.len());
        check(&row.name, &text);
    }
}

#[test]
fn every_model_has_uniform_parameters() {
    for row in models::rows() {
        let mut module = Module::new();
        let binding = Binding { group: 1, binding: 0 };
        let uniforms = module.add_described_with("model", &row.brdf, binding).expect(&row.name);
        module.add_albedo("model").expect(&row.name);
        let text = module.to_string();
        println!(
            "{:45} {:6} bytes {:4} lines, {} fields",
            row.name,
            text.len(),
            text.lines().count(),
            uniforms.fields().len()
        );
        for field in uniforms.fields() {
            let used = text.matches(&format!("model_parameters.{}", field.name)).count();
            assert!(used > 0, "{}: {}", row.name, field.name);
        }
        check(&row.name, &text);
    }
}

/// Several models share the elementary functions.
#[test]
fn all_models_fit_into_one_module() {
    let mut module = Module::new();
    for (index, row) in models::rows().iter().enumerate() {
        module.add_described(&format!("model_{index}"), &row.brdf).expect(&row.name);
    }
    let text = module.to_string();
    assert_eq!(text.matches("fn brdf_exp(").count(), 1);
    assert_eq!(text.matches("struct BrdfSample {").count(), 1);
    validate("all", &text);
}

/// Where naga lays out the fields of a uniform buffer is where the crate packs them.
#[test]
fn fields_lie_where_the_language_puts_them() {
    for row in models::rows() {
        let mut module = Module::new();
        let binding = Binding::default();
        let uniforms = module.add_described_with("model", &row.brdf, binding).expect(&row.name);
        let (parsed, _) = validate(&row.name, &module.to_string());
        let members = parsed.types.iter().find_map(|(_, kind)| match &kind.inner {
            naga::TypeInner::Struct { members, span }
                if kind.name.as_deref() == Some("ModelParameters") =>
            {
                Some((members.clone(), *span as usize))
            }
            _ => None,
        });
        let (members, span) = members.expect("the structure of the parameters");
        assert_eq!(span, uniforms.size(), "{}", row.name);
        let offsets: Vec<_> = members
            .iter()
            .map(|member| (member.name.clone().expect("a name"), member.offset as usize))
            .collect();
        let packed: Vec<_> =
            uniforms.fields().iter().map(|field| (field.name.clone(), field.offset)).collect();
        assert_eq!(offsets, packed, "{}", row.name);
        assert_eq!(uniforms.bytes().len(), span, "{}", row.name);
    }
}

#[test]
fn the_example_prints_a_valid_shader() {
    let text = example::shader().expect("a shader");
    let (module, _) = validate("example", &text);
    assert_eq!(module.entry_points[0].name, "sphere");
}

/// The page shows a function as it is written.
#[test]
fn the_page_shows_what_is_written() {
    let mut module = Module::new();
    let clay = module.add_with("clay", Binding { group: 1, binding: 0 }, |parameters| {
        let albedo = parameters.color("albedo", DVec3::new(0.8, 0.4, 0.3));
        OrenNayar::new(albedo, parameters.number("sigma", 0.3))
    });
    assert_eq!(clay.expect("clay").size(), 16);
    let text = module.to_string();
    let (_, function) = text.split_once("fn clay_eval").expect("the function");
    let (function, _) = function.split_once("\n}\n").expect("its end");
    assert!(PAGE.contains(&format!("fn clay_eval{function}\n}}\n")), "{function}");
}
