//! A panic handler that must not exist in the finished program.

use core::panic::PanicInfo;

unsafe extern "C" {
    /// Defined nowhere. If any panic can be reached, its call stays in the program and the
    /// link fails with this name.
    fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // Safety: the function does not exist, so no program that calls it can be linked.
    unsafe { a_panic_can_be_reached() }
}
