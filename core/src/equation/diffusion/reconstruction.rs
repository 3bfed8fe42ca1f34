//! The field that a cloud of strengths stands for, at any points: (1.13).

use super::direct::imaged;
use super::dynamics::DiffusionDynamics;
use super::node::{DiffusionNode, DiffusionSums};
use super::problem::DiffusionProblem;
use super::storage::DiffusionWorkspace;
use super::wall::Condition;
use crate::cloud::{State, VelocityField};
use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::error::Error;
use crate::neighbours::{Site, sort};
use crate::pairs::{Fields, Law, Separation, Settled, receive_at};
use crate::scalar::{Number, Scalar};

/// (1.13): `u_h^ε(x) = Σ_l w_l u_l ζ_ε(x - x_l)`.
#[derive(Clone, Copy, Debug)]
struct Reconstruction<S, C, const D: usize, const P: usize> {
    cut_off: C,
    /// What turns `|r|` into the argument of the cut-off.
    scale: S,
    /// `σ ε^-D`.
    height: S,
    walls: [[[Condition<S>; P]; 2]; D],
}

impl<S, C, const D: usize, const P: usize> Law<S, D> for Reconstruction<S, C, D, P>
where
    S: Scalar,
    C: CutOff,
{
    type Node = DiffusionNode<S, D, P>;
    type Sums = DiffusionSums<S, P>;
    type CutOff = C;
    const NEEDS: Needs = Needs {
        parts: Parts::Value,
        widths: Widths::Equal,
        distance: false,
    };

    fn cut_off(&self) -> C {
        self.cut_off
    }
    #[inline(always)]
    fn scale<N: Number<Scalar = S>>(&self, _: &DiffusionNode<N, D, P>) -> N {
        N::splat(self.scale)
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &DiffusionNode<N, D, P>,
        l: &DiffusionNode<N, D, P>,
        apart: &Separation<N, D>,
        to_k: &mut DiffusionSums<N, P>,
        to_l: &mut DiffusionSums<N, P>,
    ) {
        let height = N::splat(self.height) * apart.zeta.k.value;
        for j in 0..P {
            to_k.rate[j] += (l.weight * height) * l.value[j];
            to_l.rate[j] += (k.weight * height) * k.value[j];
        }
    }

    fn reflected(&self, node: &DiffusionNode<S, D, P>, wall: &Wall<S>) -> DiffusionNode<S, D, P> {
        imaged(node, wall, &self.walls)
    }
}

impl<S, C, B, A, const D: usize, const P: usize> DiffusionDynamics<S, C, B, A, D, P>
where
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// The reconstruction (1.13) at `points`, into `values`; a probe. The state stays as it is, bit
    /// for bit. For the end of a run: the bound of the next step has to be made anew.
    pub fn reconstruct(
        &self,
        state: &State<'_, S, D, P>,
        work: &mut DiffusionWorkspace<'_, S, D, P>,
        time: S,
        (points, values): (&[[S; D]], &mut [[S; P]]),
    ) -> Result<(), Error> {
        let n = state.len();
        let reach = self.reach();
        let grid = sort(&self.domain, state.position, &|_| reach, &mut work.cells)?;
        *work.grid = None;
        self.show(state, work, time);
        let cells = work.cells.cells(grid, n);
        let Some(nodes) = work.nodes.get(..n) else {
            return Err(Error::Lengths);
        };
        let law = Reconstruction {
            cut_off: self.cut_off,
            scale: self.cut_off.scale(S::ONE / self.epsilon),
            height: S::from_f64(self.cut_off.normalisation::<D>()) / self.epsilon.powi(D),
            walls: self.walls(time),
        };
        for (&position, value) in points.iter().zip(values) {
            let site = Site {
                position,
                reach_squared: reach * reach,
            };
            let mut settled = Settled::new(DiffusionNode::ZERO, DiffusionSums::ZERO);
            receive_at(&law, &cells, nodes, &site, &mut settled);
            *value = settled.sums.rate;
        }
        Ok(())
    }
}
