//! A finished formula: evaluation.

use std::fmt;
use std::sync::Arc;

use crate::derivative::derivative;
use crate::elementary::choice;
use crate::graph::{Graph, Node, Operation};

/// A function of the variables of its [`Scope`](crate::Scope); cheap to clone.
#[derive(Clone, PartialEq)]
pub struct Formula {
    text: Arc<str>,
    /// The last one is the value.
    operations: Arc<[Operation]>,
}

/// Points that are evaluated together.
const BLOCK: usize = 64;
/// Operations that [`Formula::at`] needs no heap for.
const SHORT: usize = 64;

impl Formula {
    pub(crate) fn new(text: &str, graph: &Graph, result: Node) -> Self {
        Self {
            text: text.into(),
            operations: graph.needed(result).into(),
        }
    }

    /// The same number everywhere.
    pub fn constant(value: f64) -> Self {
        Self {
            text: value.to_string().into(),
            operations: [Operation::Number(value)].into(),
        }
    }

    /// How it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What it does, the last one last.
    pub(crate) fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// Its value, if it is the same everywhere.
    pub fn value(&self) -> Option<f64> {
        match self.operations[..] {
            [Operation::Number(value)] => Some(value),
            _ => None,
        }
    }

    /// Whether its value depends on a variable.
    pub fn depends_on(&self, variable: usize) -> bool {
        self.operations.contains(&Operation::Variable(variable))
    }

    /// Its value at one point; variables that are missing are 0.
    pub fn at(&self, variables: &[f64]) -> f64 {
        let of = |place: usize| [variables.get(place).copied().unwrap_or(0.0)];
        let mut short = [[0.0; 1]; SHORT];
        let mut long;
        let registers = match self.operations.len() {
            0..=SHORT => &mut short[..],
            length => {
                long = vec![[0.0; 1]; length];
                &mut long
            }
        };
        self.run(registers, of)[0]
    }

    /// Its values at many points. A variable has one value a point, or one for all; those that are
    /// missing are 0.
    pub fn write(&self, variables: &[&[f64]], values: &mut [f64]) {
        let mut registers = vec![[0.0; BLOCK]; self.operations.len()];
        for (block, values) in values.chunks_mut(BLOCK).enumerate() {
            let first = block * BLOCK;
            let of = |place: usize| match variables.get(place) {
                Some([value]) => [*value; BLOCK],
                Some(column) => {
                    let mut part = [0.0; BLOCK];
                    for (slot, value) in part.iter_mut().zip(column.iter().skip(first)) {
                        *slot = *value;
                    }
                    part
                }
                None => [0.0; BLOCK],
            };
            let found = self.run(&mut registers, of);
            values.copy_from_slice(&found[..values.len()]);
        }
    }

    /// Does the operations, each for all points of a block.
    fn run<const W: usize>(
        &self,
        registers: &mut [[f64; W]],
        variable: impl Fn(usize) -> [f64; W],
    ) -> [f64; W] {
        for (place, operation) in self.operations.iter().enumerate() {
            registers[place] = match *operation {
                Operation::Number(value) => [value; W],
                Operation::Variable(of) => variable(of),
                Operation::Call(function, a) => registers[a].map(|a| function.of(a)),
                Operation::Pair(binary, a, b) => {
                    let (a, b) = (registers[a], registers[b]);
                    std::array::from_fn(|i| binary.of(a[i], b[i]))
                }
                Operation::Choice(condition, a, b) => {
                    let (condition, a, b) = (registers[condition], registers[a], registers[b]);
                    std::array::from_fn(|i| choice(condition[i], a[i], b[i]))
                }
            };
        }
        registers[self.operations.len() - 1]
    }

    /// Its derivative with respect to a variable. At a kink it is that of one side, of a jump 0.
    pub fn derivative(&self, variable: usize) -> Self {
        let mut graph = Graph::of(&self.operations);
        let node = derivative(&mut graph, self.operations.len() - 1, variable);
        Self::new(&format!("the derivative of {}", self.text), &graph, node)
    }
}

impl fmt::Display for Formula {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

impl fmt::Debug for Formula {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "Formula({:?})", self.text)
    }
}
