//! Operations on values: known ones are computed in `f64` by the functions of the crate, identities
//! are left out, the rest becomes a node.

use super::graph::{Operation, Step, record, step};
use super::prelude::Function;
use super::value::{Value, Width};
use crate::real::Real;

/// What all operands have in common.
fn widest<const N: usize>(of: [Value; N]) -> Width {
    of.into_iter().map(Value::width).max().unwrap_or(Width::One)
}

fn unary(operation: Operation, of: Value, known: impl Fn(f64) -> f64) -> Value {
    match of.known_numbers() {
        Some(numbers) => Value::numbers(numbers.map(known)),
        None => record(operation, [of, Value::ZERO, Value::ZERO], of.width()),
    }
}

fn binary(operation: Operation, of: [Value; 2], known: impl Fn(f64, f64) -> f64) -> Value {
    match of.map(Value::known_numbers) {
        [Some(a), Some(b)] => Value::numbers(core::array::from_fn(|i| known(a[i], b[i]))),
        _ => record(operation, [of[0], of[1], Value::ZERO], widest(of)),
    }
}

/// What is negated, if that is what a value is.
fn negated(value: Value) -> Option<Value> {
    let step = step(value.node()?)?;
    (step.operation == Operation::Neg).then_some(step.of[0])
}

/// The negative of a known negative number.
fn positive(value: Value) -> Option<Value> {
    let numbers = value.known_numbers()?;
    numbers.iter().all(|number| *number < 0.0).then(|| Value::numbers(numbers.map(|it| -it)))
}

pub(super) fn add(a: Value, b: Value) -> Value {
    if a.is(0.0) {
        return b;
    }
    if b.is(0.0) {
        return a;
    }
    match (negated(a).or(positive(a)), negated(b).or(positive(b))) {
        (_, Some(b)) => sub(a, b),
        (Some(a), None) if b.known_numbers().is_none() => sub(b, a),
        _ => binary(Operation::Add, [kept(a, b), kept(b, a)], |a, b| a + b),
    }
}

/// A sum or difference from which the other one is about to be taken away again: rounded, so that
/// what is left has the digits that it has for all who use the sum. A compiler would take both
/// operations away.
fn kept(value: Value, other: Value) -> Value {
    match value.node().and_then(step) {
        Some(step) if matches!(step.operation, Operation::Add | Operation::Sub) => {
            let [a, b, _] = step.of;
            let undone = other.node().is_some() && (a == other || b == other);
            if undone {
                record(Operation::Rounded, [value, Value::ZERO, Value::ZERO], value.width())
            } else {
                value
            }
        }
        _ => value,
    }
}

pub(super) fn sub(a: Value, b: Value) -> Value {
    if b.is(0.0) {
        return a;
    }
    if a.is(0.0) {
        return neg(b);
    }
    let known = a.known_numbers().is_some() && b.known_numbers().is_some();
    if !known && let Some(b) = negated(b).or(positive(b)) {
        return add(a, b);
    }
    binary(Operation::Sub, [kept(a, b), kept(b, a)], |a, b| a - b)
}

pub(super) fn mul(a: Value, b: Value) -> Value {
    if a.is(0.0) || b.is(0.0) {
        return Value::ZERO;
    }
    match (a, b) {
        (one, other) | (other, one) if one.is(1.0) => other,
        (minus, other) | (other, minus) if minus.is(-1.0) => neg(other),
        _ => match (scaled(a, b), scaled(b, a)) {
            (Some([number, factor]), _) | (None, Some([number, factor])) => mul(number, factor),
            (None, None) => binary(Operation::Mul, [a, b], |a, b| a * b),
        },
    }
}

/// For a product by a known factor, and another: the number and the product of the factors. Two
/// factors would be rounded to single precision, one after the other.
fn scaled(product: Value, factor: Value) -> Option<[Value; 2]> {
    let factors = factor.known_numbers()?;
    let step = step(product.node()?)?;
    let [a, b, _] = step.of;
    let (number, other) = match (a.known_numbers(), b.known_numbers()) {
        (None, Some(other)) => (a, other),
        (Some(other), None) => (b, other),
        _ => return None,
    };
    let product: [f64; 3] = core::array::from_fn(|i| factors[i] * other[i]);
    let single = f64::from(f32::MIN_POSITIVE)..f64::from(f32::MAX);
    let fits = product.iter().all(|product| single.contains(&product.abs()));
    (step.operation == Operation::Mul && fits).then(|| [number, Value::numbers(product)])
}

pub(super) fn div(a: Value, b: Value) -> Value {
    if b.is(1.0) {
        return a;
    }
    binary(Operation::Div, [a, b], |a, b| a / b)
}

pub(super) fn neg(value: Value) -> Value {
    negated(value).unwrap_or_else(|| unary(Operation::Neg, value, |x| -x))
}

pub(super) fn min(a: Value, b: Value) -> Value {
    bounded(Operation::Min, a, b, Real::min)
}

pub(super) fn max(a: Value, b: Value) -> Value {
    bounded(Operation::Max, a, b, Real::max)
}

/// Of two known bounds the narrower one is enough.
fn bounded(operation: Operation, a: Value, b: Value, narrower: fn(f64, f64) -> f64) -> Value {
    if let (Some(step), Some(bound)) = (a.node().and_then(step), b.known_numbers()) {
        let [value, other, _] = step.of;
        if let (true, Some(other)) = (step.operation == operation, other.known_numbers()) {
            let bounds = core::array::from_fn(|i| narrower(bound[i], other[i]));
            return binary(operation, [value, Value::numbers(bounds)], narrower);
        }
    }
    binary(operation, [a, b], narrower)
}

pub(super) fn clamp(value: Value, lower: Value, upper: Value) -> Value {
    let of = [value, lower, upper];
    let again = |step: Step| step.operation == Operation::Clamp && step.of[1..] == of[1..];
    if value.node().and_then(step).is_some_and(again) {
        return value;
    }
    match of.map(Value::known_numbers) {
        [Some(x), Some(a), Some(b)] => {
            Value::numbers(core::array::from_fn(|i| Real::clamp(x[i], a[i], b[i])))
        }
        _ => record(Operation::Clamp, of, widest(of)),
    }
}

pub(super) fn abs(value: Value) -> Value {
    unary(Operation::Abs, value, f64::abs)
}

pub(super) fn floor(value: Value) -> Value {
    unary(Operation::Floor, value, Real::floor)
}

pub(super) fn sqrt(value: Value) -> Value {
    unary(Operation::Sqrt, value, Real::sqrt)
}

/// A function of the prelude, of numbers: component by component where there are three.
pub(super) fn call<const N: usize>(
    function: Function,
    of: [Value; N],
    known: impl Fn([f64; N]) -> f64,
) -> Value {
    let mut all = Some([[0.0; N]; 3]);
    for (place, value) in of.into_iter().enumerate() {
        all = all.zip(value.known_numbers()).map(|(mut all, numbers)| {
            for (all, number) in all.iter_mut().zip(numbers) {
                all[place] = number;
            }
            all
        });
    }
    if let Some(all) = all {
        return Value::numbers(all.map(known));
    }
    let one = |component: u8| {
        let mut operands = [Value::ZERO; 3];
        for (operand, value) in operands.iter_mut().zip(of) {
            *operand = self::component(value, component);
        }
        record(Operation::Call(function), operands, Width::One)
    };
    match widest(of) {
        Width::Three => compose([one(0), one(1), one(2)]),
        _ => one(0),
    }
}

/// A function of the prelude of one number that answers two.
pub(super) fn call_of_two(
    function: Function,
    of: Value,
    known: impl Fn(f64) -> (f64, f64),
) -> [Value; 2] {
    if let Some(numbers) = of.known_numbers() {
        let both = numbers.map(known);
        return [Value::numbers(both.map(|it| it.0)), Value::numbers(both.map(|it| it.1))];
    }
    let one = |place: u8| {
        let of = [component(of, place), Value::ZERO, Value::ZERO];
        let both = record(Operation::Call(function), of, Width::Two);
        [component(both, 0), component(both, 1)]
    };
    match of.width() {
        Width::Three => {
            let each = [one(0), one(1), one(2)];
            [compose(each.map(|it| it[0])), compose(each.map(|it| it[1]))]
        }
        _ => one(0),
    }
}

/// A component of a vector; a number itself.
pub(super) fn component(value: Value, place: u8) -> Value {
    match value {
        Value::Numbers(numbers) => Value::Number(numbers[usize::from(place.min(2))]),
        Value::Truths(truths) => Value::Truth(truths[usize::from(place.min(2))]),
        Value::Node(node) if node.width != Width::One => match step(node) {
            Some(step) if step.operation == Operation::Compose => {
                step.of[usize::from(place.min(2))]
            }
            _ => record(Operation::Component(place), [value, Value::ZERO, Value::ZERO], Width::One),
        },
        number => number,
    }
}

/// The vector whose component this is, if it is one.
fn component_of(value: Value, place: u8) -> Option<Value> {
    let step = step(value.node()?)?;
    let whole = step.of[0];
    let fits = step.operation == Operation::Component(place) && whole.width() == Width::Three;
    fits.then_some(whole)
}

/// The vector of three numbers.
pub(super) fn compose(of: [Value; 3]) -> Value {
    if let [Value::Number(x), Value::Number(y), Value::Number(z)] = of {
        return Value::numbers([x, y, z]);
    }
    if of[0] == of[1] && of[1] == of[2] {
        return of[0];
    }
    match [component_of(of[0], 0), component_of(of[1], 1), component_of(of[2], 2)] {
        [Some(x), Some(y), Some(z)] if x == y && y == z => x,
        _ => record(Operation::Compose, of, Width::Three),
    }
}

pub(super) fn dot(a: Value, b: Value) -> Value {
    match [a, b].map(Value::known_numbers) {
        [Some(a), Some(b)] => Value::Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]),
        _ => record(Operation::Dot, [a, b, Value::ZERO], Width::One),
    }
}

pub(super) fn cross(a: Value, b: Value) -> Value {
    let part = |i: u8, j: u8| {
        sub(mul(component(a, i), component(b, j)), mul(component(a, j), component(b, i)))
    };
    match [a, b].map(Value::node) {
        [Some(_), Some(_)] => record(Operation::Cross, [a, b, Value::ZERO], Width::Three),
        _ => compose([part(1, 2), part(2, 0), part(0, 1)]),
    }
}

pub(super) fn less(a: Value, b: Value) -> Value {
    compared(Operation::Less, [a, b], |a, b| a < b)
}

pub(super) fn less_equal(a: Value, b: Value) -> Value {
    compared(Operation::LessEqual, [a, b], |a, b| a <= b)
}

fn compared(operation: Operation, of: [Value; 2], known: impl Fn(f64, f64) -> bool) -> Value {
    match of.map(Value::known_numbers) {
        [Some(a), Some(b)] => Value::truths(core::array::from_fn(|i| known(a[i], b[i]))),
        _ => record(operation, [of[0], of[1], Value::ZERO], widest(of)),
    }
}

pub(super) fn and(a: Value, b: Value) -> Value {
    match (a, b) {
        (Value::Truth(true), other) | (other, Value::Truth(true)) => other,
        (Value::Truth(false), _) | (_, Value::Truth(false)) => Value::Truth(false),
        _ if a == b => a,
        (Value::Truths(a), Value::Truths(b)) => {
            Value::truths(core::array::from_fn(|i| a[i] && b[i]))
        }
        _ => record(Operation::And, [a, b, Value::ZERO], widest([a, b])),
    }
}

pub(super) fn or(a: Value, b: Value) -> Value {
    match (a, b) {
        (Value::Truth(false), other) | (other, Value::Truth(false)) => other,
        (Value::Truth(true), _) | (_, Value::Truth(true)) => Value::Truth(true),
        _ if a == b => a,
        (Value::Truths(a), Value::Truths(b)) => {
            Value::truths(core::array::from_fn(|i| a[i] || b[i]))
        }
        _ => record(Operation::Or, [a, b, Value::ZERO], widest([a, b])),
    }
}

pub(super) fn not(value: Value) -> Value {
    match value.known_truths() {
        Some(truths) => Value::truths(truths.map(|truth| !truth)),
        None => match value.node().and_then(step) {
            Some(step) if step.operation == Operation::Not => step.of[0],
            _ => record(Operation::Not, [value, Value::ZERO, Value::ZERO], value.width()),
        },
    }
}

pub(super) fn select(mask: Value, yes: Value, no: Value) -> Value {
    // Where the choice is made already.
    let chosen = |value: Value, place: usize| match value.node().and_then(step) {
        Some(step) if step.operation == Operation::Select && step.of[0] == mask => step.of[place],
        _ => value,
    };
    let (yes, no) = (chosen(yes, 1), chosen(no, 2));
    if yes == no {
        return yes;
    }
    match mask {
        Value::Truth(true) => return yes,
        Value::Truth(false) => return no,
        Value::Truths(truths) => {
            let each = |place: u8| {
                let truth = truths[usize::from(place)];
                component(if truth { yes } else { no }, place)
            };
            return compose([each(0), each(1), each(2)]);
        }
        _ => {}
    }
    let of = [mask, yes, no];
    record(Operation::Select, of, widest(of))
}
