//! A cut-off chosen while the program runs.

use super::{
    CubicSpline, CutOff, Needs, PairBlock, QuinticSpline, QuinticSplineFour, RootFree, Smooth,
    WendlandC2, WendlandC4, WendlandC6,
};
use crate::scalar::{Number, Scalar};

macro_rules! named {
    ($($(#[$doc:meta])* $variant:ident => $value:expr, $name:literal;)*) => {
        /// Any of the cut-offs, by name. Gives the bits of the cut-off it names. In
        /// receiver lanes it is as fast as one that is compiled into the loop; where pairs are met
        /// one by one it is looked up once for each.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Named {
            $($(#[$doc])* $variant,)*
        }

        impl Named {
            /// Every name, in the order of the documentation.
            pub const NAMES: &'static [&'static str] = &[$($name,)*];

            /// The cut-off of that name.
            pub fn from_name(name: &str) -> Option<Self> {
                match name {
                    $($name => Some(Self::$variant),)*
                    _ => None,
                }
            }
            /// The name in scenario files.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }
        }

        impl CutOff for Named {
            fn support(self) -> u32 {
                match self { $(Self::$variant => $value.support(),)* }
            }
            fn order(self) -> u32 {
                match self { $(Self::$variant => $value.order(),)* }
            }
            fn smoothness<const D: usize>(self) -> u32 {
                match self { $(Self::$variant => $value.smoothness::<D>(),)* }
            }
            fn normalisation<const D: usize>(self) -> f64 {
                match self { $(Self::$variant => $value.normalisation::<D>(),)* }
            }
            #[inline]
            fn value<const D: usize, N: Number>(self, a: N) -> N {
                match self { $(Self::$variant => $value.value::<D, N>(a),)* }
            }
            #[inline]
            fn gradient<const D: usize, N: Number>(self, a: N) -> N {
                match self { $(Self::$variant => $value.gradient::<D, N>(a),)* }
            }
            #[inline]
            fn curvature<const D: usize, N: Number>(self, a: N) -> N {
                match self { $(Self::$variant => $value.curvature::<D, N>(a),)* }
            }
            #[inline]
            fn argument<N: Number>(self, distance_squared: N) -> N {
                match self { $(Self::$variant => $value.argument(distance_squared),)* }
            }
            #[inline]
            fn scale<S: Scalar>(self, inverse_epsilon: S) -> S {
                match self { $(Self::$variant => $value.scale(inverse_epsilon),)* }
            }
            #[inline]
            fn edge<S: Scalar>(self) -> S {
                match self { $(Self::$variant => $value.edge(),)* }
            }
            // On a server, where all cut-offs are there: chosen once for a pair, in a function that laws
            // share. On a device the one that there is, is known while it is compiled.
            #[cfg(feature = "std")]
            #[inline(never)]
            fn shapes_of_pair<const D: usize, N: Number>(
                self,
                needs: Needs,
                distance_squared: N,
                scales: [N; 2],
            ) -> super::Shapes<N> {
                match self {
                    $(Self::$variant => {
                        $value.shapes_of_pair::<D, N>(needs, distance_squared, scales)
                    })*
                }
            }
            #[inline(always)]
            fn shapes<const D: usize, N: Number>(
                self,
                needs: Needs,
                scale: N,
                count: usize,
                pairs: &mut PairBlock<N>,
            ) {
                match self {
                    $(Self::$variant => $value.shapes::<D, N>(needs, scale, count, pairs),)*
                }
            }
        }
    };
}

named! {
    /// [`CubicSpline`], M4.
    CubicSpline => CubicSpline, "cubic-spline";
    /// [`QuinticSpline`], M6.
    QuinticSpline => QuinticSpline, "quintic-spline";
    /// [`WendlandC2`].
    WendlandC2 => WendlandC2, "wendland-c2";
    /// [`WendlandC4`].
    WendlandC4 => WendlandC4, "wendland-c4";
    /// [`WendlandC6`].
    WendlandC6 => WendlandC6, "wendland-c6";
    /// [`RootFree`] with exponent 4.
    RootFree => RootFree::<4>, "root-free";
    /// [`QuinticSplineFour`], of order 4.
    QuinticSplineFour => QuinticSplineFour, "quintic-spline-4";
    /// [`Smooth`] with exponent 7, of order 2.
    SmoothTwo => Smooth::<7, 2>, "smooth-2";
    /// [`Smooth`] with exponent 7, of order 4.
    SmoothFour => Smooth::<7, 4>, "smooth-4";
    /// [`Smooth`] with exponent 7, of order 6.
    SmoothSix => Smooth::<7, 6>, "smooth-6";
}
