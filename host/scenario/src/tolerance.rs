//! What errors may be: `[tolerance.FIELD]`.

use crate::bound::POSITIVE;
use crate::error::Fault;
use crate::keys::TOLERANCE;
use crate::section::Section;

/// The largest error that a field may have; `F` names the fields.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerance<F = Field> {
    /// Of which field.
    pub field: F,
    /// In which norm.
    pub norm: Norm,
    /// > 0.
    pub value: f64,
    /// Where the value comes from; not empty.
    pub reason: String,
}

/// A field that is compared with the exact solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// Mass / length^dimension.
    Density,
    /// Length / time.
    Velocity,
    /// Density * velocity^2.
    Pressure,
    /// Internal energy per mass.
    Energy,
    /// Density * velocity.
    Momentum,
    /// Density * (energy + velocity^2 / 2).
    TotalEnergy,
    /// The velocity away from the center, where there is one.
    VelocityRadial,
    /// The velocity around it.
    VelocityAzimuthal,
}

/// A norm of an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Norm {
    /// Mean over the volume.
    L1,
    /// Root of the mean square.
    L2,
    /// Largest.
    Linf,
    /// Mean over the particles.
    Mean,
    /// Root of the mean square over the particles.
    Rms,
    /// Mean over the volume, over the same mean of the exact field.
    RelativeL1,
    /// Mean over the mass.
    MassL1,
}

impl Field {
    /// Its name in a scenario.
    pub fn name(self) -> &'static str {
        FIELDS
            .iter()
            .find(|(_, field)| *field == self)
            .map_or("", |(name, _)| name)
    }
}

impl Norm {
    /// Its name in a scenario.
    pub fn name(self) -> &'static str {
        NORMS
            .iter()
            .find(|(_, norm)| *norm == self)
            .map_or("", |(name, _)| name)
    }
}

const FIELDS: [(&str, Field); 8] = [
    ("density", Field::Density),
    ("velocity", Field::Velocity),
    ("pressure", Field::Pressure),
    ("energy", Field::Energy),
    ("momentum", Field::Momentum),
    ("total_energy", Field::TotalEnergy),
    ("velocity_radial", Field::VelocityRadial),
    ("velocity_azimuthal", Field::VelocityAzimuthal),
];

const NORMS: [(&str, Norm); 7] = [
    ("l1", Norm::L1),
    ("l2", Norm::L2),
    ("linf", Norm::Linf),
    ("mean", Norm::Mean),
    ("rms", Norm::Rms),
    ("relative_l1", Norm::RelativeL1),
    ("mass_l1", Norm::MassL1),
];

/// `[tolerance]` of a gas.
pub(super) fn of_gas(root: &Section<'_>, has_exact: bool) -> Result<Vec<Tolerance>, Fault> {
    let names = FIELDS.map(|(name, field)| (name.to_owned(), field));
    tolerances(root, has_exact, &names)
}

/// Refuses bounds of velocities about a center where there is none.
pub(super) fn check_center(root: &Section<'_>, has_center: bool) -> Result<(), Fault> {
    let Some(entry) = root.optional(TOLERANCE).filter(|_| !has_center) else {
        return Ok(());
    };
    let section = entry.section()?;
    let about = [Field::VelocityRadial, Field::VelocityAzimuthal];
    match about
        .iter()
        .find_map(|field| section.optional(field.name()))
    {
        None => Ok(()),
        Some(entry) => {
            let reason = "the solution is not round about a point".to_owned();
            let cure = "give a bound of `velocity`; vortices, Noh's and Sedov's problems in two and three \
                        dimensions have a center";
            Err(entry.does_not_fit(reason, cure))
        }
    }
}

/// `[tolerance]`: those of each field in the order of `fields` and [`NORMS`].
pub(super) fn tolerances<F: Copy>(
    root: &Section<'_>,
    has_exact: bool,
    fields: &[(String, F)],
) -> Result<Vec<Tolerance<F>>, Fault> {
    let Some(entry) = root.optional(TOLERANCE) else {
        return Ok(Vec::new());
    };
    let section = entry.section()?;
    if !has_exact {
        let reason = "there is no output.exact to be compared with".to_owned();
        return Err(entry.does_not_fit(reason, "add `exact` to [output], or take it out"));
    }
    section.is_among(fields.iter().map(|(name, _)| name.as_str()))?;
    let mut tolerances = Vec::new();
    for (name, field) in fields {
        if let Some(entry) = section.optional(name) {
            tolerances.extend(of_field(&entry.section()?, *field)?);
        }
    }
    Ok(tolerances)
}

/// `[tolerance.FIELD]`: a norm at least, and the reason.
fn of_field<F: Copy>(section: &Section<'_>, field: F) -> Result<Vec<Tolerance<F>>, Fault> {
    let entry = section.required("reason")?;
    let reason = entry.text()?.to_owned();
    if reason.trim().is_empty() {
        let cure = "say where the number comes from, as in reason = \"1.05 of the value \
                    measured at 900 particles\"";
        return Err(entry.does_not_fit("it is empty".to_owned(), cure));
    }
    let mut tolerances = Vec::new();
    for (name, norm) in NORMS {
        if let Some(entry) = section.optional(name) {
            tolerances.push(Tolerance {
                field,
                norm,
                value: entry.number(POSITIVE)?,
                reason: reason.clone(),
            });
        }
    }
    match tolerances.is_empty() {
        true => Err(section.missing("l1")),
        false => Ok(tolerances),
    }
}
