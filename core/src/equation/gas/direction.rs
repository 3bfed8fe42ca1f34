//! Pressure along gradients that are exact for linear fields, and opposite in each pair.
//!
//! `m_k du_k/dt = -Σ_l μ_k μ_l (P_k F_kl(ε_k) B_k + P_l F_kl(ε_l) B_l) r`, `r = x_k - x_l`,
//!
//! `m_k de_k/dt = Σ_l μ_k μ_l P_k F_kl(ε_k) (u_k-u_l)·B_k r` in place of (3.10) and (3.12), where
//! `F_kl r` is the gradient of the cut-off and `B_k` the inverse of
//!
//! `U_k = M_k/(tr M_k/D)`, `M_k = -Σ_l μ_l F_kl(ε_k) r ⊗ r`:
//!
//! the integral approach (García-Senz, Cabezón & Escartín, A&A 538, A9, 2012; Rosswog, MNRAS 448, 3628,
//! 2015), with the cut-off's gradient in place of the cut-off in the moments, those that
//! [`super::gradient`] inverts for velocities. The mean diagonal of M is `Ω ν`, and `P` already holds
//! 1/Ω; with one ε for all it does not, and B is the inverse of `M/ν`.
//!
//! Where the partners of a particle come in pairs, at r and -r, the force is that of a linear pressure
//! exactly: on any lattice, however stretched or sheared. The divergence of a linear velocity is exact on
//! any cloud. On a disordered cloud a constant pressure pushes as much as it does without B: no sum that
//! is opposite in each pair is exact for a constant there.
//!
//! Momentum is kept exactly. Forces are not along the lines of centres: angular momentum is kept as far
//! as B differs little from particle to particle. Energy is kept by [`EnergyForm::Exact`] and
//! [`EnergyForm::Total`]; in [`EnergyForm::LeapFrog`] it goes by the work of the forces, as the density
//! does not follow the same divergence, and drifts by the square of the step.
//!
//! [`EnergyForm::Exact`]: super::EnergyForm::Exact
//! [`EnergyForm::Total`]: super::EnergyForm::Total
//! [`EnergyForm::LeapFrog`]: super::EnergyForm::LeapFrog

use crate::scalar::Scalar;

use super::density::Width;
use super::dynamics::GasDynamics;
use super::gradient::GradientSums;
use super::options::Options;
use super::terms::NodeOf;

/// Between these determinants of the moments B goes over from 1 to their inverse: partners on one line
/// or all on one side leave the gradient as it is.
const DETERMINANTS: [f64; 2] = [0.125, 0.5];

impl<S: Scalar, C, V, E, const D: usize> GasDynamics<'_, S, C, V, E, Options<S, D>, D> {
    /// B of a particle.
    pub(super) fn direction(
        &self,
        node: &NodeOf<S, Options<S, D>, D>,
        sums: &GradientSums<S, D>,
    ) -> [[S; D]; D] {
        let moment = match self.width {
            Width::Adaptive { .. } => S::ONE,
            Width::Constant { .. } => S::ONE / (node.density * node.terms.specific_volume),
        };
        let mut direction = [[S::ZERO; D]; D];
        for (i, row) in direction.iter_mut().enumerate() {
            row[i] = S::ONE;
        }
        let Some(inverse) = sums.inverse() else {
            return direction;
        };
        let determinant = inverse.determinant * moment.lesser(S::ONE).powi(D);
        let [low, high] = DETERMINANTS.map(S::from_f64);
        let t = ((determinant - low) / (high - low)).greater(S::ZERO);
        let t = t.lesser(S::ONE);
        let share = t * t * (S::count(3) - (t + t));
        for i in 0..D {
            for j in 0..D {
                let exact = inverse.adjugate[i][j] / inverse.determinant / moment;
                direction[i][j] += share * (exact - direction[i][j]);
            }
        }
        direction
    }
}
