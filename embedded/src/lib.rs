//! What the firmwares share: scenarios, made by `motes export`, and how they are
//! run in static memory and reported.
#![no_std]

pub mod acoustics;
pub mod console;
pub mod diffusion;
pub mod gas;
pub mod linear;
mod panic;
pub mod steps;
pub mod stopwatch;
pub mod telegraph;
pub mod tube;
pub mod wall;
