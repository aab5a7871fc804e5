//! Models over the whole sphere: every line, both modes, both layouts, every instruction set.

use brdf::batch::{
    BsdfSampleBuffer, ColorBuffer, DirectionBuffer, Directions, InstructionSet, parallel,
};
use brdf::{Bsdf, BsdfSample, Ggx, RoughDielectric, TransportMode};
use brdf_checks::interfaces::{self, MODES};
use glam::{DVec3, Vec3};

use super::bits::SELECTION;

const LENGTHS: [usize; 7] = [0, 1, 17, 127, 128, 129, 600];

/// Pairs all over the sphere, and among them what is no direction and what lies in the surface.
fn directions() -> Vec<(DVec3, DVec3)> {
    let mut pairs: Vec<_> =
        interfaces::pairs().into_iter().step_by(2).take(LENGTHS[LENGTHS.len() - 1]).collect();
    for (index, odd) in [
        (DVec3::ZERO, DVec3::Z),
        (DVec3::Z, -DVec3::Z),
        (-DVec3::Z, DVec3::X),
        (DVec3::new(f64::NAN, 0.0, 1.0), DVec3::Z),
        (DVec3::Z, DVec3::new(0.0, f64::INFINITY, -1.0)),
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
            let (wi, wo): (Vec<$vector>, Vec<$vector>) =
                directions().into_iter().map(|(wi, wo)| ($narrow(wi), $narrow(wo))).unzip();
            let planes = |vectors: &[$vector]| -> [Vec<$float>; 3] {
                [0, 1, 2].map(|axis| vectors.iter().map(|w| w[axis]).collect())
            };
            let (wi_planes, wo_planes) = (planes(&wi), planes(&wo));
            let u: Vec<[$float; 3]> = (0..wi.len())
                .map(|index| [0.618, 0.755, 0.571].map(|step| (index as $float * step).fract()))
                .collect();
            let u_planes = [0, 1, 2].map(|k| u.iter().map(|u| u[k]).collect::<Vec<$float>>());
            let bits = |values: &[$float]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            let vector_bits = |vectors: &[$vector]| planes(vectors).map(|plane| bits(&plane));
            let mut specular_draws = 0;

            for (entry, mode) in $models.iter().flat_map(|entry| MODES.map(|mode| (entry, mode))) {
                for (name, model) in [("one", &entry.model), ("two", &entry.two_sided)] {
                    let name = format!("{}, {name}, {mode:?}", entry.row.name);
                    let calls = || wi.iter().zip(&wo);
                    let values: Vec<_> =
                        calls().map(|(wi, wo)| model.eval(*wi, *wo, mode)).collect();
                    let pdfs: Vec<_> = calls().map(|(wi, wo)| model.pdf(*wi, *wo, mode)).collect();
                    let samples: Vec<BsdfSample<$float, $vector>> =
                        wo.iter().zip(&u).map(|(wo, u)| model.sample(*wo, *u, mode)).collect();
                    let drawn: Vec<_> = samples.iter().map(|sample| sample.wi).collect();
                    let weights: Vec<_> = samples.iter().map(|sample| sample.weight).collect();
                    let densities: Vec<_> = samples.iter().map(|sample| sample.pdf).collect();
                    let specular: Vec<_> = samples.iter().map(|sample| sample.specular).collect();
                    specular_draws += specular.iter().filter(|specular| **specular).count();
                    for set in InstructionSet::available() {
                        assert!(set.select());
                        for n in LENGTHS {
                            let context = format!("{name}, {n} on {set:?}");
                            let want_value = vector_bits(&values[..n]);
                            let want_sample = (
                                vector_bits(&drawn[..n]),
                                vector_bits(&weights[..n]),
                                bits(&densities[..n]),
                                specular[..n].to_vec(),
                            );

                            // Vectors in and out.
                            let wi_in = (&wi[..n]).into();
                            let wo_in = Directions::from(&wo[..n]);
                            let mut value = vec![$vector::MAX; n];
                            let mut pdf = vec![$float::MAX; n];
                            model.eval_batch(wi_in, wo_in, mode, (&mut value).into()).unwrap();
                            assert_eq!(vector_bits(&value), want_value, "{context}");
                            model.pdf_batch(wi_in, wo_in, mode, &mut pdf).unwrap();
                            assert_eq!(bits(&pdf), bits(&pdfs[..n]), "{context}");
                            let (mut wi_out, mut events) = (value.clone(), vec![true; n]);
                            let buffer = BsdfSampleBuffer {
                                wi: (&mut wi_out).into(),
                                weight: (&mut value).into(),
                                pdf: &mut pdf,
                                specular: &mut events,
                            };
                            model.sample_batch(wo_in, (&u[..n]).into(), mode, buffer).unwrap();
                            let got =
                                (vector_bits(&wi_out), vector_bits(&value), bits(&pdf), events);
                            assert_eq!(got, want_sample, "{context}");

                            // Components in and out.
                            let of = |planes: &'_ [Vec<$float>; 3]| -> [Vec<$float>; 3] {
                                planes.each_ref().map(|plane| plane[..n].to_vec())
                            };
                            let (wi_in, wo_in, u_in) =
                                (of(&wi_planes), of(&wo_planes), of(&u_planes));
                            let wi_in = Directions::from(wi_in.each_ref());
                            let wo_in = Directions::from(wo_in.each_ref());
                            let mut out = [0, 1, 2, 3, 4, 5].map(|_| vec![$float::MAX; n]);
                            let [x, y, z, r, g, b] = &mut out;
                            let buffer = ColorBuffer::from([&mut *r, &mut *g, &mut *b]);
                            model.eval_pdf_batch(wi_in, wo_in, mode, buffer, &mut pdf).unwrap();
                            assert_eq!([bits(r), bits(g), bits(b)], want_value, "{context}");
                            assert_eq!(bits(&pdf), bits(&pdfs[..n]), "{context}");
                            let mut events = vec![true; n];
                            let buffer = BsdfSampleBuffer {
                                wi: DirectionBuffer::Planes([x, y, z]),
                                weight: ColorBuffer::from([&mut *r, &mut *g, &mut *b]),
                                pdf: &mut pdf,
                                specular: &mut events,
                            };
                            let u_in = u_in.each_ref().into();
                            model.sample_batch(wo_in, u_in, mode, buffer).unwrap();
                            let got = (
                                [bits(x), bits(y), bits(z)],
                                [bits(r), bits(g), bits(b)],
                                bits(&pdf),
                                events,
                            );
                            assert_eq!(got, want_sample, "{context}");
                        }
                    }
                }
            }
            assert!(specular_draws > 5000, "{specular_draws}");
        }
    };
}
batches_equal_calls!(
    f32_batches_over_the_sphere_have_the_bits_of_calls,
    interfaces::single(),
    f32,
    Vec3,
    |w: DVec3| w.as_vec3()
);
batches_equal_calls!(
    f64_batches_over_the_sphere_have_the_bits_of_calls,
    interfaces::double(),
    f64,
    DVec3,
    |w: DVec3| w
);

#[test]
fn all_cores_give_the_bits_of_one_over_the_sphere() {
    let count = 2 * 4096 + 77;
    let glass = RoughDielectric::new(Ggx::new(0.3).unwrap(), 1.5).unwrap();
    let pairs = interfaces::pairs().into_iter().cycle().take(count);
    let (wi, wo): (Vec<Vec3>, Vec<Vec3>) =
        pairs.map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3())).unzip();
    let u: Vec<[f32; 3]> = wi.iter().map(|w| [w.x.abs(), w.y.abs(), w.z.abs()]).collect();
    for mode in MODES {
        let (mut values, mut pdf) = (vec![Vec3::MAX; count], vec![f32::MAX; count]);
        let (wi_in, wo_in) = (Directions::from(&wi), Directions::from(&wo));
        parallel::bsdf::eval(&glass, wi_in, wo_in, mode, (&mut values).into()).unwrap();
        parallel::bsdf::pdf(&glass, wi_in, wo_in, mode, &mut pdf).unwrap();
        let (mut both, mut beside) = (vec![Vec3::MAX; count], vec![f32::MAX; count]);
        parallel::bsdf::eval_pdf(&glass, wi_in, wo_in, mode, (&mut both).into(), &mut beside)
            .unwrap();
        assert_eq!((&both, &beside), (&values, &pdf));
        let (mut drawn, mut weight, mut specular) =
            (values.clone(), values.clone(), vec![true; count]);
        let samples = BsdfSampleBuffer {
            wi: (&mut drawn).into(),
            weight: (&mut weight).into(),
            pdf: &mut beside,
            specular: &mut specular,
        };
        parallel::bsdf::sample(&glass, wo_in, (&u).into(), mode, samples).unwrap();
        for index in 0..count {
            let (wi, wo) = (wi[index], wo[index]);
            assert_eq!((values[index], pdf[index]), glass.eval_pdf(wi, wo, mode));
            let got = BsdfSample {
                wi: drawn[index],
                weight: weight[index],
                pdf: beside[index],
                specular: specular[index],
            };
            assert_eq!(got, glass.sample(wo, u[index], mode));
        }
    }
}

#[test]
fn slices_over_the_sphere_of_different_lengths_are_named() {
    let glass = RoughDielectric::new(Ggx::new(0.3_f32).unwrap(), 1.5).unwrap();
    let refused = |u: usize, events: usize| {
        let (mut wi, mut weight, mut pdf) = ([Vec3::MAX; 5], [Vec3::MAX; 5], [0.0; 5]);
        let samples = BsdfSampleBuffer {
            wi: (&mut wi).into(),
            weight: (&mut weight).into(),
            pdf: &mut pdf,
            specular: &mut vec![false; events],
        };
        let (long, short) = ([0.5_f32; 5], vec![0.5_f32; u]);
        let u = [&long[..], &long[..], &short[..]].into();
        let error = glass.sample_batch(Vec3::Z.into(), u, TransportMode::Radiance, samples);
        assert_eq!((wi, weight), ([Vec3::MAX; 5], [Vec3::MAX; 5]));
        error.unwrap_err().to_string()
    };
    assert_eq!(refused(6, 5), "samples.pdf has 5 elements, but u[2] has 6");
    assert_eq!(refused(5, 4), "samples.pdf has 5 elements, but samples.specular has 4");
}
