//! Which law a gas solver follows, chosen when it is compiled: a device only holds the code of
//! the law that it uses.

use crate::cutoff::CutOff;
use crate::error::Error;
use crate::material::EquationOfState;
use crate::neighbours::Grid;
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::dynamics::GasDynamics;
use super::options::{Options, Plain};
use super::state::Gas;
use super::storage::Workspace;
use super::viscosity::Viscosity;

/// Which law a gas solver follows: [`Plain`] or [`Options`].
pub trait Physics<S: Scalar, const D: usize>: Copy {
    /// Weights and external acceleration.
    fn plain(&self) -> &Plain<S, D>;
    /// Physical diffusivities, summed.
    fn diffusivity(&self) -> S;
    /// Forces and powers of settled densities; closes the step.
    fn rates<C: CutOff, V: Viscosity<S>, E: EquationOfState<S>>(
        solver: &GasDynamics<'_, S, C, V, E, Self, D>,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, D>,
        settled: Settled<S, D>,
    ) -> Result<(), Error>;
}

/// A cloud whose densities are settled.
#[derive(Clone, Copy, Debug)]
pub struct Settled<S, const D: usize> {
    /// How it is sorted.
    pub(super) grid: Grid<S, D>,
    /// The step that brought it here.
    pub(super) dt: S,
}

impl<S: Scalar, const D: usize> Physics<S, D> for Plain<S, D> {
    fn plain(&self) -> &Plain<S, D> {
        self
    }
    fn diffusivity(&self) -> S {
        S::ZERO
    }
    fn rates<C: CutOff, V: Viscosity<S>, E: EquationOfState<S>>(
        solver: &GasDynamics<'_, S, C, V, E, Self, D>,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, D>,
        settled: Settled<S, D>,
    ) -> Result<(), Error> {
        solver.motion_rates(engine, gas, work, settled.grid, settled.dt)
    }
}

impl<S: Scalar, const D: usize> Physics<S, D> for Options<S, D> {
    fn plain(&self) -> &Plain<S, D> {
        &self.plain
    }
    fn diffusivity(&self) -> S {
        self.diffusion.viscosity + self.diffusion.heat
    }
    fn rates<C: CutOff, V: Viscosity<S>, E: EquationOfState<S>>(
        solver: &GasDynamics<'_, S, C, V, E, Self, D>,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, D>,
        settled: Settled<S, D>,
    ) -> Result<(), Error> {
        solver.exchange_rates(engine, gas, work, settled.grid, settled.dt)
    }
}
