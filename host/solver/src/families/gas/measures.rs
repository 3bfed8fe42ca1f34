//! What is measured of a gas: sums that forces conserve, and spreads of its fields.

use super::balance::{MassLedger, columns};
use super::description::turns;
use super::plan::Plan;
use super::walls::WallLedger;
use crate::run::{Measures, Spread, Spreading, Sum};
use crate::sums::Compensated;

/// A particle of gas in the scenario's units, with all of its pressure.
pub(super) struct Observed {
    pub position: [f64; 3],
    pub velocity: [f64; 3],
    pub mass: f64,
    pub density: f64,
    pub pressure: f64,
    pub energy: f64,
    pub sound_speed: f64,
}

impl Observed {
    /// `|u|²/2`.
    pub fn kinetic_energy(&self) -> f64 {
        0.5 * self.velocity.iter().map(|u| u * u).sum::<f64>()
    }
}

/// Sums and spreads over the particles of a moment, in the scenario's units.
pub(super) struct Totals<'a> {
    plan: &'a Plan,
    /// The acceleration that gives places an energy.
    pull: [f64; 3],
    background: f64,
    /// Mass, momentum, angular momentum, energy, kinetic energy.
    sums: [Compensated; 9],
    /// Of density, velocity, pressure and neighbours.
    spreads: [Spreading; 4],
}

impl<'a> Totals<'a> {
    /// Of no particle yet.
    pub fn new(plan: &'a Plan) -> Self {
        Self {
            plan,
            pull: plan.potential_pull(),
            background: plan.background(),
            sums: Default::default(),
            spreads: Default::default(),
        }
    }

    /// Adds a particle, which has so many neighbours.
    pub fn add(&mut self, particle: &Observed, neighbours: f64) {
        let Observed {
            position: x,
            velocity: u,
            mass,
            density,
            pressure,
            energy,
            ..
        } = particle;
        let kinetic = mass * particle.kinetic_energy();
        let along: f64 = x.iter().zip(&self.pull).map(|(x, g)| x * g).sum();
        let turn = |i: usize| {
            let (a, b) = ((i + 1) % 3, (i + 2) % 3);
            mass * (x[a] * u[b] - x[b] * u[a])
        };
        let terms = [
            *mass,
            mass * u[0],
            mass * u[1],
            mass * u[2],
            turn(0),
            turn(1),
            turn(2),
            mass * (energy + self.background / density) + kinetic - mass * along,
            kinetic,
        ];
        let sums = self.sums.iter_mut().zip(terms);
        sums.for_each(|(sum, term)| sum.add(term));
        let speed = match self.plan.dimension {
            1 => u[0],
            _ => u.iter().map(|u| u * u).sum::<f64>().sqrt(),
        };
        let values = [*density, speed, *pressure, neighbours];
        let spreads = self.spreads.iter_mut().zip(values);
        spreads.for_each(|(spread, value)| spread.add(value));
    }

    /// What the time series has of them, and the sums with the sizes that their drifts are compared with.
    pub fn measures<const D: usize>(
        self,
        ledger: &MassLedger,
        walls: &WallLedger<D>,
        sizes: [f64; 4],
    ) -> Measures {
        let plan = self.plan;
        let [mass, px, py, pz, lx, ly, lz, energy, kinetic] = self.sums.map(|sum| sum.value());
        // What forces conserve: the particles' volumes sum to that of the domain but for their noise.
        let energy = energy - self.background * plan.volume();
        let (momentum, angular) = ([px, py, pz], [lx, ly, lz]);
        let mut diagnostics = vec![mass];
        diagnostics.extend(&momentum[..D]);
        diagnostics.push(energy);
        for spread in self.spreads {
            let Spread { min, mean, max } = spread.spread();
            diagnostics.extend([min, mean, max]);
        }
        diagnostics.push(kinetic);
        diagnostics.extend(turns(D).iter().map(|&i| angular[i]));
        let columns = columns(plan.opening.as_ref()).into_iter();
        diagnostics.extend(columns.map(|(end, _)| ledger.mass(end) * plan.units.mass));
        let unit = plan.units.mass * plan.units.velocity / plan.units.time();
        let forces = plan.force_columns().into_iter();
        diagnostics
            .extend(forces.map(|((axis, end, i), _)| walls.forces.force[axis][end][i] * unit));
        diagnostics.extend(plan.work_column().map(|_| walls.work(plan)));
        let values = [
            vec![mass],
            momentum.to_vec(),
            angular.to_vec(),
            vec![energy],
        ];
        let sums = values.into_iter().zip(sizes);
        Measures {
            diagnostics,
            sums: sums.map(|(value, size)| Sum { value, size }).collect(),
        }
    }
}
