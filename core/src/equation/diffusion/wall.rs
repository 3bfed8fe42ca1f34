//! What holds at a wall, as what is seen behind it.

use crate::domain::Wall;
use crate::scalar::Scalar;

/// A boundary condition. `n` points out of the domain; a flux is `-b ∂u/∂n`, positive outwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition<S> {
    /// Nothing passes: `∂u/∂n = 0`. The sums of the strengths are conserved.
    NoFlux,
    /// `u` is this.
    Value(S),
    /// The flux is this.
    Flux(S),
    /// The flux is `rate (u - outside)`: Robin's condition. `rate`: length/time, >= 0.
    Exchange {
        /// How well the wall conducts.
        rate: S,
        /// `u` beyond it.
        outside: S,
    },
}

/// The conditions at all walls, by direction, end and species.
pub(super) type Walls<S, const D: usize, const P: usize> = [[[Condition<S>; P]; 2]; D];

/// The conditions at a wall.
pub(super) fn end_of<'a, S: Scalar, const D: usize, const P: usize>(
    walls: &'a Walls<S, D, P>,
    wall: &Wall<S>,
) -> Option<&'a [Condition<S>; P]> {
    walls.get(wall.axis).and_then(|ends| ends.get(wall.end))
}

impl<S: Scalar> Condition<S> {
    /// Whether its numbers are.
    pub fn is_finite(&self) -> bool {
        match *self {
            Self::NoFlux => true,
            Self::Value(number) | Self::Flux(number) => number.is_finite(),
            Self::Exchange { rate, outside } => rate.is_finite() && outside.is_finite(),
        }
    }

    /// The same condition with another number: the value, the flux, or what is outside.
    pub fn with(self, number: S) -> Self {
        match self {
            Self::NoFlux => self,
            Self::Value(_) => Self::Value(number),
            Self::Flux(_) => Self::Flux(number),
            Self::Exchange { rate, .. } => Self::Exchange {
                rate,
                outside: number,
            },
        }
    }

    /// The same for a wall whose particles are to receive so many times as much.
    pub(super) fn shared(self, share: S) -> Self {
        match self {
            Self::NoFlux | Self::Value(_) => self,
            Self::Flux(flux) => Self::Flux(share * flux),
            Self::Exchange { rate, outside } => Self::Exchange {
                rate: share * rate,
                outside,
            },
        }
    }

    /// `u` at the wall, where a particle at `distance` from it has `u` and diffusivity `b`: the
    /// straight line that meets the condition.
    fn at_wall(&self, u: S, b: S, distance: S) -> S {
        match *self {
            Self::NoFlux => u,
            Self::Value(value) => value,
            Self::Flux(flux) => {
                if b > S::ZERO {
                    u - flux * (distance / b)
                } else {
                    u
                }
            }
            Self::Exchange { rate, outside } => {
                // The two resistances in a row: of the layer, d/b, and of the wall, 1/rate.
                let conductance = rate * distance;
                let sum = b + conductance;
                if sum > S::ZERO {
                    (b * u + conductance * outside) / sum
                } else {
                    u
                }
            }
        }
    }

    /// A bound of all that [`Condition::at_wall`] makes on its way and of the image, for `|u|` and
    /// `b` of those sizes and distances up to `reach`; of `b` the smallest above 0 comes first.
    pub(super) fn largest(&self, u: f64, [least, b]: [f64; 2], reach: f64) -> f64 {
        match *self {
            Self::NoFlux => 3.0 * u,
            Self::Value(value) => 2.0 * value.to_f64().abs() + u,
            Self::Flux(flux) => {
                // The quotient saturates.
                let depth = (reach / least).min(S::LARGEST.to_f64());
                2.0 * flux.to_f64().abs() * depth + 3.0 * u
            }
            Self::Exchange { rate, outside } => {
                let (conductance, outside) = (rate.to_f64() * reach, outside.to_f64().abs());
                let weighed = b * u + conductance * outside;
                weighed.max(b + conductance).max(2.0 * outside + 3.0 * u)
            }
        }
    }

    /// `u` of the mirror image: on the same straight line, `2 u_wall - u`.
    ///
    /// Exact for a linear `u`. For a curved one off by O(d²) with a value, and by O(d³) with a
    /// flux.
    pub(super) fn image(&self, u: S, b: S, distance: S) -> S {
        let wall = self.at_wall(u, b, distance);
        wall + (wall - u)
    }

    /// How well a particle at `distance` exchanges with the outside: of the layer, d/b, and of
    /// the wall, 1/rate, in a row. And `u` out there.
    pub(super) fn conductance(&self, b: S, distance: S) -> Option<(S, S)> {
        let Self::Exchange { rate, outside } = *self else {
            return None;
        };
        let sum = b + rate * distance;
        (sum > S::ZERO).then(|| (rate * (b / sum), outside))
    }

    /// The flux of the mirror image along the normal, from that of the particle; both times
    /// `epsilon`, and not rounded where nothing passes.
    pub(super) fn flux_image(&self, flux: S, epsilon: S) -> S {
        let through = match *self {
            // What is exchanged is not seen behind the wall: each particle pays by itself.
            Self::NoFlux | Self::Exchange { .. } => S::ZERO,
            // A temperature that is held says nothing of the flux: it goes on.
            Self::Value(_) => return flux,
            Self::Flux(flux) => flux,
        };
        let through = epsilon * through;
        (through + through) - flux
    }
}
