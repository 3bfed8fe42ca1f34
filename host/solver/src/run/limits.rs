//! What a scalar, a clock and a machine can hold.

use motes_core::scalar::Scalar;

use super::error::RunError;

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
    let needed = particles as f64 * bytes_each as f64;
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
