//! The cut-off: its shape and its width.

use super::bound::{POSITIVE, THETA};
use super::error::Fault;
use super::problem::Problem;
use super::section::Section;

/// The cut-off: its shape and its width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutOff {
    /// The shape.
    pub shape: CutOffShape,
    /// The width.
    pub width: Width,
}

/// The shape of a cut-off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutOffShape {
    /// The cubic B-spline M4.
    CubicSpline,
    /// The quintic B-spline M6.
    QuinticSpline,
    /// Wendland's C2 function.
    WendlandC2,
    /// Wendland's C4 function.
    WendlandC4,
    /// Wendland's C6 function.
    WendlandC6,
    /// A polynomial in the squared distance: no root to take.
    RootFree,
}

/// The width of a cut-off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Width {
    /// `eps_k = eta h^(theta - 1) (m_k/rho_k)^(1/dimension)`, h the mean spacing at the start
    /// as a number of the scenario's unit of length: `eps = eta h^theta` where the gas is even.
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

impl Width {
    /// ε in spacings for an even gas of spacing `h`; 1 for a width that is given.
    pub fn spacings(&self, h: f64) -> f64 {
        match *self {
            Self::Adaptive { eta, theta } if theta < 1.0 => eta * libm::pow(h, theta - 1.0),
            Self::Adaptive { eta, .. } => eta,
            Self::Constant { .. } => 1.0,
        }
    }
}

const SHAPES: &[(&str, CutOffShape)] = &[
    ("cubic-spline", CutOffShape::CubicSpline),
    ("quintic-spline", CutOffShape::QuinticSpline),
    ("wendland-c2", CutOffShape::WendlandC2),
    ("wendland-c4", CutOffShape::WendlandC4),
    ("wendland-c6", CutOffShape::WendlandC6),
    ("root-free", CutOffShape::RootFree),
];

impl CutOff {
    /// Where a scenario names none: M4 in one dimension, Wendland's C2 in two and three, where
    /// particles under a spline clump in pairs.
    fn usual(dimension: usize) -> Self {
        let (shape, eta) = match dimension {
            1 => (CutOffShape::CubicSpline, 1.0),
            _ => (CutOffShape::WendlandC2, 1.3),
        };
        let width = Width::Adaptive { eta, theta: 1.0 };
        Self { shape, width }
    }
}

/// `[cut-off]`.
pub(super) fn cut_off(root: &Section<'_>, dimension: usize) -> Result<CutOff, Fault> {
    let Some(entry) = root.optional("cut-off") else {
        return Ok(CutOff::usual(dimension));
    };
    let section = &entry.section()?;
    let shape = section.required("name")?.choice(SHAPES)?;
    let width = match (section.optional("eta"), section.optional("epsilon")) {
        (Some(eta), None) => Width::Adaptive {
            eta: eta.number(POSITIVE)?,
            theta: section
                .optional("theta")
                .map_or(Ok(1.0), |theta| theta.number(THETA))?,
        },
        (None, Some(epsilon)) => {
            if let Some(theta) = section.optional("theta") {
                let reason = "epsilon is a width of its own".to_owned();
                return Err(theta.does_not_fit(reason, "give eta with theta, or epsilon alone"));
            }
            Width::Constant {
                epsilon: epsilon.number(POSITIVE)?,
            }
        }
        (Some(_), Some(epsilon)) => return Err(epsilon.fault(Problem::Width { both: true })),
        (None, None) => return Err(Fault::new(Problem::Width { both: false }, section.span())),
    };
    Ok(CutOff { shape, width })
}
