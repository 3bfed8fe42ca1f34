//! How long a run lasts, and its steps.

use crate::scenario::bound::{COURANT, POSITIVE};
use crate::scenario::error::Fault;
use crate::scenario::section::Section;

/// How long, and in what steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Time {
    /// Duration of the run, > 0.
    pub end: f64,
    /// How a step is made.
    pub method: Method,
    /// Step / (width / wave speed), in (0, 1].
    pub courant: f64,
    /// The step, > 0, in place of the one that `courant` gives.
    pub step: Option<f64>,
    /// By how much the energy norm may grow beyond what the system allows, as a part of it,
    /// > 0.
    pub growth_margin: f64,
}

/// How a step is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The classical Runge-Kutta method: four stages, fourth order.
    Rk4,
    /// The strong-stability-preserving Runge-Kutta method: three stages, third order.
    SspRk3,
}

const METHODS: &[(&str, Method)] = &[("rk4", Method::Rk4), ("ssp-rk3", Method::SspRk3)];

impl Method {
    /// Its name in a scenario.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::SspRk3 => "ssp-rk3",
        }
    }
}

/// `[time]`.
pub(super) fn time(section: &Section<'_>) -> Result<Time, Fault> {
    let method = section.optional("method");
    Ok(Time {
        end: section.number("end", POSITIVE)?,
        method: method.map_or(Ok(Method::Rk4), |entry| entry.choice(METHODS))?,
        courant: section.number_or("courant", 0.5, COURANT)?,
        step: match section.optional("step") {
            Some(entry) => Some(entry.number(POSITIVE)?),
            None => None,
        },
        growth_margin: section.number_or("growth-margin", 0.1, POSITIVE)?,
    })
}
