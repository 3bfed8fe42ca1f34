//! A simulation that is held: looking, stopping on the way and another one beside it change no bit.

mod runs;

use motes::engine::Threads;
use motes::run::{RunError, ScalarName, Simulation, start};
use motes::scenario::{AnyScenario, Source};

/// One of each family; the second stands still and keeps its sorted cells.
const CASES: [(&str, &[&str]); 4] = [
    ("sod", &["resolution.particles=225", "time.end=0.05"]),
    ("acoustics1d", &["motion.kind=still", "time.end=0.2"]),
    ("heat1d", &[]),
    ("heat1d", &["system.form=mixed", "time.method=rk4"]),
];

fn begun(engine: &mut Threads, (name, changes): (&str, &[&str])) -> Box<dyn Simulation> {
    start(&runs::any_scenario(name, changes), ScalarName::F32, engine).unwrap()
}

/// Neighbour lists belong to one cloud: an engine that serves two in turns makes them anew.
#[test]
fn simulations_that_share_an_engine_have_the_bits_of_those_that_do_not() {
    let mut engine = Threads::new(2).unwrap();
    let mut together: Vec<_> = CASES.iter().map(|case| begun(&mut engine, *case)).collect();
    let mut is_going = true;
    while is_going {
        is_going = false;
        for simulation in &mut together {
            is_going |= simulation.step(&mut engine).unwrap().is_some();
        }
    }
    for (case, simulation) in CASES.into_iter().zip(&mut together) {
        let alone = runs::outcome(case.0, "f32", 1, case.1);
        assert_eq!(simulation.digest(), alone.digest, "{case:?}");
        assert_eq!(simulation.steps(), alone.steps, "{case:?}");
    }
}

#[test]
fn stopping_on_the_way_and_looking_change_no_bit() {
    for case in CASES {
        let mut engine = Threads::new(1).unwrap();
        let mut held = begun(&mut engine, case);
        let end = held.description().duration;
        for part in [0.25, 0.5, 2.0] {
            held.advance_to(part * end, &mut engine).unwrap();
            held.observe(&mut engine).unwrap();
            let (description, mut rows) = (held.description().clone(), 0);
            held.each(|row| {
                assert_eq!(row.values.len(), description.width());
                rows += 1;
            });
            assert_eq!(rows, held.particles());
            assert_eq!(description.headings().len(), description.width());
            let measures = held.measures();
            assert_eq!(measures.diagnostics.len(), description.diagnostics.len());
            assert_eq!(measures.sums.len(), description.sums.len());
        }
        assert!(held.is_over() && (held.time() - end).abs() <= 1e-6 * end);
        assert_eq!(
            held.digest(),
            runs::outcome(case.0, "f32", 1, case.1).digest
        );
    }
}

#[test]
fn columns_are_found_by_their_headings() {
    let mut engine = Threads::new(1).unwrap();
    let few = ["resolution.particles=3000"];
    let plane = begun(&mut engine, ("sod2d", &few));
    let particles = plane.particles();
    for heading in [
        "position_x",
        "velocity_y",
        "density",
        "neighbours",
        "material",
    ] {
        assert_eq!(plane.column(heading).unwrap().len(), particles, "{heading}");
    }
    assert!(plane.column("velocity").is_none() && plane.column("position_z").is_none());
    let spread = plane.spread("density").unwrap();
    assert!(spread.min > 0.0 && spread.min < spread.mean && spread.mean < spread.max);
}

/// Between two tasks, not only between steps.
#[test]
fn an_engine_that_is_told_to_stop_does_so_in_mid_step() {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};

    for name in ["sod", "acoustics1d", "heat1d"] {
        for threads in [1, 3] {
            let scenario = AnyScenario::read(Source::from(name), &[]).unwrap();
            let mut engine = Threads::new(threads).unwrap();
            let flag = Arc::new(AtomicBool::new(false));
            engine.stop_on(Arc::clone(&flag));
            let mut simulation = start(&scenario, ScalarName::F64, &mut engine).unwrap();
            assert!(simulation.step(&mut engine).unwrap().is_some());
            flag.store(true, Ordering::Relaxed);
            let error = simulation.step(&mut engine).unwrap_err();
            assert!(
                matches!(error, RunError::Interrupted { step: 1, .. }),
                "{name}: {error}"
            );
        }
    }
}
