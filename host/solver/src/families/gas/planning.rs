//! From a scenario to a plan: solver units, and the particles in them.

use motes_core::domain::{Axis, Side};
use motes_core::equation::gas::{
    Diffusion, EnergyForm, Far, NoSlip, Options, Particle, Plain, Stretch, Switch, Weights, Width,
};

use super::background::without;
use super::fitness::{check_reach, check_units};
use super::opening::OpenSides;
use super::packing::packing;
use super::plan::Plan;
use crate::families::PlanError;
use crate::run::{Abscissa, check_memory};
use crate::scenario::{
    self, Arrangement, EnergyRule, EquationOfState, GradientKind, Scenario, Share, ViscosityKind,
    fineness,
};
use crate::setup::{self, Placed};
use crate::sums::compensated;
use crate::units::SolverUnits;

impl Plan {
    /// Refuses more particles than can be counted or fit into memory, before any is placed.
    ///
    /// # Errors
    /// [`PlanError::Setup`] or [`PlanError::Memory`].
    pub fn check_size(scenario: &Scenario) -> Result<(), PlanError> {
        setup::check_count(scenario)?;
        let particles = scenario.resolution.particles;
        let each = size_of::<Placed>() + size_of::<Particle<f64, 3>>();
        check_memory(particles, each).map_err(PlanError::Memory)
    }

    /// Plans a run.
    ///
    /// # Errors
    /// What [`PlanError`] lists.
    pub fn new(scenario: &Scenario) -> Result<Self, PlanError> {
        Self::check_size(scenario)?;
        let (placed, mut doubts) = setup::placed(scenario)?;
        doubts.extend(super::doubts::doubts(scenario, &placed));
        let units = units(scenario, &placed);
        check_units(&units)?;
        let fineness = fineness(placed.len(), scenario.dimension);
        check_reach(scenario, &placed, fineness)?;
        let middle = std::array::from_fn(|i| {
            let bounds = occupied(scenario, &placed, i);
            0.5 * (bounds[0] + bounds[1])
        });
        let frame = Frame {
            scenario,
            units,
            middle,
            fineness,
        };
        let stretches = frame.stretches(&placed);
        let particles: Vec<_> = match &stretches {
            Some(stretches) => frame.of_stretches(stretches),
            None => placed.iter().map(|placed| frame.particle(placed)).collect(),
        };
        let cut_off = scenario.cut_off.shape;
        let axes = frame.axes();
        let opening = OpenSides::new(scenario, &units, &axes, &placed, &particles)?;
        let far = opening.as_ref().map_or([None; 2], |opening| opening.far);
        Ok(Self {
            dimension: scenario.dimension,
            units,
            middle,
            axes,
            opening,
            particles,
            stretches,
            materials: scenario
                .materials
                .iter()
                .map(|material| frame.material(&material.law))
                .collect(),
            cut_off,
            width: frame.width(),
            viscosity: scenario.viscosity,
            options: frame.options(far),
            end: scenario.time.end / units.time(),
            courant: scenario.time.courant,
            abscissa: abscissa(scenario),
            doubts,
        })
    }
}

/// The bounds of the domain along one direction; 0 beyond the dimension.
fn bounds(scenario: &Scenario, axis: usize) -> [f64; 2] {
    let extent = &scenario.domain.extent;
    let at = |corner: &[f64]| corner.get(axis).copied().unwrap_or(0.0);
    [at(&extent.lower), at(&extent.upper)]
}

/// What the frame of the solver is laid over: the domain, or where both sides are free and it is far
/// from full the gas alone. Empty space around a gas changes nothing.
fn occupied(scenario: &Scenario, placed: &[Placed], axis: usize) -> [f64; 2] {
    let [lower, upper] = bounds(scenario, axis);
    let is_free = |sides: &[scenario::Side; 2]| *sides == [scenario::Side::Free; 2];
    if !scenario.domain.sides.get(axis).is_some_and(is_free) {
        return [lower, upper];
    }
    let places = || placed.iter().map(|p| p.position[axis]);
    let [least, most] = [
        places().fold(f64::INFINITY, f64::min),
        places().fold(f64::NEG_INFINITY, f64::max),
    ];
    match most - least < FULL * (upper - lower) {
        true => [least, most],
        false => [lower, upper],
    }
}

/// The part of a domain, free on both sides, beyond which a gas is said to fill it.
const FULL: f64 = 0.9;

/// The direction in which a solution varies; the distance from its centre where it is round.
fn abscissa(scenario: &Scenario) -> Abscissa {
    match scenario.center() {
        Some(center) => Abscissa::From(center),
        None if scenario.dimension == 1 => Abscissa::Along(0),
        None => {
            let channel = scenario.channel().ok();
            Abscissa::Along(scenario.riemann_direction().or(channel).unwrap_or(0))
        }
    }
}

/// Spacing, mass and speed of which everything is counted: the mean spacing, the mean mass,
/// and the largest speed of sound or gas at the start or coming in, or of a wall.
fn units(scenario: &Scenario, placed: &[Placed]) -> SolverUnits {
    let count = placed.len().max(1) as f64;
    let is_file = matches!(scenario.resolution.arrangement, Arrangement::File(_));
    let sum = |of: &dyn Fn(&Placed) -> f64| {
        let mut terms: Vec<f64> = placed.iter().map(of).collect();
        if is_file {
            // The rows of a file may be in any order: so that the last bit does not depend on it.
            terms.sort_unstable_by(f64::total_cmp);
        }
        compensated(terms.into_iter())
    };
    let volume = sum(&|p| p.mass / p.density);
    let spacing = match scenario.dimension {
        1 => {
            // A domain that is full is as long as its gas, but for rounding and the error of a profile.
            let length = bounds(scenario, 0)[1] - bounds(scenario, 0)[0];
            match (volume - length).abs() <= 0.01 * length {
                true => length / count,
                false => volume / count,
            }
        }
        2 => (volume / count).sqrt(),
        _ => libm::cbrt(volume / count),
    };
    let speed = |p: &Placed| {
        let law = &scenario.materials[usize::from(p.material)].law;
        let squares = p.velocity.iter().map(|u| u * u).sum::<f64>();
        squares.max(law.sound_speed_squared(p.density, p.energy))
    };
    let incoming = scenario.inflow.as_ref().map_or(0.0, |inflow| {
        let law = &scenario.materials[inflow.material].law;
        let energy = law.energy(inflow.density, inflow.pressure);
        let squares = inflow.velocity.iter().map(|u| u * u).sum::<f64>();
        squares.max(law.sound_speed_squared(inflow.density, energy))
    });
    let walls = scenario.walls.iter().flatten().flatten();
    let squares = walls.map(|velocity| velocity.iter().map(|u| u * u).sum::<f64>());
    let moving = squares.fold(incoming, f64::max);
    SolverUnits {
        length: spacing,
        mass: sum(&|p| p.mass) / count,
        velocity: placed.iter().map(speed).fold(moving, f64::max).sqrt(),
        dimension: scenario.dimension as i32,
    }
}

/// A scenario seen in solver units.
struct Frame<'a> {
    scenario: &'a Scenario,
    units: SolverUnits,
    middle: [f64; 3],
    /// The mean spacing in the side of what the particles fill.
    fineness: f64,
}

impl Frame<'_> {
    /// ε in local spacings; 1 where it is given as a length.
    fn eta(&self) -> f64 {
        self.scenario.cut_off.width.spacings(self.fineness)
    }

    fn axes(&self) -> [Axis<f64>; 3] {
        std::array::from_fn(|i| {
            let bounds = bounds(self.scenario, i);
            let half = 0.5 * (bounds[1] - bounds[0]) / self.units.length;
            let sides = self.scenario.domain.sides.get(i);
            Axis {
                lower: -half,
                upper: half,
                sides: sides.map_or([Side::Free; 2], |sides| {
                    sides.map(|side| match side {
                        scenario::Side::Free => Side::Free,
                        scenario::Side::Periodic => Side::Periodic,
                        scenario::Side::Mirror => Side::Mirror,
                        scenario::Side::Inflow => Side::Inflow,
                        scenario::Side::Outflow => Side::Outflow,
                    })
                }),
            }
        })
    }

    fn width(&self) -> Width<f64> {
        match self.scenario.cut_off.width {
            scenario::Width::Adaptive { .. } => Width::Adaptive {
                eta: self.eta(),
                packing: packing(&self.scenario.resolution.arrangement),
            },
            scenario::Width::Constant { epsilon } => Width::Constant {
                epsilon: epsilon / self.units.length,
            },
        }
    }

    fn options(&self, far: [Option<Far<f64>>; 2]) -> Options<f64, 3> {
        let scenario = self.scenario;
        let (viscosity, units) = (&scenario.viscosity, &self.units);
        let diffusivity = units.length * units.velocity;
        let acceleration = units.velocity / units.time();
        Options {
            plain: Plain {
                weights: match scenario.weights {
                    scenario::Weights::Mass => Weights::Mass,
                    scenario::Weights::Number => Weights::Number,
                },
                acceleration: std::array::from_fn(|i| {
                    let component = scenario.acceleration.get(i).copied();
                    component.unwrap_or(0.0) / acceleration
                }),
                far,
            },
            energy: match scenario.time.energy {
                EnergyRule::LeapFrog => EnergyForm::LeapFrog,
                EnergyRule::Exact => EnergyForm::Exact,
                EnergyRule::Total => EnergyForm::Total,
            },
            limited: viscosity.kind == ViscosityKind::Limited,
            linear_exact: scenario.gradient == GradientKind::LinearExact,
            switch: viscosity.switch.map(|switch| Switch {
                // The core's factor multiplies alpha, the scenario's minimum is an alpha.
                minimum: if viscosity.alpha > 0.0 {
                    switch.minimum / viscosity.alpha
                } else {
                    0.0
                },
                decay: switch.decay,
            }),
            balsara: viscosity.balsara,
            conduction: scenario.conduction,
            diffusion: Diffusion {
                viscosity: scenario.diffusion.viscosity / diffusivity,
                bulk_viscosity: scenario.diffusion.bulk_viscosity / diffusivity,
                heat: scenario.diffusion.heat / diffusivity,
            },
            background: scenario.background / (units.density() * units.energy()),
            walls: self.no_slip(),
        }
    }

    fn no_slip(&self) -> NoSlip<f64, 3> {
        let walls = &self.scenario.walls;
        let unit = self.units.velocity;
        let vector = |velocity: &Vec<f64>| {
            std::array::from_fn(|i| velocity.get(i).map_or(0.0, |component| component / unit))
        };
        let wall = |axis: usize, end: usize| walls.get(axis).and_then(|ends| ends[end].as_ref());
        NoSlip {
            velocity: std::array::from_fn(|axis| [0, 1].map(|end| wall(axis, end).map(vector))),
        }
    }

    fn material(&self, law: &EquationOfState) -> EquationOfState {
        let pressure = self.units.density() * self.units.energy();
        match without(law, self.scenario.background) {
            EquationOfState::IdealGas { gamma } => EquationOfState::IdealGas { gamma },
            EquationOfState::StiffenedGas {
                gamma,
                pressure_at_infinity,
            } => EquationOfState::StiffenedGas {
                gamma,
                pressure_at_infinity: pressure_at_infinity / pressure,
            },
            EquationOfState::Isothermal { sound_speed } => EquationOfState::Isothermal {
                sound_speed: sound_speed / self.units.velocity,
            },
            EquationOfState::Tait {
                density,
                sound_speed,
                exponent,
            } => EquationOfState::Tait {
                density: density / self.units.density(),
                sound_speed: sound_speed / self.units.velocity,
                exponent,
            },
        }
    }

    fn particle(&self, placed: &Placed) -> Particle<f64, 3> {
        let units = &self.units;
        let volume = placed.mass / placed.density;
        let spacing = match units.dimension {
            1 => volume,
            2 => volume.sqrt(),
            _ => libm::cbrt(volume),
        };
        Particle {
            position: std::array::from_fn(|i| (placed.position[i] - self.middle[i]) / units.length),
            velocity: placed.velocity.map(|component| component / units.velocity),
            mass: placed.mass / units.mass,
            energy: placed.energy / units.energy(),
            epsilon: self.eta() * (spacing / units.length),
            material: placed.material,
        }
    }

    /// The stretches that the particles fill, where regions in one dimension are filled evenly
    /// with particles of equal mass: what a device can be given in a few numbers.
    fn stretches(&self, placed: &[Placed]) -> Option<Vec<Stretch>> {
        let scenario = self.scenario;
        let resolution = &scenario.resolution;
        let even = scenario.dimension == 1
            && resolution.arrangement == Arrangement::EqualMass
            && resolution.share == Share::Mass
            && resolution.jitter == 0.0
            && scenario.profile.is_none()
            && scenario.deposits.is_empty()
            && scenario.materials.len() == 1
            && scenario.regions.iter().all(|region| region.ball.is_none());
        if !even {
            return None;
        }
        let units = &self.units;
        let stretches = scenario.regions.iter().filter_map(|region| {
            let (lower, upper) = (region.extent.lower[0], region.extent.upper[0]);
            let inside = |p: &&Placed| (lower..upper).contains(&p.position[0]);
            let count = placed.iter().filter(inside).count();
            let first = placed.iter().find(inside)?;
            let mass = region.density * (upper - lower) / count as f64;
            Some(Stretch {
                lower: (lower - self.middle[0]) / units.length,
                upper: (upper - self.middle[0]) / units.length,
                particles: count as u32,
                mass: mass / units.mass,
                velocity: region.velocity[0] / units.velocity,
                energy: first.energy / units.energy(),
            })
        });
        Some(stretches.collect())
    }

    /// The particles of stretches, as a device makes them.
    fn of_stretches(&self, stretches: &[Stretch]) -> Vec<Particle<f64, 3>> {
        let eta = self.eta();
        let particles = stretches.iter().flat_map(|stretch| stretch.particles(eta));
        particles
            .map(|particle| Particle {
                position: [particle.position[0], 0.0, 0.0],
                velocity: [particle.velocity[0], 0.0, 0.0],
                mass: particle.mass,
                energy: particle.energy,
                epsilon: particle.epsilon,
                material: particle.material,
            })
            .collect()
    }
}
