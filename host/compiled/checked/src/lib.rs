//! The runs of motes compiled for fixed point that marks overflow and stops at the first.

use fixed::types::extra::{U12, U16, U18, U19, U20, U22, U32, U40, U48};
use motes_core::scalar::{Checked, Q32, Q64};
use motes_solver::compiled::Compiled;

/// 32 bits, 22 of them fractional.
pub static Q9P22: Compiled = Compiled::small::<Checked<Q32<U22>>>();
/// 32 bits, 20 of them fractional.
pub static Q11P20: Compiled = Compiled::small::<Checked<Q32<U20>>>();
/// 32 bits, 19 of them fractional.
pub static Q12P19: Compiled = Compiled::small::<Checked<Q32<U19>>>();
/// 32 bits, 18 of them fractional.
pub static Q13P18: Compiled = Compiled::small::<Checked<Q32<U18>>>();
/// 32 bits, 16 of them fractional.
pub static Q15P16: Compiled = Compiled::small::<Checked<Q32<U16>>>();
/// 32 bits, 12 of them fractional.
pub static Q19P12: Compiled = Compiled::small::<Checked<Q32<U12>>>();
/// 64 bits, 48 of them fractional.
pub static Q15P48: Compiled = Compiled::small::<Checked<Q64<U48>>>();
/// 64 bits, 40 of them fractional.
pub static Q23P40: Compiled = Compiled::small::<Checked<Q64<U40>>>();
/// 64 bits, 32 of them fractional.
pub static Q31P32: Compiled = Compiled::small::<Checked<Q64<U32>>>();
