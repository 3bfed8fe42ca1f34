//! Glass: particles without a lattice, their density even.
//!
//! Each particle is pushed down the gradient of the number density that it sees,
//!
//! `dx_k = -beta eps^2 grad n / n = -beta sum_l F(q) r_kl / sum_l z(q)`,
//!
//! a diffusion of the density (Lind et al., J. Comput. Phys. 231 (2012) 1499, equation (23),
//! with this `n` for the concentration). Pushes are sums of pairs through the core's engine,
//! in `f64` with `+ - * /` and square roots: the same bits everywhere.

use motes_core::cutoff::{CutOff, Needs, Parts, WendlandC2, Widths};
use motes_core::domain::{Axis, Domain};
use motes_core::error::Error;
use motes_core::neighbours::{CellBuffers, Site, cell_bound, sort};
use motes_core::pairs::{Engine, Fields, HalfLoop, Law, Separation, Settled};
use motes_core::record;
use motes_core::scalar::{Number, Scalar};

use super::SetupError;
use super::block::Block;

/// Width of the cut-off in spacings: about 18 neighbours in two dimensions, 58 in three.
const EPSILON: f64 = 1.2;

/// `beta`: a third of what makes the shortest waves swing.
const STRENGTH: f64 = 0.3;

/// Rounds of pushes: what the lattice's own scale needs; longer waves the start has few of.
const ROUNDS: usize = 60;

/// Largest step along a direction, in spacings, or the start could throw particles far.
const LARGEST_STEP: f64 = 0.25;

record! {
    /// What a particle shows: that it is there.
    pub struct Presence<N, const D: usize> {
        /// 1.
        pub number: N,
    }
}

record! {
    /// What it receives.
    pub struct Pushes<N, const D: usize> {
        /// `sum z(q)`, itself included.
        pub crowd: N,
        /// `-sum F(q) r_kl`.
        pub push: [N; D],
    }
}

/// The push apart.
struct Repulsion;

impl<S: Scalar, const D: usize> Law<S, D> for Repulsion {
    type Node = Presence<S, D>;
    type Sums = Pushes<S, D>;
    type CutOff = WendlandC2;
    const NEEDS: Needs = Needs {
        parts: Parts::All,
        widths: Widths::Equal,
        distance: false,
    };

    fn cut_off(&self) -> WendlandC2 {
        WendlandC2
    }
    #[inline(always)]
    fn scale<N: Number<Scalar = S>>(&self, _: &Presence<N, D>) -> N {
        N::literal(1.0 / EPSILON)
    }
    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &Presence<N, D>,
        l: &Presence<N, D>,
        apart: &Separation<N, D>,
        to_k: &mut Pushes<N, D>,
        to_l: &mut Pushes<N, D>,
    ) {
        let Separation { r, zeta, .. } = apart;
        let (value, gradient) = (zeta.k.value, zeta.k.gradient);
        to_k.crowd += l.number * value;
        to_l.crowd += k.number * value;
        for i in 0..D {
            let push = -(gradient * r[i]);
            to_k.push[i] += push;
            to_l.push[i] -= push;
        }
    }
}

/// Relaxes points of a block, `spacing` apart on average: periodic where the block is,
/// between walls elsewhere.
pub(super) fn relax(
    block: &Block,
    spacing: f64,
    points: &mut [[f64; 3]],
) -> Result<(), SetupError> {
    let relaxed = match block.dimension {
        1 => relaxed::<1>(block, spacing, points),
        2 => relaxed::<2>(block, spacing, points),
        _ => relaxed::<3>(block, spacing, points),
    };
    relaxed.map_err(|source| SetupError::Glass { source })
}

/// In units of the spacing, the lower corner at 0.
fn relaxed<const D: usize>(
    block: &Block,
    spacing: f64,
    points: &mut [[f64; 3]],
) -> Result<(), Error> {
    let mut domain = Domain::FREE;
    for (i, axis) in domain.axes.iter_mut().enumerate() {
        let length = block.length(i) / spacing;
        *axis = match block.periodic[i] {
            true => Axis::periodic(0.0, length),
            false => Axis::walls(0.0, length),
        };
    }
    let mut positions: Vec<[f64; D]> = points
        .iter()
        .map(|point| std::array::from_fn(|i| (point[i] - block.lower[i]) / spacing))
        .collect();
    let mut pusher = Pusher::new(positions.len());
    for _ in 0..ROUNDS {
        pusher.round(&domain, &mut positions)?;
    }
    for (point, position) in points.iter_mut().zip(&positions) {
        for i in 0..D {
            point[i] = block.lower[i] + spacing * position[i];
        }
        *point = block.inside(*point);
    }
    Ok(())
}

/// The memory of the engine.
struct Pusher<const D: usize> {
    sites: Vec<Site<f64, D>>,
    order: Vec<u32>,
    cell_of: Vec<u32>,
    starts: Vec<u32>,
    nodes: Vec<Presence<f64, D>>,
    settled: Vec<Settled<Presence<f64, D>, Pushes<f64, D>>>,
}

impl<const D: usize> Pusher<D> {
    fn new(n: usize) -> Self {
        let node = Presence { number: 1.0 };
        Self {
            sites: vec![Site::EMPTY; n],
            order: vec![0; n],
            cell_of: vec![0; n],
            starts: vec![0; cell_bound(n as u32) as usize + 1],
            nodes: vec![node; n],
            settled: vec![Settled::new(node, Pushes::ZERO); n],
        }
    }

    /// Pushes every particle once.
    fn round(&mut self, domain: &Domain<f64, D>, positions: &mut [[f64; D]]) -> Result<(), Error> {
        let mut buffers = CellBuffers {
            sites: &mut self.sites,
            order: &mut self.order,
            cell_of: &mut self.cell_of,
            starts: &mut self.starts,
        };
        let reach = EPSILON * f64::from(WendlandC2.support());
        let grid = sort(domain, positions, &|_| reach, &mut buffers)?;
        let cells = buffers.cells(grid, positions.len());
        HalfLoop.sweep(&Repulsion, &cells, &self.nodes, &mut self.settled)?;
        for (&id, settled) in cells.order().iter().zip(&self.settled) {
            let Pushes { crowd, push } = settled.sums;
            let step =
                push.map(|push| (STRENGTH * push / crowd).clamp(-LARGEST_STEP, LARGEST_STEP));
            domain.drift(&mut positions[id as usize], &step, id)?;
        }
        Ok(())
    }
}
