//! The exact solution of a gas.

use crate::exact::flow::{Flow, FlowError, FlowState};
use crate::exact::riemann::{GasState, RiemannError, RiemannFlow, RiemannSolution, between};
use crate::exact::sedov::SedovProblem;
use crate::exact::solution::Solution;
use crate::flows::{channel_flow, formula_flow, profile_flow, reference, start};
use crate::scenario::{EquationOfState, Exact, Piece, Region, Scenario, Side};

/// The fields that a solution has, in the order of tables and pictures.
pub const FIELDS: [&str; 4] = ["density", "velocity", "pressure", "energy"];

/// The exact solution of a scenario.
pub struct ExactSolution {
    flow: Box<dyn Flow>,
    riemann: Option<(RiemannSolution, f64)>,
    dimension: usize,
    doubt: Option<String>,
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
        Self::watched(scenario, &mut |_| ())
    }

    /// The same; `progress` hears the part that is done of what takes long.
    ///
    /// # Errors
    /// Data that the exact solution does not exist for.
    pub fn watched(
        scenario: &Scenario,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Option<Self>, ExactError> {
        let dimension = scenario.dimension;
        let of = |flow, riemann| {
            Some(Self {
                flow,
                riemann,
                dimension,
                doubt: None,
            })
        };
        let mut solution: Option<Self> = match scenario.output.exact {
            None => None,
            Some(Exact::Profile) => profile_flow(scenario)?.and_then(|flow| of(flow, None)),
            Some(Exact::Riemann) => {
                let (solution, interface, normal) = riemann(scenario, false)?;
                let flow = RiemannFlow::new(solution, interface, normal)?;
                of(Box::new(flow), Some((solution, interface)))
            }
            Some(Exact::Sedov) => of(Box::new(sedov(scenario)?), None),
            Some(Exact::Reference) => of(Box::new(reference(scenario, progress)?), None),
            Some(Exact::Formula) => {
                let formulas = scenario.output.formulas.as_ref();
                let extent = &scenario.domain.extent;
                let piece = formulas.map(|state| Piece {
                    extent: extent.clone(),
                    state: state.clone(),
                });
                let flow = formula_flow(scenario, piece.into_iter().collect());
                of(Box::new(flow), None)
            }
            Some(Exact::Channel) => match channel_flow(scenario)? {
                Some(flow) => of(Box::new(flow), None),
                None => None,
            },
        };
        if let Some(solution) = &mut solution {
            let why = solution.felt(scenario).or_else(|| reference_felt(scenario));
            solution.doubt = why.map(|why| format!("{why}: the exact solution may not hold there"));
        }
        Ok(solution)
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
    fn felt(&self, scenario: &Scenario) -> Option<String> {
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

    /// The gas at a point and a time, > 0.
    pub fn state(&self, position: [f64; 3], time: f64) -> FlowState {
        self.flow.at(position, time)
    }
}

/// Density, the components of the velocity, pressure and internal energy.
impl Solution for ExactSolution {
    fn components(&self) -> usize {
        3 + self.dimension
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        let gas = self.state(position, time);
        let (density, rest) = state.split_at_mut(1);
        let (velocity, rest) = rest.split_at_mut(self.dimension);
        density[0] = gas.density;
        velocity.copy_from_slice(&gas.velocity[..self.dimension]);
        rest.copy_from_slice(&[gas.pressure, gas.energy]);
    }

    fn doubt(&self) -> Option<String> {
        self.doubt.clone()
    }
}

/// Why a finite-volume reference may not be the run's: at a free end gas runs out into nothing, in the
/// reference it goes on as it is.
fn reference_felt(scenario: &Scenario) -> Option<String> {
    if scenario.output.exact != Some(Exact::Reference) {
        return None;
    }
    let start = start(scenario).ok()?;
    let (extent, window) = (&scenario.domain.extent, &scenario.output.window);
    let law = &scenario.materials[0].law;
    for (end, side) in scenario.domain.sides[0].iter().enumerate() {
        if *side != Side::Free {
            continue;
        }
        let place = [extent.lower[0], extent.upper[0]][end];
        let gas = start([place, 0.0, 0.0]);
        let sound = law.sound_speed_squared(gas.density, gas.energy).sqrt();
        let inward = [1.0, -1.0][end] * gas.velocity[0] + sound;
        let distance = [window.lower[0] - place, place - window.upper[0]][end];
        if distance < inward * scenario.time.end {
            return Some(format!(
                "gas runs out at the {} end of the domain, which the reference does not see, and that may \
                 be felt in the window",
                ENDS[end]
            ));
        }
    }
    None
}

/// What the ends of a direction are called.
const ENDS: [&str; 2] = ["lower", "upper"];

/// The solution of a scenario's Riemann problem, where its two regions meet, and across which
/// direction; `swapped`: with the gases on each other's side.
pub(super) fn riemann(
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
    let law = |i: usize| scenario.materials[sides[i].material].law;
    let solution = between((state(0), law(0)), (state(1), law(1)))?;
    let mut normal = [0.0; 3];
    normal[direction] = 1.0;
    Ok((solution, interface, normal))
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
