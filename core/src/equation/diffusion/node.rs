//! What the sums over pairs are made of.

use crate::record;

record! {
    /// What a particle shows.
    pub struct DiffusionNode<N, const D: usize, const P: usize> {
        /// Weight `w`.
        pub weight: N,
        /// Position; only walls ask for it.
        pub position: [N; D],
        /// `u`.
        pub value: [N; P],
        /// `b`.
        pub diffusivity: [N; P],
    }
}

record! {
    /// What it receives.
    pub struct DiffusionSums<N, const P: usize> {
        /// `ε² dq/dt`.
        pub rate: [N; P],
        /// Half of a bound of `ε² |λ|` by Gershgorin's circle of the particle, the largest of all
        /// species.
        pub radius: N,
        /// Particles within the support, itself among them.
        pub partners: N,
    }
}
