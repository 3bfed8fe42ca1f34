//! The runs of motes compiled for fixed point in 32 bits.

#[cfg(feature = "every")]
use fixed::types::extra::{U12, U18, U20, U22};
use fixed::types::extra::{U16, U19};
use motes_core::scalar::Q32;
use motes_solver::compiled::Compiled;

#[cfg(feature = "every")]
/// 22 fractional bits.
pub static Q9P22: Compiled = Compiled::new::<Q32<U22>>();
#[cfg(feature = "every")]
/// 20 fractional bits.
pub static Q11P20: Compiled = Compiled::new::<Q32<U20>>();
/// 19 fractional bits.
pub static Q12P19: Compiled = Compiled::new::<Q32<U19>>();
#[cfg(feature = "every")]
/// 18 fractional bits.
pub static Q13P18: Compiled = Compiled::new::<Q32<U18>>();
/// 16 fractional bits.
pub static Q15P16: Compiled = Compiled::new::<Q32<U16>>();
#[cfg(feature = "every")]
/// 12 fractional bits.
pub static Q19P12: Compiled = Compiled::new::<Q32<U12>>();
