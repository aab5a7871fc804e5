//! Models of the registry with any parameters.

use std::sync::LazyLock;

use arbitrary::{Arbitrary, Result, Unstructured};
use brdf::description::{BrdfDescription, BsdfDescription};
use ciborium::Value;

use crate::numbers::{Channels, Number};

/// What a model promises, whatever its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Promise {
    pub reciprocal: bool,
    /// The largest directional albedo.
    pub albedo: f64,
    /// The largest weight of a sample, and what is added to it over the larger cosine.
    pub weight: f64,
    pub grooves: f64,
}

impl Promise {
    pub fn largest_weight(self, cos_i: f64, cos_o: f64) -> f64 {
        self.weight + self.grooves / cos_i.max(cos_o)
    }

    fn scaled(self, scale: f64) -> Self {
        Self { albedo: self.albedo * scale, weight: self.weight * scale, ..self }
    }
}

struct Row {
    tree: Value,
    promise: Promise,
}

/// The lines of the registry. Sums are made of them here.
static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let row = |line: &str| {
        let row: serde_json::Value = serde_json::from_str(line).expect("a line of JSON");
        let (brdf, promises) = (&row["brdf"], &row["promises"]);
        let number = |value: &serde_json::Value, default| value.as_f64().unwrap_or(default);
        let largest = number(&promises["largest_weight"], 1.0);
        let promise = Promise {
            reciprocal: promises["reciprocal"].as_bool().unwrap_or(true),
            albedo: number(&promises["bounds"]["albedo"], 1.0),
            weight: number(&promises["bounds"]["weight"], largest),
            grooves: number(&promises["grooves"], 0.0),
        };
        let tree = Value::serialized(brdf).expect("JSON fits CBOR");
        brdf.get("sum").is_none().then_some(Row { tree, promise })
    };
    include_str!("../../tests/registry.jsonl").lines().filter_map(row).collect()
});

/// A description that may be wrong in its numbers, as a tree: unlike JSON, it holds NaN and infinity.
#[derive(Clone, Debug)]
pub struct Model {
    tree: Value,
    promise: Promise,
}

impl<'a> Arbitrary<'a> for Model {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        if u.ratio(1, 6)? {
            let mut terms = Vec::new();
            // Ends with the bytes, as each term takes some.
            while u.arbitrary()? && !u.is_empty() {
                terms.push((u.arbitrary::<Channels>()?, Self::arbitrary(u)?));
            }
            return Ok(Self::sum(&terms));
        }
        let Row { tree, promise } = u.choose(&ROWS)?;
        let mut tree = tree.clone();
        let mut light = None;
        vary(&mut tree, false, &mut light, u)?;
        Ok(Self { tree, promise: promise.scaled(light.unwrap_or(1.0)) })
    }
}

/// Replaces most numbers by others, some by lists, and notes the largest one of a light, which
/// what is reflected contains.
fn vary(
    tree: &mut Value,
    is_light: bool,
    light: &mut Option<f64>,
    u: &mut Unstructured<'_>,
) -> Result<()> {
    match tree {
        Value::Integer(_) | Value::Float(_) => {
            let kept = tree.as_float().or(tree.as_integer().map(|n| i128::from(n) as f64));
            let mut numbers = vec![kept.unwrap_or(0.0)];
            if u.ratio(7, 8)? {
                let count = if u.ratio(1, 16)? { u.int_in_range(2..=3)? } else { 1 };
                numbers = vec![0.0; count];
                for number in &mut numbers {
                    *number = Number::arbitrary(u)?.0;
                }
            }
            if is_light {
                let largest = numbers.iter().copied().fold(light.unwrap_or(0.0), f64::max);
                *light = Some(largest);
            }
            *tree = match numbers[..] {
                [number] => Value::Float(number),
                _ => Value::Array(numbers.into_iter().map(Value::Float).collect()),
            };
        }
        Value::Array(list) => {
            for inner in list {
                vary(inner, is_light, light, u)?;
            }
        }
        Value::Map(keys) => {
            for (key, inner) in keys {
                vary(inner, key.as_text() == Some("light"), light, u)?;
            }
        }
        _ => {}
    }
    Ok(())
}

impl Model {
    /// The description, if its numbers are in range.
    pub fn read(&self) -> Option<BrdfDescription> {
        self.tree.deserialized().ok()
    }

    /// What must hold of the model, if its parameters are in range.
    pub fn promise(&self) -> Promise {
        self.promise
    }

    fn sum(terms: &[(Channels, Self)]) -> Self {
        let text = |text: &str| Value::Text(text.to_owned());
        let mut all = Promise { reciprocal: true, albedo: 0.0, weight: 0.0, grooves: 0.0 };
        let (mut trees, mut total) = (Vec::new(), 0.0);
        for (Channels(weight), Self { tree, promise }) in terms {
            let largest = weight.iter().copied().fold(0.0, f64::max);
            total += weight.iter().sum::<f64>();
            all.albedo += largest * promise.albedo;
            all.weight = all.weight.max(promise.weight);
            all.grooves = all.grooves.max(promise.grooves);
            all.reciprocal &= promise.reciprocal;
            let weight = Value::Array(weight.map(Value::Float).to_vec());
            trees.push(Value::Map(vec![(text("weight"), weight), (text("brdf"), tree.clone())]));
        }
        // A channel weighs at most three times the mean that its probability is made of. Where the
        // density is a subnormal number its rounding counts.
        let scaled = |value: f64| (value * (total * 2.0).min(f64::MAX)).min(f64::MAX);
        Self {
            tree: Value::Map(vec![(text("sum"), Value::Array(trees))]),
            promise: Promise { weight: scaled(all.weight), grooves: scaled(all.grooves), ..all },
        }
    }
}

/// The lines of models over the whole sphere.
static INTERFACES: LazyLock<Vec<Value>> = LazyLock::new(|| {
    let tree = |line: &str| {
        let row: serde_json::Value = serde_json::from_str(line).expect("a line of JSON");
        Value::serialized(&row["bsdf"]).expect("JSON fits CBOR")
    };
    include_str!("../../tests/interfaces.jsonl").lines().map(tree).collect()
});

/// A description of a model over the whole sphere that may be wrong in its numbers.
#[derive(Clone, Debug)]
pub struct Interface(Value);

impl<'a> Arbitrary<'a> for Interface {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mut tree = u.choose(&INTERFACES)?.clone();
        vary(&mut tree, false, &mut None, u)?;
        Ok(Self(tree))
    }
}

impl Interface {
    /// The description, if its numbers are in range.
    pub fn read(&self) -> Option<BsdfDescription> {
        self.0.deserialized().ok()
    }
}
