//! What a module refuses, and what it leaves out of a text.

use alloc::string::{String, ToString};
use core::cell::Cell;

use glam::{DVec3, Vec3};

use super::{Binding, Expr, ExprVec3, Module, ShaderError};
use crate::diffuse::{Lambert, OrenNayar};
use crate::distribution::Ggx;
use crate::error::ParameterError;
use crate::real::{Color, Lift, Mask, Real, Vector};

fn white() -> Lambert<ExprVec3> {
    Lambert::new(ExprVec3::splat(Expr::one())).unwrap()
}

/// The text of a function of a direction, without its head and its end.
fn body(formula: impl FnOnce(ExprVec3) -> Expr) -> String {
    let mut module = Module::new();
    module.add_function("tested", ["w"], |(w,): (ExprVec3,)| formula(w)).unwrap();
    let text = module.to_string();
    let (_, body) = text.split_once("fn tested(w: vec3<f32>) -> f32 {\n").unwrap();
    body.trim_end_matches("}\n").replace("    ", "").trim_end().replace('\n', " ")
}

#[test]
fn names_are_those_of_the_language() {
    let none = ["", "1", "_a", "a_", "a__b", "a-b", "ä", "fn", "self", "vec3", "brdf", "BrdfGold"];
    // The text, or the shader around it, may call the function of the language.
    for name in none.into_iter().chain(["max", "floor", "select", "dot", "vec3f", "textureLoad"]) {
        let mut module = Module::new();
        assert_eq!(module.add(name, &white()), Err(ShaderError::Name(name.into())));
        assert!(!module.to_string().contains("fn "));
        let argument = module.add_function("f", [name], |(x,): (Expr,)| x);
        assert_eq!(argument, Err(ShaderError::Name(name.into())));
        let field = module.add_with("a", Binding::default(), |parameters| {
            let _ = parameters.number(name, 1.0);
            Ok::<_, ParameterError>(white())
        });
        assert_eq!(field, Err(ShaderError::Name(name.into())));
    }
    for name in ["a", "Z", "red_clay_2", "eval", "x1"] {
        assert_eq!(Module::new().add(name, &white()), Ok(()));
    }
}

#[test]
fn names_are_taken_once() {
    let taken = |name: &str| Err(ShaderError::Taken(name.into()));
    let mut module = Module::new();
    assert_eq!(module.add("a", &white()), Ok(()));
    assert_eq!(module.add("a", &white()), taken("a_eval"));
    assert_eq!(module.add_function("a_pdf", ["x"], |(x,): (Expr,)| x), taken("a_pdf"));
    assert_eq!(module.add_function("f", ["x", "x"], |(x, _): (Expr, Expr)| x), taken("x"));
    assert_eq!(module.add_albedo("b"), Err(ShaderError::Unknown("b".into())));
    assert_eq!(module.add_albedo("a"), Ok(()));
    assert_eq!(module.add_albedo("a"), taken("a_albedo"));
    let text = module.to_string();
    let twice = module.add_with("b", Binding::default(), |parameters| {
        let _ = (parameters.number("n", 1.0), parameters.number("n", 2.0));
        Ok::<_, ParameterError>(white())
    });
    assert_eq!(twice.map(drop), taken("n"));
    // What is refused leaves nothing behind.
    assert_eq!(module.to_string(), text);
    assert_eq!(module.add("b", &white()), Ok(()));
}

#[test]
fn a_buffer_has_a_place_of_its_own() {
    let add = |module: &mut Module, name: &str, binding| {
        let added = module.add_with(name, binding, |parameters| {
            Lambert::new(parameters.color("albedo", DVec3::splat(0.5)))
        });
        added.map(drop)
    };
    let (first, second) = (Binding::default(), Binding { group: 0, binding: 1 });
    let mut module = Module::new();
    assert_eq!(add(&mut module, "a", first), Ok(()));
    let text = module.to_string();
    assert_eq!(add(&mut module, "b", first), Err(ShaderError::Bound(first)));
    assert_eq!(module.to_string(), text);
    assert_eq!(add(&mut module, "b", second), Ok(()));
    // Without parameters there is no buffer.
    let fixed = module.add_with("c", first, |_| Ok::<_, ParameterError>(white()));
    assert_eq!(fixed.map(drop), Ok(()));
}

#[test]
fn symbols_stay_in_their_function() {
    let kept = Cell::new(Expr::zero());
    let mut module = Module::new();
    module
        .add_function("f", ["x"], |(x,): (Expr,)| {
            kept.set(x);
            x
        })
        .unwrap();
    let stolen = kept.get();
    let result = module.add_function("g", ["x"], |(x,): (Expr,)| x + stolen);
    assert_eq!(result, Err(ShaderError::Foreign("g".into())));
    let message = "\"g\" has a symbol that belongs to another function or thread";
    assert_eq!(result.unwrap_err().to_string(), message);
    let model = Lambert::new(ExprVec3::splat(stolen)).unwrap();
    assert_eq!(module.add("h", &model), Err(ShaderError::Foreign("h".into())));
    // Outside of every function a symbol is harmless.
    let value = Real::outside(stolen.exp(), 0.0, 1.0);
    assert_eq!(value.map(f64::is_nan), Some(true));
    // A module within a function is one of its own.
    let nested = module.add_function("k", ["x"], |(x,): (Expr,)| {
        let y = x + Expr::one();
        Module::new().add("inner", &white()).unwrap();
        y * x
    });
    assert_eq!(nested, Ok(()));
}

#[test]
fn a_long_loop_is_refused() {
    let mut module = Module::new();
    let result = module.add_function("long", ["x"], |(x,): (Expr,)| {
        (0..1_000_000).fold(x, |x, _| (x + Expr::one()).sqrt())
    });
    assert_eq!(
        result.unwrap_err().to_string(),
        "\"long\" must have at most 200000 operations, and has more"
    );
    assert_eq!(module.add("white", &white()), Ok(()));
}

#[test]
fn constants_are_checked_in_single_precision() {
    let error = OrenNayar::new(ExprVec3::from(DVec3::new(0.5, 1.5, 0.2)), Expr::from(0.1));
    assert_eq!(error.unwrap_err().to_string(), "albedo must be between 0 and 1, not 1.5");
    assert!(Ggx::new(Expr::from(f64::NAN)).is_err());
    // The least roughness of f32 is below that of f64.
    assert!(Ggx::new(Expr::from(1e-8_f32)).is_ok());
    let mut module = Module::new();
    let error = module.add_with("a", Binding::default(), |parameters| {
        OrenNayar::new(parameters.color("albedo", DVec3::ONE), Expr::from(-1.0))
    });
    assert!(matches!(error, Err(ShaderError::Parameter(error)) if error.parameter() == "sigma"));
}

/// What a division by 0 or a number from outside brings in is refused, if anything depends on it.
#[test]
fn constants_are_finite() {
    let refused = |result: Result<(), ShaderError>, called: &str| match result {
        Err(ShaderError::NotFinite { name, value }) => {
            name == called && (value.is_nan() || value.abs() > f32::MAX.into())
        }
        _ => false,
    };
    let mut module = Module::new();
    let empty = module.to_string();
    for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let constant = Expr::from(number);
        let formulas: [fn(Expr, Expr) -> Expr; 4] = [
            |_, c| c,
            |x, c| x + c,
            |x, c| (x * x).sqrt().max(x * c),
            |x, c| Expr::select(x.lt(Expr::one()), x, c),
        ];
        for formula in formulas {
            let added = module.add_function("f", ["x"], |(x,): (Expr,)| formula(x, constant));
            assert!(refused(added, "f"), "{number}");
        }
        let channel = |(c,): (ExprVec3,)| c * ExprVec3::from(DVec3::new(1.0, number, 1.0));
        assert!(refused(module.add_function("g", ["c"], channel), "g"), "{number}");
        let unused = Module::new().add_function("f", ["x"], |(x,): (Expr,)| {
            let _ = x + constant;
            Expr::select(Expr::zero().lt(Expr::one()), x, constant)
        });
        assert_eq!(unused, Ok(()));
    }
    // 1e39 is none in single precision, which a buffer holds.
    for number in [f64::NAN, f64::INFINITY, 1e39] {
        let added = module.add_with("clay", Binding::default(), |parameters| {
            OrenNayar::new(
                parameters.color("albedo", DVec3::ONE),
                parameters.number("sigma", number),
            )
        });
        assert!(refused(added.map(drop), "sigma"), "{number}");
        let added = module.add_function_with(
            "f",
            Binding::default(),
            ["x"],
            |parameters, (x,): (Expr,)| {
                let [a, b] = parameters.pair("pair", [1.0, number]);
                Ok::<Expr, ParameterError>(x * a + b)
            },
        );
        assert!(refused(added.map(drop), "pair"), "{number}");
    }
    assert_eq!(module.to_string(), empty);
}

#[test]
fn what_is_known_is_computed() {
    let half = || Expr::from(0.5);
    assert_eq!(body(|w| w.x() * (half().exp() * Expr::zero() + Expr::one())), "return w.x;");
    assert_eq!(body(|w| (w.x() - w.y()) + -(-w.z())), "return w.x - w.y + w.z;");
    assert_eq!(body(|w| w.x() + -w.y()), "return w.x - w.y;");
    assert_eq!(body(|w| Expr::select(half().gt(Expr::one()), w.x(), w.y())), "return w.y;");
    let nested = |w: ExprVec3| {
        let above = w.z().gt(Expr::zero());
        Expr::select(above, Expr::select(above, w.x(), half()), w.y())
    };
    assert_eq!(body(nested), "return select(w.y, w.x, w.z > 0.0);");
    assert_eq!(body(|w| w.x().max(-Expr::max_finite())), "return max(w.x, -BRDF_LARGEST);");
    assert_eq!(body(|_| Expr::from(1e39)), "return BRDF_LARGEST;");
    assert_eq!(body(|w| half() * (w.x() * Expr::from(3.0))), "return w.x * 1.5;");
    assert_eq!(
        body(|w| w.x() * Expr::from(1e-30) * Expr::from(1e-30)),
        "return w.x * 1e-30 * 1e-30;"
    );
    assert_eq!(body(|w| w.x().min(Expr::one()).min(half())), "return min(w.x, 0.5);");
    let unit = |x: Expr| x.clamp(Expr::zero(), Expr::one());
    assert_eq!(body(|w| unit(unit(w.x()))), "return brdf_clamped(w.x, 0.0, 1.0);");
    assert_eq!(body(|w| w.x().powf(Expr::zero())), "return 1.0;");
    let mask = |w: ExprVec3| w.x().lt(half()).and(w.y().le(half()).or(w.z().ge(half())).not());
    let text = body(|w| Expr::select(mask(w), w.x(), w.y()));
    assert_eq!(text, "return select(w.y, w.x, w.x < 0.5 && !(w.y <= 0.5 || w.z >= 0.5));");
}

#[test]
fn what_occurs_twice_is_written_once() {
    let text = body(|w| (w.x() * w.y()).sqrt() + (w.x() * w.y()));
    assert_eq!(text, "let x1 = w.x * w.y; return sqrt(x1) + x1;");
    // Names of arguments are no names of statements.
    let mut module = Module::new();
    let square = |(x,): (Expr,)| (x + Expr::one()).squared();
    module.add_function("square", ["x1"], square).unwrap();
    assert!(module.to_string().contains("let x2 = x1 + 1.0;\n    return x2 * x2;"));
}

/// A compiler would take (x − y) + y for x.
#[test]
fn sums_that_are_taken_back_are_rounded() {
    assert_eq!(body(|w| (w.x() - w.y()) + w.y()), "return brdf_rounded(w.x - w.y) + w.y;");
    assert_eq!(body(|w| w.y() - (w.y() + w.x())), "return w.y - brdf_rounded(w.y + w.x);");
    assert_eq!(body(|w| (w.x() - w.y()) + w.z()), "return w.x - w.y + w.z;");
}

#[test]
fn channels_are_written_over_vectors() {
    let colour = Vec3::new(0.1, 0.2, 0.3);
    let clay = OrenNayar::new(colour, 0.3).unwrap().lift(Expr::from);
    let mut module = Module::new();
    module.add("clay", &clay).unwrap();
    let text = module.to_string();
    assert_eq!(text.matches("vec3(0.1, 0.2, 0.3)").count(), 1, "{text}");
    assert!(text.contains("* vec3(0.03183099, 0.06366198, 0.09549297)"), "{text}");
    // Of equal channels one is enough.
    let mut module = Module::new();
    module.add("grey", &OrenNayar::new(Vec3::splat(0.25), 0.3).unwrap().lift(Expr::from)).unwrap();
    assert!(!module.to_string().contains("vec3(0.25"));
    // Channels that differ in their choices too.
    let formula =
        |(c,): (ExprVec3,)| c.map(|c| Expr::select(c.gt(Expr::from(0.5)), c.ln(), c.squared()));
    let mut module = Module::new();
    module.add_function("f", ["c"], formula).unwrap();
    let text = module.to_string();
    assert!(text.contains("vec3(brdf_ln(c.x), brdf_ln(c.y), brdf_ln(c.z))"), "{text}");
    assert!(text.contains("c > vec3(0.5)"), "{text}");
}
