//! A scenario that comes with the program, stepped, and a column of what it holds then.
//!
//! `cargo run --release --example run`

use motes::engine::Threads;
use motes::run::{ScalarName, start};
use motes::scenario::{AnyScenario, Source};

fn main() -> miette::Result<()> {
    let scenario = AnyScenario::read(Source::from("sod"), &[])?;
    let mut engine = Threads::new(0)?;
    let mut sod = start(&scenario, ScalarName::F64, &mut engine)?;
    sod.advance_to(0.1, &mut engine)?;
    let (x, density) = (sod.column("position"), sod.column("density"));
    for (x, density) in x.iter().flatten().zip(density.iter().flatten()) {
        println!("{x} {density}");
    }
    println!("t = {}, digest {}", sod.time(), sod.digest());
    Ok(())
}
