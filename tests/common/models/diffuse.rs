use brdf::{Lambert, OrenNayar, Real};

use super::{Entries, Entry, lit, rgb};

pub(super) fn entries<T: Real>() -> Entries<T> {
    let (lit, rgb) = (lit::<T>, rgb::<T>);
    let white = || rgb(1.0, 1.0, 1.0);
    Ok(vec![
        Entry::new("Lambert", Lambert::new(rgb(0.8, 0.5, 0.2))?),
        Entry::new("Lambert, white", Lambert::new(white())?),
        Entry::new("Oren-Nayar 0, white", OrenNayar::new(white(), lit(0.0))?),
        Entry::new("Oren-Nayar 0.05, white", OrenNayar::new(white(), lit(0.05))?)
            .gains(1.00232, 90.0),
        Entry::new("Oren-Nayar 0.3", OrenNayar::new(rgb(1.0, 0.5, 0.2), lit(0.3))?)
            .gains(1.00535, 90.0),
        Entry::new("Oren-Nayar 0.3, grey", OrenNayar::new(rgb(0.9, 0.5, 0.2), lit(0.3))?),
        Entry::new("Oren-Nayar 1.5, white", OrenNayar::new(white(), lit(1.5))?),
        Entry::new(
            "Oren-Nayar 0.3 with interreflection, white",
            OrenNayar::with_interreflection(white(), lit(0.3))?,
        )
        .gains(1.04431, 90.0),
        Entry::new(
            "Oren-Nayar 0.5 with interreflection",
            OrenNayar::with_interreflection(rgb(0.9, 0.5, 0.2), lit(0.5))?,
        ),
    ])
}
