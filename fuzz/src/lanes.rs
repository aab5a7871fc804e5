//! A scalar and a lane have the same bits.

use brdf::{Brdf, Lanes, Real, Vector};

type Wide<T> = Lanes<T, 2>;

fn vector<T: Real>([x, y, z]: [f64; 3]) -> T::Vec3 {
    Vector::new(T::lit(x), T::lit(y), T::lit(z))
}

/// All answers of a model as plain numbers.
fn answers<T: Real>(
    model: &dyn Brdf<T, Color = T::Vec3>,
    [wi, wo]: [T::Vec3; 2],
    u: [T; 2],
) -> [T; 11] {
    let (value, sample) = (model.eval(wi, wo), model.sample(wo, u));
    let (w, weight) = (sample.wi, sample.weight);
    [
        value.x(),
        value.y(),
        value.z(),
        model.pdf(wi, wo),
        w.x(),
        w.y(),
        w.z(),
        weight.x(),
        weight.y(),
        weight.z(),
        sample.pdf,
    ]
}

/// Asserts it for one model and two pairs of directions, one per lane.
pub fn assert_lanes_are_scalars<T: Real<Mask = bool> + Into<f64>>(
    scalar: &dyn Brdf<T, Color = T::Vec3>,
    lanes: &dyn Brdf<Wide<T>, Color = <Wide<T> as Real>::Vec3>,
    pairs: [[[f64; 3]; 2]; 2],
    u: [f64; 2],
) {
    let both = |which: usize| -> <Wide<T> as Real>::Vec3 {
        let component = |axis: usize| Lanes(pairs.map(|pair| T::lit(pair[which][axis])));
        Vector::new(component(0), component(1), component(2))
    };
    let wide = answers(lanes, [both(0), both(1)], u.map(Lanes::lit));
    for (lane, pair) in pairs.into_iter().enumerate() {
        let narrow = answers(scalar, pair.map(vector::<T>), u.map(T::lit));
        for (wide, narrow) in wide.into_iter().zip(narrow) {
            let [wide, narrow]: [f64; 2] = [wide.0[lane], narrow].map(Into::into);
            assert_eq!(wide.to_bits(), narrow.to_bits(), "lane {lane} of {pairs:?}");
        }
    }
}
