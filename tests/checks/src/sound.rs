//! What must hold of every answer of a model, whatever it is asked.

use brdf::{Brdf, Real, Vector, above_surface};

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
