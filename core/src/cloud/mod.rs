//! A cloud of particles, whatever the equation: what is known of it, field by field, and what the
//! linear systems and convection-diffusion share: strengths that particles carry along a velocity
//! field.

mod column;
mod frame;
mod place;
mod registers;
mod slot;
mod state;
#[cfg(feature = "heapless")]
mod storage;
mod velocity;
mod words;

pub(crate) use column::columns;
pub use column::{Column, ColumnMut, Columns, Components, Field, Kind, Role, Unit};
pub use frame::{Frame, Units};
pub use place::Place;
pub use registers::{Register, Start};
pub(crate) use registers::{accumulate, clear, put, remember, remember_strengths};
pub use slot::Slot;
pub use state::{Particle, State};
#[cfg(feature = "heapless")]
pub(crate) use storage::{CloudParts, CloudStorage};
pub use velocity::{
    Compression, Named as NamedField, Rotation, Shear, Still, Uniform, VelocityField, Wave,
};
pub use words::{Load, Remaining, Save, Words};
