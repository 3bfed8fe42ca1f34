//! Any engine in one type.

use motes_core::error::Error;
use motes_core::neighbours::Cells;
use motes_core::pairs::{Engine, HalfLoop, Law, PlainLoop, Portable, Settled, lanes};
use motes_solver::engine::{GrowingList, HostScalar, Threads};

/// Lanes of a block: of a number that divides none of anything.
const LANES: usize = 3;

/// Any engine, so that the solver is compiled once for all of them.
///
/// It goes on where a proof fails. These clouds are wild, and the sums of all options leave formats of
/// 32 bits; that bits are equal and that sums cancel holds of numbers that wrap, too.
pub enum AnyEngine {
    Plain,
    Half,
    /// Without threads, over ranges that cut rows anywhere.
    Lanes {
        lists: Vec<GrowingList>,
        fresh: bool,
        range: usize,
    },
    Threads(Threads),
}

impl AnyEngine {
    /// Lanes over ranges of that length.
    pub fn lanes(range: usize) -> Self {
        Self::Lanes {
            lists: Vec::new(),
            fresh: true,
            range,
        }
    }
}

impl<S: HostScalar, const D: usize> Engine<S, D> for AnyEngine {
    fn sorted(&mut self) {
        match self {
            Self::Plain | Self::Half => {}
            Self::Lanes { fresh, .. } => *fresh = true,
            Self::Threads(engine) => Engine::<S, D>::sorted(engine),
        }
    }
    fn unproven(&mut self, _: Error) -> Result<(), Error> {
        Ok(())
    }
    fn sweep<W: Law<S, D>>(
        &mut self,
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        settled: &mut [Settled<W::Node, W::Sums>],
    ) -> Result<(), Error> {
        match self {
            Self::Plain => PlainLoop.sweep(law, cells, nodes, settled),
            Self::Half => HalfLoop.sweep(law, cells, nodes, settled),
            Self::Lanes {
                lists,
                fresh,
                range,
            } => {
                lists.resize_with(nodes.len().div_ceil(*range), GrowingList::default);
                let ranges = settled.chunks_mut(*range).zip(lists);
                for (i, (settled, list)) in ranges.enumerate() {
                    if *fresh {
                        list.clear();
                    }
                    assert!(lanes::<Portable, S, D, LANES, W>(
                        law,
                        cells,
                        nodes,
                        i * *range,
                        settled,
                        list,
                        *fresh
                    ));
                }
                *fresh = false;
                Ok(())
            }
            Self::Threads(engine) => engine.sweep(law, cells, nodes, settled),
        }
    }
}
