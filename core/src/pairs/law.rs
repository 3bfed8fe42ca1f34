//! What an equation has to say.

use crate::cutoff::{CutOff, Needs, Shapes};
use crate::domain::Wall;
use crate::scalar::{Number, Scalar};

/// A record of scalars that also exists with lanes in place of the scalars.
///
/// [`crate::record!`] writes the implementation.
pub trait Fields<S: Scalar>: Copy + Send + Sync {
    /// The same record over another number.
    type Of<N: Number<Scalar = S>>: Copy;
    /// Every field 0.
    const ZERO: Self;
    /// The same record in every lane.
    fn splat<N: Number<Scalar = S>>(&self) -> Self::Of<N>;
    /// Lane `i` holds the `i`-th record, and 0 beyond the last one.
    fn gather<'a, N: Number<Scalar = S>>(records: impl Iterator<Item = &'a Self>) -> Self::Of<N>
    where
        Self: 'a;
    /// The record in lane `i`.
    fn lane<N: Number<Scalar = S>>(of: &Self::Of<N>, i: usize) -> Self;
}

/// Defines a record over a number, and its [`Fields`].
#[macro_export]
macro_rules! record {
    (
        $(#[$doc:meta])*
        pub struct $name:ident<N, const D: usize> {
            $($(#[$field_doc:meta])* pub $field:ident: N,)*
            $(; $($(#[$vector_doc:meta])* pub $vector:ident: [N; D],)*
            $(; $($(#[$matrix_doc:meta])* pub $matrix:ident: [[N; D]; D],)*)?)?
        }
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<N, const D: usize> {
            $($(#[$field_doc])* pub $field: N,)*
            $($($(#[$vector_doc])* pub $vector: [N; D],)*
            $($($(#[$matrix_doc])* pub $matrix: [[N; D]; D],)*)?)?
        }

        impl<S: $crate::scalar::Scalar, const D: usize> $crate::pairs::Fields<S> for $name<S, D> {
            type Of<N: $crate::scalar::Number<Scalar = S>> = $name<N, D>;
            const ZERO: Self = Self {
                $($field: S::ZERO,)*
                $($($vector: [S::ZERO; D],)*
                $($($matrix: [[S::ZERO; D]; D],)*)?)?
            };

            #[inline(always)]
            fn splat<N: $crate::scalar::Number<Scalar = S>>(&self) -> $name<N, D> {
                $name {
                    $($field: N::splat(self.$field),)*
                    $($($vector: {
                        let mut vector = [N::zero(); D];
                        for i in 0..D {
                            vector[i] = N::splat(self.$vector[i]);
                        }
                        vector
                    },)*
                    $($($matrix: {
                        let mut matrix = [[N::zero(); D]; D];
                        for i in 0..D {
                            for j in 0..D {
                                matrix[i][j] = N::splat(self.$matrix[i][j]);
                            }
                        }
                        matrix
                    },)*)?)?
                }
            }
            #[inline(always)]
            fn gather<'a, N: $crate::scalar::Number<Scalar = S>>(
                records: impl Iterator<Item = &'a Self>,
            ) -> $name<N, D>
            where
                Self: 'a,
            {
                let mut of = Self::ZERO.splat::<N>();
                for (i, record) in records.take(N::LANES).enumerate() {
                    $(of.$field.set_lane(i, record.$field);)*
                    $($(for j in 0..D {
                        of.$vector[j].set_lane(i, record.$vector[j]);
                    })*
                    $($(for j in 0..D {
                        for m in 0..D {
                            of.$matrix[j][m].set_lane(i, record.$matrix[j][m]);
                        }
                    })*)?)?
                }
                of
            }
            #[inline(always)]
            fn lane<N: $crate::scalar::Number<Scalar = S>>(of: &$name<N, D>, i: usize) -> Self {
                Self {
                    $($field: of.$field.lane(i),)*
                    $($($vector: {
                        let mut vector = [S::ZERO; D];
                        for j in 0..D {
                            vector[j] = of.$vector[j].lane(i);
                        }
                        vector
                    },)*
                    $($($matrix: {
                        let mut matrix = [[S::ZERO; D]; D];
                        for j in 0..D {
                            for m in 0..D {
                                matrix[j][m] = of.$matrix[j][m].lane(i);
                            }
                        }
                        matrix
                    },)*)?)?
                }
            }
        }
    };
}

/// What lies between the particles of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation<N, const D: usize> {
    /// `r = x_k - x_l`.
    pub r: [N; D],
    /// `|r|²`.
    pub distance_squared: N,
    /// The cut-off: what [`Law::NEEDS`] asks for.
    pub zeta: Shapes<N>,
}

impl<S: Scalar, const D: usize> Separation<S, D> {
    /// Of two particles met one by one, `r` apart.
    #[inline(always)]
    pub fn of<W: Law<S, D>>(
        law: &W,
        [k, l]: [&<W::Node as Fields<S>>::Of<S>; 2],
        r: [S; D],
        distance_squared: S,
    ) -> Self {
        let scales = [law.scale::<S>(k), law.scale::<S>(l)];
        Self {
            r,
            distance_squared,
            zeta: Shapes::of::<W::CutOff, D>(law.cut_off(), W::NEEDS, distance_squared, scales),
        }
    }
}

/// An equation: a sum over partners of a pair term.
///
/// It has no storage, no threads and no loop over neighbours. Everything is indexed as in
/// the paper: `k` receives, `l` is its partner, `r = x_k - x_l`.
pub trait Law<S: Scalar, const D: usize>: Sync {
    /// What a particle shows to its partners.
    type Node: Fields<S>;
    /// What it receives.
    type Sums: Fields<S>;
    /// The cut-off of its sums.
    type CutOff: CutOff;
    /// What it reads of the cut-off.
    const NEEDS: Needs;

    /// The cut-off.
    fn cut_off(&self) -> Self::CutOff;

    /// A particle's part of the argument of the cut-off: see [`CutOff::scale`].
    fn scale<N: Number<Scalar = S>>(&self, node: &<Self::Node as Fields<S>>::Of<N>) -> N;

    /// Adds the term of the pair to both of its particles.
    ///
    /// What `l` receives here has the bits that it would receive as `k` of the pair seen from
    /// the other side: write terms that are equal or exactly opposite, and functions of one
    /// of the two for each its own. A pair out of reach must add exactly 0. With `r = 0` it
    /// is the term of a particle on itself.
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &<Self::Node as Fields<S>>::Of<N>,
        l: &<Self::Node as Fields<S>>::Of<N>,
        apart: &Separation<N, D>,
        to_k: &mut <Self::Sums as Fields<S>>::Of<N>,
        to_l: &mut <Self::Sums as Fields<S>>::Of<N>,
    );

    /// Looks at a particle's sums: `true` when they are final; `false` to have them made
    /// again with the node that it changed. A law that does so bounds its passes itself.
    fn close(&self, node: &mut Self::Node, sums: &Self::Sums) -> bool {
        let _ = (node, sums);
        true
    }

    /// The mirror image of a node in a wall; where the image is the engine knows.
    fn reflected(&self, node: &Self::Node, wall: &Wall<S>) -> Self::Node {
        let _ = wall;
        *node
    }
}

/// The node of a particle after the last pass, and its sums.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled<Node, Sums> {
    /// As [`Law::close`] left it.
    pub node: Node,
    /// The sums of the last pass.
    pub sums: Sums,
}

impl<Node, Sums> Settled<Node, Sums> {
    /// A result that has not been written yet.
    pub const fn new(node: Node, sums: Sums) -> Self {
        Self { node, sums }
    }
}
