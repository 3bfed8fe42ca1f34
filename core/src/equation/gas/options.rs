//! What a gas solver may do beyond the paper's equations.

use crate::scalar::Scalar;

use super::far::Far;
use super::walls::NoSlip;

/// What a particle weighs in sums over its neighbours. The paper leaves the weights w_k free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weights {
    /// `w_k = m_k/ρ_k`, `ρ_k = Σ_l m_l ζ_kl` (3.13): right where the density is smooth.
    #[default]
    Mass,
    /// `w_k = 1/Σ_l ζ_kl`, `ρ_k = m_k/w_k`: the density of a particle depends on the places
    /// of its partners and not on their masses, so it may jump between two fluids whose
    /// particles are equally spaced (Ott & Schnetter, physics/0303112, 2003).
    Number,
}

/// How the energy goes from one time to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EnergyForm {
    /// Internal energy (3.12) by leap-frog: the total drifts by the square of the step.
    #[default]
    LeapFrog,
    /// Internal energy by the work that the pair forces do over each half of a step: the
    /// total is conserved to round-off for any step, at the price of one more sweep.
    Exact,
    /// Total energy (3.11): conserved to round-off too; the internal energy is a difference,
    /// and has few digits in cold, fast gas.
    Total,
}

/// A viscosity that decays away from shocks: see [`super::switch`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch<S> {
    /// The smallest factor of α, in [0, 1].
    pub minimum: S,
    /// ℓ, the rate of decay in `(c + fastest approach)/ε`, > 0.
    pub decay: S,
}

/// Physical coefficients, the same for all particles: those of Navier, Stokes and Fourier. In any
/// dimension the stress is that of a gas in space,
/// `σ = ρ ν (∇u + ∇uᵀ - 2/3 div u) + ρ ν_b div u`: see [`super::stress`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diffusion<S> {
    /// Kinematic shear viscosity ν, length²/time, >= 0.
    pub viscosity: S,
    /// Kinematic bulk viscosity ν_b, length²/time, >= 0.
    pub bulk_viscosity: S,
    /// Thermal diffusivity, length²/time, >= 0, of the internal energy within a material.
    pub heat: S,
}

/// The paper's equations, with the fastest loops and the least memory: the law of
/// [`super::motion`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plain<S, const D: usize> {
    /// The weight rule.
    pub weights: Weights,
    /// External acceleration, length/time².
    pub acceleration: [S; D],
    /// The gas far beyond the lower and the upper side of the open direction, where it is known.
    pub far: [Option<Far<S>>; 2],
}

impl<S: Scalar, const D: usize> Plain<S, D> {
    /// Weights by mass, no external acceleration, and no gas beyond the sides.
    pub const DEFAULT: Self = Self {
        weights: Weights::Mass,
        acceleration: [S::ZERO; D],
        far: [None; 2],
    };
}

/// What a gas solver may do beyond the paper's equations: the law of [`super::exchange`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options<S, const D: usize> {
    /// Weights and external acceleration.
    pub plain: Plain<S, D>,
    /// The energy.
    pub energy: EnergyForm,
    /// Whether the viscosity sees velocities that are reconstructed between the particles.
    pub limited: bool,
    /// Whether pressure acts along gradients that are exact for linear fields: see
    /// [`super::direction`].
    pub linear_exact: bool,
    /// Whether the viscosity decays away from shocks.
    pub switch: Option<Switch<S>>,
    /// Whether the viscosity spares shear: Balsara's factor.
    pub balsara: bool,
    /// Coefficient of the artificial conductivity, >= 0.
    pub conduction: S,
    /// Physical viscosity and heat conduction.
    pub diffusion: Diffusion<S>,
    /// The walls that the gas sticks to; they act by the physical viscosity.
    pub walls: NoSlip<S, D>,
    /// A pressure `p_0` that the materials leave out: theirs is `p - p_0`, and their energy `e + p_0/ρ`, so that
    /// the work of the one is the change of the other. Heat is conducted along e.
    pub background: S,
}

impl<S: Scalar> Diffusion<S> {
    /// None.
    pub const OFF: Self = Self {
        viscosity: S::ZERO,
        bulk_viscosity: S::ZERO,
        heat: S::ZERO,
    };

    /// Whether there is a viscous stress.
    pub fn is_viscous(&self) -> bool {
        self.viscosity > S::ZERO || self.bulk_viscosity > S::ZERO
    }
}

impl<S: Scalar, const D: usize> Options<S, D> {
    /// Everything off: the paper's equations.
    pub const OFF: Self = Self {
        plain: Plain::DEFAULT,
        energy: EnergyForm::LeapFrog,
        limited: false,
        linear_exact: false,
        switch: None,
        balsara: false,
        conduction: S::ZERO,
        diffusion: Diffusion::OFF,
        walls: NoSlip::NONE,
        background: S::ZERO,
    };

    /// Whether anything but the viscous stress needs the gradients of velocities.
    pub(super) fn switches(&self) -> bool {
        self.limited || self.balsara || self.switch.is_some()
    }

    /// Whether gradients are needed.
    pub fn need_gradients(&self) -> bool {
        self.switches()
            || self.linear_exact
            || self.conduction > S::ZERO
            || self.diffusion.is_viscous()
    }

    /// Whether anything is on that [`Plain`] has not. Where nothing is, [`Plain`] gives the same
    /// bits faster, in less memory.
    pub fn need_exchange(&self) -> bool {
        self.need_gradients()
            || self.energy != EnergyForm::LeapFrog
            || self.diffusion.heat > S::ZERO
    }
}
