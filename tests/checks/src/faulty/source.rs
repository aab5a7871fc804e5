//! The source that places are places of.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use super::place::{Operation, Place};

/// The text of a file of the crate, read once.
///
/// # Panics
/// If there is no such file.
pub fn source(file: &'static str) -> &'static str {
    static READ: Mutex<BTreeMap<&str, &str>> = Mutex::new(BTreeMap::new());
    READ.lock()
        .unwrap_or_else(PoisonError::into_inner)
        .entry(file)
        .or_insert_with(|| crate::text(file).leak())
}

impl Place {
    /// How many operations of this kind begin here: both products of `a * b * c` do.
    pub fn links(&self) -> usize {
        let sign = match self.operation {
            Operation::Add => '+',
            Operation::Sub => '-',
            Operation::Mul => '*',
            Operation::Div => '/',
            _ => return 1,
        };
        let lines = source(self.file).lines().skip(self.line as usize - 1);
        let text = lines.collect::<Vec<_>>().join(" ");
        let expression: Vec<char> = text.chars().skip(self.column as usize - 1).collect();
        signs(&expression, sign)
    }
}

/// How often a sign joins the terms of the expression that the text begins with; in parentheses
/// too, if it begins with them. Signs of two operands have spaces around them in this crate.
fn signs(text: &[char], sign: char) -> usize {
    let inside = if text.first() == Some(&'(') { signs(&text[1..], sign) } else { 0 };
    let (mut depth, mut count) = (0_u32, 0);
    for at in 0..text.len() {
        let spaced = at > 0 && text[at - 1] == ' ' && text.get(at + 1) == Some(&' ');
        match text[at] {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' if depth == 0 => break,
            ')' | ']' | '}' => depth -= 1,
            ',' | ';' if depth == 0 => break,
            '+' | '-' if depth == 0 && spaced && (sign == '*' || sign == '/') => break,
            other if depth == 0 && spaced && other == sign => count += 1,
            _ => {}
        }
    }
    inside + count
}
