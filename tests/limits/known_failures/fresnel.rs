//! Reflectances at the ends of indices and angles.

use brdf::fresnel::{
    conductor_polarized, dielectric_polarized, forms, index_from_normal_incidence, normal_incidence,
};
use brdf::{
    Brdf, Conductor, Constant, Cook, CookTorrance, Dielectric, Fresnel, Ggx, Hall, Schlick,
    SmithCorrelated,
};

use super::{Number, assert_near, in_both_numbers, vector};

in_both_numbers! {
    /// Unity SRP #5136, #3511, #3518, Ignis #16, glTF-Blender-IO #1752, Falcor (η = 1 and
    /// cosθ = 0): with an index of 1 there is no surface, F₀ = 0, and quotients by it are 0/0.
    an_index_of_one_reflects_nothing(no_surface);
    /// playcanvas #5239, pbrt-v4 #523: an index of 0 or below.
    indices_of_zero_and_below_are_refused(refused_indices);
    /// mitsuba3 #1113, #1150, #1161: the wrong branch of the complex root makes amplitudes jump.
    reflectance_is_continuous_in_the_absorption(branches);
    /// pbrt-v4 #222: reflectance 1 makes the index of the artist's conductor infinite, and NaN.
    a_reflectance_of_one(perfect_mirrors);
    /// OpenPBR #187, #238, #256, #314: a term that corrects a colour at normal incidence leaves
    /// 0 … 1.
    interpolated_colours_stay_between_their_ends(interpolations);
    /// LearnOpenGL #217, Nu #1228: the cosine exceeds 1 by rounding and (1 − cosθ)⁵ becomes the
    /// power of a negative number.
    cosines_above_one(long_cosines);
}

/// From grazing to normal incidence.
const COSINES: [f64; 9] = [0.0, 1e-45, 1e-20, 1e-7, 1e-3, 0.1, 0.5, 0.9, 1.0];

fn no_surface<T: Number>() {
    let one = T::lit(1.0);
    let terms: [Box<dyn Fresnel<T, Color = T>>; 3] = [
        Box::new(Dielectric::new(one).unwrap()),
        Box::new(Conductor::new(one, T::lit(0.0)).unwrap()),
        Box::new(Hall::new(T::lit(0.0), one).unwrap()),
    ];
    for term in terms {
        for cos in COSINES {
            assert_near(term.reflectance(T::lit(cos)), 0.0, 0.0);
        }
        assert_near(term.average(), 0.0, 0.0);
        let model =
            CookTorrance::new(Ggx::new(T::lit(0.3)).unwrap(), term).with_shadowing(SmithCorrelated);
        let wo = vector::<T>(0.48, 0.6, 0.64);
        assert_near(model.eval(vector::<T>(-0.48, -0.6, 0.64), wo), 0.0, 0.0);
        let sample = model.sample(wo, [T::lit(0.5), T::lit(0.5)]);
        assert_near(sample.weight, 0.0, 0.0);
        assert!(sample.pdf.double() > 0.0);
        assert_near(model.albedo(wo), 0.0, 0.0);
    }
    let polarized = dielectric_polarized(one, T::lit(0.0));
    assert_near(polarized.s, 0.0, 0.0);
    assert_near(polarized.p, 0.0, 0.0);
    assert_near(forms::abu(one, T::lit(0.0), T::lit(0.0)), 0.0, 0.0);
    assert_near(normal_incidence(one, T::lit(0.0)), 0.0, 0.0);
    assert_near(index_from_normal_incidence(T::lit(0.0)).unwrap(), 1.0, 0.0);
    // The index next to 1 has F₀ = (ε/2)², and is a mirror at grazing like every other.
    let almost = Dielectric::new(T::lit(1.0 + T::EPSILON)).unwrap();
    assert_near(almost.reflectance(one), (T::EPSILON / 2.0).powi(2), 1e-6);
    assert_near(almost.reflectance(T::lit(0.0)), 1.0, 0.0);
}

fn refused_indices<T: Number>() {
    for index in [0.0, -0.0, -1.5, 5e-324, f64::NAN, f64::NEG_INFINITY] {
        let (index, fine) = (T::lit(index), T::lit(1.5));
        let refusals = [
            Dielectric::new(index).unwrap_err(),
            Hall::new(fine * T::lit(0.1), index).map(drop).unwrap_err(),
            Cook::new(fine * T::lit(0.1), fine, index).map(drop).unwrap_err(),
            Conductor::new(index, fine).unwrap_err(),
        ];
        assert_eq!(refusals.map(|error| error.parameter()), ["ior", "ior", "ior", "eta"]);
    }
    let negative = Conductor::new(T::lit(1.5), T::lit(-0.1)).unwrap_err();
    assert_eq!((negative.parameter(), negative.range()), ("k", (0.0, 1e4)));
}

fn branches<T: Number>() {
    for eta in [0.4, 0.9, 1.0, 1.5, 3.0] {
        for step in 0..=400 {
            let (eta, cos) = (T::lit(eta), T::lit(f64::from(step) / 400.0));
            let (none, some) = (T::lit(0.0), T::lit(1e-12));
            // Both roots lie in the first quadrant: the wave decays, on the side it comes from too.
            let (a, b) = forms::ab(eta, some, cos);
            assert!(a.double() >= 0.0 && b.double() >= 0.0);
            let n_k: f64 = (eta * some).double();
            assert_near(a * b, n_k, 1e-5);
            let (clear, weak) =
                (conductor_polarized(eta, none, cos), conductor_polarized(eta, some, cos));
            // With n = 1 weak absorption is all there is to see; at the critical angle R falls as
            // √k.
            let allowed = if eta.double() == 1.0 { 1.0 } else { 1e-5 };
            let apart = [(clear.s, weak.s), (clear.p, weak.p)]
                .map(|(clear, weak)| (clear - weak).abs().double());
            assert!(apart.into_iter().all(|apart: f64| apart <= allowed), "{eta:?} {cos:?}");
            // The dielectric is the same function.
            let exact = dielectric_polarized(eta, cos);
            let apart: f64 = (exact.s - clear.s).abs().double();
            let q_squared: f64 = (eta * eta - T::lit(1.0) + cos * cos).double();
            let rounding = 20.0 * T::EPSILON.sqrt().min(T::EPSILON / q_squared.abs().sqrt());
            assert!(apart <= rounding, "{eta:?} {cos:?}: {exact:?} {clear:?}");
        }
    }
}

fn perfect_mirrors<T: Number>() {
    assert_eq!(index_from_normal_incidence(T::lit(1.0)).unwrap_err().range(), (0.0, 0.9996));
    let index = index_from_normal_incidence(T::lit(0.9996)).unwrap();
    assert_near(normal_incidence(index, T::lit(0.0)), 0.9996, 1e-6);
    let one = T::lit(1.0);
    // A reference that reflects everything leaves no room for the interpolation: F is F₀.
    let of_mirror = Hall::with_reference(T::lit(0.3), Constant::new(one).unwrap()).unwrap();
    for cos in COSINES.map(T::lit) {
        assert_near(Schlick::new(one).unwrap().reflectance(cos), 1.0, 0.0);
        assert_near(Hall::new(one, T::lit(1.5)).unwrap().reflectance(cos), 1.0, 0.0);
        assert_near(of_mirror.reflectance(cos), 0.3, T::EPSILON);
        assert_near(Conductor::new(one, T::lit(1e4)).unwrap().reflectance(cos), 1.0, 4e-4);
    }
    assert_near(of_mirror.average(), 0.3, 1e-6);
}

fn interpolations<T: Number>() {
    // References that dip below their normal incidence on the way to grazing.
    let aluminium = Conductor::new(T::lit(1.2), T::lit(7.3)).unwrap();
    let dips = (0..=1000).any(|step| {
        let cos = T::lit(f64::from(step) / 1000.0);
        aluminium.reflectance(cos) < aluminium.reflectance(T::lit(1.0))
    });
    assert!(dips);
    for f0 in [0.0, 1e-40, 0.04, 0.5, 0.9999999, 1.0] {
        let f0 = T::lit(f0);
        let hall = Hall::with_reference(f0, aluminium).unwrap();
        let cook = Cook::with_reference(f0, T::lit(2.0), aluminium).unwrap();
        for step in 0..=1000 {
            let cos = T::lit(f64::from(step) / 1000.0);
            let reflectance = hall.reflectance(cos);
            assert!(reflectance >= f0 && reflectance <= T::lit(1.0), "{f0:?} {cos:?}");
            let colour: f64 = (reflectance * T::lit(2.0)).double();
            assert_near(cook.reflectance(cos), colour, 0.0);
        }
        assert!(hall.average() >= f0 * T::lit(1.0 - 1e-6) && hall.average() <= T::lit(1.0));
    }
}

fn long_cosines<T: Number>() {
    let f0 = T::lit(0.04);
    let (glass, gold) = (T::lit(1.5), [T::lit(0.14), T::lit(3.697)]);
    let terms: [Box<dyn Fresnel<T, Color = T>>; 4] = [
        Box::new(Schlick::new(f0).unwrap()),
        Box::new(Hall::new(f0, glass).unwrap()),
        Box::new(Dielectric::new(glass).unwrap()),
        Box::new(Conductor::new(gold[0], gold[1]).unwrap()),
    ];
    for (term, want) in terms.iter().zip([0.04, 0.04, 0.04, 0.9625853747]) {
        for cos in [1.0, 1.0 + T::EPSILON, 1.0001, 2.0, 1e30, f64::INFINITY] {
            assert_near(term.reflectance(T::lit(cos)), want, 1e-6);
        }
    }
    // A pair along the normal whose lengths make N·L larger than 1.
    let long = vector::<T>(0.0, 0.0, 1.004);
    let model = CookTorrance::new(Ggx::new(T::lit(1.0)).unwrap(), Schlick::new(f0).unwrap());
    assert_near(model.eval(long, long), 0.04 / (4.0 * std::f64::consts::PI), 2e-2);
}
