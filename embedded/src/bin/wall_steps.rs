//! Counts the instructions of the first steps of a wall in the weather, in two scalars. Run it under
//! QEMU with `-icount shift=6`: see `stopwatch.rs`.
//!
//! Prints one line for each: scenario, particles, scalar, method, instructions of the first step
//! and of the longest, bytes of memory.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixed::types::extra::U16;
use motes_core::scalar::{Q32, Scalar};
use motes_firmware::console::Console;
use motes_firmware::diffusion::{Storage, start};
use motes_firmware::steps::{self, Steps};
use motes_firmware::stopwatch::Stopwatch;
use motes_firmware::wall::{NAME, PARTICLES};

/// The particles stand still, and all steps but the shorter last one have the stages of the first.
const STEPS: u32 = 16;

#[entry]
fn main() -> ! {
    let mut console = Console::open();
    let timer = cortex_m::Peripherals::take().map(|device| device.SYST);
    let Some(stopwatch) = timer.and_then(Stopwatch::new) else {
        console.text("SysTick does not count instructions: run QEMU with -icount shift=6\n");
        console.close(false);
    };
    let ok = count::<Q32<U16>>("q15.16", &stopwatch, &mut console)
        & count::<f32>("f32", &stopwatch, &mut console);
    console.close(ok)
}

/// Counts and prints the line of one scalar; `false` where the run failed.
#[inline(never)]
fn count<S: Scalar>(scalar: &str, stopwatch: &Stopwatch, console: &mut Console) -> bool {
    let mut storage = Storage::<S>::new();
    let run = start(&mut storage);
    let steps =
        run.and_then(|mut run| Steps::count(stopwatch, STEPS, || Ok(run.step()?.is_some())));
    console.row(NAME, PARTICLES, scalar);
    steps::report("rkl2", &steps, size_of::<Storage<S>>(), console)
}
