//! Why a run cannot be, or did not end.

use motes_core::equation::gas::Width;
use motes_core::error::Error;
use motes_core::scalar::Scalar;

use super::opening::OpenSides;
use super::outcome::ParticleRow;
use super::plan::Plan;

/// A run that did not reach its end.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum RunError {
    /// The solver stopped.
    #[error("at t = {time}, step {step}: {error}")]
    Solver {
        /// When, in the scenario's units.
        time: f64,
        /// In which step.
        step: u64,
        /// Why.
        error: Error,
    },
    /// Who looked at the run stopped it.
    #[error("at t = {time}: {reason}")]
    Look {
        /// When, in the scenario's units.
        time: f64,
        /// Why.
        reason: String,
    },
    /// A number of the plan does not fit the scalar.
    #[error("{what} is {value:.3e} in solver units, which `{scalar}` cannot hold to 1 %")]
    #[diagnostic(help(
        "{}",
        if value.abs() > 1.0 {
            "use a format with more integer bits, or fewer particles: lengths are counted in \
             particle spacings"
        } else {
            "use a format with more fractional bits: masses, velocities and energies are \
             counted in those of the first state"
        }
    ))]
    Format {
        /// Which number.
        what: &'static str,
        /// How large it is.
        value: f64,
        /// The scalar.
        scalar: String,
    },
    /// A step so short that the run has no end.
    #[error("at t = {time:?} the stable step is {step:.3e}: {steps:.1e} of them to the end")]
    #[diagnostic(help(
        "a speed, a diffusivity or a rate is out of proportion to time.end, or has become so: look \
         at its unit"
    ))]
    Endless {
        /// When, in the scenario's units.
        time: f64,
        /// The step, likewise.
        step: f64,
        /// How many would follow.
        steps: f64,
    },
    /// The caller asked for it.
    #[error("interrupted at t = {time}, after {step} steps: no results were written")]
    Interrupted {
        /// When.
        time: f64,
        /// After how many steps.
        step: u64,
    },
    /// Not enough memory.
    #[error(
        "{particles} particles need about {needed:.1} GiB, this machine has {available:.1} GiB free"
    )]
    #[diagnostic(help("use fewer particles (-n, resolution.particles)"))]
    Memory {
        /// How many.
        particles: usize,
        /// GiB that they take.
        needed: f64,
        /// GiB that there are.
        available: f64,
    },
}

/// Refuses a plan with a number that the format cannot hold to 1 %.
pub(super) fn check_format<S: Scalar>(plan: &Plan, scalar: &str) -> Result<(), RunError> {
    let width = match plan.width {
        Width::Adaptive { eta } => ("eta", eta),
        Width::Constant { epsilon } => ("epsilon", epsilon),
    };
    let mut numbers = vec![
        width,
        ("the duration", plan.end),
        ("courant", plan.courant),
        ("the number of particles", plan.particles.len() as f64),
    ];
    for axis in &plan.axes[..plan.dimension] {
        numbers.push(("the length of the domain", axis.upper - axis.lower));
    }
    // The largest of each: what is small beside it may be lost.
    let largest = |of: &dyn Fn(&motes_core::equation::gas::Particle<f64, 3>) -> f64| {
        plan.particles.iter().map(of).fold(0.0, f64::max)
    };
    numbers.extend([
        ("the mass of a particle", largest(&|p| p.mass)),
        ("an internal energy", largest(&|p| p.energy)),
    ]);
    for i in 0..plan.dimension {
        numbers.push(("a velocity", largest(&|p| p.velocity[i].abs())));
    }
    if let Some(incoming) = plan.opening.as_ref().and_then(OpenSides::incoming) {
        let particle = &incoming.particle;
        numbers.extend([
            ("the spacing of the inflow", incoming.spacing),
            ("the mass of a particle of the inflow", particle.mass),
            ("the internal energy of the inflow", particle.energy),
        ]);
        for velocity in &particle.velocity[..plan.dimension] {
            numbers.push(("a velocity of the inflow", *velocity));
        }
    }
    check_numbers::<S>(&numbers, scalar)
}

/// Refuses numbers that the format cannot hold to 1 %.
pub(crate) fn check_numbers<S: Scalar>(
    numbers: &[(&'static str, f64)],
    scalar: &str,
) -> Result<(), RunError> {
    for &(what, value) in numbers {
        if !((S::from_f64(value).to_f64() - value).abs() <= 0.01 * value.abs()) {
            return Err(RunError::Format {
                what,
                value,
                scalar: scalar.to_owned(),
            });
        }
    }
    Ok(())
}

/// Steps that no run makes: at a microsecond each they take eleven days.
const MOST_STEPS: f64 = 1e12;

/// Stops a run at a step, in solver units, so short that it has no end.
pub(crate) fn check_step(
    (time, unit): (f64, f64),
    step: impl Scalar,
    left: impl Scalar,
) -> Result<(), RunError> {
    let steps = left.to_f64() / step.to_f64();
    // A step of 0 is for the clock to refuse.
    if !(steps > MOST_STEPS && steps.is_finite()) {
        return Ok(());
    }
    Err(RunError::Endless {
        time,
        step: step.to_f64() * unit,
        steps,
    })
}

/// Refuses a run that would not fit into memory, where the system says how much there is.
pub(crate) fn check_memory(particles: usize, bytes_each: usize) -> Result<(), RunError> {
    let Some(available) = available_bytes() else {
        return Ok(());
    };
    // The results are held once more, as rows of f64.
    let needed = particles as f64 * (bytes_each + 2 * size_of::<ParticleRow>()) as f64;
    if needed <= available {
        return Ok(());
    }
    let gib = f64::from(1 << 30);
    Err(RunError::Memory {
        particles,
        needed: needed / gib,
        available: available / gib,
    })
}

/// Free memory as Linux tells it.
fn available_bytes() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024.0)
}
