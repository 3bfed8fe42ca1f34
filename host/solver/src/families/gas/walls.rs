//! What a gas exerts on its walls, and the work that is done on it from outside where no energy of the gas
//! tells of it.

use std::collections::BTreeMap;

use motes_core::cloud::Words;
use motes_core::domain::Side;
use motes_core::equation::gas::WallForces;
use motes_core::error::Error;

use super::plan::Plan;
use crate::run::{Series, side};
use crate::sums::Compensated;

/// The forces of now, and the work since the start, in units of the solver.
#[derive(Clone, Debug)]
pub(super) struct WallLedger<const D: usize> {
    pub forces: WallForces<D>,
    /// Of moving walls, and of an acceleration along periodic directions, where no place is higher.
    power: f64,
    work: Compensated,
}

impl<const D: usize> Default for WallLedger<D> {
    fn default() -> Self {
        Self {
            forces: WallForces::NONE,
            power: 0.0,
            work: Compensated::default(),
        }
    }
}

impl<const D: usize> WallLedger<D> {
    /// Takes over the forces of a state, and the power of what pulls it, a step of `dt` after the last.
    pub fn follow(&mut self, forces: WallForces<D>, pull: f64, dt: f64) {
        let power = forces.power + pull;
        // As velocities are kicked: half a step by each.
        self.work.add(0.5 * dt * (self.power + power));
        (self.forces, self.power) = (forces, power);
    }

    /// Passes it.
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        let forces = self.forces.force.as_flattened_mut();
        words.scalars(forces.as_flattened_mut())?;
        words.scalar(&mut self.forces.power)?;
        words.scalar(&mut self.power)?;
        self.work.pass(words)
    }

    /// The work since the start, in the scenario's units.
    pub fn work(&self, plan: &Plan) -> f64 {
        self.work.value() * plan.units.mass * plan.units.energy()
    }
}

/// The heading of the column of [`WallLedger::work`].
const WORK: &str = "work";

impl Plan {
    /// Whether the work has to be followed step by step.
    pub(super) fn is_worked(&self) -> bool {
        let walls = self.options.walls.velocity.iter().flatten().flatten();
        let pull = self.periodic_pull();
        walls
            .flatten()
            .chain(&pull)
            .any(|&component| component != 0.0)
    }

    /// The external acceleration, in the scenario's units.
    pub(super) fn acceleration(&self) -> [f64; 3] {
        let unit = self.units.velocity / self.units.time();
        let acceleration = self.options.plain.acceleration;
        acceleration.map(|component| component * unit)
    }

    /// The same along the directions that give places an energy: no place along a circle is higher than
    /// another.
    pub(super) fn potential_pull(&self) -> [f64; 3] {
        let acceleration = self.acceleration();
        std::array::from_fn(|i| match self.axes[i].is_periodic() {
            true => 0.0,
            false => acceleration[i],
        })
    }

    /// The acceleration along periodic directions, in units of the solver.
    pub(super) fn periodic_pull(&self) -> [f64; 3] {
        let acceleration = self.options.plain.acceleration;
        std::array::from_fn(|i| match self.axes[i].is_periodic() {
            true => acceleration[i],
            false => 0.0,
        })
    }

    /// The walls, by direction and end.
    fn walls(&self) -> impl Iterator<Item = (usize, usize)> {
        let axes = self.axes[..self.dimension].iter().enumerate();
        let ends = axes.flat_map(|(axis, of)| [0, 1].map(|end| (axis, end, of.sides[end])));
        ends.filter_map(|(axis, end, of)| (of == Side::Mirror).then_some((axis, end)))
    }

    /// Adds to the forces on walls what a pressure that the materials leave out exerts.
    pub(super) fn push<const D: usize>(&self, forces: &mut WallForces<D>) {
        let lengths = || self.axes[..D].iter().map(|axis| axis.upper - axis.lower);
        for (axis, end) in self.walls() {
            let beside = lengths().enumerate().filter(|&(i, _)| i != axis);
            let area: f64 = beside.map(|(_, length)| length).product();
            let outwards = if end == 0 { -1.0 } else { 1.0 };
            forces.force[axis][end][axis] += outwards * self.options.background * area;
        }
    }

    /// The columns of the forces, with the direction and the end of each wall and the component.
    pub(super) fn force_columns(&self) -> Vec<((usize, usize, usize), String)> {
        let dimension = self.dimension;
        let of_wall = |(axis, end)| {
            (0..dimension).map(move |i| {
                let name = match dimension {
                    1 => format!("force_{}", side(axis, end)),
                    _ => format!("force_{}_{}", side(axis, end), ["x", "y", "z"][i]),
                };
                ((axis, end, i), name)
            })
        };
        self.walls().flat_map(of_wall).collect()
    }

    /// The column of the work, where there is any.
    pub(super) fn work_column(&self) -> Option<String> {
        self.is_worked().then(|| WORK.to_owned())
    }

    /// The forces on the walls at the end of a series.
    pub(super) fn wall_forces(&self, series: &Series) -> BTreeMap<String, Vec<f64>> {
        let mut forces = BTreeMap::<String, Vec<f64>>::new();
        for ((axis, end, _), column) in self.force_columns() {
            let last = series.of(&column).last().copied().unwrap_or(f64::NAN);
            forces.entry(side(axis, end)).or_default().push(last);
        }
        forces
    }
}
