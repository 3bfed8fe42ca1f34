//! Records of numbers, and the same records with several numbers side by side.

use crate::numbered::numbered;
use crate::scalar::{Number, Scalar};

/// A record of scalars that also exists with lanes in place of the scalars.
///
/// A scalar is such a record, and so is an array of them; [`crate::record!`] defines others.
pub trait Fields<S: Scalar>: Copy + Send + Sync + 'static {
    /// The same record over another number.
    type Of<N: Number<Scalar = S>>: Copy;
    /// Every field 0.
    const ZERO: Self;
    /// The same record in every lane.
    fn splat<N: Number<Scalar = S>>(&self) -> Self::Of<N>;
    /// Replaces the record in lane `i`; does nothing beyond the last lane.
    fn set_lane<N: Number<Scalar = S>>(of: &mut Self::Of<N>, i: usize, record: &Self);
    /// The record in lane `i`.
    fn lane<N: Number<Scalar = S>>(of: &Self::Of<N>, i: usize) -> Self;
    /// Visits every number of the record; `self`, whatever it is, tells which record it is.
    fn each<N: Number<Scalar = S>>(&self, of: &Self::Of<N>, see: &mut dyn FnMut(N));

    /// Lane `i` holds the `i`-th record, and 0 beyond the last one.
    #[inline(always)]
    fn gather<'a, N: Number<Scalar = S>>(records: impl Iterator<Item = &'a Self>) -> Self::Of<N>
    where
        Self: 'a,
    {
        let mut of = Self::ZERO.splat::<N>();
        for (i, record) in numbered(records.take(N::LANES)) {
            Self::set_lane::<N>(&mut of, i, record);
        }
        of
    }
}

/// No data: a record without fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Nothing;

impl<S: Scalar> Fields<S> for Nothing {
    type Of<N: Number<Scalar = S>> = Self;
    const ZERO: Self = Self;

    #[inline(always)]
    fn splat<N: Number<Scalar = S>>(&self) -> Self {
        Self
    }
    #[inline(always)]
    fn set_lane<N: Number<Scalar = S>>(_: &mut Self, _: usize, _: &Self) {}
    #[inline(always)]
    fn lane<N: Number<Scalar = S>>(_: &Self, _: usize) -> Self {
        Self
    }
    fn each<N: Number<Scalar = S>>(&self, _: &Self, _: &mut dyn FnMut(N)) {}
}

impl<S: Scalar> Fields<S> for S {
    type Of<N: Number<Scalar = S>> = N;
    const ZERO: Self = <S as Scalar>::ZERO;

    #[inline(always)]
    fn splat<N: Number<Scalar = S>>(&self) -> N {
        N::splat(*self)
    }
    #[inline(always)]
    fn set_lane<N: Number<Scalar = S>>(of: &mut N, i: usize, record: &S) {
        of.set_lane(i, *record);
    }
    #[inline(always)]
    fn lane<N: Number<Scalar = S>>(of: &N, i: usize) -> S {
        of.lane(i)
    }
    fn each<N: Number<Scalar = S>>(&self, of: &N, see: &mut dyn FnMut(N)) {
        see(*of);
    }
}

// By index: a map in a map of lanes is copied through memory, lane by lane, and a sixth slower. One
// number by a map: the loop has the compiler divide for a harmonic mean that nothing asks for, 8 %
// of a step in f32 without an FPU.
impl<S: Scalar, F: Fields<S>, const K: usize> Fields<S> for [F; K] {
    type Of<N: Number<Scalar = S>> = [F::Of<N>; K];
    const ZERO: Self = [F::ZERO; K];

    #[inline(always)]
    fn splat<N: Number<Scalar = S>>(&self) -> [F::Of<N>; K] {
        if N::LANES == 1 {
            return self.map(|field| field.splat::<N>());
        }
        let mut of = [F::ZERO.splat::<N>(); K];
        for j in 0..K {
            of[j] = self[j].splat::<N>();
        }
        of
    }
    #[inline(always)]
    fn set_lane<N: Number<Scalar = S>>(of: &mut [F::Of<N>; K], i: usize, record: &Self) {
        for j in 0..K {
            F::set_lane::<N>(&mut of[j], i, &record[j]);
        }
    }
    #[inline(always)]
    fn lane<N: Number<Scalar = S>>(of: &[F::Of<N>; K], i: usize) -> Self {
        if N::LANES == 1 {
            return core::array::from_fn(|j| F::lane::<N>(&of[j], i));
        }
        let mut record = [F::ZERO; K];
        for j in 0..K {
            record[j] = F::lane::<N>(&of[j], i);
        }
        record
    }
    fn each<N: Number<Scalar = S>>(&self, of: &[F::Of<N>; K], see: &mut dyn FnMut(N)) {
        for (field, of) in self.iter().zip(of) {
            field.each::<N>(of, see);
        }
    }
}

/// Defines a record over a number, and its [`Fields`](crate::pairs::Fields).
///
/// The first parameter is called `N`; it stands for the number. Constant ones follow as needed.
/// A field is an `N`, an array of what may be a field, or another record over `N`, in any order:
///
/// ```
/// use motes_core::pairs::Fields;
/// use motes_core::record;
/// use motes_core::scalar::Lanes;
///
/// record! {
///     /// What a particle of `P` species shows.
///     pub struct Species<N, const P: usize> {
///         /// `u`.
///         pub value: [N; P],
///         /// Weight `w`.
///         pub weight: N,
///     }
/// }
/// record! {
///     /// The same, and its fluxes.
///     pub struct Flow<N, const D: usize, const P: usize> {
///         /// `-b ∇u` of each species.
///         pub flux: [[N; D]; P],
///         /// What it shows without them.
///         pub node: Species<N, P>,
///     }
/// }
///
/// let node = Species { value: [1.0, 2.0], weight: 3.0 };
/// let flow = Flow { flux: [[4.0; 3]; 2], node };
/// let lanes = Flow::gather::<Lanes<f64, 4>>([flow, flow].iter());
/// assert_eq!(lanes.node.value[1], Lanes([2.0, 2.0, 0.0, 0.0]));
/// assert_eq!(Flow::lane(&lanes, 1), flow);
/// ```
///
/// A second type parameter is a record that the user of this one chooses. Over lanes it is that
/// record over lanes:
///
/// ```
/// use motes_core::pairs::Fields;
/// use motes_core::record;
/// use motes_core::scalar::Lanes;
///
/// record! {
///     /// What a particle shows in a medium.
///     pub struct Within<N, M, const D: usize> {
///         /// What is known of the place.
///         pub medium: M,
///         /// Velocity.
///         pub velocity: [N; D],
///     }
/// }
///
/// let within = Within { medium: [1.0, 2.0], velocity: [3.0] };
/// let lanes: Within<Lanes<f64, 2>, [Lanes<f64, 2>; 2], 1> = within.splat();
/// assert_eq!(lanes.medium[0], Lanes([1.0; 2]));
/// assert_eq!(Within::lane(&lanes, 1), within);
/// ```
#[macro_export]
macro_rules! record {
    (
        $(#[$meta:meta])*
        pub struct $name:ident<N $(, const $constant:ident: usize)*> {
            $($(#[$field_meta:meta])* pub $field:ident: $type:ty),* $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<N $(, const $constant: usize)*> {
            $($(#[$field_meta])* pub $field: $type,)*
        }

        impl<S: $crate::scalar::Scalar $(, const $constant: usize)*> $crate::pairs::Fields<S>
            for $name<S $(, $constant)*>
        {
            type Of<N: $crate::scalar::Number<Scalar = S>> = $name<N $(, $constant)*>;
            $crate::record! { @fields $name { $($field)* } }
        }
    };
    (
        $(#[$meta:meta])*
        pub struct $name:ident<N, $record:ident $(, const $constant:ident: usize)*> {
            $($(#[$field_meta:meta])* pub $field:ident: $type:ty),* $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<N, $record $(, const $constant: usize)*> {
            $($(#[$field_meta])* pub $field: $type,)*
        }

        impl<S, $record $(, const $constant: usize)*> $crate::pairs::Fields<S>
            for $name<S, $record $(, $constant)*>
        where
            S: $crate::scalar::Scalar,
            $record: $crate::pairs::Fields<S>,
        {
            type Of<N: $crate::scalar::Number<Scalar = S>> =
                $name<N, $record::Of<N> $(, $constant)*>;
            $crate::record! { @fields $name { $($field)* } }
        }
    };
    (@fields $name:ident { $($field:ident)* }) => {
        const ZERO: Self = $name {
            $($field: $crate::pairs::Fields::<S>::ZERO,)*
        };

        #[inline(always)]
        fn splat<N: $crate::scalar::Number<Scalar = S>>(&self) -> Self::Of<N> {
            $name {
                $($field: $crate::pairs::Fields::<S>::splat::<N>(&self.$field),)*
            }
        }
        #[inline(always)]
        fn set_lane<N: $crate::scalar::Number<Scalar = S>>(
            of: &mut Self::Of<N>,
            i: usize,
            record: &Self,
        ) {
            $($crate::pairs::Fields::<S>::set_lane::<N>(&mut of.$field, i, &record.$field);)*
        }
        #[inline(always)]
        fn lane<N: $crate::scalar::Number<Scalar = S>>(of: &Self::Of<N>, i: usize) -> Self {
            $name {
                $($field: $crate::pairs::Fields::<S>::lane::<N>(&of.$field, i),)*
            }
        }
        fn each<N: $crate::scalar::Number<Scalar = S>>(
            &self,
            of: &Self::Of<N>,
            see: &mut dyn FnMut(N),
        ) {
            $($crate::pairs::Fields::<S>::each::<N>(&self.$field, &of.$field, see);)*
        }
    };
}
