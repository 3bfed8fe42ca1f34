//! Whole runs, lanes against the plain loop: what `motes run` has compiled still has vectors.
//!
//! `cargo bench --bench runs` prints the ratio of each and fails where one is below what it must be.

use std::process::ExitCode;
use std::time::Instant;

use motes::engine::{InstructionSet, Threads};
use motes::families::Plan;
use motes::run::{Control, ScalarName, complete, start_plan};
use motes::scenario::{AnyScenario, Source};

/// A run that is measured.
struct Case {
    /// A built-in scenario.
    scenario: &'static str,
    /// What makes it short.
    changes: &'static [&'static str],
    /// Its scalar.
    scalar: ScalarName,
    /// The smallest ratio with AVX-512; with AVX2 three quarters of it. Without vectors it is below
    /// 1.5.
    smallest: f64,
}

const CASES: [Case; 6] = [
    Case {
        scenario: "sod2d",
        changes: &["resolution.particles=20000", "time.end=0.02"],
        scalar: ScalarName::F32,
        smallest: 3.0,
    },
    Case {
        scenario: "sod2d",
        changes: &["resolution.particles=20000", "time.end=0.02"],
        scalar: ScalarName::F64,
        smallest: 2.0,
    },
    Case {
        scenario: "sedov3d",
        changes: &["resolution.particles=8000", "time.end=0.01"],
        scalar: ScalarName::F32,
        // On a Xeon from 2.5 to 3.0, from run to run.
        smallest: 2.0,
    },
    Case {
        scenario: "shallow-water",
        changes: &[],
        scalar: ScalarName::F64,
        smallest: 2.0,
    },
    Case {
        scenario: "rotating-gaussian",
        changes: &[],
        scalar: ScalarName::F64,
        smallest: 2.0,
    },
    Case {
        scenario: "heat2d",
        changes: &[],
        scalar: ScalarName::F32,
        smallest: 3.0,
    },
];

/// Makes the run once with each engine and returns the seconds of each.
fn seconds(case: &Case, engines: &mut [&mut Threads]) -> Vec<f64> {
    let changes: Vec<String> = case.changes.iter().map(|&set| set.to_owned()).collect();
    let source = Source::BuiltIn(case.scenario.to_owned());
    let plan = Plan::new(&AnyScenario::read(source, &changes).unwrap()).unwrap();
    let mut control = Control {
        samples: 1,
        progress: &mut |_| true,
        look: &mut |_| Ok(()),
        keep: None,
        from: None,
    };
    let run = |engine: &mut &mut Threads| {
        let started = Instant::now();
        let mut simulation = start_plan(plan.clone(), (case.scalar, false), engine).unwrap();
        complete(&mut *simulation, engine, &mut control).unwrap();
        started.elapsed().as_secs_f64()
    };
    engines.iter_mut().map(run).collect()
}

/// Lanes over plain: the median of pairs of runs one after the other.
fn ratio(case: &Case, set: InstructionSet) -> f64 {
    let mut plain = Threads::with(1, InstructionSet::Portable).unwrap();
    let mut lanes = Threads::with(1, set).unwrap();
    let mut ratios: Vec<f64> = (0..3)
        .map(|_| {
            let seconds = seconds(case, &mut [&mut plain, &mut lanes]);
            seconds[0] / seconds[1]
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    ratios[ratios.len() / 2]
}

fn main() -> ExitCode {
    let set = InstructionSet::detect();
    if set == InstructionSet::Portable || cfg!(not(target_arch = "x86_64")) {
        println!("this processor has no vectors that runs use: nothing to compare");
        return ExitCode::SUCCESS;
    }
    let mut code = ExitCode::SUCCESS;
    for case in &CASES {
        let ratio = ratio(case, set);
        let (name, scalar) = (case.scenario, case.scalar.name());
        println!(
            "{name} is {ratio:.1} times as fast with lanes ({scalar}, {})",
            set.name()
        );
        let smallest = match set {
            InstructionSet::Avx512 => case.smallest,
            _ => 0.75 * case.smallest,
        };
        if !(ratio >= smallest) {
            eprintln!("expected {smallest}: its loops are no longer vectorised");
            code = ExitCode::FAILURE;
        }
    }
    code
}
