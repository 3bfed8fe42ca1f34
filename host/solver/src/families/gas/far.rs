//! The gas far beyond open sides, in solver units.

use motes_core::cutoff::{CutOff, Named};
use motes_core::equation::gas::{Far, Width};
use motes_core::scalar::Scalar;

use crate::scenario::{Scenario, Side};
use crate::setup::Placed;
use crate::units::SolverUnits;

/// What the gas far beyond a side follows from.
pub(super) struct Surroundings<'a> {
    pub scenario: &'a Scenario,
    pub units: &'a SolverUnits,
    /// The open direction.
    pub axis: usize,
    /// The gas at the start.
    pub placed: &'a [Placed],
    /// By how much sums find a lattice of the gas denser than it is: [`excess`].
    pub excess: f64,
}

impl Surroundings<'_> {
    /// The gas that comes in.
    fn of_inflow(&self, depth: f64) -> Option<Far<f64>> {
        let inflow = self.scenario.inflow.as_ref()?;
        let law = &self.scenario.materials[inflow.material].law;
        let energy = law.energy(inflow.density, inflow.pressure);
        let state = Beside {
            velocity: inflow.velocity[self.axis],
            pressure: law.pressure(inflow.density * self.excess, energy),
            shift: 0.0,
            density: inflow.density,
            sound_speed: law.sound_speed_squared(inflow.density, energy).sqrt(),
        };
        Some(state.far(self.units, depth))
    }

    /// The gas beyond an outflow side: what the scenario says, else what is next to the side at the
    /// start. `None` where nothing is.
    fn of_outflow(&self, end: usize, depth: f64) -> Option<Far<f64>> {
        let mut state = self
            .next_to(end, depth / 3.0)
            .or(self.next_to(end, depth))?;
        let outflow = &self.scenario.outflow;
        if let Some(pressure) = outflow.pressure {
            state.pressure = pressure;
        }
        if let Some(velocity) = &outflow.velocity {
            state.velocity = velocity[self.axis];
        }
        state.pressure += state.shift;
        Some(state.far(self.units, depth))
    }

    /// The mean state within a distance, in solver units, from a side.
    fn next_to(&self, end: usize, distance: f64) -> Option<Beside> {
        let extent = &self.scenario.domain.extent;
        let side = [extent.lower[self.axis], extent.upper[self.axis]][end];
        let near = |placed: &&Placed| {
            (placed.position[self.axis] - side).abs() <= distance * self.units.length
        };
        let mut mean = Beside::default();
        let mut all = 0.0;
        for placed in self.placed.iter().filter(near) {
            let law = &self.scenario.materials[usize::from(placed.material)].law;
            let (density, energy) = (placed.density, placed.energy);
            let pressure = law.pressure(density, energy);
            let volume = placed.mass / density;
            all += volume;
            // A running mean.
            let part = volume / all;
            let add = |mean: &mut f64, value: f64| *mean += part * (value - *mean);
            add(&mut mean.velocity, placed.velocity[self.axis]);
            add(&mut mean.pressure, pressure);
            let dense = law.pressure(density * self.excess, energy);
            add(&mut mean.shift, dense - pressure);
            add(&mut mean.density, density);
            let sound_speed = law.sound_speed_squared(density, energy).sqrt();
            add(&mut mean.sound_speed, sound_speed);
        }
        (all > 0.0).then_some(mean)
    }
}

/// A state in the scenario's units.
#[derive(Default)]
struct Beside {
    velocity: f64,
    pressure: f64,
    /// What sums over a lattice add to the pressure.
    shift: f64,
    density: f64,
    sound_speed: f64,
}

impl Beside {
    fn far(&self, units: &SolverUnits, depth: f64) -> Far<f64> {
        Far {
            velocity: self.velocity / units.velocity,
            pressure: self.pressure / (units.density() * units.energy()),
            density: self.density / units.density(),
            sound_speed: self.sound_speed / units.velocity,
            depth,
        }
    }
}

/// The far states beyond the lower and the upper side of a direction; the depths of an inflow's and
/// an outflow's zone.
pub(super) fn far(
    sides: [Side; 2],
    surroundings: &Surroundings<'_>,
    [inflow, outflow]: [f64; 2],
) -> [Option<Far<f64>>; 2] {
    std::array::from_fn(|end| match sides[end] {
        Side::Inflow => surroundings.of_inflow(inflow),
        Side::Outflow => surroundings.of_outflow(end, outflow),
        _ => None,
    })
}

/// A far state in the scalar of the run.
pub(super) fn rounded<S: Scalar>(far: &Far<f64>) -> Far<S> {
    Far {
        velocity: S::from_f64(far.velocity),
        pressure: S::from_f64(far.pressure),
        density: S::from_f64(far.density),
        sound_speed: S::from_f64(far.sound_speed),
        depth: S::from_f64(far.depth),
    }
}

/// The density that sums over a lattice have, over the one that it has: `1 + O(1e-3)`, the error of
/// quadrature of the cut-off.
///
/// `cell`: the spacings along the directions, as many as the dimension; the width in the same unit.
pub(super) fn excess(cut_off: Named, width: Width<f64>, cell: &[f64]) -> f64 {
    match *cell {
        [x] => lattice(cut_off, width, [x]),
        [x, y] => lattice(cut_off, width, [x, y]),
        [x, y, z] => lattice(cut_off, width, [x, y, z]),
        _ => 1.0,
    }
}

fn lattice<const D: usize>(cut_off: Named, width: Width<f64>, cell: [f64; D]) -> f64 {
    let volume: f64 = cell.iter().product();
    let sum = |epsilon: f64| values(cut_off, epsilon, cell);
    match width {
        Width::Constant { epsilon } => {
            let sigma = cut_off.normalisation::<D>();
            sigma * volume * sum(epsilon) / epsilon.powi(D as i32)
        }
        Width::Adaptive { eta, packing } => {
            // The sum rises with the width; it is that of its packing at the one that a particle takes.
            let target = packing.sum::<f64, _, D>(cut_off, eta);
            let usual = eta * libm::pow(volume, 1.0 / D as f64);
            let (mut low, mut high) = (0.5 * usual, 2.0 * usual);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                match sum(middle) < target {
                    true => low = middle,
                    false => high = middle,
                }
            }
            volume * (eta / high).powi(D as i32)
        }
    }
}

/// The sum of the cut-off over the points of a lattice, one of them in the middle.
fn values<const D: usize>(cut_off: Named, epsilon: f64, cell: [f64; D]) -> f64 {
    let reach = f64::from(cut_off.support()) * epsilon;
    let most = cell.map(|length| (reach / length) as i64);
    let each = most.map(|most| 2 * most + 1);
    let count: i64 = each.iter().product();
    let value = |number: i64| {
        let mut rest = number;
        let mut squared = 0.0;
        for i in 0..D {
            let x = (rest % each[i] - most[i]) as f64 * cell[i];
            rest /= each[i];
            squared += x * x;
        }
        match squared < reach * reach {
            true => cut_off.value::<D, f64>(cut_off.argument(squared / (epsilon * epsilon))),
            false => 0.0,
        }
    };
    (0..count).map(value).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lattice_is_as_dense_as_the_solver_finds_it() {
        let line = excess(Named::CubicSpline, Width::adaptive(1.2), &[1.0]);
        assert!((line - 1.0).abs() < 1e-12, "{line}");
        let square = excess(Named::WendlandC2, Width::adaptive(1.5), &[0.5, 0.5]);
        assert!((square - 1.0).abs() < 1e-12, "{square}");
        // A cell that is no square has what is left; one width for all has all of it.
        let flat = excess(Named::WendlandC2, Width::adaptive(1.5), &[0.75, 0.5]);
        assert!(flat > 1.0003 && flat < 1.02, "{flat}");
        let constant = Width::Constant { epsilon: 1.2 };
        let line = excess(Named::CubicSpline, constant, &[1.0]);
        assert!((line - 1.0018).abs() < 1e-4, "{line}");
        // Σ over -2..2 of the M4 cut-off of width 1: 2/3 + 2/6.
        let constant = Width::Constant { epsilon: 1.0 };
        let line = excess(Named::CubicSpline, constant, &[1.0]);
        assert!((line - 1.0).abs() < 1e-14, "{line}");
    }
}
