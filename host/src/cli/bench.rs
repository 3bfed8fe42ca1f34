//! `motes bench`.

use miette::IntoDiagnostic;

use super::Failure;
use super::arguments::BenchArguments;
use crate::benchmark::{CASES, measure};
use crate::scenario::shortened;

/// Measures the cases asked for.
pub(super) fn bench(arguments: &BenchArguments) -> Result<(), Failure> {
    let unknown = arguments
        .cases
        .iter()
        .find(|name| CASES.iter().all(|case| case.name != **name));
    if let Some(name) = unknown {
        return Err(Failure::Input(miette::miette!(
            help = "the cases are 1d, 2d and 3d",
            "unknown case `{}`",
            shortened(name)
        )));
    }
    let mut results = Vec::new();
    for case in CASES {
        if !arguments.cases.is_empty() && !arguments.cases.iter().any(|name| name == case.name) {
            continue;
        }
        let result = measure(case, &arguments.scalar, arguments.threads)
            .map_err(|error| Failure::Input(error.into()))?;
        if !arguments.json {
            let line = format!(
                "{}: {:.2} million particle updates/s ({}, {} particles, {:.1} neighbours, {} \
                 thread(s), {})",
                result.case,
                result.updates_per_second / 1e6,
                result.scalar,
                result.particles,
                result.neighbours,
                result.threads,
                result.instruction_set,
            );
            super::print(&format!("{line}\n"))?;
        }
        results.push(result);
    }
    if arguments.json {
        let json = serde_json::to_string(&results)
            .into_diagnostic()
            .map_err(Failure::Run)?;
        super::print(&format!("{json}\n"))?;
    }
    Ok(())
}
