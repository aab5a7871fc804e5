//! f(wi, wo) = f(wo, wi), in units in the last place.

use brdf::{Brdf, Color, Real};

/// How far a model is from reciprocal.
#[derive(Clone, Copy, Debug)]
pub struct Reciprocity {
    /// The largest difference of a channel, in units in the last place of its larger value.
    pub ulp: f64,
    /// The largest difference relative to the larger value.
    pub relative: f64,
}

/// Exchanges light and viewer of each pair. `epsilon` is that of the number.
pub fn reciprocity<T: Real + Into<f64>>(
    model: &dyn Brdf<T, Color = T::Vec3>,
    pairs: &[(T::Vec3, T::Vec3)],
    epsilon: f64,
) -> Reciprocity {
    let mut found = Reciprocity { ulp: 0.0, relative: 0.0 };
    for &(wi, wo) in pairs {
        let (there, back) = (model.eval(wi, wo), model.eval(wo, wi));
        let larger = there.zip(back, Real::max);
        let difference = (there - back).map(Real::abs);
        let channels = |color: T::Vec3| {
            Color::fold(color, Vec::new(), |mut all: Vec<f64>, value| {
                all.push(value.into());
                all
            })
        };
        for (difference, larger) in channels(difference).into_iter().zip(channels(larger)) {
            if difference > 0.0 {
                // The unit of a number between 2ᵏ and 2ᵏ⁺¹ is 2ᵏ ε.
                found.ulp = found.ulp.max(difference / (larger.log2().floor().exp2() * epsilon));
                found.relative = found.relative.max(difference / larger);
            }
        }
    }
    found
}
