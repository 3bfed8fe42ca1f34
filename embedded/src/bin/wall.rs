//! A wall in the weather, in two scalars one after the other in the same 16 KiB of memory. A start
//! for your own on a small processor.
//!
//! Prints one line for each scalar: scenario, particles, scalar, digest, and the bytes of its
//! storage.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixed::types::extra::U16;
use motes_core::scalar::{Q32, Scalar};
use motes_firmware::console::Console;
use motes_firmware::diffusion::{Storage, report};

#[entry]
fn main() -> ! {
    let mut console = Console::open();
    let ok = run::<Q32<U16>>("q15.16", &mut console) & run::<f32>("f32", &mut console);
    console.close(ok)
}

/// Runs the wall in one scalar. On the stack, not in a static: so the other may have the same
/// memory.
#[inline(never)]
fn run<S: Scalar>(scalar: &str, console: &mut Console) -> bool {
    let mut storage = Storage::<S>::new();
    report(scalar, Some(&mut storage), console)
}
