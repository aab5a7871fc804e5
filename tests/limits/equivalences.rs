//! Models that are other models at the ends of their parameters, and the same model written in
//! another way.

use std::f64::consts::TAU;
use std::sync::Arc;

use brdf::{
    AnyBrdf, Beckmann, Blinn, Blinn1977, Blinn1977Printed, BlinnPhong, Brdf, ClassicPhong,
    Conductor, Constant, Cook, CookTorrance, Dielectric, Distribution, Fresnel, Gaussian, Ggx,
    Hall, Lambert, Mixture, OrenNayar, Pair, Phong, Schlick, SchlickPower, Shadowing, Smith,
    SmithCorrelated, SmithSeparable, SumOfTwo, VCavity, WeightedSum, fresnel::normal_incidence,
    from_spherical,
};
use glam::DVec3;

use crate::hemisphere::Model;
use brdf_checks::directions::pairs_to_grazing;

type Color64 = dyn Brdf<f64, Color = f64>;

const ULP: f64 = f64::EPSILON;

/// Equal up to `tolerance` relative to the larger. Deep in a tail both are zero to all purposes.
fn assert_close(context: &str, a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * a.max(b) + 1e-200, "{context}: {a:e}, {b:e}");
}

fn assert_same_values(what: &str, one: &Color64, other: &Color64, tolerance: f64) {
    for (wi, wo) in pairs_to_grazing(2000) {
        let context = format!("{what} at {wi} {wo}");
        assert_close(&context, one.eval(wi, wo), other.eval(wi, wo), tolerance);
    }
}

/// Values and densities; samples too, where nothing may differ.
fn assert_same(what: &str, one: &Color64, other: &Color64, tolerance: f64) {
    assert_same_values(what, one, other, tolerance);
    for (index, (wi, wo)) in pairs_to_grazing(2000).into_iter().enumerate() {
        let context = format!("density of {what} at {wi} {wo}");
        assert_close(&context, one.pdf(wi, wo), other.pdf(wi, wo), tolerance);
        if tolerance == 0.0 {
            let u = [index as f64 / 2000.0, (index as f64 * 0.618).fract()];
            assert_eq!(one.sample(wo, u), other.sample(wo, u), "{what}: sample of {wo} by {u:?}");
        }
    }
}

/// A model behind a pointer, and one of parts behind pointers, is that model to the last bit.
#[test]
fn pointers_change_nothing() {
    let gold = Conductor::new(0.43, 2.455).unwrap();
    let ggx = Ggx::anisotropic(0.1, 0.4).unwrap();
    let direct = CookTorrance::new(ggx, gold).with_shadowing(SmithCorrelated);
    let boxed: Model = Box::new(direct);
    assert_same("Box<dyn Brdf>", &direct, &boxed, 0.0);
    let shared: Arc<Color64> = Arc::new(direct);
    assert_same("Arc<dyn Brdf>", &direct, &*shared, 0.0);

    let normals: Box<dyn Smith<f64>> = Box::new(ggx);
    let term: Box<dyn Fresnel<f64, Color = f64>> = Box::new(gold);
    let shadowing: Box<dyn Shadowing<f64, Box<dyn Smith<f64>>>> = Box::new(SmithCorrelated);
    let parts = CookTorrance::new(normals, term).with_shadowing(shadowing);
    assert_same("parts behind pointers", &direct, &parts, 0.0);
    for (index, (_, wo)) in pairs_to_grazing(200).into_iter().enumerate() {
        assert_eq!(direct.albedo(wo), boxed.albedo(wo), "{index}");
    }
}

/// Terms that add up to one material, in any grouping.
#[test]
fn sums_and_mixtures_of_the_same_are_the_same() {
    let lobe = || Phong::new(0.9, 12.0).unwrap();
    let halves = WeightedSum::new([(0.25, lobe()), (0.75, lobe())]).unwrap();
    assert_same("a sum of equal terms", &lobe(), &halves, 2.0 * ULP);

    let term = |weight: f64, model: Model| (weight, model);
    let inner = WeightedSum::new([
        term(0.5, Box::new(Lambert::new(0.6).unwrap())),
        term(0.5, Box::new(lobe())),
    ]);
    let nested = WeightedSum::new([
        term(0.5, Box::new(inner.unwrap())),
        term(0.5, Box::new(SchlickPower::new(0.8, 30.0).unwrap())),
    ]);
    let flat = WeightedSum::new([
        term(0.25, Box::new(Lambert::new(0.6).unwrap())),
        term(0.25, Box::new(lobe())),
        term(0.5, Box::new(SchlickPower::new(0.8, 30.0).unwrap())),
    ]);
    assert_same("a nested sum", &nested.unwrap(), &flat.unwrap(), 4.0 * ULP);

    let white = Constant::new(1.0).unwrap();
    let ggx = Ggx::new(0.3).unwrap();
    let mixed = Mixture::new([(0.25, ggx), (0.75, ggx)]).unwrap();
    assert_same(
        "a mixture of equal terms",
        &CookTorrance::new(ggx, white).with_shadowing(SmithCorrelated),
        &CookTorrance::new(mixed, white).with_shadowing(SmithCorrelated),
        8.0 * ULP,
    );
    let one = Mixture::new([(1.0, ggx)]).unwrap();
    assert_same(
        "a mixture of one",
        &CookTorrance::new(ggx, white).with_shadowing(SmithCorrelated),
        &CookTorrance::new(one, white).with_shadowing(SmithCorrelated),
        0.0,
    );
    // V-cavities do not know the distribution: the mixture is the sum.
    let (narrow, wide) = (Beckmann::new(0.1).unwrap(), Beckmann::new(0.5).unwrap());
    let mixed = Mixture::new([(0.25, narrow), (0.75, wide)]).unwrap();
    let sum = WeightedSum::new([
        (0.25, CookTorrance::from_parts(narrow, white, VCavity)),
        (0.75, CookTorrance::from_parts(wide, white, VCavity)),
    ]);
    let mixed = CookTorrance::from_parts(mixed, white, VCavity);
    assert_same("a mixture in V-cavities", &mixed, &sum.unwrap(), 8.0 * ULP);
}

/// A sum of known types is the sum in a list, call by call and block by block.
#[test]
fn a_sum_of_two_is_the_sum_of_a_list() {
    let coat = CookTorrance::new(Ggx::new(0.2).unwrap(), Schlick::new(0.04).unwrap());
    let base = Lambert::new(0.7).unwrap();
    let dust = OrenNayar::new(0.5, 0.4).unwrap();
    for (base_weight, coat_weight) in [(0.9, 0.1), (0.5, 0.5), (0.0, 1.0), (1.0, 0.0)] {
        let two = SumOfTwo::new((base_weight, base), (coat_weight, coat)).unwrap();
        let terms: [(f64, Model); 2] =
            [(base_weight, Box::new(base)), (coat_weight, Box::new(coat))];
        let list = WeightedSum::new(terms).unwrap();
        assert_same("a sum of two", &two, &list, 0.0);
        assert_eq!(two.albedo(DVec3::Z), list.albedo(DVec3::Z));
        let any: AnyBrdf<f64, f64> = two.into();
        assert_same("any sum of two", &any, &list, 0.0);

        let three = SumOfTwo::new((0.8, two), (0.2, dust)).unwrap();
        let (wi, wo): (Vec<_>, Vec<_>) = pairs_to_grazing(300).into_iter().unzip();
        let (mut values, mut pdf) = (vec![0.0; wi.len()], vec![0.0; wi.len()]);
        three.eval_pdf_batch((&wi).into(), (&wo).into(), (&mut values).into(), &mut pdf).unwrap();
        for (index, (wi, wo)) in wi.into_iter().zip(wo).enumerate() {
            assert_eq!((values[index], pdf[index]), three.eval_pdf(wi, wo));
        }
    }
    assert!(SumOfTwo::new((0.0, base), (0.0, coat)).is_err());
    assert!(SumOfTwo::new((-1.0, base), (1.0, coat)).is_err());
}

#[test]
fn equal_roughness_along_both_axes_is_isotropic() {
    let gold = Conductor::new(0.43, 2.455).unwrap();
    let (one, two) = (Ggx::new(0.2).unwrap(), Ggx::anisotropic(0.2, 0.2).unwrap());
    assert_same("GGX", &CookTorrance::new(one, gold), &CookTorrance::new(two, gold), 0.0);
    let one = CookTorrance::new(Beckmann::new(0.2).unwrap(), gold);
    let two = CookTorrance::new(Beckmann::anisotropic(0.2, 0.2).unwrap(), gold);
    assert_same("Beckmann", &one, &two, 0.0);
    let (one, two) = (one.with_shadowing(SmithCorrelated), two.with_shadowing(SmithCorrelated));
    assert_same("Beckmann, Smith", &one, &two, 0.0);
    // Grain that is turned with both directions is the grain itself.
    let grain = CookTorrance::new(Ggx::anisotropic(0.1, 0.5).unwrap(), gold);
    let across = CookTorrance::new(Ggx::anisotropic(0.5, 0.1).unwrap(), gold);
    for (wi, wo) in pairs_to_grazing(2000) {
        let turned = |w: DVec3| DVec3::new(-w.y, w.x, w.z);
        assert_eq!(grain.eval(wi, wo), across.eval(turned(wi), turned(wo)), "{wi} {wo}");
    }
}

/// Distributions that are constant at one end of their parameter are there the same one.
#[test]
fn constant_distributions_are_the_same() {
    let white = Constant::new(1.0).unwrap();
    let ggx = CookTorrance::from_parts(Ggx::new(1.0).unwrap(), white, VCavity);
    let blinn = CookTorrance::new(Blinn::new(0.0).unwrap(), white);
    assert_same("GGX 1, Blinn 0", &ggx, &blinn, 8.0 * ULP);
    // exp(−α²/m²) is 1 but for (π/2)²/10⁸.
    let gaussian = CookTorrance::new(Gaussian::new(1e4).unwrap(), white);
    assert_same("GGX 1, Gaussian 10⁴", &ggx, &gaussian, 3e-8);
}

/// The three distributions of 1977 are the modern ones of the same parameter.
#[test]
fn blinns_distributions_are_the_modern_ones() {
    let gold = Conductor::new(0.43, 2.455).unwrap();
    let half_width = 0.3;
    let printed = Blinn1977::new(half_width).unwrap();
    let check = |what: &str, old: &Color64, modern: &Color64, at_normal: f64| {
        for (wi, wo) in pairs_to_grazing(1000) {
            let (got, want) = (old.eval(wi, wo), modern.eval(wi, wo) * 4.0 / at_normal);
            assert_close(what, got, want, 4.0 * ULP);
        }
    };
    let blinn = Blinn::new(printed.c1()).unwrap();
    let modern = CookTorrance::from_parts(blinn, gold, VCavity);
    let old = Blinn1977Printed::d1(printed, gold).unwrap();
    check("D₁", &old, &modern, blinn.density(DVec3::Z));
    let gaussian = Gaussian::new(1.0 / printed.c2()).unwrap();
    let modern = CookTorrance::from_parts(gaussian, gold, VCavity);
    let old = Blinn1977Printed::d2(printed, gold).unwrap();
    check("D₂", &old, &modern, gaussian.density(DVec3::Z));
    let ggx = Ggx::new(printed.c3()).unwrap();
    let modern = CookTorrance::from_parts(ggx, gold, VCavity);
    let old = Blinn1977Printed::d3(printed, gold).unwrap();
    check("D₃", &old, &modern, ggx.density(DVec3::Z));
    for step in 0..90 {
        let alpha = f64::from(step).to_radians();
        let h = from_spherical(alpha, 0.4);
        let shapes = [
            (printed.d1(alpha), blinn.density(h) / blinn.density(DVec3::Z)),
            (printed.d2(alpha), gaussian.density(h) / gaussian.density(DVec3::Z)),
            (printed.d3(alpha), ggx.density(h) / ggx.density(DVec3::Z)),
        ];
        for (got, want) in shapes {
            assert!((got - want).abs() <= 1e-13 * want, "{alpha}: {got} {want}");
        }
    }
}

/// The lobes around the mirror direction, of the same exponent.
#[test]
fn lobes_meet_at_small_exponents() {
    let phong = |n| Phong::new(0.8, n).unwrap();
    let schlick = |n| SchlickPower::new(0.8, n).unwrap();
    // S/(h − hS + S) is S for h = 1.
    assert_same_values("exponent 1", &phong(1.0), &schlick(1.0), 8.0 * ULP);
    // One lobe of 1975 times its constant and the cosine.
    for n in [0.0, 1.0, 20.0, 3000.0] {
        let classic = ClassicPhong::new(0.8, n).unwrap();
        for (wi, wo) in pairs_to_grazing(1000) {
            let (got, want) =
                (classic.eval(wi, wo) * wi.z * (n + 2.0) / TAU, phong(n).eval(wi, wo));
            assert_close(&format!("exponent {n}"), got, want, 4.0 * ULP);
            assert_eq!(classic.pdf(wi, wo), phong(n).pdf(wi, wo));
        }
    }
    for n in [0.0, 1.0, 20.0, 3000.0] {
        let (lobe, blinn) = (BlinnPhong::new(0.8, n).unwrap(), Blinn::new(n).unwrap());
        for (wi, wo) in pairs_to_grazing(1000) {
            // Half vectors are drawn as the distribution of the same power has them.
            let pair = Pair::<f64>::new(wi, wo);
            let want = blinn.density(pair.h) * pair.cos_h / (4.0 * pair.cos_d);
            let got = lobe.pdf(wi, wo);
            assert_close(&format!("exponent {n}"), got, want, 1e-12);
        }
    }
    let lambert = Lambert::new(0.8).unwrap();
    assert_same_values("exponent 0", &BlinnPhong::new(0.8, 0.0).unwrap(), &lambert, 4.0 * ULP);
}

/// Terms of Fresnel that are others at the ends of their parameters, as whole materials.
#[test]
fn reflectances_reduce_to_each_other() {
    let ggx = Ggx::new(0.3).unwrap();
    let glass = Dielectric::new(1.5).unwrap();
    let of_glass = CookTorrance::new(ggx, glass);
    let transparent = CookTorrance::new(ggx, Conductor::new(1.5, 0.0).unwrap());
    assert_same("k = 0", &of_glass, &transparent, 1e-13);
    let f0 = normal_incidence(1.5, 0.0);
    let hall = CookTorrance::new(ggx, Hall::new(f0, 1.5).unwrap());
    assert_same("Hall of its own reference", &of_glass, &hall, 1e-13);
    let cook = CookTorrance::new(ggx, Cook::new(f0, 1.0, 1.5).unwrap());
    assert_same("Cook of white light", &of_glass, &cook, 1e-13);
    let white = CookTorrance::new(ggx, Constant::new(1.0).unwrap());
    assert_same("Schlick of 1", &white, &CookTorrance::new(ggx, Schlick::new(1.0).unwrap()), ULP);
    assert_same("Hall of 1", &white, &CookTorrance::new(ggx, Hall::new(1.0, 1.5).unwrap()), ULP);
    for (wi, wo) in pairs_to_grazing(1000) {
        let grey = CookTorrance::new(ggx, Constant::new(0.25).unwrap());
        assert_eq!(grey.eval(wi, wo), 0.25 * white.eval(wi, wo), "the reflectance is a factor");
    }
}

/// Without slopes nothing is hidden: all shadowings agree away from the horizon, and a material
/// reflects what its facets reflect.
#[test]
fn without_roughness_the_reflectance_remains() {
    let gold = Conductor::new(0.43, 2.455).unwrap();
    for roughness in [1e-6, 1e-4] {
        let ggx = CookTorrance::from_parts(Ggx::new(roughness).unwrap(), gold, VCavity);
        let beckmann = CookTorrance::from_parts(Beckmann::new(roughness).unwrap(), gold, VCavity);
        let gaussian = CookTorrance::new(Gaussian::new(roughness).unwrap(), gold);
        for degrees in [0.0_f64, 30.0, 60.0, 80.0] {
            let wo = from_spherical(degrees.to_radians(), 0.4);
            let want = gold.reflectance(wo.z);
            for model in [&ggx as &Color64, &beckmann, &gaussian] {
                let got = model.albedo(wo);
                assert!((got / want - 1.0).abs() < 5e-4, "{roughness} {degrees}°: {got} {want}");
            }
            let mirror = DVec3::new(-wo.x, -wo.y, wo.z);
            let [none, correlated, separable] = [
                ggx.eval(mirror, wo),
                ggx.with_shadowing(SmithCorrelated).eval(mirror, wo),
                ggx.with_shadowing(SmithSeparable).eval(mirror, wo),
            ];
            // Λ = a² tan²θ/4, twice.
            let hidden = 0.51 * (roughness * degrees.to_radians().tan()).powi(2) + 4.0 * ULP;
            assert!((correlated / none - 1.0).abs() <= hidden, "{correlated} {none}");
            assert!((separable / none - 1.0).abs() <= hidden, "{separable} {none}");
        }
    }
}

/// Seen along the normal no facet is masked: all shadowings of random surfaces are G₁ of the light.
#[test]
fn shadowings_agree_along_the_normal() {
    let ggx = Ggx::new(0.7).unwrap();
    for step in 0..90 {
        let wi = from_spherical(f64::from(step).to_radians(), 0.3);
        let pair = Pair::new(wi, DVec3::Z);
        let correlated: f64 = SmithCorrelated.visibility(&ggx, &pair);
        let separable = SmithSeparable.visibility(&ggx, &pair);
        assert!((correlated / separable - 1.0).abs() <= 4.0 * ULP, "{step}°");
        // In a V-cavity light is shadowed from 60° on, where 2 (N·h)(N·wi) < wi·h.
        let v_cavity = VCavity.visibility(&ggx, &pair) * 4.0 * pair.cos_i;
        let alpha = 0.5 * f64::from(step).to_radians();
        let want = (2.0 * (2.0 * alpha).cos()).min(1.0);
        assert!((v_cavity - want).abs() < 1e-14, "{step}°: {v_cavity} {want}");
    }
}
