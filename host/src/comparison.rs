//! Errors of a run against an exact solution.

use std::collections::BTreeMap;

use crate::exact::riemann::{GasState, RiemannError, RiemannProblem, RiemannSolution};
use crate::scenario::{Exact, Extent, Material, Region, Scenario, Side};
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
}

/// The fields that are compared, in the order of tables and pictures.
pub const FIELDS: [&str; 4] = ["density", "velocity", "pressure", "energy"];

/// The exact solution at a point, field by field in the order of [`FIELDS`].
pub type FieldValues = [f64; 4];

/// The exact solution of a scenario.
pub struct ExactSolution {
    solution: RiemannSolution,
    interface: f64,
}

impl ExactSolution {
    /// The one that the scenario names, if it names one.
    ///
    /// # Errors
    /// Data that the exact solution does not exist for.
    pub fn of(scenario: &Scenario) -> Result<Option<Self>, RiemannError> {
        let Some(Exact::Riemann) = scenario.output.exact else {
            return Ok(None);
        };
        let Material::IdealGas { gamma } = scenario.material;
        let mut sides: Vec<_> = scenario.regions.iter().collect();
        sides.sort_by(|a, b| a.extent.lower[0].total_cmp(&b.extent.lower[0]));
        let state = |i: usize| GasState {
            density: sides[i].density,
            velocity: sides[i].velocity[0],
            pressure: sides[i].pressure,
        };
        let problem = RiemannProblem {
            left: state(0),
            right: state(1),
            left_gamma: gamma,
            right_gamma: gamma,
            left_pressure_at_infinity: 0.0,
            right_pressure_at_infinity: 0.0,
        };
        let interface = sides[1].extent.lower[0];
        Ok(Some(Self {
            solution: problem.solve()?,
            interface,
        }))
    }

    /// Where the waves begin and end at a time: the solution is smooth between them.
    pub fn edges(&self, time: f64) -> Vec<f64> {
        let contact = self.solution.star().map(|star| star.velocity);
        let waves = [self.solution.left_wave(), self.solution.right_wave()];
        let speeds = waves.as_flattened().iter().copied().chain(contact);
        let mut edges: Vec<f64> = speeds.map(|speed| self.interface + speed * time).collect();
        edges.dedup();
        edges
    }

    /// Why the comparison may not mean what it says: the solution is that of two gases that
    /// fill all of space, and the ends of the domain can be felt in the window.
    pub fn doubt(&self, scenario: &Scenario) -> Option<String> {
        let (extent, window) = (&scenario.domain.extent, &scenario.output.window);
        let time = scenario.time.end;
        let edges = self.edges(time);
        let first = edges.iter().copied().fold(f64::INFINITY, f64::min);
        let last = edges.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if first < extent.lower[0] || last > extent.upper[0] {
            return Some("the waves have reached the ends of the domain".to_owned());
        }
        // What an end sends out travels at most with the speed of its gas and of sound.
        let Material::IdealGas { gamma } = scenario.material;
        for (end, side) in scenario.domain.sides[0].iter().enumerate() {
            let place = [extent.lower[0], extent.upper[0]][end];
            let touches =
                |region: &&Region| [region.extent.lower[0], region.extent.upper[0]][end] == place;
            let region = scenario.regions.iter().find(touches);
            let still = region.is_some_and(|region| region.velocity[0] == 0.0);
            if *side == Side::Mirror && still {
                continue;
            }
            let speed = |region: &Region| {
                region.velocity[0].abs() + 3.0 * (gamma * region.pressure / region.density).sqrt()
            };
            let fastest = scenario.regions.iter().map(speed).fold(0.0, f64::max);
            let distance = [window.lower[0] - place, place - window.upper[0]][end];
            if distance < fastest * time || region.is_none() {
                let name = ["lower", "upper"][end];
                return Some(format!(
                    "the {name} end of the domain may be felt in the window"
                ));
            }
        }
        None
    }

    /// The solution at a point and a time, > 0.
    pub fn at(&self, position: f64, time: f64) -> FieldValues {
        let xi = (position - self.interface) / time;
        let state = self.solution.sample(xi);
        let energy = self.solution.internal_energy(xi);
        [state.density, state.velocity, state.pressure, energy]
    }
}

/// A particle's fields, in the order of [`FIELDS`].
pub fn fields(particle: &ParticleRow) -> FieldValues {
    [
        particle.density,
        particle.velocity,
        particle.pressure,
        particle.energy,
    ]
}

/// The norms of every field over the particles in the window; `None` if there are none.
pub fn norms(
    exact: &ExactSolution,
    particles: &[ParticleRow],
    time: f64,
    window: &Extent,
) -> Option<BTreeMap<&'static str, Norms>> {
    let inside = |p: &&ParticleRow| (window.lower[0]..=window.upper[0]).contains(&p.position);
    let mut sums = [(0.0, 0.0, 0.0f64); 4];
    let mut total = 0.0;
    for particle in particles.iter().filter(inside) {
        let volume = particle.mass / particle.density;
        total += volume;
        let values = fields(particle)
            .into_iter()
            .zip(exact.at(particle.position, time));
        for ((l1, l2, linf), (value, exact)) in sums.iter_mut().zip(values) {
            let error = (value - exact).abs();
            *l1 += volume * error;
            *l2 += volume * error * error;
            *linf = linf.max(error);
        }
    }
    let norms = sums.map(|(l1, l2, linf)| Norms {
        l1: l1 / total,
        l2: (l2 / total).sqrt(),
        linf,
    });
    (total > 0.0).then(|| FIELDS.into_iter().zip(norms).collect())
}
