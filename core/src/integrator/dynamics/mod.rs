//! How each equation is stepped, as a [`Dynamics`](crate::equation::Dynamics).

mod diffusion;
mod gas;
mod linear;

pub use diffusion::{DiffusionMethod, Scheme};
pub use gas::{LeapFrog, OpenGas};
