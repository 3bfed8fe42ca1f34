//! The box a cloud lives in, its sides, and the two places that know what a position is:
//! [`Offset::displacement`] and [`Domain::drift`].

use crate::error::{Error, Quantity};
use crate::numbered::numbered;
use crate::scalar::{Number, Scalar};

/// What is beyond a side of the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Nothing: the cloud has the room it takes.
    Free,
    /// The other side of the domain. Both sides of a direction are periodic, or none.
    Periodic,
    /// The mirror image of the cloud: a wall that lets nothing through.
    Mirror,
    /// Particles that come in: beyond the side nothing acts on them. The equation
    /// says what they are: for a gas `equation::gas::open`.
    Inflow,
    /// Particles that go out: beyond the side they answer to nothing but waves that go out.
    Outflow,
}

/// Where a particle is that has passed an open side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Beyond<S, const D: usize> {
    /// Beyond an inflow side.
    Inflow,
    /// Beyond an outflow side; the unit vector that points out.
    Outflow([S; D]),
}

impl Side {
    /// Whether particles may be beyond it.
    pub fn is_passable(self) -> bool {
        matches!(self, Self::Free | Self::Inflow | Self::Outflow)
    }
}

/// One direction of the domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis<S> {
    /// Position of the lower side; means nothing where that side is free.
    pub lower: S,
    /// Position of the upper side; means nothing where that side is free.
    pub upper: S,
    /// What is below `lower` and above `upper`.
    pub sides: [Side; 2],
}

impl<S: Scalar> Axis<S> {
    /// A direction without sides.
    pub const FREE: Self = Self {
        lower: S::ZERO,
        upper: S::ZERO,
        sides: [Side::Free; 2],
    };

    /// A periodic direction.
    pub const fn periodic(lower: S, upper: S) -> Self {
        Self {
            lower,
            upper,
            sides: [Side::Periodic; 2],
        }
    }

    /// A direction between two walls.
    pub const fn walls(lower: S, upper: S) -> Self {
        Self {
            lower,
            upper,
            sides: [Side::Mirror; 2],
        }
    }

    /// Whether the direction closes on itself.
    pub fn is_periodic(&self) -> bool {
        self.sides == [Side::Periodic; 2]
    }
}

/// The domain: one [`Axis`] for each of `D` directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<S, const D: usize> {
    /// The directions.
    pub axes: [Axis<S>; D],
}

impl<S: Scalar, const D: usize> Domain<S, D> {
    /// All of space.
    pub const FREE: Self = Self {
        axes: [Axis::FREE; D],
    };

    /// Moves a position by `step`, through periodic sides and off walls.
    ///
    /// Returns for each direction whether it met a wall there: the velocity in that
    /// direction is to be reversed. Errors: a step beyond the image of the domain, a step that is no
    /// finite number.
    pub fn drift(
        &self,
        position: &mut [S; D],
        step: &[S; D],
        particle: u32,
    ) -> Result<[bool; D], Error> {
        let mut reflected = [false; D];
        let components = position.iter_mut().zip(step).zip(&self.axes);
        for (((x, &dx), axis), reflected) in components.zip(&mut reflected) {
            let moved = *x + dx;
            // Before a comparison, which a NaN passes.
            if !moved.is_finite() {
                return Err(Error::NotFinite {
                    particle,
                    quantity: Quantity::Position,
                });
            }
            let (below, above) = (moved < axis.lower, moved > axis.upper);
            *x = match axis.sides {
                [Side::Periodic, _] if below => moved + (axis.upper - axis.lower),
                [Side::Periodic, _] if !(moved < axis.upper) => moved - (axis.upper - axis.lower),
                [Side::Mirror, _] if below => {
                    *reflected = true;
                    axis.lower + (axis.lower - moved)
                }
                [_, Side::Mirror] if above => {
                    *reflected = true;
                    axis.upper - (moved - axis.upper)
                }
                _ => moved,
            };
            let low = !axis.sides[0].is_passable() && *x < axis.lower;
            let high = !axis.sides[1].is_passable() && *x > axis.upper;
            if low || high {
                return Err(Error::Outside { particle });
            }
        }
        Ok(reflected)
    }

    /// Where a position lies beyond an inflow or outflow side; `None` elsewhere.
    #[inline(always)]
    pub fn beyond(&self, position: &[S; D]) -> Option<Beyond<S, D>> {
        let (side, passed) = self.passed(position)?;
        match side {
            Side::Inflow => Some(Beyond::Inflow),
            _ => Some(Beyond::Outflow(passed.normal())),
        }
    }

    /// The inflow or outflow side that a position lies beyond; `None` elsewhere.
    #[inline(always)]
    pub fn passed(&self, position: &[S; D]) -> Option<(Side, Passed)> {
        for (axis, (sides, &x)) in numbered(self.axes.iter().zip(position)) {
            let (end, side) = if x < sides.lower {
                (0, sides.sides[0])
            } else if x > sides.upper {
                (1, sides.sides[1])
            } else {
                continue;
            };
            if matches!(side, Side::Inflow | Side::Outflow) {
                return Some((side, Passed { axis, end }));
            }
        }
        None
    }
}

/// A side that a position lies beyond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Passed {
    /// The direction across it.
    pub axis: usize,
    /// 0 for the lower side of the domain, 1 for the upper one.
    pub end: usize,
}

impl Passed {
    /// A component along the direction, counted outwards.
    #[inline(always)]
    pub fn outward<S: Scalar>(&self, component: S) -> S {
        match self.end {
            0 => -component,
            _ => component,
        }
    }

    /// The unit vector that points out.
    #[inline(always)]
    pub fn normal<S: Scalar, const D: usize>(&self) -> [S; D] {
        let mut normal = [S::ZERO; D];
        if let Some(component) = normal.get_mut(self.axis) {
            *component = self.outward(S::ONE);
        }
        normal
    }
}

/// A wall, as what lies behind it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall<S> {
    /// The direction across it.
    pub axis: usize,
    /// 0 for the lower side of the domain, 1 for the upper one.
    pub end: usize,
    /// Where it is.
    pub position: S,
}

/// How a neighbour is seen along one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Offset<S> {
    /// Itself, or a periodic image at `-shift`.
    Shift(S),
    /// Its mirror image in a wall at this position.
    Wall(S),
}

impl<S: Scalar> Offset<S> {
    /// `x_k - x_l`, with `l` or its image.
    ///
    /// Positions are never moved before they are subtracted, so the displacement from `l` to
    /// `k` is the exact negative of that from `k` to `l` (along a wall: exactly equal).
    #[inline(always)]
    pub fn displacement<N: Number<Scalar = S>>(&self, x_k: N, x_l: N) -> N {
        match *self {
            Self::Shift(shift) => (x_k - x_l) + N::splat(shift),
            Self::Wall(wall) => (x_k - N::splat(wall)) + (x_l - N::splat(wall)),
        }
    }
}
