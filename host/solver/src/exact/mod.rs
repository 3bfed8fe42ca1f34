//! Exact solutions, one per file, shared by tests, pictures and studies.

pub mod channel;
pub mod diffusion;
pub mod finite_volume;
pub mod flow;
pub mod formula;
pub mod gresho;
pub mod kelvin_helmholtz;
pub mod linear;
pub mod moving_centre;
pub mod noh;
#[cfg(test)]
mod residual;
pub mod riemann;
pub mod sedov;
pub mod solution;
pub mod sound_wave;
pub mod taylor_green;
pub mod yee_vortex;
