//! How fast the gas solver is: a jittered lattice in a periodic box, adaptive ε, M4 and the
//! default viscosity, all chosen by name as in `motes run`.

use std::time::Instant;

use motes_core::cutoff::Named as NamedCutOff;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{Coefficients, Named as NamedViscosity, Pairwise};
use motes_core::equation::gas::{GasDynamics, Options, Particle, Plain, Width};
use motes_core::error::Error;
use motes_core::material::{IdealGas, Named as NamedMaterial};

use crate::engine::{HostScalar, Threads, ThreadsError};
use crate::families::gas::GasArrays;

/// A box of `per_side^dimension` particles.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Its name.
    pub name: &'static str,
    /// Dimension of space.
    pub dimension: usize,
    /// Particles along each direction.
    pub per_side: usize,
    /// Width of the cut-off in spacings.
    pub eta: f64,
}

/// The cases, with about 4, 15 and 48 neighbours.
pub const CASES: [Case; 3] = [
    Case {
        name: "1d",
        dimension: 1,
        per_side: 200_000,
        eta: 1.07,
    },
    Case {
        name: "2d",
        dimension: 2,
        per_side: 512,
        eta: 1.10,
    },
    Case {
        name: "3d",
        dimension: 3,
        per_side: 64,
        eta: 1.13,
    },
];

/// What was measured.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Speed {
    /// Name of the case.
    pub case: &'static str,
    /// Dimension of space.
    pub dimension: usize,
    /// Name of the scalar.
    pub scalar: String,
    /// Number of threads.
    pub threads: usize,
    /// Number of particles.
    pub particles: usize,
    /// Mean neighbour count.
    pub neighbours: f64,
    /// Particles times steps over seconds, the fastest of several steps.
    pub updates_per_second: f64,
    /// The instruction set of the inner loops.
    pub instruction_set: &'static str,
}

/// A measurement that cannot be made.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum BenchmarkError {
    /// Not a scalar of the benchmark.
    #[error("`{name}` is not measured")]
    #[diagnostic(help("measured are f32 and f64"))]
    Scalar {
        /// Its name.
        name: String,
    },
    /// No threads.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Threads(#[from] ThreadsError),
    /// The solver stopped.
    #[error("the solver stopped: {0}")]
    Solver(Error),
}

/// Measures one case.
///
/// # Errors
/// A scalar that is not measured, threads that do not start.
pub fn measure(case: Case, scalar: &str, threads: usize) -> Result<Speed, BenchmarkError> {
    let mut engine = Threads::new(threads)?;
    let (neighbours, updates_per_second) = match (scalar, case.dimension) {
        ("f32", 1) => steps::<f32, 1>(case, &mut engine),
        ("f32", 2) => steps::<f32, 2>(case, &mut engine),
        ("f32", _) => steps::<f32, 3>(case, &mut engine),
        ("f64", 1) => steps::<f64, 1>(case, &mut engine),
        ("f64", 2) => steps::<f64, 2>(case, &mut engine),
        ("f64", _) => steps::<f64, 3>(case, &mut engine),
        _ => {
            return Err(BenchmarkError::Scalar {
                name: scalar.to_owned(),
            });
        }
    }
    .map_err(BenchmarkError::Solver)?;
    Ok(Speed {
        case: case.name,
        dimension: case.dimension,
        scalar: scalar.to_owned(),
        threads: engine.threads(),
        particles: case.per_side.pow(case.dimension as u32),
        neighbours,
        updates_per_second,
        instruction_set: engine.instruction_set().name(),
    })
}

/// Neighbours and updates a second. The first steps settle ε and warm the caches; of the
/// others the median counts: the machine may have other work.
fn steps<S: HostScalar, const D: usize>(
    case: Case,
    engine: &mut Threads,
) -> Result<(f64, f64), Error> {
    let solver = GasDynamics {
        domain: Domain {
            axes: [Axis::periodic(S::ZERO, S::from_f64(case.per_side as f64)); D],
        },
        cut_off: NamedCutOff::CubicSpline,
        width: Width::Adaptive {
            eta: S::from_f64(case.eta),
        },
        viscosity: NamedViscosity::Pairwise(Pairwise(Coefficients {
            alpha: S::ONE,
            beta: S::from_f64(2.0),
        })),
        materials: &[NamedMaterial::IdealGas(IdealGas::new(1.4))],
        physics: Plain::DEFAULT,
        courant: S::from_f64(0.3),
        smallest_omega: S::from_f64(1.0 / 32.0),
    };
    let mut arrays = GasArrays::new(jittered::<S, D>(case), &Options::OFF);
    let (mut gas, mut work) = arrays.parts();
    solver.prepare(engine, &mut gas, &mut work)?;
    let mut seconds = Vec::new();
    for step in 0..14 {
        let started = Instant::now();
        let dt = solver.time_step(&gas, S::ONE)?;
        solver.advance(engine, &mut gas, &mut work, dt)?;
        if step >= 3 {
            seconds.push(started.elapsed().as_secs_f64());
        }
    }
    seconds.sort_by(f64::total_cmp);
    let neighbours: f64 = gas.neighbours.iter().map(|count| count.to_f64()).sum();
    let n = gas.len() as f64;
    Ok((neighbours / n, n / seconds[seconds.len() / 2]))
}

/// A lattice of spacing 1, every particle up to 0.1 off its place, with small velocities.
pub fn jittered<S: HostScalar, const D: usize>(case: Case) -> Vec<Particle<S, D>> {
    let mut seed = 1u64;
    let mut noise = move || {
        // Marsaglia's xorshift: reproducible, and good enough for a jitter.
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut particle = |i: usize| {
        let mut rest = i;
        let mut position = [S::ZERO; D];
        for x in position.iter_mut().rev() {
            *x = S::from_f64((rest % case.per_side) as f64 + 0.5 + 0.2 * noise());
            rest /= case.per_side;
        }
        Particle {
            position,
            velocity: std::array::from_fn(|_| S::from_f64(0.1 * noise())),
            mass: S::ONE,
            energy: S::from_f64(1.8),
            epsilon: S::from_f64(case.eta),
            material: 0,
        }
    };
    (0..case.per_side.pow(D as u32))
        .map(&mut particle)
        .collect()
}
