//! Densities and shadowing at small and unequal roughness.

use std::f64::consts::PI;

use brdf::{
    Beckmann, Brdf, Constant, CookTorrance, Distribution, Gaussian, Ggx, Mixture, Pair, Shadowing,
    Smith, SmithCorrelated, VCavity, Vector,
};

use super::{Number, assert_near, in_both_numbers, vector};

in_both_numbers! {
    /// pbrt-v3 #273, three-gpu-pathtracer #161: one roughness is 0, the other not, and densities
    /// are 0/0.
    a_roughness_of_zero_is_refused(refused_roughness);
    /// pbrt-v3 #273, appleseed #1347 (Beckmann with small roughness samples black or NaN).
    the_least_roughness_is_a_mirror(mirrors);
    /// redner #64: where the roughness goes to 0, differences of the density are NaN.
    densities_of_neighbouring_roughness(neighbours);
    /// godot #56373, #59123, three.js #8349: α⁴ of GGX underflows in short numbers and divides by
    /// zero. filament #241, #245: the same for unequal roughness.
    the_peak_of_the_density(peaks);
    /// adobe/openpbr-bsdf #15: √(1 + α² tan²θ) − 1 of Smith's Λ cancels close to the normal.
    lambda_close_to_the_normal(small_lambda);
    /// adobe/openpbr-bsdf #17: an early exit of G₁ for small angles makes a step.
    masking_has_no_step(masking_steps);
}

fn refused_roughness<T: Number>() {
    let (zero, some) = (T::lit(0.0), T::lit(0.3));
    for outside in [0.0, -0.0, -0.3, 1e-9, 1e5, f64::NAN, f64::INFINITY] {
        let outside = T::lit(outside);
        let refusals = [
            Ggx::new(outside).map(drop).unwrap_err(),
            Ggx::anisotropic(outside, some).map(drop).unwrap_err(),
            Ggx::anisotropic(some, outside).map(drop).unwrap_err(),
            Beckmann::new(outside).map(drop).unwrap_err(),
            Beckmann::anisotropic(outside, some).map(drop).unwrap_err(),
            Beckmann::anisotropic(some, outside).map(drop).unwrap_err(),
            Gaussian::new(outside).map(drop).unwrap_err(),
        ];
        let parameters = refusals.map(|error| error.parameter());
        let each = ["roughness", "along_x", "along_y", "roughness", "along_x", "along_y"];
        assert_eq!(parameters[..6], each);
        assert_eq!(parameters[6], "roughness");
    }
    assert_eq!(Ggx::anisotropic(zero, zero).unwrap_err().range(), (1e-8, 1e4));
}

fn mirrors<T: Number>() {
    let white = || Constant::new(T::lit(1.0)).unwrap();
    let wo = vector::<T>(0.48, 0.6, 0.64);
    for (x, y) in [(1e-8, 1e-8), (1e-8, 1e-3), (1e-6, 1e-8)] {
        let (a, b) = (T::lit(x), T::lit(y));
        let models: [Box<dyn Brdf<T, Color = T>>; 3] = [
            Box::new(CookTorrance::from_parts(
                Beckmann::anisotropic(a, b).unwrap(),
                white(),
                VCavity,
            )),
            Box::new(
                CookTorrance::new(Beckmann::anisotropic(a, b).unwrap(), white())
                    .with_shadowing(SmithCorrelated),
            ),
            Box::new(
                CookTorrance::new(Ggx::anisotropic(a, b).unwrap(), white())
                    .with_shadowing(SmithCorrelated),
            ),
        ];
        for model in models {
            for u in [[0.1, 0.1], [0.5, 0.7], [0.9, 0.3]] {
                let sample = model.sample(wo, u.map(T::lit));
                assert_near(sample.weight, 1.0, 2e-3);
                let around = 20.0 * x.max(y);
                assert!((sample.wi.x().double() + 0.48).abs() < around + 1e-6, "{sample:?}");
                assert!((sample.wi.y().double() + 0.6).abs() < around + 1e-6, "{sample:?}");
            }
            // The albedo, too, is that of the mirror.
            assert_near(model.albedo(wo), 1.0, 2e-3);
        }
    }
}

fn neighbours<T: Number>() {
    // D(h) grows as α² far from the peak and falls as α⁻² at it: Δ ln D = ±2 Δ ln α.
    let (normal, tilted) = (vector::<T>(0.0, 0.0, 1.0), vector::<T>(0.6, 0.0, 0.8));
    for roughness in [1e-8, 1e-6, 1e-4] {
        let densities = |h: T::Vec3| -> [f64; 2] {
            [1.0, 1.25].map(|step| Ggx::new(T::lit(roughness * step)).unwrap().density(h).double())
        };
        let [one, more] = densities(normal);
        assert!((more / one - 0.64).abs() < 1e-6, "{roughness}: {one} {more}");
        let [one, more] = densities(tilted);
        assert!((more / one - 1.5625).abs() < 1e-6, "{roughness}: {one} {more}");
        let [one, more] = [1.0, 1.25]
            .map(|step| Beckmann::new(T::lit(roughness * step)).unwrap().density(tilted).double());
        assert_eq!((one, more), (0.0, 0.0));
    }
}

fn peaks<T: Number>() {
    let normal = vector::<T>(0.0, 0.0, 1.0);
    for (x, y) in [(1e-8, 1e-8), (1e-5, 1e-5), (1e-8, 1e4), (1e-2, 1e-6), (1.0, 0.1), (1e4, 1e4)] {
        let (a, b) = (T::lit(x), T::lit(y));
        assert_near(Ggx::anisotropic(a, b).unwrap().density(normal), 1.0 / (PI * x * y), 1e-6);
        assert_near(Beckmann::anisotropic(a, b).unwrap().density(normal), 1.0 / (PI * x * y), 1e-6);
        // A quarter of the peak where h_x/(α_x h_z) = 1: the shape does not underflow either.
        let h = vector::<T>(x / x.hypot(1.0), 0.0, 1.0 / x.hypot(1.0));
        let want = x.hypot(1.0).powi(4) / (4.0 * PI * x * y);
        assert_near(Ggx::anisotropic(a, b).unwrap().density(h), want, 2e-6);
    }
    let two = [(T::lit(0.5), Ggx::new(T::lit(1e-8)).unwrap()); 2];
    assert_near(Mixture::new(two).unwrap().density(normal), 1e16 / PI, 1e-6);
}

fn small_lambda<T: Number>() {
    for roughness in [1e-8, 1e-4, 0.1, 1.0] {
        for sin in [1e-10, 1e-6, 1e-4] {
            let w = vector::<T>(sin, 0.0, (1.0_f64 - sin * sin).sqrt());
            // Λ cosθ = α² sin²/4 but for terms of its square.
            let ggx = Ggx::new(T::lit(roughness)).unwrap();
            assert_near(ggx.lambda_cos(w), 0.25 * (roughness * sin).powi(2), 2e-6);
        }
    }
    // Beckmann's is erfc-small instead, and exactly zero where it is below every number.
    let beckmann = Beckmann::new(T::lit(0.5)).unwrap();
    let lambda: f64 = beckmann.lambda_cos(vector::<T>(1e-6, 0.0, 1.0)).double();
    assert_eq!(lambda, 0.0);
    // At ν = 1/(α tanθ) = 1.2, where erfc ν = 0.0896860…, the sum of two terms that cancel.
    let nu = 1.2_f64;
    let cos = 1.0 / (2.0 / nu).hypot(1.0);
    let w = vector::<T>((1.0 - cos * cos).sqrt(), 0.0, cos);
    let lambda = ((-nu * nu).exp() / (nu * PI.sqrt()) - 0.08968602177036462) / 2.0;
    assert_near(beckmann.lambda_cos(w), lambda * cos, 5e-6);
}

fn masking_steps<T: Number>() {
    // G₁/(4 cosθ) over neighbouring angles from the normal to the horizon.
    let (ggx, beckmann) = (Ggx::new(T::lit(0.5)).unwrap(), Beckmann::new(T::lit(0.5)).unwrap());
    let steps = 4000;
    let masking = |step: u32| -> [f64; 3] {
        let theta = std::f64::consts::FRAC_PI_2 * f64::from(step) / f64::from(steps);
        let wo = vector::<T>(theta.sin(), 0.0, theta.cos());
        let pair = Pair::<T>::new(wo, wo);
        [
            SmithCorrelated.masking(&ggx, &pair),
            SmithCorrelated.masking(&beckmann, &pair),
            VCavity.masking(&ggx, &pair),
        ]
        .map(Number::double)
    };
    let mut before = masking(0);
    assert_eq!(before, [0.25; 3]);
    for step in 1..steps {
        let now = masking(step);
        for (now, before) in now.into_iter().zip(before) {
            assert!((now - before).abs() < 3e-3, "{step}: {before} {now}");
        }
        before = now;
    }
}
