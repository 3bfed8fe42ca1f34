//! Sod's shock tube on a Cortex-M4F, in floats and in fixed point.
//!
//! Prints one line for each scalar: scenario, particles, scalar, digest, and beside it the L1
//! error of the density in units of 10^-9 of the unit of density. The digests are those of
//! `motes run sod` on a server: see `tests/golden.csv`.
#![no_std]
#![no_main]

mod console;
mod panic;
mod tube;

use console::Console;
use cortex_m_rt::entry;
use cortex_m_semihosting::debug;
use fixed::types::extra::{U19, U32};
use motes_core::equation::gas::{Gas, GasStorage};
use motes_core::error::Error;
use motes_core::integrator::Clock;
use motes_core::pairs::HalfLoop;
use motes_core::scalar::{Q32, Q64, Scalar};
use static_cell::ConstStaticCell;
use tube::{CELLS, CUT_OFF, EXACT_DENSITY, NAME, PARTICLES, TUBE, WINDOW, viscosity};

/// A tube of gas in static memory.
type Storage<S> = GasStorage<S, 1, PARTICLES, CELLS>;

static IN_F32: ConstStaticCell<Storage<f32>> = ConstStaticCell::new(Storage::new());
static IN_F64: ConstStaticCell<Storage<f64>> = ConstStaticCell::new(Storage::new());
static IN_Q12_19: ConstStaticCell<Storage<Q32<U19>>> = ConstStaticCell::new(Storage::new());
static IN_Q31_32: ConstStaticCell<Storage<Q64<U32>>> = ConstStaticCell::new(Storage::new());

#[entry]
fn main() -> ! {
    let mut console = Console::open();
    let ok = report("f32", run(IN_F32.try_take()), &mut console)
        & report("f64", run(IN_F64.try_take()), &mut console)
        & report("q12.19", run(IN_Q12_19.try_take()), &mut console)
        & report("q31.32", run(IN_Q31_32.try_take()), &mut console);
    debug::exit(if ok {
        debug::EXIT_SUCCESS
    } else {
        debug::EXIT_FAILURE
    });
    loop {
        cortex_m::asm::wfi();
    }
}

/// Runs the tube to its end. The digest of its last state, and the error of its density.
fn run<S: Scalar>(storage: Option<&mut Storage<S>>) -> Result<(u64, f64), Error> {
    // `take` would be the shorter word, but panics if the storage was taken before.
    let storage = storage.ok_or(Error::Lengths)?;
    let materials = [TUBE.material()];
    let solver = TUBE.solver(CUT_OFF, viscosity(), &materials);
    for particle in TUBE.particles() {
        storage.push(particle)?;
    }
    let (mut gas, mut work) = storage.parts();
    let mut clock = Clock::new(TUBE.duration());
    solver.prepare(&mut HalfLoop, &mut gas, &mut work)?;
    while let Some(left) = clock.left() {
        let dt = solver.time_step(&gas, left)?;
        solver.advance(&mut HalfLoop, &mut gas, &mut work, dt)?;
        clock.tick(dt)?;
    }
    Ok((gas.digest().0, density_error(&gas)))
}

/// `Σ V_k |ρ_k - ρ| / Σ V_k` over the window, `V_k = m_k/ρ_k`.
fn density_error<S: Scalar>(gas: &Gas<'_, S, 1>) -> f64 {
    let (mut sum, mut total) = (0.0, 0.0);
    let particles = gas.position.iter().zip(gas.density.iter()).zip(gas.mass);
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

/// Prints the line of one scalar; `false` where the run failed.
fn report(scalar: &str, result: Result<(u64, f64), Error>, console: &mut Console) -> bool {
    console.text(NAME);
    console.text(",");
    console.decimal(PARTICLES as u64);
    console.text(",");
    console.text(scalar);
    console.text(",");
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
