//! From TOML text to a checked scenario.

use super::document::Document;
use super::error::{Fault, Place, ScenarioError};
use super::keys::Family;
use super::problem::Problem;
use super::section::Section;
use super::source::Source;
use super::{AnyScenario, Arrangement, Domain, Gas, LinearScenario, Scenario, Units};
use super::{
    cut_off, geometry, inflow, linear, material, method, output, profile, region, resolution, set,
    tolerance,
};

/// Reads a source with the `overrides` on top, through `parsed`. Each text is parsed once: that of
/// the source, and what each of the overrides makes of it.
pub(super) fn read<T>(
    source: &Source,
    overrides: &[String],
    parsed: impl FnOnce(&Document<'_>) -> Result<T, Fault>,
) -> Result<T, ScenarioError> {
    let (mut text, mut name) = (source.text()?, source.to_string());
    for argument in overrides {
        let document = Document::parse(&text, source.files());
        let document = document.map_err(|fault| fault.within(&name, &text))?;
        text = set::changed(&document, argument).map_err(|problem| {
            let place = Place {
                name: "--set".to_owned(),
                text: argument.clone(),
                span: 0..argument.len(),
            };
            ScenarioError::new(*problem, place)
        })?;
    }
    if !overrides.is_empty() {
        name.push_str(" after --set");
    }
    Document::parse(&text, source.files())
        .and_then(|document| parsed(&document))
        .map_err(|fault| fault.within(&name, &text))
}

/// A scenario of either family.
pub(super) fn any(document: &Document<'_>) -> Result<AnyScenario, Fault> {
    Ok(match document.family() {
        Family::Gas => AnyScenario::Gas(Box::new(gas(document)?)),
        Family::Linear => AnyScenario::Linear(Box::new(linear(document)?)),
    })
}

/// A scenario that describes a linear system.
pub(super) fn linear(document: &Document<'_>) -> Result<LinearScenario, Fault> {
    let root = document.root(Family::Linear)?;
    linear::scenario(&root, document.files, document.text)
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

/// A scenario that describes a gas.
pub(super) fn gas(document: &Document<'_>) -> Result<Scenario, Fault> {
    let root = &document.root(Family::Gas)?;
    let section = |key| root.required(key)?.section();
    let heading = heading(root)?;
    let (dimension, domain) = (heading.dimension, heading.domain);
    let gas = state(root, &domain)?;
    let resolution = resolution::resolution(
        &section("resolution")?,
        document.files.folder(),
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
        text: document.text.to_owned(),
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
