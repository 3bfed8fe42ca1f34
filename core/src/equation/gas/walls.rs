//! Walls that viscous gas sticks to.
//!
//! Pressure and pseudo-viscosity see a mirror: behind a wall stands the image of each particle, with its
//! velocity along the normal reversed. The viscous stress sees there a flow that is odd about the wall,
//!
//! `u' = 2 u_w - u`,
//!
//! `u_w` the velocity of the wall, along the wall: on the wall itself it is `u_w` to second order. The rest
//! follows from the dissipation Φ of [`super::stress`] with these velocities in it: the stress of an image
//! has `A' = -A R`, R the reflection of places, so that what the pair of a particle and an image exerts is
//! what that of the other particle and the other image exerts. Heat is the work of the wall and what
//! kinetic energy loses, to rounding.
//!
//! Where walls meet, an image lies behind several of them: `u' = ū + M (u - ū)`, M the product of `-1` for
//! a wall that the gas sticks to and of R for one that it slips along, ū the mean velocity of the
//! former. Behind two walls that the gas sticks to it is u itself, whatever their velocities:
//! one after the other they would make it depend on their order, and no pair of it would conserve energy.
//!
//! Morris, Fox & Zhu, J. Comp. Phys. 136, 214 (1997) reverse velocities likewise, by distances from the wall.

use crate::neighbours::Image;
use crate::numbered::numbered;
use crate::scalar::{Number, Scalar};

/// The walls that the gas sticks to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoSlip<S, const D: usize> {
    /// The velocity of the lower and the upper wall across each direction, without a component across it;
    /// `None` for one that the gas slips along.
    pub velocity: [[Option<[S; D]>; 2]; D],
}

impl<S: Scalar, const D: usize> NoSlip<S, D> {
    /// The gas slips along all walls.
    pub const NONE: Self = Self {
        velocity: [[None; 2]; D],
    };

    /// Whether it sticks to any.
    pub fn is_any(&self) -> bool {
        self.velocity.iter().flatten().any(Option::is_some)
    }

    /// The velocity of a wall that it sticks to.
    pub fn of(&self, axis: usize, end: usize) -> Option<[S; D]> {
        *self.velocity.get(axis)?.get(end)?
    }

    /// The first wall whose velocity is no number, or has a component across it: its direction and end.
    pub(crate) fn invalid(&self) -> Option<(usize, usize)> {
        for (axis, ends) in numbered(&self.velocity) {
            for (end, velocity) in numbered(ends) {
                let Some(velocity) = velocity else { continue };
                let across = velocity.get(axis).is_some_and(|u| *u != S::ZERO);
                if across || !velocity.iter().all(|u| u.is_finite()) {
                    return Some((axis, end));
                }
            }
        }
        None
    }

    /// The largest component of the velocities.
    pub(super) fn fastest(&self) -> f64 {
        let components = self.velocity.iter().flatten().flatten().flatten();
        let sizes = components.map(|component| component.to_f64().abs());
        sizes.fold(0.0, f64::max)
    }

    /// How the viscous stress sees an image; `None` where it sees a mirror.
    #[inline(always)]
    pub fn seen<N: Number<Scalar = S>>(&self, image: &Image<D>) -> Option<Reversal<N, D>> {
        let (mut turned, mut sign) = ([S::ONE; D], [S::ONE; D]);
        let (mut sum, mut count) = ([S::ZERO; D], 0u32);
        for (axis, end) in image.ends() {
            let wall = self.of(axis, end);
            count = count.saturating_add(u32::from(wall.is_some()));
            for i in 0..D {
                let across = i == axis;
                if let Some(velocity) = &wall {
                    sum[i] += velocity[i];
                }
                if across || wall.is_some() {
                    turned[i] = -turned[i];
                }
                if !across && wall.is_some() {
                    sign[i] = -sign[i];
                }
            }
        }
        if count == 0 {
            return None;
        }
        let mut shift = [S::ZERO; D];
        for i in 0..D {
            if turned[i] < S::ZERO {
                let mean = sum[i] / S::count(count);
                shift[i] = mean + mean;
            }
        }
        Some(Reversal {
            sign: sign.map(N::splat),
            shift: shift.map(N::splat),
        })
    }
}

/// How the viscous stress sees an image that a mirror shows otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reversal<N, const D: usize> {
    /// `M R`, 1 or -1 for each component: what makes of the velocity in a mirror that of the image.
    sign: [N; D],
    /// `(1 - M) ū`.
    shift: [N; D],
}

impl<N: Number, const D: usize> Reversal<N, D> {
    /// A velocity, from that in the mirror.
    #[inline(always)]
    pub fn velocity(&self, mirrored: &[N; D]) -> [N; D] {
        let mut velocity = self.rate(mirrored);
        for i in 0..D {
            velocity[i] += self.shift[i];
        }
        velocity
    }

    /// The rate of change of a velocity, or a force, from that in the mirror.
    #[inline(always)]
    pub fn rate(&self, mirrored: &[N; D]) -> [N; D] {
        let mut rate = *mirrored;
        for i in 0..D {
            rate[i] = self.sign[i] * rate[i];
        }
        rate
    }

    /// The velocity of a wall that acts on the image, where one does: `(1 - M) ū/2`.
    pub(super) fn wall_velocity(&self) -> [N; D] {
        self.shift.map(|component| N::literal(0.5) * component)
    }
}

/// `u_k - u_l`, with that of `l` as it is seen.
#[inline(always)]
pub(super) fn apart_as<N: Number, const D: usize>(
    seen: Option<&Reversal<N, D>>,
    k: &[N; D],
    l: &[N; D],
) -> [N; D] {
    let l = match seen {
        None => *l,
        Some(seen) => seen.velocity(l),
    };
    let mut apart = [N::zero(); D];
    for i in 0..D {
        apart[i] = k[i] - l[i];
    }
    apart
}
