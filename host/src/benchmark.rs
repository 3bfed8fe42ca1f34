//! How fast the gas solver is: a jittered lattice in a periodic box, adaptive ε, M4 and the
//! default viscosity, all chosen by name as in `motes run`.

use std::time::Instant;

use motes_core::cutoff::Named as NamedCutOff;
use motes_core::domain::Axis;
use motes_core::equation::gas::{Options, Particle, Width};

use crate::engine::{Threads, ThreadsError};
use crate::families::{Plan, gas};
use crate::run::{Abscissa, RunError, ScalarName, start_plan};
use crate::scenario::{EquationOfState, Viscosity, ViscosityKind};
use crate::units::SolverUnits;

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
    Solver(#[from] RunError),
}

/// Measures one case.
///
/// # Errors
/// A scalar that is not measured, threads that do not start.
pub fn measure(case: Case, scalar: &str, threads: usize) -> Result<Speed, BenchmarkError> {
    let name = match scalar {
        "f32" => ScalarName::F32,
        "f64" => ScalarName::F64,
        _ => {
            return Err(BenchmarkError::Scalar {
                name: scalar.to_owned(),
            });
        }
    };
    let mut engine = Threads::new(threads)?;
    let (neighbours, updates_per_second) = steps(case, name, &mut engine)?;
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
fn steps(case: Case, scalar: ScalarName, engine: &mut Threads) -> Result<(f64, f64), RunError> {
    let plan = Plan::Gas(Box::new(plan(case)));
    let mut gas = start_plan(plan, (scalar, false), engine)?;
    let mut seconds = Vec::new();
    for step in 0..14 {
        let started = Instant::now();
        gas.step(engine)?;
        if step >= 3 {
            seconds.push(started.elapsed().as_secs_f64());
        }
    }
    seconds.sort_by(f64::total_cmp);
    let updates = gas.places() as f64 / seconds[seconds.len() / 2];
    Ok((gas.neighbours().mean, updates))
}

/// A lattice of spacing 1 in a periodic box, every particle up to 0.1 off its place, with small
/// velocities.
pub fn plan(case: Case) -> gas::Plan {
    gas::Plan {
        dimension: case.dimension,
        units: SolverUnits {
            length: 1.0,
            mass: 1.0,
            velocity: 1.0,
            dimension: case.dimension as i32,
        },
        middle: [0.0; 3],
        axes: [Axis::periodic(0.0, case.per_side as f64); 3],
        opening: None,
        particles: jittered(case),
        stretches: None,
        materials: vec![EquationOfState::IdealGas { gamma: 1.4 }],
        cut_off: NamedCutOff::CubicSpline,
        width: Width::adaptive(case.eta),
        viscosity: Viscosity {
            kind: ViscosityKind::Pairwise,
            alpha: 1.0,
            beta: 2.0,
            switch: None,
            balsara: false,
        },
        options: Options::OFF,
        end: 1000.0,
        courant: 0.3,
        abscissa: Abscissa::Along(0),
        doubts: Vec::new(),
    }
}

fn jittered(case: Case) -> Vec<Particle<f64, 3>> {
    let mut seed = 1u64;
    let mut noise = move || {
        // Marsaglia's xorshift: reproducible, and good enough for a jitter.
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let particle = |i: usize| {
        let (mut rest, mut position, mut velocity) = (i, [0.0; 3], [0.0; 3]);
        for x in position[..case.dimension].iter_mut().rev() {
            *x = (rest % case.per_side) as f64 + 0.5 + 0.2 * noise();
            rest /= case.per_side;
        }
        for u in &mut velocity[..case.dimension] {
            *u = 0.1 * noise();
        }
        Particle {
            position,
            velocity,
            mass: 1.0,
            energy: 1.8,
            epsilon: case.eta,
            material: 0,
        }
    };
    let particles = 0..case.per_side.pow(case.dimension as u32);
    particles.map(particle).collect()
}
