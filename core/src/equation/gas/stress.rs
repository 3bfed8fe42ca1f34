//! Physical viscosity: the stress of Navier and Stokes,
//!
//! `σ = ρ ν (∇u + ∇uᵀ - 2/3 div u) + ρ ν_b div u`,
//!
//! in any dimension that of a gas in space. A particle turns
//!
//! `Φ_k = V_k ρ_k [ν/M_k Σ_l w_kl |v - G_k r|² + 2 ν |S_k|² + (ν_b - 2/3 ν) (tr G_k)²]`
//!
//! into heat in a unit of time, with `r = x_k - x_l`, `v = u_k - u_l`, `w_kl = -μ_l F_kl(ε_k)`,
//! `V = m/ρ`, the gradient `G_k = Σ_l w_kl v ⊗ r M_k^-1` ([`super::gradient`]), its symmetric part `S_k`,
//! `M_k = Σ_l w_kl r ⊗ r`, and its mean diagonal in place of it where it divides. Forces are what that
//! takes from the velocities, `-1/2 ∂/∂u Σ Φ`:
//!
//! `m_k du_k/dt = -Σ_l (X_k + X_l)`, `X_k = μ_k w_kl (α_k v + A_k r)`, `m_k de_k/dt = Σ_l X_k·v = Φ_k`,
//!
//! `α = ν c`, `A = c [-ν G + (ν (G + Gᵀ) + (ν_b - 2/3 ν) tr G) U^-1]`, `c = m/(μ M)`, `U` the moments
//! over their mean diagonal `M`.
//!
//! The first sum, of what the gradient leaves unexplained, makes `α v` of it: the pair operator (4.6),
//! normalised by its own second moment, so that on a lattice a shear wave decays by `ν k²`; it damps what
//! no gradient sees. By construction `Φ_k >= 0`, `Σ Φ` is the work of the forces, and nothing acts where
//! the cloud turns as a rigid body; with it angular momentum is conserved, as momentum is.
//!
//! Considered and not taken: a stress along the lines of centres (Monaghan, Rep. Prog. Phys. 68, 1703,
//! 2005), whose fourth moments take a fifth of the shear viscosity on a lattice of squares, whatever
//! its spacing, and whose bulk viscosity is 5/3 of that of shear; (4.6) of each component alone
//! (Morris, Fox & Zhu, J. Comp. Phys. 136, 214, 1997), which brakes and heats a body that turns; gradients
//! alone (Takeda, Miyama & Sekiya, Prog. Theor. Phys. 92, 939, 1994), blind to waves of two spacings: on
//! a cloud jittered by 0.2 spacings 23 % of the viscosity is lost.
//!
//! The step is bounded by `d = (4/3 ν + ν_b)/(Ω det U)`, Ω as at most 1: see [`GasDynamics::time_step`].
//! Where partners surround a particle evenly velocities decay by at most `4 ν Σ_l V_l |F_kl| = 14 ν/ε²` (Wendland's C2
//! and M4), and `16 d/ε²` is what a step at a factor of 1 allows.

use crate::cutoff::CutOff;
use crate::error::{Error, Quantity};
use crate::material::EquationOfState;
use crate::numbered::numbered;
use crate::pairs::{Engine, Settled, holds};
use crate::scalar::Scalar;

use super::dynamics::GasDynamics;
use super::gradient::{GradientNode, GradientSums, Inverse, divergence};
use super::options::{Diffusion, Options};
use super::physics::Sorted;
use super::terms::NodeOf;
use super::viscosity::Viscosity;

/// The smallest determinant of U whose gradients carry stress: 0.30 in the corner of a cube. What has
/// partners along fewer directions has (4.6) alone.
const SMALLEST_DETERMINANT: f64 = 0.125;

impl<S: Scalar> Diffusion<S> {
    /// `ν_b - 2/3 ν`.
    fn second_viscosity(&self) -> S {
        self.bulk_viscosity - self.viscosity * S::from_f64(2.0 / 3.0)
    }

    /// `[-ν G + (ν (G + Gᵀ) + (ν_b - 2/3 ν) tr G) U^-1]`.
    fn stress<const D: usize>(
        &self,
        gradient: &[[S; D]; D],
        inverse: &Inverse<S, D>,
    ) -> [[S; D]; D] {
        let isotropic = self.second_viscosity() * divergence(gradient);
        let mut tensor = [[S::ZERO; D]; D];
        for i in 0..D {
            for j in 0..D {
                tensor[i][j] = self.viscosity * (gradient[i][j] + gradient[j][i]);
            }
            tensor[i][i] += isotropic;
        }
        let mut stress = [[S::ZERO; D]; D];
        for i in 0..D {
            for j in 0..D {
                for m in 0..D {
                    stress[i][j] += tensor[i][m] * inverse.adjugate[m][j];
                }
                stress[i][j] = stress[i][j] / inverse.determinant - self.viscosity * gradient[i][j];
            }
        }
        stress
    }

    /// A bound of what [`Diffusion::stress`] makes on its way, of a gradient with entries up to `slope`.
    fn largest<const D: usize>(&self, slope: f64) -> f64 {
        let d = D as f64;
        let shear = self.viscosity.to_f64();
        let tensor = (2.0 * shear + d * self.second_viscosity().to_f64().abs()) * slope;
        // No entry of an adjugate exceeds (3/2)² of the moments in space, nor 2 in a plane.
        let made = d * tensor * 2.25 / SMALLEST_DETERMINANT + shear * slope;
        made.max(2.0 * d * slope)
    }
}

impl<S, C, V, E, const D: usize> GasDynamics<'_, S, C, V, E, Options<S, D>, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
{
    /// What the nodes show of their viscous stress, from the velocity gradients.
    pub(super) fn stresses(
        &self,
        cloud: &mut Sorted<'_, '_, S, D, impl Engine<S, D>>,
        nodes: &mut [NodeOf<S, Options<S, D>, D>],
        gradients: &[Settled<GradientNode<S, D>, GradientSums<S, D>>],
    ) -> Result<(), Error> {
        let diffusion = &self.physics.diffusion;
        for (place, (node, gradient)) in numbered(nodes.iter_mut().zip(gradients)) {
            let shown = &mut node.terms;
            let ratio = node.mass / node.measure;
            let volume = ratio * ratio * shown.specific_volume;
            shown.shear = diffusion.viscosity * volume;
            let inverse = gradient.sums.inverse();
            let smallest = S::from_f64(SMALLEST_DETERMINANT);
            let determined = inverse.filter(|inverse| inverse.determinant > smallest);
            let mut share = S::ONE;
            if let Some(inverse) = &determined {
                let slopes = gradient.sums.slopes().velocity;
                let stress = diffusion.stress(&slopes, inverse);
                shown.stress = stress.map(|row| row.map(|entry| volume * entry));
                share = inverse.determinant;
                self.proven(cloud.engine, || {
                    let entries = slopes.iter().flatten();
                    let slope = entries
                        .map(|entry| entry.to_f64().abs())
                        .fold(0.0, f64::max);
                    let bound = diffusion.largest::<D>(slope) * volume.to_f64().max(1.0);
                    let id = cloud.cells.order().get(place).copied().unwrap_or(0);
                    holds::<S>(Quantity::Gradient, id, bound)
                })?;
            }
            let moment = S::ONE / (node.density * shown.specific_volume);
            let third = diffusion.viscosity * S::from_f64(1.0 / 3.0);
            let viscosity = diffusion.viscosity + third + diffusion.bulk_viscosity;
            shown.diffusivity += viscosity / (moment.lesser(S::ONE) * share.lesser(S::ONE));
        }
        Ok(())
    }
}
