//! What changes the sums of the strengths, as far as it is counted: walls and reactions.

use motes_core::domain::Side;
use motes_core::equation::diffusion::Ledger;
use motes_core::scalar::Scalar;

use super::plan::Plan;
use crate::run::{Balance, Series, inflow};
use crate::scenario::linear::{Reaction, System};

/// Something that a component comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::families) struct Source {
    /// A wall, by direction and end; `None` for reactions.
    wall: Option<(usize, usize)>,
    component: usize,
}

impl Source {
    /// All that a plan has: every wall, also those that let nothing through, and reactions.
    pub fn all(plan: &Plan) -> Vec<Self> {
        let System::ConvectionDiffusion(problem) = &plan.system else {
            return Vec::new();
        };
        let mut all = Vec::new();
        for (axis, sides) in plan.axes.iter().take(plan.dimension).enumerate() {
            for end in (0..2).filter(|&end| sides.sides[end] == Side::Mirror) {
                all.extend((0..problem.species.len()).map(|component| Self {
                    wall: Some((axis, end)),
                    component,
                }));
            }
        }
        if problem.reaction != Reaction::None {
            all.extend((0..problem.species.len()).map(|component| Self {
                wall: None,
                component,
            }));
        }
        all
    }

    /// The column of the time series.
    pub fn column(self, names: &[String]) -> String {
        let name = &names[self.component];
        match self.wall {
            Some((axis, end)) => inflow(axis, end, name),
            None => format!("reactions_{name}"),
        }
    }

    /// What has come from it so far, in units of a strength of the solver.
    pub fn total<S: Scalar, const D: usize, const P: usize>(self, ledger: &Ledger<S, D, P>) -> f64 {
        let intake = match self.wall {
            Some((axis, end)) => &ledger.walls[axis][end][self.component],
            None => &ledger.reactions[self.component],
        };
        S::wide_to_f64(intake.total())
    }
}

/// The balance of each component that something comes from.
pub(super) fn balance(plan: &Plan, series: &Series) -> Vec<Balance> {
    let sources = Source::all(plan);
    let of = |component: usize| {
        let mine = || {
            sources
                .iter()
                .filter(move |source| source.component == component)
        };
        let name = plan.names[component].as_str();
        let reactions = mine().find(|source| source.wall.is_none());
        let reactions = reactions.map(|source| source.column(&plan.names));
        Balance::of(
            series,
            (name, &format!("total_{name}")),
            mine().filter_map(|source| source.wall),
            reactions.as_deref(),
        )
    };
    let has_any = |&component: &usize| sources.iter().any(|source| source.component == component);
    (0..plan.names.len()).filter(has_any).map(of).collect()
}
