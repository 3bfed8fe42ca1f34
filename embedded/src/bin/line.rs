//! The smallest firmware: acoustics in one scalar. A start for your own.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixed::types::extra::U16;
use motes_core::error::Error;
use motes_core::scalar::Q32;
use motes_firmware::acoustics::{NAME, PARTICLES};
use motes_firmware::console::Console;
use motes_firmware::linear::{self, Storage};
use static_cell::ConstStaticCell;

static LINE: ConstStaticCell<Storage<Q32<U16>>> = ConstStaticCell::new(Storage::new());

#[entry]
fn main() -> ! {
    let mut console = Console::open();
    let outcome = match LINE.try_take() {
        Some(storage) => linear::acoustics(storage),
        None => Err(Error::Lengths),
    };
    console.row(NAME, PARTICLES, "q15.16");
    console.outcome(&outcome);
    console.close(outcome.is_ok())
}
