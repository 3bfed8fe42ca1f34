//! `motes suite`.

use std::path::Path;

use miette::IntoDiagnostic;

use super::Failure;
use super::arguments::{SUITE_FOLDER, SUITE_SCALARS, SuiteArguments, scalar};
use super::watch::{Interrupt, progress_bar};
use crate::engine::Threads;
use crate::experiment::ExperimentError;
use crate::io;
use crate::report::pictures::pictures;
use crate::report::suite::{Check, SuiteRow, failures, html, markdown, verdict};
use crate::run::{RunError, ScalarName};
use crate::scenario::shortened;
use crate::suite::{CASES, Case, Measured, SuiteError};

/// Runs the suite and writes its report; fails where a bound is missed.
pub(super) fn suite(arguments: &SuiteArguments) -> Result<(), Failure> {
    let cases = selected(&arguments.cases)?;
    let scalars = arguments
        .scalars
        .iter()
        .map(|name| scalar(name))
        .collect::<Result<Vec<_>, _>>()?;
    let out = &arguments.out;
    let images = out.join("images");
    // Locked to the end; what else lies there stays.
    let _folder = io::RunFolder::claim(out).map_err(Failure::input)?;
    io::writable(&images).map_err(|error| Failure::Input(error.into()))?;
    let mut engine =
        Threads::new(arguments.threads).map_err(|error| Failure::Input(error.into()))?;
    let runs: Vec<(&Case, ScalarName)> = cases
        .iter()
        .flat_map(|case| scalars.iter().map(move |scalar| (*case, *scalar)))
        .filter(|(case, scalar)| case.takes(scalar.name()))
        .collect();
    let interrupt = Interrupt::listen();
    engine.stop_on(interrupt.flag());
    let bar = progress_bar(
        arguments.json,
        1000 * runs.len() as u64,
        "{wide_bar} {percent}% {msg}",
    );
    let mut rows = Vec::new();
    for (case, scalar) in runs {
        bar.set_message(format!("{} in {}", case.name(), scalar.name()));
        let before = bar.position();
        let mut measure = |scalar: ScalarName| {
            case.measure(scalar, &mut engine, &mut |done| {
                bar.set_position(before + (1000.0 * done) as u64);
                interrupt.goes_on()
            })
        };
        if let Some(reason) = case.unfit(scalar.name()) {
            rows.push(stopped(case, scalar, reason, false));
        } else {
            match measure(scalar) {
                Ok(measured) => rows.push(with_picture(case, scalar, measured, &images)?),
                Err(SuiteError::Experiment(ExperimentError::Run(
                    error @ RunError::Interrupted { .. },
                ))) => {
                    return Err(Failure::Interrupted(error.into()));
                }
                // What 32 bits cannot hold, 64 may.
                Err(SuiteError::Experiment(ExperimentError::Run(error)))
                    if scalar.name().starts_with('q') =>
                {
                    rows.push(stopped(case, scalar, &error.to_string(), false));
                    let wide = super::arguments::scalar("q31.32")?;
                    match measure(wide) {
                        Ok(measured) => rows.push(measured.row),
                        Err(error) => rows.push(stopped(case, wide, &error.to_string(), true)),
                    }
                }
                Err(SuiteError::Experiment(ExperimentError::Run(error))) => {
                    rows.push(stopped(case, scalar, &error.to_string(), true));
                }
                Err(error) => return Err(Failure::Run(error.into())),
            }
        }
        bar.set_position(before + 1000);
    }
    bar.finish_and_clear();
    report(arguments, &rows)
}

/// The cases asked for; all where none are.
fn selected(names: &[String]) -> Result<Vec<&'static Case>, Failure> {
    if names.is_empty() {
        return Ok(CASES.iter().collect());
    }
    let mut cases = Vec::new();
    for name in names {
        let before = cases.len();
        cases.extend(CASES.iter().filter(|case| case.scenario == name));
        if cases.len() == before {
            let mut known: Vec<_> = CASES.iter().map(|case| case.scenario).collect();
            known.dedup();
            return Err(Failure::Input(miette::miette!(
                help = format!("it has {}", known.join(", ")),
                "`{}` is not in the suite",
                shortened(name)
            )));
        }
    }
    Ok(cases)
}

/// Writes the picture of a run in f64 and puts its name into the row.
fn with_picture(
    case: &Case,
    scalar: ScalarName,
    measured: Measured,
    images: &Path,
) -> Result<SuiteRow, Failure> {
    let Measured {
        mut row,
        experiment,
    } = measured;
    if scalar == ScalarName::F64 {
        // The map where there is one: it says more of a plane than a line does.
        let last = pictures(&experiment).map_err(Failure::Run)?.pop();
        if let Some((_, picture)) = last {
            let name = format!("{}.svg", case.file_name());
            io::write_text(&images.join(&name), &picture)
                .map_err(|error| Failure::Run(error.into()))?;
            row.picture = Some(format!("images/{name}"));
        }
    }
    Ok(row)
}

/// The row of a run that was not made or did not reach its end; `missed`: though it should
/// have.
fn stopped(case: &Case, scalar: ScalarName, reason: &str, missed: bool) -> SuiteRow {
    let check = Check {
        what: "end of the run".to_owned(),
        measured: f64::NAN,
        bound: 1.0,
        reason: "a run that stops has no errors to tell".to_owned(),
        lower: true,
    };
    SuiteRow {
        scenario: case.name(),
        scalar: scalar.name().to_owned(),
        dimension: case.dimension,
        particles: 0,
        steps: 0,
        seconds: 0.0,
        smallest_step: 0.0,
        checks: missed.then_some(check).into_iter().collect(),
        energy_drift: f64::NAN,
        momentum_drift: f64::NAN,
        digest: String::new(),
        note: Some(format!("not run in {}: {reason}", scalar.name())),
        picture: None,
    }
}

fn report(arguments: &SuiteArguments, rows: &[SuiteRow]) -> Result<(), Failure> {
    let out = &arguments.out;
    let mut command = "cargo run --release -- suite".to_owned();
    for case in &arguments.cases {
        command += &format!(" {case}");
    }
    if arguments.scalars.join(",") != SUITE_SCALARS {
        command += &format!(" --scalars {}", arguments.scalars.join(","));
    }
    if out != Path::new(SUITE_FOLDER) {
        command += &format!(" --out {}", out.display());
    }
    let text = |name: &str, text: &str| {
        io::write_text(&out.join(name), text).map_err(|error| Failure::Run(error.into()))
    };
    text("accuracy.md", &markdown(rows, &command))?;
    text("accuracy.html", &html(rows, &command))?;
    if arguments.json {
        let json = serde_json::to_string(rows)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        super::print(&format!("{json}\n"))?;
    } else {
        for row in rows {
            let checks: Vec<String> = row.checks.iter().map(ToString::to_string).collect();
            let note = row.note.as_deref().filter(|_| row.is_refused());
            let line = format!("{:<28}{:<8}{}", row.scenario, row.scalar, checks.join(", "));
            super::print(&format!("{line}{}\n", note.unwrap_or_default()))?;
        }
        super::print(&format!(
            "report     {}\n{}\n",
            out.join("accuracy.md").display(),
            verdict(rows)
        ))?;
    }
    match failures(rows) {
        0 => Ok(()),
        missed => Err(Failure::Run(miette::miette!(
            help = format!("they are marked in {}", out.join("accuracy.md").display()),
            "{missed} bound(s) missed"
        ))),
    }
}
