//! The equations of the paper. One folder or file each; every one is a
//! [`Law`](crate::pairs::Law) and what goes with it.

pub mod diffusion;
pub mod gas;
pub mod linear;
