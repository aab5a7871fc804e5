//! The graph of a function as statements.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use super::graph::{Graph, Operation, Step};
use super::literal::number;
use super::prelude::Function;
use super::value::{Value, Width};

/// The longest expression of a statement.
const LINE: usize = 84;

/// The statements of a function and what is left when they are done.
pub(super) struct Body {
    /// Statements, one a line, without indentation.
    pub(super) statements: Vec<String>,
    /// The expressions asked for.
    pub(super) results: Vec<String>,
    /// The functions of the prelude that they call.
    pub(super) functions: BTreeSet<Function>,
}

/// How tightly an expression holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    Or,
    And,
    Comparison,
    Sum,
    Product,
    Sign,
    Whole,
}

#[derive(Clone, Debug)]
struct Text {
    text: String,
    bond: Bond,
    /// Whether it is a name, or a component of one, and need not get another.
    named: bool,
}

impl Text {
    fn new(text: impl Into<String>, bond: Bond) -> Self {
        Self { text: text.into(), bond, named: false }
    }

    fn named(text: impl Into<String>) -> Self {
        Self { text: text.into(), bond: Bond::Whole, named: true }
    }

    /// In parentheses, if it does not hold together well enough.
    fn held(&self, least: Bond) -> String {
        if self.bond >= least { self.text.clone() } else { format!("({})", self.text) }
    }

    /// The same to the right of an operator, where no sign may begin.
    fn right(&self, least: Bond) -> String {
        if self.text.starts_with('-') && self.bond < Bond::Whole {
            format!("({})", self.text)
        } else {
            self.held(least)
        }
    }
}

struct Printer<'a> {
    graph: &'a Graph,
    /// How often a node is an operand or a result.
    uses: Vec<u32>,
    texts: Vec<Option<Text>>,
    /// Names of known vectors that are used more than once.
    constants: BTreeMap<[u64; 3], (u32, Option<String>)>,
    counts: BTreeMap<&'static str, u32>,
    body: Body,
}

/// The statements that compute some values, each as wide as is asked for.
pub(super) fn print(graph: &Graph, results: &[(Value, Width)]) -> Body {
    let mut printer = Printer {
        graph,
        uses: vec![0; graph.steps.len()],
        texts: vec![None; graph.steps.len()],
        constants: BTreeMap::new(),
        counts: BTreeMap::new(),
        body: Body { statements: Vec::new(), results: Vec::new(), functions: BTreeSet::new() },
    };
    printer.count(results);
    for (place, step) in graph.steps.iter().enumerate() {
        if printer.uses.get(place).is_some_and(|uses| *uses > 0) {
            printer.statement(place, *step);
        }
    }
    for (value, width) in results {
        let text = printer.spread(*value, *width).text;
        printer.body.results.push(text);
    }
    printer.body
}

impl Printer<'_> {
    /// Counts uses from the results back: an operand stands before what uses it.
    fn count(&mut self, results: &[(Value, Width)]) {
        results.iter().for_each(|(value, _)| self.used(*value));
        for place in (0..self.graph.steps.len()).rev() {
            if self.uses[place] > 0 {
                self.graph.steps[place].of.into_iter().for_each(|value| self.used(value));
            }
        }
    }

    fn used(&mut self, value: Value) {
        match value {
            Value::Node(node) => {
                if let Some(uses) = self.uses.get_mut(node.place as usize) {
                    *uses += 1;
                }
            }
            Value::Numbers(numbers) => {
                self.constants.entry(numbers.map(f64::to_bits)).or_default().0 += 1;
            }
            _ => {}
        }
    }

    /// Prepares the text of a node; a statement gives it a name if it is used more than once.
    fn statement(&mut self, place: usize, step: Step) {
        let mut text = self.expression(step);
        // The longest operands get names until the rest fits into a line.
        while text.text.len() > LINE {
            let unnamed = step.of.into_iter().filter_map(Value::node).filter_map(|node| {
                let text = self.texts.get(node.place as usize)?.as_ref()?;
                (!text.named).then_some((text.text.len(), node.place as usize))
            });
            let Some((_, longest)) = unnamed.max() else { break };
            self.name(longest);
            text = self.expression(step);
        }
        let often = self.uses[place] > 1 && !text.named;
        self.texts[place] = Some(text);
        if often {
            self.name(place);
        }
    }

    /// Gives a node a name.
    fn name(&mut self, place: usize) {
        let Some(text) = self.texts[place].take() else { return };
        let step = self.graph.steps[place];
        let name = self.fresh(match (step.operation, step.width) {
            (operation, _) if is_truth(operation, self.graph, step.of) => "is",
            (_, Width::One) => "x",
            (_, Width::Two) => "p",
            (_, Width::Three) => "v",
        });
        self.body.statements.push(format!("let {name} = {};", text.text));
        self.texts[place] = Some(Text::named(name));
    }

    fn fresh(&mut self, letter: &'static str) -> String {
        loop {
            let count = self.counts.entry(letter).or_default();
            *count += 1;
            let name = format!("{letter}{count}");
            if !self.graph.names.contains(&name) {
                return name;
            }
        }
    }

    /// The text of a value.
    fn operand(&mut self, value: Value) -> Text {
        match value {
            Value::Node(node) => {
                let text = self.texts.get(node.place as usize).cloned().flatten();
                text.unwrap_or_else(|| Text::new("0.0", Bond::Whole))
            }
            Value::Number(value) => {
                let text = number(value);
                let bond = if text.starts_with('-') { Bond::Sign } else { Bond::Whole };
                Text { text, bond, named: true }
            }
            Value::Truth(truth) => Text::named(truth.to_string()),
            Value::Truths([x, y, z]) => Text::named(format!("vec3({x}, {y}, {z})")),
            Value::Numbers(numbers) => {
                let [x, y, z] = numbers.map(number);
                let text = format!("vec3({x}, {y}, {z})");
                let key = numbers.map(f64::to_bits);
                match self.constants.get(&key).cloned() {
                    Some((_, Some(name))) => Text::named(name),
                    Some((2.., None)) => {
                        let name = self.fresh("c");
                        self.body.statements.push(format!("let {name} = {text};"));
                        self.constants.insert(key, (2, Some(name.clone())));
                        Text::named(name)
                    }
                    _ => Text::named(text),
                }
            }
        }
    }

    /// The text of an operand where as many components are needed as an operation has.
    fn spread(&mut self, value: Value, width: Width) -> Text {
        let text = self.operand(value);
        if width == Width::Three && value.width() == Width::One {
            Text::new(format!("vec3({})", text.text), Bond::Whole)
        } else {
            text
        }
    }

    /// The text of an operation.
    fn expression(&mut self, step: Step) -> Text {
        let Step { operation, of: [a, b, c], width } = step;
        match operation {
            Operation::Input(place) => {
                let name = self.graph.names.get(place as usize).cloned();
                Text::named(name.unwrap_or_default())
            }
            Operation::Add => self.infix(a, "+", b, [Bond::Sum, Bond::Product]),
            Operation::Sub => self.infix(a, "-", b, [Bond::Sum, Bond::Product]),
            Operation::Mul => self.infix(a, "*", b, [Bond::Product, Bond::Sign]),
            Operation::Div => self.infix(a, "/", b, [Bond::Product, Bond::Sign]),
            Operation::Neg => {
                let operand = self.operand(a).right(Bond::Sign);
                Text::new(format!("-{operand}"), Bond::Sign)
            }
            Operation::Less => self.comparison(a, b, ["<", ">"]),
            Operation::LessEqual => self.comparison(a, b, ["<=", ">="]),
            Operation::And => self.logic(a, b, ["&&", "&"], Bond::And),
            Operation::Or => self.logic(a, b, ["||", "|"], Bond::Or),
            Operation::Not => {
                let operand = self.operand(a).held(Bond::Whole);
                Text::new(format!("!{operand}"), Bond::Sign)
            }
            Operation::Select => {
                let values = a.width().max(b.width()).max(c.width());
                let (yes, no) = (self.spread(b, values).text, self.spread(c, values).text);
                let mask = self.operand(a).text;
                self.call("select", [no, yes, mask])
            }
            Operation::Min => self.builtin("min", [a, b], width),
            Operation::Max => self.builtin("max", [a, b], width),
            Operation::Clamp => self.clamp([a, b, c], width),
            Operation::Rounded => {
                let function = match width {
                    Width::Three => Function::Rounded3,
                    _ => Function::Rounded,
                };
                self.body.functions.insert(function);
                self.builtin(function.name(), [a], width)
            }
            Operation::Abs => self.builtin("abs", [a], width),
            Operation::Floor => self.builtin("floor", [a], width),
            Operation::Sqrt => self.builtin("sqrt", [a], width),
            Operation::Dot => self.builtin("dot", [a, b], Width::Three),
            Operation::Cross => self.builtin("cross", [a, b], Width::Three),
            Operation::Call(function) => {
                self.body.functions.insert(function);
                let operands = match function {
                    Function::PowerOfPart | Function::Clamped => vec![a, b, c],
                    Function::Copysign | Function::Powf | Function::Atan2 | Function::Decay => {
                        vec![a, b]
                    }
                    _ => vec![a],
                };
                let operands: Vec<String> =
                    operands.into_iter().map(|it| self.operand(it).text).collect();
                self.call(function.name(), operands)
            }
            Operation::Component(place) => {
                let of = self.operand(a);
                let letter = ["x", "y", "z"][usize::from(place.min(2))];
                let text = format!("{}.{letter}", of.held(Bond::Whole));
                Text { text, bond: Bond::Whole, named: of.named }
            }
            Operation::Compose => self.builtin("vec3", [a, b, c], Width::One),
        }
    }

    fn call(&self, name: &str, operands: impl IntoIterator<Item = String>) -> Text {
        let operands: Vec<String> = operands.into_iter().collect();
        Text::new(format!("{name}({})", operands.join(", ")), Bond::Whole)
    }

    fn builtin<const N: usize>(&mut self, name: &str, of: [Value; N], width: Width) -> Text {
        let operands = of.map(|value| self.spread(value, width).text);
        self.call(name, operands)
    }

    /// With the function of the language a value that is not a number may pass.
    fn clamp(&mut self, of: [Value; 3], width: Width) -> Text {
        self.body.functions.insert(Function::Clamped);
        if width == Width::One {
            return self.builtin(Function::Clamped.name(), of, width);
        }
        self.builtin("clamp", of, width)
    }

    fn infix(&mut self, a: Value, sign: &str, b: Value, bonds: [Bond; 2]) -> Text {
        let (left, right) = (self.operand(a).held(bonds[0]), self.operand(b).right(bonds[1]));
        Text::new(format!("{left} {sign} {right}"), bonds[0])
    }

    fn comparison(&mut self, a: Value, b: Value, signs: [&str; 2]) -> Text {
        let width = a.width().max(b.width());
        let (left, right) = (self.spread(a, width), self.spread(b, width));
        let known = a.node().is_none();
        let (left, sign, right) =
            if known { (right, signs[1], left) } else { (left, signs[0], right) };
        let (left, right) = (left.held(Bond::Sum), right.held(Bond::Sum));
        Text::new(format!("{left} {sign} {right}"), Bond::Comparison)
    }

    fn logic(&mut self, a: Value, b: Value, signs: [&str; 2], bond: Bond) -> Text {
        let width = a.width().max(b.width());
        let (left, right) = (self.spread(a, width), self.spread(b, width));
        let held = |text: &Text| {
            if width == Width::Three {
                text.held(Bond::Sign)
            } else if text.bond == bond {
                text.text.clone()
            } else {
                text.held(Bond::Comparison)
            }
        };
        let sign = signs[usize::from(width == Width::Three)];
        Text::new(format!("{} {sign} {}", held(&left), held(&right)), bond)
    }
}

/// Whether an operation answers a truth.
fn is_truth(operation: Operation, graph: &Graph, of: [Value; 3]) -> bool {
    match operation {
        Operation::Less | Operation::LessEqual | Operation::And | Operation::Or => true,
        Operation::Not => true,
        Operation::Component(_) | Operation::Compose => match of[0] {
            Value::Truth(_) | Value::Truths(_) => true,
            Value::Node(node) => {
                graph.step(node).is_some_and(|step| is_truth(step.operation, graph, step.of))
            }
            _ => false,
        },
        _ => false,
    }
}
