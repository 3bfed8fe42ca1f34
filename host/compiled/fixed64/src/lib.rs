//! The runs of motes compiled for fixed point in 64 bits.

use fixed::types::extra::U32;
#[cfg(feature = "every")]
use fixed::types::extra::{U40, U48};
use motes_core::scalar::Q64;
use motes_solver::compiled::Compiled;

#[cfg(feature = "every")]
/// 48 fractional bits.
pub static Q15P48: Compiled = Compiled::new::<Q64<U48>>();
#[cfg(feature = "every")]
/// 40 fractional bits.
pub static Q23P40: Compiled = Compiled::new::<Q64<U40>>();
/// 32 fractional bits.
pub static Q31P32: Compiled = Compiled::new::<Q64<U32>>();
