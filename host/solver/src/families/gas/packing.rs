//! The lattice that a gas is nearest to.

use motes_core::equation::gas::Packing;

use crate::scenario::Arrangement;

/// The lattice nearest to an arrangement.
pub(super) fn packing(arrangement: &Arrangement) -> Packing {
    match arrangement {
        Arrangement::Hexagonal | Arrangement::ClosePacked | Arrangement::Glass => Packing::Close,
        _ => Packing::Cubic,
    }
}
