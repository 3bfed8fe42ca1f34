//! Counts instructions with SysTick, under QEMU's `-icount shift=6`: an instruction then takes 64 ns
//! of QEMU's time, and SysTick counts that at the clock of the board. On a real device it would
//! count cycles.

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;

/// What SysTick counts down from: its 24 bits.
const FULL: u32 = 0x00ff_ffff;

/// Instructions of 64 ns in 10 million ticks: 1.6 ticks each at the 25 MHz of mps2-an386, 1.024 at
/// the 16 MHz of microbit.
const RATES: [u64; 2] = [6_250_000, 9_765_625];

/// How often SysTick came to 0.
static TURNS: AtomicU32 = AtomicU32::new(0);

/// Once in 10 million instructions, for some 20 of them, which are counted as well.
#[exception]
fn SysTick() {
    TURNS.store(
        TURNS.load(Ordering::Relaxed).wrapping_add(1),
        Ordering::Relaxed,
    );
}

/// A counter of instructions.
pub struct Stopwatch {
    /// Ticks that starting and stopping take.
    empty: u64,
    /// One of [`RATES`].
    rate: u64,
}

impl Stopwatch {
    /// One that has been tried: `None` where SysTick does not count at one of the known rates.
    pub fn new(mut timer: SYST) -> Option<Self> {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(FULL);
        timer.clear_current();
        timer.enable_interrupt();
        timer.enable_counter();
        let empty = ticks(|| ());
        let stopwatch = |rate| Self { empty, rate };
        RATES.map(stopwatch).into_iter().find(Self::is_right)
    }

    /// Tries it on a loop.
    fn is_right(&self) -> bool {
        // `delay(n)` goes n + 1 times round a loop of two instructions; the calls may differ by a few.
        let short = self.instructions(|| cortex_m::asm::delay(1_000));
        let long = self.instructions(|| cortex_m::asm::delay(1_001_000));
        (1_999_990..=2_000_010).contains(&long.wrapping_sub(short))
    }

    /// The instructions of `work`.
    pub fn instructions(&self, work: impl FnOnce()) -> u64 {
        let ticks = ticks(work).saturating_sub(self.empty);
        ticks.saturating_mul(self.rate).div_ceil(10_000_000)
    }
}

/// The ticks of `work`, and of looking at the time twice.
fn ticks(work: impl FnOnce()) -> u64 {
    let start = now();
    work();
    now().wrapping_sub(start)
}

/// Ticks since SysTick was started.
fn now() -> u64 {
    loop {
        let turns = TURNS.load(Ordering::Relaxed);
        let left = SYST::get_current();
        if turns == TURNS.load(Ordering::Relaxed) {
            // A turn begins at 0, then come FULL, FULL - 1 and so on.
            let turns = u64::from(turns) * u64::from(FULL + 1);
            return turns + u64::from(left.wrapping_neg() & FULL);
        }
    }
}
