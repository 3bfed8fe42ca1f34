//! Stepping a plan to its end.

use std::time::Instant;

use motes_core::cutoff::CutOff;
use motes_core::equation::gas::{Cloud, Gas, GasDynamics, Opening, Physics, Viscosity, Width};
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::material::{EquationOfState, Named as NamedMaterial};
use motes_core::scalar::Scalar;

use super::arrays::GasArrays;
use super::limits::{RunError, check_format, check_memory, check_step};
use super::opening::OpenSides;
use super::outcome::{Drift, Lonely, Outcome, ParticleRow, Sample, Spread};
use super::plan::Plan;
use crate::engine::{HostScalar, Threads};
use crate::sums::compensated;

/// A look at a run between two steps.
pub struct Look<'a> {
    /// Time.
    pub time: f64,
    /// Steps made.
    pub steps: u64,
    /// The particles, in id order; made when asked for.
    pub particles: &'a dyn Fn() -> Vec<ParticleRow>,
}

/// What a run tells its caller, and hears from it, between steps.
pub struct Control<'a> {
    /// Rows of the time series, equally spaced in time.
    pub samples: usize,
    /// Called with the part of the run that is done, in [0, 1]; `false` stops the run.
    pub progress: &'a mut dyn FnMut(f64) -> bool,
    /// Called at the start and after each step. Looking changes no bit.
    pub look: &'a mut dyn FnMut(&Look<'_>) -> Result<(), String>,
}

/// A plan in the scalar of the run.
struct Run<'a, 'm, S: Scalar, C, V, P, const D: usize> {
    plan: &'a Plan,
    solver: GasDynamics<'m, S, C, V, NamedMaterial<S>, P, D>,
    opening: Option<Opening<'m, S, D>>,
    clock: Clock<S>,
}

/// Runs a plan with one scalar, cut-off, viscosity and law.
pub(super) fn run_with<S: HostScalar, C, V, P, const D: usize>(
    plan: &Plan,
    scalar: &str,
    (cut_off, viscosity, physics): (C, V, P),
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError>
where
    C: CutOff,
    V: Viscosity<S>,
    P: Physics<S, D>,
{
    let options = plan.options::<S, D>();
    let bytes = GasArrays::<S, P::Shown, D>::bytes_per_particle(&options);
    check_memory(plan.particles.len(), bytes)?;
    check_format::<S>(plan, scalar)?;
    let materials = plan.materials();
    let layer = plan
        .opening
        .as_ref()
        .map_or_else(Vec::new, OpenSides::layer);
    let opening = plan.opening.as_ref();
    let run = Run {
        plan,
        solver: plan.solver(cut_off, viscosity, physics, &materials),
        opening: opening.map(|opening| opening.rounded(&layer)),
        clock: Clock::new(S::from_f64(plan.end)),
    };
    let arrays = GasArrays::new(plan.particles(), &options);
    run.complete(arrays, engine, control)
}

impl<S: HostScalar, C, V, P, const D: usize> Run<'_, '_, S, C, V, P, D>
where
    C: CutOff,
    V: Viscosity<S>,
    P: Physics<S, D>,
{
    fn complete(
        mut self,
        mut arrays: GasArrays<S, P::Shown, D>,
        engine: &mut Threads,
        control: &mut Control<'_>,
    ) -> Result<Outcome, RunError> {
        if let Some(opening) = &self.opening {
            opening
                .fill(&self.solver.domain, &mut arrays)
                .map_err(|error| self.failed(error))?;
        }
        let (mut gas, mut work) = arrays.parts();
        let started = Instant::now();
        self.solver
            .prepare(engine, &mut gas, &mut work)
            .map_err(|error| self.failed(error))?;
        let first = self.sample(&gas, S::ZERO);
        let (mut series, mut sampled) = (vec![first], 0.0);
        let mut lonely = self.watch(&gas, None);
        let (mut smallest, mut largest) = (f64::INFINITY, 0.0f64);
        self.show(&gas, control)?;
        while let Some(left) = self.clock.left() {
            if let Some(opening) = &self.opening {
                opening
                    .exchange(&self.solver.domain, &mut arrays)
                    .map_err(|error| self.failed(error))?;
            }
            let (mut gas, mut work) = arrays.parts();
            let dt = self
                .solver
                .time_step(&gas, left)
                .map_err(|error| self.failed(error))?;
            check_step((self.time(), self.plan.units.time()), dt, left)?;
            self.solver
                .advance(engine, &mut gas, &mut work, dt)
                .map_err(|error| self.failed(error))?;
            self.clock.tick(dt).map_err(|error| self.failed(error))?;
            let step = dt.to_f64() * self.plan.units.time();
            // The last step is as long as what is left.
            if dt < left || largest == 0.0 {
                (smallest, largest) = (smallest.min(step), largest.max(step));
            }
            lonely = self.watch(&gas, lonely);
            let done = self.clock.time.to_f64() / self.clock.end.to_f64();
            let due = (done * control.samples as f64).floor();
            if due > sampled {
                sampled = due;
                series.push(self.sample(&gas, dt));
            }
            self.show(&gas, control)?;
            if !(control.progress)(done) {
                let (time, step) = (self.time(), self.clock.steps);
                return Err(RunError::Interrupted { time, step });
            }
        }
        let seconds = started.elapsed().as_secs_f64();
        let gas = arrays.gas();
        let last = self.sample(&gas, S::ZERO);
        Ok(Outcome {
            particles: self.rows(&gas),
            drift: self.drift(&first, &last),
            is_open: self.opening.is_some(),
            series,
            steps: self.clock.steps,
            smallest_step: if smallest.is_finite() { smallest } else { 0.0 },
            largest_step: largest,
            time: self.time(),
            seconds,
            digest: gas.digest(),
            lonely,
        })
    }

    fn time(&self) -> f64 {
        self.clock.time.to_f64() * self.plan.units.time()
    }

    fn failed(&self, error: Error) -> RunError {
        RunError::Solver {
            time: self.time(),
            step: self.clock.steps,
            error,
        }
    }

    fn show(&self, gas: &Gas<'_, S, D>, control: &mut Control<'_>) -> Result<(), RunError> {
        let look = Look {
            time: self.time(),
            steps: self.clock.steps,
            particles: &|| self.rows(gas),
        };
        (control.look)(&look).map_err(|reason| RunError::Look {
            time: look.time,
            reason,
        })
    }

    /// The first particle with fewer than two neighbours under a constant ε: its density no
    /// longer feels the spacing, and waves move at wrong speeds. An adaptive ε looks for them.
    fn watch(&self, gas: &Gas<'_, S, D>, seen: Option<Lonely>) -> Option<Lonely> {
        if let Width::Adaptive { .. } = self.solver.width {
            return None;
        }
        seen.or_else(|| {
            let two = S::count(2);
            let particle = gas
                .neighbours
                .iter()
                .zip(gas.position.iter())
                .position(|(&neighbours, x)| neighbours < two && !self.is_beyond(x))?;
            let neighbours = gas.neighbours[particle].to_f64();
            Some(Lonely {
                particle,
                time: self.time(),
                neighbours,
            })
        })
    }

    /// The particles in the scenario's units, in id order; those beyond open sides are not
    /// part of the result.
    fn rows(&self, gas: &Gas<'_, S, D>) -> Vec<ParticleRow> {
        (0..gas.len())
            .filter(|&id| !self.is_beyond(&gas.position[id]))
            .map(|id| self.row(gas, id))
            .collect()
    }

    fn is_beyond(&self, position: &[S; D]) -> bool {
        self.solver.domain.beyond(position).is_some()
    }

    /// One particle in the scenario's units.
    fn row(&self, gas: &Gas<'_, S, D>, id: usize) -> ParticleRow {
        let units = &self.plan.units;
        let (density, energy) = (gas.density[id], gas.energy[id]);
        let material = gas.material[id];
        let law = &self.solver.materials[usize::from(material)];
        let pressure = law.pressure(density, energy);
        let mut row = ParticleRow {
            position: [0.0; 3],
            velocity: [0.0; 3],
            mass: gas.mass[id].to_f64() * units.mass,
            density: density.to_f64() * units.density(),
            pressure: pressure.to_f64() * units.density() * units.energy(),
            energy: energy.to_f64() * units.energy(),
            sound_speed: law.sound_speed(density, energy).to_f64() * units.velocity,
            divergence: gas.divergence[id].to_f64() / units.time(),
            viscosity_factor: gas.viscosity_factor[id].to_f64(),
            epsilon: gas.epsilon[id].to_f64() * units.length,
            neighbours: gas.neighbours[id].to_f64(),
            material,
        };
        for i in 0..D {
            let place = gas.position[id][i].to_f64() * units.length;
            row.position[i] = self.plan.middle[i] + place;
            row.velocity[i] = gas.velocity[id][i].to_f64() * units.velocity;
        }
        row
    }

    /// One row of the time series.
    fn sample(&self, gas: &Gas<'_, S, D>, dt: S) -> Sample {
        let rows = self.rows(gas);
        let sum = |of: &dyn Fn(&ParticleRow) -> f64| compensated(rows.iter().map(of));
        let pull = self.external();
        let kinetic = |p: &ParticleRow| 0.5 * p.mass * p.speed() * p.speed();
        let lift = |p: &ParticleRow| -> f64 {
            let along: f64 = p.position.iter().zip(&pull).map(|(x, g)| x * g).sum();
            p.mass * along
        };
        let turn = |i: usize| {
            let (a, b) = ((i + 1) % 3, (i + 2) % 3);
            sum(&|p| p.mass * (p.position[a] * p.velocity[b] - p.position[b] * p.velocity[a]))
        };
        let speed = |p: &ParticleRow| if D == 1 { p.velocity[0] } else { p.speed() };
        Sample {
            time: self.time(),
            steps: self.clock.steps,
            time_step: dt.to_f64() * self.plan.units.time(),
            mass: sum(&|p| p.mass),
            momentum: std::array::from_fn(|i| sum(&|p| p.mass * p.velocity[i])),
            angular_momentum: std::array::from_fn(turn),
            energy: sum(&|p| p.mass * p.energy + kinetic(p) - lift(p)),
            kinetic_energy: sum(&kinetic),
            density: Spread::of(rows.iter().map(|p| p.density)),
            velocity: Spread::of(rows.iter().map(speed)),
            pressure: Spread::of(rows.iter().map(|p| p.pressure)),
            neighbours: Spread::of(rows.iter().map(|p| p.neighbours)),
        }
    }

    /// The external acceleration in the scenario's units.
    fn external(&self) -> [f64; 3] {
        let unit = self.plan.units.velocity / self.plan.units.time();
        self.plan
            .options
            .plain
            .acceleration
            .map(|component| component * unit)
    }

    fn drift(&self, first: &Sample, last: &Sample) -> Drift {
        let units = &self.plan.units;
        let distance = |a: &[f64; 3], b: &[f64; 3]| -> f64 {
            let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
            squares.sum::<f64>().sqrt()
        };
        let momentum = first.mass * units.velocity;
        let size = (self.plan.axes[0].upper - self.plan.axes[0].lower) * units.length;
        Drift {
            mass: (last.mass - first.mass) / first.mass,
            momentum: distance(&last.momentum, &first.momentum) / momentum,
            angular_momentum: distance(&last.angular_momentum, &first.angular_momentum)
                / (momentum * size),
            energy: (last.energy - first.energy) / first.energy,
        }
    }
}
