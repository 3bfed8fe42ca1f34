//! The runs of motes compiled for fixed point, and for f32 with approximate roots.

#[cfg(feature = "every")]
use fixed::types::extra::{U12, U18, U20, U22, U40, U48};
use fixed::types::extra::{U16, U19, U32};
use motes_core::scalar::{Micro, Q32, Q64};
use motes_solver::compiled::Compiled;

/// `f32` with approximate square roots.
pub static MICROMATH: Compiled = Compiled::new::<Micro>();
#[cfg(feature = "every")]
/// 32 bits, 22 of them fractional.
pub static Q9P22: Compiled = Compiled::new::<Q32<U22>>();
#[cfg(feature = "every")]
/// 32 bits, 20 of them fractional.
pub static Q11P20: Compiled = Compiled::new::<Q32<U20>>();
/// 32 bits, 19 of them fractional.
pub static Q12P19: Compiled = Compiled::new::<Q32<U19>>();
#[cfg(feature = "every")]
/// 32 bits, 18 of them fractional.
pub static Q13P18: Compiled = Compiled::new::<Q32<U18>>();
/// 32 bits, 16 of them fractional.
pub static Q15P16: Compiled = Compiled::new::<Q32<U16>>();
#[cfg(feature = "every")]
/// 32 bits, 12 of them fractional.
pub static Q19P12: Compiled = Compiled::new::<Q32<U12>>();
#[cfg(feature = "every")]
/// 64 bits, 48 of them fractional.
pub static Q15P48: Compiled = Compiled::new::<Q64<U48>>();
#[cfg(feature = "every")]
/// 64 bits, 40 of them fractional.
pub static Q23P40: Compiled = Compiled::new::<Q64<U40>>();
/// 64 bits, 32 of them fractional.
pub static Q31P32: Compiled = Compiled::new::<Q64<U32>>();
