//! Operations, each once, simplified where that is exact.

use std::collections::BTreeMap;

use crate::function::{BinaryFunction, Function};

/// The place of an operation in its graph.
pub(crate) type Node = usize;

/// One operation on those before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Operation {
    Number(f64),
    /// A variable by its place in the scope.
    Variable(usize),
    Call(Function, Node),
    Pair(BinaryFunction, Node, Node),
    /// The second where the first is not 0, else the third.
    Choice(Node, Node, Node),
}

/// The most operations of a formula and its definitions.
pub(crate) const MOST: usize = 20_000;

/// Operations in an order in which each needs earlier ones only.
#[derive(Debug, Clone, Default)]
pub(crate) struct Graph {
    pub operations: Vec<Operation>,
    /// Where an operation stands, so that none is there twice.
    places: BTreeMap<Key, Node>,
    /// The definitions that have been read, by name and arguments: none is read twice.
    pub called: BTreeMap<(String, Vec<Node>), Node>,
}

/// An operation as whole numbers, which have an order: kind, detail and up to three operands.
type Key = (u8, u64, Node, Node, Node);

fn key(operation: &Operation) -> Key {
    match *operation {
        Operation::Number(value) => (0, value.to_bits(), 0, 0, 0),
        Operation::Variable(place) => (1, place as u64, 0, 0, 0),
        Operation::Call(function, a) => (2, function as u64, a, 0, 0),
        Operation::Pair(binary, a, b) => (3, binary as u64, a, b, 0),
        Operation::Choice(condition, a, b) => (4, 0, condition, a, b),
    }
}

impl Graph {
    /// A graph of operations that are in order.
    pub fn of(operations: &[Operation]) -> Self {
        let mut graph = Self::default();
        for operation in operations {
            graph.push(*operation);
        }
        graph
    }

    fn push(&mut self, operation: Operation) -> Node {
        let next = self.operations.len();
        let place = *self.places.entry(key(&operation)).or_insert(next);
        if place == next {
            self.operations.push(operation);
        }
        place
    }

    pub fn number(&mut self, value: f64) -> Node {
        self.push(Operation::Number(value))
    }

    pub fn variable(&mut self, place: usize) -> Node {
        self.push(Operation::Variable(place))
    }

    /// The value of a node that is a number.
    pub fn value(&self, node: Node) -> Option<f64> {
        match self.operations[node] {
            Operation::Number(value) => Some(value),
            _ => None,
        }
    }

    pub fn call(&mut self, function: Function, a: Node) -> Node {
        match self.value(a) {
            Some(a) => self.number(function.of(a)),
            None => self.push(Operation::Call(function, a)),
        }
    }

    /// Leaves out what changes nothing: `a + 0`, `1 a`, `a/1`, `a^1`; and makes `0 a` 0, as
    /// derivatives need: where a is infinite, the derivative of a constant is 0 still.
    pub fn pair(&mut self, binary: BinaryFunction, a: Node, b: Node) -> Node {
        let is = |node: Option<f64>, value: f64| node == Some(value);
        match (binary, self.value(a), self.value(b)) {
            (_, Some(a), Some(b)) => self.number(binary.of(a, b)),
            (BinaryFunction::Add, x, _) if is(x, 0.0) => b,
            (BinaryFunction::Add | BinaryFunction::Subtract, _, y) if is(y, 0.0) => a,
            (BinaryFunction::Multiply, x, _) if is(x, 1.0) => b,
            (BinaryFunction::Multiply | BinaryFunction::Divide | BinaryFunction::Power, _, y)
                if is(y, 1.0) =>
            {
                a
            }
            (BinaryFunction::Multiply, x, y) if is(x, 0.0) || is(y, 0.0) => self.number(0.0),
            (BinaryFunction::Divide, x, _) if is(x, 0.0) => a,
            (BinaryFunction::Power, _, y) if is(y, 0.0) => self.number(1.0),
            _ => self.push(Operation::Pair(binary, a, b)),
        }
    }

    pub fn choice(&mut self, condition: Node, a: Node, b: Node) -> Node {
        match self.value(condition) {
            Some(value) => [b, a][usize::from(value != 0.0)],
            None if a == b => a,
            None => self.push(Operation::Choice(condition, a, b)),
        }
    }

    pub fn negative(&mut self, a: Node) -> Node {
        let zero = self.number(0.0);
        let minus = self.number(-1.0);
        match self.value(a) {
            Some(_) => self.pair(BinaryFunction::Subtract, zero, a),
            None => self.pair(BinaryFunction::Multiply, minus, a),
        }
    }

    /// What a node needs, itself the last, in the order of evaluation.
    pub fn needed(&self, node: Node) -> Vec<Operation> {
        let mut is_needed = vec![false; node + 1];
        is_needed[node] = true;
        // Operands stand before their users: one walk down meets all.
        for place in (0..=node).rev() {
            if is_needed[place] {
                mark(&self.operations[place], &mut is_needed);
            }
        }
        let mut renamed = vec![0; node + 1];
        let mut operations = Vec::new();
        for place in (0..=node).filter(|&place| is_needed[place]) {
            renamed[place] = operations.len();
            operations.push(match self.operations[place] {
                Operation::Call(function, a) => Operation::Call(function, renamed[a]),
                Operation::Pair(binary, a, b) => Operation::Pair(binary, renamed[a], renamed[b]),
                Operation::Choice(condition, a, b) => {
                    Operation::Choice(renamed[condition], renamed[a], renamed[b])
                }
                other => other,
            });
        }
        operations
    }
}

/// Marks what an operation needs itself.
fn mark(operation: &Operation, is_needed: &mut [bool]) {
    match *operation {
        Operation::Number(_) | Operation::Variable(_) => {}
        Operation::Call(_, a) => is_needed[a] = true,
        Operation::Pair(_, a, b) => {
            is_needed[a] = true;
            is_needed[b] = true;
        }
        Operation::Choice(condition, a, b) => {
            for place in [condition, a, b] {
                is_needed[place] = true;
            }
        }
    }
}
