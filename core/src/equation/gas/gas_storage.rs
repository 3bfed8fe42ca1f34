//! All the memory of a gas in one piece, for a device.

use heapless::Vec;

use crate::equation::{Dynamics, Parts, Storage};
use crate::error::{Container, Error};
use crate::neighbours::{CellBuffers, Grid, Site};
use crate::numbered::numbered;
use crate::pairs::{Fields, Nothing, Settled};
use crate::scalar::Scalar;

use super::density::{DensityNode, DensitySums};
use super::exchange::Extras;
use super::gradient::{GradientNode, GradientSums};
use super::node::{GasNode, GasSums};
use super::open::Cloud;
use super::state::{Before, Gas, Particle};
use super::storage::{GradientBuffers, Workspace};

/// A gas of at most `N` particles on at most `C - 1` cells, with its workspace, in one piece
/// of memory without a heap.
///
/// `X` is what its terms show: [`Nothing`](crate::pairs::Nothing) with
/// [`Plain`](super::Plain), [`Extras`](super::exchange::Extras) with [`Options`](super::Options).
/// `G` is `N` where options need gradients, else 0. `C` must exceed
/// [`cell_bound`](crate::neighbours::cell_bound)`(N)`. [`GasStorage::new`] is
/// `const`, and all bits of an empty storage are 0 but for the heapless lengths: a `static`
/// one costs no flash and no stack.
pub struct GasStorage<
    S: Scalar,
    X: Fields<S>,
    const D: usize,
    const N: usize,
    const G: usize,
    const C: usize,
> {
    arrays: Arrays<S, D, N>,
    sites: [Site<S, D>; N],
    order: [u32; N],
    cell_of: [u32; N],
    starts: [u32; C],
    grid: Option<Grid<S, D>>,
    density_nodes: [DensityNode<S, D>; N],
    densities: [Settled<DensityNode<S, D>, DensitySums<S, D>>; N],
    nodes: [GasNode<S, X, D>; N],
    rates: [Settled<GasNode<S, X, D>, GasSums<S, D>>; N],
    gradient_nodes: [GradientNode<S, D>; G],
    gradients: [Settled<GradientNode<S, D>, GradientSums<S, D>>; G],
    before: Vec<Before<S, D>, N>,
}

/// The arrays of the state.
struct Arrays<S, const D: usize, const N: usize> {
    position: Vec<[S; D], N>,
    velocity: Vec<[S; D], N>,
    position_remainder: [[S; D]; N],
    velocity_remainder: [[S; D]; N],
    energy: Vec<S, N>,
    mass: Vec<S, N>,
    epsilon: Vec<S, N>,
    material: Vec<u8, N>,
    density: [S; N],
    force: [[S; D]; N],
    power: [S; N],
    heat: [S; N],
    power_slope: [S; N],
    viscosity_factor: [S; N],
    divergence: [S; N],
    approach: [S; N],
    signal: [S; N],
    neighbours: [S; N],
}

impl<S: Scalar, const D: usize, const N: usize> Arrays<S, D, N> {
    const fn new() -> Self {
        Self {
            position: Vec::new(),
            velocity: Vec::new(),
            position_remainder: [[S::ZERO; D]; N],
            velocity_remainder: [[S::ZERO; D]; N],
            energy: Vec::new(),
            mass: Vec::new(),
            epsilon: Vec::new(),
            material: Vec::new(),
            density: [S::ZERO; N],
            force: [[S::ZERO; D]; N],
            power: [S::ZERO; N],
            heat: [S::ZERO; N],
            power_slope: [S::ZERO; N],
            viscosity_factor: [S::ZERO; N],
            divergence: [S::ZERO; N],
            approach: [S::ZERO; N],
            signal: [S::ZERO; N],
            neighbours: [S::ZERO; N],
        }
    }

    fn gas(&mut self) -> Gas<'_, S, D> {
        let n = self.mass.len();
        Gas {
            position: &mut self.position,
            velocity: &mut self.velocity,
            position_remainder: self.position_remainder.get_mut(..n).unwrap_or(&mut []),
            velocity_remainder: self.velocity_remainder.get_mut(..n).unwrap_or(&mut []),
            energy: &mut self.energy,
            mass: &mut self.mass,
            material: &mut self.material,
            epsilon: &mut self.epsilon,
            density: self.density.get_mut(..n).unwrap_or(&mut []),
            force: self.force.get_mut(..n).unwrap_or(&mut []),
            power: self.power.get_mut(..n).unwrap_or(&mut []),
            heat: self.heat.get_mut(..n).unwrap_or(&mut []),
            power_slope: self.power_slope.get_mut(..n).unwrap_or(&mut []),
            viscosity_factor: self.viscosity_factor.get_mut(..n).unwrap_or(&mut []),
            divergence: self.divergence.get_mut(..n).unwrap_or(&mut []),
            approach: self.approach.get_mut(..n).unwrap_or(&mut []),
            signal: self.signal.get_mut(..n).unwrap_or(&mut []),
            neighbours: self.neighbours.get_mut(..n).unwrap_or(&mut []),
        }
    }
}

/// The storage of a gas that follows the paper's equations: [`Plain`](super::Plain).
pub type PlainStorage<S, const D: usize, const N: usize, const C: usize> =
    GasStorage<S, Nothing, D, N, 0, C>;

/// The storage of a gas with [`Options`](super::Options).
pub type OptionsStorage<S, const D: usize, const N: usize, const C: usize> =
    GasStorage<S, Extras<S, D>, D, N, N, C>;

impl<S: Scalar, X: Fields<S>, const D: usize, const N: usize, const G: usize, const C: usize>
    Default for GasStorage<S, X, D, N, G, C>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, X: Fields<S>, const D: usize, const N: usize, const G: usize, const C: usize>
    GasStorage<S, X, D, N, G, C>
{
    /// An empty cloud.
    pub const fn new() -> Self {
        Self {
            arrays: Arrays::new(),
            sites: [Site::EMPTY; N],
            order: [0; N],
            cell_of: [0; N],
            starts: [0; C],
            grid: None,
            density_nodes: [DensityNode::ZERO; N],
            densities: [Settled::new(DensityNode::ZERO, DensitySums::ZERO); N],
            nodes: [GasNode::ZERO; N],
            rates: [Settled::new(GasNode::ZERO, GasSums::ZERO); N],
            gradient_nodes: [GradientNode::ZERO; G],
            gradients: [Settled::new(GradientNode::ZERO, GradientSums::ZERO); G],
            before: Vec::new(),
        }
    }

    /// Adds a particle; its id is the number of particles before it. Error: no room.
    pub fn push(&mut self, particle: Particle<S, D>) -> Result<(), Error> {
        let full = Error::Capacity {
            container: Container::Particles,
            needed: (self.arrays.mass.len() as u32).saturating_add(1),
            capacity: N as u32,
        };
        self.arrays
            .position
            .push(particle.position)
            .map_err(|_| full)?;
        self.arrays
            .velocity
            .push(particle.velocity)
            .map_err(|_| full)?;
        self.arrays.mass.push(particle.mass).map_err(|_| full)?;
        self.arrays.energy.push(particle.energy).map_err(|_| full)?;
        self.arrays
            .epsilon
            .push(particle.epsilon)
            .map_err(|_| full)?;
        self.arrays
            .material
            .push(particle.material)
            .map_err(|_| full)
    }

    /// Removes all particles.
    pub fn clear(&mut self) {
        self.before.clear();
        self.arrays.position.clear();
        self.arrays.velocity.clear();
        self.arrays.mass.clear();
        self.arrays.energy.clear();
        self.arrays.epsilon.clear();
        self.arrays.material.clear();
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (Gas<'_, S, D>, Workspace<'_, S, X, D>) {
        let gas = self.arrays.gas();
        let work = Workspace {
            cells: CellBuffers {
                sites: &mut self.sites,
                order: &mut self.order,
                cell_of: &mut self.cell_of,
                starts: &mut self.starts,
            },
            grid: &mut self.grid,
            density_nodes: &mut self.density_nodes,
            densities: &mut self.densities,
            nodes: &mut self.nodes,
            rates: &mut self.rates,
            gradients: GradientBuffers {
                nodes: &mut self.gradient_nodes,
                sums: &mut self.gradients,
            },
        };
        (gas, work)
    }
}

impl<S: Scalar, X: Fields<S>, const D: usize, const N: usize, const G: usize, const C: usize>
    Cloud<S, D> for GasStorage<S, X, D, N, G, C>
{
    fn gas(&mut self) -> Gas<'_, S, D> {
        self.parts().0
    }

    fn insert(&mut self, particle: Particle<S, D>, density: S) -> Result<(), Error> {
        let id = self.arrays.mass.len();
        self.push(particle)?;
        put(&mut self.arrays.density, id, density);
        put(&mut self.arrays.position_remainder, id, [S::ZERO; D]);
        put(&mut self.arrays.velocity_remainder, id, [S::ZERO; D]);
        put(&mut self.arrays.force, id, [S::ZERO; D]);
        put(&mut self.arrays.power, id, S::ZERO);
        put(&mut self.arrays.heat, id, S::ZERO);
        put(&mut self.arrays.power_slope, id, S::ZERO);
        put(&mut self.arrays.viscosity_factor, id, S::ZERO);
        put(&mut self.arrays.divergence, id, S::ZERO);
        put(&mut self.arrays.approach, id, S::ZERO);
        put(&mut self.arrays.signal, id, S::ZERO);
        put(&mut self.arrays.neighbours, id, S::ZERO);
        Ok(())
    }

    fn swap_remove(&mut self, id: usize) {
        let Some(last) = self.arrays.mass.len().checked_sub(1) else {
            return;
        };
        if id > last {
            return;
        }
        take_last(&mut self.arrays.position, id);
        take_last(&mut self.arrays.velocity, id);
        take_last(&mut self.arrays.energy, id);
        take_last(&mut self.arrays.mass, id);
        take_last(&mut self.arrays.epsilon, id);
        take_last(&mut self.arrays.material, id);
        // Nothing reads what is left beyond the end.
        for array in [
            &mut self.arrays.density,
            &mut self.arrays.power,
            &mut self.arrays.heat,
            &mut self.arrays.power_slope,
            &mut self.arrays.viscosity_factor,
            &mut self.arrays.divergence,
            &mut self.arrays.approach,
            &mut self.arrays.signal,
            &mut self.arrays.neighbours,
        ] {
            if let Some(&value) = array.get(last) {
                put(array, id, value);
            }
        }
        for array in [
            &mut self.arrays.position_remainder,
            &mut self.arrays.velocity_remainder,
            &mut self.arrays.force,
        ] {
            if let Some(&value) = array.get(last) {
                put(array, id, value);
            }
        }
    }
}

impl<S, X, Y, const D: usize, const N: usize, const G: usize, const C: usize> Storage<S, Y, D>
    for GasStorage<S, X, D, N, G, C>
where
    S: Scalar,
    X: Fields<S>,
    Y: for<'a> Dynamics<
            S,
            D,
            State<'a> = Gas<'a, S, D>,
            Work<'a> = Workspace<'a, S, X, D>,
            Particle = Particle<S, D>,
        >,
{
    fn parts(&mut self) -> Parts<'_, S, Y, D> {
        let (state, work) = self.parts();
        Parts { state, work }
    }
    fn insert(&mut self, particle: Particle<S, D>) -> Result<(), Error> {
        Cloud::insert(self, particle, S::ZERO)
    }
    fn swap_remove(&mut self, id: usize) {
        Cloud::swap_remove(self, id);
    }
    fn keep(&mut self) {
        self.before.clear();
        let gas = self.arrays.gas();
        for id in 0..gas.len() {
            // There is room for as many as there are particles.
            let _ = gas.kept(id).map(|particle| self.before.push(particle));
        }
    }
    fn restore(&mut self) {
        let mut gas = self.arrays.gas();
        for (id, particle) in numbered(&self.before) {
            gas.put_back(id, particle);
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
