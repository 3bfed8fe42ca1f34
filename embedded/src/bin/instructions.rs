//! Counts the instructions of a step of acoustics, 64 particles, in five scalars and by both
//! methods. Run it under QEMU with `-icount shift=6`: see `stopwatch.rs`.
//!
//! Prints one line for each: scenario, particles, scalar, method, instructions of the first step
//! and of the longest, bytes of memory.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixed::types::extra::{U16, U19, U32};
use motes_core::error::Error;
use motes_core::integrator::{RK4, RungeKutta, SSP_RK3};
use motes_core::scalar::{Q32, Q64, Scalar};
use motes_firmware::acoustics::{CUT_OFF, LINE, NAME, PARTICLES, motion, system};
use motes_firmware::console::Console;
use motes_firmware::linear::{Storage, start};
use motes_firmware::steps::{self, Steps};
use motes_firmware::stopwatch::Stopwatch;
use static_cell::ConstStaticCell;

static F32: ConstStaticCell<Storage<f32>> = ConstStaticCell::new(Storage::new());
static F64: ConstStaticCell<Storage<f64>> = ConstStaticCell::new(Storage::new());
static Q12_19: ConstStaticCell<Storage<Q32<U19>>> = ConstStaticCell::new(Storage::new());
static Q15_16: ConstStaticCell<Storage<Q32<U16>>> = ConstStaticCell::new(Storage::new());
static Q31_32: ConstStaticCell<Storage<Q64<U32>>> = ConstStaticCell::new(Storage::new());

#[entry]
fn main() -> ! {
    let mut console = Console::open();
    let timer = cortex_m::Peripherals::take().map(|device| device.SYST);
    let Some(stopwatch) = timer.and_then(Stopwatch::new) else {
        console.text("SysTick does not count instructions: run QEMU with -icount shift=6\n");
        console.close(false);
    };
    let ok = report("q15.16", Q15_16.try_take(), &stopwatch, &mut console)
        & report("q12.19", Q12_19.try_take(), &stopwatch, &mut console)
        & report("q31.32", Q31_32.try_take(), &stopwatch, &mut console)
        & report("f32", F32.try_take(), &stopwatch, &mut console)
        & report("f64", F64.try_take(), &stopwatch, &mut console);
    console.close(ok)
}

/// Counts and prints the lines of one scalar; `false` where a run failed.
fn report<S: Scalar>(
    scalar: &str,
    storage: Option<&mut Storage<S>>,
    stopwatch: &Stopwatch,
    console: &mut Console,
) -> bool {
    let Some(storage) = storage else {
        return false;
    };
    let mut ok = true;
    for method in [RK4, SSP_RK3] {
        let steps = count(storage, method, stopwatch);
        console.row(NAME, PARTICLES, scalar);
        ok &= steps::report(method.name, &steps, size_of::<Storage<S>>(), console);
    }
    ok
}

/// Counts every step of the run.
fn count<S: Scalar>(
    storage: &mut Storage<S>,
    method: RungeKutta,
    stopwatch: &Stopwatch,
) -> Result<Steps, Error> {
    let equation = (CUT_OFF, system::<S>(), motion::<S>());
    let mut run = start(storage, &LINE, equation, method)?;
    Steps::count(stopwatch, u32::MAX, || Ok(run.step()?.is_some()))
}
