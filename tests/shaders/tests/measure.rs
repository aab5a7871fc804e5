//! Measures.
use brdf::wgsl::Module;
use brdf::Brdf;
use brdf_checks::directions::pairs_to_grazing;
use brdf_checks::measure::precision::{Quantity, precision};
use brdf_checks::models;
use brdf_shaders::device::Device;
use brdf_shaders::recorded::{Question, Recorded, ask};

#[test]
fn measure() {
    let device = Device::find().unwrap();
    println!("{}", device.name);
    let count: usize = std::env::var("COUNT").map_or(20_000, |c| c.parse().unwrap());
    let pairs: Vec<_> = pairs_to_grazing(count).into_iter().map(|(a, b)| (a.as_vec3(), b.as_vec3())).filter(|(a, b)| a.z > 0.0 && b.z > 0.0).collect();
    let questions: Vec<_> = pairs.iter().map(|&(wi, wo)| Question { wi, wo, u: [(wi.x.abs() * 97.0).fract(), (wo.y.abs() * 89.0).fract()] }).collect();
    let doubles = models::double();
    for ((row, single), double) in models::rows().iter().zip(models::single()).zip(doubles) {
        let mut module = Module::new();
        module.add_described("model", &row.brdf).unwrap();
        let answers = ask(&device, &module.to_string(), &questions, None);
        let recorded = Recorded::new(&questions, &answers);
        let mut line = format!("{:45}", row.name);
        for quantity in [Quantity::Eval, Quantity::Pdf] {
            let f = precision(quantity, &*single.model, &*double.model, &pairs);
            let s = precision(quantity, &recorded, &*double.model, &pairs);
            if s.ratio > 1.0 { let (wi, wo) = s.worst; println!("{quantity:?} {wi} {wo} {:?} {:?} {:?}", recorded.eval(wi, wo), single.model.eval(wi, wo), double.model.eval(wi.as_dvec3(), wo.as_dvec3())); }
            line += &format!(" | med {:.1e}/{:.1e} max {:.2e}/{:.2e} bound {:.2}/{:.2}", s.median, f.median, s.maximum, f.maximum, s.ratio, f.ratio);
        }
        // samples
        let mut errs = [vec![], vec![]];
        let mut same = 0;
        for (q, a) in questions.iter().zip(&answers) {
            let want = double.model.sample(q.wo.as_dvec3(), q.u.map(f64::from));
            let f = single.model.sample(q.wo, q.u);
            same += usize::from(f == a.sample);
            for (errs, got) in errs.iter_mut().zip([&a.sample, &f]) {
                let e = (got.wi.as_dvec3() - want.wi).length().max((got.weight.as_dvec3() - want.weight).abs().max_element() / want.weight.max_element().max(1e-3));
                let e = e.max((f64::from(got.pdf) - double.model.pdf(got.wi.as_dvec3(), q.wo.as_dvec3())).abs() / f64::from(got.pdf).max(1e-6) * 0.1);
                errs.push(if e.is_nan() { 1e9 } else { e });
            }
        }
        for e in &mut errs { e.sort_by(f64::total_cmp); }
        let p = |e: &Vec<f64>, x: f64| e[((e.len() - 1) as f64 * x) as usize];
        let [s, f] = &errs;
        line += &format!(" | sample same {:.2} med {:.1e}/{:.1e} 99.9% {:.1e}/{:.1e} max {:.1e}/{:.1e}", same as f64 / s.len() as f64, p(s, 0.5), p(f, 0.5), p(s, 0.999), p(f, 0.999), p(s, 1.0), p(f, 1.0));
        println!("{line}");
    }
}
