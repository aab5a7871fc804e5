//! Materials of many sliders.

use brdf::{Brdf, Disney2012, DisneyForm, DisneyParameters, Vector};

use super::reference::each;
use super::{Check, Number, Verdict, near, vector};

pub(super) fn all<T: Number>() -> [Check; 2] {
    [("Disney's material", disney::<T>), ("a black base has no tint", black::<T>)]
}

fn disney<T: Number>() -> Verdict {
    each("disney_2012", |case| {
        let [wi, wo] = ["i", "o"].map(|which| vector::<T>(case.direction(which)));
        let number = |key: &str| case.input::<T>(key);
        let base_color = Vector::new(T::lit(0.8), T::lit(0.4), T::lit(0.2));
        let sliders = DisneyParameters {
            base_color,
            metallic: number("metallic"),
            subsurface: number("subsurface"),
            specular: number("specular"),
            roughness: number("roughness"),
            specular_tint: number("specular_tint"),
            anisotropic: number("anisotropic"),
            sheen: number("sheen"),
            sheen_tint: number("sheen_tint"),
            clearcoat: number("clearcoat"),
            clearcoat_gloss: number("clearcoat_gloss"),
        };
        let model = Disney2012::<T::Vec3, T>::new(sliders)?;
        case.same_vector::<T>("f_2012", model.eval(wi, wo))?;
        case.same_vector::<T>("f_2014", model.with_form(DisneyForm::Of2014).eval(wi, wo))?;
        // The coat is what a material has more with it.
        let bare = DisneyParameters { clearcoat: T::zero(), ..sliders };
        let bare = Disney2012::<T::Vec3, T>::new(bare)?;
        let coat = model.eval(wi, wo).x().into() - bare.eval(wi, wo).x().into();
        near("clear coat", T::lit(coat), case.number_out("clearcoat"), 1e-12)
    })
}

fn black<T: Number>() -> Verdict {
    let black = DisneyParameters::of(vector::<T>(glam::DVec3::ZERO));
    let tinted = DisneyParameters { specular_tint: T::one(), ..black };
    let [black, tinted] = [Disney2012::new(black)?, Disney2012::new(tinted)?];
    let w = vector::<T>(glam::DVec3::Z);
    near("tint of black", tinted.eval(w, w).x(), black.eval(w, w).x().into(), 0.0)
}
