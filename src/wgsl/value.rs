//! What a symbol stands for: a known value, or a node of the graph of a function.

use core::hash::{Hash, Hasher};

/// A number, a truth, or three of them side by side.
#[derive(Clone, Copy, Debug)]
pub(super) enum Value {
    Number(f64),
    Numbers([f64; 3]),
    Truth(bool),
    Truths([bool; 3]),
    Node(Node),
}

/// The place of an operation in the graph of a session.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Node {
    pub(super) session: u32,
    pub(super) place: u32,
    pub(super) width: Width,
}

/// How many numbers or truths a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Width {
    One,
    Two,
    Three,
}

/// Of bits, so that a value that is not a number equals itself.
impl PartialEq for Value {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => a.to_bits() == b.to_bits(),
            (Self::Numbers(a), Self::Numbers(b)) => a.map(f64::to_bits) == b.map(f64::to_bits),
            (Self::Truth(a), Self::Truth(b)) => a == b,
            (Self::Truths(a), Self::Truths(b)) => a == b,
            (Self::Node(a), Self::Node(b)) => a == b,
            _ => false,
        }
    }
}

impl Eq for Value {}

impl Hash for Value {
    fn hash<H: Hasher>(&self, state: &mut H) {
        core::mem::discriminant(self).hash(state);
        match self {
            Self::Number(number) => number.to_bits().hash(state),
            Self::Numbers(numbers) => numbers.map(f64::to_bits).hash(state),
            Self::Truth(truth) => truth.hash(state),
            Self::Truths(truths) => truths.hash(state),
            Self::Node(node) => node.hash(state),
        }
    }
}

impl Value {
    pub(super) const ZERO: Self = Self::Number(0.0);

    /// Three known numbers, or one if they are the same.
    pub(super) fn numbers(numbers: [f64; 3]) -> Self {
        let [x, y, z] = numbers.map(f64::to_bits);
        if x == y && y == z { Self::Number(numbers[0]) } else { Self::Numbers(numbers) }
    }

    /// Three known truths, or one if they are the same.
    pub(super) fn truths(truths: [bool; 3]) -> Self {
        let [x, y, z] = truths;
        if x == y && y == z { Self::Truth(x) } else { Self::Truths(truths) }
    }

    pub(super) fn width(self) -> Width {
        match self {
            Self::Number(_) | Self::Truth(_) => Width::One,
            Self::Numbers(_) | Self::Truths(_) => Width::Three,
            Self::Node(node) => node.width,
        }
    }

    pub(super) fn node(self) -> Option<Node> {
        if let Self::Node(node) = self { Some(node) } else { None }
    }

    /// The numbers of a known value, the same one thrice if there is one.
    pub(super) fn known_numbers(self) -> Option<[f64; 3]> {
        match self {
            Self::Number(number) => Some([number; 3]),
            Self::Numbers(numbers) => Some(numbers),
            _ => None,
        }
    }

    /// The truths of a known value, the same one thrice if there is one.
    pub(super) fn known_truths(self) -> Option<[bool; 3]> {
        match self {
            Self::Truth(truth) => Some([truth; 3]),
            Self::Truths(truths) => Some(truths),
            _ => None,
        }
    }

    /// Whether it is this number.
    pub(super) fn is(self, number: f64) -> bool {
        matches!(self, Self::Number(known) if known == number)
    }
}
