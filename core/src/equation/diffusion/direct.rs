//! The direct form (4.6): one symmetric pair operator.

use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::error::{Error, Quantity};
use crate::numbered::numbered;
use crate::pairs::{Ground, Largest, Law, Separation};
use crate::scalar::{Number, Scalar};

use super::mean::Mean;
use super::node::{DiffusionNode, DiffusionSums};
use super::wall::{Walls, end_of};

/// `dq_k/dt = Σ_l w_k w_l (b_k + b_l)(u_l - u_k) ∇ζ_kl·(x_l - x_k)/|x_l - x_k|²` (4.6), one ε.
///
/// Differs from the paper: as printed (4.6) adds the operator (4.5) to the left-hand side; it
/// approximates `+div(b ∇u)` and belongs on the right. For a radial cut-off the bracket is
/// `-σ ε^-(D+2) F(q)` and needs no division; ε² is taken out, so that no number is small.
///
/// Differs from the paper: with a tensor the term is times `((D+2) n·Tn - tr T)/2`, `n` the
/// direction of the pair, which makes `div(b T ∇u)` of the same order (Español & Revenga, Phys. Rev.
/// E 67, 2003, 026705); below 0 for some pairs where the eigenvalues of `T` differ by more than a
/// factor: no maximum principle then.
#[derive(Clone, Copy, Debug)]
pub struct Direct<S, C, const D: usize, const P: usize> {
    /// ζ.
    pub cut_off: C,
    /// What turns `|r|` into the argument of the cut-off.
    pub scale: S,
    /// `σ ε^-D`.
    pub height: S,
    /// What stands for `(b_k + b_l)/2`.
    pub mean: Mean,
    /// `T`; `None` for 1.
    pub tensor: Option<[[S; D]; D]>,
}

impl<S: Scalar, C: CutOff, const D: usize, const P: usize> Direct<S, C, D, P> {
    /// `((D+2) n·Tn - tr T)/2`, 1 without a tensor.
    #[inline(always)]
    fn share<N: Number<Scalar = S>>(&self, r: &[N; D], distance_squared: N) -> N {
        let Some(tensor) = &self.tensor else {
            return N::splat(S::ONE);
        };
        let (mut image, mut trace) = (*r, S::ZERO);
        for i in 0..D {
            image[i] = N::dot(&tensor[i].map(N::splat), r);
            trace += tensor[i][i];
        }
        // A particle by itself has no direction, and no difference either.
        let size = distance_squared.max(N::splat(S::TINIEST));
        let along = N::dot(r, &image) / size;
        let dimensions = N::splat(S::count(D as u32 + 2).half());
        dimensions * along - N::splat(trace.half())
    }

    /// What the term of a node on itself adds to its `radius`, to the last bit.
    pub(super) fn own_radius(&self) -> impl Fn(&DiffusionNode<S, D, P>) -> S {
        let scales = [self.scale; 2];
        let apart = Separation {
            r: [S::ZERO; D],
            distance_squared: S::ZERO,
            zeta: self
                .cut_off
                .shapes_of_pair::<D, _>(Self::NEEDS, S::ZERO, scales),
        };
        let size = self.size(self.bracket(&apart));
        let mean = self.mean;
        move |node| {
            let twice = node.diffusivity.map(|b| mean.twice(b, b));
            node.weight * (size * twice.into_iter().fold(S::ZERO, Scalar::greater))
        }
    }

    /// The bracket of (4.6) times ε².
    #[inline(always)]
    pub(super) fn bracket<N: Number<Scalar = S>>(&self, apart: &Separation<N, D>) -> N {
        self.plain_bracket(apart) * self.share(&apart.r, apart.distance_squared)
    }

    /// The same without a tensor.
    #[inline(always)]
    pub(super) fn plain_bracket<N: Number<Scalar = S>>(&self, apart: &Separation<N, D>) -> N {
        -(N::splat(self.height) * apart.zeta.k.gradient)
    }

    /// From order 4 on, and with a tensor, the bracket has both signs.
    #[inline(always)]
    pub(super) fn size<N: Number<Scalar = S>>(&self, bracket: N) -> N {
        bracket.max(-bracket)
    }
}

impl<S: Scalar, C: CutOff, const D: usize, const P: usize> Law<S, D> for Direct<S, C, D, P> {
    type Node = DiffusionNode<S, D, P>;
    type Sums = DiffusionSums<S, P>;
    type CutOff = C;
    const NEEDS: Needs = Needs {
        parts: Parts::Gradient,
        widths: Widths::Equal,
        distance: false,
    };
    const MAKES: Quantity = Quantity::Rate;

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
        let bracket = self.bracket(apart);
        let factor = (k.weight * l.weight) * bracket;
        let mut largest = N::zero();
        for j in 0..P {
            let b = self.mean.twice(k.diffusivity[j], l.diffusivity[j]);
            let term = factor * (b * (l.value[j] - k.value[j]));
            to_k.rate[j] += term;
            to_l.rate[j] -= term;
            largest = largest.max(b);
        }
        let size = self.size(bracket) * largest;
        to_k.radius += l.weight * size;
        to_l.radius += k.weight * size;
        to_k.partners += apart.zeta.k.within;
        to_l.partners += apart.zeta.k.within;
    }
}

/// Whether what is seen behind the walls stays in the range of the format.
#[inline(never)]
pub(super) fn prove_walls<S: Scalar, const D: usize, const P: usize>(
    walls: &Walls<S, D, P>,
    ground: &Ground<'_, '_, S, D>,
    nodes: &[DiffusionNode<S, D, P>],
) -> Result<(), Error> {
    let grid = ground.cells.grid();
    if !grid.has_walls() {
        return Ok(());
    }
    for j in 0..P {
        let value = Largest::of(nodes.iter().map(|node| node.value[j]));
        let ends = [S::LARGEST, S::ZERO];
        let conductors = nodes.iter().fold(ends, |[least, most], node| {
            let b = node.diffusivity[j];
            let positive = if b > S::ZERO { b } else { least };
            [least.lesser(positive), most.greater(b)]
        });
        let conductors = conductors.map(Scalar::to_f64);
        for (axis, ends) in numbered(grid.walls()) {
            for (end, wall) in numbered(ends) {
                let condition = walls.get(axis).and_then(|ends| ends.get(end));
                if let (Some(_), Some(conditions)) = (wall, condition) {
                    let bound = conditions[j].largest(value.bound, conductors, ground.reach);
                    ground.holds(Quantity::Wall, Largest { bound, ..value })?;
                }
            }
        }
    }
    Ok(())
}

/// A node as it is seen behind a wall.
pub(super) fn imaged<S: Scalar, const D: usize, const P: usize>(
    node: &DiffusionNode<S, D, P>,
    wall: &Wall<S>,
    walls: &Walls<S, D, P>,
) -> DiffusionNode<S, D, P> {
    let mut image = *node;
    let conditions = end_of(walls, wall);
    let place = node.position.get(wall.axis);
    if let (Some(conditions), Some(&x)) = (conditions, place) {
        let distance = (x - wall.position).abs();
        let species = image.value.iter_mut().zip(&node.diffusivity);
        for ((u, &b), condition) in species.zip(conditions) {
            *u = condition.image(*u, b, distance);
        }
    }
    image
}
