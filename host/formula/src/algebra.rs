//! Formulas made of formulas: sums, products, substitutions.

use std::ops::{Add, Mul, Sub};

use crate::formula::Formula;
use crate::function::{BinaryFunction, Function};
use crate::graph::{Graph, Node, Operation};

/// What formulas made of others show as their text.
const MADE: &str = "made of other formulas";

impl Formula {
    /// A variable of its scope, by its place there.
    pub fn variable(place: usize) -> Self {
        let mut graph = Graph::default();
        let node = graph.variable(place);
        Self::new(MADE, &graph, node)
    }

    /// The same function of other functions: a variable becomes the formula in its place, and stays
    /// where there is none.
    pub fn with(&self, variables: &[Self]) -> Self {
        let mut graph = Graph::default();
        let variables: Vec<Node> = variables
            .iter()
            .map(|of| copied(&mut graph, of, &[]))
            .collect();
        let node = copied(&mut graph, self, &variables);
        Self::new(MADE, &graph, node)
    }

    /// Its sine.
    pub fn sine(&self) -> Self {
        let mut graph = Graph::default();
        let a = copied(&mut graph, self, &[]);
        let node = graph.call(Function::Sin, a);
        Self::new(MADE, &graph, node)
    }

    /// The larger of two.
    pub fn maximum(&self, other: &Self) -> Self {
        self.combined(BinaryFunction::Maximum, other)
    }

    fn combined(&self, binary: BinaryFunction, other: &Self) -> Self {
        let mut graph = Graph::default();
        let (a, b) = (
            copied(&mut graph, self, &[]),
            copied(&mut graph, other, &[]),
        );
        let node = graph.pair(binary, a, b);
        Self::new(MADE, &graph, node)
    }
}

/// Adds a formula to a graph, with nodes in the place of its first variables.
fn copied(graph: &mut Graph, formula: &Formula, variables: &[Node]) -> Node {
    let mut nodes: Vec<Node> = Vec::new();
    for operation in formula.operations() {
        nodes.push(match *operation {
            Operation::Number(value) => graph.number(value),
            Operation::Variable(place) => match variables.get(place) {
                Some(node) => *node,
                None => graph.variable(place),
            },
            Operation::Call(function, a) => graph.call(function, nodes[a]),
            Operation::Pair(binary, a, b) => graph.pair(binary, nodes[a], nodes[b]),
            Operation::Choice(condition, a, b) => {
                graph.choice(nodes[condition], nodes[a], nodes[b])
            }
        });
    }
    nodes[nodes.len() - 1]
}

impl Add for &Formula {
    type Output = Formula;
    fn add(self, other: Self) -> Formula {
        self.combined(BinaryFunction::Add, other)
    }
}

impl Sub for &Formula {
    type Output = Formula;
    fn sub(self, other: Self) -> Formula {
        self.combined(BinaryFunction::Subtract, other)
    }
}

impl Mul for &Formula {
    type Output = Formula;
    fn mul(self, other: Self) -> Formula {
        self.combined(BinaryFunction::Multiply, other)
    }
}
