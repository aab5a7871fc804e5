//! Every term with extreme inputs, and with other numbers than floats.

use brdf::fresnel::{conductor_polarized, dielectric_polarized, forms};
use brdf::{Conductor, Constant, Cook, Dielectric, Fresnel, Hall, Lanes, Real, Schlick};

use super::fresnel::{cosines, extinctions, indices};
use brdf_checks::traced::trace;

#[test]
fn cosines_of_any_size_are_harmless() {
    macro_rules! check {
        ($float:ident) => {
            let mut indices: Vec<$float> = indices().into_iter().map($float::from).collect();
            indices.push(1.0);
            let mut cosines: Vec<$float> = cosines().into_iter().map($float::from).collect();
            cosines.extend([$float::MIN_POSITIVE, 1e-40, 1.0 + $float::EPSILON, 1.001, 3.0]);
            cosines.extend([$float::MAX, $float::INFINITY, $float::NAN]);
            let good = |value: $float| (0.0..=1.0).contains(&value);
            for &n in &indices {
                let mut terms: Vec<Box<dyn Fresnel<$float, Color = $float>>> = vec![
                    Box::new(Dielectric::new(n).unwrap()),
                    Box::new(Hall::new(0.5, n).unwrap()),
                    Box::new(Cook::new(0.0, 1.0, n).unwrap()),
                ];
                for k in extinctions() {
                    terms.push(Box::new(Conductor::new(n, $float::from(k)).unwrap()));
                }
                for term in &terms {
                    for &cos in &cosines {
                        assert!(good(term.reflectance(cos)), "{n} {cos}");
                        assert!(good(term.reflectance(-cos)), "{n} {cos}");
                        if cos > 1.0 {
                            assert_eq!(term.reflectance(cos), term.reflectance(1.0));
                        }
                    }
                }
                for &cos in &cosines {
                    for cos in [cos, -cos] {
                        let polarized = dielectric_polarized(n, cos);
                        assert!(good(polarized.s) && good(polarized.p), "{n} {cos}");
                        assert!(good(forms::gc(n, cos)), "{n} {cos}");
                        for k in [0.0, 1e-30, 1e-3, 1.0, 1e4] {
                            let polarized = conductor_polarized(n, k, cos);
                            assert!(good(polarized.s) && good(polarized.p), "{n} {k} {cos}");
                            assert!(good(forms::abu(n, k, cos)), "{n} {k} {cos}");
                        }
                    }
                }
                for term in terms[..3].iter().chain(terms[3..].iter().step_by(9)) {
                    assert!(good(term.average()), "{n}");
                }
            }
            for f0 in [0.0, 1e-30, 0.1, 0.3, 0.7, 1.0] {
                for &cos in &cosines {
                    assert!(good(Schlick::new(f0).unwrap().reflectance(cos)), "{f0} {cos}");
                }
            }
        };
    }
    check!(f32);
    check!(f64);
}

/// The averages of all terms, and their reflectances at one cosine.
fn all_terms<T: Real>(cos: T) -> Vec<T> {
    let terms: [Box<dyn Fresnel<T, Color = T>>; 6] = [
        Box::new(Constant::new(T::lit(0.5)).unwrap()),
        Box::new(Schlick::new(T::lit(0.04)).unwrap()),
        Box::new(Dielectric::new(T::lit(0.75)).unwrap()),
        Box::new(Conductor::new(T::lit(0.14), T::lit(3.697)).unwrap()),
        Box::new(Hall::new(T::lit(0.2), T::lit(1.5)).unwrap()),
        Box::new(Cook::new(T::lit(0.2), T::lit(0.5), T::lit(1.5)).unwrap()),
    ];
    let mut answers: Vec<T> = terms.iter().map(|term| term.reflectance(cos)).collect();
    answers.extend(terms.iter().map(|term| term.average()));
    answers
}

#[test]
fn lanes_and_symbols_run_every_term() {
    let cosines = [-1.0, -0.9, -0.3, 0.0, 0.2, 0.5, 0.9, 1.0];
    let lanes = all_terms(Lanes(cosines));
    let symbols = trace(|[cos]| all_terms(cos));
    for (lane, cos) in cosines.into_iter().enumerate() {
        let want: Vec<f64> = all_terms(cos);
        assert_eq!(lanes.iter().map(|answer| answer.0[lane]).collect::<Vec<_>>(), want);
        assert_eq!(symbols([cos]), want);
    }
}
