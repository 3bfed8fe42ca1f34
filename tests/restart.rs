//! A run that is kept and gone on with is, to the bit, the run that was never interrupted.

mod runs;

use motes::engine::Threads;
use motes::families::Plan;
use motes::run::{Control, Keep, Outcome, RunError, Simulation, complete, pass_run, start_plan};
use motes::scenario::AnyScenario;
use motes_core::cloud::{Remaining, Save, Words};
use runs::any_scenario;

/// How many times a run is gone on with.
const RESUMED: u64 = 5;

/// Scenarios of all families, with what a step carries to the next in each its own way.
const SCENARIOS: [(&str, &[&str], &[&str]); 20] = [
    // Adaptive width between walls, in all forms of the energy.
    (
        "sod",
        &["f64", "f32", "q12.19", "q31.32", "micromath"],
        &["resolution.particles=120"],
    ),
    (
        "sod",
        &["f64"],
        &["resolution.particles=120", "time.energy=exact"],
    ),
    (
        "sod",
        &["f32"],
        &["resolution.particles=120", "time.energy=total"],
    ),
    // A free cloud, a switch of the viscosity and conduction.
    (
        "noh1d",
        &["f64", "q31.32"],
        &[
            "resolution.particles=60",
            "viscosity.switch={minimum = 0.1, decay = 0.1}",
        ],
    ),
    // Two materials, weights by number.
    ("water-air", &["f64", "f32"], &["resolution.particles=120"]),
    // Particles come and go, and what has come in is told.
    (
        "wind-tunnel",
        &["f64", "f32"],
        &["resolution.particles=300", "time.end=0.4"],
    ),
    // Walls that move do work; gradients are made exact; the mean pressure is left out.
    ("couette", &["f64", "f32"], &["time.end=0.01"]),
    (
        "cavity",
        &["f64"],
        &["resolution.particles=64", "time.end=0.1"],
    ),
    (
        "gresho",
        &["f64"],
        &[
            "resolution.particles=900",
            "time.end=0.1",
            "time.courant=0.2",
        ],
    ),
    (
        "noh3d",
        &["f32"],
        &["resolution.particles=700", "time.end=0.5"],
    ),
    // Snapshots and rows at their very times.
    (
        "sod",
        &["f64", "q12.19"],
        &["resolution.particles=120", "output.exact-times=true"],
    ),
    // Linear systems, on clouds that stand still and that move; growth that is bounded.
    (
        "acoustics1d",
        &["f64", "f32", "q15.16"],
        &["resolution.particles=256", "time.courant=0.1"],
    ),
    (
        "transport-compression",
        &["f64", "q31.32"],
        &["resolution.particles=256", "time.courant=0.1"],
    ),
    (
        "telegraph",
        &["f64", "q12.19"],
        &["resolution.particles=256", "time.courant=0.1"],
    ),
    (
        "manufactured",
        &["f64", "f32"],
        &[
            "resolution.particles=900",
            "time.end=0.1",
            "time.courant=0.2",
        ],
    ),
    // Convection-diffusion by both methods: the step follows from the stage before.
    (
        "wall-day",
        &["f64", "q15.16"],
        &["resolution.particles=48", "time.end=6"],
    ),
    (
        "unsteady-diffusion",
        &["f64", "f32"],
        &[
            "resolution.particles=900",
            "time.end=0.1",
            "time.courant=0.2",
        ],
    ),
    (
        "unsteady-diffusion",
        &["f64"],
        &[
            "resolution.particles=900",
            "time.end=0.05",
            "time.method=rk4",
        ],
    ),
    (
        "gray-scott",
        &["f64"],
        &["resolution.particles=256", "time.end=60"],
    ),
    (
        "decay-chain",
        &["f64", "q15.16"],
        &["resolution.particles=48"],
    ),
];

/// A run from its start, or from what was kept, on so many threads. `keep` hears every step.
fn carried(
    scenario: &AnyScenario,
    scalar: &str,
    threads: usize,
    keep: Option<&mut Keep<'_>>,
    from: Option<&mut dyn Words>,
) -> Result<Outcome, RunError> {
    let mut engine = Threads::new(threads).unwrap();
    let plan = Plan::new(scenario).unwrap();
    let how = (scalar.parse().unwrap(), false);
    let mut simulation = start_plan(plan, how, &mut engine)?;
    let mut control = Control {
        samples: 20,
        progress: &mut |_| true,
        look: &mut |_| Ok(()),
        // As short-lived as the rest.
        keep: match keep {
            Some(keep) => Some(keep),
            None => None,
        },
        from: match from {
            Some(words) => Some(words),
            None => None,
        },
    };
    complete(&mut *simulation, &mut engine, &mut control)
}

/// All that is told of a run, but for the time that it took.
fn told(outcome: &Outcome) -> String {
    let timeless = Outcome {
        seconds: 0.0,
        ..outcome.clone()
    };
    format!("{timeless:?}")
}

#[test]
fn a_run_that_is_gone_on_with_has_the_bits_series_and_sums_of_one_that_was_not_interrupted() {
    for (name, scalars, changes) in SCENARIOS {
        let scenario = any_scenario(name, changes);
        let has_all = cfg!(feature = "fixed-point");
        for &scalar in scalars
            .iter()
            .filter(|name| has_all || name.starts_with('f'))
        {
            let run = || format!("{name} in {scalar} {changes:?}");
            let whole = carried(&scenario, scalar, 1, None, None);
            let whole = whole.unwrap_or_else(|error| panic!("{}: {error}", run()));
            assert!(
                whole.steps > RESUMED + 1,
                "{}: {} steps",
                run(),
                whole.steps
            );
            // Kept on the way, on as many threads as may be.
            let every = whole.steps.div_ceil(RESUMED + 1);
            let mut kept: Vec<Vec<u8>> = Vec::new();
            let mut keep = |simulation: &mut dyn Simulation, logbook: &mut _| {
                if simulation.steps().is_multiple_of(every) {
                    let mut memory = Vec::new();
                    let mut words = Save(|bytes: &[u8]| {
                        memory.extend_from_slice(bytes);
                        Ok(())
                    });
                    let passed = pass_run(simulation, logbook, &mut words);
                    passed.map_err(|error| error.to_string())?;
                    kept.push(memory);
                }
                Ok(())
            };
            let watched = carried(&scenario, scalar, 2, Some(&mut keep), None).unwrap();
            assert_eq!(told(&watched), told(&whole), "{}: kept", run());
            assert!(
                kept.len() as u64 + 1 >= RESUMED,
                "{}: {}",
                run(),
                kept.len()
            );
            for (place, words) in kept.iter().enumerate() {
                let mut words = Remaining(words);
                let threads = 1 + place % 2;
                let resumed = carried(&scenario, scalar, threads, None, Some(&mut words));
                let resumed = resumed.unwrap_or_else(|error| panic!("{}: {error}", run()));
                assert_eq!(told(&resumed), told(&whole), "{}, part {place}", run());
            }
        }
    }
}
