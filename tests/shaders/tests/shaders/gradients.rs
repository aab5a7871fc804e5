//! Gradients on a device: numbers with derivatives whose parts are symbols.

use brdf::wgsl::{Binding, Expr, ExprVec3, Module, Parameters};
use brdf::{
    Brdf, Color, Conductor, CookTorrance, Dual, Ggx, ParameterError, Real, SmithCorrelated, Vector,
    Vector3,
};
use brdf_checks::directions::pairs_to_grazing;
use brdf_shaders::device::{Device, Program};
use brdf_shaders::validate::validate;
use glam::{DVec3, Vec3};

const ETA: [f64; 3] = [0.143, 0.374, 1.442];
const K: [f64; 3] = [3.983, 2.386, 1.603];

/// Value of GGX on gold and its derivatives by the roughness and, channel by channel, n and k.
fn gold<T: Real>(
    [roughness, eta, k]: [[T; 3]; 3],
    wi: T::Vec3,
    wo: T::Vec3,
) -> Result<[T::Vec3; 4], ParameterError> {
    let variable = |[x, y, z]: [T; 3], place| {
        let number = |value| Dual::<T, 3>::variable(value, place);
        Vector3 { x: number(x), y: number(y), z: number(z) }
    };
    let metal = Conductor::new(variable(eta, 1), variable(k, 2))?;
    let f = CookTorrance::new(Ggx::new(Dual::variable(roughness[0], 0))?, metal)
        .with_shadowing(SmithCorrelated)
        .eval(Dual::vector(wi), Dual::vector(wo));
    let by = |place: usize| f.lift(move |channel: Dual<T, 3>| channel.derivatives[place]);
    Ok([f.lift(|channel: Dual<T, 3>| channel.value), by(0), by(1), by(2)])
}

#[test]
fn gradients_of_gold_are_those_of_double_precision() {
    let formula = |parameters: &mut Parameters, (wi, wo): (ExprVec3, ExprVec3)| {
        let roughness = [parameters.number("roughness", 0.3); 3];
        let channels = |color: ExprVec3| [color.x(), color.y(), color.z()];
        let eta = channels(parameters.color("eta", ETA.into()));
        let k = channels(parameters.color("k", K.into()));
        gold::<Expr>([roughness, eta, k], wi, wo)
    };
    let mut module = Module::new();
    let binding = Binding { group: 1, binding: 0 };
    let uniforms = module
        .add_function_with("gold_gradient", binding, ["wi", "wo"], formula)
        .expect("a gradient");
    let text = module.to_string();
    println!("{} bytes, {} lines", text.len(), text.lines().count());
    validate("gradient", &text);
    let Some(device) = Device::find() else { return };
    let program = Program {
        text: &text,
        statements: "
    let wi = vec3(given[at], given[at + 1u], given[at + 2u]);
    let wo = vec3(given[at + 3u], given[at + 4u], given[at + 5u]);
    let gradient = gold_gradient(wi, wo);
    for (var i = 0u; i < 12u; i++) {
        answers[to + i] = gradient[i / 3u][i % 3u];
    }",
        inputs: 6,
        outputs: 12,
    };
    let pairs: Vec<(Vec3, Vec3)> = pairs_to_grazing(100_000)
        .into_iter()
        .map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3()))
        .filter(|(wi, wo)| wi.z > 0.0 && wo.z > 0.0)
        .collect();
    let given: Vec<f32> =
        pairs.iter().flat_map(|(wi, wo)| wi.to_array().into_iter().chain(wo.to_array())).collect();
    let bytes = uniforms.bytes();
    let answers = device.compile(&program).run(&given, Some(&bytes));
    // What the buffer holds, in double precision.
    let rounded = |values: [f64; 3]| values.map(|value| f64::from(value as f32));
    let parameters = [rounded([0.3; 3]), rounded(ETA), rounded(K)];
    let mut worst = 0.0_f64;
    for ((wi, wo), got) in pairs.iter().zip(answers.chunks_exact(12)) {
        let want: [DVec3; 4] =
            gold(parameters, wi.as_dvec3(), wo.as_dvec3()).expect("parameters in range");
        let value = want[0];
        for (index, want) in want.into_iter().enumerate() {
            let got = Vec3::from_slice(&got[3 * index..]).as_dvec3();
            assert!(got.is_finite(), "{index} at {wi} {wo}: {got}");
            // A derivative that passes through 0 is a difference of terms as large as the value over
            // its parameter.
            let over = [1.0, parameters[0][0], parameters[1][1], parameters[2][1]][index];
            let scale = want.abs() + value / over;
            worst = worst.max(((got - want).abs() / scale).max_element());
        }
    }
    println!("largest error {worst:e}");
    assert!(worst < 1e-5, "{worst:e}");
}
