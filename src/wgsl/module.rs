//! The text of a shader: models and what they need.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::{self, Write};

use super::error::ShaderError;
use super::expr::{Expr, ExprVec3};
use super::function::{Answer, Arguments};
use super::graph::{Graph, MOST, session};
use super::literal::LARGEST;
use super::name::checked;
use super::parameters::{Binding, Parameters, Uniforms};
use super::prelude::Function;
use super::print::{Body, print};
use super::traced::{Kind, Traced};
use super::value::{Value, Width};
use crate::brdf::Brdf;
use crate::bsdf::{Bsdf, TransportMode};
use crate::quadrature::{LATTICE, ROW, STEP};

/// A piece of WGSL: functions of models, and the elementary functions that these use.
///
/// Its text, by [`Display`](fmt::Display), is to be put in front of a shader that calls them.
///
/// ```
/// use brdf::wgsl::Module;
/// use brdf::{Beckmann, Conductor, CookTorrance, Lift};
/// use glam::Vec3;
///
/// let gold = CookTorrance::new(
///     Beckmann::new(0.3)?,
///     Conductor::new(Vec3::new(0.16, 0.42, 1.38), Vec3::new(3.66, 2.47, 1.91))?,
/// );
/// let mut module = Module::new();
/// module.add("gold", &gold.lift(|parameter| parameter.into()))?;
/// let text = module.to_string();
/// assert!(text.contains("fn gold_eval(wi: vec3<f32>, wo: vec3<f32>) -> vec3<f32> {"));
/// assert!(text.contains("fn gold_pdf(wi: vec3<f32>, wo: vec3<f32>) -> f32 {"));
/// assert!(text.contains("fn gold_sample(wo: vec3<f32>, u: vec2<f32>) -> BrdfSample {"));
/// # Ok::<(), brdf::wgsl::ShaderError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Module {
    names: BTreeSet<String>,
    bindings: Vec<Binding>,
    functions: BTreeSet<Function>,
    samples: BTreeSet<Kind>,
    /// What the models are.
    models: BTreeMap<String, Kind>,
    text: String,
}

impl Module {
    /// An empty module.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds `NAME_eval`, `NAME_pdf` and `NAME_sample` of a model whose parameters are constants.
    ///
    /// # Errors
    /// If the name is no name of its own, or the model contains symbols or constants that are not
    /// finite.
    pub fn add<M>(&mut self, name: &str, model: &M) -> Result<(), ShaderError>
    where
        M: Brdf<Expr, Color = ExprVec3>,
    {
        self.traced(name, || Traced::brdf(model))
    }

    /// Adds the functions of a model over the whole sphere for one of the modes: as [`add`](Self::add),
    /// but that `NAME_sample` takes three uniform numbers and says whether what it drew is a specular
    /// lobe.
    ///
    /// ```
    /// use brdf::wgsl::Module;
    /// use brdf::{Ggx, Lift, RoughDielectric, TransportMode};
    ///
    /// let frosted = RoughDielectric::new(Ggx::new(0.3_f32)?, 1.5)?.lift(|number| number.into());
    /// let mut module = Module::new();
    /// module.add_bsdf("frosted", &frosted, TransportMode::Radiance)?;
    /// module.add_bsdf("frosted_importance", &frosted, TransportMode::Importance)?;
    /// let text = module.to_string();
    /// assert!(text.contains("fn frosted_sample(wo: vec3<f32>, u: vec3<f32>) -> BsdfSample {"));
    /// # Ok::<(), brdf::wgsl::ShaderError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`add`](Self::add).
    pub fn add_bsdf<M>(
        &mut self,
        name: &str,
        model: &M,
        mode: TransportMode,
    ) -> Result<(), ShaderError>
    where
        M: Bsdf<Expr, Color = ExprVec3>,
    {
        self.traced(name, || Traced::bsdf(model, mode))
    }

    fn traced(&mut self, name: &str, trace: impl FnOnce() -> Traced) -> Result<(), ShaderError> {
        let (results, graph) = session(trace);
        self.claim(Names::model(name)?, &graph, results.values())?;
        self.functions_of(name, results, &graph);
        Ok(())
    }

    /// Adds the functions of a model whose parameters come from a uniform buffer.
    ///
    /// `make` makes the model of parameters, which are fields of the structure `NameParameters`. Symbols
    /// have no value yet that could be checked: what the buffer holds has to be in the ranges that the
    /// model's constructor states.
    ///
    /// ```
    /// use brdf::wgsl::{Binding, Module};
    /// use brdf::{Lambert, OrenNayar};
    /// use glam::DVec3;
    ///
    /// let mut module = Module::new();
    /// let uniforms = module.add_with("clay", Binding { group: 1, binding: 0 }, |parameters| {
    ///     let sigma = parameters.number("sigma", 0.3);
    ///     let albedo = parameters.color("albedo", DVec3::new(0.8, 0.4, 0.3));
    ///     OrenNayar::new(albedo, sigma)
    /// })?;
    /// assert_eq!((uniforms.fields()[1].offset, uniforms.bytes().len()), (16, 32));
    /// assert!(module.to_string().contains("clay_parameters.sigma"));
    /// # Ok::<(), brdf::wgsl::ShaderError>(())
    /// ```
    ///
    /// # Errors
    /// If a name is no name of its own, the module has a buffer at that place, a constant of the model
    /// is not in its range, or a constant or parameter is not finite.
    pub fn add_with<M, E>(
        &mut self,
        name: &str,
        binding: Binding,
        make: impl FnOnce(&mut Parameters) -> Result<M, E>,
    ) -> Result<Uniforms, ShaderError>
    where
        M: Brdf<Expr, Color = ExprVec3>,
        E: Into<ShaderError>,
    {
        self.traced_with(name, binding, make, Traced::brdf)
    }

    /// Adds the functions of a model over the whole sphere whose parameters come from a uniform buffer:
    /// [`add_bsdf`](Self::add_bsdf) as [`add_with`](Self::add_with).
    ///
    /// # Errors
    /// As there.
    pub fn add_bsdf_with<M, E>(
        &mut self,
        name: &str,
        mode: TransportMode,
        binding: Binding,
        make: impl FnOnce(&mut Parameters) -> Result<M, E>,
    ) -> Result<Uniforms, ShaderError>
    where
        M: Bsdf<Expr, Color = ExprVec3>,
        E: Into<ShaderError>,
    {
        self.traced_with(name, binding, make, |model| Traced::bsdf(model, mode))
    }

    fn traced_with<M, E: Into<ShaderError>>(
        &mut self,
        name: &str,
        binding: Binding,
        make: impl FnOnce(&mut Parameters) -> Result<M, E>,
        trace: impl FnOnce(&M) -> Traced,
    ) -> Result<Uniforms, ShaderError> {
        let (traced, graph) = session(|| {
            let mut parameters = Parameters::new(format!("{name}_parameters"));
            let model = make(&mut parameters).map_err(Into::into)?;
            let uniforms = parameters.done()?;
            Ok::<_, ShaderError>((trace(&model), uniforms))
        });
        let (results, uniforms) = traced?;
        self.check_free(binding, &uniforms)?;
        self.claim(Names::model(name)?.with_parameters(), &graph, results.values())?;
        self.structure(name, binding, &uniforms);
        self.functions_of(name, results, &graph);
        Ok(uniforms)
    }

    /// Adds a function of any formula: a Fresnel term, a distribution, a derivative.
    ///
    /// ```
    /// use brdf::wgsl::{Expr, ExprVec3, Module};
    /// use brdf::{Distribution, Ggx};
    ///
    /// let ggx = Ggx::new(Expr::from(0.3))?;
    /// let mut module = Module::new();
    /// module.add_function("facets", ["h"], |(h,): (ExprVec3,)| ggx.density(h))?;
    /// assert!(module.to_string().contains("fn facets(h: vec3<f32>) -> f32 {"));
    /// # Ok::<(), brdf::wgsl::ShaderError>(())
    /// ```
    ///
    /// # Errors
    /// If a name is no name of its own, a symbol is one of another function, or a constant is not finite:
    ///
    /// ```
    /// use brdf::Real;
    /// use brdf::wgsl::{Expr, Module};
    ///
    /// let scaled = |(x,): (Expr,)| x * (Expr::one() / Expr::zero());
    /// let error = Module::new().add_function("scaled", ["x"], scaled).unwrap_err();
    /// let message = r#"the constants of "scaled" must be finite in single precision, not inf"#;
    /// assert_eq!(error.to_string(), message);
    /// ```
    pub fn add_function<A: Arguments<N>, R: Answer, const N: usize>(
        &mut self,
        name: &str,
        arguments: [&str; N],
        formula: impl FnOnce(A) -> R,
    ) -> Result<(), ShaderError> {
        let (results, graph) = session(|| formula(A::symbols(arguments)).parts());
        let names = Names::function(name, &arguments)?;
        self.claim(names, &graph, results.iter().map(|part| part.0))?;
        self.formula::<A, R, N>(name, arguments, &results, &graph);
        Ok(())
    }

    /// Adds a function of any formula that has parameters in a uniform buffer, as
    /// [`add_with`](Self::add_with).
    ///
    /// # Errors
    /// As there.
    pub fn add_function_with<A: Arguments<N>, R: Answer, E: Into<ShaderError>, const N: usize>(
        &mut self,
        name: &str,
        binding: Binding,
        arguments: [&str; N],
        formula: impl FnOnce(&mut Parameters, A) -> Result<R, E>,
    ) -> Result<Uniforms, ShaderError> {
        let (traced, graph) = session(|| {
            let mut parameters = Parameters::new(format!("{name}_parameters"));
            let results = formula(&mut parameters, A::symbols(arguments)).map_err(Into::into)?;
            Ok::<_, ShaderError>((results.parts(), parameters.done()?))
        });
        let (results, uniforms) = traced?;
        let names = Names::function(name, &arguments)?;
        self.check_free(binding, &uniforms)?;
        let values = results.iter().map(|part| part.0);
        self.claim(names.with_parameters(), &graph, values)?;
        self.structure(name, binding, &uniforms);
        self.formula::<A, R, N>(name, arguments, &results, &graph);
        Ok(uniforms)
    }

    /// Adds `NAME_albedo`, the directional albedo of a model of reflection that is in the module: the mean
    /// weight of the 4181 samples of a lattice, in a loop over `NAME_sample`.
    ///
    /// A model over the whole sphere has no such function. What its samples weigh on the mean is all that it
    /// reflects and transmits, lobes included, and depends on the mode: refraction scales
    /// [radiance](TransportMode::Radiance).
    ///
    /// ```
    /// use brdf::wgsl::{Module, ShaderError};
    /// use brdf::{Lift, SmoothDielectric, TransportMode};
    ///
    /// let glass = SmoothDielectric::new(1.5_f32)?.lift(|number| number.into());
    /// let mut module = Module::new();
    /// module.add_bsdf("glass", &glass, TransportMode::Radiance)?;
    /// assert_eq!(module.add_albedo("glass"), Err(ShaderError::WholeSphere("glass".into())));
    /// # Ok::<(), ShaderError>(())
    /// ```
    ///
    /// # Errors
    /// If the module has no model of that name, or its albedo already, or if the model is one over the whole
    /// sphere.
    pub fn add_albedo(&mut self, name: &str) -> Result<(), ShaderError> {
        let (albedo, sample) = (format!("{name}_albedo"), format!("{name}_sample"));
        match self.models.get(name) {
            Some(Kind::Brdf) => {}
            Some(Kind::Bsdf) => return Err(ShaderError::WholeSphere(name.into())),
            None => return Err(ShaderError::Unknown(name.into())),
        }
        if !self.names.insert(albedo.clone()) {
            return Err(ShaderError::Taken(albedo));
        }
        let rows = LATTICE / ROW;
        let _ = write!(
            self.text,
            "
// The directional albedo: the mean weight of {LATTICE} samples.
fn {albedo}(wo: vec3<f32>) -> vec3<f32> {{
    var sum = vec3<f32>(0.0);
    for (var row = 0u; row < {rows}u; row++) {{
        var part = vec3<f32>(0.0);
        for (var i = row * {ROW}u; i < (row + 1u) * {ROW}u; i++) {{
            let u = (vec2<f32>(vec2<u32>(i, i * {STEP}u % {LATTICE}u)) + 0.5) / {LATTICE}.0;
            part += {sample}(wo, u).weight;
        }}
        sum += part;
    }}
    return sum / {LATTICE}.0;
}}
"
        );
        Ok(())
    }

    /// Takes names, all of them or none, for functions whose graph is in order.
    fn claim(
        &mut self,
        names: Names<'_>,
        graph: &Graph,
        results: impl IntoIterator<Item = Value>,
    ) -> Result<(), ShaderError> {
        if graph.foreign {
            return Err(ShaderError::Foreign(names.name.into()));
        }
        if graph.full {
            return Err(ShaderError::TooLong { name: names.name.into(), most: MOST });
        }
        if let Some(taken) = names.taken.iter().find(|name| self.names.contains(*name)) {
            return Err(ShaderError::Taken(taken.clone()));
        }
        if let Some(value) = graph.not_finite(results) {
            return Err(ShaderError::NotFinite { name: names.name.into(), value });
        }
        self.names.extend(names.taken);
        Ok(())
    }

    /// Checks that no buffer is at that place yet, if one is to come there.
    fn check_free(&self, binding: Binding, uniforms: &Uniforms) -> Result<(), ShaderError> {
        if !uniforms.fields().is_empty() && self.bindings.contains(&binding) {
            return Err(ShaderError::Bound(binding));
        }
        Ok(())
    }

    fn formula<A: Arguments<N>, R: Answer, const N: usize>(
        &mut self,
        name: &str,
        arguments: [&str; N],
        results: &[ExprVec3],
        graph: &Graph,
    ) {
        let kinds = arguments.iter().zip(A::kinds());
        let kinds: Vec<String> = kinds.map(|(name, kind)| format!("{name}: {kind}")).collect();
        let result = R::kind();
        let width = if R::WIDE { Width::Three } else { Width::One };
        let results: Vec<_> = results.iter().map(|part| (part.0, width)).collect();
        self.function(Signature {
            comment: "",
            name,
            arguments: &kinds.join(", "),
            result: &result,
            body: &print(graph, &results),
            parts: &[],
        });
    }

    fn structure(&mut self, name: &str, binding: Binding, uniforms: &Uniforms) {
        if uniforms.fields().is_empty() {
            return;
        }
        self.bindings.push(binding);
        let (kind, Binding { group, binding }) = (camel_case(name), binding);
        let text = &mut self.text;
        let _ = write!(text, "\nstruct {kind}Parameters {{\n");
        for (member, kind) in uniforms.members() {
            let _ = writeln!(text, "    {member}: {kind},");
        }
        let _ = write!(
            text,
            "}}\n@group({group}) @binding({binding})\nvar<uniform> {name}_parameters: {kind}Parameters;\n"
        );
    }

    fn functions_of(&mut self, name: &str, results: Traced, graph: &Graph) {
        let Traced { kind, eval, pdf, sample } = results;
        self.function(Signature {
            comment: "f(wi, wo) per steradian, without the cosine.",
            name: &format!("{name}_eval"),
            arguments: PAIR,
            result: "vec3<f32>",
            body: &print(graph, &[(eval.0, Width::Three)]),
            parts: &[],
        });
        self.function(Signature {
            comment: "The density per steradian of the samples for wo.",
            name: &format!("{name}_pdf"),
            arguments: PAIR,
            result: "f32",
            body: &print(graph, &[(pdf.0, Width::One)]),
            parts: &[],
        });
        self.function(Signature {
            comment: kind.comment(),
            name: &format!("{name}_sample"),
            arguments: kind.arguments(),
            result: kind.name(),
            body: &print(graph, &sample),
            parts: kind.parts(),
        });
        self.samples.insert(kind);
        self.models.insert(name.into(), kind);
    }

    fn function(&mut self, signature: Signature<'_>) {
        let Signature { comment, name, arguments, result, body, parts } = signature;
        self.functions.extend(&body.functions);
        let text = &mut self.text;
        let (before, after) = if comment.is_empty() { ("", "") } else { ("// ", "\n") };
        let _ = write!(text, "\n{before}{comment}{after}fn {name}({arguments}) -> {result} {{\n");
        for statement in &body.statements {
            let _ = writeln!(text, "    {statement}");
        }
        // A result of several parts is made of named ones.
        for (part, value) in parts.iter().zip(&body.results).filter(|(part, value)| part != value) {
            let _ = writeln!(text, "    let {part} = {value};");
        }
        let _ = match body.results.as_slice() {
            [one] if !result.starts_with("array") => writeln!(text, "    return {one};\n}}"),
            results if parts.is_empty() => {
                writeln!(text, "    return {result}({});\n}}", results.join(", "))
            }
            _ => writeln!(text, "    return {result}({});\n}}", parts.join(", ")),
        };
    }
}

/// The names that an addition takes, all made of one.
struct Names<'a> {
    name: &'a str,
    taken: Vec<String>,
}

impl<'a> Names<'a> {
    fn model(name: &'a str) -> Result<Self, ShaderError> {
        checked(name)?;
        let taken = ["eval", "pdf", "sample"].map(|kind| format!("{name}_{kind}")).into();
        Ok(Self { name, taken })
    }

    fn function(name: &'a str, arguments: &[&str]) -> Result<Self, ShaderError> {
        for (index, argument) in arguments.iter().enumerate() {
            checked(argument)?;
            if arguments[..index].contains(argument) {
                return Err(ShaderError::Taken((*argument).into()));
            }
        }
        Ok(Self { name, taken: Vec::from([checked(name)?.into()]) })
    }

    /// And those of a uniform buffer.
    fn with_parameters(mut self) -> Self {
        let Self { name, .. } = self;
        self.taken
            .extend([format!("{name}_parameters"), format!("{}Parameters", camel_case(name))]);
        self
    }
}

/// A function to be written.
struct Signature<'a> {
    comment: &'a str,
    name: &'a str,
    arguments: &'a str,
    result: &'a str,
    body: &'a Body,
    /// What the parts of the result are called, if it has some.
    parts: &'a [&'a str],
}

const PAIR: &str = "wi: vec3<f32>, wo: vec3<f32>";

/// `RedClay` for `red_clay`.
fn camel_case(name: &str) -> String {
    let word = |word: &str| {
        let mut letters = word.chars();
        let first = letters.next().map(|letter| letter.to_ascii_uppercase());
        first.into_iter().chain(letters).collect::<String>()
    };
    name.split('_').map(word).collect()
}

impl fmt::Display for Module {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(LARGEST)?;
        let mut needed = self.functions.clone();
        let mut new: Vec<Function> = needed.iter().copied().collect();
        while let Some(function) = new.pop() {
            new.extend(function.needs().filter(|other| needed.insert(*other)));
        }
        for function in needed {
            f.write_str("\n")?;
            f.write_str(function.text())?;
        }
        for kind in &self.samples {
            f.write_str(kind.structure())?;
        }
        f.write_str(&self.text)
    }
}
