//! A described model is the model: the same bits as the one that is constructed directly.

use std::fmt::Debug;

use brdf::description::{BrdfDescription, DistributionDescription, FresnelDescription};
use brdf::{
    Beckmann, Blinn, Blinn1977, Blinn1977Printed, BlinnPhong, Brdf, ClassicPhong, Color, Conductor,
    Constant, Cook, CookTorrance, CookTorrance1982Printed, Dielectric, Distribution, Fresnel,
    Gaussian, GeneralSchlick, Ggx, Hall, Lambert, Mixture, OrenNayar, ParameterError, Phong, Real,
    Schlick, SchlickPower, SmithCorrelated, SmithSeparable, VCavity, Vector, WeightedSum,
    from_spherical,
};

/// Pairs of directions: over all the hemisphere, mirrored, at grazing, and below.
fn directions<T: Real>() -> Vec<(T::Vec3, T::Vec3)> {
    let at = |theta: f64, phi: f64| from_spherical(T::lit(theta), T::lit(phi));
    vec![
        (at(0.0, 0.0), at(0.0, 0.0)),
        (at(0.3, 0.4), at(0.5, 2.4)),
        (at(0.9, 0.0), at(0.85, 3.0)),
        (at(1.5, 1.0), at(1.4, 4.5)),
        (at(0.2, 5.0), at(1.2, 1.0)),
        (at(2.0, 5.0), at(1.2, 1.0)),
    ]
}

fn numbers<T: Real>() -> Vec<[T; 2]> {
    [[0.0, 0.0], [0.1, 0.9], [0.35, 0.2], [0.5, 0.5], [0.77, 0.01], [0.999, 0.999]]
        .map(|[a, b]| [T::lit(a), T::lit(b)])
        .to_vec()
}

fn same_model<T: Real + PartialEq>(text: &str, direct: impl Brdf<T, Color = T::Vec3>)
where
    T::Vec3: PartialEq,
{
    let description: BrdfDescription = serde_json::from_str(text).expect(text);
    let built = description.build::<T>().expect(text);
    for (wi, wo) in directions::<T>() {
        assert_eq!(built.eval(wi, wo), direct.eval(wi, wo), "{text}: eval({wi:?}, {wo:?})");
        assert_eq!(built.pdf(wi, wo), direct.pdf(wi, wo), "{text}: pdf({wi:?}, {wo:?})");
        for u in numbers() {
            assert_eq!(built.sample(wo, u), direct.sample(wo, u), "{text}: sample({wo:?}, {u:?})");
        }
    }
    let (_, wo) = directions::<T>()[1];
    assert_eq!(built.albedo(wo), direct.albedo(wo), "{text}: albedo");
}

fn same_fresnel<T: Real + Debug>(text: &str, direct: impl Fresnel<T, Color = T::Vec3>)
where
    T::Vec3: PartialEq,
{
    let description: FresnelDescription = serde_json::from_str(text).expect(text);
    let built = description.build::<T>().expect(text);
    for cos in [-1.0, -0.3, 0.0, 0.01, 0.5, 0.99, 1.0].map(T::lit) {
        assert_eq!(built.reflectance(cos), direct.reflectance(cos), "{text}: {cos:?}");
    }
    assert_eq!(built.average(), direct.average(), "{text}");
}

fn same_distribution<T: Real + PartialEq>(text: &str, direct: impl Distribution<T>)
where
    T::Vec3: PartialEq,
{
    let description: DistributionDescription = serde_json::from_str(text).expect(text);
    let built = description.build::<T>().expect(text);
    for (h, _) in directions::<T>() {
        assert_eq!(built.density(h), direct.density(h), "{text}: {h:?}");
    }
    for u in numbers() {
        assert_eq!(built.sample(u), direct.sample(u), "{text}: {u:?}");
    }
}

fn rgb<T: Real>(r: f64, g: f64, b: f64) -> T::Vec3 {
    Vector::new(T::lit(r), T::lit(g), T::lit(b))
}

fn gray<T: Real>(value: f64) -> T::Vec3 {
    <T::Vec3 as Color<T>>::splat(T::lit(value))
}

fn fresnel_terms<T: Real>() -> Result<(), ParameterError>
where
    T::Vec3: PartialEq,
{
    same_fresnel::<T>(r#"{"constant": 0.3}"#, Constant::new(gray::<T>(0.3))?);
    same_fresnel::<T>(
        r#"{"dielectric": {"ior": [0.7, 1.5, 2.4]}}"#,
        Dielectric::new(rgb::<T>(0.7, 1.5, 2.4))?,
    );
    same_fresnel::<T>(
        r#"{"conductor": {"eta": [0.2, 0.4, 1.4], "k": 3}}"#,
        Conductor::new(rgb::<T>(0.2, 0.4, 1.4), gray::<T>(3.0))?,
    );
    same_fresnel::<T>(
        r#"{"schlick": {"f0": [0.9, 0.5, 0.1]}}"#,
        Schlick::new(rgb::<T>(0.9, 0.5, 0.1))?,
    );
    same_fresnel::<T>(
        r#"{"schlick": {"f0": [0.9, 0.5, 0.1], "f90": [1, 1, 1], "exponent": 5}}"#,
        Schlick::new(rgb::<T>(0.9, 0.5, 0.1))?,
    );
    same_fresnel::<T>(
        r#"{"schlick": {"f0": 0.04, "f90": [0.9, 0.5, 0.1], "exponent": 3.5}}"#,
        GeneralSchlick::new(gray::<T>(0.04), rgb::<T>(0.9, 0.5, 0.1), T::lit(3.5))?,
    );
    same_fresnel::<T>(
        r#"{"schlick": {"f0": 0.04, "exponent": 3.5}}"#,
        GeneralSchlick::new(gray::<T>(0.04), gray::<T>(1.0), T::lit(3.5))?,
    );
    same_fresnel::<T>(
        r#"{"hall": {"f0": [0.9, 0.5, 0.1], "ior": 1.3}}"#,
        Hall::new(rgb::<T>(0.9, 0.5, 0.1), T::lit(1.3))?,
    );
    let copper = Conductor::new(T::lit(1.02), T::lit(2.577))?;
    same_fresnel::<T>(
        r#"{"hall": {"f0": [0.95, 0.64, 0.54], "ior": [1.02, 2.577]}}"#,
        Hall::with_reference(rgb::<T>(0.95, 0.64, 0.54), copper)?,
    );
    same_fresnel::<T>(
        r#"{"cook": {"f0": 0.2, "light": [0.5, 1, 2], "ior": [1.02, 2.577]}}"#,
        Cook::with_reference(gray::<T>(0.2), rgb::<T>(0.5, 1.0, 2.0), copper)?,
    );
    same_fresnel::<T>(
        r#"{"cook": {"f0": 0.2, "light": [0.5, 1, 2]}}"#,
        Cook::new(gray::<T>(0.2), rgb::<T>(0.5, 1.0, 2.0), T::lit(1.5))?,
    );
    Ok(())
}

#[test]
fn fresnel_terms_are_those_of_the_types() {
    fresnel_terms::<f32>().expect("in range");
    fresnel_terms::<f64>().expect("in range");
}

#[test]
fn metals_are_measured() {
    let wavelengths = glam::DVec3::new(650.0, 550.0, 450.0);
    for (name, material) in [
        ("Au", &brdf::materials::GOLD),
        ("gold", &brdf::materials::GOLD),
        ("aluminum", &brdf::materials::ALUMINIUM),
        ("au_mcpeak", &brdf::materials::GOLD_MCPEAK_2015),
    ] {
        let text = format!(r#"{{"metal": "{name}"}}"#);
        same_fresnel::<f64>(&text, material.conductor(wavelengths).expect("in range"));
        same_fresnel::<f32>(&text, material.conductor(wavelengths.as_vec3()).expect("in range"));
    }
}

/// Every material that is no dielectric can be named, by its key and by its name.
#[test]
fn every_metal_can_be_named() {
    use brdf::materials::{ALL, Kind};
    let mut count = 0;
    for material in ALL.into_iter().filter(|material| material.kind() != Kind::Dielectric) {
        for name in [material.key(), material.name()] {
            let text = serde_json::json!({ "metal": name }).to_string();
            let description: FresnelDescription = serde_json::from_str(&text).expect(&text);
            assert_eq!(serde_json::to_string(&description).expect(&text), text);
            assert!(description.build::<f32>().is_ok());
        }
        count += 1;
    }
    assert_eq!(count, 40);
}

fn distributions<T: Real + PartialEq>() -> Result<(), ParameterError>
where
    T::Vec3: PartialEq,
{
    let lit = T::lit;
    same_distribution::<T>(r#"{"gaussian": {"roughness": 0.3}}"#, Gaussian::new(lit(0.3))?);
    same_distribution::<T>(r#"{"beckmann": {"roughness": 0.3}}"#, Beckmann::new(lit(0.3))?);
    same_distribution::<T>(
        r#"{"beckmann": {"roughness": [0.3, 0.1]}}"#,
        Beckmann::anisotropic(lit(0.3), lit(0.1))?,
    );
    same_distribution::<T>(r#"{"ggx": {"roughness": 0.3}}"#, Ggx::new(lit(0.3))?);
    same_distribution::<T>(
        r#"{"ggx": {"roughness": [0.3, 0.1]}}"#,
        Ggx::anisotropic(lit(0.3), lit(0.1))?,
    );
    same_distribution::<T>(r#"{"blinn": {"exponent": 30}}"#, Blinn::new(lit(30.0))?);
    let mixture = |kind: &str, key: &str, values: [f64; 3]| {
        let [a, b, c] = values.map(|value| {
            format!(r#"{{"weight": {value}, "distribution": {{"{kind}": {{"{key}": {value}}}}}}}"#)
        });
        format!(r#"{{"mixture": [{a}, {b}, {c}]}}"#)
    };
    let values = [0.4, 0.2, 0.7];
    let weighted = values.map(|value| (lit(value), lit(value)));
    let [a, b, c] = weighted;
    same_distribution::<T>(
        &mixture("beckmann", "roughness", values),
        Mixture::new([
            (a.0, Beckmann::new(a.1)?),
            (b.0, Beckmann::new(b.1)?),
            (c.0, Beckmann::new(c.1)?),
        ])?,
    );
    same_distribution::<T>(
        &mixture("ggx", "roughness", values),
        Mixture::new([(a.0, Ggx::new(a.1)?), (b.0, Ggx::new(b.1)?), (c.0, Ggx::new(c.1)?)])?,
    );
    same_distribution::<T>(
        &mixture("gaussian", "roughness", values),
        Mixture::new([
            (a.0, Gaussian::new(a.1)?),
            (b.0, Gaussian::new(b.1)?),
            (c.0, Gaussian::new(c.1)?),
        ])?,
    );
    same_distribution::<T>(
        &mixture("blinn", "exponent", values),
        Mixture::new([(a.0, Blinn::new(a.1)?), (b.0, Blinn::new(b.1)?), (c.0, Blinn::new(c.1)?)])?,
    );
    // Of several kinds, in the order in which the kinds are sorted.
    let boxed: [(T, Box<dyn Distribution<T>>); 4] = [
        (lit(0.5), Box::new(Beckmann::new(lit(0.2))?)),
        (lit(1.0), Box::new(Ggx::new(lit(0.3))?)),
        (lit(1.5), Box::new(Gaussian::new(lit(0.4))?)),
        (lit(2.0), Box::new(Blinn::new(lit(10.0))?)),
    ];
    same_distribution::<T>(
        r#"{"mixture": [{"weight": 0.5, "distribution": {"beckmann": {"roughness": 0.2}}},
                        {"weight": 1, "distribution": {"ggx": {"roughness": 0.3}}},
                        {"weight": 1.5, "distribution": {"gaussian": {"roughness": 0.4}}},
                        {"weight": 2, "distribution": {"blinn": {"exponent": 10}}}]}"#,
        Mixture::new(boxed)?,
    );
    // A mixture in a mixture, with weights that are exact in binary.
    same_distribution::<T>(
        r#"{"mixture": [{"weight": 1, "distribution": {"ggx": {"roughness": 0.2}}},
                        {"weight": 3, "distribution": {"mixture": [
                            {"weight": 1, "distribution": {"ggx": {"roughness": 0.4}}},
                            {"weight": 1, "distribution": {"ggx": {"roughness": 0.6}}}]}}]}"#,
        Mixture::new([
            (lit(0.25), Ggx::new(lit(0.2))?),
            (lit(0.375), Ggx::new(lit(0.4))?),
            (lit(0.375), Ggx::new(lit(0.6))?),
        ])?,
    );
    Ok(())
}

#[test]
fn distributions_are_those_of_the_types() {
    distributions::<f32>().expect("in range");
    distributions::<f64>().expect("in range");
}

fn lobes<T: Real + PartialEq>() -> Result<(), ParameterError>
where
    T::Vec3: PartialEq,
{
    let (lit, color) = (T::lit, rgb::<T>(0.9, 0.5, 0.1));
    same_model::<T>(r#"{"lambert": {"albedo": [0.9, 0.5, 0.1]}}"#, Lambert::new(color)?);
    same_model::<T>(
        r#"{"oren_nayar": {"albedo": [0.9, 0.5, 0.1], "sigma": 0.3}}"#,
        OrenNayar::new(color, lit(0.3))?,
    );
    same_model::<T>(
        r#"{"oren_nayar": {"albedo": [0.9, 0.5, 0.1], "sigma": 0.3, "interreflection": true}}"#,
        OrenNayar::with_interreflection(color, lit(0.3))?,
    );
    same_model::<T>(
        r#"{"phong": {"specular": [0.9, 0.5, 0.1], "exponent": 7}}"#,
        Phong::new(color, lit(7.0))?,
    );
    same_model::<T>(
        r#"{"phong": {"specular": [0.9, 0.5, 0.1], "exponent": 7, "normalized": false}}"#,
        ClassicPhong::new(color, lit(7.0))?,
    );
    same_model::<T>(
        r#"{"blinn_phong": {"specular": [0.9, 0.5, 0.1], "exponent": 7}}"#,
        BlinnPhong::new(color, lit(7.0))?,
    );
    same_model::<T>(
        r#"{"blinn_phong": {"specular": [0.9, 0.5, 0.1], "exponent": 7, "normalized": false}}"#,
        BlinnPhong::unnormalized(color, lit(7.0))?,
    );
    same_model::<T>(
        r#"{"schlick_power": {"specular": [0.9, 0.5, 0.1], "exponent": 7}}"#,
        SchlickPower::new(color, lit(7.0))?,
    );
    same_model::<T>(
        r#"{"schlick_power": {"specular": [0.9, 0.5, 0.1], "exponent": 7, "normalized": false}}"#,
        SchlickPower::unnormalized(color, lit(7.0))?,
    );
    type Boxed<T> = Box<dyn Brdf<T, Color = <T as Real>::Vec3>>;
    let terms: [(T::Vec3, Boxed<T>); 2] = [
        (gray::<T>(0.7), Box::new(Lambert::new(color)?)),
        (rgb::<T>(0.1, 0.2, 0.3), Box::new(Phong::new(gray::<T>(1.0), lit(20.0))?)),
    ];
    same_model::<T>(
        r#"{"sum": [{"weight": 0.7, "brdf": {"lambert": {"albedo": [0.9, 0.5, 0.1]}}},
                    {"weight": [0.1, 0.2, 0.3],
                     "brdf": {"phong": {"specular": 1, "exponent": 20}}}]}"#,
        WeightedSum::new(terms)?,
    );
    Ok(())
}

#[test]
fn lobes_and_sums_are_those_of_the_types() {
    lobes::<f32>().expect("in range");
    lobes::<f64>().expect("in range");
}

fn microfacets<T: Real + PartialEq>() -> Result<(), ParameterError>
where
    T::Vec3: PartialEq,
{
    let lit = T::lit;
    let glass = || Dielectric::new(gray::<T>(1.5));
    let model = |distribution: &str, fresnel: &str, shadowing: &str| {
        format!(
            r#"{{"cook_torrance": {{"distribution": {distribution}, "fresnel": {fresnel},
                "shadowing": "{shadowing}"}}}}"#
        )
    };
    let (dielectric, schlick) = (r#"{"dielectric": {"ior": 1.5}}"#, r#"{"schlick": {"f0": 0.04}}"#);
    let ggx = Ggx::anisotropic(lit(0.2), lit(0.5))?;
    let surface = CookTorrance::from_parts(ggx, glass()?, VCavity);
    let text = r#"{"ggx": {"roughness": [0.2, 0.5]}}"#;
    same_model::<T>(&model(text, dielectric, "v_cavity"), surface);
    same_model::<T>(&model(text, dielectric, "smith"), surface.with_shadowing(SmithCorrelated));
    same_model::<T>(
        &model(text, dielectric, "smith_separable"),
        surface.with_shadowing(SmithSeparable),
    );
    let (beckmann, schlick_term) = (Beckmann::new(lit(0.3))?, Schlick::new(gray::<T>(0.04))?);
    let surface = CookTorrance::from_parts(beckmann, schlick_term, VCavity);
    let text = r#"{"beckmann": {"roughness": 0.3}}"#;
    same_model::<T>(&model(text, schlick, "v_cavity"), surface);
    same_model::<T>(&model(text, schlick, "smith"), surface.with_shadowing(SmithCorrelated));
    same_model::<T>(
        &model(text, schlick, "smith_separable"),
        surface.with_shadowing(SmithSeparable),
    );
    same_model::<T>(
        &model(r#"{"gaussian": {"roughness": 0.3}}"#, schlick, "v_cavity"),
        CookTorrance::new(Gaussian::new(lit(0.3))?, Schlick::new(gray::<T>(0.04))?),
    );
    same_model::<T>(
        &model(r#"{"blinn": {"exponent": 30}}"#, dielectric, "v_cavity"),
        CookTorrance::new(Blinn::new(lit(30.0))?, glass()?),
    );
    let mixture = CookTorrance::from_parts(
        Mixture::new([(lit(0.4), Beckmann::new(lit(0.2))?), (lit(0.6), Beckmann::new(lit(0.5))?)])?,
        glass()?,
        VCavity,
    );
    let text = r#"{"mixture": [{"weight": 0.4, "distribution": {"beckmann": {"roughness": 0.2}}},
                               {"weight": 0.6, "distribution": {"beckmann": {"roughness": 0.5}}}]}"#;
    same_model::<T>(&model(text, dielectric, "v_cavity"), mixture);
    same_model::<T>(&model(text, dielectric, "smith"), mixture.with_shadowing(SmithCorrelated));
    same_model::<T>(
        &model(text, dielectric, "smith_separable"),
        mixture.with_shadowing(SmithSeparable),
    );
    for (text, smith) in [(text, true), (r#"{"blinn": {"exponent": 30}}"#, false)] {
        let by_default =
            format!(r#"{{"cook_torrance": {{"distribution": {text}, "fresnel": {dielectric}}}}}"#);
        if smith {
            same_model::<T>(&by_default, mixture.with_shadowing(SmithCorrelated));
        } else {
            same_model::<T>(&by_default, CookTorrance::new(Blinn::new(lit(30.0))?, glass()?));
        }
    }
    same_model::<T>(
        r#"{"torrance_sparrow_1967": {"c": 0.05, "fresnel": {"dielectric": {"ior": 1.5}}}}"#,
        CookTorrance::torrance_sparrow_1967(lit(0.05), glass()?)?,
    );
    same_model::<T>(
        r#"{"cook_torrance_1982_printed": {"roughness": 0.2,
            "fresnel": {"dielectric": {"ior": 1.5}}}}"#,
        CookTorrance1982Printed::new(Beckmann::new(lit(0.2))?, glass()?),
    );
    let blinn = |form: &str| {
        format!(
            r#"{{"blinn_1977_printed": {{"distribution": "{form}", "beta": 0.3,
                "fresnel": {{"dielectric": {{"ior": 1.5}}}}}}}}"#
        )
    };
    let distribution = Blinn1977::new(lit(0.3))?;
    same_model::<T>(&blinn("d1"), Blinn1977Printed::d1(distribution, glass()?)?);
    same_model::<T>(&blinn("d2"), Blinn1977Printed::d2(distribution, glass()?)?);
    same_model::<T>(&blinn("d3"), Blinn1977Printed::d3(distribution, glass()?)?);
    Ok(())
}

#[test]
fn microfacet_models_are_those_of_the_types() {
    microfacets::<f32>().expect("in range");
    microfacets::<f64>().expect("in range");
}

/// Every combination of distribution, Fresnel term and shadowing samples by its own density.
#[test]
fn every_description_builds_a_consistent_model() {
    for text in crate::forms::models() {
        let description: BrdfDescription = serde_json::from_str(&text).expect(&text);
        let model = description.build::<f64>().expect(&text);
        let wo = from_spherical(0.7, 1.0);
        // Not every draw gives a direction above the surface.
        let sample = numbers().into_iter().map(|u| model.sample(wo, u)).find(|it| it.pdf > 0.0);
        let sample = sample.expect(&text);
        let value = model.eval(sample.wi, wo) * sample.wi.z;
        assert!((model.pdf(sample.wi, wo) / sample.pdf - 1.0).abs() < 1e-9, "{text}");
        assert!(
            value.abs_diff_eq(sample.weight * sample.pdf, 1e-9 * value.max_element()),
            "{text}"
        );
    }
}

/// Every number that a model is built of is one of the numbers of the description, and they are set one
/// by one.
#[test]
fn numbers_are_those_that_models_are_built_of() {
    for row in brdf_checks::models::rows() {
        let (text, description) = (&row.name, &row.brdf);
        let numbers = description.numbers();
        let mut places = 0;
        let build = description.build_with(|path, value: f64| {
            let path = path.to_string();
            let number = numbers.iter().find(|number| number.path == path).expect(&path);
            assert_eq!(number.value, value, "{path}");
            assert!((number.range.lower..=number.range.upper).contains(&value), "{path}");
            places += 1;
            value
        });
        build.expect(text);
        assert!(places <= numbers.len(), "{text}");
        let same = description.with_numbers(|_, value| value).expect(text);
        assert_eq!(&same, description);
        let Some(first) = numbers.first() else { continue };
        let mut range = first.range;
        range.upper = range.upper.min(range.lower.abs().max(1.0) * 2.0);
        let other = 0.5 * (range.lower + range.upper);
        let changed = description
            .with_numbers(|path, value| if path.to_string() == first.path { other } else { value });
        // A colour of two channels may not have a sum of weights, and so on: an error is one, too.
        if let Ok(changed) = changed {
            assert_eq!(changed.numbers()[0].value, other, "{text}");
        }
        let beyond = first.range.upper.next_up().max(first.range.upper + 1.0);
        assert!(description.with_numbers(|_, _| beyond).is_err(), "{text}");
    }
}
