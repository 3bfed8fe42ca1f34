//! Sod's shock tube, acoustics, the telegraph line and a wall in the weather on a Cortex-M4F, in
//! floats and in fixed point.
//!
//! Prints one line for each scenario and scalar: scenario, particles, scalar, digest. The digests
//! are those of `motes run` on a server: see `tests/golden.csv`.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixed::types::extra::{U16, U19, U32};
use motes_core::scalar::{Q32, Q64};
use motes_firmware::console::Console;
use motes_firmware::{diffusion, gas, linear};
use static_cell::ConstStaticCell;

static GAS_F32: ConstStaticCell<gas::Storage<f32>> = ConstStaticCell::new(gas::Storage::new());
static GAS_F64: ConstStaticCell<gas::Storage<f64>> = ConstStaticCell::new(gas::Storage::new());
static GAS_Q12_19: ConstStaticCell<gas::Storage<Q32<U19>>> =
    ConstStaticCell::new(gas::Storage::new());
static GAS_Q31_32: ConstStaticCell<gas::Storage<Q64<U32>>> =
    ConstStaticCell::new(gas::Storage::new());

static LINE_F32: ConstStaticCell<linear::Storage<f32>> =
    ConstStaticCell::new(linear::Storage::new());
static LINE_F64: ConstStaticCell<linear::Storage<f64>> =
    ConstStaticCell::new(linear::Storage::new());
static LINE_Q12_19: ConstStaticCell<linear::Storage<Q32<U19>>> =
    ConstStaticCell::new(linear::Storage::new());
static LINE_Q15_16: ConstStaticCell<linear::Storage<Q32<U16>>> =
    ConstStaticCell::new(linear::Storage::new());
static LINE_Q31_32: ConstStaticCell<linear::Storage<Q64<U32>>> =
    ConstStaticCell::new(linear::Storage::new());

static WALL_F32: ConstStaticCell<diffusion::Storage<f32>> =
    ConstStaticCell::new(diffusion::Storage::new());
static WALL_F64: ConstStaticCell<diffusion::Storage<f64>> =
    ConstStaticCell::new(diffusion::Storage::new());
static WALL_Q15_16: ConstStaticCell<diffusion::Storage<Q32<U16>>> =
    ConstStaticCell::new(diffusion::Storage::new());
static WALL_Q31_32: ConstStaticCell<diffusion::Storage<Q64<U32>>> =
    ConstStaticCell::new(diffusion::Storage::new());

#[entry]
fn main() -> ! {
    let mut console = Console::open();
    // `take` would be the shorter word, but panics if the storage was taken before.
    let ok = gas::report("f32", GAS_F32.try_take(), &mut console)
        & gas::report("f64", GAS_F64.try_take(), &mut console)
        & gas::report("q12.19", GAS_Q12_19.try_take(), &mut console)
        & gas::report("q31.32", GAS_Q31_32.try_take(), &mut console)
        & linear::report("f32", LINE_F32.try_take(), &mut console)
        & linear::report("f64", LINE_F64.try_take(), &mut console)
        & linear::report("q12.19", LINE_Q12_19.try_take(), &mut console)
        & linear::report("q15.16", LINE_Q15_16.try_take(), &mut console)
        & linear::report("q31.32", LINE_Q31_32.try_take(), &mut console)
        & diffusion::report("f32", WALL_F32.try_take(), &mut console)
        & diffusion::report("f64", WALL_F64.try_take(), &mut console)
        & diffusion::report("q15.16", WALL_Q15_16.try_take(), &mut console)
        & diffusion::report("q31.32", WALL_Q31_32.try_take(), &mut console);
    console.close(ok)
}
