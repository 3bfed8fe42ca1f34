//! Sod's shock tube.

use motes_core::equation::gas::{Gas, PlainStorage};
use motes_core::error::Error;
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::Scalar;

use crate::console::Console;
use crate::steps::complete;
use crate::tube::{CELLS, CUT_OFF, EXACT_DENSITY, NAME, PARTICLES, TUBE, WINDOW, viscosity};

/// A tube of gas in static memory.
pub type Storage<S> = PlainStorage<S, 1, PARTICLES, CELLS>;

/// Runs the tube in one scalar and prints its line: behind the digest the L1 error of the density
/// in units of 10^-9 of the unit of density. `false` where the run failed.
pub fn report<S: Scalar>(
    scalar: &str,
    storage: Option<&mut Storage<S>>,
    console: &mut Console,
) -> bool {
    let result = run(storage);
    console.row(NAME, PARTICLES, scalar);
    match result {
        Ok((digest, error)) => {
            console.hexadecimal(digest);
            console.text(" density L1 ");
            console.decimal((error * 1e9) as u64);
            console.text("e-9\n");
        }
        Err(_) => console.text("failed\n"),
    }
    result.is_ok()
}

/// Runs the tube to its end. The digest of its last state, and the error of its density.
fn run<S: Scalar>(storage: Option<&mut Storage<S>>) -> Result<(u64, f64), Error> {
    let storage = storage.ok_or(Error::Lengths)?;
    let materials = [TUBE.material()];
    let solver = TUBE.solver(CUT_OFF, viscosity(), &materials);
    TUBE.fill(|particle| storage.push(particle))?;
    let mut run = Stepper::new(solver, LeapFrog, HalfLoop, storage)?.until(TUBE.duration());
    let digest = complete(&mut run)?;
    Ok((digest, density_error(&run.state())))
}

/// `Σ V_k |ρ_k - ρ| / Σ V_k` over the window, `V_k = m_k/ρ_k`.
fn density_error<S: Scalar>(gas: &Gas<'_, S, 1>) -> f64 {
    let (mut sum, mut total) = (0.0, 0.0);
    let particles = gas
        .position
        .iter()
        .zip(gas.density.iter())
        .zip(gas.mass.iter());
    for ((&[x], density), mass) in particles {
        let (x, density) = (x.to_f64(), density.to_f64());
        if (WINDOW[0]..=WINDOW[1]).contains(&x) {
            let volume = mass.to_f64() / density;
            let error = density - exact_density(x);
            sum += volume * if error < 0.0 { -error } else { error };
            total += volume;
        }
    }
    sum / total
}

/// The exact density: straight lines between the points of the table.
fn exact_density(x: f64) -> f64 {
    let mut before = (WINDOW[0], 0.0);
    for after in EXACT_DENSITY {
        if x < after.0 {
            let part = (x - before.0) / (after.0 - before.0);
            return before.1 + (after.1 - before.1) * part;
        }
        before = after;
    }
    before.1
}
