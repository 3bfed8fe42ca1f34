//! What acts on the particles beside the pressure, and the steps of time.

use crate::bound::{COURANT, DAMPING, NOT_NEGATIVE, POSITIVE};
use crate::entry::Entry;
use crate::error::Fault;
use crate::geometry::AXES;
use crate::section::Section;
use crate::{Domain, Side};

/// What a particle's weight in the sums is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weights {
    /// `w_k = m_k/rho_k`, the density a sum of masses.
    Mass,
    /// `w_k = 1/n_k`, `n` a sum over numbers: for unequal masses side by side.
    Number,
}

/// What the forces of pressure act along.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GradientKind {
    /// The line of centres, as the gradient of the cut-off does.
    Plain,
    /// A gradient that is exact for linear fields.
    LinearExact,
}

/// The pseudo-viscosity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viscosity {
    /// Its form.
    pub kind: ViscosityKind,
    /// Factor of the linear term, >= 0; 0 for `ViscosityKind::None`. With a switch the
    /// largest it takes.
    pub alpha: f64,
    /// Factor of the quadratic term, >= 0; 0 for `ViscosityKind::None`.
    pub beta: f64,
    /// Lowers `alpha` away from shocks.
    pub switch: Option<Switch>,
    /// Balsara's factor: lowers both terms where the flow shears.
    pub balsara: bool,
}

/// A switch of `alpha`: it rises in shocks and decays behind them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Switch {
    /// The `alpha` that it decays to; in [0, alpha].
    pub minimum: f64,
    /// How fast, in sound speeds per width of the cut-off, > 0.
    pub decay: f64,
}

/// The form of the pseudo-viscosity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ViscosityKind {
    /// Along the line of centres, with the signal speed of the pair.
    Pairwise,
    /// Gingold and Monaghan 1983.
    GingoldMonaghan,
    /// Added to the pressure where the gas is compressed.
    VonNeumann,
    /// Pairwise, on velocities reconstructed at the midpoint under a slope limiter.
    Limited,
    /// No pseudo-viscosity.
    None,
}

/// Physical diffusion, length^2/time: that of Navier, Stokes and Fourier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diffusion {
    /// Kinematic shear viscosity, >= 0.
    pub viscosity: f64,
    /// Kinematic bulk viscosity, >= 0.
    pub bulk_viscosity: f64,
    /// Thermal diffusivity, >= 0.
    pub heat: f64,
}

/// What pushes and pulls beside the differences of pressure.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Force {
    /// Length / time^2, of everything.
    pub acceleration: Vec<f64>,
    /// The pressure that forces leave out, >= 0.
    pub background: f64,
}

/// How long, and in what steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Time {
    /// Duration of the run, >= 0: at 0 the start is all there is.
    pub end: f64,
    /// Step / (width / signal speed), in (0, 1].
    pub courant: f64,
    /// How the energy is advanced.
    pub energy: EnergyRule,
}

/// How the energy is advanced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergyRule {
    /// With predicted velocities: the total drifts with the square of the step.
    LeapFrog,
    /// With the mean velocity of the step: the total is conserved to rounding.
    Exact,
    /// The total energy of a particle in place of the internal one.
    Total,
}

const WEIGHTS: &[(&str, Weights)] = &[("mass", Weights::Mass), ("number", Weights::Number)];

const GRADIENTS: &[(&str, GradientKind)] = &[
    ("plain", GradientKind::Plain),
    ("linear-exact", GradientKind::LinearExact),
];

const KINDS: &[(&str, ViscosityKind)] = &[
    ("pairwise", ViscosityKind::Pairwise),
    ("gingold_monaghan", ViscosityKind::GingoldMonaghan),
    ("von_neumann", ViscosityKind::VonNeumann),
    ("limited", ViscosityKind::Limited),
    ("none", ViscosityKind::None),
];

const ENERGY_RULES: &[(&str, EnergyRule)] = &[
    ("leapfrog", EnergyRule::LeapFrog),
    ("exact", EnergyRule::Exact),
    ("total", EnergyRule::Total),
];

/// Courant number where none is given.
const DEFAULT_COURANT: f64 = 0.3;

/// `[weights]`.
pub(super) fn weights(root: &Section<'_>) -> Result<Weights, Fault> {
    match root.optional("weights") {
        Some(entry) => entry.section()?.required("rule")?.choice(WEIGHTS),
        None => Ok(Weights::Mass),
    }
}

/// `[gradient]`.
pub(super) fn gradient(root: &Section<'_>) -> Result<GradientKind, Fault> {
    match root.optional("gradient") {
        Some(entry) => entry.section()?.required("kind")?.choice(GRADIENTS),
        None => Ok(GradientKind::Plain),
    }
}

/// The viscosity where nothing else is said.
const DEFAULT_VISCOSITY: Viscosity = Viscosity {
    kind: ViscosityKind::Pairwise,
    alpha: 1.0,
    beta: 2.0,
    switch: None,
    balsara: false,
};

/// `[viscosity]`.
pub(super) fn viscosity(root: &Section<'_>) -> Result<Viscosity, Fault> {
    let usual = DEFAULT_VISCOSITY;
    let Some(entry) = root.optional("viscosity") else {
        return Ok(usual);
    };
    let section = &entry.section()?;
    let kind = section.optional("kind");
    let kind = kind.map_or(Ok(usual.kind), |entry| entry.choice(KINDS))?;
    if kind == ViscosityKind::None {
        // So that `--set viscosity.kind=none` alone switches it off.
        return Ok(Viscosity {
            kind,
            alpha: 0.0,
            beta: 0.0,
            switch: None,
            balsara: false,
        });
    }
    let alpha = section.number_or("alpha", usual.alpha, DAMPING)?;
    let beta = section.number_or("beta", usual.beta, DAMPING)?;
    let balsara = section.optional("balsara");
    Ok(Viscosity {
        kind,
        alpha,
        beta,
        switch: match section.optional("switch") {
            Some(entry) => Some(switch(&entry.section()?, alpha)?),
            None => None,
        },
        balsara: balsara.map_or(Ok(false), |entry| entry.truth())?,
    })
}

fn switch(section: &Section<'_>, alpha: f64) -> Result<Switch, Fault> {
    let entry = section.required("minimum")?;
    let minimum = entry.number(NOT_NEGATIVE)?;
    if minimum > alpha {
        let reason = format!("viscosity.alpha = {alpha} is the largest it takes");
        return Err(entry.does_not_fit(reason, "give a minimum of at most viscosity.alpha"));
    }
    let decay = section.required("decay")?.number(POSITIVE)?;
    Ok(Switch { minimum, decay })
}

/// `[conduction]`: factor of the artificial conductivity.
pub(super) fn conduction(root: &Section<'_>) -> Result<f64, Fault> {
    match root.optional("conduction") {
        Some(entry) => entry.section()?.required("alpha")?.number(DAMPING),
        None => Ok(0.0),
    }
}

/// `[diffusion]`.
pub(super) fn diffusion(root: &Section<'_>) -> Result<Diffusion, Fault> {
    let section = root.optional("diffusion").map(|entry| entry.section());
    let section = section.transpose()?;
    let coefficient = |key| {
        let entry = section.as_ref().and_then(|section| section.optional(key));
        entry.map_or(Ok(0.0), |entry| entry.number(NOT_NEGATIVE))
    };
    Ok(Diffusion {
        viscosity: coefficient("viscosity")?,
        bulk_viscosity: coefficient("bulk-viscosity")?,
        heat: coefficient("heat")?,
    })
}

/// `[force]`.
pub(super) fn force(root: &Section<'_>, domain: &Domain) -> Result<Force, Fault> {
    let none = vec![0.0; domain.extent.lower.len()];
    let Some(entry) = root.optional("force") else {
        return Ok(Force {
            acceleration: none,
            background: 0.0,
        });
    };
    let section = entry.section()?;
    let background = section.optional("background");
    let acceleration = match section.optional("acceleration") {
        Some(entry) => entry.vector(none.len())?,
        None if background.is_some() => none,
        None => return Err(section.missing("acceleration")),
    };
    let background = background.map_or(Ok(0.0), |entry| background_pressure(&entry, domain))?;
    Ok(Force {
        acceleration,
        background,
    })
}

/// A pressure that pushes equally from all sides: not where a side leaves the gas without a partner.
fn background_pressure(entry: &Entry<'_>, domain: &Domain) -> Result<f64, Fault> {
    let background = entry.number(NOT_NEGATIVE)?;
    let is_closed = |side: &Side| matches!(side, Side::Periodic | Side::Mirror);
    let open = domain
        .sides
        .iter()
        .position(|sides| !sides.iter().all(is_closed));
    match open.filter(|_| background > 0.0) {
        None => Ok(background),
        Some(axis) => Err(entry.does_not_fit(
            format!(
                "the domain is open along {}, and what lies beyond pushes with all of its pressure",
                AXES[axis]
            ),
            "take `background` out, or make all sides \"periodic\" or \"mirror\"",
        )),
    }
}

/// `[time]`.
pub(super) fn time(section: &Section<'_>) -> Result<Time, Fault> {
    let courant = section.optional("courant");
    let energy = section.optional("energy");
    Ok(Time {
        end: section.required("end")?.number(NOT_NEGATIVE)?,
        courant: courant.map_or(Ok(DEFAULT_COURANT), |entry| entry.number(COURANT))?,
        energy: energy.map_or(Ok(EnergyRule::LeapFrog), |entry| entry.choice(ENERGY_RULES))?,
    })
}
