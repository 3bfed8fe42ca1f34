//! A scenario of either family.

use std::path::Path;

use crate::check;
use crate::error::ScenarioError;
use crate::linear::{self, LinearScenario, Measured, Probe, Series};
use crate::source::Source;
use crate::tolerance::Tolerance;
use crate::{Arrangement, Extent, Family, Ring, Scenario, Snapshots, Units};

/// A scenario, whatever it describes.
#[derive(Debug, Clone, PartialEq)]
pub enum AnyScenario {
    /// A gas.
    Gas(Box<Scenario>),
    /// A linear first-order system.
    Linear(Box<LinearScenario>),
}

impl AnyScenario {
    /// Reads a scenario; `overrides` are `section.key=value` as given to `--set`,
    /// the later ones on top of the earlier.
    ///
    /// # Errors
    /// Whatever keeps the text from being a scenario: the first fault found, with
    /// its place and cure.
    pub fn read(source: Source, overrides: &[String]) -> Result<Self, ScenarioError> {
        check::read(&source, overrides, check::any)
    }

    /// What it describes.
    pub fn family(&self) -> Family {
        match self {
            Self::Gas(_) => Family::Gas,
            Self::Linear(_) => Family::Linear,
        }
    }

    /// Letters, digits, `-` and `_`: fit to name a file.
    pub fn name(&self) -> &str {
        match self {
            Self::Gas(scenario) => &scenario.name,
            Self::Linear(scenario) => &scenario.name,
        }
    }

    /// One line for lists and headings; may be empty.
    pub fn description(&self) -> &str {
        match self {
            Self::Gas(scenario) => &scenario.description,
            Self::Linear(scenario) => &scenario.description,
        }
    }

    /// 1, 2 or 3.
    pub fn dimension(&self) -> usize {
        match self {
            Self::Gas(scenario) => scenario.dimension,
            Self::Linear(scenario) => scenario.dimension,
        }
    }

    /// The TOML text after `--set`: reading it gives this scenario.
    pub fn text(&self) -> &str {
        match self {
            Self::Gas(scenario) => &scenario.text,
            Self::Linear(scenario) => &scenario.text,
        }
    }

    /// Labels of the units.
    pub fn units(&self) -> &Units {
        match self {
            Self::Gas(scenario) => &scenario.units,
            Self::Linear(scenario) => &scenario.units,
        }
    }

    /// Duration.
    pub fn end(&self) -> f64 {
        match self {
            Self::Gas(scenario) => scenario.time.end,
            Self::Linear(scenario) => scenario.time.end,
        }
    }

    /// Number of particles; 0 where they come from a file.
    pub fn particles(&self) -> usize {
        match self {
            Self::Gas(scenario) => scenario.resolution.particles,
            Self::Linear(scenario) => scenario.resolution.particles,
        }
    }

    /// The file that the particles come from, if they come from one.
    pub fn cloud_file(&self) -> Option<&Path> {
        match self {
            Self::Gas(scenario) => match &scenario.resolution.arrangement {
                Arrangement::File(path) => Some(path),
                _ => None,
            },
            Self::Linear(scenario) => match &scenario.resolution.arrangement {
                linear::Arrangement::File(path) => Some(path),
                _ => None,
            },
        }
    }

    /// Rows of the time series, at least 1.
    pub fn samples(&self) -> usize {
        match self {
            Self::Gas(scenario) => scenario.output.samples,
            Self::Linear(scenario) => scenario.output.samples,
        }
    }

    /// States on the way, if any are written.
    pub fn snapshots(&self) -> Option<Snapshots> {
        match self {
            Self::Gas(scenario) => scenario.output.snapshots,
            Self::Linear(scenario) => scenario.output.snapshots,
        }
    }

    /// Whether steps are shortened so that rows of the time series and snapshots have their own
    /// times.
    pub fn exact_times(&self) -> bool {
        match self {
            Self::Gas(scenario) => scenario.output.exact_times,
            Self::Linear(scenario) => scenario.output.exact_times,
        }
    }

    /// Where errors are measured.
    pub fn window(&self) -> &Extent {
        match self {
            Self::Gas(scenario) => &scenario.output.window,
            Self::Linear(scenario) => &scenario.output.window,
        }
    }

    /// Where in the window errors are measured, if not everywhere.
    pub fn ring(&self) -> Option<&Ring> {
        match self {
            Self::Gas(scenario) => scenario.output.ring.as_ref(),
            Self::Linear(_) => None,
        }
    }

    /// Whether to compare with an exact solution.
    pub fn has_exact(&self) -> bool {
        match self {
            Self::Gas(scenario) => scenario.output.exact.is_some(),
            Self::Linear(scenario) => scenario.output.exact.is_some(),
        }
    }

    /// The largest errors that a run may have, by the names of the fields.
    pub fn tolerances(&self) -> Vec<Tolerance<String>> {
        fn named<F>(of: &[Tolerance<F>], name: impl Fn(&F) -> String) -> Vec<Tolerance<String>> {
            let named = of.iter().map(|tolerance| Tolerance {
                field: name(&tolerance.field),
                norm: tolerance.norm,
                value: tolerance.value,
                reason: tolerance.reason.clone(),
            });
            named.collect()
        }
        match self {
            Self::Gas(scenario) => named(&scenario.tolerances, |field| field.name().to_owned()),
            Self::Linear(scenario) => {
                let names = scenario.system.names(scenario.dimension);
                named(&scenario.tolerances, |field| match *field {
                    Measured::State => "state".to_owned(),
                    Measured::Reconstruction => "reconstruction".to_owned(),
                    Measured::Component(i) => names[i].clone(),
                })
            }
        }
    }

    /// Places where the smoothed solution is written at the end.
    pub fn probe(&self) -> Option<&Probe> {
        match self {
            Self::Gas(_) => None,
            Self::Linear(scenario) => scenario.output.probe.as_ref(),
        }
    }

    /// The series that drive walls, with the number of the component each is of.
    pub fn driven(&self) -> Vec<(usize, &Series)> {
        match self {
            Self::Gas(_) => Vec::new(),
            Self::Linear(scenario) => scenario.system.driven(),
        }
    }
}
