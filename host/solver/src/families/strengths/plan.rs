//! What the solver needs of a run, in solver units, every number still an `f64`.
//!
//! The mean spacing and the fastest of waves, flows and particles are 1, and the middle of the
//! domain is 0. Values stay what they are.

use motes_core::cloud::Frame;
use motes_core::cutoff::Named;
use motes_core::domain::{Axis, Domain, Side};
use motes_core::equation::linear::Particle;
use motes_core::equation::linear::systems::Units;
use motes_core::integrator::{RK4, RungeKutta, SSP_RK3};
use motes_core::scalar::Scalar;

use super::budget::Budget;
use super::diffusivity;
use super::doubts::doubts;
use super::field::{PlannedField, RunField};
use super::frame::frame;
use super::jumps;
use super::layers;
use super::particles::{Particles, particle};
use super::quadrature::Quadrature;
use super::sizes::Sizes;
use super::waves::WaveBounds;
use crate::exact::linear::error::SolutionError;
use crate::exact::solution::Solution;
use crate::families::PlanError;
use crate::run::{RunError, check_memory, check_numbers};
use crate::scenario::formula::Formula;
use crate::scenario::linear::{Field, LinearScenario, Method, System};
use crate::scenario::{self, Extent, Width};
use crate::symmetriser::Symmetriser;

/// A run of a linear system in solver units. Vectors have three components; those beyond the
/// dimension mean nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// What the solver units are, in the scenario's.
    pub units: Units,
    /// The middle of the domain, in the scenario's units: 0 for the solver.
    pub middle: [f64; 3],
    /// The domain in the scenario's units.
    pub extent: Extent,
    /// The domain.
    pub axes: [Axis<f64>; 3],
    /// What the components are called.
    pub names: Vec<String>,
    /// `x_k` at the start.
    pub positions: Vec<[f64; 3]>,
    /// `w_k` at the start.
    pub weights: Vec<f64>,
    /// `u_k` at the start, one after the other.
    pub values: Vec<f64>,
    /// The equations, in the scenario's units.
    pub system: System,
    /// `f(x,t)` beside that of the system, in the scenario's units.
    pub source: Option<Vec<Formula>>,
    /// The symmetriser, where the equations are given as matrices.
    pub symmetriser: Option<Symmetriser>,
    /// The waves, where the matrices are formulas.
    pub(in crate::families) waves: Option<WaveBounds>,
    /// How large velocities and sources of formulas become, in the scenario's units.
    sizes: Sizes,
    /// What the particles follow.
    pub(in crate::families) field: PlannedField,
    /// The speed of the fastest of them at the start.
    pub(super) fastest: f64,
    /// The cut-off.
    pub cut_off: Named,
    /// Its width.
    pub epsilon: f64,
    /// The time integrator.
    pub method: Method,
    /// For how many stages a step of the stabilised method is made.
    pub stages: u32,
    /// Factor of the stable time step.
    pub courant: f64,
    /// The time step, if it is given.
    pub step: Option<f64>,
    /// Duration.
    pub end: f64,
    /// The part by which the energy norm may exceed its bound.
    pub growth_margin: f64,
    /// Duration in the scenario's units.
    pub duration: f64,
    /// A power of two of the size of the largest value at the start; 1 where all are 0.
    pub amplitude: f64,
    /// Whether neighbours are counted after every step: snapshots show them.
    pub counts_always: bool,
    /// What becomes of the sums of the strengths.
    pub(in crate::families) budget: Budget,
    /// Why the results may not mean what they say.
    pub doubts: Vec<String>,
}

impl Plan {
    /// The plan of a scenario whose state at t = 0 is that of a solution, if it has one.
    ///
    /// # Errors
    /// Particles that cannot be made, an initial state that does not exist, matrices of a system
    /// that is not symmetrisable.
    pub(in crate::families) fn new(
        scenario: &LinearScenario,
        start: impl FnOnce() -> Result<Option<Box<dyn Solution>>, SolutionError>,
    ) -> Result<Self, PlanError> {
        let dimension = scenario.dimension;
        let components = scenario.system.components(dimension);
        // Before the particles are made: 3 vectors and, with registers, 12 values each at the least.
        check_memory(scenario.resolution.particles, 200 + 100 * components)?;
        let quadrature = Quadrature::of(scenario)?;
        let count = quadrature.shares.len();
        let values = match (start()?, quadrature.values) {
            (Some(solution), _) => {
                let mut values = vec![0.0; count * solution.components()];
                let rows = values.chunks_exact_mut(solution.components());
                for (row, &position) in rows.zip(&quadrature.positions) {
                    solution.write(position, 0.0, row);
                }
                values
            }
            (None, values) => values.unwrap_or_default(),
        };
        check_start(scenario, &values, &quadrature.positions)?;
        if let System::ConvectionDiffusion(of) = &scenario.system {
            diffusivity::check(of, &scenario.domain.extent, scenario.time.end)?;
        }
        let amplitude = amplitude(&values);
        let symmetriser = match &scenario.system {
            System::Matrices { flux, .. } => Some(Symmetriser::of(flux)?),
            _ => None,
        };
        let extent = &scenario.domain.extent;
        let waves = WaveBounds::of(&scenario.system, extent, scenario.time.end)?;
        let volume: f64 = scenario.domain.extent.volume();
        let spacing = libm::pow(volume / count as f64, 1.0 / dimension as f64);
        let units = Units {
            length: spacing,
            velocity: velocity(
                scenario,
                symmetriser
                    .as_ref()
                    .map(|of| of.speed)
                    .or(waves.map(|of| of.speed)),
                &quadrature.positions,
                spacing,
            ),
        };
        let time = units.length / units.velocity;
        let middle = std::array::from_fn(|i| scenario.domain.extent.middle(i));
        let lengths = lengths(scenario, spacing);
        let solver_place = |x: &[f64; 3]| std::array::from_fn(|i| x[i] * lengths[i]);
        let epsilon = match scenario.cut_off.width {
            Width::Adaptive { .. } => {
                let fineness = scenario::fineness(count, dimension);
                scenario.cut_off.width.spacings(fineness)
            }
            Width::Constant { epsilon } => epsilon / spacing,
        };
        let mut plan = Self {
            dimension,
            units,
            middle,
            extent: scenario.domain.extent.clone(),
            axes: std::array::from_fn(|i| axis(scenario, i, lengths[i])),
            names: scenario.system.names(dimension),
            positions: quadrature.places.iter().map(solver_place).collect(),
            values,
            system: scenario.system.clone(),
            source: scenario.source.clone(),
            symmetriser,
            waves,
            sizes: Sizes::of(scenario)?,
            field: PlannedField::new(
                &scenario.motion,
                &scenario.domain.extent,
                units,
                scenario.time.end,
            ),
            fastest: fastest(scenario, &scenario.motion, &quadrature.positions) / units.velocity,
            cut_off: scenario.cut_off.shape,
            epsilon,
            method: scenario.time.method,
            stages: scenario.time.stages as u32,
            courant: scenario.time.courant,
            step: scenario.time.step.map(|step| step / time),
            end: scenario.time.end / time,
            duration: scenario.time.end,
            amplitude,
            counts_always: scenario.output.snapshots.is_some(),
            growth_margin: scenario.time.growth_margin,
            budget: Budget::of(scenario),
            doubts: doubts(
                scenario,
                spacing,
                (epsilon, &lengths[..dimension]),
                &quadrature.shares,
            ),
            weights: quadrature.shares,
        };
        plan.doubts.extend(quadrature.doubts);
        plan.doubts.extend(jumps::doubts(scenario, spacing));
        plan.doubts.extend(layers::check(scenario, plan.width())?);
        Ok(plan)
    }

    /// The way from places of the solver to those of the scenario's formulas.
    pub fn frame(&self) -> Frame {
        frame(&self.extent, self.units)
    }

    /// ε in the scenario's unit of length.
    pub fn width(&self) -> f64 {
        self.epsilon * self.units.length
    }

    /// The unit of time in the scenario's units.
    pub fn unit_of_time(&self) -> f64 {
        self.units.length / self.units.velocity
    }

    /// The unit of weight, a volume, in the scenario's units.
    pub fn unit_of_volume(&self) -> f64 {
        self.units.length.powi(self.dimension as i32)
    }

    /// What the particles follow, in solver units.
    pub fn motion<S: Scalar, const D: usize>(&self) -> RunField<S, D> {
        self.field.run()
    }

    /// Its Runge-Kutta method; the classical one where it has none.
    pub fn runge_kutta(&self) -> RungeKutta {
        match self.method {
            Method::SspRk3 => SSP_RK3,
            Method::Rk4 | Method::Rkl2 => RK4,
        }
    }

    /// The domain, in the scalar and dimension of the run.
    pub(in crate::families) fn domain<S: Scalar, const D: usize>(&self) -> Domain<S, D> {
        Domain {
            axes: std::array::from_fn(|i| Axis {
                lower: S::from_f64(self.axes[i].lower),
                upper: S::from_f64(self.axes[i].upper),
                sides: self.axes[i].sides,
            }),
        }
    }

    /// The particles; the plan has none then.
    pub(super) fn take_particles(&mut self) -> Particles {
        Particles {
            positions: std::mem::take(&mut self.positions),
            weights: std::mem::take(&mut self.weights),
            values: std::mem::take(&mut self.values),
            components: self.names.len(),
        }
    }

    /// The particles, in the scalar and dimension of the run, with zeros for components beyond
    /// those of the plan.
    pub fn particles<S: Scalar, const D: usize, const P: usize>(
        &self,
    ) -> impl Iterator<Item = Particle<S, D, P>> {
        let values = self.values.chunks_exact(self.names.len());
        let places = self.positions.iter().zip(&self.weights);
        places.zip(values).map(|((&x, &w), u)| particle(x, w, u))
    }

    /// Refuses numbers that the format cannot hold to 1 %.
    pub(super) fn check_format<S: Scalar>(&self, scalar: &str) -> Result<(), RunError> {
        let largest = |values: &[f64]| values.iter().map(|u| u.abs()).fold(0.0, f64::max);
        let mut numbers = vec![
            ("epsilon", self.epsilon),
            ("the duration", self.end),
            ("courant", self.courant),
            ("the number of particles", self.weights.len() as f64),
            ("a weight", largest(&self.weights)),
            ("a value", largest(&self.values)),
            ("what drives a wall", self.largest_drive()),
        ];
        if self.source.is_some() {
            numbers.push(("a source", self.sizes.source * self.unit_of_time()));
        }
        if self.sizes.velocity > 0.0 {
            numbers.push(("a velocity", self.sizes.velocity / self.units.velocity));
        }
        if let Some(waves) = self.waves {
            numbers.push(("a wave speed", waves.speed / self.units.velocity));
            numbers.push(("the decay", waves.damping * self.unit_of_time()));
        }
        numbers.extend(self.step.map(|step| ("the time step", step)));
        for axis in &self.axes[..self.dimension] {
            numbers.push(("the length of the domain", axis.upper - axis.lower));
        }
        check_numbers::<S>(&numbers, scalar)
    }
}

/// Refuses values at the start that are no numbers.
fn check_start(
    scenario: &LinearScenario,
    values: &[f64],
    positions: &[[f64; 3]],
) -> Result<(), PlanError> {
    let Some(place) = values.iter().position(|value| !value.is_finite()) else {
        return Ok(());
    };
    let names = scenario.system.names(scenario.dimension);
    let position = positions[place / names.len()];
    Err(PlanError::Start {
        component: names[place % names.len()].clone(),
        value: values[place],
        position: position[..scenario.dimension].to_vec(),
    })
}

/// The most units of time that diffusion is given.
const LONGEST: f64 = 1024.0;

/// The power of two below the largest of some values; 1 where all are 0.
fn amplitude(values: &[f64]) -> f64 {
    let largest = values.iter().map(|u| u.abs()).fold(0.0, f64::max);
    if largest > 0.0 {
        libm::exp2(libm::floor(libm::log2(largest)))
    } else {
        1.0
    }
}

/// The lengths of the domain in spacings; 1 beyond its dimension.
///
/// Rounded to 40 bits: what a unit of length does to the last bits of a quotient is gone then, and
/// the state at t = 0 has the same bits in every unit.
fn lengths(scenario: &LinearScenario, spacing: f64) -> [f64; 3] {
    let extent = &scenario.domain.extent;
    let sides = |i: usize| extent.lower.get(i).zip(extent.upper.get(i));
    std::array::from_fn(|i| match sides(i) {
        Some((lower, upper)) => {
            let length = (upper - lower) / spacing;
            let grid = libm::exp2(libm::floor(libm::log2(length)) - 40.0);
            libm::round(length / grid) * grid
        }
        None => 1.0,
    })
}

/// One direction of the domain.
fn axis(scenario: &LinearScenario, i: usize, length: f64) -> Axis<f64> {
    let Some(sides) = scenario.domain.sides.get(i) else {
        return Axis::FREE;
    };
    let half = 0.5 * length;
    Axis {
        lower: -half,
        upper: half,
        sides: sides.map(|side| match side {
            scenario::Side::Periodic => Side::Periodic,
            scenario::Side::Mirror => Side::Mirror,
            _ => Side::Free,
        }),
    }
}

/// The largest speed of a field at some places, in the scenario's units.
fn fastest(scenario: &LinearScenario, field: &Field, positions: &[[f64; 3]]) -> f64 {
    let extent = &scenario.domain.extent;
    PlannedField::new(field, extent, Units::ONE, 0.0).fastest(positions)
}

/// The fastest of waves, flows and particles at the start; 1 where nothing moves.
fn velocity(
    scenario: &LinearScenario,
    of_matrices: Option<f64>,
    positions: &[[f64; 3]],
    spacing: f64,
) -> f64 {
    let waves = scenario.system.wave_speed();
    let waves = of_matrices.unwrap_or(waves);
    let flow = match &scenario.system {
        System::Transport { velocity, .. } => Some(velocity),
        _ => None,
    };
    let of_field = |field: &Field| fastest(scenario, field, positions);
    let flow = flow.map_or(0.0, of_field);
    let fastest = waves.max(flow).max(of_field(&scenario.motion));
    let fastest = match &scenario.system {
        System::ConvectionDiffusion(problem) => {
            let largest = diffusivity::largest(problem, &scenario.domain.extent);
            let conducted = largest / spacing;
            // Diffusion over many spacings takes many times spacing^2/b: no format need count them.
            fastest
                .max(conducted)
                .min(LONGEST * spacing / scenario.time.end)
        }
        _ => fastest,
    };
    if fastest > 0.0 { fastest } else { 1.0 }
}
