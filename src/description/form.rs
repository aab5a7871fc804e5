//! The table of all forms of descriptions: what can be read, written and built.

use alloc::vec;

use super::value::{Described, Numbers, Value};
use crate::diffuse::{Lambert, OrenNayar};
use crate::distribution::{Beckmann, Blinn, Blinn1977, Gaussian, Ggx};
use crate::error::range;
use crate::fresnel::{
    BelcourBarla, Conductor, Constant, Cook, Dielectric, GeneralSchlick, Hall, Stack,
};
use crate::glossy::{BlinnPhong, Phong, SchlickPower};
use crate::interface::{Plastic, ROUGH_IOR, SmoothDielectric, ThinDielectric};
use crate::parameter::{Kind, Parameter, Part, Preset, model};
use crate::planetary::{LommelSeeliger, Minnaert};
use crate::wave::{BeckmannKirchhoff, He1991};

/// A form of description: its name and what stands behind it.
///
/// ```
/// use brdf::description::{Content, forms};
/// use brdf::parameter::Part;
///
/// let (_, phong) = forms().find(|(_, form)| form.name() == "phong").unwrap();
/// let Content::Keys(parameters) = phong.content() else { panic!() };
/// let names: Vec<_> = parameters.iter().map(|parameter| parameter.name).collect();
/// assert_eq!(names, ["specular", "exponent", "normalized"]);
/// assert!(forms().any(|(part, form)| part == Part::Fresnel && form.name() == "metal"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Form {
    name: &'static str,
    part: Part,
    content: Content,
    /// The names of the keys.
    pub(super) keys: &'static [&'static str],
}

/// What stands behind the name of a form.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Content {
    /// An object with a key for each parameter.
    Keys(&'static [Parameter]),
    /// The value of the one parameter, without a key.
    Value(&'static Parameter),
    /// A list of terms, which are objects with a key for each parameter.
    Terms(&'static [Parameter]),
}

impl Form {
    /// The name, which is the key or the variant.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// What stands behind the name.
    #[must_use]
    pub const fn content(&self) -> &Content {
        &self.content
    }

    pub(super) const fn part(&self) -> Part {
        self.part
    }

    pub(super) const fn room(&self) -> &'static Room {
        Room::of(self.part)
    }

    /// Whether a value stands behind the name, without a key.
    pub(super) const fn is_value(&self) -> bool {
        matches!(self.content, Content::Value(_))
    }

    /// The parameters of the value behind the name, or of each term.
    pub(super) const fn parameters(&self) -> &'static [Parameter] {
        match self.content {
            Content::Keys(parameters) | Content::Terms(parameters) => parameters,
            Content::Value(parameter) => core::slice::from_ref(parameter),
        }
    }
}

/// All forms, with what they describe. A form of [`Part::Brdf`] is one of [`Part::Bsdf`] too, and stands
/// here once.
pub fn forms() -> impl Iterator<Item = (Part, &'static Form)> {
    [Part::Brdf, Part::Bsdf, Part::Fresnel, Part::Distribution]
        .into_iter()
        .flat_map(|part| Room::of(part).forms.iter().map(move |form| (part, form)))
        .filter(|(part, form)| *part == form.part)
}

/// The forms of one part, and what they are called together.
#[derive(Debug)]
pub(super) struct Room {
    /// As a type, and the type of the terms of a list.
    pub(super) name: &'static str,
    pub(super) term: &'static str,
    /// What an error expects where none of the forms stands.
    pub(super) expected: &'static str,
    pub(super) forms: &'static [Form],
    pub(super) names: &'static [&'static str],
}

impl Room {
    pub(super) const fn of(part: Part) -> &'static Self {
        match part {
            Part::Brdf => &BRDF,
            Part::Bsdf => &BSDF,
            Part::Fresnel => &FRESNEL,
            Part::Distribution => &DISTRIBUTION,
        }
    }
}

static BRDF: Room = Room {
    name: "BrdfDescription",
    term: "WeightedBrdf",
    expected: "a model, such as {\"lambert\": {\"albedo\": 0.5}}",
    forms: &BRDF_FORMS,
    names: &names(&BRDF_FORMS),
};

static BSDF: Room = Room {
    name: "BsdfDescription",
    term: "WeightedBsdf",
    expected: "a model, such as {\"dielectric\": {\"ior\": 1.5}}",
    forms: &BSDF_FORMS,
    names: &names(&BSDF_FORMS),
};

static FRESNEL: Room = Room {
    name: "FresnelDescription",
    term: "Layer",
    expected: "a Fresnel term, such as {\"schlick\": {\"f0\": 0.04}}",
    forms: &FRESNEL_FORMS,
    names: &names(&FRESNEL_FORMS),
};

static DISTRIBUTION: Room = Room {
    name: "DistributionDescription",
    term: "WeightedDistribution",
    expected: "a distribution, such as {\"ggx\": {\"roughness\": 0.3}}",
    forms: &DISTRIBUTION_FORMS,
    names: &names(&DISTRIBUTION_FORMS),
};

/// A form of a part, whose content is of one of the kinds.
macro_rules! form {
    ($part:ident $name:literal: Value $parameter:expr) => {
        Form { name: $name, part: Part::$part, content: Content::Value($parameter), keys: &[] }
    };
    ($part:ident $name:literal: $content:ident $parameters:expr) => {{
        const PARAMETERS: &[Parameter] = $parameters;
        const KEYS: [&str; PARAMETERS.len()] = keys(PARAMETERS);
        Form { name: $name, part: Part::$part, content: Content::$content(PARAMETERS), keys: &KEYS }
    }};
}

static BRDF_FORMS: [Form; 12] = [
    form!(Brdf "lambert": Keys <Lambert>::PARAMETERS),
    form!(Brdf "oren_nayar": Keys <OrenNayar>::PARAMETERS),
    form!(Brdf "phong": Keys <Phong>::PARAMETERS),
    form!(Brdf "blinn_phong": Keys <BlinnPhong>::PARAMETERS),
    form!(Brdf "schlick_power": Keys <SchlickPower>::PARAMETERS),
    form!(Brdf "minnaert": Keys <Minnaert>::PARAMETERS),
    form!(Brdf "lommel_seeliger": Keys <LommelSeeliger>::PARAMETERS),
    form!(Brdf "cook_torrance": Keys &[FACETS, REFLECTANCE, SHADOWING]),
    form!(Brdf "torrance_sparrow_1967": Keys &[
        model!(@row c: T, SHARPNESS_1967, "c", "sharpness of the distribution, 1/degree"),
        REFLECTANCE,
    ]),
    form!(Brdf "cook_torrance_1982_printed": Keys &[<Beckmann>::PARAMETERS[0], REFLECTANCE]),
    form!(Brdf "blinn_1977_printed": Keys &[
        Parameter::new(
            "distribution", "D", "which of the distributions of 1977",
            Kind::Word(&["d1", "d2", "d3"]),
        ),
        <Blinn1977>::PARAMETERS[0],
        REFLECTANCE,
    ]),
    form!(Brdf "sum": Terms &[
        model!(@row weight: C, WEIGHT, "w", "weight, per channel"),
        Parameter::new("brdf", "f", "the model", Kind::Part(Part::Brdf)),
    ]),
];

/// Models over the whole sphere that are none of reflection alone, and those with specular lobes.
static SPHERE_FORMS: [Form; 7] = [
    form!(Bsdf "mirror": Keys &[REFLECTANCE.or(Preset::White)]),
    form!(Bsdf "plastic": Keys &[
        <Plastic>::PARAMETERS[0],
        <Plastic>::PARAMETERS[1].of(Kind::RealIndex(range::DENSER, 1)),
        <Plastic>::PARAMETERS[2],
    ]),
    form!(Bsdf "beckmann_kirchhoff_1963": Keys <BeckmannKirchhoff<()>>::PARAMETERS),
    form!(Bsdf "he_1991": Keys <He1991<()>>::PARAMETERS),
    form!(Bsdf "dielectric": Keys &[<SmoothDielectric>::PARAMETERS[0].of(ONE_INDEX)]),
    form!(Bsdf "thin_dielectric": Keys &[<ThinDielectric>::PARAMETERS[0].of(ONE_INDEX)]),
    form!(Bsdf "rough_dielectric": Keys &[FACETS, ROUGH_IOR.of(ONE_INDEX), REFRACTED_SHADOWING]),
];

/// These, and every model of reflection.
static BSDF_FORMS: [Form; 19] = joined(&SPHERE_FORMS, &BRDF_FORMS);

static FRESNEL_FORMS: [Form; 9] = [
    form!(Fresnel "constant": Value &<Constant>::PARAMETERS[0]),
    form!(Fresnel "dielectric": Keys &[
        <Dielectric>::PARAMETERS[0].of(Kind::RelativeIndex(range::ETA, 3)),
    ]),
    form!(Fresnel "conductor": Keys <Conductor>::PARAMETERS),
    form!(Fresnel "metal": Value &METAL),
    form!(Fresnel "schlick": Keys <GeneralSchlick>::PARAMETERS),
    form!(Fresnel "hall": Keys <Hall>::PARAMETERS),
    form!(Fresnel "cook": Keys <Cook>::PARAMETERS),
    form!(Fresnel "stack": Keys <Stack>::PARAMETERS),
    form!(Fresnel "belcour_barla": Keys <BelcourBarla>::PARAMETERS),
];

/// The Fresnel term that reflects all light.
pub(super) fn white() -> Described {
    let form = &FRESNEL_FORMS[0];
    Described { form, values: vec![Value::Numbers(Numbers::One(1.0))] }
}

/// A layer of a stack.
pub(super) static LAYER: Form = form!(Fresnel "layers": Terms <Stack>::LAYER);

/// An index of each channel.
pub(super) static INDICES: Form = form!(Fresnel "index": Keys <Conductor>::PARAMETERS);

/// The index of a measured material.
pub(super) static MATERIAL: Form = form!(Fresnel "index": Keys &[NAME]);

/// The index of samples.
pub(super) static SAMPLES: Form = form!(Fresnel "index": Keys &[NUMBERS]);

/// The index of a measured material relative to that outside.
pub(super) static MATERIAL_IN: Form = form!(Fresnel "index": Keys &[NAME, OUTSIDE]);

/// The index of samples relative to that outside.
pub(super) static SAMPLES_IN: Form = form!(Fresnel "index": Keys &[NUMBERS, OUTSIDE]);

const NAME: Parameter =
    Parameter::new("material", "", "key, symbol or name of a measured material", Kind::Text);

const NUMBERS: Parameter = Parameter::new(
    "samples",
    "",
    "wavelength in nm, n and k of each sample, by rising wavelength",
    Kind::Samples,
);

const OUTSIDE: Parameter = Parameter::new(
    "outside",
    "n₁",
    "index of the medium that the light comes from",
    Kind::RealIndex(range::ETA, 3),
)
.or(Preset::Number(1.0));

/// An index that is the same in all channels.
const ONE_INDEX: Kind = Kind::RealIndex(range::ETA, 1);

static DISTRIBUTION_FORMS: [Form; 5] = [
    form!(Distribution "gaussian": Keys <Gaussian>::PARAMETERS),
    form!(Distribution "beckmann": Keys <Beckmann>::PARAMETERS),
    form!(Distribution "ggx": Keys <Ggx>::PARAMETERS),
    form!(Distribution "blinn": Keys <Blinn>::PARAMETERS),
    form!(Distribution "mixture": Terms &[
        model!(@row weight: T, WEIGHT, "w", "weight, divided by the sum of all weights"),
        Parameter::new("distribution", "D", "the distribution", Kind::Part(Part::Distribution)),
    ]),
];

const FACETS: Parameter = Parameter::new(
    "distribution",
    "D",
    "density of the facets' normals",
    Kind::Part(Part::Distribution),
);

const REFLECTANCE: Parameter =
    Parameter::new("fresnel", "F", "reflectance of a facet", Kind::Part(Part::Fresnel));

const SHADOWING: Parameter = Parameter::new(
    "shadowing",
    "G",
    "fraction of facets that light and viewer both see; Smith's is known for some distributions",
    Kind::Word(&["v_cavity", "smith", "smith_separable"]),
)
.or(Preset::Shadowing);

const REFRACTED_SHADOWING: Parameter = Parameter::new(
    "shadowing",
    "G",
    "fraction of facets that light and viewer both see",
    Kind::Word(&["smith", "smith_separable"]),
)
.or(Preset::Word("smith"));

/// `Ta` and `Zn` are accepted although their sets are not for colour.
const METAL: Parameter = Parameter::new(
    "name",
    "",
    "symbol or name of a metal, alloy or semiconductor whose index was measured",
    Kind::Metal,
);

const fn joined<const N: usize>(first: &[Form], rest: &[Form]) -> [Form; N] {
    assert!(first.len() + rest.len() == N);
    let (mut all, mut index) = ([first[0]; N], 0);
    while index < N {
        all[index] = if index < first.len() { first[index] } else { rest[index - first.len()] };
        index += 1;
    }
    all
}

const fn names<const N: usize>(forms: &[Form; N]) -> [&'static str; N] {
    let (mut names, mut index) = ([""; N], 0);
    while index < N {
        names[index] = forms[index].name;
        index += 1;
    }
    names
}

const fn keys<const N: usize>(parameters: &[Parameter]) -> [&'static str; N] {
    let (mut keys, mut index) = ([""; N], 0);
    while index < N {
        keys[index] = parameters[index].name;
        index += 1;
    }
    keys
}
