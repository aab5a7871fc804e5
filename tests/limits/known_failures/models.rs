//! Whole models at the edges of what they are asked.

use brdf::{
    BlinnPhong, Brdf, ClassicPhong, Conductor, Dielectric, Fresnel, Lambert, OrenNayar, Phong,
    Schlick, SchlickPower, Vector, WeightedSum,
};

use super::{Number, assert_near, in_both_numbers, vector};

in_both_numbers! {
    /// adobe/openpbr-bsdf #33: the exact albedo of a rough diffuse surface divides by the cosine
    /// of the viewer.
    the_albedo_of_rough_diffuse_at_the_horizon(diffuse_at_the_horizon);
    /// LearnOpenGL #217: the power of a negative cosine, behind the lobe.
    lobes_are_zero_behind_their_edge(behind_the_lobe);
    /// mitsuba3 #443: a weight of zero in one lobe blackens the others.
    a_term_of_weight_zero_does_not_count(weight_zero);
    /// mitsuba3 #443: F₀ = 0 blackens a surface that still reflects at grazing.
    no_reflectance_at_normal_incidence_is_not_black(f0_of_zero);
}

fn diffuse_at_the_horizon<T: Number>() {
    let sigma = 0.3_f64;
    let variance = sigma * sigma;
    let a = 1.0 - 0.5 * variance / (variance + 0.33);
    let b = 0.45 * variance / (variance + 0.09);
    let model = OrenNayar::new(T::lit(0.5), T::lit(sigma)).unwrap();
    // ρ (A + B/2) at the horizon; the slope there is finite, −2B/π cosθ at most.
    for cos in [T::LEAST, 1e-30, 1e-20, 1e-10, 1e-7] {
        let wo = vector::<T>(1.0, 0.0, cos);
        assert_near(model.albedo(wo), 0.5 * (a + 0.5 * b), 2e-6);
        // Light at the horizon too: f grows without bound, the radiance f cosθ does not.
        let wi = vector::<T>(0.8, 0.6, cos);
        let radiance: f64 = (model.eval(wi, wo) * wi.z()).double();
        assert!(radiance <= 0.5 * (a + b) / std::f64::consts::PI, "{radiance}");
    }
    let lambert = OrenNayar::new(T::lit(0.5), T::lit(0.0)).unwrap();
    let horizon = vector::<T>(1.0, 0.0, T::LEAST);
    assert_near(lambert.eval(horizon, horizon), 0.5 / std::f64::consts::PI, T::EPSILON);
}

fn behind_the_lobe<T: Number>() {
    let one = T::lit(1.0);
    // Even, odd, and broken exponents: a power of a negative number is positive, negative, NaN.
    for n in [1.0, 2.0, 2.5, 3.0, 100.0].map(T::lit) {
        let lobes: [Box<dyn Brdf<T, Color = T>>; 3] = [
            Box::new(Phong::new(one, n).unwrap()),
            Box::new(ClassicPhong::new(one, n).unwrap()),
            Box::new(SchlickPower::new(one, n).unwrap()),
        ];
        // R·V = −0.28: the light on the viewer's side, both low.
        let (wi, wo) = (vector::<T>(0.8, 0.0, 0.6), vector::<T>(0.8, 0.0, 0.6));
        for lobe in &lobes {
            assert_near(lobe.eval(wi, wo), 0.0, 0.0);
            assert_near(lobe.pdf(wi, wo), 0.0, 0.0);
        }
        // The half vector is above the surface for every pair.
        let blinn = BlinnPhong::unnormalized(one, n).unwrap();
        let want = 0.6_f64.powf(n.double());
        assert_near(blinn.eval(wi, wo), want, 1e-6 * (1.0 + n.double()));
    }
}

fn weight_zero<T: Number>() {
    type Boxed<T> = Box<dyn Brdf<T, Color = T>>;
    let wo = vector::<T>(0.48, 0.6, 0.64);
    let lobe = || Phong::new(T::lit(0.9), T::lit(20.0)).unwrap();
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    for first in [true, false] {
        let diffuse: Boxed<T> = Box::new(Lambert::new(one).unwrap());
        let gloss: Boxed<T> = Box::new(lobe());
        let mut terms = [(zero, diffuse), (one, gloss)];
        if !first {
            terms.swap(0, 1);
        }
        let sum = WeightedSum::new(terms).unwrap();
        for u in [[0.0, 0.5], [0.3, 0.1], [0.999, 0.9]].map(|u| u.map(T::lit)) {
            let (of_sum, of_lobe) = (sum.sample(wo, u), lobe().sample(wo, u));
            assert_near(of_sum.pdf, of_lobe.pdf.double(), 1e-6);
            assert_near(of_sum.weight, of_lobe.weight.double(), 1e-5);
        }
        assert_near(sum.albedo(wo), lobe().albedo(wo).double(), 0.0);
    }
}

fn f0_of_zero<T: Number>() {
    let schlick = Schlick::new(T::lit(0.0)).unwrap();
    assert_near(schlick.reflectance(T::lit(0.0)), 1.0, 0.0);
    assert_near(schlick.reflectance(T::lit(0.5)), 1.0 / 32.0, 1e-6);
    assert_near(schlick.average(), 1.0 / 21.0, 1e-6);
    // Exact surfaces have no such F₀ but for n = 1; next to it they are black, metals are not.
    assert_near(Dielectric::new(T::lit(1.0)).unwrap().average(), 0.0, 0.0);
    let metal = Conductor::new(T::lit(1.0), T::lit(2.0)).unwrap();
    assert_near(metal.reflectance(T::lit(1.0)), 0.5, 1e-6);
}
