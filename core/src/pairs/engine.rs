//! Who carries a law out.

use super::law::{Law, Settled};
use super::{half, plain};
use crate::error::Error;
use crate::neighbours::Cells;
use crate::scalar::Scalar;

/// Who carries a law out over a cloud. All engines give the same bits.
pub trait Engine<S: Scalar, const D: usize> {
    /// The cloud was sorted anew: anything remembered of the neighbours is void.
    fn sorted(&mut self) {}

    /// Evaluates `law` for every particle; `nodes` and `settled` are in sorted order and as
    /// long as the cloud.
    fn sweep<W: Law<S, D>>(
        &mut self,
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        settled: &mut [Settled<W::Node, W::Sums>],
    ) -> Result<(), Error>;
}

/// The plain loop: the definition of every sum.
#[derive(Clone, Copy, Debug, Default)]
pub struct PlainLoop;

impl<S: Scalar, const D: usize> Engine<S, D> for PlainLoop {
    fn sweep<W: Law<S, D>>(
        &mut self,
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        settled: &mut [Settled<W::Node, W::Sums>],
    ) -> Result<(), Error> {
        plain(law, cells, nodes, 0, settled);
        Ok(())
    }
}

/// The half loop: every pair once. The engine of a device.
#[derive(Clone, Copy, Debug, Default)]
pub struct HalfLoop;

impl<S: Scalar, const D: usize> Engine<S, D> for HalfLoop {
    fn sweep<W: Law<S, D>>(
        &mut self,
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        settled: &mut [Settled<W::Node, W::Sums>],
    ) -> Result<(), Error> {
        half(law, cells, nodes, settled);
        Ok(())
    }
}
