//! A gas that is stepped.

use std::collections::BTreeMap;

use motes_core::cloud::{Columns as _, Words};
use motes_core::cutoff::Named as NamedCutOff;
use motes_core::digest::Digest;
use motes_core::domain::Domain;
use motes_core::equation::gas::viscosity::Named as NamedViscosity;
use motes_core::equation::gas::{Cloud as _, GasDynamics, Opening, Physics, Width};
use motes_core::equation::{Dynamics, Parts};
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::material::{EquationOfState, Named as NamedMaterial};
use motes_core::scalar::Scalar;

use super::balance::{MassLedger, balance};
use super::description::description;
use super::limits::check_format;
use super::measures::{Observed, Totals};
use super::memory::GasArrays;
use super::opening::OpenSides;
use super::plan::Plan;
use super::walls::WallLedger;
use super::warnings::{Lonely, drifted};
use crate::engine::{Holder, HostScalar, Threads};
use crate::families::apart::{Frame, check_apart};
use crate::run::{
    Balance, Description, Measures, Outcome, Row, RunError, Schedule, Simulation, Spread, Step,
    Stops, Sum, check_memory, check_step,
};
use crate::sums::compensated;

/// The equations in the scalar of the run.
struct Setup<S: Scalar, P, const D: usize> {
    /// Without its particles.
    plan: Plan,
    domain: Domain<S, D>,
    viscosity: NamedViscosity<S>,
    physics: P,
    materials: Vec<NamedMaterial<S>>,
    layer: Vec<[S; D]>,
}

type Solver<'m, S, P, const D: usize> =
    GasDynamics<'m, S, NamedCutOff, NamedViscosity<S>, NamedMaterial<S>, P, D>;

impl<S: Scalar, P: Physics<S, D>, const D: usize> Setup<S, P, D> {
    fn solver(&self) -> Solver<'_, S, P, D> {
        let plan = &self.plan;
        plan.solver(plan.cut_off, self.viscosity, self.physics, &self.materials)
    }

    fn opening(&self) -> Option<Opening<'_, S, D>> {
        let opening = self.plan.opening.as_ref();
        opening.map(|opening| opening.rounded(&self.layer))
    }
}

/// A gas in the memory of a server.
struct GasSimulation<S: Scalar, P: Physics<S, D>, const D: usize> {
    setup: Setup<S, P, D>,
    memory: GasArrays<S, P::Shown, D>,
    clock: Clock<S>,
    stops: Stops<S>,
    lonely: Option<Lonely>,
    ledger: MassLedger,
    walls: WallLedger<D>,
    holder: Holder,
    /// What the drifts of mass, momentum, angular momentum and energy are compared with.
    sizes: [f64; 4],
    description: Description,
}

/// A gas at its start.
///
/// # Errors
/// Numbers that the scalar cannot hold, too little memory, and what the solver finds.
pub(in crate::families) fn start<S: HostScalar, const D: usize>(
    plan: Plan,
    scalar: &str,
    engine: &mut Threads,
) -> Result<Box<dyn Simulation>, RunError> {
    let options = plan.options::<S, D>();
    if S::WRAPS && options.linear_exact {
        return Err(RunError::Gradient {
            scalar: scalar.to_owned(),
        });
    }
    if options.need_exchange() {
        prepared(plan, options, scalar, engine)
    } else {
        prepared(plan, options.plain, scalar, engine)
    }
}

fn prepared<S: HostScalar, P: Physics<S, D> + Send + 'static, const D: usize>(
    mut plan: Plan,
    physics: P,
    scalar: &str,
    engine: &mut Threads,
) -> Result<Box<dyn Simulation>, RunError> {
    let options = plan.options::<S, D>();
    let bytes = GasArrays::<S, P::Shown, D>::bytes_per_particle(&options);
    check_memory(plan.particles.len(), bytes)?;
    check_format::<S>(&plan, scalar)?;
    let description = description(&plan);
    let memory = GasArrays::new(plan.take_particles(), &options);
    let layer = plan.opening.as_ref().map(OpenSides::layer);
    let mut simulation = GasSimulation {
        memory,
        clock: Clock::new(S::from_f64(plan.end)),
        stops: Stops::none(),
        lonely: None,
        ledger: MassLedger::default(),
        walls: WallLedger::default(),
        holder: Holder::new(),
        sizes: [0.0; 4],
        description,
        setup: Setup {
            domain: plan.domain(),
            viscosity: plan.viscosity(),
            physics,
            materials: plan.materials(),
            layer: layer.unwrap_or_default(),
            plan,
        },
    };
    simulation.check_apart(scalar)?;
    simulation.prepare(engine).map_err(RunError::at_start)?;
    Ok(Box::new(simulation))
}

impl<S: HostScalar, P: Physics<S, D> + Send, const D: usize> GasSimulation<S, P, D> {
    fn check_apart(&self, scalar: &str) -> Result<(), RunError> {
        let plan = &self.setup.plan;
        let frame = Frame {
            axes: &plan.axes,
            middle: plan.middle,
            length: plan.units.length,
        };
        check_apart(
            self.memory.position.iter().map(<[S; D]>::as_slice),
            &frame,
            scalar,
        )
    }

    fn prepare(&mut self, engine: &mut Threads) -> Result<(), RunError> {
        engine.serve(&self.holder);
        let failed = self.failed();
        if let Some(opening) = self.setup.opening() {
            opening
                .fill(&self.setup.domain, &mut self.memory)
                .map_err(failed)?;
        }
        let mut prepare = |memory: &mut GasArrays<S, P::Shown, D>| {
            let (mut gas, mut work) = memory.parts();
            let solver = self.setup.solver();
            solver.prepare(engine, &mut gas, &mut work).map_err(failed)
        };
        let background = self.setup.plan.options.background;
        if background > 0.0 {
            // What is given is e, and e + p_0/ρ takes the densities, which the sums make.
            let given = self.memory.energy.clone();
            let expected = self.setup.plan.expected_densities(&self.memory);
            self.memory.energize(&given, background, expected);
            prepare(&mut self.memory)?;
            let summed = self.memory.density.clone();
            self.memory.energize(&given, background, summed);
        }
        prepare(&mut self.memory)?;
        self.follow(0.0);
        self.watch();
        let mass = self.measures().sums[0].value[0];
        let plan = &self.setup.plan;
        let momentum = mass * plan.units.velocity;
        let size = (plan.axes[0].upper - plan.axes[0].lower) * plan.units.length;
        self.sizes = [mass, momentum, momentum * size, self.energies()];
        Ok(())
    }

    /// The energies that can pass into one another, none of them below 0: kinetic, internal, and the
    /// work of the external acceleration across the domain. Where the energy plays no part it is only
    /// kept account of, from 0: mass times the square of the sound speed stands for it.
    fn energies(&self) -> f64 {
        let plan = &self.setup.plan;
        let lengths = plan
            .axes
            .iter()
            .map(|axis| (axis.upper - axis.lower) * plan.units.length);
        let drops = plan.acceleration().into_iter().zip(lengths);
        let work: f64 = drops.map(|(g, length)| (g * length).abs()).sum();
        compensated(self.seen().map(|id| {
            let particle = self.particle(id);
            let law = &self.setup.materials[usize::from(self.memory.material[id])];
            let internal = match law.feels_energy() {
                true => particle.energy.abs(),
                false => particle.sound_speed * particle.sound_speed,
            };
            particle.mass * (internal + particle.kinetic_energy() + work)
        }))
    }

    /// Takes over what acts on the walls, a step of `dt` after the last time.
    fn follow(&mut self, dt: f64) {
        let pull = self.setup.plan.periodic_pull();
        let (gas, work) = self.memory.parts();
        let mut forces = self.setup.solver().wall_forces(&gas, &work);
        if self.setup.plan.options.background > 0.0 {
            self.setup.plan.push(&mut forces);
        }
        let mut power = 0.0;
        if pull.iter().any(|&component| component != 0.0) {
            let along = |u: &[S; D]| {
                u.iter()
                    .zip(&pull)
                    .map(|(u, g)| u.to_f64() * g)
                    .sum::<f64>()
            };
            let rows = gas.mass.iter().zip(gas.velocity.iter());
            power = compensated(rows.map(|(mass, u)| mass.to_f64() * along(u)));
        }
        self.walls.follow(forces, power, dt);
    }

    /// What an error of the solver is from here.
    fn failed(&self) -> impl Fn(Error) -> RunError + Copy + use<S, P, D> {
        let (time, step) = (self.time(), self.clock.steps);
        move |error| RunError::solver(time, step, error)
    }

    /// The first particle with fewer than two neighbours under a constant ε: its density no
    /// longer feels the spacing, and waves move at wrong speeds. An adaptive ε looks for them.
    fn watch(&mut self) {
        if matches!(self.setup.plan.width, Width::Adaptive { .. }) || self.lonely.is_some() {
            return;
        }
        let two = S::count(2);
        let mut all = self.memory.neighbours.iter().zip(&self.memory.position);
        let alone = all.position(|(&neighbours, x)| neighbours < two && !self.is_beyond(x));
        self.lonely = alone.map(|particle| Lonely {
            particle,
            time: self.time(),
            neighbours: self.memory.neighbours[particle].to_f64(),
        });
    }

    fn is_beyond(&self, position: &[S; D]) -> bool {
        self.setup.domain.beyond(position).is_some()
    }

    /// The particles to see, by their places.
    fn seen(&self) -> impl Iterator<Item = usize> {
        let all = 0..self.memory.mass.len();
        all.filter(|&id| !self.is_beyond(&self.memory.position[id]))
    }

    fn particle(&self, id: usize) -> Observed {
        let (units, gas) = (&self.setup.plan.units, &self.memory);
        let (density, energy) = (gas.density[id], gas.energy[id]);
        let law = &self.setup.materials[usize::from(gas.material[id])];
        let pressure = law.pressure(density, energy);
        let (background, mass_density) = (
            self.setup.plan.background(),
            density.to_f64() * units.density(),
        );
        let mut particle = Observed {
            position: [0.0; 3],
            velocity: [0.0; 3],
            mass: gas.mass[id].to_f64() * units.mass,
            density: mass_density,
            pressure: pressure.to_f64() * units.density() * units.energy() + background,
            energy: energy.to_f64() * units.energy() - background / mass_density,
            sound_speed: law.sound_speed(density, energy).to_f64() * units.velocity,
        };
        for i in 0..D {
            let place = gas.position[id][i].to_f64() * units.length;
            particle.position[i] = self.setup.plan.middle[i] + place;
            particle.velocity[i] = gas.velocity[id][i].to_f64() * units.velocity;
        }
        particle
    }
}

impl<S: HostScalar, P: Physics<S, D> + Send, const D: usize> Simulation for GasSimulation<S, P, D> {
    fn description(&self) -> &Description {
        &self.description
    }

    fn time(&self) -> f64 {
        self.stops.time(&self.clock, self.setup.plan.units.time())
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
        self.clock.left().is_none()
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
        let (time, unit) = (self.time(), self.setup.plan.units.time());
        if let Some(opening) = self.setup.opening() {
            opening
                .exchange(&self.setup.domain, &mut self.memory)
                .map_err(failed)?;
            self.ledger.open(&self.setup.domain, &self.memory.position);
        }
        let solver = self.setup.solver();
        let (mut gas, mut work) = self.memory.parts();
        let room = self.stops.room(&self.clock, left, unit);
        let dt = solver.time_step(&gas, room.longest).map_err(failed)?;
        let dt = Clock::with_rest(dt, room.longest);
        check_step((time, unit), dt, left)?;
        solver
            .advance(engine, &mut gas, &mut work, dt)
            .map_err(failed)?;
        if self.setup.plan.is_worked() {
            self.follow(dt.to_f64());
        }
        if self.setup.plan.opening.is_some() {
            let (domain, gas) = (&self.setup.domain, &self.memory);
            self.ledger.close(domain, &gas.position, &gas.mass);
        }
        let ticked = self.stops.tick(&mut self.clock, dt, &room);
        ticked.map_err(failed)?;
        self.watch();
        Ok(Some(Step {
            length: dt.to_f64() * unit,
            is_whole: dt < room.longest,
            evaluations: 1,
        }))
    }

    fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        self.clock.pass(words)?;
        self.stops.pass(words)?;
        let mut particles = self.memory.mass.len() as u64;
        words.count(&mut particles)?;
        if words.fills() {
            self.memory.resize(particles)?;
            // The engine's lists are those of another state.
            self.holder = Holder::new();
        }
        let (state, work) = self.memory.parts();
        let solver = self.setup.solver();
        Dynamics::pass(&solver, &mut Parts { state, work }, words)?;
        self.ledger.pass(words)?;
        self.walls.pass(words)?;
        Lonely::pass(&mut self.lonely, words)
    }

    fn observe(&mut self, _: &mut Threads) -> Result<(), RunError> {
        // Where nothing has to be followed the forces alone are of this moment.
        self.follow(0.0);
        Ok(())
    }

    fn places(&self) -> usize {
        self.memory.mass.len()
    }

    fn show(&self, place: usize, row: &mut Row) -> bool {
        let gas = &self.memory;
        if self.is_beyond(&gas.position[place]) {
            return false;
        }
        let (particle, units) = (self.particle(place), &self.setup.plan.units);
        row.position = particle.position;
        row.volume = particle.mass / particle.density;
        row.values.clear();
        row.values.extend(&particle.position[..D]);
        row.values.extend(&particle.velocity[..D]);
        row.values.extend([
            particle.mass,
            particle.density,
            particle.pressure,
            particle.energy,
            gas.epsilon[place].to_f64() * units.length,
            gas.neighbours[place].to_f64(),
            particle.sound_speed,
            gas.divergence[place].to_f64() / units.time(),
            gas.viscosity_factor[place].to_f64(),
            f64::from(gas.material[place]),
        ]);
        true
    }

    fn measures(&self) -> Measures {
        let plan = &self.setup.plan;
        let mut totals = Totals::new(plan);
        for id in self.seen() {
            totals.add(&self.particle(id), self.memory.neighbours[id].to_f64());
        }
        totals.measures(&self.ledger, &self.walls, self.sizes)
    }

    fn expected(&self, mut first: Vec<Sum>) -> Vec<Sum> {
        if let Some(energy) = first.last_mut().and_then(|sum| sum.value.first_mut()) {
            *energy += self.walls.work(&self.setup.plan);
        }
        first
    }

    fn neighbours(&self) -> Spread {
        Spread::of(self.seen().map(|id| self.memory.neighbours[id].to_f64()))
    }

    fn width(&self) -> f64 {
        let unit = self.setup.plan.units.length;
        Spread::of(
            self.seen()
                .map(|id| self.memory.epsilon[id].to_f64() * unit),
        )
        .mean
    }

    fn digest(&mut self) -> Digest {
        self.memory.gas().digest()
    }

    fn digest_unordered(&mut self) -> Digest {
        self.memory.gas().digest_unordered()
    }

    fn state_bytes(&mut self) -> usize {
        self.memory.gas().state_bytes()
    }

    fn wall_forces(&self, outcome: &Outcome) -> BTreeMap<String, Vec<f64>> {
        self.setup.plan.wall_forces(&outcome.series)
    }

    fn balance(&self, outcome: &Outcome) -> Vec<Balance> {
        balance(self.setup.plan.opening.as_ref(), &outcome.series)
    }

    fn doubts(&self, _: &Outcome) -> Vec<String> {
        self.setup.plan.doubts.clone()
    }

    fn warnings(&self, outcome: &Outcome) -> Vec<String> {
        let lonely = self.lonely.iter().map(Lonely::to_string);
        lonely.chain(drifted::<S>(outcome)).collect()
    }
}
