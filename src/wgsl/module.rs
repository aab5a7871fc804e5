//! The text of a shader: models and what they need.

use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Write};

use super::error::ShaderError;
use super::expr::Expr;
use super::graph::{Graph, input, session};
use super::name::checked;
use super::parameters::{Binding, Parameters, Uniforms};
use super::prelude::Function;
use super::print::{Body, print};
use super::simplify::component;
use super::value::Width;
use super::vector::ExprVec3;
use crate::brdf::{Brdf, Sample};
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
    names: Vec<String>,
    functions: BTreeSet<Function>,
    samples: bool,
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
    /// If the name is no name of its own, or the model contains symbols.
    pub fn add<M>(&mut self, name: &str, model: &M) -> Result<(), ShaderError>
    where
        M: Brdf<Expr, Color = ExprVec3>,
    {
        self.named(name)?;
        let (results, graph) = session(|| Traced::new(model));
        self.functions_of(name, &results, &graph)
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
    /// If a name is no name of its own, or a constant of the model is not in its range.
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
        self.named(name)?;
        let (traced, graph) = session(|| {
            let mut parameters = Parameters::new(format!("{name}_parameters"));
            let model = make(&mut parameters).map_err(Into::into)?;
            let uniforms = parameters.done()?;
            Ok::<_, ShaderError>((Traced::new(&model), uniforms))
        });
        let (results, uniforms) = traced?;
        let before = self.text.len();
        self.structure(name, binding, &uniforms);
        let added = self.functions_of(name, &results, &graph);
        if added.is_err() {
            self.text.truncate(before);
        }
        added.map(|()| uniforms)
    }

    /// Adds `NAME_albedo`, the directional albedo of a model that is in the module: the mean weight
    /// of the 4181 samples of a lattice, in a loop over `NAME_sample`.
    ///
    /// # Errors
    /// If the module has no model of that name, or its albedo already.
    pub fn add_albedo(&mut self, name: &str) -> Result<(), ShaderError> {
        let albedo = format!("{name}_albedo");
        if !self.names.iter().any(|known| known == name) {
            return Err(ShaderError::Unknown(name.into()));
        }
        if self.names.contains(&albedo) {
            return Err(ShaderError::Taken(albedo));
        }
        let rows = LATTICE / ROW;
        let _ = write!(
            self.text,
            "
fn {albedo}(wo: vec3<f32>) -> vec3<f32> {{
    var sum = vec3<f32>(0.0);
    for (var row = 0u; row < {rows}u; row++) {{
        var part = vec3<f32>(0.0);
        for (var i = row * {ROW}u; i < (row + 1u) * {ROW}u; i++) {{
            let u = (vec2<f32>(vec2<u32>(i, i * {STEP}u % {LATTICE}u)) + 0.5) / {LATTICE}.0;
            part += {name}_sample(wo, u).weight;
        }}
        sum += part;
    }}
    return sum / {LATTICE}.0;
}}
"
        );
        self.names.push(albedo);
        Ok(())
    }

    /// Whether a name may be added.
    fn named(&self, name: &str) -> Result<(), ShaderError> {
        checked(name)?;
        let type_name = camel_case(name);
        if self.names.iter().any(|known| known == name || camel_case(known) == type_name) {
            return Err(ShaderError::Taken(name.into()));
        }
        Ok(())
    }

    fn structure(&mut self, name: &str, binding: Binding, uniforms: &Uniforms) {
        if uniforms.fields().is_empty() {
            return;
        }
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

    fn functions_of(
        &mut self,
        name: &str,
        results: &Traced,
        graph: &Graph,
    ) -> Result<(), ShaderError> {
        if graph.foreign {
            return Err(ShaderError::Foreign);
        }
        if graph.full {
            return Err(ShaderError::TooLong);
        }
        let Traced { eval, pdf, sample } = results;
        let body = print(graph, &[(eval.0, Width::Three)]);
        self.function(&format!("{name}_eval"), PAIR, "vec3<f32>", &body, "");
        let body = print(graph, &[(pdf.0, Width::One)]);
        self.function(&format!("{name}_pdf"), PAIR, "f32", &body, "");
        let body = print(
            graph,
            &[
                (sample.wi.0, Width::Three),
                (sample.weight.0, Width::Three),
                (sample.pdf.0, Width::One),
            ],
        );
        self.function(&format!("{name}_sample"), DRAW, "BrdfSample", &body, "BrdfSample");
        self.samples = true;
        self.names.push(name.to_string());
        Ok(())
    }

    fn function(&mut self, name: &str, arguments: &str, kind: &str, body: &Body, made: &str) {
        self.functions.extend(&body.functions);
        let text = &mut self.text;
        let _ = write!(text, "\nfn {name}({arguments}) -> {kind} {{\n");
        for statement in &body.statements {
            let _ = writeln!(text, "    {statement}");
        }
        let results = body.results.join(", ");
        let _ = if made.is_empty() {
            write!(text, "    return {results};\n}}\n")
        } else {
            write!(text, "    return {made}({results});\n}}\n")
        };
    }
}

const PAIR: &str = "wi: vec3<f32>, wo: vec3<f32>";
const DRAW: &str = "wo: vec3<f32>, u: vec2<f32>";

/// What the functions of a model answer to symbols.
struct Traced {
    eval: ExprVec3,
    pdf: Expr,
    sample: Sample<Expr, ExprVec3>,
}

impl Traced {
    fn new<M: Brdf<Expr, Color = ExprVec3>>(model: &M) -> Self {
        let direction = |name: &str| ExprVec3(input(name.into(), Width::Three));
        let (wi, wo) = (direction("wi"), direction("wo"));
        let u = input("u".into(), Width::Two);
        let u = [0, 1].map(|place| Expr(component(u, place)));
        Self { eval: model.eval(wi, wo), pdf: model.pdf(wi, wo), sample: model.sample(wo, u) }
    }
}

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
        let mut needed = self.functions.clone();
        let mut new: Vec<Function> = needed.iter().copied().collect();
        while let Some(function) = new.pop() {
            new.extend(function.needs().filter(|other| needed.insert(*other)));
        }
        for (index, function) in needed.iter().enumerate() {
            f.write_str(if index == 0 { "" } else { "\n" })?;
            f.write_str(function.text())?;
        }
        if self.samples {
            f.write_str(SAMPLE)?;
        }
        f.write_str(&self.text)
    }
}

const SAMPLE: &str = "
struct BrdfSample {
    // Towards the light.
    wi: vec3<f32>,
    // f cos/pdf; zero where there is no direction.
    weight: vec3<f32>,
    // Per steradian.
    pdf: f32,
}
";
