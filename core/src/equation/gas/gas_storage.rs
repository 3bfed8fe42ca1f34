//! All the memory of a gas in one piece, for a device.

use heapless::Vec;

use crate::error::{Container, Error};
use crate::neighbours::{CellBuffers, Site};
use crate::pairs::{Fields, Settled};
use crate::scalar::Scalar;

use super::density::{DensityNode, DensitySums};
use super::motion::{GasNode, GasSums};
use super::open::Cloud;
use super::state::{Gas, Particle};
use super::storage::{ExchangeWorkspace, Workspace};

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
    material: Vec<u8, N>,
    density: [S; N],
    force: [[S; D]; N],
    power: [S; N],
    power_slope: [S; N],
    viscosity_factor: [S; N],
    divergence: [S; N],
    approach: [S; N],
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
            material: Vec::new(),
            density: [S::ZERO; N],
            force: [[S::ZERO; D]; N],
            power: [S::ZERO; N],
            power_slope: [S::ZERO; N],
            viscosity_factor: [S::ZERO; N],
            divergence: [S::ZERO; N],
            approach: [S::ZERO; N],
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
        self.epsilon.push(particle.epsilon).map_err(|_| full)?;
        self.material.push(particle.material).map_err(|_| full)
    }

    /// Removes all particles.
    pub fn clear(&mut self) {
        self.position.clear();
        self.velocity.clear();
        self.mass.clear();
        self.energy.clear();
        self.epsilon.clear();
        self.material.clear();
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (Gas<'_, S, D>, Workspace<'_, S, D>) {
        let n = self.mass.len();
        let gas = Gas {
            position: &mut self.position,
            velocity: &mut self.velocity,
            energy: &mut self.energy,
            mass: &self.mass,
            material: &self.material,
            epsilon: &mut self.epsilon,
            density: self.density.get_mut(..n).unwrap_or(&mut []),
            force: self.force.get_mut(..n).unwrap_or(&mut []),
            power: self.power.get_mut(..n).unwrap_or(&mut []),
            power_slope: self.power_slope.get_mut(..n).unwrap_or(&mut []),
            viscosity_factor: self.viscosity_factor.get_mut(..n).unwrap_or(&mut []),
            divergence: self.divergence.get_mut(..n).unwrap_or(&mut []),
            approach: self.approach.get_mut(..n).unwrap_or(&mut []),
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
            exchange: ExchangeWorkspace::default(),
        };
        (gas, work)
    }
}

impl<S: Scalar, const D: usize, const N: usize, const C: usize> Cloud<S, D>
    for GasStorage<S, D, N, C>
{
    fn gas(&mut self) -> Gas<'_, S, D> {
        self.parts().0
    }

    fn insert(&mut self, particle: Particle<S, D>, density: S) -> Result<(), Error> {
        let id = self.mass.len();
        self.push(particle)?;
        put(&mut self.density, id, density);
        put(&mut self.force, id, [S::ZERO; D]);
        put(&mut self.power, id, S::ZERO);
        put(&mut self.power_slope, id, S::ZERO);
        put(&mut self.viscosity_factor, id, S::ZERO);
        put(&mut self.divergence, id, S::ZERO);
        put(&mut self.approach, id, S::ZERO);
        put(&mut self.signal, id, S::ZERO);
        put(&mut self.neighbours, id, S::ZERO);
        Ok(())
    }

    fn swap_remove(&mut self, id: usize) {
        let Some(last) = self.mass.len().checked_sub(1) else {
            return;
        };
        if id > last {
            return;
        }
        take_last(&mut self.position, id);
        take_last(&mut self.velocity, id);
        take_last(&mut self.energy, id);
        take_last(&mut self.mass, id);
        take_last(&mut self.epsilon, id);
        take_last(&mut self.material, id);
        // Nothing reads what is left beyond the end.
        for array in [
            &mut self.density,
            &mut self.power,
            &mut self.power_slope,
            &mut self.viscosity_factor,
            &mut self.divergence,
            &mut self.approach,
            &mut self.signal,
            &mut self.neighbours,
        ] {
            if let Some(&value) = array.get(last) {
                put(array, id, value);
            }
        }
        if let Some(&force) = self.force.get(last) {
            put(&mut self.force, id, force);
        }
    }
}

/// Sets an entry, where there is one.
fn put<T>(array: &mut [T], id: usize, value: T) {
    if let Some(entry) = array.get_mut(id) {
        *entry = value;
    }
}

/// Removes entry `id` of a list in which it is; the last one takes its place.
fn take_last<T, const N: usize>(list: &mut Vec<T, N>, id: usize) {
    if let Some(last) = list.pop() {
        put(list, id, last);
    }
}
