//! The state of a gas: arrays side by side, in memory that belongs to the caller.

use heapless::Vec;

use crate::error::{Container, Error, Quantity};
use crate::neighbours::{CellBuffers, Site};
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

use super::density::{DensityNode, DensitySums};
use super::motion::{GasNode, GasSums};

/// A particle as it is put into a cloud.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<S, const D: usize> {
    /// Position.
    pub position: [S; D],
    /// Velocity.
    pub velocity: [S; D],
    /// Mass, > 0.
    pub mass: S,
    /// Internal energy per mass, >= 0.
    pub energy: S,
    /// What ε is expected to be; the first density sum corrects it.
    pub epsilon: S,
}

/// The state: one array a quantity, all of the same length, indexed by particle id.
///
/// The first five make the state of the paper; the others are made from them, and are part
/// of the state because the next step starts from them.
pub struct Gas<'a, S, const D: usize> {
    /// `x`.
    pub position: &'a mut [[S; D]],
    /// `u`.
    pub velocity: &'a mut [[S; D]],
    /// `e`, internal energy per mass.
    pub energy: &'a mut [S],
    /// `m`; never changes.
    pub mass: &'a [S],
    /// ε.
    pub epsilon: &'a mut [S],
    /// ρ.
    pub density: &'a mut [S],
    /// `m du/dt`.
    pub force: &'a mut [[S; D]],
    /// `m de/dt`.
    pub power: &'a mut [S],
    /// `div u`.
    pub divergence: &'a mut [S],
    /// The speed that bounds the time step, see [`super::Viscosity::signal`].
    pub signal: &'a mut [S],
    /// Partners within the support of the last ε that was summed over (the final one may
    /// differ by [`Scalar::EXTRAPOLATION`]), without the particle itself.
    pub neighbours: &'a mut [S],
}

/// One particle of a [`Gas`]: its entry in every array.
pub(super) struct Row<'a, S, const D: usize> {
    pub(super) velocity: &'a mut [S; D],
    pub(super) energy: &'a mut S,
    pub(super) mass: S,
    pub(super) epsilon: &'a mut S,
    pub(super) density: &'a mut S,
    pub(super) force: &'a mut [S; D],
    pub(super) power: &'a mut S,
    pub(super) divergence: &'a mut S,
    pub(super) signal: &'a mut S,
    pub(super) neighbours: &'a mut S,
}

impl<S: Scalar, const D: usize> Gas<'_, S, D> {
    /// Number of particles.
    pub fn len(&self) -> usize {
        self.mass.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.mass.is_empty()
    }

    /// Whether all arrays have the same length.
    pub(super) fn is_consistent(&self) -> bool {
        let n = self.mass.len();
        let vectors = [self.position.len(), self.velocity.len(), self.force.len()];
        let scalars = [
            self.energy.len(),
            self.epsilon.len(),
            self.density.len(),
            self.power.len(),
            self.divergence.len(),
            self.signal.len(),
            self.neighbours.len(),
        ];
        vectors.iter().chain(&scalars).all(|&length| length == n)
    }

    /// The entries of particle `id`; `None` beyond the end.
    #[inline(always)]
    pub(super) fn row(&mut self, id: u32) -> Option<Row<'_, S, D>> {
        let id = id as usize;
        Some(Row {
            velocity: self.velocity.get_mut(id)?,
            energy: self.energy.get_mut(id)?,
            mass: *self.mass.get(id)?,
            epsilon: self.epsilon.get_mut(id)?,
            density: self.density.get_mut(id)?,
            force: self.force.get_mut(id)?,
            power: self.power.get_mut(id)?,
            divergence: self.divergence.get_mut(id)?,
            signal: self.signal.get_mut(id)?,
            neighbours: self.neighbours.get_mut(id)?,
        })
    }
}

impl<S: Scalar, const D: usize> Row<'_, S, D> {
    /// Velocity and energy at the end of a step, predicted by the rates of its start. The
    /// prediction of energy is kept from falling below 0.
    #[inline(always)]
    pub(super) fn predicted(&self, dt: S) -> ([S; D], S) {
        let mut velocity = *self.velocity;
        for (u, &force) in velocity.iter_mut().zip(self.force.iter()) {
            *u += dt * (force / self.mass);
        }
        let energy = *self.energy + dt * (*self.power / self.mass);
        (velocity, energy.greater(S::ZERO))
    }

    /// Half a kick with the rates held, half a kick with the new ones, which take their place.
    #[inline(always)]
    pub(super) fn kick(&mut self, dt: S, force: [S; D], power: S) {
        let half = dt.half();
        let components = self
            .velocity
            .iter_mut()
            .zip(self.force.iter_mut())
            .zip(force);
        for ((u, old), new) in components {
            *u += half * (*old / self.mass);
            *u += half * (new / self.mass);
            *old = new;
        }
        *self.energy += half * (*self.power / self.mass);
        *self.energy += half * (power / self.mass);
        *self.power = power;
    }

    /// The first thing wrong with the particle.
    pub(super) fn problem(&self, particle: u32) -> Option<Error> {
        let not_finite = |quantity| Some(Error::NotFinite { particle, quantity });
        if !self.velocity.iter().all(|u| u.is_finite()) {
            not_finite(Quantity::Velocity)
        } else if !self.energy.is_finite() {
            not_finite(Quantity::Energy)
        } else if !self.density.is_finite() {
            not_finite(Quantity::Density)
        } else if !self.epsilon.is_finite() {
            not_finite(Quantity::Epsilon)
        } else if !self.force.iter().all(|f| f.is_finite()) {
            not_finite(Quantity::Force)
        } else if !self.power.is_finite() {
            not_finite(Quantity::Power)
        } else if *self.energy < S::ZERO {
            Some(Error::NegativeEnergy { particle })
        } else {
            None
        }
    }
}

/// Memory that a step works in; nothing in it outlives the step.
pub struct Workspace<'a, S: Scalar, const D: usize> {
    /// For the search for partners.
    pub cells: CellBuffers<'a, S, D>,
    /// Nodes of the density sum, in sorted order.
    pub density_nodes: &'a mut [DensityNode<S, D>],
    /// Its results.
    pub densities: &'a mut [Settled<DensityNode<S, D>, DensitySums<S, D>>],
    /// Nodes of the motion, in sorted order.
    pub gas_nodes: &'a mut [GasNode<S, D>],
    /// Its results.
    pub rates: &'a mut [Settled<GasNode<S, D>, GasSums<S, D>>],
}

/// A gas of at most `N` particles on at most `C - 1` cells, with its workspace, in one piece
/// of memory without a heap.
///
/// `C` must exceed [`cell_bound`](crate::neighbours::cell_bound)`(N)`. [`GasStorage::new`] is
/// `const`, and all bits of an empty storage are 0 but for the heapless lengths: a `static`
/// one costs no flash and no stack.
pub struct GasStorage<S: Scalar, const D: usize, const N: usize, const C: usize> {
    position: Vec<[S; D], N>,
    velocity: Vec<[S; D], N>,
    energy: Vec<S, N>,
    mass: Vec<S, N>,
    epsilon: Vec<S, N>,
    density: [S; N],
    force: [[S; D]; N],
    power: [S; N],
    divergence: [S; N],
    signal: [S; N],
    neighbours: [S; N],
    sites: [Site<S, D>; N],
    order: [u32; N],
    cell_of: [u32; N],
    starts: [u32; C],
    density_nodes: [DensityNode<S, D>; N],
    densities: [Settled<DensityNode<S, D>, DensitySums<S, D>>; N],
    gas_nodes: [GasNode<S, D>; N],
    rates: [Settled<GasNode<S, D>, GasSums<S, D>>; N],
}

impl<S: Scalar, const D: usize, const N: usize, const C: usize> Default for GasStorage<S, D, N, C> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const D: usize, const N: usize, const C: usize> GasStorage<S, D, N, C> {
    /// An empty cloud.
    pub const fn new() -> Self {
        Self {
            position: Vec::new(),
            velocity: Vec::new(),
            energy: Vec::new(),
            mass: Vec::new(),
            epsilon: Vec::new(),
            density: [S::ZERO; N],
            force: [[S::ZERO; D]; N],
            power: [S::ZERO; N],
            divergence: [S::ZERO; N],
            signal: [S::ZERO; N],
            neighbours: [S::ZERO; N],
            sites: [Site::EMPTY; N],
            order: [0; N],
            cell_of: [0; N],
            starts: [0; C],
            density_nodes: [DensityNode::ZERO; N],
            densities: [Settled::new(DensityNode::ZERO, DensitySums::ZERO); N],
            gas_nodes: [GasNode::ZERO; N],
            rates: [Settled::new(GasNode::ZERO, GasSums::ZERO); N],
        }
    }

    /// Adds a particle; its id is the number of particles before it. Error: no room.
    pub fn push(&mut self, particle: Particle<S, D>) -> Result<(), Error> {
        let full = Error::Capacity {
            container: Container::Particles,
            needed: self.mass.len() as u32 + 1,
            capacity: N as u32,
        };
        self.position.push(particle.position).map_err(|_| full)?;
        self.velocity.push(particle.velocity).map_err(|_| full)?;
        self.mass.push(particle.mass).map_err(|_| full)?;
        self.energy.push(particle.energy).map_err(|_| full)?;
        self.epsilon.push(particle.epsilon).map_err(|_| full)
    }

    /// Removes all particles.
    pub fn clear(&mut self) {
        self.position.clear();
        self.velocity.clear();
        self.mass.clear();
        self.energy.clear();
        self.epsilon.clear();
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (Gas<'_, S, D>, Workspace<'_, S, D>) {
        let n = self.mass.len();
        let gas = Gas {
            position: &mut self.position,
            velocity: &mut self.velocity,
            energy: &mut self.energy,
            mass: &self.mass,
            epsilon: &mut self.epsilon,
            density: self.density.get_mut(..n).unwrap_or(&mut []),
            force: self.force.get_mut(..n).unwrap_or(&mut []),
            power: self.power.get_mut(..n).unwrap_or(&mut []),
            divergence: self.divergence.get_mut(..n).unwrap_or(&mut []),
            signal: self.signal.get_mut(..n).unwrap_or(&mut []),
            neighbours: self.neighbours.get_mut(..n).unwrap_or(&mut []),
        };
        let work = Workspace {
            cells: CellBuffers {
                sites: &mut self.sites,
                order: &mut self.order,
                cell_of: &mut self.cell_of,
                starts: &mut self.starts,
            },
            density_nodes: &mut self.density_nodes,
            densities: &mut self.densities,
            gas_nodes: &mut self.gas_nodes,
            rates: &mut self.rates,
        };
        (gas, work)
    }
}
