//! Models over the whole sphere with any parameters; what is accepted answers soundly on both sides for any
//! directions and uniform numbers, and importance is radiance with the directions exchanged, to the last bit.
#![no_main]

use arbitrary::Arbitrary;
use brdf::Real;
use brdf_fuzz::geometry::Directions;
use brdf_fuzz::models::Interface;
use brdf_fuzz::numbers::Number;
use brdf_fuzz::sound::unsound;
use libfuzzer_sys::{Corpus, fuzz_target};

#[derive(Arbitrary, Debug)]
struct Input {
    model: Interface,
    double: bool,
    directions: [Directions; 2],
    u: [Number; 3],
}

fuzz_target!(|input: Input| -> Corpus {
    if input.double { check::<f64>(&input) } else { check::<f32>(&input) }
});

fn check<T: Real<Mask = bool> + Into<f64> + PartialEq>(input: &Input) -> Corpus {
    let Some(description) = input.model.read() else { return Corpus::Reject };
    // A value may leave its range where it is rounded to f32.
    let Ok(model) = description.build::<T>() else { return Corpus::Reject };
    for Directions(pair) in input.directions {
        assert_eq!(unsound(&model, pair, input.u.map(|Number(u)| u)), None);
    }
    Corpus::Keep
}
