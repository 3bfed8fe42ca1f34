//! Stepping a plan to its end.

use std::time::Instant;

use motes_core::equation::linear::{Place, State};
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::scalar::Scalar;

use super::growth::Monitor;
use super::limits::LinearError;
use super::outcome::{Cloud, Outcome, Sample};
use super::plan::Plan;
use super::solver::Solver;
use crate::engine::{HostScalar, Threads};
use crate::simulation::{RunError, Spread, check_memory, check_step};
use crate::sums::compensated;

/// A look at a run between two steps.
pub struct Look<'a> {
    /// Time.
    pub time: f64,
    /// Steps made.
    pub steps: u64,
    /// The particles; made when asked for.
    pub cloud: &'a dyn Fn() -> Cloud,
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
struct Run<'a, S, V, const D: usize, const P: usize> {
    plan: &'a Plan,
    solver: V,
    clock: Clock<S>,
    step: Option<S>,
}

/// Runs a plan with one scalar and solver, which takes so many bytes a particle. `P` may exceed
/// the components of the plan: those beyond stay 0.
pub(super) fn run_with<S: HostScalar, V: Solver<S, D, P>, const D: usize, const P: usize>(
    plan: &Plan,
    scalar: &str,
    (solver, bytes): (V, usize),
    engine: &mut Threads,
    control: &mut Control<'_>,
) -> Result<Outcome, LinearError> {
    check_memory(plan.weights.len(), bytes)?;
    plan.check_format::<S>(scalar)?;
    let run = Run {
        plan,
        clock: Clock::new(S::from_f64(plan.end)),
        step: plan.step.map(S::from_f64),
        solver,
    };
    let mut arrays = run.solver.arrays(plan.particles().collect());
    run.complete(&mut arrays, engine, control)
}

impl<S: HostScalar, V, const D: usize, const P: usize> Run<'_, S, V, D, P>
where
    V: Solver<S, D, P>,
{
    fn complete(
        mut self,
        arrays: &mut V::Arrays,
        engine: &mut Threads,
        control: &mut Control<'_>,
    ) -> Result<Outcome, LinearError> {
        let (mut state, mut work) = V::parts(arrays);
        let started = Instant::now();
        self.solver
            .prepare(engine, &mut state, &mut work)
            .map_err(|error| self.failed(error))?;
        let rate = self.solver.growth();
        let rate = rate.map(|rate| rate / self.plan.unit_of_time());
        let order = self.solver.order();
        let mut monitor = Monitor::new(rate, order, self.plan.growth_margin, self.norm(&state));
        let first = self.sample(&state, &monitor, S::ZERO);
        let mut series = vec![first];
        let (mut sampled, mut sides) = (0.0, 0);
        let (mut smallest, mut largest) = (f64::INFINITY, 0.0f64);
        self.show(&state, control)?;
        while let Some(left) = self.clock.left() {
            let dt = self.time_step(&state, &work, left)?;
            check_step((self.time(), self.plan.unit_of_time()), dt, left)?;
            let source = self.source_norm(&state);
            let step = (self.clock.time, dt);
            let made = self.solver.advance(engine, &mut state, &mut work, step);
            sides += u64::from(made.map_err(|error| self.failed(error))?);
            self.clock.tick(dt).map_err(|error| self.failed(error))?;
            let real_dt = dt.to_f64() * self.plan.unit_of_time();
            (smallest, largest) = (smallest.min(real_dt), largest.max(real_dt));
            monitor.step(self.time(), real_dt, source, self.norm(&state))?;
            let done = self.clock.time.to_f64() / self.clock.end.to_f64();
            let due = (done * control.samples as f64).floor();
            let is_due = due > sampled || self.clock.left().is_none();
            if is_due || self.plan.counts_always {
                self.solver
                    .count_neighbours(engine, &mut state, &mut work, self.clock.time)
                    .map_err(|error| self.failed(error))?;
            }
            if is_due {
                sampled = due;
                series.push(self.sample(&state, &monitor, dt));
            }
            self.show(&state, control)?;
            if !(control.progress)(done) {
                return Err(LinearError::Run(RunError::Interrupted {
                    time: self.time(),
                    step: self.clock.steps,
                }));
            }
        }
        let seconds = started.elapsed().as_secs_f64();
        let cloud = self.cloud(&state);
        let drift = self.drift(&series[0], &series[series.len() - 1]);
        let steps = self.clock.steps;
        let undamped = self
            .solver
            .undamped(engine, &mut state, &mut work, self.clock.time)
            .map_err(|error| self.failed(error))?;
        Ok(Outcome {
            undamped,
            sides,
            reconstruction: self.reconstruction(&state, &mut work, None)?,
            probe: match &self.plan.probe {
                Some(points) => self.reconstruction(&state, &mut work, Some(points))?,
                None => Vec::new(),
            },
            digest: state.digest(),
            cloud,
            series,
            steps,
            smallest_step: if steps > 0 { smallest } else { 0.0 },
            largest_step: largest,
            time: self.time(),
            seconds,
            drift,
        })
    }

    /// The step that is asked for, or the one that the solver makes.
    fn time_step(
        &self,
        state: &State<'_, S, D, P>,
        work: &V::Work<'_>,
        left: S,
    ) -> Result<S, LinearError> {
        let time = self.clock.time;
        let Some(step) = self.step else {
            return self
                .solver
                .time_step(state, work, time, left)
                .map_err(|error| self.failed(error));
        };
        match self.solver.stable_step(state, work, time) {
            Some(limit) if !(step <= limit) => Err(LinearError::Step {
                step: step.to_f64() * self.plan.unit_of_time(),
                limit: limit.to_f64() * self.plan.unit_of_time(),
                time: self.time(),
            }),
            _ => Ok(Scalar::lesser(step, left)),
        }
    }

    /// The time in the scenario's units; at the end that of the scenario, not as rounded.
    fn time(&self) -> f64 {
        if self.clock.time == self.clock.end {
            return self.plan.duration;
        }
        self.clock.time.to_f64() * self.plan.unit_of_time()
    }

    fn failed(&self, error: Error) -> LinearError {
        let narrow = matches!(
            error,
            Error::Isolated { .. }
                | Error::PeriodTooShort { .. }
                | Error::WallsTooNear { .. }
                | Error::Range
        );
        if narrow && self.clock.steps == 0 {
            let (spacings, epsilon) = (self.plan.epsilon, self.plan.width());
            return LinearError::Width {
                spacings,
                epsilon,
                error,
            };
        }
        LinearError::Run(RunError::Solver {
            time: self.time(),
            step: self.clock.steps,
            error,
        })
    }

    fn show(
        &self,
        state: &State<'_, S, D, P>,
        control: &mut Control<'_>,
    ) -> Result<(), LinearError> {
        let look = Look {
            time: self.time(),
            steps: self.clock.steps,
            cloud: &|| self.cloud(state),
        };
        (control.look)(&look).map_err(|reason| {
            LinearError::Run(RunError::Look {
                time: look.time,
                reason,
            })
        })
    }

    /// `(Σ w u·Pu)^(1/2)`, weights in the scenario's units.
    fn norm(&self, state: &State<'_, S, D, P>) -> f64 {
        self.norm_of(state, |_, u| *u)
    }

    /// The same of the source, per time of the scenario's units.
    fn source_norm(&self, state: &State<'_, S, D, P>) -> f64 {
        let norm = self.norm_of(state, |place, _| self.solver.source(place));
        norm / self.plan.unit_of_time()
    }

    fn norm_of(
        &self,
        state: &State<'_, S, D, P>,
        of: impl Fn(&Place<S, D>, &[S; P]) -> [S; P],
    ) -> f64 {
        let time = self.clock.time;
        // Values of size 1 have squares in every format.
        let size = self.plan.amplitude;
        let rows = state.position.iter().zip(state.weight.iter());
        let terms = rows.zip(state.value.iter()).map(|((&position, w), u)| {
            let place = Place { position, time };
            let u = of(&place, u).map(|u| S::from_f64(u.to_f64() / size));
            w.to_f64() * self.solver.energy_density(&place, &u).to_f64()
        });
        let squared = compensated(terms) * self.plan.unit_of_volume();
        // Rounding may leave less than nothing of nothing; what is no number stays none.
        if squared < 0.0 {
            0.0
        } else {
            size * squared.sqrt()
        }
    }

    /// The particles in the scenario's units, in id order.
    fn cloud(&self, state: &State<'_, S, D, P>) -> Cloud {
        let length = self.plan.units.length;
        let place = |x: &[S; D]| {
            std::array::from_fn(|i| match x.get(i) {
                Some(x) => self.plan.middle[i] + x.to_f64() * length,
                None => 0.0,
            })
        };
        let volume = self.plan.unit_of_volume();
        Cloud {
            positions: state.position.iter().map(place).collect(),
            weights: state.weight.iter().map(|w| w.to_f64() * volume).collect(),
            components: self.plan.names.len(),
            values: self.plain(state.value),
            neighbours: state.neighbours.iter().map(|n| n.to_f64()).collect(),
        }
    }

    /// Values without the components beyond those of the plan.
    fn plain(&self, values: &[[S; P]]) -> Vec<f64> {
        let components = self.plan.names.len();
        let rows = values.iter().flat_map(|u| &u[..components]);
        rows.map(|u| u.to_f64()).collect()
    }

    /// (1.13) at some points, at the particles without.
    fn reconstruction(
        &self,
        state: &State<'_, S, D, P>,
        work: &mut V::Work<'_>,
        points: Option<&[[f64; 3]]>,
    ) -> Result<Vec<f64>, LinearError> {
        let points = match points {
            None => state.position.to_vec(),
            Some(points) => {
                let place = |x: &[f64; 3]| std::array::from_fn(|i| S::from_f64(x[i]));
                points.iter().map(place).collect()
            }
        };
        let mut values = vec![[S::ZERO; P]; points.len()];
        self.solver
            .reconstruct(state, work, self.clock.time, &points, &mut values)
            .map_err(|error| self.failed(error))?;
        Ok(self.plain(&values))
    }

    /// One row of the time series.
    fn sample(&self, state: &State<'_, S, D, P>, monitor: &Monitor, dt: S) -> Sample {
        let volume = self.plan.unit_of_volume();
        let cloud = self.cloud(state);
        let components = 0..self.plan.names.len();
        let exact = state.total();
        let total = |i: usize| {
            // A sum of rounded numbers would move where the exact one does not.
            if S::HAS_EXACT_SUMS {
                return volume * S::wide_to_f64(exact[i]);
            }
            let strengths = state.strength.iter().map(|q| S::wide_to_f64(q[i]));
            volume * compensated(strengths)
        };
        let size = |i: usize| {
            let strengths = state.strength.iter();
            let sizes = strengths.map(|q| S::rounded(q[i]).to_f64().abs());
            volume * compensated(sizes)
        };
        Sample {
            time: self.time(),
            steps: self.clock.steps,
            time_step: dt.to_f64() * self.plan.unit_of_time(),
            totals: components.clone().map(total).collect(),
            sizes: components.clone().map(size).collect(),
            energy: monitor.energy(self.norm(state)),
            spreads: components
                .map(|i| Spread::of(cloud.component(i).into_iter()))
                .collect(),
            neighbours: Spread::of(cloud.neighbours.iter().copied()),
        }
    }

    /// What the sums have moved by.
    fn drift(&self, first: &Sample, last: &Sample) -> Option<Vec<f64>> {
        if !self.plan.is_conserving {
            return None;
        }
        let totals = first.totals.iter().zip(&last.totals);
        let sizes = first.sizes.iter().zip(&last.sizes);
        let part = |((first, last), (before, after)): ((&f64, &f64), (&f64, &f64))| {
            let (moved, size) = (last - first, before.max(*after));
            if moved == 0.0 { 0.0 } else { moved / size }
        };
        Some(totals.zip(sizes).map(part).collect())
    }
}
