//! The instructions of the steps of a run.

use motes_core::cloud::Columns;
use motes_core::equation::{Dynamics, Storage};
use motes_core::error::Error;
use motes_core::integrator::Stepper;
use motes_core::pairs::Engine;
use motes_core::scalar::Scalar;

use crate::console::Console;
use crate::stopwatch::Stopwatch;

/// Runs to the end; the digest of the last state.
pub fn complete<S, Y, E, M, const D: usize>(run: &mut Stepper<S, Y, E, M, D>) -> Result<u64, Error>
where
    S: Scalar,
    Y: Dynamics<S, D>,
    E: Engine<S, D>,
    M: Storage<S, Y, D>,
{
    while run.step()?.is_some() {}
    Ok(run.state().digest().0)
}

/// Instructions of a step.
pub struct Steps {
    /// Of the first one.
    pub first: u64,
    /// Of the longest one.
    pub longest: u64,
}

impl Steps {
    /// Counts the first steps of a run, `most` at the most. `step` makes one; `false` where the end
    /// has been reached before.
    pub fn count(
        stopwatch: &Stopwatch,
        most: u32,
        mut step: impl FnMut() -> Result<bool, Error>,
    ) -> Result<Self, Error> {
        let mut steps = Self {
            first: 0,
            longest: 0,
        };
        for _ in 0..most {
            let mut more = Ok(false);
            let count = stopwatch.instructions(|| more = step());
            if !more? {
                break;
            }
            if steps.first == 0 {
                steps.first = count;
            }
            steps.longest = steps.longest.max(count);
        }
        Ok(steps)
    }
}

/// Prints the end of a line: method, instructions of the first step and of the longest, bytes of
/// memory. `false` where the run failed.
pub fn report(
    method: &str,
    steps: &Result<Steps, Error>,
    bytes: usize,
    console: &mut Console,
) -> bool {
    console.text(method);
    match steps {
        Ok(steps) => {
            for number in [steps.first, steps.longest, bytes as u64] {
                console.text(",");
                console.decimal(number);
            }
            console.text("\n");
        }
        Err(_) => console.text(",failed\n"),
    }
    steps.is_ok()
}
