//! How long a run lasts, and its steps.

use super::System;
use crate::bound::{COURANT, NOT_NEGATIVE, POSITIVE};
use crate::entry::Entry;
use crate::error::Fault;
use crate::section::Section;

/// How long, and in what steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Time {
    /// Duration of the run, >= 0: at 0 the start is all there is.
    pub end: f64,
    /// How a step is made.
    pub method: Method,
    /// Step / (width / wave speed), in (0, 1].
    pub courant: f64,
    /// The step, > 0, in place of the one that `courant` gives.
    pub step: Option<f64>,
    /// How many stages a step of [`Method::Rkl2`] is made for, 3 to 255, odd; with `step` their
    /// number follows from it.
    pub stages: usize,
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
    /// The Runge-Kutta-Legendre method (Meyer, Balsara and Aslam, J. Comput. Phys. 257 (2014)
    /// 594): second order, any odd number of stages from 3 on, for diffusion.
    Rkl2,
}

const METHODS: &[(&str, Method)] = &[
    ("rk4", Method::Rk4),
    ("ssp-rk3", Method::SspRk3),
    ("rkl2", Method::Rkl2),
];

impl Method {
    /// Its name in a scenario.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::SspRk3 => "ssp-rk3",
            Self::Rkl2 => "rkl2",
        }
    }
}

/// The number of stages unless told.
const STAGES: usize = 9;

/// `[time]` of a system.
pub(super) fn time(section: &Section<'_>, system: &System) -> Result<Time, Fault> {
    let method = method(section, system)?;
    let step = section.optional("step");
    Ok(Time {
        end: section.number("end", NOT_NEGATIVE)?,
        method,
        courant: section.number_or("courant", 0.5, COURANT)?,
        stages: match section.optional("stages") {
            Some(entry) => stages(&entry, method, step.as_ref())?,
            None => STAGES,
        },
        step: step.map(|entry| entry.number(POSITIVE)).transpose()?,
        growth_margin: section.number_or("growth-margin", 0.1, POSITIVE)?,
    })
}

fn method(section: &Section<'_>, system: &System) -> Result<Method, Fault> {
    let is_diffusion = matches!(system, System::ConvectionDiffusion(_));
    let Some(entry) = section.optional("method") else {
        let usual = [Method::Rk4, Method::Rkl2][usize::from(is_diffusion)];
        return Ok(usual);
    };
    let method = entry.choice(METHODS)?;
    if method == Method::Rkl2 && !is_diffusion {
        let reason = "its stages reach far along the negative real axis and not along the \
                      imaginary one, where waves are"
            .to_owned();
        let cure = "choose rk4 or ssp-rk3: rkl2 is for convection-diffusion";
        return Err(entry.does_not_fit(reason, cure));
    }
    Ok(method)
}

fn stages(entry: &Entry<'_>, method: Method, step: Option<&Entry<'_>>) -> Result<usize, Fault> {
    if method != Method::Rkl2 {
        let reason = format!("the number of stages of {} is its own", method.name());
        return Err(entry.does_not_fit(reason, "take `stages` out, or set method = \"rkl2\""));
    }
    if step.is_some() {
        let reason = "time.step is there, from which the number of stages follows".to_owned();
        return Err(entry.does_not_fit(reason, "keep one: step (a time) or stages"));
    }
    let (need, cure) = ("3 to 255, odd", "give an odd number, for example 9");
    let stages = entry.whole(3..=255_usize, need, cure)?;
    if stages.is_multiple_of(2) {
        let reason =
            "it is even: then the longest stable step does not damp the shortest waves".to_owned();
        return Err(entry.does_not_fit(reason, cure));
    }
    Ok(stages)
}
