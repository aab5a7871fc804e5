use brdf::{
    Beckmann, Blinn1977, Blinn1977Printed, Conductor, CookTorrance, CookTorrance1982Printed,
    Dielectric, Real,
};

use super::{Entries, Entry, lit, rgb};

pub(super) fn entries<T: Real>() -> Entries<T> {
    let (lit, rgb) = (lit::<T>, rgb::<T>);
    let gold = || Conductor::new(rgb(0.143, 0.374, 1.442), rgb(3.983, 2.386, 1.603));
    let glass = || Dielectric::new(rgb(1.5, 1.5, 1.5));
    let wide = Blinn1977::new(lit(1.0))?;
    Ok(vec![
        Entry::new(
            "Torrance-Sparrow 1967, glass",
            CookTorrance::torrance_sparrow_1967(lit(0.05), glass()?)?,
        ),
        Entry::new(
            "Cook-Torrance as printed in 1982, gold",
            CookTorrance1982Printed::new(Beckmann::new(lit(0.2))?, gold()?),
        )
        .gains(3.9033, 90.0),
        Entry::new("Blinn 1977 as printed, D1, gold", Blinn1977Printed::d1(wide, gold()?)?)
            .gains(7.7671, 90.0),
        Entry::new("Blinn 1977 as printed, D2, gold", Blinn1977Printed::d2(wide, gold()?)?)
            .gains(7.8004, 90.0),
        Entry::new("Blinn 1977 as printed, D3, gold", Blinn1977Printed::d3(wide, gold()?)?)
            .gains(7.6596, 90.0),
    ])
}
