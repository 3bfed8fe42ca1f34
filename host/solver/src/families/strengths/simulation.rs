//! A cloud of strengths that is stepped.

use std::sync::Arc;

use motes_core::cloud::Words;
use motes_core::digest::Digest;
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::scalar::Scalar;

use super::balance::{Source, balance};
use super::description::description;
use super::digits::{few_digits, short_steps};
use super::doubts::{thin, undamped};
use super::growth::Monitor;
use super::plan::Plan;
use super::principle::beyond;
use super::solver::{Maker, Solver};
use crate::engine::{Holder, HostScalar, Threads};
use crate::families::apart::{Frame, check_apart};
use crate::run::{
    Balance, Description, EnergyNorm, Measures, Outcome, Particulars, Row, RunError, Schedule,
    Simulation, Spread, Step, Stops, Sum, check_memory, check_step,
};
use crate::scenario::linear::System;

/// A cloud in the memory of a server, and its solver.
pub(super) struct Strengths<S: HostScalar> {
    /// Without its particles.
    pub(super) plan: Arc<Plan>,
    pub(super) solver: Box<dyn Solver<S>>,
    pub(super) clock: Clock<S>,
    stops: Stops<S>,
    /// The step that is asked for.
    given: Option<S>,
    monitor: Monitor,
    holder: Holder,
    description: Description,
}

/// A cloud at its start.
///
/// # Errors
/// Numbers that the scalar cannot hold, too little memory, and what the solver finds.
pub(in crate::families) fn start<S: HostScalar>(
    mut plan: Plan,
    maker: Maker<S>,
    scalar: &str,
    engine: &mut Threads,
) -> Result<Box<dyn Simulation>, RunError> {
    check_memory(plan.weights.len(), maker.bytes)?;
    plan.check_format::<S>(scalar)?;
    let description = description(&plan);
    let particles = plan.take_particles();
    let plan = Arc::new(plan);
    let mut simulation = Strengths {
        solver: (maker.make)(&plan, particles),
        clock: Clock::new(S::from_f64(plan.end)),
        stops: Stops::none(),
        given: plan.step.map(S::from_f64),
        monitor: Monitor::new(None, 0, 0.0, 0.0),
        holder: Holder::new(),
        plan,
        description,
    };
    let frame = Frame {
        axes: &simulation.plan.axes,
        middle: simulation.plan.middle,
        length: simulation.plan.units.length,
    };
    check_apart(simulation.solver.cloud().positions(), &frame, scalar)?;
    simulation.prepare(engine).map_err(RunError::at_start)?;
    Ok(Box::new(simulation))
}

impl<S: HostScalar> Strengths<S> {
    fn prepare(&mut self, engine: &mut Threads) -> Result<(), RunError> {
        engine.serve(&self.holder);
        let failed = self.failed();
        self.solver.prepare(engine).map_err(failed)?;
        let rate = self.solver.growth();
        let rate = rate.map(|rate| rate / self.plan.unit_of_time());
        let (order, margin) = (self.solver.order(), self.plan.growth_margin);
        self.monitor = Monitor::new(rate, order, margin, self.norm());
        Ok(())
    }

    /// The step that is asked for, or the one that the solver makes.
    fn time_step(&mut self, left: S) -> Result<S, RunError> {
        let time = self.clock.time;
        let Some(step) = self.given else {
            let failed = self.failed();
            return self.solver.time_step(time, left).map_err(failed);
        };
        let unit = self.plan.unit_of_time();
        let failed = self.failed();
        let stable = self.solver.stable_step(time);
        match stable.map_err(failed)? {
            Some(limit) if !(step <= limit) => Err(RunError::Step {
                step: step.to_f64() * unit,
                limit: limit.to_f64() * unit,
                time: self.time(),
            }),
            _ => Ok(Scalar::lesser(step, left)),
        }
    }

    /// What an error of the solver is from here.
    fn failed(&self) -> impl Fn(Error) -> RunError + Copy + use<S> {
        let (time, step) = (self.time(), self.clock.steps);
        let (spacings, epsilon) = (self.plan.epsilon, self.plan.width());
        move |error| {
            let is_narrow = matches!(
                error,
                Error::Isolated { .. }
                    | Error::PeriodTooShort { .. }
                    | Error::WallsTooNear { .. }
                    | Error::Range
            );
            match is_narrow && step == 0 {
                true => RunError::Width {
                    spacings,
                    epsilon,
                    error,
                },
                false => RunError::solver(time, step, error),
            }
        }
    }

    fn count(&mut self, engine: &mut Threads) -> Result<(), RunError> {
        let failed = self.failed();
        let counted = self.solver.count_neighbours(engine, self.clock.time);
        counted.map_err(failed)
    }
}

impl<S: HostScalar> Simulation for Strengths<S> {
    fn description(&self) -> &Description {
        &self.description
    }

    /// At the end that of the scenario, not as rounded.
    fn time(&self) -> f64 {
        if self.is_over() {
            return self.plan.duration;
        }
        self.stops.time(&self.clock, self.plan.unit_of_time())
    }
    fn steps(&self) -> u64 {
        self.clock.steps
    }
    fn done(&self) -> f64 {
        match self.is_over() {
            true => 1.0,
            false => self.clock.time.to_f64() / self.clock.end.to_f64(),
        }
    }
    fn is_over(&self) -> bool {
        self.clock.time == self.clock.end
    }

    fn meet(&mut self, schedule: Schedule) {
        self.stops = Stops::new(schedule);
    }

    fn step(&mut self, engine: &mut Threads) -> Result<Option<Step>, RunError> {
        let Some(left) = self.clock.left() else {
            return Ok(None);
        };
        engine.serve(&self.holder);
        let failed = self.failed();
        let unit = self.plan.unit_of_time();
        let room = self.stops.room(&self.clock, left, unit);
        let dt = Clock::with_rest(self.time_step(room.longest)?, room.longest);
        check_step((self.time(), unit), dt, left)?;
        let source = self.source_norm();
        let step = (self.clock.time, dt);
        let made = self.solver.advance(engine, step);
        let evaluations = made.map_err(failed)?;
        let ticked = self.stops.tick(&mut self.clock, dt, &room);
        ticked.map_err(failed)?;
        let length = dt.to_f64() * unit;
        let (time, norm) = (self.time(), self.norm());
        self.monitor.step(time, length, source, norm)?;
        if self.plan.counts_always {
            self.count(engine)?;
        }
        Ok(Some(Step {
            length,
            is_whole: dt < room.longest,
            evaluations,
        }))
    }

    fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        self.clock.pass(words)?;
        self.stops.pass(words)?;
        self.monitor.pass(words)?;
        if words.fills() {
            // The engine's lists are those of another state.
            self.holder = Holder::new();
        }
        self.solver.pass(words)
    }

    fn observe(&mut self, engine: &mut Threads) -> Result<(), RunError> {
        match self.plan.counts_always {
            true => Ok(()),
            false => {
                engine.serve(&self.holder);
                self.count(engine)
            }
        }
    }

    fn places(&self) -> usize {
        self.solver.cloud().weight.len()
    }

    fn show(&self, place: usize, row: &mut Row) -> bool {
        let (cloud, plan) = (self.solver.cloud(), &self.plan);
        let dimension = cloud.dimension;
        let x = &cloud.position[place * dimension..][..dimension];
        row.position = std::array::from_fn(|i| match x.get(i) {
            Some(x) => plan.middle[i] + x.to_f64() * plan.units.length,
            None => 0.0,
        });
        row.volume = cloud.weight[place].to_f64() * plan.unit_of_volume();
        row.values.clear();
        row.values.extend(&row.position[..dimension]);
        row.values.push(row.volume);
        let values = &cloud.value[place * cloud.components..][..plan.names.len()];
        row.values.extend(values.iter().map(|u| u.to_f64()));
        row.values.push(cloud.neighbours[place].to_f64());
        true
    }

    fn measures(&self) -> Measures {
        let components = 0..self.plan.names.len();
        let scales = self.scales();
        let sum = |component: usize| Sum {
            value: vec![self.total(component)],
            size: scales[component],
        };
        let sums: Vec<Sum> = components.clone().map(sum).collect();
        let spread = |component: usize| {
            let values = self.solver.cloud().values();
            Spread::of(values.map(|u| u[component].to_f64()))
        };
        let mut diagnostics = vec![self.norm(), self.monitor.bound()];
        diagnostics.extend(sums.iter().map(|sum| sum.value[0]));
        for Spread { min, mean, max } in components.map(spread).chain([self.neighbours()]) {
            diagnostics.extend([min, mean, max]);
        }
        let volume = self.plan.unit_of_volume();
        for source in Source::all(&self.plan) {
            let intake = self.solver.intake(source);
            diagnostics.extend(intake.map(|intake| volume * intake));
        }
        Measures { diagnostics, sums }
    }

    fn energy_weights(&self) -> Vec<f64> {
        let p = self.plan.names.len();
        let is_plain = matches!(self.plan.system, System::ConvectionDiffusion(_));
        if is_plain || p < 2 || self.places() == 0 {
            return Vec::new();
        }
        let energy = |i: usize, j: usize| self.energy_of(&[i, j]);
        // Of both at once what is not of either is that of their product, twice.
        let entry = |i: usize, j: usize| match i == j {
            true => energy(i, i),
            false => 0.5 * (energy(i, j) - energy(i, i) - energy(j, j)),
        };
        (0..p * p).map(|k| entry(k / p, k % p)).collect()
    }

    fn expected(&self, first: Vec<Sum>) -> Vec<Sum> {
        let sums: Vec<f64> = first.iter().map(|sum| sum.value[0]).collect();
        let after = self.plan.budget.after(self.time(), &sums);
        let size = |sum: &Sum| sum.size;
        (first.iter().map(size).zip(after))
            .map(|(size, value)| Sum {
                value: vec![value],
                size,
            })
            .collect()
    }

    fn neighbours(&self) -> Spread {
        Spread::of(self.solver.cloud().neighbours.iter().map(|n| n.to_f64()))
    }

    fn width(&self) -> f64 {
        self.plan.width()
    }

    fn digest(&mut self) -> Digest {
        self.solver.digest()
    }

    fn digest_unordered(&mut self) -> Digest {
        self.solver.digest_unordered()
    }

    fn state_bytes(&mut self) -> usize {
        self.solver.state_bytes()
    }

    fn reconstruct(&mut self, points: Option<&[[f64; 3]]>) -> Result<Vec<f64>, RunError> {
        let (plan, failed) = (&self.plan, self.failed());
        let along = |x: &[f64; 3], i: usize| (x[i] - plan.middle[i]) / plan.units.length;
        let place = |x| std::array::from_fn(|i| S::from_f64(along(x, i)));
        let points = points.map(|points| points.iter().map(place).collect::<Vec<[S; 3]>>());
        let made = self.solver.reconstruct(self.clock.time, points.as_deref());
        let values = made.map_err(failed)?;
        let components = self.solver.cloud().components;
        let rows = values.chunks_exact(components);
        let named = rows.flat_map(|u| &u[..self.plan.names.len()]);
        Ok(named.map(|u| u.to_f64()).collect())
    }

    fn undamped(&mut self, engine: &mut Threads) -> Result<f64, RunError> {
        engine.serve(&self.holder);
        let failed = self.failed();
        let part = self.solver.undamped(engine, self.clock.time);
        part.map_err(failed)
    }

    fn doubts(&self, outcome: &Outcome) -> Vec<String> {
        let (plan, blind) = (&self.plan, undamped(outcome.undamped));
        let weights = self.solver.cloud().weight.iter().map(|w| w.to_f64());
        let largest = weights.fold(0.0, f64::max);
        let thinned = thin(
            plan.cut_off,
            plan.epsilon,
            (largest, plan.dimension),
            "the end",
        );
        // What was thin at the start is told already.
        let was_thin = plan
            .doubts
            .iter()
            .any(|doubt| doubt.contains("at the start"));
        let thinned = thinned.filter(|_| !was_thin);
        plan.doubts
            .iter()
            .cloned()
            .chain(blind)
            .chain(thinned)
            .collect()
    }

    fn warnings(&self, outcome: &Outcome) -> Vec<String> {
        let least = outcome.neighbours.min;
        let thin = (least < 2.0 && self.plan.epsilon > 0.0).then(|| {
            format!(
                "a particle has {least} neighbour(s): the cloud is too thin there; use a \
                 larger epsilon (cut-off.eta)"
            )
        });
        let tiniest = S::WRAPS.then(|| S::TINIEST.to_f64());
        let blurred = tiniest.and_then(|tiniest| {
            few_digits(&self.plan, tiniest, &self.energy_weights(), &outcome.series)
        });
        let astray = tiniest.and_then(|tiniest| short_steps(&self.plan, tiniest, self.clock.steps));
        let beyond = beyond(&self.plan, &outcome.series);
        thin.into_iter()
            .chain(blurred)
            .chain(astray)
            .chain(beyond)
            .collect()
    }

    fn balance(&self, outcome: &Outcome) -> Vec<Balance> {
        balance(&self.plan, &outcome.series)
    }

    fn particulars(&self, outcome: &Outcome) -> Option<Particulars> {
        let norms = outcome.series.of("energy_norm");
        let last = |values: &[f64]| values.last().copied().unwrap_or(f64::NAN);
        let bound = last(&outcome.series.of("energy_bound"));
        Some(Particulars {
            system: self.plan.system.name().to_owned(),
            components: self.plan.names.clone(),
            method: self.plan.method.name().to_owned(),
            epsilon: self.plan.width(),
            energy_norm: EnergyNorm {
                first: norms.first().copied().unwrap_or(f64::NAN),
                last: last(&norms),
                bound: Some(bound).filter(|bound| bound.is_finite()),
            },
        })
    }
}
