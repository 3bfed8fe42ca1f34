//! A gas that is stepped.

use std::collections::BTreeMap;

use motes_core::cutoff::Named as NamedCutOff;
use motes_core::digest::Digest;
use motes_core::domain::Domain;
use motes_core::equation::gas::viscosity::Named as NamedViscosity;
use motes_core::equation::gas::{Cloud as _, GasDynamics, Opening, Physics, Width};
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::material::{EquationOfState, Named as NamedMaterial};
use motes_core::scalar::Scalar;

use super::balance::{MassLedger, balance, columns};
use super::description::{description, turns};
use super::limits::check_format;
use super::memory::GasArrays;
use super::opening::OpenSides;
use super::plan::Plan;
use super::walls::WallLedger;
use crate::engine::{Holder, HostScalar, Threads};
use crate::families::apart::{Frame, check_apart};
use crate::run::{
    Balance, Description, Measures, Outcome, Row, RunError, Schedule, Simulation, Spread,
    Spreading, Step, Stops, Sum, check_memory, check_step,
};
use crate::sums::{Compensated, compensated};

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

/// A particle with fewer neighbours than a density can be trusted with.
struct Lonely {
    particle: usize,
    time: f64,
    neighbours: f64,
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

/// A particle in the scenario's units.
struct Particle {
    position: [f64; 3],
    velocity: [f64; 3],
    mass: f64,
    density: f64,
    pressure: f64,
    energy: f64,
    sound_speed: f64,
}

impl<S: HostScalar, P: Physics<S, D> + Send, const D: usize> GasSimulation<S, P, D> {
    fn check_apart(&self, scalar: &str) -> Result<(), RunError> {
        let plan = &self.setup.plan;
        let frame = Frame {
            axes: &plan.axes,
            middle: plan.middle,
            length: plan.units.length,
        };
        check_apart(&self.memory.position, &frame, scalar)
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
        let drops = self.external().into_iter().zip(lengths);
        let work: f64 = drops.map(|(g, length)| (g * length).abs()).sum();
        compensated(self.seen().map(|id| {
            let particle = self.particle(id);
            let law = &self.setup.materials[usize::from(self.memory.material[id])];
            let internal = match law.feels_energy() {
                true => particle.energy.abs(),
                false => particle.sound_speed * particle.sound_speed,
            };
            let squares = particle.velocity.iter().map(|u| u * u).sum::<f64>();
            particle.mass * (internal + 0.5 * squares + work)
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

    /// Of the domain, in the scenario's units.
    fn volume(&self) -> f64 {
        let plan = &self.setup.plan;
        let lengths = plan.axes[..D].iter().map(|axis| axis.upper - axis.lower);
        lengths.map(|length| length * plan.units.length).product()
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

    fn particle(&self, id: usize) -> Particle {
        let (units, gas) = (&self.setup.plan.units, &self.memory);
        let (density, energy) = (gas.density[id], gas.energy[id]);
        let law = &self.setup.materials[usize::from(gas.material[id])];
        let pressure = law.pressure(density, energy);
        let (background, mass_density) = (self.background(), density.to_f64() * units.density());
        let mut particle = Particle {
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

    /// The work from outside since the start, in the scenario's units.
    fn work(&self) -> f64 {
        let units = &self.setup.plan.units;
        self.walls.work() * units.mass * units.energy()
    }

    /// The pressure that the materials leave out, in the scenario's units.
    fn background(&self) -> f64 {
        let (plan, units) = (&self.setup.plan, &self.setup.plan.units);
        plan.options.background * (units.density() * units.energy())
    }

    /// The external acceleration in the scenario's units.
    fn external(&self) -> [f64; 3] {
        let plan = &self.setup.plan;
        let unit = plan.units.velocity / plan.units.time();
        let acceleration = plan.options.plain.acceleration;
        acceleration.map(|component| component * unit)
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
        let (mut pull, background) = (self.external(), self.background());
        for (component, axis) in pull.iter_mut().zip(&self.setup.plan.axes) {
            // No place along a circle is higher than another.
            if axis.is_periodic() {
                *component = 0.0;
            }
        }
        let mut sums = [Compensated::default(); 9];
        let mut spreads = [Spreading::default(); 4];
        for id in self.seen() {
            let Particle {
                position: x,
                velocity: u,
                mass,
                density,
                pressure,
                energy,
                ..
            } = self.particle(id);
            let speed = u.iter().map(|u| u * u).sum::<f64>().sqrt();
            let kinetic = 0.5 * mass * speed * speed;
            let along: f64 = x.iter().zip(&pull).map(|(x, g)| x * g).sum();
            let turn = |i: usize| {
                let (a, b) = ((i + 1) % 3, (i + 2) % 3);
                mass * (x[a] * u[b] - x[b] * u[a])
            };
            let terms = [
                mass,
                mass * u[0],
                mass * u[1],
                mass * u[2],
                turn(0),
                turn(1),
                turn(2),
                mass * (energy + background / density) + kinetic - mass * along,
                kinetic,
            ];
            sums.iter_mut()
                .zip(terms)
                .for_each(|(sum, term)| sum.add(term));
            let speed = if D == 1 { u[0] } else { speed };
            let neighbours = self.memory.neighbours[id].to_f64();
            let values = [density, speed, pressure, neighbours];
            spreads
                .iter_mut()
                .zip(values)
                .for_each(|(spread, value)| spread.add(value));
        }
        let [mass, px, py, pz, lx, ly, lz, energy, kinetic] = sums.map(|sum| sum.value());
        // What forces conserve: the particles' volumes sum to that of the domain but for their noise.
        let energy = energy - background * self.volume();
        let (momentum, angular) = ([px, py, pz], [lx, ly, lz]);
        let mut diagnostics = vec![mass];
        diagnostics.extend(&momentum[..D]);
        diagnostics.push(energy);
        for spread in spreads {
            let Spread { min, mean, max } = spread.spread();
            diagnostics.extend([min, mean, max]);
        }
        diagnostics.push(kinetic);
        diagnostics.extend(turns(D).iter().map(|&i| angular[i]));
        let plan = &self.setup.plan;
        let columns = columns(plan.opening.as_ref()).into_iter();
        diagnostics.extend(columns.map(|(end, _)| self.ledger.mass(end) * plan.units.mass));
        let unit = plan.units.mass * plan.units.velocity / plan.units.time();
        let forces = plan.force_columns().into_iter();
        diagnostics
            .extend(forces.map(|((axis, end, i), _)| self.walls.forces.force[axis][end][i] * unit));
        diagnostics.extend(plan.work_column().map(|_| self.work()));
        let values = [
            vec![mass],
            momentum.to_vec(),
            angular.to_vec(),
            vec![energy],
        ];
        let sums = values.into_iter().zip(self.sizes);
        Measures {
            diagnostics,
            sums: sums.map(|(value, size)| Sum { value, size }).collect(),
        }
    }

    fn expected(&self, mut first: Vec<Sum>) -> Vec<Sum> {
        if let Some(energy) = first.last_mut().and_then(|sum| sum.value.first_mut()) {
            *energy += self.work();
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
        let lonely = self.lonely.iter().map(|lonely| {
            format!(
                "particle {} had {} neighbour(s) at t = {:.6}: its density no longer feels the \
                 spacing, and waves may move at wrong speeds; use eta, or a larger epsilon",
                lonely.particle, lonely.neighbours, lonely.time
            )
        });
        lonely.chain(drifted::<S>(outcome)).collect()
    }
}

/// The energy that a sound run may gain or lose: leap-frog and viscosity stay far below it.
const SOUND_DRIFT: f64 = 1e-3;

/// A warning where the energy has moved as it does not in a sound run.
fn drifted<S: Scalar>(outcome: &Outcome) -> Option<String> {
    let drift = outcome.drift_of("energy");
    let cause = match S::HAS_EXACT_SUMS {
        true => {
            "numbers may have overflowed (--check-overflow tells), else the time step is too large \
             (time.courant)"
        }
        false => "the time step is too large: use a smaller time.courant",
    };
    (outcome.is_conserving && !(drift.abs() < SOUND_DRIFT)).then(|| {
        format!("the total energy moved by {drift:.1e} of kinetic, internal and external energy: {cause}")
    })
}
