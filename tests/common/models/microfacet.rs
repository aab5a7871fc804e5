use brdf::{
    Beckmann, Blinn, Conductor, Constant, Cook, CookTorrance, Dielectric, Gaussian, Ggx, Hall,
    Mixture, Real, Schlick, SmithCorrelated, SmithSeparable,
};

use super::{Entries, Entry, lit, rgb};

pub(super) fn entries<T: Real>() -> Entries<T> {
    let (lit, rgb) = (lit::<T>, rgb::<T>);
    let white = || Constant::new(rgb(1.0, 1.0, 1.0));
    let gold = || Conductor::new(rgb(0.143, 0.374, 1.442), rgb(3.983, 2.386, 1.603));
    let glass = || Dielectric::new(rgb(1.5, 1.5, 1.5));
    let from_inside = || Dielectric::new(rgb(0.65, 0.66, 0.67));
    let plastic = || Schlick::new(rgb(0.04, 0.05, 0.06));
    let hall = || Hall::new(rgb(0.95, 0.64, 0.54), lit(1.5));
    let cook = || Cook::new(rgb(0.9, 0.6, 0.3), rgb(1.0, 0.9, 0.8), lit(1.5));
    let beckmann = |roughness| Beckmann::new(lit(roughness));
    let ggx = |roughness| Ggx::new(lit(roughness));
    let gaussian = |roughness| Gaussian::new(lit(roughness));
    let blinn = |exponent| Blinn::new(lit(exponent));
    let of_beckmann = || Mixture::new([(lit(0.75), beckmann(0.125)?), (lit(0.25), beckmann(0.5)?)]);
    let of_ggx = || Mixture::new([(lit(0.9), ggx(0.02)?), (lit(0.1), ggx(0.6)?)]);
    let of_gaussians = || {
        let (narrow, middle, wide) = (gaussian(0.1)?, gaussian(0.3)?, gaussian(0.6)?);
        Mixture::new([(lit(0.5), narrow), (lit(0.25), middle), (lit(0.25), wide)])
    };
    let (smith, separable) = (SmithCorrelated, SmithSeparable);
    #[rustfmt::skip]
    let entries = vec![
        Entry::new("Beckmann 0.001, white", CookTorrance::new(beckmann(0.001)?, white()?)),
        Entry::new("Beckmann 0.05, gold", CookTorrance::new(beckmann(0.05)?, gold()?)),
        Entry::new("Beckmann 0.25, gold", CookTorrance::new(beckmann(0.25)?, gold()?)),
        Entry::new("Beckmann 1, white", CookTorrance::new(beckmann(1.0)?, white()?)),
        Entry::new("Beckmann 0.5 0.05, gold", CookTorrance::new(Beckmann::anisotropic(lit(0.5), lit(0.05))?, gold()?)),
        Entry::new("Beckmann 0.001, Smith, plastic", CookTorrance::new(beckmann(0.001)?, plastic()?).with_shadowing(smith)),
        Entry::new("Beckmann 0.01, Smith, plastic", CookTorrance::new(beckmann(0.01)?, plastic()?).with_shadowing(smith)),
        Entry::new("Beckmann 0.3, Smith, white", CookTorrance::new(beckmann(0.3)?, white()?).with_shadowing(smith)),
        Entry::new("Beckmann 1, Smith, white", CookTorrance::new(beckmann(1.0)?, white()?).with_shadowing(smith)),
        Entry::new("Beckmann 0.5, Smith separable, Hall", CookTorrance::new(beckmann(0.5)?, hall()?).with_shadowing(separable)),
        Entry::new("Beckmann 0.1 0.5, Smith separable, Hall", CookTorrance::new(Beckmann::anisotropic(lit(0.1), lit(0.5))?, hall()?).with_shadowing(separable)),
        Entry::new("GGX 0.001, Cook", CookTorrance::new(ggx(0.001)?, cook()?)),
        Entry::new("GGX 0.5, Cook", CookTorrance::new(ggx(0.5)?, cook()?)),
        Entry::new("GGX 1 0.1, Cook", CookTorrance::new(Ggx::anisotropic(lit(1.0), lit(0.1))?, cook()?)),
        Entry::new("GGX 0.001, Smith, gold", CookTorrance::new(ggx(0.001)?, gold()?).with_shadowing(smith)),
        Entry::new("GGX 0.01, Smith, gold", CookTorrance::new(ggx(0.01)?, gold()?).with_shadowing(smith)),
        Entry::new("GGX 0.1, Smith, gold", CookTorrance::new(ggx(0.1)?, gold()?).with_shadowing(smith)),
        Entry::new("GGX 0.3, Smith, gold", CookTorrance::new(ggx(0.3)?, gold()?).with_shadowing(smith)),
        Entry::new("GGX 0.05 0.4, Smith, glass", CookTorrance::new(Ggx::anisotropic(lit(0.05), lit(0.4))?, glass()?).with_shadowing(smith)),
        Entry::new("GGX 0.2, Smith, from inside glass", CookTorrance::new(ggx(0.2)?, from_inside()?).with_shadowing(smith)),
        Entry::new("GGX 0.05, Smith separable, white", CookTorrance::new(ggx(0.05)?, white()?).with_shadowing(separable)),
        Entry::new("GGX 0.5, Smith separable, white", CookTorrance::new(ggx(0.5)?, white()?).with_shadowing(separable)),
        Entry::new("GGX 1, Smith separable, white", CookTorrance::new(ggx(1.0)?, white()?).with_shadowing(separable)),
        Entry::new("Gaussian 0.001, white", CookTorrance::new(gaussian(0.001)?, white()?)),
        Entry::new("Gaussian 0.05, plastic", CookTorrance::new(gaussian(0.05)?, plastic()?)),
        Entry::new("Gaussian 0.25, plastic", CookTorrance::new(gaussian(0.25)?, plastic()?)),
        Entry::new("Gaussian 1, white", CookTorrance::new(gaussian(1.0)?, white()?)),
        Entry::new("Blinn 0, white", CookTorrance::new(blinn(0.0)?, white()?)),
        Entry::new("Blinn 8, gold", CookTorrance::new(blinn(8.0)?, gold()?)),
        Entry::new("Blinn 50, white", CookTorrance::new(blinn(50.0)?, white()?)),
        Entry::new("Blinn 1e4, white", CookTorrance::new(blinn(1e4)?, white()?)),
        Entry::new("mixture of Beckmann, Smith, gold", CookTorrance::new(of_beckmann()?, gold()?).with_shadowing(smith)),
        Entry::new("mixture of GGX, Smith, gold", CookTorrance::new(of_ggx()?, gold()?).with_shadowing(smith)),
        Entry::new("mixture of Gaussians, glass", CookTorrance::new(of_gaussians()?, glass()?)),
    ];
    Ok(entries)
}
