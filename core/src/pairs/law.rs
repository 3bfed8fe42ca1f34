//! What an equation has to say.

use crate::domain::Wall;
use crate::scalar::{Number, Scalar};

pub(super) use super::record::Fields;

/// An equation: a sum over partners of a pair term.
///
/// It has no storage, no threads and no loop over neighbours. Everything is indexed as in
/// the paper: `k` receives, `l` is its partner, `r = x_k - x_l`.
pub trait Law<S: Scalar, const D: usize>: Sync {
    /// What a particle shows to its partners.
    type Node: Fields<S>;
    /// What it receives.
    type Sums: Fields<S>;

    /// Adds the term of the pair to both of its particles.
    ///
    /// What `l` receives here has the bits that it would receive as `k` of the pair seen from
    /// the other side: write terms that are equal or exactly opposite, and functions of one
    /// of the two for each its own. A pair out of reach must add exactly 0. With `r = 0` it
    /// is the term of a particle on itself.
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &<Self::Node as Fields<S>>::Of<N>,
        l: &<Self::Node as Fields<S>>::Of<N>,
        r: &[N; D],
        distance_squared: N,
        to_k: &mut <Self::Sums as Fields<S>>::Of<N>,
        to_l: &mut <Self::Sums as Fields<S>>::Of<N>,
    );

    /// Looks at a particle's sums: `true` when they are final; `false` to have them made
    /// again with the node that it changed. A law that does so bounds its passes itself.
    fn close(&self, node: &mut Self::Node, sums: &Self::Sums) -> bool {
        let _ = (node, sums);
        true
    }

    /// The mirror image of a node in a wall; where the image is the engine knows.
    fn reflected(&self, node: &Self::Node, wall: &Wall<S>) -> Self::Node {
        let _ = wall;
        *node
    }
}

/// The node of a particle after the last pass, and its sums.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled<Node, Sums> {
    /// As [`Law::close`] left it.
    pub node: Node,
    /// The sums of the last pass.
    pub sums: Sums,
}

impl<Node, Sums> Settled<Node, Sums> {
    /// A result that has not been written yet.
    pub const fn new(node: Node, sums: Sums) -> Self {
        Self { node, sums }
    }
}
