//! The graph of what formulas do to symbols, in which the same operation stands once.

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use core::cell::RefCell;
use core::sync::atomic::{AtomicU32, Ordering};
use std::collections::HashMap;

use super::prelude::Function;
use super::value::{Node, Value, Width};

/// What a node does to its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operation {
    /// The argument or parameter of this place in the list of names.
    Input(u32),
    Add,
    Sub,
    Mul,
    Div,
    Neg,
    Less,
    LessEqual,
    And,
    Or,
    Not,
    /// The second where the first is true, else the third.
    Select,
    Min,
    Max,
    /// The first, moved to between the others.
    Clamp,
    /// The operand, rounded to single precision.
    Rounded,
    Abs,
    Floor,
    Sqrt,
    Dot,
    Cross,
    /// A function of the prelude.
    Call(Function),
    /// The x, y or z of what has them.
    Component(u8),
    /// A vector of three numbers.
    Compose,
}

/// An operation and its operands, as many of the three as it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Step {
    pub(super) operation: Operation,
    pub(super) of: [Value; 3],
    pub(super) width: Width,
}

/// More operations than any model of the crate has; who asks for a long loop to be unrolled gets
/// an error and no endless text.
pub(super) const MOST: usize = 200_000;

/// The operations of one function, in the order of their first use.
#[derive(Debug)]
pub(super) struct Graph {
    session: u32,
    pub(super) steps: Vec<Step>,
    pub(super) names: Vec<String>,
    places: HashMap<Step, u32>,
    /// Whether a symbol came from elsewhere.
    pub(super) foreign: bool,
    /// Whether there were too many operations.
    pub(super) full: bool,
}

thread_local! {
    static CURRENT: RefCell<Option<Graph>> = const { RefCell::new(None) };
}

static SESSIONS: AtomicU32 = AtomicU32::new(0);

/// Runs formulas and gives back what they did. A session within a session is one of its own.
pub(super) fn session<R>(formulas: impl FnOnce() -> R) -> (R, Graph) {
    let graph = Graph {
        session: SESSIONS.fetch_add(1, Ordering::Relaxed),
        steps: Vec::new(),
        names: Vec::new(),
        places: HashMap::new(),
        foreign: false,
        full: false,
    };
    let session = graph.session;
    /// Puts the session outside back, also where a formula panics.
    struct Outer(Option<Graph>);
    impl Drop for Outer {
        fn drop(&mut self) {
            CURRENT.with_borrow_mut(|current| *current = self.0.take());
        }
    }
    let outer = Outer(CURRENT.with_borrow_mut(|current| current.replace(graph)));
    let result = formulas();
    let graph = CURRENT.with_borrow_mut(Option::take);
    drop(outer);
    let lost = || Graph {
        session,
        steps: Vec::new(),
        names: Vec::new(),
        places: HashMap::new(),
        foreign: true,
        full: false,
    };
    (result, graph.unwrap_or_else(lost))
}

/// A symbol with a name.
pub(super) fn input(name: String, width: Width) -> Value {
    let place = CURRENT.with_borrow_mut(|current| {
        let names = &mut current.as_mut()?.names;
        names.push(name);
        u32::try_from(names.len() - 1).ok()
    });
    place.map_or(Value::Number(f64::NAN), |place| {
        record(Operation::Input(place), [Value::ZERO; 3], width)
    })
}

/// The node of an operation. What is no symbol of this session is not a number.
pub(super) fn record(operation: Operation, of: [Value; 3], width: Width) -> Value {
    let step = Step { operation, of, width };
    let node = CURRENT.with_borrow_mut(|current| current.as_mut()?.node(step));
    node.map_or(Value::Number(f64::NAN), Value::Node)
}

/// What a node of this session does.
pub(super) fn step(node: Node) -> Option<Step> {
    CURRENT.with_borrow(|current| current.as_ref()?.step(node))
}

impl Graph {
    fn node(&mut self, step: Step) -> Option<Node> {
        let session = self.session;
        if step.of.iter().filter_map(|value| value.node()).any(|node| node.session != session) {
            self.foreign = true;
            return None;
        }
        if let Some(&place) = self.places.get(&step) {
            return Some(Node { session, place, width: step.width });
        }
        if self.steps.len() >= MOST {
            self.full = true;
            return None;
        }
        let place = u32::try_from(self.steps.len()).ok()?;
        self.steps.push(step);
        self.places.insert(step, place);
        Some(Node { session, place, width: step.width })
    }

    /// A constant that the results depend on and that is not finite, if there is one.
    pub(super) fn not_finite(&self, results: impl IntoIterator<Item = Value>) -> Option<f64> {
        let mut seen = vec![false; self.steps.len()];
        let mut values: Vec<Value> = results.into_iter().collect();
        while let Some(value) = values.pop() {
            let numbers = value.known_numbers().unwrap_or_default();
            if let Some(wrong) = numbers.into_iter().find(|number| !number.is_finite()) {
                return Some(wrong);
            }
            let Some(place) = value.node().map(|node| node.place as usize) else { continue };
            if let (Some(seen @ false), Some(step)) = (seen.get_mut(place), self.steps.get(place)) {
                *seen = true;
                values.extend(step.of);
            }
        }
        None
    }

    /// What a node does, if it is one of this graph.
    pub(super) fn step(&self, node: Node) -> Option<Step> {
        let own = node.session == self.session;
        self.steps.get(node.place as usize).copied().filter(|_| own)
    }
}
