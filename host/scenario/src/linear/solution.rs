//! Which initial states have a solution that is known.

use super::{Conductor, ConvectionDiffusion, Field, Initial, Reaction, System};
use crate::{Domain, Side};

impl Initial {
    /// Whether the solution at later times is known.
    ///
    /// # Errors
    /// Why it is not.
    pub fn has_solution(&self, system: &System, domain: &Domain) -> Result<(), String> {
        if matches!(self, Self::Manufactured { .. }) {
            return Ok(());
        }
        if matches!(self, Self::Formula { .. }) {
            return Err("no solution is known".to_owned());
        }
        if let System::Transport {
            velocity: velocity @ Field::Formula(_),
            ..
        } = system
        {
            return Err(format!("the velocity is {}", velocity.name()));
        }
        let System::ConvectionDiffusion(diffusion) = system else {
            return Ok(());
        };
        let at = Place { diffusion, domain };
        match self {
            Self::Gaussian { .. } => at.gaussian(),
            Self::Modes { wave, .. } => at.modes(wave),
            Self::Band { .. } => at.band(),
            Self::Legendre { .. } => at.legendre(),
            Self::Uniform { .. } => at.uniform(),
            _ => Err("no solution is known".to_owned()),
        }
    }
}

/// Where a state is at t = 0.
#[derive(Clone, Copy)]
struct Place<'a> {
    diffusion: &'a ConvectionDiffusion,
    domain: &'a Domain,
}

/// Nothing, or the reason that something is not as it must be.
fn need(holds: bool, reason: impl Into<String>) -> Result<(), String> {
    if holds { Ok(()) } else { Err(reason.into()) }
}

impl Place<'_> {
    fn has(&self, side: Side) -> bool {
        self.domain.sides.iter().flatten().any(|&own| own == side)
    }

    fn is_still(&self) -> bool {
        self.diffusion.velocity == Field::Still
    }

    fn is_shift(&self) -> bool {
        matches!(
            self.diffusion.velocity,
            Field::Still | Field::Uniform { .. }
        )
    }

    fn still(&self) -> Result<(), String> {
        let name = self.diffusion.velocity.name();
        need(
            self.is_still(),
            format!("the velocity is {name}, not still"),
        )
    }

    fn uniform_profile(&self) -> Result<(), String> {
        let name = self.diffusion.profile.name();
        let is_uniform = self.diffusion.profile == Conductor::Uniform;
        need(is_uniform, format!("the profile is {name}, not uniform"))
    }

    fn one_species(&self) -> Result<(), String> {
        let count = self.diffusion.species.len();
        need(count == 1, format!("there are {count} species, not one"))
    }

    fn no_reaction(&self) -> Result<(), String> {
        let name = self.diffusion.reaction.name();
        let is_none = self.diffusion.reaction == Reaction::None;
        need(is_none, format!("the reaction is {name}, not none"))
    }

    /// `du/dt = M u`.
    fn homogeneous(&self) -> Result<(), String> {
        match &self.diffusion.reaction {
            Reaction::None => Ok(()),
            Reaction::Linear { source, .. } => need(
                source.iter().all(|&source| source == 0.0),
                "the linear reaction has a source",
            ),
            other => Err(format!("the reaction is {}, not linear", other.name())),
        }
    }

    fn no_modulation(&self) -> Result<(), String> {
        let is_steady = self.diffusion.modulation.is_none();
        need(is_steady, "the diffusivity changes in time: modulation")
    }

    fn closed(&self) -> Result<(), String> {
        need(self.diffusion.is_closed(), "something passes a [[wall]]")
    }

    fn gaussian(&self) -> Result<(), String> {
        let Self { diffusion, .. } = self;
        let velocity = &diffusion.velocity;
        let name = velocity.name();
        self.uniform_profile()?;
        need(!self.has(Side::Mirror), "a wall throws it back")?;
        self.homogeneous()?;
        let all = &diffusion.diffusivity;
        need(
            all.iter().all(|b| *b == all[0]),
            "the diffusivities of the species differ",
        )?;
        need(
            !matches!(velocity, Field::Wave { .. } | Field::Formula(_)),
            format!("the velocity is {name}, which no Gaussian survives"),
        )?;
        need(
            self.is_shift() || diffusion.tensor.is_none(),
            format!("the velocity is {name}, which turns the tensor's directions"),
        )?;
        let turns = matches!(velocity, Field::Rotation { .. });
        need(
            self.is_shift() || turns || diffusion.modulation.is_none(),
            format!("the velocity is {name}, and there is a modulation"),
        )?;
        need(
            self.is_shift() || !self.has(Side::Periodic),
            format!("the velocity is {name}, and a direction is periodic"),
        )
    }

    fn modes(&self, wave: &[i32]) -> Result<(), String> {
        self.uniform_profile()?;
        self.still()?;
        self.no_modulation()?;
        self.homogeneous()?;
        if !self.has(Side::Mirror) {
            return Ok(());
        }
        let along = wave.iter().filter(|&&number| number != 0).count();
        let meets = |(number, sides): (&i32, &[Side; 2])| *number != 0 && sides[0] == Side::Mirror;
        let meets_wall = wave.iter().zip(&self.domain.sides).any(meets);
        need(
            along == 1 || !meets_wall,
            "a wave that meets a wall at an angle is thrown back",
        )
    }

    fn band(&self) -> Result<(), String> {
        let name = self.diffusion.velocity.name();
        self.uniform_profile()?;
        need(
            self.is_shift(),
            format!("the velocity is {name}, neither still nor uniform"),
        )?;
        self.one_species()?;
        need(self.diffusion.tensor.is_none(), "there is a tensor")?;
        self.no_modulation()?;
        self.no_reaction()?;
        let is_wall = self.domain.sides[0].contains(&Side::Mirror);
        need(!is_wall, "there is a wall along x")?;
        self.closed()
    }

    fn legendre(&self) -> Result<(), String> {
        self.still()?;
        self.one_species()?;
        self.no_reaction()?;
        need(
            self.domain.sides == [[Side::Mirror; 2]],
            "a side along x is no wall",
        )?;
        self.closed()?;
        let Conductor::Parabola { center, radius } = self.diffusion.profile else {
            return Err("the profile is no parabola".to_owned());
        };
        let extent = &self.domain.extent;
        // Rounding of the sum of two decimals.
        let meets = |side: f64, vertex: f64| (side - vertex).abs() <= 1e-12 * radius;
        need(
            meets(extent.lower[0], center - radius) && meets(extent.upper[0], center + radius),
            format!(
                "the profile falls to 0 at {} and {}, not at the sides",
                center - radius,
                center + radius
            ),
        )
    }

    fn uniform(&self) -> Result<(), String> {
        let dimension = self.domain.sides.len();
        need(dimension == 1, format!("dimension = {dimension}, not 1"))?;
        need(
            self.domain.sides == [[Side::Mirror; 2]],
            "a side along x is no wall",
        )?;
        self.still()?;
        self.one_species()?;
        self.no_reaction()?;
        self.no_modulation()?;
        let profile = &self.diffusion.profile;
        let is_known = matches!(profile, Conductor::Uniform | Conductor::Layers { .. });
        let name = profile.name();
        need(
            is_known,
            format!("the profile is {name}, not uniform or layers"),
        )
    }
}
