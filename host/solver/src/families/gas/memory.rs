//! A gas in growing arrays: the same solver as on a device, in the memory of a server.

use motes_core::equation::gas::density::{DensityNode, DensitySums};
use motes_core::equation::gas::exchange::Extras;
use motes_core::equation::gas::gradient::{GradientNode, GradientSums};
use motes_core::equation::gas::motion::{GasNode, GasSums};
use motes_core::equation::gas::{Cloud, Gas, GradientBuffers, Options, Particle, Workspace};
use motes_core::equation::linear::Nothing;
use motes_core::error::{Container, Error};
use motes_core::neighbours::{CellBuffers, Grid, Site, cell_bound};
use motes_core::pairs::{Fields, Settled};
use motes_core::scalar::Scalar;

use crate::setup::LARGEST;

/// The state of a gas and the workspace of its solver.
pub struct GasArrays<S: Scalar, X: Fields<S>, const D: usize> {
    pub(super) position: Vec<[S; D]>,
    pub(super) velocity: Vec<[S; D]>,
    pub(super) energy: Vec<S>,
    pub(super) mass: Vec<S>,
    pub(super) epsilon: Vec<S>,
    pub(super) material: Vec<u8>,
    pub(super) density: Vec<S>,
    position_remainder: Vec<[S; D]>,
    velocity_remainder: Vec<[S; D]>,
    force: Vec<[S; D]>,
    power: Vec<S>,
    heat: Vec<S>,
    power_slope: Vec<S>,
    pub(super) viscosity_factor: Vec<S>,
    pub(super) divergence: Vec<S>,
    approach: Vec<S>,
    signal: Vec<S>,
    pub(super) neighbours: Vec<S>,
    sites: Vec<Site<S, D>>,
    order: Vec<u32>,
    cell_of: Vec<u32>,
    starts: Vec<u32>,
    grid: Option<Grid<S, D>>,
    density_nodes: Vec<DensityNode<S, D>>,
    densities: Vec<Settled<DensityNode<S, D>, DensitySums<S, D>>>,
    nodes: Vec<GasNode<S, X, D>>,
    rates: Vec<Settled<GasNode<S, X, D>, GasSums<S, D>>>,
    gradient_nodes: Vec<GradientNode<S, D>>,
    gradients: Vec<Settled<GradientNode<S, D>, GradientSums<S, D>>>,
    /// Whether the options ask for gradients.
    graded: bool,
}

/// The arrays of a gas that follows the paper's equations.
pub type PlainArrays<S, const D: usize> = GasArrays<S, Nothing, D>;

/// The arrays of a gas with [`Options`].
pub type OptionsArrays<S, const D: usize> = GasArrays<S, Extras<S, D>, D>;

impl<S: Scalar, X: Fields<S>, const D: usize> GasArrays<S, X, D> {
    /// Bytes that one particle takes, state, workspace and a typical neighbour list.
    pub fn bytes_per_particle(options: &Options<S, D>) -> usize {
        let gradients = size_of::<GradientNode<S, D>>()
            + size_of::<Settled<GradientNode<S, D>, GradientSums<S, D>>>();
        size_of::<[S; D]>() * 5
            + size_of::<S>() * 11
            + size_of::<Site<S, D>>()
            + size_of::<u32>() * (6 + 16)
            + size_of::<DensityNode<S, D>>()
            + size_of::<Settled<DensityNode<S, D>, DensitySums<S, D>>>()
            + size_of::<GasNode<S, X, D>>()
            + size_of::<Settled<GasNode<S, X, D>, GasSums<S, D>>>()
            + gradients * usize::from(options.need_gradients())
    }

    /// A cloud of these particles, with memory for what the options need; ids are places.
    pub fn new(
        particles: impl IntoIterator<Item = Particle<S, D>>,
        options: &Options<S, D>,
    ) -> Self {
        let particles = particles.into_iter();
        let most = particles.size_hint().0;
        let scalars = || Vec::with_capacity(most);
        let mut arrays = Self {
            position: Vec::with_capacity(most),
            velocity: Vec::with_capacity(most),
            energy: scalars(),
            mass: scalars(),
            epsilon: scalars(),
            material: Vec::with_capacity(most),
            density: Vec::new(),
            position_remainder: Vec::new(),
            velocity_remainder: Vec::new(),
            force: Vec::new(),
            power: Vec::new(),
            heat: Vec::new(),
            power_slope: Vec::new(),
            viscosity_factor: Vec::new(),
            divergence: Vec::new(),
            approach: Vec::new(),
            signal: Vec::new(),
            neighbours: Vec::new(),
            sites: Vec::new(),
            order: Vec::new(),
            cell_of: Vec::new(),
            starts: Vec::new(),
            grid: None,
            density_nodes: Vec::new(),
            densities: Vec::new(),
            nodes: Vec::new(),
            rates: Vec::new(),
            gradient_nodes: Vec::new(),
            gradients: Vec::new(),
            graded: options.need_gradients(),
        };
        // What they come from is gone before the workspace is there.
        particles.for_each(|particle| arrays.put(&particle));
        let n = arrays.mass.len();
        arrays.position_remainder.resize(n, [S::ZERO; D]);
        arrays.velocity_remainder.resize(n, [S::ZERO; D]);
        arrays.force.resize(n, [S::ZERO; D]);
        arrays.density.resize(n, S::ZERO);
        for array in arrays.made() {
            array.resize(n, S::ZERO);
        }
        arrays.make_room(n);
        arrays
    }

    /// Adds what is given of a particle.
    fn put(&mut self, particle: &Particle<S, D>) {
        self.position.push(particle.position);
        self.velocity.push(particle.velocity);
        self.energy.push(particle.energy);
        self.mass.push(particle.mass);
        self.epsilon.push(particle.epsilon);
        self.material.push(particle.material);
    }

    /// Makes `e + p_0/ρ` of energies e.
    pub(super) fn energize(&mut self, given: &[S], background: f64, densities: Vec<S>) {
        let energies = self.energy.iter_mut().zip(given).zip(densities);
        for ((energy, given), density) in energies {
            *energy = S::from_f64(given.to_f64() + background / density.to_f64());
        }
    }

    /// What the solver makes of a particle, beside its density and force.
    fn made(&mut self) -> [&mut Vec<S>; 8] {
        [
            &mut self.power,
            &mut self.heat,
            &mut self.power_slope,
            &mut self.viscosity_factor,
            &mut self.divergence,
            &mut self.approach,
            &mut self.signal,
            &mut self.neighbours,
        ]
    }

    /// Gives the workspace room for so many particles.
    fn make_room(&mut self, n: usize) {
        self.sites.resize(n, Site::EMPTY);
        self.order.resize(n, 0);
        self.cell_of.resize(n, 0);
        self.starts.resize(cell_bound(n as u32) as usize + 1, 0);
        self.density_nodes.resize(n, DensityNode::ZERO);
        let density = Settled::new(DensityNode::ZERO, DensitySums::ZERO);
        self.densities.resize(n, density);
        self.nodes.resize(n, GasNode::ZERO);
        let rate = Settled::new(GasNode::ZERO, GasSums::ZERO);
        self.rates.resize(n, rate);
        let graded = if self.graded { n } else { 0 };
        self.gradient_nodes.resize(graded, GradientNode::ZERO);
        let gradient = Settled::new(GradientNode::ZERO, GradientSums::ZERO);
        self.gradients.resize(graded, gradient);
    }

    /// Makes room for so many particles, to be read into: beyond those there they are empty.
    ///
    /// Error: more than can be counted.
    pub(super) fn resize(&mut self, particles: u64) -> Result<(), Error> {
        let n = usize::try_from(particles).unwrap_or(usize::MAX);
        if n > LARGEST {
            return Err(Error::Capacity {
                container: Container::Particles,
                needed: u32::try_from(particles).unwrap_or(u32::MAX),
                capacity: LARGEST as u32,
            });
        }
        self.material.resize(n, 0);
        for array in [
            &mut self.position,
            &mut self.velocity,
            &mut self.position_remainder,
            &mut self.velocity_remainder,
            &mut self.force,
        ] {
            array.resize(n, [S::ZERO; D]);
        }
        for array in [
            &mut self.energy,
            &mut self.mass,
            &mut self.epsilon,
            &mut self.density,
        ] {
            array.resize(n, S::ZERO);
        }
        for array in self.made() {
            array.resize(n, S::ZERO);
        }
        if n > self.sites.len() {
            self.make_room(n);
        }
        Ok(())
    }

    /// The state and the workspace, as the solver takes them.
    pub fn parts(&mut self) -> (Gas<'_, S, D>, Workspace<'_, S, X, D>) {
        let gas = Gas {
            position: &mut self.position,
            velocity: &mut self.velocity,
            energy: &mut self.energy,
            mass: &mut self.mass,
            material: &mut self.material,
            epsilon: &mut self.epsilon,
            density: &mut self.density,
            position_remainder: &mut self.position_remainder,
            velocity_remainder: &mut self.velocity_remainder,
            force: &mut self.force,
            power: &mut self.power,
            heat: &mut self.heat,
            power_slope: &mut self.power_slope,
            viscosity_factor: &mut self.viscosity_factor,
            divergence: &mut self.divergence,
            approach: &mut self.approach,
            signal: &mut self.signal,
            neighbours: &mut self.neighbours,
        };
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

impl<S: Scalar, X: Fields<S>, const D: usize> Cloud<S, D> for GasArrays<S, X, D> {
    fn gas(&mut self) -> Gas<'_, S, D> {
        self.parts().0
    }

    fn insert(&mut self, particle: Particle<S, D>, density: S) -> Result<(), Error> {
        let n = self.mass.len() + 1;
        if n > LARGEST {
            return Err(Error::Capacity {
                container: Container::Particles,
                needed: n as u32,
                capacity: LARGEST as u32,
            });
        }
        self.put(&particle);
        self.density.push(density);
        self.position_remainder.push([S::ZERO; D]);
        self.velocity_remainder.push([S::ZERO; D]);
        self.force.push([S::ZERO; D]);
        for array in self.made() {
            array.push(S::ZERO);
        }
        if n > self.sites.len() {
            // Ahead by an eighth: growing costs little a particle.
            self.make_room((n + n / 8).min(LARGEST));
        }
        Ok(())
    }

    fn swap_remove(&mut self, id: usize) {
        if id >= self.mass.len() {
            return;
        }
        self.position.swap_remove(id);
        self.velocity.swap_remove(id);
        self.material.swap_remove(id);
        self.position_remainder.swap_remove(id);
        self.velocity_remainder.swap_remove(id);
        self.force.swap_remove(id);
        for array in [
            &mut self.energy,
            &mut self.mass,
            &mut self.epsilon,
            &mut self.density,
        ] {
            array.swap_remove(id);
        }
        for array in self.made() {
            array.swap_remove(id);
        }
    }
}
