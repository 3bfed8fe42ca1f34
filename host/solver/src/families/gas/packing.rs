//! The lattice that a gas is nearest to.

use motes_core::equation::gas::Packing;

use crate::scenario::Arrangement;

/// The lattice whose sums are nearest to those of an arrangement. Those of a glass are less than 1e-3
/// from those of squares and cubes, and 2.5e-3 from the closest packing's.
pub(super) fn packing(arrangement: &Arrangement) -> Packing {
    match arrangement {
        Arrangement::Hexagonal | Arrangement::ClosePacked => Packing::Close,
        _ => Packing::Cubic,
    }
}
