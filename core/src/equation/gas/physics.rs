//! Which law a gas solver follows, chosen when it is compiled: a device only holds the code of
//! the law that it uses.

use crate::cutoff::CutOff;
use crate::error::Error;
use crate::material::EquationOfState;
use crate::neighbours::Cells;
use crate::pairs::Engine;
use crate::pairs::Nothing;
use crate::scalar::Scalar;

use super::dynamics::GasDynamics;
use super::options::{EnergyForm, Plain};
use super::state::Gas;
use super::storage::{GradientBuffers, RatesOf};
use super::terms::{NodeOf, Terms};
use super::viscosity::Viscosity;
use super::walls::NoSlip;

/// Which law a gas solver follows: [`Plain`] or [`Options`](super::Options).
pub trait Physics<S: Scalar, const D: usize>: Terms<S, D> {
    /// Weights and external acceleration.
    fn plain(&self) -> &Plain<S, D>;
    /// The physical diffusivity that bounds the time step of a particle, length²/time.
    fn diffusivity(&self, shown: &Self::Shown) -> S {
        let _ = shown;
        S::ZERO
    }
    /// How the energy goes from one time to the next.
    fn energy(&self) -> EnergyForm {
        EnergyForm::LeapFrog
    }
    /// The walls that the gas sticks to.
    fn no_slip(&self) -> NoSlip<S, D> {
        NoSlip::NONE
    }
    /// Whether the reversible part of the work is that of the density: whether forces are derivatives of
    /// an energy of the density's sum.
    fn follows_density(&self) -> bool {
        true
    }
    /// Whether gradients of velocity and energy are made.
    fn need_gradients(&self) -> bool {
        false
    }

    /// What a particle in that state shows beyond the paper's equations.
    fn shown(&self, state: &Thermal<S>) -> Self::Shown;

    /// Refines what particles show by gradients, before the sums over pairs.
    fn refine<C: CutOff, V: Viscosity<S>, E: EquationOfState<S>>(
        solver: &GasDynamics<'_, S, C, V, E, Self, D>,
        cloud: &mut Sorted<'_, '_, S, D, impl Engine<S, D>>,
        nodes: &mut [NodeOf<S, Self, D>],
        buffers: &mut GradientBuffers<'_, S, D>,
    ) -> Result<(), Error> {
        let _ = (solver, cloud, nodes, buffers);
        Ok(())
    }

    /// Sums the energy, where that takes another sweep, after velocities have been kicked.
    fn close_energy<C: CutOff, V: Viscosity<S>, E: EquationOfState<S>>(
        solver: &GasDynamics<'_, S, C, V, E, Self, D>,
        cloud: &mut Sorted<'_, '_, S, D, impl Engine<S, D>>,
        nodes: &mut [NodeOf<S, Self, D>],
        rates: &mut RatesOf<S, Self, D>,
    ) -> Result<(), Error> {
        let _ = (solver, cloud, nodes, rates);
        Ok(())
    }
}

/// The state of the matter of a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thermal<S> {
    /// Number of its material.
    pub material: u8,
    /// ρ.
    pub density: S,
    /// p.
    pub pressure: S,
    /// e.
    pub energy: S,
    /// What the second moment of the cut-off's gradient sums to in place of 1,
    /// `-1/(D ν_k) Σ_l μ_l r·∇ζ_kl(ε_k)`: Ω, where the width follows the density.
    pub moment: S,
}

/// A sorted cloud of settled densities on its way through a step of length `dt`.
pub struct Sorted<'a, 'g, S, const D: usize, N> {
    /// Evaluates laws.
    pub(super) engine: &'a mut N,
    /// The state.
    pub(super) gas: &'a mut Gas<'g, S, D>,
    /// Its order.
    pub(super) cells: Cells<'a, S, D>,
    /// The step that brought it here.
    pub(super) dt: S,
}

impl<S: Scalar, const D: usize> Physics<S, D> for Plain<S, D> {
    fn plain(&self) -> &Plain<S, D> {
        self
    }
    fn shown(&self, _: &Thermal<S>) -> Nothing {
        Nothing
    }
}
