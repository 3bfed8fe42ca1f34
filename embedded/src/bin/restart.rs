//! A wall in the weather that loses its power again and again, at any step and while it saves itself, and
//! is on with the same bits after each reset.
//!
//! Prints the line of the wall that never lost it: scenario, particles, scalar, digest; behind it how often
//! power was lost.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixed::types::extra::U16;
use motes_core::cloud::Slot;
use motes_core::error::Error;
use motes_core::scalar::Q32;
use motes_firmware::console::Console;
use motes_firmware::diffusion::{Storage, start};
use motes_firmware::wall::{NAME, PARTICLES};
use static_cell::ConstStaticCell;

type S = Q32<U16>;
/// Bytes of a slot: the words of the wall.
const BYTES: usize = 4096;

static WALL: ConstStaticCell<Storage<S>> = ConstStaticCell::new(Storage::new());
/// What a reset leaves: battery-backed memory, or flash that these are copied to.
static SLOTS: ConstStaticCell<[Slot<BYTES>; 2]> = ConstStaticCell::new([Slot::new(), Slot::new()]);

#[entry]
fn main() -> ! {
    let mut console = Console::open();
    let outcome = match (WALL.try_take(), SLOTS.try_take()) {
        (Some(wall), Some(slots)) => survive(wall, slots),
        _ => Err(Error::Lengths),
    };
    console.row(NAME, PARTICLES, "q15.16");
    match outcome {
        Ok((digest, losses)) => {
            console.hexadecimal(digest);
            console.text(" losses ");
            console.decimal(losses);
            console.text("\n");
        }
        Err(_) => console.text("failed\n"),
    }
    console.close(matches!(outcome, Ok((_, losses)) if losses > 50))
}

/// Runs to the end through losses of power; the digest, and how many there were.
fn survive(wall: &mut Storage<S>, slots: &mut [Slot<BYTES>; 2]) -> Result<(u64, u64), Error> {
    let mut losses = 0u64;
    // Marsaglia's generator (J. Stat. Softw. 8, 14, 2003): when power is lost.
    let mut chance = 1u32;
    loop {
        // After a reset: nothing is left but the slots.
        let mut run = start(wall)?;
        if let Some(slot) = Slot::newer(slots) {
            slot.load(|words| run.pass(words))?;
        }
        loop {
            if run.step()?.is_none() {
                return Ok((run.state().digest().0, losses));
            }
            chance ^= chance << 13;
            chance ^= chance >> 17;
            chance ^= chance << 5;
            let is_lost = chance.is_multiple_of(8);
            let saved = Slot::older(slots).save(run.clock().steps, |words| {
                run.pass(words)?;
                // In mid-save, once in a while.
                match is_lost && chance.is_multiple_of(16) {
                    true => Err(Error::Interrupted),
                    false => Ok(()),
                }
            });
            match saved {
                Err(error) if error != Error::Interrupted => return Err(error),
                _ => {}
            }
            if is_lost {
                losses = losses.wrapping_add(1);
                break;
            }
        }
    }
}
