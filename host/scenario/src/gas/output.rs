//! What is written and measured.

use crate::Extent;
use crate::bound::{NOT_NEGATIVE, POSITIVE};
use crate::define::Definitions;
use crate::error::Fault;
use crate::output::{DEFAULT_SAMPLES, Snapshots, exact_times, samples, snapshots, window};
use crate::section::Section;

use super::Gas;
use super::material::EquationOfState;
use super::profile::{StateFormulas, state_formulas};
use super::region::riemann_direction;

/// What is written and measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Where errors are measured; in the domain.
    pub window: Extent,
    /// Rows of the time series, equally spaced in time, at least 1.
    pub samples: usize,
    /// The exact solution to compare with.
    pub exact: Option<Exact>,
    /// Those of [`Exact::Formula`].
    pub formulas: Option<StateFormulas>,
    /// Where in the window errors are measured, if not everywhere.
    pub ring: Option<Ring>,
    /// States on the way, if any are written.
    pub snapshots: Option<Snapshots>,
    /// Whether steps are shortened so that rows of the time series and snapshots have their own
    /// times.
    pub exact_times: bool,
}

/// A solution to compare with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exact {
    /// The Riemann problem: two boxes that touch across a face.
    Riemann,
    /// The point explosion: one deposit in one region.
    Sedov,
    /// The solution that the profile has.
    Profile,
    /// A converged finite-volume run of the same problem: one dimension.
    Reference,
    /// Viscous flow between two walls that the gas sticks to, from a uniform start.
    Channel,
    /// What formulas of place and time say: [`Output::formulas`].
    Formula,
}

/// The points at a distance in `[inner, outer]` from a centre.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    /// The origin unless given.
    pub center: Vec<f64>,
    /// >= 0.
    pub inner: f64,
    /// Above `inner`.
    pub outer: f64,
}

const EXACT: &[(&str, Exact)] = &[
    ("riemann", Exact::Riemann),
    ("sedov", Exact::Sedov),
    ("profile", Exact::Profile),
    ("reference", Exact::Reference),
    ("channel", Exact::Channel),
];

/// `[output]`.
pub(super) fn output(
    root: &Section<'_>,
    domain: &Extent,
    gas: &Gas,
    definitions: &Definitions<'_>,
) -> Result<Output, Fault> {
    let mut output = Output {
        window: domain.clone(),
        samples: DEFAULT_SAMPLES,
        exact: None,
        formulas: None,
        ring: None,
        snapshots: None,
        exact_times: false,
    };
    let Some(entry) = root.optional("output") else {
        return Ok(output);
    };
    let section = entry.section()?;
    output.window = window(&section, domain)?;
    output.samples = samples(&section)?;
    output.snapshots = snapshots(&section)?;
    output.exact_times = exact_times(&section)?;
    let exact = section.optional("exact");
    if let Some(entry) = exact.as_ref().filter(|entry| entry.is_section()) {
        let section = entry.section()?;
        let law = &gas.materials[0].law;
        let formulas = state_formulas(&section, law, domain.lower.len(), definitions)?;
        output.exact = Some(Exact::Formula);
        output.formulas = Some(formulas);
    } else if let Some(entry) = exact {
        let chosen = entry.choice(EXACT)?;
        if let Err((reason, cure)) = exists(chosen, domain.lower.len(), gas) {
            return Err(entry.does_not_fit(reason, cure));
        }
        output.exact = Some(chosen);
    }
    if let Some(entry) = section.optional("ring") {
        output.ring = Some(ring(&entry.section()?, domain.lower.len())?);
    }
    Ok(output)
}

/// That the solution exists for this gas, or why not and what it takes.
fn exists(exact: Exact, dimension: usize, gas: &Gas) -> Result<(), (String, &'static str)> {
    match exact {
        Exact::Riemann => {
            let cure = "it needs exactly two regions: boxes that touch across a face and span \
                        the same in the other directions; otherwise leave `exact` out";
            riemann_direction(&gas.regions).map_err(|reason| (reason, cure))?;
            let deposits = gas.deposits.len();
            if deposits > 0 {
                return Err((format!("the number of deposits is {deposits}"), cure));
            }
            Ok(())
        }
        Exact::Sedov => {
            let cure = "it needs one region, one deposit and an ideal gas; otherwise leave \
                        `exact` out";
            if gas.regions.len() != 1 || gas.deposits.len() != 1 {
                let (regions, deposits) = (gas.regions.len(), gas.deposits.len());
                let reason =
                    format!("the number of regions is {regions}, that of deposits {deposits}");
                return Err((reason, cure));
            }
            match gas.materials[gas.regions[0].material].law {
                EquationOfState::IdealGas { .. } => Ok(()),
                law => Err((format!("the region is {}", law.name()), cure)),
            }
        }
        Exact::Profile => {
            let cure = "it needs a [profile] of kind noh, sound-wave, yee-vortex or gresho; \
                        otherwise leave `exact` out";
            match &gas.profile {
                None => Err(("there is no [profile]".to_owned(), cure)),
                Some(profile) if !profile.has_solution() => {
                    Err((format!("no solution of {} is known", profile.name()), cure))
                }
                Some(_) => Ok(()),
            }
        }
        Exact::Reference if dimension != 1 => Err((
            format!("dimension = {dimension}"),
            "it needs dimension = 1; otherwise leave `exact` out",
        )),
        Exact::Reference if gas.regions.is_empty() && gas.profile.is_none() => Err((
            "the gas comes from a file".to_owned(),
            "it needs [[region]] or [profile]; otherwise leave `exact` out",
        )),
        Exact::Reference => Ok(()),
        Exact::Channel if gas.regions.len() != 1 || gas.profile.is_some() => Err((
            format!("the number of regions is {}", gas.regions.len()),
            "it needs one region that fills the domain; otherwise leave `exact` out",
        )),
        Exact::Channel | Exact::Formula => Ok(()),
    }
}

fn ring(section: &Section<'_>, dimension: usize) -> Result<Ring, Fault> {
    let inner = section.required("inner")?.number(NOT_NEGATIVE)?;
    let entry = section.required("outer")?;
    let outer = entry.number(POSITIVE)?;
    if outer <= inner {
        let reason = format!("output.ring.inner = {inner}");
        return Err(entry.does_not_fit(reason, "give an outer radius above the inner one"));
    }
    let center = section.optional("center");
    let center = center.map_or(Ok(vec![0.0; dimension]), |entry| entry.vector(dimension))?;
    Ok(Ring {
        center,
        inner,
        outer,
    })
}

/// That there is a channel where its solution is asked for.
pub(super) fn check_channel(
    root: &Section<'_>,
    output: &Output,
    channel: Result<usize, &'static str>,
) -> Result<(), Fault> {
    let (Some(Exact::Channel), Err(reason)) = (output.exact, channel) else {
        return Ok(());
    };
    let entry = root.required("output")?.section()?.required("exact")?;
    let cure = "it needs a [[wall]] with slip = \"none\" at both ends of one direction, the others \
                periodic, one region, and nothing that moves or acts across the walls";
    Err(entry.does_not_fit(reason.to_owned(), cure))
}
