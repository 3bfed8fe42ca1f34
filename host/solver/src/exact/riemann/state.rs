//! What a Riemann problem is made of: uniform states, and the front between two of them.

/// Density, velocity and pressure at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GasState {
    /// Mass / length; 0 in a vacuum.
    pub density: f64,
    /// Length / time.
    pub velocity: f64,
    /// Density * velocity^2; in a vacuum 0, or minus the lower pressure at infinity.
    pub pressure: f64,
}

/// A shock or fan running to the left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Front {
    /// Behind it, at the contact or at the edge of the vacuum.
    pub inside: GasState,
    /// Speed of the front; of a shock.
    pub head: f64,
    /// Speed of the end; equal to `head` for a shock.
    pub tail: f64,
}
