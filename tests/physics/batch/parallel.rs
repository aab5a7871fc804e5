//! All cores say what one says.

use brdf::batch::{ColorBuffer, DirectionBuffer, Directions, SampleBuffer, parallel};
use brdf::{Beckmann, Brdf, CookTorrance, Schlick};
use glam::Vec3;

use brdf_checks::directions::pairs;

#[test]
fn any_number_of_threads_gives_the_bits_of_one() {
    let count = 3 * 4096 + 77;
    let (wi, wo): (Vec<_>, Vec<_>) =
        pairs(count).into_iter().map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3())).unzip();
    let u: Vec<[f32; 2]> = wi.iter().map(|w| [w.x.abs(), w.y.abs()]).collect();
    let model =
        CookTorrance::new(Beckmann::new(0.3).unwrap(), Schlick::new(Vec3::splat(0.5)).unwrap());
    let values: Vec<Vec3> = wi.iter().zip(&wo).map(|(wi, wo)| model.eval(*wi, *wo)).collect();
    let densities: Vec<f32> = wi.iter().zip(&wo).map(|(wi, wo)| model.pdf(*wi, *wo)).collect();
    let samples: Vec<_> = wo.iter().zip(&u).map(|(wo, u)| model.sample(*wo, *u)).collect();
    for threads in [1, 2, 3, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let (wi_in, wo_in) = (Directions::from(&wi), Directions::from(&wo));
            let (mut value, mut pdf) = (vec![Vec3::MAX; count], vec![f32::MAX; count]);
            parallel::eval(&model, wi_in, wo_in, (&mut value).into()).unwrap();
            assert_eq!(value, values);
            parallel::pdf(&model, wi_in, wo_in, &mut pdf).unwrap();
            assert_eq!(pdf, densities);
            let mut planes = [0, 1, 2, 3, 4, 5].map(|_| vec![f32::MAX; count]);
            let [x, y, z, r, g, b] = &mut planes;
            let buffer = SampleBuffer {
                wi: DirectionBuffer::Planes([x, y, z]),
                weight: ColorBuffer::from([r, g, b]),
                pdf: &mut pdf,
            };
            parallel::sample(&model, wo_in, (&u).into(), buffer).unwrap();
            for (index, want) in samples.iter().enumerate() {
                let [x, y, z, r, g, b] = [0, 1, 2, 3, 4, 5].map(|plane| planes[plane][index]);
                assert_eq!(Vec3::new(x, y, z), want.wi);
                assert_eq!(Vec3::new(r, g, b), want.weight);
                assert_eq!(pdf[index], want.pdf);
            }
        });
    }
    let error = parallel::pdf(&model, (&wi).into(), (&wo[1..]).into(), &mut vec![0.0; count]);
    assert!(error.unwrap_err().to_string().contains("but wo has"));
}
