//! Who carries a law out.

use super::law::{Law, Settled};
use super::proof::Ground;
use super::{half, plain};
use crate::error::Error;
use crate::neighbours::Cells;
use crate::scalar::Scalar;

/// Who carries a law out over a cloud. All engines give the same bits.
pub trait Engine<S: Scalar, const D: usize> {
    /// The cloud was sorted anew: anything remembered of the neighbours is void.
    fn sorted(&mut self) {}

    /// Evaluates `law` as [`Engine::sweep`] does, once it is proven that in this format no sum or
    /// product of it wraps. Floats have nothing to prove.
    ///
    /// Error: [`Error::Unproven`], and no sum has been made.
    fn evaluate<W: Law<S, D>>(
        &mut self,
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        settled: &mut [Settled<W::Node, W::Sums>],
    ) -> Result<(), Error> {
        if S::WRAPS {
            let proven = law.proof(&Ground::of(cells), nodes);
            proven.or_else(|error| self.unproven(error))?;
        }
        self.sweep(law, cells, nodes, settled)
    }

    /// What becomes of a proof that fails: the error, unless the engine goes on without.
    fn unproven(&mut self, error: Error) -> Result<(), Error> {
        Err(error)
    }

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
