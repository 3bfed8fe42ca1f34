//! What the sums over pairs of a gas are made of.

use crate::record;

record! {
    /// What a particle of gas shows: over a number `N`, with what the terms need, `X`.
    pub struct GasNode<N, X, const D: usize> {
        /// Mass `m`.
        pub mass: N,
        /// Measure μ: the mass, or 1.
        pub measure: N,
        /// `P = (p + q)/(Ω ν²)`.
        pub pressure: N,
        /// `σ ε^-(D+2)`: turns `F(q) r` into the gradient.
        pub gradient: N,
        /// The particle's part of the argument of the cut-off.
        pub scale: N,
        /// Sound speed `c`.
        pub sound_speed: N,
        /// `c √m/ν`: how stiff it is to its partners, see
        /// [`GasDynamics::time_step`](super::GasDynamics::time_step).
        pub stiffness: N,
        /// Density ρ.
        pub density: N,
        /// ε.
        pub epsilon: N,
        /// Velocity `u`.
        pub velocity: [N; D],
        /// What goes beyond the paper.
        pub terms: X,
    }
}

record! {
    /// What it receives.
    pub struct GasSums<N, const D: usize> {
        /// `Σ_l μ_l (u_k-u_l)·∇ζ_kl(ε_k) = -Ω_k ν_k div u`.
        pub compression: N,
        /// [`Motion`](super::motion::Motion): rate of internal energy but for the pressure's part,
        /// `1/2 Σ_l m_k m_l Π_kl (u_k-u_l)·g_kl`, and what is conducted.
        /// [`PairWork`](super::energy::PairWork): rate of internal energy with the velocities of now.
        /// [`EnergyFlow`](super::energy::EnergyFlow): rate of total energy.
        pub power: N,
        /// [`PairWork`](super::energy::PairWork): what `power` gains in a unit of time while forces do
        /// not change.
        pub power_slope: N,
        /// The fastest approach of a partner, along the line of centres; at least 0.
        pub approach: N,
        /// The largest stiffness of those within the support.
        pub stiffest: N,
        /// `m_k du_k/dt`.
        pub force: [N; D],
    }
}
