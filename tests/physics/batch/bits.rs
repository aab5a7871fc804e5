//! Every model of the registry, both layouts, every instruction set, lengths around the sizes of
//! registers and blocks.

use std::sync::Mutex;

use brdf::batch::{ColorBuffer, DirectionBuffer, Directions, InstructionSet, SampleBuffer};
use glam::{DVec3, Vec3};

use brdf_checks::directions::pairs;
use brdf_checks::models;

const LENGTHS: [usize; 9] = [0, 1, 15, 16, 17, 127, 128, 129, 1000];

/// The selected instruction set is one for the whole program.
pub(crate) static SELECTION: Mutex<()> = Mutex::new(());

/// Pairs above the surface, and among them what is no direction and what is none above.
fn directions(count: usize) -> Vec<(DVec3, DVec3)> {
    let mut pairs = pairs(count);
    for (index, odd) in [
        (DVec3::ZERO, DVec3::Z),
        (DVec3::Z, -DVec3::Z),
        (DVec3::new(f64::NAN, 0.0, 1.0), DVec3::Z),
        (DVec3::new(1e30, 0.0, 1.0), DVec3::new(0.0, f64::INFINITY, 1.0)),
        (DVec3::Z, DVec3::Z),
    ]
    .into_iter()
    .enumerate()
    {
        pairs[7 * index] = odd;
    }
    pairs
}

macro_rules! batches_equal_calls {
    ($test:ident, $models:expr, $float:ident, $vector:ident, $narrow:expr) => {
        #[test]
        fn $test() {
            let _alone = SELECTION.lock().unwrap();
            let (wi, wo): (Vec<$vector>, Vec<$vector>) = directions(LENGTHS[LENGTHS.len() - 1])
                .into_iter()
                .map(|(wi, wo)| ($narrow(wi), $narrow(wo)))
                .unzip();
            let planes = |vectors: &[$vector]| -> [Vec<$float>; 3] {
                [0, 1, 2].map(|axis| vectors.iter().map(|w| w[axis]).collect())
            };
            let ([wi_x, wi_y, wi_z], [wo_x, wo_y, wo_z]) = (planes(&wi), planes(&wo));
            let u: Vec<[$float; 2]> = (0..wi.len())
                .map(|index| [0.618, 0.755].map(|step| (index as $float * step).fract()))
                .collect();
            let [u0, u1] = [0, 1].map(|k| u.iter().map(|u| u[k]).collect::<Vec<$float>>());
            let bits = |values: &[$float]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            let vector_bits = |vectors: &[$vector]| planes(vectors).map(|plane| bits(&plane));

            for entry in $models {
                let (name, model) = (entry.name, &entry.model);
                let calls = || wi.iter().zip(&wo);
                let values: Vec<_> = calls().map(|(wi, wo)| model.eval(*wi, *wo)).collect();
                let densities: Vec<_> = calls().map(|(wi, wo)| model.pdf(*wi, *wo)).collect();
                let samples: Vec<_> =
                    wo.iter().zip(&u).map(|(wo, u)| model.sample(*wo, *u)).collect();
                for set in InstructionSet::available() {
                    assert!(set.select());
                    assert_eq!(InstructionSet::selected(), set);
                    for n in LENGTHS {
                        let context = format!("{name}, {n} on {set:?}");
                        let want_value = vector_bits(&values[..n]);
                        let want_pdf = bits(&densities[..n]);
                        let drawn: Vec<_> = samples[..n].iter().map(|s| s.wi).collect();
                        let weights: Vec<_> = samples[..n].iter().map(|s| s.weight).collect();
                        let pdfs: Vec<_> = samples[..n].iter().map(|s| s.pdf).collect();
                        let want_sample = (vector_bits(&drawn), vector_bits(&weights), bits(&pdfs));

                        // Vectors in and out.
                        let mut value = vec![$vector::MAX; n];
                        let (wi_in, wo_in) = ((&wi[..n]).into(), Directions::from(&wo[..n]));
                        model.eval_batch(wi_in, wo_in, (&mut value).into()).unwrap();
                        assert_eq!(vector_bits(&value), want_value, "{context}");
                        let mut pdf = vec![$float::MAX; n];
                        model.pdf_batch(wi_in, wo_in, &mut pdf).unwrap();
                        assert_eq!(bits(&pdf), want_pdf, "{context}");
                        let (mut drawn, mut weight) = (value.clone(), value.clone());
                        let buffer = SampleBuffer {
                            wi: (&mut drawn).into(),
                            weight: (&mut weight).into(),
                            pdf: &mut pdf,
                        };
                        model.sample_batch(wo_in, (&u[..n]).into(), buffer).unwrap();
                        let got = (vector_bits(&drawn), vector_bits(&weight), bits(&pdf));
                        assert_eq!(got, want_sample, "{context}");

                        // Components in and out.
                        let wi_in = Directions::Planes([&wi_x[..n], &wi_y[..n], &wi_z[..n]]);
                        let wo_in = Directions::Planes([&wo_x[..n], &wo_y[..n], &wo_z[..n]]);
                        let mut planes = [0, 1, 2, 3, 4, 5].map(|_| vec![$float::MAX; n]);
                        let [x, y, z, r, g, b] = &mut planes;
                        let buffer = ColorBuffer::from([&mut *r, &mut *g, &mut *b]);
                        model.eval_batch(wi_in, wo_in, buffer).unwrap();
                        assert_eq!([bits(r), bits(g), bits(b)], want_value, "{context}");
                        let buffer = SampleBuffer {
                            wi: DirectionBuffer::Planes([x, y, z]),
                            weight: ColorBuffer::from([&mut *r, &mut *g, &mut *b]),
                            pdf: &mut pdf,
                        };
                        let u_in = [&u0[..n], &u1[..n]].into();
                        model.sample_batch(wo_in, u_in, buffer).unwrap();
                        let got =
                            ([bits(x), bits(y), bits(z)], [bits(r), bits(g), bits(b)], bits(&pdf));
                        assert_eq!(got, want_sample, "{context}");
                    }
                    // One viewer for all.
                    let (viewer, mut pdf) = (wo[100], vec![$float::MAX; wi.len()]);
                    model.pdf_batch((&wi).into(), viewer.into(), &mut pdf).unwrap();
                    let want: Vec<_> = wi.iter().map(|wi| model.pdf(*wi, viewer)).collect();
                    assert_eq!(bits(&pdf), bits(&want), "{name} seen from {viewer}");
                }
            }
        }
    };
}
batches_equal_calls!(
    f32_batches_have_the_bits_of_calls,
    models::single(),
    f32,
    Vec3,
    |w: DVec3| w.as_vec3()
);
batches_equal_calls!(
    f64_batches_have_the_bits_of_calls,
    models::double(),
    f64,
    DVec3,
    |w: DVec3| w
);

/// Colours with one, four and seven channels.
#[test]
fn every_number_of_channels_has_the_bits_of_calls() {
    use brdf::{Beckmann, Brdf, Color, Conductor, CookTorrance, Lambert, Spectrum};

    fn check<C: Color<f64> + PartialEq>(
        model: &impl Brdf<f64, Color = C>,
        wi: &[DVec3],
        wo: &[DVec3],
    ) {
        let want: Vec<C> = wi.iter().zip(wo).map(|(wi, wo)| model.eval(*wi, *wo)).collect();
        let mut values = vec![C::splat(-1.0); wi.len()];
        model.eval_batch(wi.into(), wo.into(), (&mut values).into()).unwrap();
        assert!(values == want);
    }
    let (wi, wo): (Vec<_>, Vec<_>) = pairs(200).into_iter().unzip();
    let beckmann = Beckmann::new(0.3).unwrap();
    let four = [1.38, 0.43, 0.29, 0.14];
    let seven = [1.38, 0.43, 0.29, 0.14, 0.7, 2.0, 0.9];
    let (k4, k7) = (four.map(|eta| 3.0 - eta), seven.map(|eta| 3.0 - eta));
    check(&CookTorrance::new(beckmann, Conductor::new(0.14, 3.7).unwrap()), &wi, &wo);
    let gold = Conductor::new(Spectrum(four), Spectrum(k4)).unwrap();
    check(&CookTorrance::new(beckmann, gold), &wi, &wo);
    let gold = Conductor::new(Spectrum(seven), Spectrum(k7)).unwrap();
    check(&CookTorrance::new(beckmann, gold), &wi, &wo);
    check(&Lambert::new(Spectrum(seven.map(|eta| eta * 0.5))).unwrap(), &wi, &wo);
}
