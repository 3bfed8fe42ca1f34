//! The fields of a state: what each is called, what it is made of, and its numbers in id order.
//!
//! Digests, output, checkpoints and bindings are written once against this description, for every
//! equation.

use crate::digest::{Digest, Digester};
use crate::numbered::numbered;
use crate::scalar::Scalar;

/// A field of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// What it is called in files.
    pub name: &'static str,
    /// What its numbers are.
    pub kind: Kind,
    /// How many there are for each particle.
    pub components: Components,
    /// Their dimension.
    pub unit: Unit,
    /// What it is to the run.
    pub role: Role,
}

/// What the numbers of a field are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Coordinates.
    Position,
    /// Components along the directions of space.
    Vector,
    /// Numbers that do not turn with the axes.
    Scalar,
    /// Sums of products, in double width: [`Scalar::Wide`].
    Strength,
    /// Whole numbers.
    Integer,
}

/// How many numbers a particle has of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Components {
    /// One.
    One,
    /// One for each direction of space.
    Directions,
    /// One for each component of the unknown.
    Unknowns,
}

/// A dimension: powers of length, mass, time and of the unknown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unit {
    /// Of length, for each direction of space.
    pub per_direction: i8,
    /// Of length.
    pub length: i8,
    /// Of mass.
    pub mass: i8,
    /// Of time.
    pub time: i8,
    /// Of the unknown.
    pub unknown: i8,
}

/// What a field is to a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The next step starts from it, and the digest covers it.
    State,
    /// The next step starts from it; the digest does not cover it.
    Carried,
    /// Made from the others.
    Derived,
}

/// The numbers of a field, in id order, all components of a particle together.
#[derive(Clone, Copy, Debug)]
pub enum Column<'a, S: Scalar> {
    /// Of [`Kind::Position`], [`Kind::Vector`] and [`Kind::Scalar`].
    Scalars(&'a [S]),
    /// Of [`Kind::Strength`].
    Strengths(&'a [S::Wide]),
    /// Of [`Kind::Integer`].
    Integers(&'a [u8]),
}

/// The same, to write to.
#[derive(Debug)]
pub enum ColumnMut<'a, S: Scalar> {
    /// Of [`Kind::Position`], [`Kind::Vector`] and [`Kind::Scalar`].
    Scalars(&'a mut [S]),
    /// Of [`Kind::Strength`].
    Strengths(&'a mut [S::Wide]),
    /// Of [`Kind::Integer`].
    Integers(&'a mut [u8]),
}

/// A state that can be described: fields, and their numbers.
pub trait Columns<S: Scalar> {
    /// The fields, in the order of digests and files.
    fn fields(&self) -> &'static [Field];
    /// The numbers of the field at that place of the list; `None` beyond its end.
    fn column(&self, field: usize) -> Option<Column<'_, S>>;
    /// The same, to write to.
    fn column_mut(&mut self, field: usize) -> Option<ColumnMut<'_, S>>;

    /// The digest: all fields of [`Role::State`], one after the other.
    fn digest(&self) -> Digest {
        let mut digester = Digester::new();
        for (place, field) in numbered(self.fields()) {
            if field.role != Role::State {
                continue;
            }
            if let Some(column) = self.column(place) {
                column.add_to(&mut digester);
            }
        }
        digester.digest()
    }

    /// The digest of the same numbers in any order of the particles: the sum, modulo 2^64, of the
    /// digests of their rows, each the fields of [`Role::State`] one after the other.
    ///
    /// Particles change places without changing it; it changes when a bit of one does, and when one
    /// comes or goes, a twin of another too.
    fn digest_unordered(&self) -> Digest {
        let fields = || numbered(self.fields()).filter(|(_, field)| field.role == Role::State);
        let mut one = fields().filter(|(_, field)| field.components == Components::One);
        let particles = one.next().and_then(|(place, _)| self.column(place));
        let particles = particles.map_or(0, |column| column.len());
        let mut sum = 0u64;
        for id in 0..particles {
            let mut row = Digester::new();
            for (place, _) in fields() {
                if let Some(column) = self.column(place) {
                    column.row(id, particles).add_to(&mut row);
                }
            }
            sum = sum.wrapping_add(row.digest().0);
        }
        Digest(sum)
    }

    /// Bytes of one particle that the next step starts from: its fields of [`Role::State`] and
    /// [`Role::Carried`]. 0 without particles.
    fn state_bytes(&self) -> usize {
        let fields = || numbered(self.fields());
        let mut one = fields().filter(|(_, field)| field.components == Components::One);
        let particles = one.next().and_then(|(place, _)| self.column(place));
        let particles = particles.map_or(0, |column| column.len());
        let kept = fields().filter(|(_, field)| field.role != Role::Derived);
        let bytes = kept.filter_map(|(place, _)| self.column(place).map(|column| column.bytes()));
        bytes.sum::<usize>().checked_div(particles).unwrap_or(0)
    }
}

impl<S: Scalar> Column<'_, S> {
    /// Bytes of all of them.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Scalars(values) => size_of_val(*values),
            Self::Strengths(values) => size_of_val(*values),
            Self::Integers(values) => size_of_val(*values),
        }
    }

    /// How many numbers there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Scalars(values) => values.len(),
            Self::Strengths(values) => values.len(),
            Self::Integers(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The numbers of one of so many particles; none beyond the last.
    pub fn row(&self, id: usize, particles: usize) -> Self {
        fn row<T>(values: &[T], id: usize, particles: usize) -> &[T] {
            let each = values.len().checked_div(particles).unwrap_or(0).max(1);
            values.chunks_exact(each).nth(id).unwrap_or(&[])
        }
        match self {
            Self::Scalars(values) => Self::Scalars(row(values, id, particles)),
            Self::Strengths(values) => Self::Strengths(row(values, id, particles)),
            Self::Integers(values) => Self::Integers(row(values, id, particles)),
        }
    }

    fn add_to(&self, digester: &mut Digester) {
        match self {
            Self::Scalars(values) => digester.scalars(values),
            Self::Strengths(values) => digester.wide::<S>(values),
            Self::Integers(values) => digester.integers(values),
        }
    }
}

impl Unit {
    /// A plain number.
    pub const NONE: Self = Self {
        per_direction: 0,
        length: 0,
        mass: 0,
        time: 0,
        unknown: 0,
    };
    /// A length.
    pub const LENGTH: Self = Self {
        length: 1,
        ..Self::NONE
    };
    /// A volume: as many lengths as space has directions.
    pub const VOLUME: Self = Self {
        per_direction: 1,
        ..Self::NONE
    };
    /// A mass.
    pub const MASS: Self = Self {
        mass: 1,
        ..Self::NONE
    };
    /// A velocity.
    pub const VELOCITY: Self = Self {
        length: 1,
        time: -1,
        ..Self::NONE
    };
    /// The unknown of a system.
    pub const UNKNOWN: Self = Self {
        unknown: 1,
        ..Self::NONE
    };

    /// The product of two units.
    pub const fn times(self, other: Self) -> Self {
        Self {
            per_direction: self.per_direction + other.per_direction,
            length: self.length + other.length,
            mass: self.mass + other.mass,
            time: self.time + other.time,
            unknown: self.unknown + other.unknown,
        }
    }

    /// One over it.
    pub const fn inverse(self) -> Self {
        Self {
            per_direction: -self.per_direction,
            length: -self.length,
            mass: -self.mass,
            time: -self.time,
            unknown: -self.unknown,
        }
    }
}

impl Components {
    /// How many, in that many directions and for so many unknowns.
    pub const fn count(self, directions: usize, unknowns: usize) -> usize {
        match self {
            Self::One => 1,
            Self::Directions => directions,
            Self::Unknowns => unknowns,
        }
    }
}

/// Implements [`Columns`] from a table: field, how it is kept, what it is.
///
/// Kept as `scalars` (`[S]`), `vectors` (`[[S; K]]`), `strengths` (`[[S::Wide; K]]`) or `integers`
/// (`[u8]`).
macro_rules! columns {
    (
        impl [$($generics:tt)*] $state:ty {
            $($field:ident: $kept:ident, $kind:ident, $components:ident, $unit:expr, $role:ident;)*
        }
    ) => {
        impl<S: $crate::scalar::Scalar, $($generics)*> $crate::cloud::Columns<S> for $state {
            fn fields(&self) -> &'static [$crate::cloud::Field] {
                use $crate::cloud::{Components, Field, Kind, Role};
                const {
                    &[$(Field {
                        name: stringify!($field),
                        kind: Kind::$kind,
                        components: Components::$components,
                        unit: $unit,
                        role: Role::$role,
                    },)*]
                }
            }

            fn column(&self, field: usize) -> Option<$crate::cloud::Column<'_, S>> {
                let mut place = 0..;
                $(if place.next() == Some(field) {
                    return Some($crate::cloud::columns!(@column $kept, &self.$field));
                })*
                None
            }

            fn column_mut(&mut self, field: usize) -> Option<$crate::cloud::ColumnMut<'_, S>> {
                let mut place = 0..;
                $(if place.next() == Some(field) {
                    return Some($crate::cloud::columns!(@column_mut $kept, self.$field));
                })*
                None
            }
        }
    };
    (@column scalars, $array:expr) => { $crate::cloud::Column::Scalars($array) };
    (@column vectors, $array:expr) => { $crate::cloud::Column::Scalars($array.as_flattened()) };
    (@column strengths, $array:expr) => { $crate::cloud::Column::Strengths($array.as_flattened()) };
    (@column integers, $array:expr) => { $crate::cloud::Column::Integers($array) };
    (@column_mut scalars, $array:expr) => { $crate::cloud::ColumnMut::Scalars($array) };
    (@column_mut vectors, $array:expr) => {
        $crate::cloud::ColumnMut::Scalars($array.as_flattened_mut())
    };
    (@column_mut strengths, $array:expr) => {
        $crate::cloud::ColumnMut::Strengths($array.as_flattened_mut())
    };
    (@column_mut integers, $array:expr) => { $crate::cloud::ColumnMut::Integers($array) };
}
pub(crate) use columns;
