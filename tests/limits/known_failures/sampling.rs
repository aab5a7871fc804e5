//! Samples at the ends of the uniform numbers and of the viewer's angles.

use brdf::{
    Beckmann, Brdf, Constant, CookTorrance, Ggx, Lambert, Phong, Shadowing, Smith, VCavity, Vector,
    quadrature::mean_over_square,
};

use super::{Number, assert_near, in_both_numbers, vector};

in_both_numbers! {
    /// pbrt-v4 #313, #316: the uniform number rounds to 1, the cosine and the density of a
    /// cosine-weighted direction become 0, and the reflectance estimated from them 0/0.
    a_uniform_number_close_to_one_has_a_density(the_last_cosine);
    /// pbrt-v4 #313: the same for the number 1 itself, which rounding of 1 − 2⁻⁵³ gives.
    a_uniform_number_of_one_is_a_failed_draw(the_cosine_zero);
    /// mitsuba2 #32: tanθ of the viewer is infinite at the horizon and visible normals are NaN.
    visible_normals_of_a_viewer_at_the_horizon(grazing_viewers);
    /// adobe/openpbr-bsdf #24: a viewer along the normal has no azimuth, and
    /// the rotation by the angle of (0, 0) is NaN.
    visible_normals_of_a_viewer_along_the_normal(viewers_along_the_normal);
    /// three-gpu-pathtracer #846, #847: weight, density and value of a sample do not belong
    /// together (by 7 %).
    weight_times_density_is_the_value(consistent_samples);
}

fn the_last_cosine<T: Number>() {
    let model = Lambert::new(T::lit(0.75)).unwrap();
    let z = vector::<T>(0.0, 0.0, 1.0);
    let sample = model.sample(z, [T::lit(T::BELOW_ONE), T::lit(0.25)]);
    let cos = (1.0 - T::BELOW_ONE).sqrt();
    assert_near(sample.wi.z(), cos, T::EPSILON);
    assert_near(sample.pdf, cos / std::f64::consts::PI, 2.0 * T::EPSILON);
    assert_near(sample.weight, 0.75, 0.0);
    // The estimate of the reflectance over all its numbers, the last ones included.
    let steps = 64;
    let mean: f64 = (0..steps)
        .map(|step| 1.0 - (1.0 - T::BELOW_ONE).powf(f64::from(step) / f64::from(steps - 1)))
        .map(|u| model.sample(z, [T::lit(u), T::lit(0.5)]).weight.double())
        .sum();
    assert_eq!(mean / f64::from(steps), 0.75);
}

fn the_cosine_zero<T: Number>() {
    let model = Lambert::new(T::lit(0.75)).unwrap();
    let sample = model.sample(vector::<T>(0.0, 0.0, 1.0), [T::lit(1.0), T::lit(0.25)]);
    let answers: [f64; 3] = [sample.wi.z(), sample.weight, sample.pdf].map(Number::double);
    assert_eq!(answers, [0.0; 3]);
}

fn grazing_viewers<T: Number>() {
    for cos in [0.0_f64, 1e-45, 1e-38, 1e-20, 1e-12] {
        let wo = vector::<T>(1.0, 0.0, cos.max(T::LEAST));
        for roughness in [1e-3, 0.3, 1.0] {
            let (u, a) = (0.25_f64, T::lit(roughness));
            // Beckmann's slopes towards a viewer at the horizon have the distribution function
            // exp(−x²).
            let h = Beckmann::new(a).unwrap().sample_visible(wo, [T::lit(u), T::lit(0.5)]);
            assert_near(h.x() / h.z(), roughness * (-u.ln()).sqrt(), 2e-6);
            assert!(h.y().double().abs() < 1e-6);
            // GGX adds the viewer's direction to a point of the cap, here half a sphere.
            let h = Ggx::new(a).unwrap().sample_visible(wo, [T::lit(0.25), T::lit(u)]);
            let sin = (u * (2.0 - u)).sqrt();
            assert_near(h.x() / h.z(), roughness / (1.0 - u), 2e-6);
            assert_near(h.y() / h.z(), roughness * sin / (1.0 - u), 2e-6);
            // In a V-cavity one of two facets is seen, the one that faces the viewer.
            let ggx = Ggx::new(a).unwrap();
            for place in [0.0, 0.1, 0.5, 0.9] {
                let h = VCavity.sample_visible(&ggx, wo, [T::lit(u), T::lit(place)]);
                assert!(h.x().double() > -1e-6 && h.z().double() > 0.0, "{h:?}");
            }
        }
        // Of GGX with roughness 1, whose normals are uniform over the hemisphere, the visible
        // ones have the mean cosine ∫ cos² / ∫ cos = 2/3 to the viewer.
        let ggx = Ggx::new(T::lit(1.0)).unwrap();
        let mean: T = mean_over_square(|u| Vector::dot(ggx.sample_visible(wo, u), wo));
        assert_near(mean, 2.0 / 3.0, 1e-3);
    }
}

fn viewers_along_the_normal<T: Number>() {
    let u = [T::lit(0.36), T::lit(0.25)];
    for tilt in [0.0, -0.0, 1e-45, 1e-30, 1e-19, 1e-10] {
        let wo = vector::<T>(tilt, -tilt, 1.0);
        // At the normal all normals count by their projected area alone: tan²θ = −ln(1 − u) and
        // u/(1 − u), in the azimuth 2πu₁ or 2πu₀.
        let beckmann = Beckmann::new(T::lit(0.5)).unwrap();
        let h = beckmann.sample_visible(wo, u);
        let slope = ((h.x() * h.x() + h.y() * h.y()) / (h.z() * h.z())).sqrt();
        if tilt < 1e-18 {
            assert_near(slope, 0.5 * (-(0.64_f64).ln()).sqrt(), 2e-6);
        }
        let length: f64 = Vector::length_squared(h).double();
        assert!((length - 1.0).abs() < 1e-6, "{h:?}");
        let mean: T = mean_over_square(|u| {
            let h = beckmann.sample_visible(wo, u);
            (h.x() * h.x() + h.y() * h.y()) / (h.z() * h.z())
        });
        assert_near(mean, 0.25, 1e-2); // ∫ tan² D cos = m²
        let h = Ggx::new(T::lit(0.5)).unwrap().sample_visible(wo, [u[1], u[0]]);
        let slope = ((h.x() * h.x() + h.y() * h.y()) / (h.z() * h.z())).sqrt();
        assert_near(slope, 0.5 * (0.36_f64 / 0.64).sqrt(), 2e-6);
    }
}

fn consistent_samples<T: Number>() {
    let white = || Constant::new(vector::<T>(1.0, 1.0, 1.0)).unwrap();
    let models: [Box<dyn Brdf<T, Color = T::Vec3>>; 3] = [
        Box::new(CookTorrance::new(Ggx::new(T::lit(0.3)).unwrap(), white())),
        Box::new(CookTorrance::new(Beckmann::new(T::lit(0.3)).unwrap(), white())),
        Box::new(Phong::new(vector::<T>(1.0, 1.0, 1.0), T::lit(20.0)).unwrap()),
    ];
    let wo = vector::<T>(0.48, 0.6, 0.64);
    for model in models {
        for u in [[0.1, 0.9], [0.5, 0.2], [0.9, 0.6], [0.0, 0.0]] {
            let sample = model.sample(wo, u.map(T::lit));
            let value: f64 = (model.eval(sample.wi, wo).x() * sample.wi.z()).double();
            assert_near(sample.weight.x() * sample.pdf, value, 1e-5);
            let pdf: f64 = model.pdf(sample.wi, wo).double();
            assert_near(sample.pdf, pdf, 0.0);
        }
    }
}
