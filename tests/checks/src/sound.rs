//! What must hold of every answer of a model, whatever it is asked.

use brdf::{Brdf, Bsdf, Real, TransportMode, Vector, above_surface};

/// Asserts it for one model, one pair of directions and one pair of uniform numbers, NaN and
/// infinity among them: no answer is NaN, infinite or negative, all are zero where a direction is
/// no direction above the surface, a sample that weighs something is a direction above it, and
/// its weight is at most `largest_weight` of the cosines of the sample and of `wo`.
pub fn assert_sound<T: Real<Mask = bool> + Into<f64>>(
    name: &str,
    model: &dyn Brdf<T, Color = T::Vec3>,
    largest_weight: impl Fn(f64, f64) -> f64,
    [wi, wo]: [[f64; 3]; 2],
    u: [f64; 2],
) {
    let sound = |what: &str, value: T| -> f64 {
        let value: f64 = value.into();
        let fine = value.is_finite() && value >= 0.0;
        assert!(fine, "{name}: {what} is {value} at wi {wi:?} wo {wo:?} u {u:?}");
        value
    };
    let largest = |what: &str, color: T::Vec3| {
        [color.x(), color.y(), color.z()].map(|c| sound(what, c)).into_iter().fold(0.0, f64::max)
    };
    let vector =
        |w: [f64; 3]| <T::Vec3 as Vector<T>>::new(T::lit(w[0]), T::lit(w[1]), T::lit(w[2]));
    let above = |w: T::Vec3| above_surface::<T, T::Vec3>(w);
    let (wi, wo) = (vector(wi), vector(wo));

    let value = largest("eval", model.eval(wi, wo)).max(sound("pdf", model.pdf(wi, wo)));
    if !(above(wi) && above(wo)) {
        assert_eq!(value, 0.0, "{name}: wi {wi:?} wo {wo:?}");
    }

    let sample = model.sample(wo, u.map(T::lit));
    let weight = largest("weight", sample.weight);
    let pdf = sound("density of a sample", sample.pdf);
    let [x, y, z]: [f64; 3] = [sample.wi.x(), sample.wi.y(), sample.wi.z()].map(Into::into);
    // As long as the direction it mirrors, whose length may be 0.5 % off.
    let longest = x.abs().max(y.abs()).max(z.abs());
    assert!(longest <= 1.0051, "{name}: sample {:?} of {wo:?} {u:?}", sample.wi);
    if weight > 0.0 || pdf > 0.0 {
        assert!(above(wo) && above(sample.wi), "{name}: sample {sample:?} of {wo:?} {u:?}");
        // The lengths of the directions pass into the weight.
        let limit = largest_weight(z, wo.z().into()) * 1.01;
        assert!(weight <= limit, "{name}: weight {weight} > {limit} for {wo:?} {u:?}");
    }
}

/// What a model over the whole sphere says that is no answer, asked for a pair of directions and three
/// uniform numbers, NaN and infinity among them: NaN, infinite and negative numbers, directions that are
/// none, anything but zero where a direction is none or lies in the surface, and importance that is not
/// radiance with the directions exchanged.
pub fn unsound<T: Real<Mask = bool> + Into<f64> + PartialEq>(
    model: &dyn Bsdf<T, Color = T::Vec3>,
    [light, viewer]: [[f64; 3]; 2],
    u: [f64; 3],
) -> Option<String> {
    let vector = |[x, y, z]: [f64; 3]| <T::Vec3 as Vector<T>>::new(T::lit(x), T::lit(y), T::lit(z));
    let none = |w: T::Vec3| {
        let z: f64 = w.z().into();
        let length_squared: f64 = Vector::length_squared(w).into();
        !(0.9899..=1.0101).contains(&length_squared) || z == 0.0
    };
    let numbers = |color: T::Vec3| [color.x(), color.y(), color.z()].map(Into::<f64>::into);
    let (wi, wo) = (vector(light), vector(viewer));
    for mode in [TransportMode::Radiance, TransportMode::Importance] {
        let (value, pdf) = model.eval_pdf(wi, wo, mode);
        let sample = model.sample(wo, u.map(T::lit), mode);
        let lobes = model.specular(wo, mode);
        let weights = [sample.weight, lobes.reflected.weight, lobes.transmitted.weight];
        let of_viewer = [weights.map(numbers).concat(), vec![sample.pdf.into()]].concat();
        let of_pair = [numbers(value).to_vec(), vec![pdf.into()]].concat();
        let sound = |x: &f64| x.is_finite() && *x >= 0.0;
        let zero = |all: &[f64]| all.iter().all(|x| *x == 0.0);
        let drawn: f64 = Vector::length_squared(sample.wi).into();
        let right = of_pair.iter().chain(&of_viewer).all(sound)
            && drawn <= 1.0101
            && (zero(&of_viewer) && !sample.specular || !none(wo))
            && (zero(&of_pair) || !(none(wo) || none(wi)));
        if !right {
            return Some(format!("{of_pair:?} {sample:?} {lobes:?} at {light:?} {viewer:?} {u:?}"));
        }
    }
    let radiance = numbers(model.eval(wi, wo, TransportMode::Radiance));
    let importance = numbers(model.eval(wo, wi, TransportMode::Importance));
    let transposed = radiance == importance;
    (!transposed).then(|| format!("{radiance:?} {importance:?} at {light:?} {viewer:?}"))
}

/// What [`unsound`] finds for what is a direction, what nearly is and what is none, on both sides.
pub fn unsound_anywhere<T: Real<Mask = bool> + Into<f64> + PartialEq>(
    model: &dyn Bsdf<T, Color = T::Vec3>,
) -> Option<String> {
    let numbers = [0.0, 1.0, -0.8, 1e-30, -1e-20, 1e30, 1e300, f64::INFINITY, f64::NAN];
    let mut directions: Vec<[f64; 3]> = numbers
        .iter()
        .flat_map(|&x| numbers.map(|z| [x, if x == 1.0 { 0.0 } else { 0.6 }, z]))
        .collect();
    for power in [1, 4, 8, 16, 25, 40, 160, 310] {
        let grazing = 10.0_f64.powi(-power);
        directions.extend([[1.0, 0.0, grazing], [-0.8, 0.6, -grazing]]);
    }
    directions.extend((0..40).map(|index| {
        let (sin, cos) = (f64::from(index) * 0.08).sin_cos();
        [sin * 0.8, sin * 0.6, cos]
    }));
    let last = 1.0 - f64::EPSILON / 2.0;
    let uniforms =
        [[0.0; 3], [1.0; 3], [0.3, 0.7, last], [0.3, 0.7, 0.0], [f64::NAN, 2.0, -1.0], [last; 3]];
    directions.iter().enumerate().find_map(|(index, &wo)| {
        uniforms.iter().enumerate().find_map(|(step, &u)| {
            let wi = directions[(7 * index + 53 * step) % directions.len()];
            unsound(model, [wi, wo], u)
        })
    })
}
