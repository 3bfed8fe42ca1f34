//! From TOML text to a checked [`Scenario`].

use std::path::Path;

use toml::de::DeTable;

use super::error::{Fault, ScenarioError};
use super::keys::ROOT;
use super::problem::Problem;
use super::section::Section;
use super::{Arrangement, Domain};
use super::{Gas, Scenario, Units};
use super::{
    cut_off, geometry, inflow, material, method, output, profile, region, resolution, tolerance,
};

/// The scenario that `text`, called `name`, describes; files it names are in `folder`.
pub(super) fn scenario(text: String, name: &str, folder: &Path) -> Result<Scenario, ScenarioError> {
    let scenario = parsed(&text, folder).map_err(|fault| fault.within(name, &text))?;
    Ok(Scenario { text, ..scenario })
}

fn parsed(text: &str, folder: &Path) -> Result<Scenario, Fault> {
    let end = text.trim_end().len();
    let document = DeTable::parse(text).map_err(|error| {
        let message = error.message().to_owned();
        Fault::new(
            Problem::Syntax { message },
            error.span().unwrap_or(end..end),
        )
    })?;
    let root = Section::open(ROOT, document.get_ref(), end..end)?;
    let section = |key| root.required(key)?.section();
    let name = plain_name(&root)?;
    let description = label(&root, "description", "")?;
    let dimension = root.required("dimension")?.count(
        3,
        "1, 2 or 3",
        "give the number of directions of space",
    )?;
    let domain = geometry::domain(&section("domain")?, dimension)?;
    let gas = gas(&root, &domain)?;
    let resolution = resolution::resolution(
        &section("resolution")?,
        folder,
        &domain,
        gas.profile.as_ref(),
    )?;
    // A file of particles says itself how the gas is.
    let described = !gas.regions.is_empty() || gas.profile.is_some();
    if !described && !matches!(resolution.arrangement, Arrangement::File(_)) {
        return Err(Fault::new(Problem::Gas { both: false }, root.span()));
    }
    let output = output::output(&root, &domain.extent, &gas)?;
    inflow::check_output(&root, &domain, &output)?;
    Ok(Scenario {
        name,
        description,
        dimension,
        units: units(&root)?,
        inflow: inflow::inflow(&root, &domain, &gas.materials)?,
        domain,
        regions: gas.regions,
        profile: gas.profile,
        materials: gas.materials,
        deposits: gas.deposits,
        resolution,
        weights: method::weights(&root)?,
        cut_off: cut_off::cut_off(&root, dimension)?,
        viscosity: method::viscosity(&root)?,
        conduction: method::conduction(&root)?,
        diffusion: method::diffusion(&root)?,
        acceleration: method::acceleration(&root, dimension)?,
        time: method::time(&section("time")?)?,
        tolerances: tolerance::tolerances(&root, &output)?,
        output,
        text: String::new(),
    })
}

/// What there is at t = 0.
fn gas(root: &Section<'_>, domain: &Domain) -> Result<Gas, Fault> {
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
