//! `motes run`.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressStyle};
use miette::{IntoDiagnostic, Report, WrapErr};

use super::Failure;
use super::arguments::{RunArguments, scalar, scenario};
use crate::comparison::{ExactSolution, FIELDS, fields, norms};
use crate::engine::Threads;
use crate::io;
use crate::report::figure::{self, Panel};
use crate::report::summary::Summary;
use crate::scenario::Scenario;
use crate::simulation::{self, Control, Outcome, Plan, RunError};

fn input(error: impl Into<Report>) -> Failure {
    Failure::Input(error.into())
}

/// Reads, runs, writes, prints.
pub(super) fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let scalar = scalar(&arguments.scalar)?;
    let scenario = scenario(
        &arguments.scenario,
        arguments.particles.as_deref(),
        &arguments.overrides,
    )?;
    let exact = ExactSolution::of(&scenario)
        .into_diagnostic()
        .wrap_err("this scenario has no exact solution: remove output.exact")
        .map_err(Failure::Input)?;
    let plan = Plan::new(&scenario).map_err(input)?;
    let mut engine = Threads::new(arguments.threads).map_err(input)?;
    let out = arguments
        .out
        .clone()
        .unwrap_or_else(|| Path::new("out").join(&scenario.name));
    // Now rather than after the run: a folder that cannot be written to costs no time.
    io::writable(&out).map_err(input)?;

    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    // Without the handler Ctrl-C still ends the program, only less politely.
    let _ = ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed));
    let bar = progress_bar(arguments.quiet || arguments.json, &scenario.name);
    let mut control = Control {
        samples: scenario.output.samples,
        progress: &mut |done| {
            bar.set_position((1000.0 * done) as u64);
            !interrupted.load(Ordering::Relaxed)
        },
    };
    let checked = arguments.check_overflow;
    let outcome = simulation::run(&plan, scalar, checked, &mut engine, &mut control);
    bar.finish_and_clear();
    let outcome = outcome.map_err(|error| match error {
        RunError::Interrupted { .. } => Failure::Interrupted(error.into()),
        RunError::Format { .. } | RunError::Memory { .. } => Failure::Input(error.into()),
        RunError::Solver { .. } => Failure::Run(error.into()),
    })?;

    let errors = exact.as_ref().and_then(|exact| {
        norms(
            exact,
            &outcome.particles,
            outcome.time,
            &scenario.output.window,
        )
    });
    let mut doubts: Vec<String> = exact
        .iter()
        .filter_map(|exact| exact.doubt(&scenario))
        .map(|why| format!("{why}: the exact solution may not hold there"))
        .collect();
    if exact.is_some() && errors.is_none() {
        doubts.push("no particle is in output.window: there are no errors to tell".to_owned());
    }
    write(&out, &scenario, &outcome, exact.as_ref()).map_err(Failure::Run)?;
    let called = (scenario.name.as_str(), scalar.name(), engine.threads());
    let summary = Summary::new(called, &outcome, errors, doubts);
    if arguments.json {
        let json = serde_json::to_string(&summary)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        super::print(&format!("{json}\n"))?;
    } else if !arguments.quiet {
        super::print(&format!(
            "{summary}
results    {}
",
            out.display()
        ))?;
    }
    Ok(())
}

fn progress_bar(hidden: bool, name: &str) -> ProgressBar {
    if hidden || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg} {wide_bar} {percent}% {eta} left");
    let bar = ProgressBar::new(1000).with_message(name.to_owned());
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Writes all result files.
fn write(
    out: &Path,
    scenario: &Scenario,
    outcome: &Outcome,
    exact: Option<&ExactSolution>,
) -> Result<(), Report> {
    let file = |name: &str| -> PathBuf { out.join(name) };
    io::write_text(&file("scenario.toml"), &scenario.text)?;
    io::write_particles(&file("particles.csv"), outcome, exact)?;
    io::write_series(&file("series.csv"), &outcome.series)?;
    let title = format!(
        "{}, {} particles, t = {}",
        scenario.name,
        outcome.particles.len(),
        outcome.time
    );
    let picture = figure::panels(&title, "position", &panels(scenario, outcome, exact))?;
    io::write_text(&file("figure.svg"), &picture)?;
    Ok(())
}

/// A panel for each field over the window: particles as points, the exact solution as a curve.
fn panels(scenario: &Scenario, outcome: &Outcome, exact: Option<&ExactSolution>) -> Vec<Panel> {
    let window = &scenario.output.window;
    let (lower, upper) = (window.lower[0], window.upper[0]);
    let inside: Vec<_> = outcome
        .particles
        .iter()
        .filter(|particle| (lower..=upper).contains(&particle.position))
        .collect();
    let points = 1000;
    let at = |i: i32| lower + (upper - lower) * f64::from(i) / f64::from(points);
    let panel = |(i, field): (usize, &str)| Panel {
        heading: field.to_owned(),
        points: inside
            .iter()
            .map(|particle| (particle.position, fields(particle)[i]))
            .collect(),
        curve: exact.map_or_else(Vec::new, |exact| {
            (0..=points)
                .map(|p| (at(p), exact.at(at(p), outcome.time)[i]))
                .collect()
        }),
    };
    FIELDS.into_iter().enumerate().map(panel).collect()
}
