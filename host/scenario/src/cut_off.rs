//! The cut-off: its shape and its width.

use motes_core::cutoff::{CutOff as _, Named};

use crate::bound::{POSITIVE, THETA};
use crate::entry::Entry;
use crate::error::Fault;
use crate::problem::Problem;
use crate::section::Section;

/// The cut-off: its shape and its width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutOff {
    /// The shape.
    pub shape: Named,
    /// The width.
    pub width: Width,
}

/// The width of a cut-off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Width {
    /// `eps = eta L (h/L)^theta`, h the mean spacing at the start and L the side of the square
    /// or cube of `N` such spacings squared or cubed, in one dimension the length of the
    /// domain: [`fineness`] is `h/L`. No unit of length enters.
    ///
    /// Of a gas `eps_k = eta (h/L)^(theta - 1) (m_k/rho_k)^(1/dimension)`, which is that where it
    /// is even; of a linear system the same everywhere and at all times.
    Adaptive {
        /// > 0; in mean spacings where theta is 1.
        eta: f64,
        /// In (0, 1]. Below 1 finer clouds have more neighbours, without which their error
        /// stalls (Theorem 1).
        theta: f64,
    },
    /// The same for all particles and times.
    Constant {
        /// A length, > 0.
        epsilon: f64,
    },
}

/// `h/L`, the spacing of an even cloud in the side of a square or cube that it fills: `N^(-1/D)`.
pub fn fineness(particles: usize, dimension: usize) -> f64 {
    libm::pow(1.0 / particles as f64, 1.0 / dimension as f64)
}

impl Width {
    /// ε in spacings for an even cloud of that [`fineness`]; 1 for a width that is given.
    pub fn spacings(&self, fineness: f64) -> f64 {
        match *self {
            Self::Adaptive { eta, theta } if theta < 1.0 => eta * libm::pow(fineness, theta - 1.0),
            Self::Adaptive { eta, .. } => eta,
            Self::Constant { .. } => 1.0,
        }
    }

    /// ε of an even cloud of spacing `h`, in the unit of `h`, and that [`fineness`].
    pub fn epsilon(&self, h: f64, fineness: f64) -> f64 {
        match *self {
            Self::Adaptive { .. } => h * self.spacings(fineness),
            Self::Constant { epsilon } => epsilon,
        }
    }
}

/// The shape of that name.
fn shape(entry: &Entry<'_>) -> Result<Named, Fault> {
    let place = entry.choice_of(Named::NAMES.iter().copied())?;
    // Every name leads back to its shape.
    Ok(Named::from_name(Named::NAMES[place]).unwrap_or(Named::CubicSpline))
}

/// That of a gas, whose density is a sum of its values: none may be negative.
fn positive_shape(entry: &Entry<'_>) -> Result<Named, Fault> {
    let shape = shape(entry)?;
    if shape.order() == 2 {
        return Ok(shape);
    }
    let reason = format!(
        "it is of order {} and below 0 somewhere, and a density is a sum of its values",
        shape.order()
    );
    Err(entry.does_not_fit(
        reason,
        "choose one of order 2 for a gas: docs/scenario.md lists them",
    ))
}

impl CutOff {
    /// Where a gas names none: M4 in one dimension, Wendland's C2 in two and three, where
    /// particles under a spline clump in pairs.
    fn of_gas(dimension: usize) -> Self {
        let (shape, eta) = match dimension {
            1 => (Named::CubicSpline, 1.0),
            _ => (Named::WendlandC2, 1.3),
        };
        let width = Width::Adaptive { eta, theta: 1.0 };
        Self { shape, width }
    }
}

/// Of a linear system that names none: shape, eta and theta. M6 is smooth enough for
/// `epsilon = eta L (h/L)^0.75`: both errors of Theorem 1 fall with the spacing.
const OF_LINEAR: (Named, f64, f64) = (Named::QuinticSpline, 0.7, 0.75);

/// `[cut-off]` of a gas: a shape and a width, or neither.
pub(super) fn of_gas(root: &Section<'_>, dimension: usize) -> Result<CutOff, Fault> {
    let Some(entry) = root.optional("cut-off") else {
        return Ok(CutOff::of_gas(dimension));
    };
    let section = &entry.section()?;
    let shape = positive_shape(&section.required("name")?)?;
    let width = width(section, 1.0)?;
    let missing = || Fault::new(Problem::Width { both: false }, section.span());
    let width = width.ok_or_else(missing)?;
    Ok(CutOff { shape, width })
}

/// `[cut-off]` of a linear system: each key has a default.
pub(super) fn of_linear(root: &Section<'_>) -> Result<CutOff, Fault> {
    let (usual_shape, eta, theta) = OF_LINEAR;
    let usual = Width::Adaptive { eta, theta };
    let Some(entry) = root.optional("cut-off") else {
        return Ok(CutOff {
            shape: usual_shape,
            width: usual,
        });
    };
    let section = &entry.section()?;
    let name = section.optional("name");
    let alone = section.optional("theta");
    Ok(CutOff {
        shape: name.map_or(Ok(usual_shape), |name| shape(&name))?,
        width: match (width(section, theta)?, alone) {
            (Some(width), _) => width,
            (None, None) => usual,
            (None, Some(theta)) => Width::Adaptive {
                eta,
                theta: theta.number(THETA)?,
            },
        },
    })
}

/// The width that `eta` or `epsilon` gives, if there is one of them.
fn width(section: &Section<'_>, usual_theta: f64) -> Result<Option<Width>, Fault> {
    let theta = section.optional("theta");
    let width = match (section.optional("eta"), section.optional("epsilon")) {
        (Some(eta), None) => Width::Adaptive {
            eta: eta.number(POSITIVE)?,
            theta: theta.map_or(Ok(usual_theta), |theta| theta.number(THETA))?,
        },
        (None, Some(epsilon)) => {
            if let Some(theta) = theta {
                let reason = "epsilon is a width of its own".to_owned();
                return Err(theta.does_not_fit(reason, "give eta with theta, or epsilon alone"));
            }
            Width::Constant {
                epsilon: epsilon.number(POSITIVE)?,
            }
        }
        (Some(_), Some(epsilon)) => return Err(epsilon.fault(Problem::Width { both: true })),
        (None, None) => return Ok(None),
    };
    Ok(Some(width))
}
