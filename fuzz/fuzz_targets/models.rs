//! Models of the registry with any parameters; what is accepted answers soundly for any directions and
//! uniform numbers, is reciprocal to the last bit where it says so, keeps below its largest
//! albedo, and answers the same in lanes.
#![no_main]

use arbitrary::Arbitrary;
use brdf::{Brdf, Lanes, Real, Vector};
use brdf_fuzz::geometry::Directions;
use brdf_fuzz::lanes::assert_lanes_are_scalars;
use brdf_fuzz::models::Model;
use brdf_fuzz::numbers::Number;
use brdf_fuzz::sound::assert_sound;
use libfuzzer_sys::{Corpus, fuzz_target};

#[derive(Arbitrary, Debug)]
struct Input {
    model: Model,
    double: bool,
    directions: [Directions; 2],
    u: [Number; 2],
    albedo: u8,
}

fuzz_target!(|input: Input| -> Corpus {
    if input.double { check::<f64>(&input) } else { check::<f32>(&input) }
});

fn check<T: Real<Mask = bool> + Into<f64> + PartialEq>(input: &Input) -> Corpus {
    let Some(description) = input.model.read() else { return Corpus::Reject };
    let lanes = description.build::<Lanes<T, 2>>();
    // A value may leave its range where it is rounded to f32.
    let Ok(model) = description.build::<T>() else {
        assert!(lanes.is_err(), "lanes accept what a scalar does not");
        return Corpus::Reject;
    };
    let lanes = lanes.expect("lanes do not accept what a scalar does");
    let promise = input.model.promise();
    let u = input.u.map(|Number(u)| u);
    let pairs = input.directions.map(|Directions(pair)| pair);
    for pair in pairs {
        // Colours and lights may be so small that only their rounding is left.
        let largest = |cos_i, cos_o| promise.largest_weight(cos_i, cos_o) + 1e-30;
        assert_sound("the model", &model, largest, pair, u);
        if promise.reciprocal {
            let [wi, wo]: [T::Vec3; 2] =
                pair.map(|[x, y, z]| Vector::new(T::lit(x), T::lit(y), T::lit(z)));
            let (there, back) = (model.eval(wi, wo), model.eval(wo, wi));
            assert!(
                there.x() == back.x() && there.y() == back.y() && there.z() == back.z(),
                "{there:?} against {back:?}"
            );
        }
    }
    assert_lanes_are_scalars(&model, &lanes, pairs, u);
    // An albedo costs as much as a thousand samples.
    if input.albedo == 1 {
        let [x, y, z] = pairs[0][1];
        let albedo = model.albedo(Vector::new(T::lit(x), T::lit(y), T::lit(z)));
        for channel in [albedo.x(), albedo.y(), albedo.z()] {
            let channel: f64 = channel.into();
            let largest = promise.albedo * (1.0 + 1e-4) + 1e-30;
            assert!((0.0..=largest).contains(&channel), "albedo {channel} > {largest}");
        }
    }
    Corpus::Keep
}
