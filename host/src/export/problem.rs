//! The numbers of a convection-diffusion problem as Rust source.

use std::fmt::Write;

use motes_core::equation::diffusion::{Conductor, Drive, DrivenCondition, NamedProblem};

use super::module::Module;

/// Where the core has the problems.
pub(super) const DIFFUSION: &str = "motes_core::equation::diffusion";

/// The numbers of a problem: the fields of a struct literal, each behind so many blanks.
pub(super) fn numbers<const D: usize, const P: usize>(
    module: &mut Module,
    problem: &NamedProblem<'_, f64, D, P>,
    indent: usize,
) -> String {
    module.import(
        DIFFUSION,
        [
            "Conductor",
            "DrivenCondition",
            "Modulation",
            "NamedProblem",
            "Reaction",
        ],
    );
    if problem
        .walls
        .iter()
        .flatten()
        .flatten()
        .any(|wall| drive(wall).is_some())
    {
        module.import(DIFFUSION, ["Drive"]);
    }
    let NamedProblem {
        diffusivity,
        conductor,
        modulation,
        tensor,
        reaction,
        walls,
    } = problem;
    let margin = " ".repeat(indent);
    let conductor = match conductor {
        Conductor::Layers { bounds, factors } => {
            format!("Conductor::Layers {{ bounds: &{bounds:?}, factors: &{factors:?} }}")
        }
        plain => format!("Conductor::{plain:?}"),
    };
    let (amplitude, frequency) = (modulation.amplitude, modulation.frequency);
    let mut text = format!(
        "{margin}diffusivity: {diffusivity:?},
{margin}conductor: {conductor},
{margin}modulation: Modulation {{ amplitude: {amplitude:?}, frequency: {frequency:?} }},
{margin}tensor: {tensor:?},
{margin}reaction: Reaction::{reaction:?},
{margin}walls: ["
    );
    for (axis, ends) in walls.iter().enumerate() {
        text += if axis > 0 { ", [\n" } else { "[\n" };
        for end in ends {
            let end: Vec<String> = end.iter().map(|wall| condition(wall, indent)).collect();
            let _ = writeln!(text, "{margin}    [{}],", end.join(", "));
        }
        let _ = write!(text, "{margin}]");
    }
    text + "],\n"
}

fn condition(wall: &DrivenCondition<'_, f64>, indent: usize) -> String {
    let driven = match drive(wall) {
        None => String::new(),
        Some(Drive::Constant(value)) => format!("Drive::Constant({value:?})"),
        Some(Drive::Series(points)) => {
            let margin = " ".repeat(indent + 4);
            let rows = points
                .iter()
                .map(|point| format!("{margin}    {point:?},\n"));
            format!("Drive::Series(&[\n{}{margin}])", rows.collect::<String>())
        }
    };
    match wall {
        DrivenCondition::NoFlux => "DrivenCondition::NoFlux".to_owned(),
        DrivenCondition::Value(_) => format!("DrivenCondition::Value({driven})"),
        DrivenCondition::Flux(_) => format!("DrivenCondition::Flux({driven})"),
        DrivenCondition::Exchange { rate, .. } => {
            format!("DrivenCondition::Exchange {{ rate: {rate:?}, outside: {driven} }}")
        }
    }
}

/// What drives a wall.
fn drive<'a, 's>(wall: &'a DrivenCondition<'s, f64>) -> Option<&'a Drive<'s, f64>> {
    match wall {
        DrivenCondition::NoFlux => None,
        DrivenCondition::Value(drive)
        | DrivenCondition::Flux(drive)
        | DrivenCondition::Exchange { outside: drive, .. } => Some(drive),
    }
}

/// Adds how much room the lists of a problem take: `POINTS` and `LAYERS`.
pub(super) fn room<const D: usize, const P: usize>(
    module: &mut Module,
    problem: &NamedProblem<'_, f64, D, P>,
    walls: &str,
) {
    let points = |wall: &DrivenCondition<'_, f64>| match drive(wall) {
        Some(Drive::Series(points)) => points.len(),
        _ => 0,
    };
    let points: usize = problem.walls.iter().flatten().flatten().map(points).sum();
    let layers = match problem.conductor {
        Conductor::Layers { factors, .. } => factors.len(),
        _ => 0,
    };
    let doc = format!("Points of the series at {walls} walls.");
    module.constant(&doc, "POINTS", "usize", &points.to_string());
    module.constant(
        "Layers of the conductor.",
        "LAYERS",
        "usize",
        &layers.to_string(),
    );
}
