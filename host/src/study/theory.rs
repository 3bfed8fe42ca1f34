//! What Theorems 2 and 3 say of a study.

/// What the order of a linear system depends on, with `eps = C h^theta`.
///
/// Theorem 2, (2.9), and Theorem 3 for convection-diffusion: the error is `O(eps^r + h^m/eps^(m+s))`, s = 1, for a cut-off of order r
/// in `W^(m+s,1)`. Gas dynamics has no theorem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Theory {
    /// r: the moments 1 to r - 1 of the cut-off vanish.
    pub order_r: u32,
    /// m + s: so many weak derivatives of the cut-off are integrable.
    pub smoothness: u32,
    /// > 0; below 1 finer clouds have more neighbours.
    pub theta: f64,
}

impl Theory {
    /// `r theta`: the order where the first term governs, as it does on clouds that are even
    /// enough.
    pub fn predicted_order(&self) -> f64 {
        f64::from(self.order_r) * self.theta
    }

    /// `min(r theta, m - theta (m + s))`: what the theorem guarantees for any cloud. Nothing where
    /// it is not above 0.
    pub fn guaranteed_order(&self) -> f64 {
        let smoothness = f64::from(self.smoothness);
        let quadrature = (smoothness - 1.0) - self.theta * smoothness;
        self.predicted_order().min(quadrature)
    }

    /// A warning where the error cannot go to 0.
    pub fn warning(&self) -> Option<String> {
        (self.theta >= 1.0).then(|| {
            format!(
                "theta = {}: the quadrature term h^m/eps^(m+s) does not fall with h, and the \
                 error cannot converge to zero; take eps = C h^theta with theta < 1",
                self.theta
            )
        })
    }
}
