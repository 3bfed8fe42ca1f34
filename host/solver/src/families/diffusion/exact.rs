//! The state at t = 0 of convection-diffusion, and the solution that belongs to it.

use crate::exact::diffusion::band::BandProblem;
use crate::exact::diffusion::gaussian::GaussianProblem;
use crate::exact::diffusion::legendre::LegendreProblem;
use crate::exact::diffusion::mode::ModeProblem;
use crate::exact::diffusion::modulation::Modulation;
use crate::exact::diffusion::slab::drive::Drive;
use crate::exact::diffusion::slab::{End, Layer, SlabProblem};
use crate::exact::linear::error::SolutionError;
use crate::exact::solution::Solution;
use crate::families::strengths::{flow, length, periods, spread, wave_vector};
use crate::scenario::linear as scenario;
use crate::scenario::linear::{
    Conductor, ConvectionDiffusion, Field, Initial, LinearScenario, Reaction, WallCondition,
};

/// The state at t = 0, which is asked for at no other time: that of a problem in which nothing
/// moves.
///
/// # Errors
/// Numbers for which there is none.
pub(in crate::families) fn start(
    scenario: &LinearScenario,
    of: &ConvectionDiffusion,
    initial: &Initial,
) -> Result<Box<dyn Solution>, SolutionError> {
    let calm = ConvectionDiffusion {
        velocity: Field::Still,
        diffusivity: vec![0.0; of.species.len()],
        modulation: None,
        tensor: None,
        reaction: Reaction::None,
        ..of.clone()
    };
    match initial {
        Initial::Uniform { state } => Ok(Box::new(Uniform(state.clone()))),
        Initial::Spots {
            background,
            spot,
            centers,
            width,
        } => Ok(Box::new(Spots {
            background: background.clone(),
            spot: spot.clone(),
            centers: centers.iter().map(|center| spread(center)).collect(),
            width: *width,
        })),
        _ => moving(scenario, &calm, initial),
    }
}

/// The solution at all times of a state for which the scenario says that there is one.
///
/// # Errors
/// Numbers for which there is none.
pub(in crate::families) fn solution(
    scenario: &LinearScenario,
    of: &ConvectionDiffusion,
    initial: &Initial,
) -> Result<Box<dyn Solution>, SolutionError> {
    match initial {
        Initial::Uniform { state } => slab(scenario, of, state[0]),
        _ => moving(scenario, of, initial),
    }
}

/// The solution from a state that is not the same everywhere.
fn moving(
    scenario: &LinearScenario,
    of: &ConvectionDiffusion,
    initial: &Initial,
) -> Result<Box<dyn Solution>, SolutionError> {
    let species = of.species.len();
    let first = |amplitude: f64| {
        let mut state = vec![0.0; species];
        state[0] = amplitude;
        state
    };
    let modulation = of.modulation.map(|of| Modulation {
        amplitude: of.amplitude,
        rate: of.rate,
    });
    let reaction = match &of.reaction {
        Reaction::Linear { matrix, .. } => matrix.clone(),
        _ => Vec::new(),
    };
    let tensor = of.tensor.as_ref().map(|tensor| full(tensor));
    Ok(match initial {
        Initial::Gaussian {
            center,
            width,
            amplitude,
        } => Box::new(
            GaussianProblem {
                dimension: scenario.dimension,
                field: flow(scenario, &of.velocity),
                center: spread(center),
                width: *width,
                state: first(*amplitude),
                diffusivity: of.diffusivity[0],
                tensor,
                modulation,
                reaction,
                periods: periods(scenario),
            }
            .solve()?,
        ),
        Initial::Modes { wave, state } => Box::new(
            ModeProblem {
                wave_vector: wave_vector(scenario, wave),
                lower: spread(&scenario.domain.extent.lower),
                state: state.clone(),
                diffusivities: of.diffusivity.clone(),
                tensor,
                reaction,
            }
            .solve()?,
        ),
        Initial::Legendre { degree, amplitude } => {
            let (center, radius) = match of.profile {
                Conductor::Parabola { center, radius } => (center, radius),
                _ => (scenario.domain.extent.middle(0), 0.5 * length(scenario, 0)),
            };
            let polynomial = LegendreProblem {
                center,
                radius,
                degree: *degree,
                amplitude: *amplitude,
                diffusivity: of.diffusivity[0],
                modulation,
            };
            among(polynomial.solve()?, species)
        }
        Initial::Band {
            center,
            length,
            width,
            amplitude,
        } => {
            let band = BandProblem {
                center: *center,
                length: *length,
                width: *width,
                amplitude: *amplitude,
                diffusivity: of.diffusivity[0],
                velocity: match &of.velocity {
                    Field::Uniform { velocity } => spread(velocity),
                    _ => [0.0; 3],
                },
                period: periods(scenario)[0],
            };
            among(band.solve()?, species)
        }
        // Of other systems: convection-diffusion has no such state.
        _ => Box::new(Uniform(vec![0.0; species])),
    })
}

/// A tensor with zeros beyond the dimension.
fn full(tensor: &[Vec<f64>]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| tensor.get(i).map_or([0.0; 3], |row| spread(row)))
}

/// A solution of one species as the first of several, the others 0.
fn among(solution: impl Solution + 'static, species: usize) -> Box<dyn Solution> {
    match species {
        1 => Box::new(solution),
        _ => Box::new(First { solution, species }),
    }
}

/// The first of several species.
struct First<F> {
    solution: F,
    species: usize,
}

impl<F: Solution> Solution for First<F> {
    fn components(&self) -> usize {
        self.species
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        state.fill(0.0);
        self.solution.write(position, time, &mut state[..1]);
    }
}

/// The same everywhere.
struct Uniform(Vec<f64>);

impl Solution for Uniform {
    fn components(&self) -> usize {
        self.0.len()
    }

    fn write(&self, _: [f64; 3], _: f64, state: &mut [f64]) {
        state.copy_from_slice(&self.0);
    }
}

/// `background + (spot - background) exp(-|x - c|²/width²)`, c the nearest centre.
struct Spots {
    background: Vec<f64>,
    spot: Vec<f64>,
    centers: Vec<[f64; 3]>,
    width: f64,
}

impl Solution for Spots {
    fn components(&self) -> usize {
        self.background.len()
    }

    fn write(&self, position: [f64; 3], _: f64, state: &mut [f64]) {
        let squared = |center: &[f64; 3]| -> f64 {
            let components = position.iter().zip(center);
            components.map(|(x, c)| (x - c) * (x - c)).sum()
        };
        let nearest = self.centers.iter().map(squared);
        let nearest = nearest.fold(f64::INFINITY, f64::min);
        let part = libm::exp(-nearest / (self.width * self.width));
        let ends = self.background.iter().zip(&self.spot);
        for (u, (background, spot)) in state.iter_mut().zip(ends) {
            *u = background + (spot - background) * part;
        }
    }
}

/// Heat through a slab of layers that is the same everywhere at t = 0.
fn slab(
    scenario: &LinearScenario,
    of: &ConvectionDiffusion,
    initial: f64,
) -> Result<Box<dyn Solution>, SolutionError> {
    let extent = &scenario.domain.extent;
    let (lower, upper) = (extent.lower[0], extent.upper[0]);
    let (bounds, factors) = match &of.profile {
        Conductor::Layers { bounds, factors } => (bounds.as_slice(), factors.as_slice()),
        _ => (&[][..], &[1.0][..]),
    };
    let clipped = |x: &f64| x.clamp(lower, upper);
    let starts = [lower].into_iter().chain(bounds.iter().map(clipped));
    let ends = bounds.iter().map(clipped).chain([upper]);
    let layers = starts.zip(ends).zip(factors);
    let layers = layers.map(|((start, end), factor)| Layer {
        thickness: end - start,
        diffusivity: of.diffusivity[0] * factor,
    });
    let end = |end: usize| {
        let condition = of.walls.first().and_then(|ends| ends[end].first());
        condition.map_or(End::NoFlux, |of| end_of(of, scenario.time.end))
    };
    let problem = SlabProblem {
        lower,
        // Layers beyond the domain have nothing in it.
        layers: layers.filter(|layer| layer.thickness > 0.0).collect(),
        ends: [end(0), end(1)],
        initial,
    };
    Ok(Box::new(problem.solve()?))
}

/// What a slab meets at an end.
fn end_of(condition: &WallCondition, duration: f64) -> End {
    let drive = |drive: &scenario::Drive| match drive {
        // Straight lines between so many points are 1e-7 off a wave that swings once.
        scenario::Drive::Formula(_) => Drive {
            points: drive.sampled(duration, 4096),
        },
        scenario::Drive::Constant(value) => Drive::constant(*value),
        scenario::Drive::Series(series) => {
            let points = series.times.iter().zip(&series.values);
            Drive {
                points: points.map(|(&time, &value)| (time, value)).collect(),
            }
        }
    };
    match condition {
        WallCondition::NoFlux => End::NoFlux,
        // What does not conduct lets nothing through.
        WallCondition::Exchange { rate: 0.0, .. } => End::NoFlux,
        WallCondition::Value(value) => End::Value(drive(value)),
        WallCondition::Flux(flux) => End::Flux(drive(flux)),
        WallCondition::Exchange { rate, outside } => End::Exchange {
            rate: *rate,
            outside: drive(outside),
        },
    }
}
