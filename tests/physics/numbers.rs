//! Each formula runs on every kind of number, and says the same on all of them.

use brdf::{Lanes, Vector3};
use brdf_checks::directions::{pairs, pairs_to_grazing};
use brdf_checks::models;
use brdf_checks::traced::{Traced, trace};
use glam::{DVec3, Vec3};

/// A model runs once on symbols; playing the record gives what the model gives.
#[test]
fn every_model_can_be_traced() {
    for (row, model) in models::rows().iter().zip(models::double()) {
        let record = trace(|[ix, iy, iz, ox, oy, oz, u0, u1]: [Traced; 8]| {
            // Built here, so that its parameters are on the tape of this record.
            let entry = row.traced();
            let (wi, wo) = (Vector3 { x: ix, y: iy, z: iz }, Vector3 { x: ox, y: oy, z: oz });
            let value = entry.model.eval(wi, wo);
            let pdf = entry.model.pdf(wi, wo);
            let sample = entry.model.sample(wo, [u0, u1]);
            let mut outputs = vec![value.x, value.y, value.z, pdf, sample.pdf];
            outputs.extend([sample.wi.x, sample.wi.y, sample.wi.z]);
            outputs.extend([sample.weight.x, sample.weight.y, sample.weight.z]);
            outputs
        });
        for (index, (wi, wo)) in pairs(200).into_iter().enumerate() {
            let u = [(index as f64 * 0.618) % 1.0, (index as f64 * 0.755) % 1.0];
            let got = record([wi.x, wi.y, wi.z, wo.x, wo.y, wo.z, u[0], u[1]]);
            let (value, pdf) = (model.model.eval(wi, wo), model.model.pdf(wi, wo));
            let sample = model.model.sample(wo, u);
            let mut want = vec![value.x, value.y, value.z, pdf, sample.pdf];
            want.extend(sample.wi.to_array());
            want.extend(sample.weight.to_array());
            assert_eq!(got, want, "{} at {wi} {wo} {u:?}", model.name);
        }
    }
}

/// Lanes have the bits of the scalar formula, also those of a lifted model.
macro_rules! lanes_equal_scalars {
    ($test:ident, $lanes:expr, $scalars:expr, [$float:ident; $n:literal], $vector:ident, $narrow:expr) => {
        #[test]
        fn $test() {
            const N: usize = $n;
            let pairs: Vec<($vector, $vector)> = pairs_to_grazing(1024)
                .into_iter()
                .map(|(wi, wo)| ($narrow(wi), $narrow(wo)))
                .collect();
            let gather = |lanes: &[$vector]| Vector3 {
                x: Lanes::<$float, N>(std::array::from_fn(|lane| lanes[lane].x)),
                y: Lanes(std::array::from_fn(|lane| lanes[lane].y)),
                z: Lanes(std::array::from_fn(|lane| lanes[lane].z)),
            };
            for (lanes, scalar) in $lanes.iter().flat_map(|lanes| lanes.iter().zip($scalars)) {
                for (index, chunk) in pairs.chunks_exact(N).enumerate() {
                    let (wi, wo): (Vec<$vector>, Vec<$vector>) = chunk.iter().copied().unzip();
                    let u: [[$float; N]; 2] = [wi.iter(), wo.iter()].map(|w| {
                        let mut u = w.map(|w| (w.x.abs() * 97.0).fract());
                        std::array::from_fn(|_| u.next().unwrap())
                    });
                    let value = lanes.model.eval(gather(&wi), gather(&wo));
                    let pdf = lanes.model.pdf(gather(&wi), gather(&wo));
                    let sample = lanes.model.sample(gather(&wo), u.map(Lanes));
                    // An albedo takes thousands of values: a few directions are enough.
                    let albedo = (index % 64 == 0).then(|| lanes.model.albedo(gather(&wo)));
                    for lane in 0..N {
                        let at = |v: Vector3<Lanes<$float, N>>| {
                            [v.x.0[lane].to_bits(), v.y.0[lane].to_bits(), v.z.0[lane].to_bits()]
                        };
                        let bits = |v: $vector| v.to_array().map($float::to_bits);
                        let (wi, wo) = (wi[lane], wo[lane]);
                        let context = format!("{} at {wi} {wo}", scalar.name);
                        assert_eq!(at(value), bits(scalar.model.eval(wi, wo)), "{context}");
                        if let Some(albedo) = albedo {
                            assert_eq!(at(albedo), bits(scalar.model.albedo(wo)), "{context}");
                        }
                        let want = scalar.model.pdf(wi, wo);
                        assert_eq!(pdf.0[lane].to_bits(), want.to_bits(), "{context}");
                        let want = scalar.model.sample(wo, u.map(|u| u[lane]));
                        assert_eq!(at(sample.wi), bits(want.wi), "{context}");
                        assert_eq!(at(sample.weight), bits(want.weight), "{context}");
                        assert_eq!(sample.pdf.0[lane].to_bits(), want.pdf.to_bits(), "{context}");
                    }
                }
            }
        }
    };
}
lanes_equal_scalars!(
    f32_lanes_have_the_bits_of_scalars,
    models::single_lanes(),
    models::single(),
    [f32; 4],
    Vec3,
    |w: DVec3| w.as_vec3()
);
lanes_equal_scalars!(
    f64_lanes_have_the_bits_of_scalars,
    models::double_lanes(),
    models::double(),
    [f64; 2],
    DVec3,
    |w: DVec3| w
);
