//! An open side in space: how far out a place is, and the place that far out.

use crate::domain::{Axis, Passed};
use crate::scalar::Scalar;

/// An open side, and where it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct OpenEnd<S> {
    /// Which one.
    pub side: Passed,
    /// Where.
    pub position: S,
}

impl<S: Scalar> OpenEnd<S> {
    /// The two ends of a direction.
    pub fn both(axis: usize, of: &Axis<S>) -> [Self; 2] {
        let end = |end, position| Self {
            side: Passed { axis, end },
            position,
        };
        [end(0, of.lower), end(1, of.upper)]
    }

    /// The component of a vector along the direction.
    pub fn along<const D: usize>(&self, vector: &[S; D]) -> S {
        vector.get(self.side.axis).copied().unwrap_or(S::ZERO)
    }

    /// The same vector with another component along the direction.
    pub fn with<const D: usize>(&self, mut vector: [S; D], along: S) -> [S; D] {
        if let Some(component) = vector.get_mut(self.side.axis) {
            *component = along;
        }
        vector
    }

    /// How far out a position lies; negative inside.
    pub fn distance<const D: usize>(&self, position: &[S; D]) -> S {
        let x = self.along(position);
        match self.side.end {
            0 => self.position - x,
            _ => x - self.position,
        }
    }

    /// The same position that far out.
    pub fn at<const D: usize>(&self, position: [S; D], distance: S) -> [S; D] {
        self.with(position, self.position + self.side.outward(distance))
    }
}
