//! From TOML text to a checked [`Scenario`].

use toml::de::DeTable;

use super::error::{Fault, ScenarioError};
use super::geometry;
use super::keys::ROOT;
use super::problem::Problem;
use super::section::{Bound, Section};
use super::*;

const POSITIVE: Bound = Bound {
    need: "> 0",
    holds: |value| value > 0.0,
    cure: "give a number larger than 0",
};

const NOT_NEGATIVE: Bound = Bound {
    need: ">= 0",
    holds: |value| value >= 0.0,
    cure: "give 0 or a positive number: a negative one would feed shocks instead of damping them",
};

const GAMMA: Bound = Bound {
    need: "> 1",
    holds: |value| value > 1.0,
    cure: "give the ratio of the specific heats, for example 1.4 for air or 1.6667 for argon",
};

const COURANT: Bound = Bound {
    need: "> 0 and at most 1",
    holds: |value| value > 0.0 && value <= 1.0,
    cure: "0.3 is safe; larger steps are faster and less stable",
};

const ARRANGEMENTS: &[(&str, Arrangement)] = &[("equal-mass", Arrangement::EqualMass)];

const SHAPES: &[(&str, CutOffShape)] = &[
    ("cubic-spline", CutOffShape::CubicSpline),
    ("quintic-spline", CutOffShape::QuinticSpline),
    ("wendland-c2", CutOffShape::WendlandC2),
    ("wendland-c4", CutOffShape::WendlandC4),
    ("wendland-c6", CutOffShape::WendlandC6),
    ("root-free", CutOffShape::RootFree),
];

const KINDS: &[(&str, ViscosityKind)] = &[
    ("pairwise", ViscosityKind::Pairwise),
    ("gingold_monaghan", ViscosityKind::GingoldMonaghan),
    ("von_neumann", ViscosityKind::VonNeumann),
    ("none", ViscosityKind::None),
];

const EXACT: &[(&str, Exact)] = &[("riemann", Exact::Riemann)];

/// Courant number where none is given.
const DEFAULT_COURANT: f64 = 0.3;

/// Rows of the time series where none are given.
const DEFAULT_SAMPLES: usize = 100;

/// The scenario that `text`, called `name`, describes.
pub(super) fn scenario(text: String, name: &str) -> Result<Scenario, ScenarioError> {
    let scenario = parsed(&text).map_err(|fault| fault.within(name, &text))?;
    Ok(Scenario { text, ..scenario })
}

fn parsed(text: &str) -> Result<Scenario, Fault> {
    let end = text.trim_end().len();
    let document = DeTable::parse(text).map_err(|error| {
        let message = error.message().to_owned();
        Fault::new(
            Problem::Syntax { message },
            error.span().unwrap_or(end..end),
        )
    })?;
    let root = Section::open(ROOT, document.get_ref(), end..end)?;
    let name = plain_name(&root)?;
    let description = label(&root, "description", "")?;
    let dimension = root.required("dimension")?.count(
        3,
        "1, 2 or 3",
        "give the number of directions of space",
    )?;
    let domain = geometry::domain(&root.required("domain")?.section()?, dimension)?;
    let regions = regions(&root, &domain.extent)?;
    let output = output(&root, &domain.extent, &regions)?;
    Ok(Scenario {
        name,
        description,
        dimension,
        units: units(&root)?,
        domain,
        regions,
        material: material(&root.required("material")?.section()?)?,
        resolution: resolution(&root.required("resolution")?.section()?)?,
        cut_off: cut_off(&root.required("cut-off")?.section()?)?,
        viscosity: viscosity(&root.required("viscosity")?.section()?)?,
        time: time(&root.required("time")?.section()?)?,
        output,
        text: String::new(),
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

fn regions(root: &Section<'_>, domain: &Extent) -> Result<Vec<Region>, Fault> {
    let entry = root.required("region")?;
    let entries = entry.list("one or more [[region]]")?;
    if entries.is_empty() {
        return Err(root.missing("region"));
    }
    let mut regions: Vec<Region> = Vec::with_capacity(entries.len());
    for entry in entries {
        let section = entry.section()?;
        let region = region(&section, domain)?;
        geometry::clear_of_overlap(&section, &region.extent, &regions)?;
        regions.push(region);
    }
    Ok(regions)
}

fn region(section: &Section<'_>, domain: &Extent) -> Result<Region, Fault> {
    Ok(Region {
        extent: geometry::extent_inside(section, domain)?,
        density: section.required("density")?.number(POSITIVE)?,
        velocity: section.required("velocity")?.vector(domain.lower.len())?,
        pressure: section.required("pressure")?.number(POSITIVE)?,
    })
}

fn material(section: &Section<'_>) -> Result<Material, Fault> {
    section
        .required("equation-of-state")?
        .choice(&[("ideal-gas", ())])?;
    let gamma = section.required("gamma")?.number(GAMMA)?;
    Ok(Material::IdealGas { gamma })
}

fn resolution(section: &Section<'_>) -> Result<Resolution, Fault> {
    let particles = section.required("particles")?.count(
        u32::MAX,
        "1 to 4294967295",
        "give the number of particles in the whole domain, for example 900",
    )?;
    let arrangement = section.required("arrangement")?.choice(ARRANGEMENTS)?;
    Ok(Resolution {
        particles,
        arrangement,
    })
}

fn cut_off(section: &Section<'_>) -> Result<CutOff, Fault> {
    let shape = section.required("name")?.choice(SHAPES)?;
    let width = match (section.optional("eta"), section.optional("epsilon")) {
        (Some(eta), None) => Width::Adaptive {
            eta: eta.number(POSITIVE)?,
        },
        (None, Some(epsilon)) => Width::Constant {
            epsilon: epsilon.number(POSITIVE)?,
        },
        (Some(_), Some(epsilon)) => return Err(epsilon.fault(Problem::Width { both: true })),
        (None, None) => return Err(Fault::new(Problem::Width { both: false }, section.span())),
    };
    Ok(CutOff { shape, width })
}

fn viscosity(section: &Section<'_>) -> Result<Viscosity, Fault> {
    let kind = section.required("kind")?.choice(KINDS)?;
    if kind == ViscosityKind::None {
        // So that `--set viscosity.kind=none` alone switches it off.
        return Ok(Viscosity {
            kind,
            alpha: 0.0,
            beta: 0.0,
        });
    }
    let alpha = section.required("alpha")?.number(NOT_NEGATIVE)?;
    let beta = section.required("beta")?.number(NOT_NEGATIVE)?;
    Ok(Viscosity { kind, alpha, beta })
}

fn time(section: &Section<'_>) -> Result<Time, Fault> {
    let end = section.required("end")?.number(POSITIVE)?;
    let courant = section.optional("courant");
    let courant = courant.map_or(Ok(DEFAULT_COURANT), |entry| entry.number(COURANT))?;
    Ok(Time { end, courant })
}

fn output(root: &Section<'_>, domain: &Extent, regions: &[Region]) -> Result<Output, Fault> {
    let mut output = Output {
        window: domain.clone(),
        samples: DEFAULT_SAMPLES,
        exact: None,
    };
    let Some(entry) = root.optional("output") else {
        return Ok(output);
    };
    let section = entry.section()?;
    if let Some(window) = section.optional("window") {
        output.window = geometry::extent_inside(&window.section()?, domain)?;
    }
    if let Some(samples) = section.optional("samples") {
        let cure = "give the number of rows of the time series, for example 100";
        output.samples = samples.count(u32::MAX, "1 to 4294967295", cure)?;
    }
    if let Some(exact) = section.optional("exact") {
        let chosen = exact.choice(EXACT)?;
        if let Some(reason) = geometry::not_riemann(regions) {
            return Err(exact.fault(Problem::NotRiemann { reason }));
        }
        output.exact = Some(chosen);
    }
    Ok(output)
}
