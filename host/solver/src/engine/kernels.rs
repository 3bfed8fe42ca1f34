//! The inner loops compiled for each instruction set, and the number of lanes each scalar
//! gets.
//!
//! This is the only `unsafe` of the project. A function with `#[target_feature]` may only run
//! on a processor that has the feature. The kernels are private, and reached through
//! [`HostScalar::sweep`] alone, which chooses among them by [`InstructionSet::available`]: that
//! asks the processor.
#![allow(unsafe_code)]

use motes_core::cutoff::{CutOff, Needs, PairBlock};
use motes_core::neighbours::{Cells, Runs};
#[cfg(not(target_arch = "x86_64"))]
use motes_core::pairs::Portable;
use motes_core::pairs::{Fields, Kernel, Law, Operands, Receivers, Settled, lanes};
use motes_core::pairs::{find, sum};
use motes_core::scalar::{Checked, Lanes, Micro, Q32, Q64, Scalar};

use super::{GrowingList, InstructionSet, plain_range};

#[cfg(target_arch = "x86_64")]
macro_rules! kernel {
    ($name:ident, $features:literal) => {
        struct $name;

        impl Kernel for $name {
            fn find<S: Scalar, const D: usize, const L: usize>(
                cells: &Cells<'_, S, D>,
                receivers: &Receivers<S, D, L>,
                runs: &Runs<D>,
                words: &mut [u32],
            ) -> usize {
                #[target_feature(enable = $features)]
                fn compiled<S: Scalar, const D: usize, const L: usize>(
                    cells: &Cells<'_, S, D>,
                    receivers: &Receivers<S, D, L>,
                    runs: &Runs<D>,
                    words: &mut [u32],
                ) -> usize {
                    find(cells, receivers, runs, words)
                }
                // Safety: this kernel is only chosen where the processor has the features.
                unsafe { compiled(cells, receivers, runs, words) }
            }

            fn shapes<S: Scalar, C: CutOff, const D: usize, const L: usize>(
                cut_off: C,
                needs: Needs,
                scale: &Lanes<S, L>,
                count: usize,
                pairs: &mut PairBlock<Lanes<S, L>>,
            ) {
                #[target_feature(enable = $features)]
                fn compiled<S: Scalar, C: CutOff, const D: usize, const L: usize>(
                    cut_off: C,
                    needs: Needs,
                    scale: &Lanes<S, L>,
                    count: usize,
                    pairs: &mut PairBlock<Lanes<S, L>>,
                ) {
                    cut_off.shapes::<D, _>(needs, *scale, count, pairs);
                }
                // Safety: as above.
                unsafe { compiled::<S, C, D, L>(cut_off, needs, scale, count, pairs) }
            }

            fn sum<S: Scalar, const D: usize, const L: usize, W: Law<S, D>>(
                law: &W,
                cells: &Cells<'_, S, D>,
                nodes: &[W::Node],
                block: &Operands<'_, S, D, L, W>,
                pairs: &mut PairBlock<Lanes<S, L>>,
                sums: &mut <W::Sums as Fields<S>>::Of<Lanes<S, L>>,
            ) {
                #[target_feature(enable = $features)]
                fn compiled<S: Scalar, const D: usize, const L: usize, W: Law<S, D>>(
                    law: &W,
                    cells: &Cells<'_, S, D>,
                    nodes: &[W::Node],
                    block: &Operands<'_, S, D, L, W>,
                    pairs: &mut PairBlock<Lanes<S, L>>,
                    sums: &mut <W::Sums as Fields<S>>::Of<Lanes<S, L>>,
                ) {
                    sum::<$name, S, D, L, W>(law, cells, nodes, block, pairs, sums);
                }
                // Safety: as above.
                unsafe { compiled(law, cells, nodes, block, pairs, sums) }
            }
        }
    };
}
#[cfg(target_arch = "x86_64")]
kernel!(Avx2, "avx2");
#[cfg(target_arch = "x86_64")]
kernel!(Avx512, "avx2,avx512f,avx512vl,avx512dq,avx512bw");

/// A scalar that the host can run with.
pub trait HostScalar: Scalar {
    /// Whether runs use lanes: where they do not, the plain loop is as fast.
    const HAS_LANES: bool;

    /// Evaluates `law` over a range of receivers, as [`lanes`] does.
    #[expect(clippy::too_many_arguments, reason = "passes on what `lanes` takes")]
    fn sweep<const D: usize, W: Law<Self, D>>(
        set: InstructionSet,
        law: &W,
        cells: &Cells<'_, Self, D>,
        nodes: &[W::Node],
        first: usize,
        settled: &mut [Settled<W::Node, W::Sums>],
        list: &mut GrowingList,
        fresh: bool,
    ) -> bool;
}

macro_rules! with_lanes {
    ($scalar:ty, $avx512:literal, $avx2:literal, $portable:literal) => {
        impl HostScalar for $scalar {
            const HAS_LANES: bool = true;

            fn sweep<const D: usize, W: Law<Self, D>>(
                set: InstructionSet,
                law: &W,
                cells: &Cells<'_, Self, D>,
                nodes: &[W::Node],
                first: usize,
                settled: &mut [Settled<W::Node, W::Sums>],
                list: &mut GrowingList,
                fresh: bool,
            ) -> bool {
                // Asked again, though the engine has asked: what follows relies on it.
                match set.available() {
                    #[cfg(target_arch = "x86_64")]
                    InstructionSet::Avx512 => lanes::<Avx512, Self, D, $avx512, W>(
                        law, cells, nodes, first, settled, list, fresh,
                    ),
                    #[cfg(target_arch = "x86_64")]
                    InstructionSet::Avx2 => lanes::<Avx2, Self, D, $avx2, W>(
                        law, cells, nodes, first, settled, list, fresh,
                    ),
                    // Vectors of 128 bits gain little over the plain loop, and every kernel
                    // costs a third of the time to build.
                    #[cfg(target_arch = "x86_64")]
                    _ => plain_range(law, cells, nodes, first, settled),
                    #[cfg(not(target_arch = "x86_64"))]
                    _ => lanes::<Portable, Self, D, $portable, W>(
                        law, cells, nodes, first, settled, list, fresh,
                    ),
                }
            }
        }
    };
}
// Lanes with AVX-512, with AVX2, and without either.
with_lanes!(f32, 16, 8, 8);
with_lanes!(f64, 8, 8, 4);

macro_rules! without_lanes {
    ($({$($generics:tt)*})? $scalar:ty) => {
        impl $(<$($generics)*>)? HostScalar for $scalar {
            const HAS_LANES: bool = false;

            fn sweep<const D: usize, W: Law<Self, D>>(
                _: InstructionSet,
                law: &W,
                cells: &Cells<'_, Self, D>,
                nodes: &[W::Node],
                first: usize,
                settled: &mut [Settled<W::Node, W::Sums>],
                _: &mut GrowingList,
                _: bool,
            ) -> bool {
                plain_range(law, cells, nodes, first, settled)
            }
        }
    };
}
use fixed::types::extra::Unsigned;
without_lanes!(Micro);
without_lanes!({F: Unsigned + Copy + Send + Sync + 'static} Q32<F>);
without_lanes!({F: Unsigned + Copy + Send + Sync + 'static} Q64<F>);
without_lanes!({S: Scalar} Checked<S>);
