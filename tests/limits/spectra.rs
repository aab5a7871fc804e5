//! A spectrum through a model says what each of its wavelengths says alone, to the last bit.

use brdf::{
    Beckmann, Brdf, Color, Conductor, CookTorrance, Fresnel, Ggx, Lambert, ParameterError, Real,
    SmithCorrelated, Spectrum,
};
use brdf_checks::directions::pairs;

const N: usize = 8;

/// Index from that of a dielectric to that of a noble metal.
const ETA: [f64; N] = [1.5, 1.38, 0.97, 0.43, 0.29, 0.2, 0.14, 4.2];
const K: [f64; N] = [0.0, 1.914, 1.87, 2.455, 2.863, 3.3, 3.697, 0.05];

fn spectrum<T: Real>(values: [f64; N]) -> Spectrum<T, N> {
    Spectrum(values.map(T::lit))
}

fn bits(values: [f64; N]) -> [u64; N] {
    values.map(f64::to_bits)
}

#[test]
fn fresnel_of_a_spectrum_is_fresnel_of_each_wavelength() -> Result<(), ParameterError> {
    let together = Conductor::new(spectrum::<f64>(ETA), spectrum(K))?;
    for step in 0..=1000 {
        let cos = f64::from(step) / 1000.0;
        let got = together.reflectance(cos).0;
        for channel in 0..N {
            let want = Conductor::new(ETA[channel], K[channel])?.reflectance(cos);
            assert_eq!(got[channel].to_bits(), want.to_bits(), "{channel} at cosine {cos}");
        }
    }
    Ok(())
}

#[test]
fn average_of_a_spectrum_is_the_average_of_each_wavelength() -> Result<(), ParameterError> {
    let got = Conductor::new(spectrum::<f64>(ETA), spectrum(K))?.average().0;
    for channel in 0..N {
        let want = Conductor::new(ETA[channel], K[channel])?.average();
        assert_eq!(got[channel].to_bits(), want.to_bits(), "{channel}");
    }
    Ok(())
}

/// `eval`, `sample` and `pdf` of a model of all wavelengths against one model for each.
fn compare<M, S>(together: &M, single: impl Fn(usize) -> Result<S, ParameterError>)
where
    M: Brdf<f64, Color = Spectrum<f64, N>>,
    S: Brdf<f64, Color = f64>,
{
    let singles: Vec<S> = (0..N).map(|channel| single(channel).expect("in range")).collect();
    for (index, (wi, wo)) in pairs(2000).into_iter().enumerate() {
        let u = [(index as f64 * 0.618) % 1.0, (index as f64 * 0.755) % 1.0];
        let (value, sample) = (together.eval(wi, wo), together.sample(wo, u));
        let each = |of: &dyn Fn(&S) -> f64| -> [f64; N] {
            std::array::from_fn(|channel| of(&singles[channel]))
        };
        assert_eq!(bits(value.0), bits(each(&|one| one.eval(wi, wo))), "eval {wi} {wo}");
        let weights = each(&|one| one.sample(wo, u).weight);
        assert_eq!(bits(sample.weight.0), bits(weights), "weight {wo} {u:?}");
        for one in &singles {
            assert_eq!(one.sample(wo, u).wi, sample.wi);
            assert_eq!(one.pdf(wi, wo).to_bits(), together.pdf(wi, wo).to_bits());
        }
    }
}

#[test]
fn models_of_a_spectrum_are_models_of_each_wavelength() -> Result<(), ParameterError> {
    let (eta, k) = (spectrum::<f64>(ETA), spectrum(K));
    compare(&CookTorrance::new(Beckmann::new(0.3)?, Conductor::new(eta, k)?), |channel| {
        let metal = Conductor::new(ETA[channel], K[channel])?;
        Ok(CookTorrance::new(Beckmann::new(0.3)?, metal))
    });
    let smith = CookTorrance::new(Ggx::new(0.6)?, Conductor::new(eta, k)?);
    compare(&smith.with_shadowing(SmithCorrelated), |channel| {
        let metal = Conductor::new(ETA[channel], K[channel])?;
        Ok(CookTorrance::new(Ggx::new(0.6)?, metal).with_shadowing(SmithCorrelated))
    });
    let albedo: [f64; N] = std::array::from_fn(|channel| channel as f64 / 7.0);
    compare(&Lambert::new(Spectrum(albedo))?, |channel| Lambert::new(albedo[channel]));
    Ok(())
}

#[test]
fn a_spectrum_is_a_colour() {
    let (a, b) = (Spectrum([1.0, 2.0, 3.0]), Spectrum([4.0, 5.0, 6.0]));
    assert_eq!((a + b).0, [5.0, 7.0, 9.0]);
    assert_eq!((b - a).0, [3.0; 3]);
    assert_eq!((a * b).0, [4.0, 10.0, 18.0]);
    assert_eq!((a * 2.0).0, [2.0, 4.0, 6.0]);
    assert_eq!(<Spectrum<f64, 3> as Color<f64>>::splat(0.5).0, [0.5; 3]);
    assert_eq!(Color::<f64>::mean(a), 2.0);
    assert_eq!(Color::<f64>::fold(a, 0.0, |sum, value| 10.0 * sum + value), 123.0);
    assert_eq!(Color::<f64>::lift(a, Real::sqrt).0[0], 1.0);
    assert_eq!(Color::<f64>::outside(a, 0.0, 2.5), Some(3.0));
    assert_eq!(<Spectrum<f64, 3> as Color<f64>>::choose(true, a, b), a);
}

#[test]
fn a_value_out_of_range_is_found_in_any_channel() {
    for channel in 0..N {
        let mut eta = ETA;
        eta[channel] = f64::NAN;
        let error = Conductor::new(spectrum::<f64>(eta), spectrum(K)).unwrap_err();
        assert_eq!(error.parameter(), "eta");
    }
}
