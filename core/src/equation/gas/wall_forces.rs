//! What a gas exerts on the walls of its domain.

use crate::cutoff::CutOff;
use crate::material::EquationOfState;
use crate::neighbours::Image;
use crate::numbered::numbered;
use crate::pairs::{Fields, Law, Partner, Separation, each_image};
use crate::scalar::Scalar;

use super::dynamics::GasDynamics;
use super::node::GasSums;
use super::physics::Physics;
use super::state::Gas;
use super::storage::Workspace;
use super::viscosity::Viscosity;

/// The forces of a gas on the walls of its domain, in solver units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallForces<const D: usize> {
    /// On the lower and the upper wall across each direction; 0 where there is none.
    pub force: [[[f64; D]; 2]; D],
    /// The power of moving walls: what they add to the energy of the gas in a unit of time.
    pub power: f64,
}

impl<const D: usize> WallForces<D> {
    /// None.
    pub const NONE: Self = Self {
        force: [[[0.0; D]; 2]; D],
        power: 0.0,
    };

    /// Adds the force of an image in walls on a particle, with the opposite sign. What points across a wall
    /// is that of this wall; what lies along all of them they share, those that the gas sticks to where
    /// there are any.
    fn add(
        &mut self,
        image: &Image<D>,
        force: &[f64; D],
        sticks: impl Fn(usize, usize) -> bool + Copy,
    ) {
        let walls = || image.ends();
        let are_any = walls().any(|(axis, end)| sticks(axis, end));
        let holds = |&(axis, end): &(usize, usize)| sticks(axis, end) || !are_any;
        let count = walls().filter(holds).count().max(1) as f64;
        for i in 0..D {
            let across = walls().find(|(axis, _)| *axis == i);
            for (axis, end) in walls() {
                let share = match across {
                    Some((own, _)) if own == axis => 1.0,
                    Some(_) => continue,
                    None if holds(&(axis, end)) => 1.0 / count,
                    None => continue,
                };
                let wall = self.force.get_mut(axis).and_then(|ends| ends.get_mut(end));
                if let Some(component) = wall.and_then(|wall| wall.get_mut(i)) {
                    *component -= share * force[i];
                }
            }
        }
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
    /// What the gas exerts on the walls of its domain: minus the forces of all images, in the order of
    /// summation. Of a state as the last step left it, or [`GasDynamics::prepare`]; 0 before.
    ///
    /// The forces of particles on one another cancel, so that the momentum of the gas changes by minus the
    /// sum of these forces, and of what else acts on it.
    pub fn wall_forces(
        &self,
        gas: &Gas<'_, S, D>,
        work: &Workspace<'_, S, P::Shown, D>,
    ) -> WallForces<D> {
        let mut forces = WallForces::NONE;
        let (Some(grid), n) = (*work.grid, gas.len()) else {
            return forces;
        };
        if !grid.has_walls() {
            return forces;
        }
        let (law, walls) = (self.motion(), grid.walls());
        let cells = work.cells.cells(grid, n);
        let nodes = work.nodes.get(..n).unwrap_or(&[]);
        let no_slip = self.physics.no_slip();
        let sticks = |axis, end| no_slip.of(axis, end).is_some();
        for (place, (shown, site)) in numbered(nodes.iter().zip(cells.sites())) {
            if self.domain.passed(&site.position).is_some() {
                continue;
            }
            let k = shown.splat::<S>();
            each_image(&cells, place, |partner: &Partner<S, D>| {
                let Some(shown) = nodes.get(partner.place) else {
                    return;
                };
                let mut shown = *shown;
                for wall in partner.image.walls(&walls) {
                    shown = law.reflected(&shown, &wall);
                }
                let l = shown.splat::<S>();
                let apart = Separation::of(&law, [&k, &l], partner.r, partner.distance_squared);
                let mut to_k = GasSums::<S, D>::ZERO.splat::<S>();
                let mut to_l = to_k;
                law.pair_behind([&k, &l], &partner.image, &apart, &mut to_k, &mut to_l);
                let force = to_k.force.map(S::to_f64);
                forces.add(&partner.image, &force, sticks);
                if let Some(seen) = no_slip.seen::<S>(&partner.image) {
                    let velocity = seen.wall_velocity().map(S::to_f64);
                    let terms = force.iter().zip(velocity);
                    forces.power += terms.map(|(force, u)| force * u).sum::<f64>();
                }
            });
        }
        forces
    }
}
