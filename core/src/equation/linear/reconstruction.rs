//! The field that a cloud of strengths stands for, at any points: (1.13).

use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::error::Error;
use crate::neighbours::{Site, sort};
use crate::pairs::{Fields, Law, Separation, Settled, receive_at};
use crate::scalar::{Number, Scalar};

use super::dynamics::LinearDynamics;
use super::law::{SystemNode, SystemSums};
use super::storage::LinearWorkspace;
use super::system::FirstOrderSystem;
use crate::cloud::State;
use crate::cloud::VelocityField;

/// (1.13): `u_h^ε(x) = Σ_l w_l u_l ζ_ε(x - x_l)`, over the nodes of the system.
#[derive(Clone, Copy, Debug)]
struct Reconstruction<'a, C, S, F, const P: usize> {
    system: &'a F,
    cut_off: C,
    /// What turns `|r|` into the argument of the cut-off.
    scale: S,
    /// `σ ε^-D`.
    height: S,
}

impl<C, S, F, const D: usize, const P: usize> Law<S, D> for Reconstruction<'_, C, S, F, P>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, D, P>,
{
    type Node = SystemNode<S, F::Medium, D, P>;
    type Sums = SystemSums<S, P>;
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
    fn scale<N: Number<Scalar = S>>(&self, _: &<Self::Node as Fields<S>>::Of<N>) -> N {
        N::splat(self.scale)
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &<Self::Node as Fields<S>>::Of<N>,
        l: &<Self::Node as Fields<S>>::Of<N>,
        apart: &Separation<N, D>,
        to_k: &mut SystemSums<N, P>,
        to_l: &mut SystemSums<N, P>,
    ) {
        let height = N::splat(self.height) * apart.zeta.k.value;
        for j in 0..P {
            to_k.rate[j] += (l.weight * height) * l.value[j];
            to_l.rate[j] += (k.weight * height) * k.value[j];
        }
    }

    fn reflected(&self, node: &Self::Node, wall: &Wall<S>) -> Self::Node {
        SystemNode {
            value: self.system.reflected(&node.value, wall.axis),
            ..*node
        }
    }
}

impl<S, C, F, A, const D: usize, const P: usize> LinearDynamics<S, C, F, A, D, P>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// The reconstruction (1.13) at `points`, into `values`; a probe. The state stays as it is,
    /// bit for bit, and so does the run that it belongs to.
    pub fn reconstruct(
        &self,
        state: &State<'_, S, D, P>,
        work: &mut LinearWorkspace<'_, S, F::Medium, D, P>,
        points: &[[S; D]],
        values: &mut [[S; P]],
    ) -> Result<(), Error> {
        let n = state.len();
        let reach = self.reach();
        let grid = sort(&self.domain, state.position, &|_| reach, &mut work.cells)?;
        let cells = work.cells.cells(grid, n);
        let Some(nodes) = work.nodes.get_mut(..n) else {
            return Err(Error::Lengths);
        };
        for (node, &id) in nodes.iter_mut().zip(cells.order()) {
            let id = id as usize;
            if let (Some(&weight), Some(&value)) = (state.weight.get(id), state.value.get(id)) {
                (node.weight, node.value) = (weight, value);
            }
        }
        let law = Reconstruction {
            system: &self.system,
            cut_off: self.cut_off,
            scale: self.cut_off.scale(S::ONE / self.epsilon),
            height: S::from_f64(self.cut_off.normalisation::<D>()) / self.epsilon.powi(D),
        };
        for (&position, value) in points.iter().zip(values) {
            let site = Site {
                position,
                reach_squared: reach * reach,
            };
            let mut settled = Settled::new(SystemNode::ZERO, SystemSums::ZERO);
            receive_at(&law, &cells, nodes, &site, &mut settled);
            *value = settled.sums.rate;
        }
        Ok(())
    }
}
