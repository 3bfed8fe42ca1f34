//! What happens to particles beyond open sides: see [`super::open`] and [`super::far`].

use crate::cutoff::CutOff;
use crate::domain::{Passed, Side};
use crate::material::EquationOfState;
use crate::neighbours::Cells;
use crate::scalar::Scalar;

use super::density::DensityNode;
use super::dynamics::GasDynamics;
use super::end::OpenEnd;
use super::far::Far;
use super::node::GasSums;
use super::physics::Physics;
use super::state::{Gas, Row, Wave};
use super::storage::RatesOf;
use super::terms::NodeOf;
use super::viscosity::Viscosity;

/// Slices of a zone, equally thick.
const SLICES: usize = 16;

/// The mean of something in each slice of the zones beyond the lower and the upper side.
#[derive(Clone, Copy)]
pub(super) struct Means<S> {
    mean: [[S; SLICES]; 2],
    count: [[u32; SLICES]; 2],
}

impl<S: Scalar> Means<S> {
    /// Of nothing.
    pub const NONE: Self = Self {
        mean: [[S::ZERO; SLICES]; 2],
        count: [[0; SLICES]; 2],
    };

    /// A running mean: in fixed point a sum of many could leave the range.
    fn add(&mut self, place: Slice, value: S) {
        let mean = self
            .mean
            .get_mut(place.end)
            .and_then(|of| of.get_mut(place.number));
        let count = self
            .count
            .get_mut(place.end)
            .and_then(|of| of.get_mut(place.number));
        if let (Some(mean), Some(count)) = (mean, count) {
            *count = count.saturating_add(1);
            *mean += (value - *mean) / S::count(*count);
        }
    }

    fn of(&self, place: Slice) -> S {
        let mean = self.mean.get(place.end).and_then(|of| of.get(place.number));
        mean.copied().unwrap_or(S::ZERO)
    }
}

/// A slice of a zone.
#[derive(Clone, Copy)]
struct Slice {
    end: usize,
    number: usize,
}

/// Where a particle is beyond a side with a known far state.
pub(super) struct Place<'a, S> {
    far: &'a Far<S>,
    side: Passed,
    /// From the side.
    distance: S,
}

impl<S: Scalar> Place<'_, S> {
    /// Its slice; the last one beyond the depth of the zone.
    fn slice(&self) -> Slice {
        let number = self
            .distance
            .cells(self.far.depth / S::count(SLICES as u32));
        Slice {
            end: self.side.end,
            number: (number as usize).min(SLICES - 1),
        }
    }
}

impl<S: Scalar, const D: usize> DensityNode<S, D> {
    /// `div u`, of the sums at these densities.
    #[inline(always)]
    pub(super) fn divergence(&self, sums: &GasSums<S, D>) -> S {
        -(sums.compression / (self.density * self.omega))
    }
}

impl<S, C, V, E, P, const D: usize> GasDynamics<'_, S, C, V, E, P, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    /// Where a position is beyond an open side that waves pass against the stream; `None` where
    /// it is not beyond one, nothing is known of the far gas, or all of it is supersonic.
    #[inline(always)]
    fn place(&self, position: &[S; D]) -> Option<Place<'_, S>> {
        let (_, side) = self.domain.passed(position)?;
        let far = self.physics.plain().far.get(side.end)?.as_ref()?;
        let [lower, upper] = OpenEnd::both(side.axis, self.domain.axes.get(side.axis)?);
        let end = if side.end == 0 { lower } else { upper };
        far.is_subsonic().then(|| Place {
            far,
            side,
            distance: end.distance(position),
        })
    }

    /// The mean w of the slices, of the velocities that forces depend on.
    pub(super) fn excesses(
        &self,
        gas: &mut Gas<'_, S, D>,
        cells: &Cells<'_, S, D>,
        dt: S,
    ) -> Means<S> {
        let mut means = Means::NONE;
        if self.physics.plain().far != [None; 2] {
            for &id in cells.order() {
                let Some(row) = gas.row(id) else { continue };
                if let Some(place) = self.place(row.position) {
                    let excess = place.far.excess(place.side, &row.predicted(dt));
                    means.add(place.slice(), excess);
                }
            }
        }
        means
    }

    /// The mean `div u` of the slices.
    pub(super) fn divergences<'s>(
        &self,
        gas: &Gas<'_, S, D>,
        cells: &Cells<'_, S, D>,
        rates: &RatesOf<S, P, D>,
        densities: impl Iterator<Item = &'s DensityNode<S, D>>,
    ) -> Means<S> {
        let mut means = Means::NONE;
        if self.physics.plain().far != [None; 2] {
            for ((rate, settled), &id) in rates.iter().zip(densities).zip(cells.order()) {
                let position = gas.position.get(id as usize);
                if let Some(place) = position.and_then(|x| self.place(x)) {
                    means.add(place.slice(), settled.divergence(&rate.sums));
                }
            }
        }
        means
    }

    /// The pressure of a particle beyond an open side that waves come in through.
    #[inline(always)]
    pub(super) fn pressure_beyond(
        &self,
        position: &[S; D],
        velocity: &[S; D],
        excesses: &Means<S>,
        [density, sound_speed]: [S; 2],
    ) -> Option<S> {
        let place = self.place(position)?;
        let outward =
            place.far.excess(place.side, velocity) + place.side.outward(place.far.velocity);
        let excess = excesses.of(place.slice());
        (outward < sound_speed).then(|| place.far.pressure_of_wave(excess, density * sound_speed))
    }

    /// Kicks a particle beyond an open side.
    ///
    /// Where no wave comes in its velocity obeys `Du/Dt = -c div u` along the normal. Where waves do,
    /// its pressure is that of a wave that runs out, and the sums over pairs make
    /// `Du/Dt = -∇p/ρ = -c ∂w/∂n` of it; they also keep particles in order. They need partners whose
    /// densities are right, two reaches around. Further out nothing holds particles in their places:
    /// there it is `-c div u` again, with the mean of `div u` in a slice of the zone, and what
    /// differs from the mean velocity of the slice is damped at a rate of `c/4ε`.
    #[inline(always)]
    pub(super) fn close_beyond(
        &self,
        (side, passed): (Side, Passed),
        row: &mut Row<'_, S, D>,
        (node, sums): (&NodeOf<S, P, D>, &GasSums<S, D>),
        divergence: S,
        [excesses, divergences]: [&Means<S>; 2],
        dt: S,
    ) {
        let normal = passed.normal();
        let mut wave = Wave {
            normal,
            push: -(row.mass * (node.sound_speed * divergence)),
            power: node.measure * (node.pressure * sums.compression),
        };
        match self.place(row.position) {
            None if side == Side::Inflow => return row.hold(),
            None => {}
            Some(place) => {
                let reach = S::count(self.cut_off.support()) * node.epsilon;
                if place.distance + (reach + reach) <= place.far.depth {
                    wave.push = S::dot(&normal, &sums.force);
                } else {
                    let far = place.far;
                    let divergence = divergences.of(place.slice());
                    let ahead = far.excess(passed, &node.velocity) - excesses.of(place.slice());
                    let drag = (ahead / node.epsilon).half().half();
                    wave.push = -(row.mass * (node.sound_speed * (divergence + drag)));
                    wave.power = -(row.mass * (far.pressure / far.density * divergence));
                }
            }
        }
        row.leave(dt, wave, self.physics.energy());
    }
}
