//! Texts and bytes of unknown origin: reading them never panics, what is read can be built, and
//! what is written is read again. The same for models of the registry with any parameters.
#![no_main]

use arbitrary::{Arbitrary, Unstructured};
use brdf::Real;
use brdf::description::{BrdfDescription, BsdfDescription};
use brdf_fuzz::geometry::Directions;
use brdf_fuzz::models::Model;
use brdf_fuzz::numbers::Number;
use brdf_fuzz::sound::{assert_sound, unsound};
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
struct Made {
    directions: Directions,
    u: [Number; 2],
    model: Model,
}

/// The directions and numbers for descriptions that come as a text.
const GRAZING: Directions = Directions([[-0.6, 0.0, 0.8], [1.0, 0.0, 1e-20]]);

fuzz_target!(|bytes: &[u8]| {
    let Some((&format, rest)) = bytes.split_first() else { return };
    match format % 4 {
        0 => {
            round_trip(serde_json::from_slice(rest).ok(), GRAZING, [0.0, 1.0]);
            over_sphere(serde_json::from_slice(rest).ok());
        }
        1 => round_trip(ron::de::from_bytes(rest).ok(), GRAZING, [0.0, 1.0]),
        2 => round_trip(ciborium::from_reader(rest).ok(), GRAZING, [0.0, 1.0]),
        _ => {
            let Ok(made) = Made::arbitrary_take_rest(Unstructured::new(rest)) else { return };
            round_trip(made.model.read(), made.directions, made.u.map(|Number(u)| u));
        }
    }
});

/// What is read as a model over the whole sphere.
fn over_sphere(description: Option<BsdfDescription>) {
    let Some(description) = description else { return };
    let text = serde_json::to_string(&description).expect("descriptions can be written");
    let again: BsdfDescription = serde_json::from_str(&text).expect("what is written can be read");
    assert_eq!(again, description, "{text}");
    let model = description.build::<f64>().expect("what is read can be built");
    let Directions(pair) = GRAZING;
    for sides in [pair, pair.map(|[x, y, z]| [x, y, -z])] {
        assert_eq!(unsound(&model, sides, [0.0, 1.0, 0.5]), None, "{text}");
    }
}

fn round_trip(description: Option<BrdfDescription>, directions: Directions, u: [f64; 2]) {
    let Some(description) = description else { return };
    let text = serde_json::to_string(&description).expect("descriptions can be written");
    let again: BrdfDescription = serde_json::from_str(&text).expect("what is written can be read");
    assert_eq!(again, description, "{text}");
    let mut bytes = Vec::new();
    ciborium::into_writer(&description, &mut bytes).expect("descriptions can be written");
    let again: BrdfDescription =
        ciborium::from_reader(bytes.as_slice()).expect("what is written can be read");
    assert_eq!(again, description, "{text}");

    check::<f64>(&description, directions, u);
    // A value may leave its range where it is rounded to f32.
    if description.build::<f32>().is_ok() {
        check::<f32>(&description, directions, u);
    }
}

fn check<T: Real<Mask = bool> + Into<f64>>(
    description: &BrdfDescription,
    Directions(pair): Directions,
    u: [f64; 2],
) {
    let model = description.build::<T>().expect("what is read can be built");
    assert_sound("the model", &model, |_, _| f64::INFINITY, pair, u);
}
