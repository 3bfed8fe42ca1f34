//! `motes list`.

use super::Failure;
use crate::scenario::linear::System;
use crate::scenario::{AnyScenario, BUILT_IN, Source};

/// The headings, in their order.
const GROUPS: [&str; 3] = ["gas dynamics", "linear systems", "convection-diffusion"];

/// The heading that a scenario stands under.
fn group(scenario: &AnyScenario) -> &'static str {
    match scenario {
        AnyScenario::Gas(_) => GROUPS[0],
        AnyScenario::Linear(scenario) => match scenario.system {
            System::ConvectionDiffusion(_) => GROUPS[2],
            _ => GROUPS[1],
        },
    }
}

/// A rough time in words.
fn cost(seconds: f64) -> String {
    match seconds {
        s if s < 1.0 => "< 1 s".to_owned(),
        s if s < 60.0 => format!("{s:.0} s"),
        s => format!("{:.0} min", s / 60.0),
    }
}

/// Prints the built-in scenarios by what they solve, with dimension, particles and a rough time.
pub(super) fn list() -> Result<(), Failure> {
    let mut lines = GROUPS.map(|heading| format!("{heading}\n"));
    for built_in in BUILT_IN {
        let source = Source::BuiltIn(built_in.name.to_owned());
        let scenario = AnyScenario::read(source, &[]).map_err(Failure::input)?;
        let place = GROUPS
            .iter()
            .position(|heading| *heading == group(&scenario));
        lines[place.unwrap_or_default()] += &format!(
            "  {:<22} {}D {:>7} {:>6}  {}\n",
            scenario.name(),
            scenario.dimension(),
            scenario.particles(),
            cost(built_in.seconds),
            scenario.description()
        );
    }
    super::print(&format!(
        "{}\nParticles, and seconds in f64 on two cores. `motes show NAME` prints one.\n",
        lines.join("\n")
    ))
}
