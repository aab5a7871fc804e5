//! Parameters that a shader reads from a uniform buffer.

use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use glam::DVec3;

use super::error::ShaderError;
use super::expr::{Expr, ExprVec3};
use super::graph::input;
use super::name::checked;
use super::simplify::component;
use super::value::{Value, Width};

/// Where a shader finds its uniform buffer: `@group` and `@binding`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Binding {
    /// The number of the bind group.
    pub group: u32,
    /// The number in the group.
    pub binding: u32,
}

/// A parameter in a uniform buffer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Field {
    /// The name in the shader's structure.
    pub name: String,
    /// Where the value begins, in bytes.
    pub offset: usize,
    /// The value that was given: one number, two, or the three channels of a colour.
    pub values: Vec<f64>,
}

/// What a shader's uniform buffer consists of, packed as the language demands: in order, a colour
/// at a multiple of 16 bytes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Uniforms {
    fields: Vec<Field>,
}

impl Uniforms {
    /// The parameters, in their order.
    #[must_use]
    pub fn fields(&self) -> &[Field] {
        &self.fields
    }

    /// The size of the buffer, in bytes.
    #[must_use]
    pub fn size(&self) -> usize {
        let end = self.fields.last().map_or(0, |field| field.offset + 4 * field.values.len());
        let alignment = self.fields.iter().map(|field| alignment(field.values.len())).max();
        end.next_multiple_of(alignment.unwrap_or(4))
    }

    /// The buffer with the values that were given, rounded to `f32`, in the order of bytes of all
    /// graphics processors.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![0; self.size()];
        for field in &self.fields {
            let places = bytes.iter_mut().skip(field.offset);
            #[allow(clippy::cast_possible_truncation, reason = "shaders compute in f32")]
            let values = field.values.iter().flat_map(|value| (*value as f32).to_le_bytes());
            places.zip(values).for_each(|(place, byte)| *place = byte);
        }
        bytes
    }

    fn push(&mut self, name: &str, values: &[f64]) {
        let end = self.fields.last().map_or(0, |field| field.offset + 4 * field.values.len());
        let offset = end.next_multiple_of(alignment(values.len()));
        self.fields.push(Field { name: name.into(), offset, values: values.into() });
    }

    /// The members of the structure.
    pub(super) fn members(&self) -> impl Iterator<Item = (&str, &'static str)> {
        self.fields.iter().map(|field| {
            let kind = match field.values.len() {
                1 => "f32",
                2 => "vec2<f32>",
                _ => "vec3<f32>",
            };
            (field.name.as_str(), kind)
        })
    }
}

/// The alignment of so many numbers.
fn alignment(numbers: usize) -> usize {
    match numbers {
        1 => 4,
        2 => 8,
        _ => 16,
    }
}

/// The parameters of a model that is being written: each call makes one, with the value that it begins
/// with, which has to be finite in single precision.
#[derive(Debug)]
pub struct Parameters {
    /// The variable that holds them.
    variable: String,
    uniforms: Uniforms,
    wrong: Option<ShaderError>,
}

impl Parameters {
    pub(super) fn new(variable: String) -> Self {
        Self { variable, uniforms: Uniforms::default(), wrong: None }
    }

    /// A number.
    #[must_use]
    pub fn number(&mut self, name: &str, value: f64) -> Expr {
        Expr(self.field(name, &[value], Width::One))
    }

    /// Two numbers: along the tangent and the bitangent.
    #[must_use]
    pub fn pair(&mut self, name: &str, values: [f64; 2]) -> [Expr; 2] {
        let pair = self.field(name, &values, Width::Two);
        [Expr(component(pair, 0)), Expr(component(pair, 1))]
    }

    /// A colour.
    #[must_use]
    pub fn color(&mut self, name: &str, value: DVec3) -> ExprVec3 {
        ExprVec3(self.field(name, &value.to_array(), Width::Three))
    }

    fn field(&mut self, name: &str, values: &[f64], width: Width) -> Value {
        let taken = self.uniforms.fields.iter().any(|field| field.name == name);
        let checked = if taken { Err(ShaderError::Taken(name.into())) } else { checked(name) };
        #[allow(clippy::cast_possible_truncation, reason = "shaders compute in f32")]
        let wrong = values.iter().find(|value| !(**value as f32).is_finite());
        let finite = match wrong {
            Some(&value) => Err(ShaderError::NotFinite { name: name.into(), value }),
            None => Ok(()),
        };
        if let Err(error) = checked.and(finite) {
            self.wrong.get_or_insert(error);
        }
        self.uniforms.push(name, values);
        input(format!("{}.{name}", self.variable), width)
    }

    pub(super) fn done(self) -> Result<Uniforms, ShaderError> {
        self.wrong.map_or(Ok(self.uniforms), Err)
    }
}
