//! Every form of description, and its way through several formats and back.

use std::fmt::Debug;

use brdf::description::{BrdfDescription, DistributionDescription, FresnelDescription};
use serde::Serialize;
use serde::de::DeserializeOwned;

pub(crate) const FRESNEL: [&str; 27] = [
    r#"{"constant":0.5}"#,
    r#"{"constant":[0.25,0.5,1]}"#,
    r#"{"dielectric":{"ior":1.5}}"#,
    r#"{"dielectric":{"ior":[0.7,1.5,1.6]}}"#,
    r#"{"conductor":{"eta":[0.14,0.43,1.38],"k":[3.7,2.5,1.9]}}"#,
    r#"{"metal":"Au"}"#,
    r#"{"metal":{"material":"silver","outside":1.5}}"#,
    r#"{"metal":{"samples":[[450,1.4,1.9],[550,0.4,2.5],[650,0.2,3.6]],"outside":{"material":"water"}}}"#,
    r#"{"dielectric":{"ior":{"material":"BK7"}}}"#,
    r#"{"dielectric":{"ior":{"samples":[[400,1.55,0],[700,1.5,1e-7]],"outside":[1.3,1.31,1.32]}}}"#,
    r#"{"stack":{"layers":[{"index":{"samples":[[400,2.6,0.1],[700,2.4,0]]},"thickness":40}],"substrate":{"material":"Ti"}}}"#,
    r#"{"schlick":{"f0":[0.9,0.6,0.3]}}"#,
    r#"{"schlick":{"f0":0.04,"f90":[0.9,0.6,0.3],"exponent":3}}"#,
    r#"{"lazanyi":{"f0":[0.9,0.6,0.3],"a":1.5,"alpha":[6,5,4]}}"#,
    r#"{"f82":{"f0":[0.9,0.6,0.3],"f82":0.5}}"#,
    r#"{"f82_tint":{"f0":[0.9,0.6,0.3]}}"#,
    r#"{"gulbrandsen":{"reflectivity":[0.9,0.6,0.3],"edge_tint":0.5}}"#,
    r#"{"hall":{"f0":[0.9,0.6,0.3]}}"#,
    r#"{"hall":{"f0":0.5,"ior":1.3}}"#,
    r#"{"hall":{"f0":[0.95,0.64,0.54],"ior":[1.02,2.577]}}"#,
    r#"{"cook":{"f0":0.2,"light":[0.5,1,2]}}"#,
    r#"{"cook":{"f0":0.2,"light":0.5,"ior":2.5}}"#,
    r#"{"cook":{"f0":0.2,"light":0.5,"ior":[0.2,3]}}"#,
    r#"{"stack":{"layers":[],"substrate":{"material":"Au"}}}"#,
    r#"{"stack":{"outside":1.33,"layers":[{"index":[2.4,0.01],"thickness":40}],"substrate":{"eta":[2.7,2.4,2.1],"k":3},"wavelength":[600,550,450]}}"#,
    r#"{"belcour_barla":{"film":1.33,"thickness":300,"substrate":1}}"#,
    r#"{"belcour_barla":{"film":1.33,"thickness":300,"substrate":{"eta":0.5,"k":2.5},"outside":1.1}}"#,
];

pub(crate) const DISTRIBUTIONS: [&str; 11] = [
    r#"{"gaussian":{"roughness":0.3}}"#,
    r#"{"beckmann":{"roughness":0.3}}"#,
    r#"{"beckmann":{"roughness":[0.2,0.5]}}"#,
    r#"{"ggx":{"roughness":1}}"#,
    r#"{"ggx":{"roughness":[0.1,0.4]}}"#,
    r#"{"blinn":{"exponent":40}}"#,
    r#"{"gtr":{"roughness":0.3,"gamma":1.5}}"#,
    r#"{"student_t":{"roughness":[0.1,0.4],"gamma":3}}"#,
    r#"{"mixture":[{"weight":2,"distribution":{"beckmann":{"roughness":0.2}}},{"weight":3,"distribution":{"beckmann":{"roughness":0.5}}}]}"#,
    r#"{"mixture":[{"weight":1,"distribution":{"ggx":{"roughness":0.2}}},{"weight":3,"distribution":{"beckmann":{"roughness":0.5}}}]}"#,
    r#"{"mixture":[{"weight":1,"distribution":{"blinn":{"exponent":10}}},{"weight":3,"distribution":{"mixture":[{"weight":1,"distribution":{"gaussian":{"roughness":0.2}}},{"weight":1,"distribution":{"ggx":{"roughness":0.4}}}]}}]}"#,
];

pub(crate) const SIMPLE: [&str; 27] = [
    r#"{"lambert":{"albedo":0.5}}"#,
    r#"{"lambert":{"albedo":[0.1,0.2,0.3]}}"#,
    r#"{"oren_nayar":{"albedo":0.5,"sigma":0.3}}"#,
    r#"{"oren_nayar":{"albedo":0.5,"sigma":0.3,"interreflection":true}}"#,
    r#"{"oren_nayar_full":{"albedo":0.5,"sigma":0.3,"interreflection":false}}"#,
    r#"{"fujii":{"albedo":0.5,"sigma":0.3}}"#,
    r#"{"fon":{"albedo":0.5,"roughness":0.3}}"#,
    r#"{"eon":{"albedo":[0.1,0.2,0.3],"roughness":0.3}}"#,
    r#"{"phong":{"specular":0.5,"exponent":10}}"#,
    r#"{"phong":{"specular":0.5,"exponent":10,"normalized":false}}"#,
    r#"{"blinn_phong":{"specular":[0.5,0.6,0.7],"exponent":10}}"#,
    r#"{"blinn_phong":{"specular":0.5,"exponent":10,"normalized":false}}"#,
    r#"{"schlick_power":{"specular":0.5,"exponent":10}}"#,
    r#"{"schlick_power":{"specular":0.5,"exponent":10,"normalized":false}}"#,
    r#"{"ward":{"specular":0.5,"roughness":[0.1,0.3]}}"#,
    r#"{"ward":{"specular":0.5,"roughness":0.1,"form":"ward_1992"}}"#,
    r#"{"ashikhmin_shirley":{"specular":0.1,"diffuse":[0.5,0.4,0.3],"exponent":[10,100]}}"#,
    r#"{"lafortune":{"lobes":[{"c":[-1,-1,0.9],"exponent":10},{"c":[0.5,0.5,0.5],"exponent":3,"specular":[0.5,0.4,0.3]}]}}"#,
    r#"{"hapke":{"w":[0.1,0.2,0.3]}}"#,
    r#"{"hapke":{"w":0.5,"xi":-0.3,"b0":1,"h":0.1,"theta_bar":0.3,"h_function":"1981"}}"#,
    r#"{"schlick_1994":{"layers":[{"specular":0.5,"roughness":0.3}]}}"#,
    r#"{"schlick_1994":{"layers":[{"specular":0.1,"roughness":0.3},{"specular":[0.5,0.4,0.3],"roughness":0.8,"isotropy":0.5}],"shadowing":"none","split":true}}"#,
    r#"{"disney_2012":{"base_color":[0.5,0.4,0.3]}}"#,
    r#"{"disney_2012":{"base_color":0.5,"metallic":1,"anisotropic":0.5,"clearcoat":1,"form":"2014"}}"#,
    r#"{"torrance_sparrow_1967":{"c":0.05,"fresnel":{"dielectric":{"ior":1.5}}}}"#,
    r#"{"cook_torrance_1982_printed":{"roughness":[0.2,0.3],"fresnel":{"metal":"copper"}}}"#,
    r#"{"sum":[{"weight":[0.5,0.25,0.125],"brdf":{"lambert":{"albedo":0.5}}},{"weight":0.5,"brdf":{"sum":[{"weight":1,"brdf":{"phong":{"specular":1,"exponent":3}}}]}}]}"#,
];

/// All models: the simple ones, and every distribution with every Fresnel term and shadowing.
pub(crate) fn models() -> Vec<String> {
    let mut models = SIMPLE.map(String::from).to_vec();
    for fresnel in FRESNEL {
        for form in ["d1", "d2", "d3"] {
            models.push(format!(
                r#"{{"blinn_1977_printed":{{"distribution":"{form}","beta":0.3,"fresnel":{fresnel}}}}}"#
            ));
        }
        for distribution in DISTRIBUTIONS {
            let smith =
                !["gaussian", "blinn", "gtr", "student"].iter().any(|it| distribution.contains(it));
            models.push(format!(
                r#"{{"cook_torrance":{{"distribution":{distribution},"fresnel":{fresnel}}}}}"#
            ));
            for shadowing in ["v_cavity", "smith", "smith_separable"] {
                if smith || shadowing == "v_cavity" {
                    models.push(format!(
                        r#"{{"cook_torrance":{{"shadowing":"{shadowing}","distribution":{distribution},"fresnel":{fresnel}}}}}"#
                    ));
                }
            }
        }
    }
    models
}

pub(crate) fn goes_round<V: Serialize + DeserializeOwned + PartialEq + Debug>(text: &str) {
    let value: V = serde_json::from_str(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let written = serde_json::to_string(&value).expect("JSON");
    assert_eq!(serde_json::from_str::<V>(&written).expect(&written), value, "{written}");
    let tree = serde_json::to_value(&value).expect("JSON");
    assert_eq!(serde_json::from_value::<V>(tree).expect("a tree of JSON"), value, "{written}");

    let written = ron::to_string(&value).expect("RON");
    assert_eq!(ron::from_str::<V>(&written).expect(&written), value, "{written}");

    let mut written = Vec::new();
    ciborium::into_writer(&value, &mut written).expect("CBOR");
    assert_eq!(ciborium::from_reader::<V, _>(&*written).expect(text), value, "CBOR of {text}");
}

#[test]
fn every_form_goes_through_json_ron_and_cbor() {
    FRESNEL.into_iter().for_each(goes_round::<FresnelDescription>);
    DISTRIBUTIONS.into_iter().for_each(goes_round::<DistributionDescription>);
    for model in models() {
        goes_round::<BrdfDescription>(&model);
    }
}

#[test]
fn what_is_written_is_the_documented_form() {
    for text in [
        r#"{"cook_torrance":{"distribution":{"ggx":{"roughness":[0.5,0.25]}},"fresnel":{"constant":[0.5,0.25,1.0]},"shadowing":"smith"}}"#,
        r#"{"phong":{"specular":0.5,"exponent":10.0,"normalized":false}}"#,
        r#"{"sum":[{"weight":0.5,"brdf":{"lambert":{"albedo":0.5}}}]}"#,
    ] {
        let value: BrdfDescription = serde_json::from_str(text).expect(text);
        assert_eq!(serde_json::to_string(&value).expect("JSON"), text);
    }
}

#[test]
fn absent_keys_have_their_defaults() {
    for (short, long) in [
        (
            r#"{"phong":{"specular":1,"exponent":2}}"#,
            r#"{"phong":{"specular":1,"exponent":2,"normalized":true}}"#,
        ),
        (
            r#"{"oren_nayar":{"albedo":1,"sigma":0.5}}"#,
            r#"{"oren_nayar":{"albedo":1,"sigma":0.5,"interreflection":false}}"#,
        ),
        (
            r#"{"torrance_sparrow_1967":{"c":1,"fresnel":{"schlick":{"f0":1}}}}"#,
            r#"{"torrance_sparrow_1967":{"c":1,"fresnel":{"schlick":{"f0":1,"f90":1,"exponent":5}}}}"#,
        ),
        (
            r#"{"cook_torrance":{"distribution":{"blinn":{"exponent":9}},"fresnel":{"constant":1}}}"#,
            r#"{"cook_torrance":{"distribution":{"blinn":{"exponent":9}},"fresnel":{"constant":1},"shadowing":"v_cavity"}}"#,
        ),
        (
            r#"{"cook_torrance":{"fresnel":{"hall":{"f0":1}},"distribution":{"ggx":{"roughness":1}}}}"#,
            r#"{"cook_torrance":{"distribution":{"ggx":{"roughness":1}},"fresnel":{"hall":{"f0":1,"ior":1.5}},"shadowing":"smith"}}"#,
        ),
    ] {
        let read = |text| serde_json::from_str::<BrdfDescription>(text).expect(text);
        assert_eq!(read(short), read(long));
    }
}

/// RON as it is written by hand: forms are variants.
#[test]
fn ron_reads_naturally() {
    let text = "cook_torrance(distribution: beckmann(roughness: (0.2, 0.5)), fresnel: \
                conductor(eta: [0.14, 0.43, 1.38], k: 3), shadowing: smith)";
    let value: BrdfDescription = ron::from_str(text).expect(text);
    let json = r#"{"cook_torrance":{"distribution":{"beckmann":{"roughness":[0.2,0.5]}},
        "fresnel":{"conductor":{"eta":[0.14,0.43,1.38],"k":3}},"shadowing":"smith"}}"#;
    assert_eq!(value, serde_json::from_str(json).expect(json));
}
