//! What can go wrong in the core: small values that name the particle or the capacity.

use core::fmt;

/// A container of fixed capacity, or a buffer that the caller lent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Container {
    /// Particles.
    Particles,
    /// Cells of the neighbour grid, plus one.
    Cells,
    /// Candidates in a neighbour list.
    Candidates,
}

/// A quantity of a particle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Position.
    Position,
    /// Velocity.
    Velocity,
    /// Internal energy per mass.
    Energy,
    /// Mass density.
    Density,
    /// Width of the cut-off, ε.
    Epsilon,
    /// Rate of momentum.
    Force,
    /// Rate of internal energy.
    Power,
    /// Time step.
    TimeStep,
    /// Weight `w`.
    Weight,
    /// Strength `q = w u`.
    Strength,
    /// A sum over pairs.
    Sum,
    /// Sums over pairs that make the density.
    DensitySum,
    /// Pressure, or what makes it.
    Pressure,
    /// Sums over pairs that make gradients.
    Gradient,
    /// Rate of the strength.
    Rate,
    /// The bound of the stable time step.
    Stability,
    /// What is seen behind a wall.
    Wall,
}

/// A number that is set from outside, between steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// What drives the lower (0) or upper (1) wall across a direction.
    Wall {
        /// The direction, from 0.
        axis: u8,
        /// Which of its ends.
        end: u8,
    },
    /// The external acceleration.
    Acceleration,
    /// The state of what comes in.
    Inflow,
    /// The factor of the stable time step, in (0, 1].
    Courant,
}

/// An error of the core. `particle` is an id: the place in the caller's arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// More was needed than the memory given at compile time, or by the caller, holds.
    Capacity {
        /// What is full.
        container: Container,
        /// How many would be needed.
        needed: u32,
        /// How many there is room for.
        capacity: u32,
    },
    /// Arrays that belong together have unequal lengths.
    Lengths,
    /// A side of the domain is upside down, or a free side has no particles.
    EmptyDomain {
        /// The direction, from 0.
        axis: u8,
    },
    /// A periodic direction is shorter than three reaches of the cut-off. The reach of an
    /// adaptive cut-off includes room for ε to grow by 1/32 over what was expected of it.
    PeriodTooShort {
        /// The direction, from 0.
        axis: u8,
    },
    /// Two walls that face each other are nearer than one reach of the cut-off, so that a particle
    /// would meet images of images. The reach has the same room as above.
    WallsTooNear {
        /// The direction, from 0.
        axis: u8,
    },
    /// The domain or the reach is too large for squares of displacements in this format.
    Range,
    /// A particle of a material that there is not.
    Material {
        /// Id of the particle.
        particle: u32,
    },
    /// A position beyond the domain by more than its length.
    Outside {
        /// Id of the particle.
        particle: u32,
    },
    /// A weight that is not above zero.
    Weight {
        /// Id of the particle.
        particle: u32,
    },
    /// A particle that sees no other one.
    Isolated {
        /// Id of the particle.
        particle: u32,
    },
    /// Ω is below its bound: the density hardly answers to ε.
    Omega {
        /// Id of the particle.
        particle: u32,
    },
    /// The iteration for ε did not settle within its bound of passes.
    Epsilon {
        /// Id of the particle.
        particle: u32,
    },
    /// A number set from outside that is not finite, or not in its range. The state has not met it.
    Parameter {
        /// Which.
        parameter: Parameter,
    },
    /// The engine was asked to stop before its sums were whole.
    Interrupted,
    /// The words of a state end before the state does, or do not fit into their memory.
    Truncated,
    /// The time step is below the resolution of the time.
    Stalled,
    /// Internal energy below zero.
    NegativeEnergy {
        /// Id of the particle.
        particle: u32,
    },
    /// A bound of what is to be computed is beyond a format that wraps. Nothing has been computed.
    Unproven {
        /// Id of the particle that it is largest at.
        particle: u32,
        /// Which of its quantities, or of what it takes to make it.
        quantity: Quantity,
        /// Integer bits that would do.
        integer_bits: u8,
    },
    /// A value that is not finite, or that overflowed where the scalar keeps track of it.
    NotFinite {
        /// Id of the particle.
        particle: u32,
        /// Which of its quantities.
        quantity: Quantity,
    },
}

impl fmt::Display for Container {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Particles => "particles",
            Self::Cells => "cells",
            Self::Candidates => "neighbour candidates",
        })
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Position => "position",
            Self::Velocity => "velocity",
            Self::Energy => "internal energy",
            Self::Density => "density",
            Self::Epsilon => "epsilon",
            Self::Force => "force",
            Self::Power => "rate of internal energy",
            Self::TimeStep => "time step",
            Self::Weight => "weight",
            Self::Strength => "strength",
            Self::Sum => "the sum over pairs",
            Self::DensitySum => "the sum for the density",
            Self::Pressure => "pressure",
            Self::Gradient => "the sum for the gradient",
            Self::Rate => "the rate of the strength",
            Self::Stability => "the bound of the time step",
            Self::Wall => "the image behind a wall",
        })
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wall { axis, end } => {
                let end = if *end == 0 { "lower" } else { "upper" };
                write!(f, "what drives the {end} wall in direction {axis}")
            }
            Self::Acceleration => f.write_str("the external acceleration"),
            Self::Inflow => f.write_str("the state of the inflow"),
            Self::Courant => f.write_str("courant"),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Capacity {
                container,
                needed,
                capacity,
            } => write!(
                f,
                "{needed} {container} do not fit: there is room for {capacity}; \
                 raise the capacity or use fewer particles"
            ),
            Self::Lengths => f.write_str("arrays of one cloud have unequal lengths"),
            Self::EmptyDomain { axis } => write!(
                f,
                "the domain is empty in direction {axis}: its upper side must lie above its \
                 lower one, and a free side needs particles"
            ),
            Self::PeriodTooShort { axis } => write!(
                f,
                "the period in direction {axis} is below three reaches of the cut-off: use more \
                 particles, a smaller epsilon or eta, or a longer domain"
            ),
            Self::WallsTooNear { axis } => write!(
                f,
                "the walls in direction {axis} are nearer than one reach of the cut-off: use more \
                 particles, a smaller epsilon or eta, or a longer domain"
            ),
            Self::Range => f.write_str(
                "the reach of the cut-off is too large for this number format: use more integer \
                 bits, or a smaller epsilon or eta",
            ),
            Self::Material { particle } => write!(
                f,
                "the material of particle {particle} is not in the list of materials"
            ),
            Self::Outside { particle } => write!(
                f,
                "particle {particle} crossed the whole domain in one step: use a smaller time step"
            ),
            Self::Weight { particle } => write!(
                f,
                "the weight of particle {particle} is not above zero: weights are volumes"
            ),
            Self::Isolated { particle } => write!(
                f,
                "particle {particle} sees no neighbour: use a larger eta or epsilon"
            ),
            Self::Omega { particle } => write!(
                f,
                "Omega of particle {particle} is too small: its neighbours sit at the edge of its \
                 cut-off; use a larger eta"
            ),
            Self::Epsilon { particle } => write!(
                f,
                "epsilon of particle {particle} did not settle: use a larger eta or a smaller \
                 time step"
            ),
            Self::Parameter {
                parameter: Parameter::Courant,
            } => f.write_str(
                "courant, the factor of the stable time step, is out of range: need > 0 and at \
                 most 1; the state is as it was",
            ),
            Self::Parameter { parameter } => write!(
                f,
                "{parameter} is not a finite number: the state is as it was; set it and step again"
            ),
            Self::Interrupted => f.write_str("interrupted in mid-step"),
            Self::Truncated => f.write_str(
                "the words end before the state does: the memory that it was saved to is too small, or \
                 holds another one",
            ),
            Self::Stalled => f.write_str(
                "the time step is below the resolution of the time in this number format: use a \
                 format with more digits, or a shorter run",
            ),
            Self::NegativeEnergy { particle } => write!(
                f,
                "the internal energy of particle {particle} fell below zero: use a smaller time \
                 step or more particles"
            ),
            Self::Unproven {
                particle,
                quantity,
                integer_bits,
            } => {
                write!(
                    f,
                    "{quantity} of particle {particle} may leave the range of the number format: "
                )?;
                match integer_bits {
                    0..=31 => write!(
                        f,
                        "a format with {integer_bits} integer bits would do, such as q{integer_bits}.{}",
                        if *integer_bits <= 23 {
                            31 - integer_bits
                        } else {
                            63 - integer_bits
                        }
                    ),
                    _ => write!(
                        f,
                        "not even {integer_bits} integer bits would do; use floats"
                    ),
                }
            }
            Self::NotFinite { particle, quantity } => write!(
                f,
                "{quantity} of particle {particle} has left the range of the number format: use a \
                 wider format or a smaller time step"
            ),
        }
    }
}

impl core::error::Error for Error {}
