//! From TOML text to a checked scenario.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeTable;

use super::error::{Fault, ScenarioError};
use super::files::Files;
use super::keys::{Family, ROOT};
use super::problem::Problem;
use super::section::Section;
use super::source::Source;
use super::{AnyScenario, Arrangement, Domain, Gas, LinearScenario, Scenario, Units};
use super::{
    cut_off, geometry, inflow, linear, material, method, output, profile, region, resolution, set,
    tolerance,
};

/// Reads a source with the `overrides` on top, through `parsed`: it gets the text and
/// where the files are that the text names.
pub(super) fn read<T>(
    source: &Source,
    overrides: &[String],
    parsed: impl FnOnce(&str, Files<'_>) -> Result<T, Fault>,
) -> Result<T, ScenarioError> {
    let (mut text, mut name) = (source.text()?, source.to_string());
    if !overrides.is_empty() {
        text = set::with_overrides(&text, &name, overrides)?;
        name.push_str(" after --set");
    }
    parsed(&text, source.files()).map_err(|fault| fault.within(&name, &text))
}

/// A scenario of either family.
pub(super) fn any(text: &str, files: Files<'_>) -> Result<AnyScenario, Fault> {
    let document = document(text)?;
    let (family, _) = family(&document);
    Ok(match family {
        Family::Gas => AnyScenario::Gas(Box::new(gas(text, files)?)),
        Family::Linear => AnyScenario::Linear(Box::new(linear(text, files)?)),
    })
}

/// A scenario that describes a gas.
pub(super) fn gas(text: &str, files: Files<'_>) -> Result<Scenario, Fault> {
    let document = document(text)?;
    scenario(&root(text, &document, Family::Gas)?, files, text)
}

/// A scenario that describes a linear system.
pub(super) fn linear(text: &str, files: Files<'_>) -> Result<LinearScenario, Fault> {
    let document = document(text)?;
    linear::scenario(&root(text, &document, Family::Linear)?, files, text)
}

fn document(text: &str) -> Result<Spanned<DeTable<'_>>, Fault> {
    DeTable::parse(text).map_err(|error| {
        let end = text.trim_end().len();
        let message = error.message().to_owned();
        let span = error.span().unwrap_or(end..end);
        Fault::new(Problem::Syntax { message }, span)
    })
}

/// The family that a text is of, and where it says so.
fn family(document: &Spanned<DeTable<'_>>) -> (Family, Option<Range<usize>>) {
    let mut keys = document.get_ref().keys();
    let system = keys.find(|key| key.get_ref() == "system");
    let span = system.map(|system| system.span());
    (Family::of(span.is_some()), span)
}

/// The keys above all sections, of a text that must be of a family.
fn root<'a>(
    text: &str,
    document: &'a Spanned<DeTable<'a>>,
    wanted: Family,
) -> Result<Section<'a>, Fault> {
    let end = text.trim_end().len();
    let (family, span) = family(document);
    if family != wanted {
        let problem = Problem::WrongFamily { family };
        return Err(Fault::new(problem, span.unwrap_or(end..end)));
    }
    Section::open(family, ROOT, document.get_ref(), end..end)
}

/// What gases and linear systems have in common.
pub(super) struct Heading {
    pub name: String,
    pub description: String,
    pub dimension: usize,
    pub units: Units,
    pub domain: Domain,
}

/// The keys above all sections, `[units]` and `[domain]`.
pub(super) fn heading(root: &Section<'_>) -> Result<Heading, Fault> {
    let name = plain_name(root)?;
    let description = label(root, "description", "")?;
    let dimension = root.required("dimension")?.count(
        3,
        "1, 2 or 3",
        "give the number of directions of space",
    )?;
    let domain = geometry::domain(&root.required("domain")?.section()?, dimension)?;
    Ok(Heading {
        name,
        description,
        dimension,
        units: units(root)?,
        domain,
    })
}

fn scenario(root: &Section<'_>, files: Files<'_>, text: &str) -> Result<Scenario, Fault> {
    let section = |key| root.required(key)?.section();
    let heading = heading(root)?;
    let (dimension, domain) = (heading.dimension, heading.domain);
    let gas = state(root, &domain)?;
    let resolution = resolution::resolution(
        &section("resolution")?,
        files.folder(),
        &domain,
        gas.profile.as_ref(),
    )?;
    // A file of particles says itself how the gas is.
    let described = !gas.regions.is_empty() || gas.profile.is_some();
    if !described && !matches!(resolution.arrangement, Arrangement::File(_)) {
        return Err(Fault::new(Problem::Gas { both: false }, root.span()));
    }
    let output = output::output(root, &domain.extent, &gas)?;
    inflow::check_output(root, &domain, &output)?;
    Ok(Scenario {
        name: heading.name,
        description: heading.description,
        dimension,
        units: heading.units,
        inflow: inflow::inflow(root, &domain, &gas.materials)?,
        domain,
        regions: gas.regions,
        profile: gas.profile,
        materials: gas.materials,
        deposits: gas.deposits,
        resolution,
        weights: method::weights(root)?,
        cut_off: cut_off::of_gas(root, dimension)?,
        viscosity: method::viscosity(root)?,
        conduction: method::conduction(root)?,
        diffusion: method::diffusion(root)?,
        acceleration: method::acceleration(root, dimension)?,
        time: method::time(&section("time")?)?,
        tolerances: tolerance::of_gas(root, output.exact.is_some())?,
        output,
        text: text.to_owned(),
    })
}

/// What there is at t = 0.
fn state(root: &Section<'_>, domain: &Domain) -> Result<Gas, Fault> {
    let materials = material::materials(root)?;
    let (region, profile) = (root.optional("region"), root.optional("profile"));
    if let (Some(_), Some(profile)) = (&region, &profile) {
        return Err(profile.fault(Problem::Gas { both: true }));
    }
    Ok(Gas {
        regions: match region {
            Some(entry) => region::regions(&entry, &domain.extent, &materials)?,
            None => Vec::new(),
        },
        profile: match profile {
            Some(entry) => Some(profile::profile(&entry, domain, &materials)?),
            None => None,
        },
        deposits: region::deposits(root, &domain.extent, &materials)?,
        materials,
    })
}

fn plain_name(root: &Section<'_>) -> Result<String, Fault> {
    let entry = root.required("name")?;
    let name = entry.text()?.to_owned();
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if name.is_empty() || !name.chars().all(plain) {
        return Err(entry.fault(Problem::NotPlain { name }));
    }
    Ok(name)
}

fn label(section: &Section<'_>, key: &'static str, default: &str) -> Result<String, Fault> {
    let text = section
        .optional(key)
        .map_or(Ok(default), |entry| entry.text())?;
    Ok(text.to_owned())
}

fn units(root: &Section<'_>) -> Result<Units, Fault> {
    let Some(entry) = root.optional("units") else {
        let one = || "1".to_owned();
        return Ok(Units {
            length: one(),
            mass: one(),
            time: one(),
        });
    };
    let section = entry.section()?;
    Ok(Units {
        length: label(&section, "length", "1")?,
        mass: label(&section, "mass", "1")?,
        time: label(&section, "time", "1")?,
    })
}
