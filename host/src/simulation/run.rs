//! Stepping a plan to its end.

use std::time::Instant;

use motes_core::cutoff::CutOff;
use motes_core::equation::gas::{Gas, GasDynamics, Viscosity, Width};
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::material::{EquationOfState, IdealGas};
use motes_core::scalar::Scalar;

use super::arrays::GasArrays;
use super::outcome::{Drift, Lonely, Outcome, ParticleRow, Sample, Spread};
use super::plan::Plan;
use crate::engine::{HostScalar, Threads};

/// What a run tells its caller, and hears from it, between steps.
pub struct Control<'a> {
    /// Rows of the time series, equally spaced in time.
    pub samples: usize,
    /// Called with the part of the run that is done, in [0, 1]; `false` stops the run.
    pub progress: &'a mut dyn FnMut(f64) -> bool,
}

/// A run that did not reach its end.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum RunError {
    /// The solver stopped.
    #[error("at t = {time}, step {step}: {error}")]
    Solver {
        /// When, in the scenario's units.
        time: f64,
        /// In which step.
        step: u64,
        /// Why.
        error: Error,
    },
    /// A number of the plan does not fit the scalar.
    #[error("{what} is {value:.3e} in solver units, which `{scalar}` cannot hold to 1 %")]
    #[diagnostic(help(
        "{}",
        if value.abs() > 1.0 {
            "use a format with more integer bits, or fewer particles: lengths are counted in \
             particle spacings"
        } else {
            "use a format with more fractional bits: masses, velocities and energies are \
             counted in those of the first state"
        }
    ))]
    Format {
        /// Which number.
        what: &'static str,
        /// How large it is.
        value: f64,
        /// The scalar.
        scalar: String,
    },
    /// The caller asked for it.
    #[error("interrupted at t = {time}, after {step} steps: no results were written")]
    Interrupted {
        /// When.
        time: f64,
        /// After how many steps.
        step: u64,
    },
    /// Not enough memory.
    #[error(
        "{particles} particles need about {needed:.1} GiB, this machine has {available:.1} GiB free"
    )]
    #[diagnostic(help("use fewer particles (-n, resolution.particles)"))]
    Memory {
        /// How many.
        particles: usize,
        /// GiB that they take.
        needed: f64,
        /// GiB that there are.
        available: f64,
    },
}

/// A plan in the scalar of the run.
struct Run<'a, S: Scalar, C, V> {
    plan: &'a Plan,
    solver: GasDynamics<S, C, V, IdealGas<S>, 1>,
    clock: Clock<S>,
}

/// Runs a plan with one scalar, cut-off and viscosity.
pub(super) fn run_with<S: HostScalar, C: CutOff, V: Viscosity<S>>(
    plan: &Plan,
    scalar: &str,
    cut_off: C,
    viscosity: V,
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, RunError> {
    check_memory(plan.particles(), GasArrays::<S, 1>::BYTES_PER_PARTICLE)?;
    check_format::<S>(plan, scalar)?;
    let tube = plan.tube();
    let run = Run {
        plan,
        solver: tube.solver(cut_off, viscosity),
        clock: Clock::new(tube.duration()),
    };
    run.complete(GasArrays::new(tube.particles()), engine, control)
}

impl<S: HostScalar, C: CutOff, V: Viscosity<S>> Run<'_, S, C, V> {
    fn complete(
        mut self,
        mut arrays: GasArrays<S, 1>,
        engine: &mut Threads,
        control: &mut Control<'_>,
    ) -> Result<Outcome, RunError> {
        let (mut gas, mut work) = arrays.parts();
        let started = Instant::now();
        self.solver
            .prepare(engine, &mut gas, &mut work)
            .map_err(|error| self.failed(error))?;
        let first = self.sample(&gas, S::ZERO);
        let (mut series, mut sampled) = (vec![first], 0.0);
        let mut lonely = self.watch(&gas, None);
        while let Some(left) = self.clock.left() {
            let dt = self
                .solver
                .time_step(&gas, left)
                .map_err(|error| self.failed(error))?;
            self.solver
                .advance(engine, &mut gas, &mut work, dt)
                .map_err(|error| self.failed(error))?;
            self.clock.tick(dt).map_err(|error| self.failed(error))?;
            lonely = self.watch(&gas, lonely);
            let done = self.clock.time.to_f64() / self.clock.end.to_f64();
            let due = (done * control.samples as f64).floor();
            if due > sampled {
                sampled = due;
                series.push(self.sample(&gas, dt));
            }
            if !(control.progress)(done) {
                let (time, step) = (self.time(), self.clock.steps);
                return Err(RunError::Interrupted { time, step });
            }
        }
        let seconds = started.elapsed().as_secs_f64();
        let last = self.sample(&gas, S::ZERO);
        let reference = first.mass * self.plan.units.velocity;
        Ok(Outcome {
            particles: (0..gas.len()).map(|id| self.row(&gas, id)).collect(),
            series,
            steps: self.clock.steps,
            time: self.time(),
            seconds,
            digest: gas.digest(),
            drift: Drift {
                mass: (last.mass - first.mass) / first.mass,
                momentum: (last.momentum - first.momentum) / reference,
                energy: (last.energy - first.energy) / first.energy,
            },
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

    /// The first particle with fewer than two neighbours: its density no longer feels the
    /// spacing, and waves move at wrong speeds.
    fn watch(&self, gas: &Gas<'_, S, 1>, seen: Option<Lonely>) -> Option<Lonely> {
        seen.or_else(|| {
            let two = S::count(2);
            let particle = gas
                .neighbours
                .iter()
                .position(|&neighbours| neighbours < two)?;
            let neighbours = gas.neighbours[particle].to_f64();
            Some(Lonely {
                particle,
                time: self.time(),
                neighbours,
            })
        })
    }

    /// One particle in the scenario's units.
    fn row(&self, gas: &Gas<'_, S, 1>, id: usize) -> ParticleRow {
        let units = &self.plan.units;
        let (density, energy) = (gas.density[id], gas.energy[id]);
        let pressure = self.solver.equation_of_state.pressure(density, energy);
        ParticleRow {
            position: self.plan.middle + gas.position[id][0].to_f64() * units.length,
            velocity: gas.velocity[id][0].to_f64() * units.velocity,
            mass: gas.mass[id].to_f64() * units.mass,
            density: density.to_f64() * units.density(),
            pressure: pressure.to_f64() * units.density() * units.energy(),
            energy: energy.to_f64() * units.energy(),
            epsilon: gas.epsilon[id].to_f64() * units.length,
            neighbours: gas.neighbours[id].to_f64(),
        }
    }

    /// One row of the time series.
    fn sample(&self, gas: &Gas<'_, S, 1>, dt: S) -> Sample {
        let rows: Vec<ParticleRow> = (0..gas.len()).map(|id| self.row(gas, id)).collect();
        let sum = |of: fn(&ParticleRow) -> f64| rows.iter().map(of).sum::<f64>();
        Sample {
            time: self.time(),
            steps: self.clock.steps,
            time_step: dt.to_f64() * self.plan.units.time(),
            mass: sum(|p| p.mass),
            momentum: sum(|p| p.mass * p.velocity),
            energy: sum(|p| p.mass * (p.energy + 0.5 * p.velocity * p.velocity)),
            density: Spread::of(rows.iter().map(|p| p.density)),
            velocity: Spread::of(rows.iter().map(|p| p.velocity)),
            pressure: Spread::of(rows.iter().map(|p| p.pressure)),
            neighbours: Spread::of(rows.iter().map(|p| p.neighbours)),
        }
    }
}

/// Refuses a plan with a number that the format cannot hold to 1 %.
fn check_format<S: Scalar>(plan: &Plan, scalar: &str) -> Result<(), RunError> {
    let width = match plan.width {
        Width::Adaptive { eta } => ("eta", eta),
        Width::Constant { epsilon } => ("epsilon", epsilon),
    };
    let mut numbers = vec![
        width,
        ("the length of the domain", 2.0 * plan.half_length),
        ("the duration", plan.end),
        ("courant", plan.courant),
        ("the number of particles", plan.particles() as f64),
    ];
    for stretch in &plan.stretches {
        numbers.extend([
            ("the mass of a particle", stretch.mass),
            ("a velocity", stretch.velocity),
            ("an internal energy", stretch.energy),
        ]);
    }
    for (what, value) in numbers {
        if !((S::from_f64(value).to_f64() - value).abs() <= 0.01 * value.abs()) {
            return Err(RunError::Format {
                what,
                value,
                scalar: scalar.to_owned(),
            });
        }
    }
    Ok(())
}

/// Refuses a run that would not fit into memory, where the system says how much there is.
fn check_memory(particles: usize, bytes_each: usize) -> Result<(), RunError> {
    let Some(available) = available_bytes() else {
        return Ok(());
    };
    // The results are held once more, as rows of f64.
    let needed = particles as f64 * (bytes_each + 2 * size_of::<ParticleRow>()) as f64;
    if needed <= available {
        return Ok(());
    }
    let gib = f64::from(1 << 30);
    Err(RunError::Memory {
        particles,
        needed: needed / gib,
        available: available / gib,
    })
}

/// Free memory as Linux tells it.
fn available_bytes() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024.0)
}
