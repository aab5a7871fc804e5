use brdf::{
    CookTorrance, Dielectric, Ggx, Lambert, Phong, Real, SchlickPower, SmithCorrelated, WeightedSum,
};

use super::{Boxed, Entries, Entry, lit, rgb};

pub(super) fn entries<T: Real>() -> Entries<T> {
    let (lit, rgb) = (lit::<T>, rgb::<T>);
    let boxed = |model: Boxed<T>| model;
    let three = {
        let terms = [
            (rgb(0.5, 0.25, 0.125), boxed(Box::new(Lambert::new(rgb(0.8, 0.5, 0.2))?))),
            (rgb(0.25, 0.5, 0.5), Box::new(Phong::new(rgb(1.0, 1.0, 1.0), lit(30.0))?)),
            (rgb(0.25, 0.25, 0.375), Box::new(SchlickPower::new(rgb(1.0, 0.9, 0.8), lit(8.0))?)),
        ];
        WeightedSum::new(terms)?
    };
    // A sum inside a sum; a narrow lobe that weighs little beside a broad one.
    let nested = {
        let glass = Dielectric::new(rgb(1.5, 1.5, 1.5))?;
        let coat = CookTorrance::new(Ggx::new(lit(0.02))?, glass).with_shadowing(SmithCorrelated);
        let base: Boxed<T> = Box::new(WeightedSum::new([(
            rgb(1.0, 1.0, 1.0),
            boxed(Box::new(Lambert::new(rgb(0.3, 0.1, 0.05))?)),
        )])?);
        WeightedSum::new([(rgb(0.7, 0.7, 0.7), base), (rgb(0.3, 0.3, 0.3), Box::new(coat))])?
    };
    Ok(vec![Entry::new("weighted sum of three", three), Entry::new("weighted sum, nested", nested)])
}
