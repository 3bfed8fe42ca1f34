//! Diffusivities that vary in space and time, by name.

use crate::cloud::Place;
use crate::scalar::{Scalar, sine_of_turns};

/// How `b` varies along x: a factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Conductor<'a, S> {
    /// The same everywhere.
    Uniform,
    /// `1 - ((x - center)/radius)²`, 0 where that is below 0: Legendre's operator.
    Parabola {
        /// Where it is 1.
        center: S,
        /// How far from there it is 0, > 0.
        radius: S,
    },
    /// Layers with jumps between them.
    Layers {
        /// Where one ends and the next begins, ascending.
        bounds: &'a [S],
        /// Of each layer: one more than bounds.
        factors: &'a [S],
    },
}

impl<S: Scalar> Conductor<'_, S> {
    /// The factor at a place.
    pub fn factor<const D: usize>(&self, place: &Place<S, D>) -> S {
        let x = place.position.first().copied().unwrap_or(S::ZERO);
        match *self {
            Self::Uniform => S::ONE,
            Self::Parabola { center, radius } => {
                let part = (x - center) / radius;
                (S::ONE - part * part).greater(S::ZERO)
            }
            Self::Layers { bounds, factors } => {
                let layer = bounds.partition_point(|&bound| bound <= x);
                factors.get(layer).copied().unwrap_or(S::ZERO)
            }
        }
    }
}

impl<S: Scalar> Conductor<'_, S> {
    /// The factor of the way between two coordinates along x, `1/factor` averaged along it:
    /// resistances in a row. `None` where it is smooth, and means of the two ends do.
    ///
    /// The same bits whichever end is named first.
    pub fn between(&self, [one, other]: [S; 2]) -> Option<S> {
        let Self::Layers { bounds, factors } = *self else {
            return None;
        };
        let (from, to) = (one.lesser(other), one.greater(other));
        let first = bounds.partition_point(|&bound| bound <= from);
        let last = bounds.partition_point(|&bound| bound <= to);
        let joints = bounds.get(first..last).unwrap_or(&[]);
        let layers = factors.get(first..).unwrap_or(&[]);
        let mut layers = layers.iter().copied();
        let mut mean = layers.next().unwrap_or(S::ZERO);
        let ends = joints.iter().skip(1).copied().chain([to]);
        for ((&joint, end), layer) in joints.iter().zip(ends).zip(layers) {
            mean = in_series([(mean, joint - from), (layer, end - joint)]);
        }
        Some(mean)
    }
}

/// What two stretches of these conductivities and lengths conduct in a row: `1/b` averaged over the
/// length. The same bits in any order, and no larger number on the way than the larger `b` over
/// the smaller.
pub(super) fn in_series<S: Scalar>([one, other]: [(S, S); 2]) -> S {
    let ((low, short), (high, long)) = if one.0 <= other.0 {
        (one, other)
    } else {
        (other, one)
    };
    let length = short + long;
    if low == high || !(length > S::ZERO) {
        return low;
    }
    // b_low over (part_low + part_high b_low/b_high).
    let across = short / length + (long / length) * (low / high);
    if across > S::ZERO { low / across } else { low }
}

/// A factor of `b` that swings in time, `1 + amplitude sin(2π frequency t)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modulation<S> {
    /// Above -1 and below 1.
    pub amplitude: S,
    /// Turns/time.
    pub frequency: S,
}

impl<S: Scalar> Modulation<S> {
    /// Nothing swings.
    pub const NONE: Self = Self {
        amplitude: S::ZERO,
        frequency: S::ZERO,
    };

    /// The factor at a time.
    pub fn factor(&self, time: S) -> S {
        // The same bits without a sine for each particle at each stage.
        if self.amplitude == S::ZERO {
            return S::ONE;
        }
        S::ONE + self.amplitude * sine_of_turns(self.frequency * time)
    }

    /// The largest factor over the one at that time.
    pub fn headroom(&self, time: S) -> S {
        (S::ONE + self.amplitude.abs()) / self.factor(time)
    }
}
