//! The runs that the firmware holds, in the core alone: in fixed point every sum of theirs is proven to
//! stay in range, and their digests are those of the golden table.

#[path = "../../embedded/src/acoustics.rs"]
#[allow(dead_code)]
mod acoustics;
#[path = "../../embedded/src/telegraph.rs"]
#[allow(dead_code)]
mod telegraph;
#[path = "../../embedded/src/tube.rs"]
#[allow(dead_code)]
mod tube;
#[allow(clippy::extra_unused_type_parameters)]
#[path = "../../embedded/src/wall.rs"]
#[allow(dead_code)]
mod wall;

use fixed::types::extra::{U16, U19, U32};
use motes_core::cloud::{Columns, Save};
use motes_core::equation::diffusion::{DirectStorage, Lists};
use motes_core::equation::gas::PlainStorage;
use motes_core::equation::linear::LinearStorage;
use motes_core::equation::{Dynamics, Storage};
use motes_core::error::Error;
use motes_core::integrator::{DiffusionMethod, LeapFrog, Scheme, Stepper};
use motes_core::pairs::{HalfLoop, Nothing};
use motes_core::scalar::{Q32, Q64, Scalar};

type Q15p16 = Q32<U16>;
type Q12p19 = Q32<U19>;
type Q31p32 = Q64<U32>;

/// Runs to the end; the digest.
fn complete<S, Y, M>(mut run: Stepper<S, Y, HalfLoop, M, 1>) -> Result<String, Error>
where
    S: Scalar,
    Y: Dynamics<S, 1>,
    M: Storage<S, Y, 1>,
{
    while run.step()?.is_some() {}
    Ok(Columns::digest(&run.state()).to_string())
}

fn sod<S: Scalar>() -> Result<String, Error> {
    let mut storage = PlainStorage::<S, 1, { tube::PARTICLES }, { tube::CELLS }>::new();
    let materials = [tube::TUBE.material()];
    let solver = tube::TUBE.solver(tube::CUT_OFF, tube::viscosity(), &materials);
    tube::TUBE.fill(|particle| storage.push(particle))?;
    let run = Stepper::new(solver, LeapFrog, HalfLoop, storage)?;
    complete(run.until(tube::TUBE.duration()))
}

macro_rules! line {
    ($name:ident) => {
        fn $name<S: Scalar>() -> Result<String, Error> {
            use $name::{CELLS, CUT_OFF, LINE, METHOD, PARTICLES, motion, system};
            let mut storage = LinearStorage::<S, Nothing, 1, 2, PARTICLES, CELLS>::new();
            for particle in LINE.particles() {
                storage.push(particle)?;
            }
            let dynamics = LINE.dynamics(CUT_OFF, system::<S>(), motion::<S>());
            let run = Stepper::new(dynamics, METHOD, HalfLoop, storage)?;
            complete(run.until(LINE.duration()))
        }
    };
}
line!(acoustics);
line!(telegraph);

fn wall_day<S: Scalar>() -> Result<String, Error> {
    use wall::{CELLS, CUT_OFF, LAYERS, PARTICLES, POINTS, SLAB, motion};
    let mut lists = Lists::<S, POINTS, LAYERS>::new();
    let mut cloud = DirectStorage::<S, 1, 1, PARTICLES, CELLS>::new();
    for particle in SLAB.particles() {
        cloud.push(particle)?;
    }
    let dynamics = SLAB.dynamics(CUT_OFF, SLAB.problem(&mut lists)?, motion::<S>());
    let method = DiffusionMethod {
        scheme: Scheme::Stabilised(SLAB.stages),
        longest: SLAB.longest(),
    };
    complete(Stepper::new(dynamics, method, HalfLoop, cloud)?.until(SLAB.duration()))
}

/// The digest of the golden table.
fn golden(scenario: &str, particles: usize, scalar: &str) -> Result<String, Error> {
    let table = include_str!("../../tests/golden.csv");
    let row = format!("{scenario},{particles},{scalar},");
    let digest = table.lines().find_map(|line| line.strip_prefix(&row));
    Ok(digest.unwrap_or("no such row").to_owned())
}

#[test]
fn the_tube_is_proven_all_the_way() {
    assert_eq!(sod::<Q12p19>(), golden("sod", 225, "q12.19"));
    assert_eq!(sod::<Q31p32>(), golden("sod", 225, "q31.32"));
}

#[test]
fn the_lines_are_proven_all_the_way() {
    assert_eq!(acoustics::<Q12p19>(), golden("acoustics1d", 64, "q12.19"));
    assert_eq!(acoustics::<Q15p16>(), golden("acoustics1d", 64, "q15.16"));
    assert_eq!(acoustics::<Q31p32>(), golden("acoustics1d", 64, "q31.32"));
    assert_eq!(telegraph::<Q12p19>(), golden("telegraph", 64, "q12.19"));
    assert_eq!(telegraph::<Q15p16>(), golden("telegraph", 64, "q15.16"));
    assert_eq!(telegraph::<Q31p32>(), golden("telegraph", 64, "q31.32"));
}

#[test]
fn the_wall_is_proven_all_the_way() {
    assert_eq!(wall_day::<Q15p16>(), golden("wall-day", 96, "q15.16"));
    assert_eq!(wall_day::<Q31p32>(), golden("wall-day", 96, "q31.32"));
}

/// As `docs/devices.md` says.
#[test]
fn the_words_of_the_wall_are_2392_bytes() {
    use wall::{CELLS, CUT_OFF, LAYERS, PARTICLES, POINTS, SLAB, motion};
    let mut lists = Lists::<Q15p16, POINTS, LAYERS>::new();
    let mut cloud = DirectStorage::<Q15p16, 1, 1, PARTICLES, CELLS>::new();
    SLAB.particles()
        .for_each(|particle| cloud.push(particle).unwrap());
    let dynamics = SLAB.dynamics(
        CUT_OFF,
        SLAB.problem(&mut lists).unwrap(),
        motion::<Q15p16>(),
    );
    let method = DiffusionMethod {
        scheme: Scheme::Stabilised(SLAB.stages),
        longest: SLAB.longest(),
    };
    let mut run = Stepper::new(dynamics, method, HalfLoop, cloud).unwrap();
    let mut bytes = 0;
    let mut count = Save(|word: &[u8]| {
        bytes += word.len();
        Ok(())
    });
    run.pass(&mut count).unwrap();
    assert_eq!(bytes, 2392);
}
