//! Described models in a module.

use alloc::collections::BTreeMap;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::error::ShaderError;
use super::expr::Expr;
use super::module::Module;
use super::parameters::{Binding, Parameters, Uniforms};
use crate::bsdf::TransportMode;
use crate::description::{BrdfDescription, BsdfDescription, DescriptionError, Path};
use crate::real::Vector;

impl Module {
    /// Adds the functions of a described model whose parameters are constants.
    ///
    /// # Errors
    /// If the name is no name of its own, or a value is not in its range in single precision.
    pub fn add_described(
        &mut self,
        name: &str,
        description: &BrdfDescription,
    ) -> Result<(), ShaderError> {
        self.add(name, &description.build::<Expr>()?)
    }

    /// Adds the functions of a described model whose parameters come from a uniform buffer: every
    /// number of the description, a metal's indices excepted. Fields have the names of the keys, with
    /// as many of those above in front as tells them apart.
    ///
    /// ```
    /// use brdf::description::BrdfDescription;
    /// use brdf::wgsl::{Binding, Module};
    ///
    /// let paint: BrdfDescription = serde_json::from_str(r#"{"sum": [
    ///     {"weight": 0.9, "brdf": {"lambert": {"albedo": [0.8, 0.2, 0.1]}}},
    ///     {"weight": 0.1, "brdf": {"phong": {"specular": 1, "exponent": 40}}}
    /// ]}"#)?;
    /// let uniforms = Module::new().add_described_with("paint", &paint, Binding::default())?;
    /// let names: Vec<_> = uniforms.fields().iter().map(|field| field.name.as_str()).collect();
    /// assert_eq!(names, ["sum_0_weight", "albedo", "sum_1_weight", "specular", "exponent"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As for [`add_described`](Self::add_described).
    pub fn add_described_with(
        &mut self,
        name: &str,
        description: &BrdfDescription,
        binding: Binding,
    ) -> Result<Uniforms, ShaderError> {
        let given = Given::of(|number| description.build_with(number).map(|_| ()))?;
        self.add_with(name, binding, |parameters| description.build_with(given.symbols(parameters)))
    }

    /// Adds the functions of a described model over the whole sphere whose parameters are constants:
    /// [`add_bsdf`](Self::add_bsdf) as [`add_described`](Self::add_described).
    ///
    /// # Errors
    /// As there.
    pub fn add_described_bsdf(
        &mut self,
        name: &str,
        description: &BsdfDescription,
        mode: TransportMode,
    ) -> Result<(), ShaderError> {
        self.add_bsdf(name, &description.build::<Expr>()?, mode)
    }

    /// Adds the functions of a described model over the whole sphere whose parameters come from a uniform
    /// buffer: [`add_bsdf_with`](Self::add_bsdf_with) as
    /// [`add_described_with`](Self::add_described_with).
    ///
    /// # Errors
    /// As there.
    pub fn add_described_bsdf_with(
        &mut self,
        name: &str,
        description: &BsdfDescription,
        mode: TransportMode,
        binding: Binding,
    ) -> Result<Uniforms, ShaderError> {
        let given = Given::of(|number| description.build_with(number).map(|_| ()))?;
        self.add_bsdf_with(name, mode, binding, |parameters| {
            description.build_with(given.symbols(parameters))
        })
    }
}

/// A parameter of a description.
struct One {
    /// The keys and indices that lead to it.
    steps: Vec<String>,
    /// The places and values of its numbers.
    numbers: Vec<(String, f64)>,
}

/// The parameters of a description.
struct Given(Vec<One>);

impl Given {
    /// Of a description that is built of numbers by their places.
    fn of(
        build: impl FnOnce(&mut dyn FnMut(&Path<'_>, f64) -> f64) -> Result<(), DescriptionError>,
    ) -> Result<Self, ShaderError> {
        let mut parameters: Vec<One> = Vec::new();
        build(&mut |path, value| {
            let text = path.to_string();
            let is_component = text.ends_with(']');
            let whole = text.rsplit_once('[').filter(|_| is_component).map_or(&*text, |it| it.0);
            let steps: Vec<String> = whole
                .split(['.', '[', ']'])
                .filter(|step| !step.is_empty())
                .map(String::from)
                .collect();
            match parameters.last_mut() {
                Some(known) if known.steps == steps => known.numbers.push((text, value)),
                _ => parameters.push(One { steps, numbers: Vec::from([(text, value)]) }),
            }
            value
        })?;
        Ok(Self(parameters))
    }

    /// As many of the last steps as no other parameter has, from a key on.
    fn name(&self, steps: &[String]) -> String {
        let names = (1..=steps.len()).map(|count| &steps[steps.len() - count..]);
        let mut names = names.filter(|name| {
            let begins = |letter: char| letter.is_ascii_alphabetic();
            let alone = self.0.iter().filter(|other| other.steps.ends_with(name)).count();
            // What begins with `brdf` are names of the crate.
            let first = name.first().is_some_and(|step| step.starts_with(begins) && step != "brdf");
            first && alone == 1
        });
        names.next().unwrap_or(steps).join("_")
    }

    /// A field for each parameter, and the symbols of its numbers by their places; the value of what has
    /// none.
    fn symbols(&self, parameters: &mut Parameters) -> impl FnMut(&Path<'_>, f64) -> Expr + use<> {
        let mut symbols = BTreeMap::new();
        for One { steps, numbers } in &self.0 {
            let name = self.name(steps);
            let values: Vec<f64> = numbers.iter().map(|(_, value)| *value).collect();
            let fields: Vec<Expr> = match *values.as_slice() {
                [value] => Vec::from([parameters.number(&name, value)]),
                [x, y] => parameters.pair(&name, [x, y]).into(),
                [x, y, z, ..] => {
                    let color = parameters.color(&name, glam::DVec3::new(x, y, z));
                    Vec::from([color.x(), color.y(), color.z()])
                }
                [] => Vec::new(),
            };
            let places = numbers.iter().map(|(place, _)| place.clone());
            symbols.extend(places.zip(fields));
        }
        move |path, value| symbols.get(&path.to_string()).copied().unwrap_or_else(|| value.into())
    }
}
