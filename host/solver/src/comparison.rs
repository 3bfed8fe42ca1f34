//! Errors of a run against an exact solution.

use std::collections::BTreeMap;

use crate::exact::flow::{Flow, FlowError, FlowState};
use crate::exact::riemann::{GasState, RiemannError, RiemannFlow, RiemannProblem, RiemannSolution};
use crate::exact::sedov::SedovProblem;
use crate::flows::{profile_flow, reference};
use crate::scenario::{EquationOfState, Exact, Extent, Norm, Region, Ring, Scenario, Side};
use crate::simulation::ParticleRow;

/// Norms of the error of one field over a window.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Norms {
    /// `Σ V_k |err_k| / Σ V_k`, `V_k = m_k/ρ_k`.
    pub l1: f64,
    /// `(Σ V_k err_k² / Σ V_k)^(1/2)`.
    pub l2: f64,
    /// `max_k |err_k|`.
    pub linf: f64,
    /// `Σ |err_k| / n`: every particle counts the same.
    pub mean: f64,
    /// `(Σ err_k² / n)^(1/2)`: likewise.
    pub rms: f64,
}

impl Norms {
    /// One of them.
    pub fn of(&self, norm: Norm) -> f64 {
        match norm {
            Norm::L1 => self.l1,
            Norm::L2 => self.l2,
            Norm::Linf => self.linf,
            Norm::Mean => self.mean,
            Norm::Rms => self.rms,
        }
    }
}

/// The sums that [`Norms`] are made of.
#[derive(Clone, Copy, Debug, Default)]
pub struct NormSums {
    volume: f64,
    count: f64,
    l1: f64,
    l2: f64,
    linf: f64,
    mean: f64,
    squares: f64,
}

impl NormSums {
    /// Adds the error of a particle.
    pub fn add(&mut self, volume: f64, error: f64) {
        let size = error.abs();
        self.volume += volume;
        self.count += 1.0;
        self.l1 += volume * size;
        self.l2 += volume * size * size;
        self.linf = self.linf.max(size);
        self.mean += size;
        self.squares += size * size;
    }

    /// The norms; `None` without particles.
    pub fn norms(&self) -> Option<Norms> {
        (self.volume > 0.0).then(|| Norms {
            l1: self.l1 / self.volume,
            l2: (self.l2 / self.volume).sqrt(),
            linf: self.linf,
            mean: self.mean / self.count,
            rms: (self.squares / self.count).sqrt(),
        })
    }
}

/// The fields that are compared, in the order of tables and pictures. The error of the
/// velocity is the length of the difference of the two vectors.
pub const FIELDS: [&str; 4] = ["density", "velocity", "pressure", "energy"];

/// The exact solution of a scenario.
pub struct ExactSolution {
    flow: Box<dyn Flow>,
    riemann: Option<(RiemannSolution, f64)>,
    dimension: usize,
}

/// Why a scenario has no exact solution after all.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum ExactError {
    /// Of the Riemann problem.
    #[error("the exact solution does not exist: {0}")]
    Riemann(#[from] RiemannError),
    /// Of another flow.
    #[error("the exact solution does not exist: {0}")]
    Flow(#[from] FlowError),
}

impl ExactSolution {
    /// The one that the scenario names, if it names one.
    ///
    /// # Errors
    /// Data that the exact solution does not exist for.
    pub fn of(scenario: &Scenario) -> Result<Option<Self>, ExactError> {
        let dimension = scenario.dimension;
        let of = |flow, riemann| {
            Some(Self {
                flow,
                riemann,
                dimension,
            })
        };
        Ok(match scenario.output.exact {
            None => None,
            Some(Exact::Profile) => profile_flow(scenario)?.and_then(|flow| of(flow, None)),
            Some(Exact::Riemann) => {
                let (solution, interface, normal) = riemann(scenario, false)?;
                let flow = RiemannFlow::new(solution, interface, normal)?;
                of(Box::new(flow), Some((solution, interface)))
            }
            Some(Exact::Sedov) => of(Box::new(sedov(scenario)?), None),
            Some(Exact::Reference) => of(Box::new(reference(scenario)?), None),
        })
    }

    /// Where the waves begin and end at a time, along the direction of a Riemann problem: the
    /// solution is smooth between them. Empty for other solutions.
    pub fn edges(&self, time: f64) -> Vec<f64> {
        let Some((solution, interface)) = &self.riemann else {
            return Vec::new();
        };
        let contact = solution.star().map(|star| star.velocity);
        let waves = [solution.left_wave(), solution.right_wave()];
        let speeds = waves.as_flattened().iter().copied().chain(contact);
        let mut edges: Vec<f64> = speeds.map(|speed| interface + speed * time).collect();
        edges.dedup();
        edges
    }

    /// Place and pressure of the contact of a Riemann problem at a time.
    pub fn contact(&self, time: f64) -> Option<(f64, f64)> {
        let (solution, interface) = self.riemann.as_ref()?;
        let star = solution.star()?;
        Some((interface + star.velocity * time, star.pressure))
    }

    /// Why the comparison may not mean what it says: the solution is that of two gases that
    /// fill all of space, and the ends of the domain can be felt in the window.
    pub fn doubt(&self, scenario: &Scenario) -> Option<String> {
        self.riemann.as_ref()?;
        let direction = scenario.riemann_direction()?;
        let (extent, window) = (&scenario.domain.extent, &scenario.output.window);
        let time = scenario.time.end;
        let edges = self.edges(time);
        let first = edges.iter().copied().fold(f64::INFINITY, f64::min);
        let last = edges.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if first < extent.lower[direction] || last > extent.upper[direction] {
            return Some("the waves have reached the ends of the domain".to_owned());
        }
        // What an end sends out travels at most with the speed of its gas and of sound.
        for (end, side) in scenario.domain.sides[direction].iter().enumerate() {
            let place = [extent.lower[direction], extent.upper[direction]][end];
            let touches = |region: &&Region| {
                [
                    region.extent.lower[direction],
                    region.extent.upper[direction],
                ][end]
                    == place
            };
            let region = scenario.regions.iter().find(touches);
            let Some(region) = region else {
                return Some(format!("the gas does not reach the {} end", ENDS[end]));
            };
            let sound = |region: &Region| {
                let law = &scenario.materials[region.material].law;
                let energy = law.energy(region.density, region.pressure);
                law.sound_speed_squared(region.density, energy).sqrt()
            };
            let inward = [1.0, -1.0][end] * region.velocity[direction];
            let speed = match side {
                Side::Mirror if inward == 0.0 => 0.0,
                // The two gases meet once more, the other way round.
                Side::Periodic => match riemann(scenario, true) {
                    Ok((beyond, ..)) => [beyond.right_wave()[1], -beyond.left_wave()[0]][end],
                    Err(_) => f64::INFINITY,
                },
                // Into a vacuum the gas runs out, and what it feels of that runs in with sound.
                Side::Free => inward + sound(region),
                _ => scenario
                    .regions
                    .iter()
                    .map(|region| region.velocity[direction].abs() + 3.0 * sound(region))
                    .fold(0.0, f64::max),
            };
            let distance = [
                window.lower[direction] - place,
                place - window.upper[direction],
            ][end];
            if distance < speed * time {
                return Some(format!(
                    "the {} end of the domain may be felt in the window",
                    ENDS[end]
                ));
            }
        }
        None
    }

    /// The solution at a point and a time, > 0.
    pub fn at(&self, position: [f64; 3], time: f64) -> FlowState {
        self.flow.at(position, time)
    }

    /// The same as a row of a table: density, the components of the velocity, pressure and
    /// internal energy.
    pub fn row(&self, position: [f64; 3], time: f64) -> Vec<f64> {
        let state = self.at(position, time);
        let mut row = vec![state.density];
        row.extend(&state.velocity[..self.dimension]);
        row.extend([state.pressure, state.energy]);
        row
    }

    /// The errors of a particle, in the order of [`FIELDS`].
    fn errors(&self, particle: &ParticleRow, time: f64) -> [f64; 4] {
        let exact = self.at(particle.position, time);
        let difference = particle.velocity.iter().zip(exact.velocity);
        let squares: f64 = difference.map(|(a, b)| (a - b) * (a - b)).sum();
        [
            (particle.density - exact.density).abs(),
            squares.sqrt(),
            (particle.pressure - exact.pressure).abs(),
            (particle.energy - exact.energy).abs(),
        ]
    }
}

/// What the ends of a direction are called.
const ENDS: [&str; 2] = ["lower", "upper"];

/// The solution of a scenario's Riemann problem, where its two regions meet, and across which
/// direction; `swapped`: with the gases on each other's side.
fn riemann(
    scenario: &Scenario,
    swapped: bool,
) -> Result<(RiemannSolution, f64, [f64; 3]), RiemannError> {
    let direction = scenario.riemann_direction().unwrap_or(0);
    let mut sides: Vec<_> = scenario.regions.iter().collect();
    let place = |region: &Region| region.extent.lower[direction];
    sides.sort_by(|a, b| place(a).total_cmp(&place(b)));
    let interface = place(sides[1]);
    if swapped {
        sides.reverse();
    }
    let state = |i: usize| GasState {
        density: sides[i].density,
        velocity: sides[i].velocity[direction],
        pressure: sides[i].pressure,
    };
    let law = |i: usize| match scenario.materials[sides[i].material].law {
        EquationOfState::IdealGas { gamma } => (gamma, 0.0),
        EquationOfState::StiffenedGas {
            gamma,
            pressure_at_infinity,
        } => (gamma, pressure_at_infinity),
        // The scenario has been checked: no other has an exact solution.
        _ => (f64::NAN, f64::NAN),
    };
    let problem = RiemannProblem {
        left: state(0),
        right: state(1),
        left_gamma: law(0).0,
        right_gamma: law(1).0,
        left_pressure_at_infinity: law(0).1,
        right_pressure_at_infinity: law(1).1,
    };
    let mut normal = [0.0; 3];
    normal[direction] = 1.0;
    Ok((problem.solve()?, interface, normal))
}

/// The blast wave of a scenario's deposit.
fn sedov(scenario: &Scenario) -> Result<impl Flow + use<>, FlowError> {
    let EquationOfState::IdealGas { gamma } = scenario.materials[0].law else {
        return Err(FlowError::OutOfRange {
            quantity: "gamma",
            value: f64::NAN,
            need: "an ideal gas",
        });
    };
    SedovProblem {
        dimension: scenario.dimension,
        gamma,
        density: scenario.regions[0].density,
        energy: scenario.deposits[0].energy,
        pressure: scenario.regions[0].pressure,
    }
    .solve()
}

/// The particles in a window and, where there is one, a ring.
pub fn within<'p>(
    particles: &'p [ParticleRow],
    window: &Extent,
    ring: Option<&Ring>,
) -> impl Iterator<Item = &'p ParticleRow> {
    particles.iter().filter(move |particle| {
        let bounds = window.lower.iter().zip(&window.upper);
        let in_box = bounds
            .zip(&particle.position)
            .all(|((lower, upper), x)| (*lower..=*upper).contains(x));
        in_box
            && ring.is_none_or(|ring| {
                let from = ring.center.iter().zip(&particle.position);
                let squares: f64 = from.map(|(c, x)| (x - c) * (x - c)).sum();
                (ring.inner..=ring.outer).contains(&squares.sqrt())
            })
    })
}

/// The norms of every field over the particles in the window; `None` if there are none.
pub fn norms(
    exact: &ExactSolution,
    particles: &[ParticleRow],
    time: f64,
    scenario: &Scenario,
) -> Option<BTreeMap<&'static str, Norms>> {
    let (window, ring) = (&scenario.output.window, scenario.output.ring.as_ref());
    let mut sums = [NormSums::default(); 4];
    for particle in within(particles, window, ring) {
        let volume = particle.mass / particle.density;
        for (sums, error) in sums.iter_mut().zip(exact.errors(particle, time)) {
            sums.add(volume, error);
        }
    }
    let norms = sums.map(|sums| sums.norms());
    let fields = FIELDS.into_iter().zip(norms);
    fields.map(|(field, norms)| Some((field, norms?))).collect()
}
