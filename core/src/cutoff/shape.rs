//! The cut-off as pair loops read it: its value and derivatives at the arguments of many pairs.

use super::CutOff;
use crate::scalar::{Number, Scalar};

/// What a law reads of the cut-off of a pair; what it does not read is not made.
///
/// In lanes [`Widths::Both`] goes with [`Parts::Gradient`] and the distance, and only there is the
/// distance: see [`Needs::fit_lanes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needs {
    /// Which functions.
    pub parts: Parts,
    /// At which widths.
    pub widths: Widths,
    /// Whether the distance itself.
    pub distance: bool,
}

impl Needs {
    /// Whether lanes make all that is asked for.
    pub const fn fit_lanes(&self) -> bool {
        let both = matches!(self.widths, Widths::Both);
        let slope = matches!(self.parts, Parts::Gradient);
        (!both || slope) && (!self.distance || both)
    }
}

/// Functions of the argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parts {
    /// [`Shape::value`].
    Value,
    /// [`Shape::gradient`], [`Shape::within`].
    Gradient,
    /// All of [`Shape`].
    All,
}

/// The widths at which a pair is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Widths {
    /// Both particles have the same.
    Equal,
    /// What a particle receives depends on its own width alone.
    Own,
    /// What a particle receives depends on both widths.
    Both,
}

/// A cut-off at one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape<N> {
    /// `z(q)`.
    pub value: N,
    /// `F(q) = z'(q)/q`.
    pub gradient: N,
    /// `z''(q)`.
    pub curvature: N,
    /// 1 within the support, 0 beyond.
    pub within: N,
}

/// The cut-off of a pair: at the width of `k`, at the width of `l`, and the distance.
///
/// What a law does not ask for by its [`Needs`] is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shapes<N> {
    /// At the width of `k`.
    pub k: Shape<N>,
    /// At the width of `l`.
    pub l: Shape<N>,
    /// `|r|`.
    pub distance: N,
}

impl<N: Number> Shape<N> {
    /// Nothing.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            value: N::zero(),
            gradient: N::zero(),
            curvature: N::zero(),
            within: N::zero(),
        }
    }

    /// Of a cut-off at an argument.
    #[inline(always)]
    fn of<C: CutOff, const D: usize>(cut_off: C, parts: Parts, a: N) -> Self {
        let mut shape = Self::zero();
        if parts != Parts::Gradient {
            shape.value = cut_off.value::<D, N>(a);
        }
        if parts != Parts::Value {
            shape.gradient = cut_off.gradient::<D, N>(a);
            shape.within = a.below(N::splat(cut_off.edge()));
        }
        if parts == Parts::All {
            shape.curvature = cut_off.curvature::<D, N>(a);
        }
        shape
    }
}

impl<N: Number> Shapes<N> {
    /// Of one pair; `scales` are those of `k` and `l`, see [`CutOff::scale`].
    #[inline(always)]
    pub(super) fn make<C: CutOff, const D: usize>(
        cut_off: C,
        needs: Needs,
        distance_squared: N,
        scales: [N; 2],
    ) -> Self {
        let distance = cut_off.argument(distance_squared);
        let k = Shape::of::<C, D>(cut_off, needs.parts, distance * scales[0]);
        Self {
            k,
            l: match needs.widths {
                Widths::Equal => k,
                _ => Shape::of::<C, D>(cut_off, needs.parts, distance * scales[1]),
            },
            distance: match needs.distance {
                true => distance_squared.sqrt(),
                false => N::zero(),
            },
        }
    }
}

/// Pairs of a receiver that are looked at together: enough that choosing a cut-off costs nothing
/// beside them, few enough that they stay in the nearest cache.
pub const BLOCK: usize = 16;

/// Pairs of a block of receivers with [`BLOCK`] candidates, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct PairBlock<N: Number> {
    /// `|r|²`.
    pub distance_squared: [N; BLOCK],
    /// The scales of the candidates; read with [`Widths::Both`] alone.
    pub scale: [N::Scalar; BLOCK],
    /// `|r|`, where it is needed.
    pub distance: [N; BLOCK],
    /// The cut-off at the widths of the receivers.
    pub k: [Shape<N>; BLOCK],
    /// The cut-off at the widths of the candidates.
    pub l: [Shape<N>; BLOCK],
}

impl<N: Number> PairBlock<N> {
    /// Nothing.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            distance_squared: [N::zero(); BLOCK],
            scale: [N::Scalar::ZERO; BLOCK],
            distance: [N::zero(); BLOCK],
            k: [Shape::zero(); BLOCK],
            l: [Shape::zero(); BLOCK],
        }
    }

    /// The shapes of pair `i` as a law reads them.
    #[inline(always)]
    pub fn shapes(&self, i: usize, needs: Needs) -> Shapes<N> {
        let read = |shape: &Shape<N>| {
            let mut read = Shape::zero();
            if needs.parts != Parts::Gradient {
                read.value = shape.value;
            }
            if needs.parts != Parts::Value {
                (read.gradient, read.within) = (shape.gradient, shape.within);
            }
            if needs.parts == Parts::All {
                read.curvature = shape.curvature;
            }
            read
        };
        let k = read(&self.k[i]);
        Shapes {
            k,
            l: match needs.widths {
                Widths::Equal => k,
                Widths::Own => Shape::zero(),
                Widths::Both => read(&self.l[i]),
            },
            distance: match needs.distance {
                true => self.distance[i],
                false => N::zero(),
            },
        }
    }

    /// Makes the shapes of the first `count` pairs of receivers of that scale.
    ///
    /// One loop for each of the three needs that laws have, so that each is a handful of vector
    /// instructions; every cut-off has them. A need that no law has gets more than it asks for.
    #[inline(always)]
    pub(super) fn make<C: CutOff, const D: usize>(
        &mut self,
        cut_off: C,
        needs: Needs,
        scale: N,
        count: usize,
    ) {
        let count = count.min(BLOCK);
        match (needs.parts, needs.widths) {
            (Parts::Gradient, Widths::Both) => {
                for i in 0..count {
                    let argument = cut_off.argument(self.distance_squared[i]);
                    let at_l = argument * N::splat(self.scale[i]);
                    self.k[i].gradient = cut_off.gradient::<D, N>(argument * scale);
                    self.l[i].gradient = cut_off.gradient::<D, N>(at_l);
                    // The same root as that of the argument, where that is one.
                    self.distance[i] = self.distance_squared[i].sqrt();
                }
            }
            (Parts::Gradient, _) => {
                for i in 0..count {
                    let a = cut_off.argument(self.distance_squared[i]) * scale;
                    self.k[i].gradient = cut_off.gradient::<D, N>(a);
                    self.k[i].within = a.below(N::splat(cut_off.edge()));
                }
            }
            _ => {
                for i in 0..count {
                    let a = cut_off.argument(self.distance_squared[i]) * scale;
                    self.k[i] = Shape::of::<C, D>(cut_off, Parts::All, a);
                }
            }
        }
    }
}
