//! Memory that keeps a run over a reset.

use super::words::{Remaining, Save, Words};
use crate::digest::Digester;
use crate::error::Error;

/// Memory for the words of a run, of at most `B` bytes, sealed once they are whole.
///
/// Take two and write to the older: whenever power is lost, one is whole. They lie where a reset leaves
/// them, or are written to flash after [`Slot::save`] and read from it before [`Slot::load`].
///
/// ```
/// # use motes_core::{cloud::{Slot, Words}, error::Error};
/// let mut slots = [Slot::<64>::new(), Slot::new()];
/// let mut temperature = 20.5f32;
/// Slot::older(&mut slots).save(7, |words| words.scalar(&mut temperature))?;
/// temperature = 0.0;
/// if let Some(slot) = Slot::newer(&slots) {
///     slot.load(|words| words.scalar(&mut temperature))?;
/// }
/// assert_eq!(temperature, 20.5);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Slot<const B: usize> {
    seal: u64,
    number: u64,
    length: u64,
    words: [u8; B],
}

impl<const B: usize> Default for Slot<B> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const B: usize> Slot<B> {
    /// Nothing, not sealed.
    pub const fn new() -> Self {
        Self {
            seal: 0,
            number: 0,
            length: 0,
            words: [0; B],
        }
    }

    /// Saves what `pass` passes, under a number that grows from one time to the next, such as that of steps.
    ///
    /// Errors: [`Error::Truncated`] where there is no room, and those of `pass`. The slot holds nothing
    /// then.
    pub fn save(
        &mut self,
        number: u64,
        pass: impl FnOnce(&mut dyn Words) -> Result<(), Error>,
    ) -> Result<(), Error> {
        // Before anything else: what is half written has no seal.
        self.seal = 0;
        self.number = number;
        self.length = 0;
        let Self { length, words, .. } = self;
        pass(&mut Save(|bytes: &[u8]| {
            let start = *length as usize;
            let end = start.checked_add(bytes.len()).ok_or(Error::Truncated)?;
            let room = words.get_mut(start..end).ok_or(Error::Truncated)?;
            room.copy_from_slice(bytes);
            *length = end as u64;
            Ok(())
        }))?;
        self.seal = self.digest().ok_or(Error::Truncated)?;
        Ok(())
    }

    /// Loads what was saved; `pass` passes it.
    ///
    /// Errors: [`Error::Truncated`] where the slot is not whole, or holds fewer words; those of `pass`.
    pub fn load(
        &self,
        pass: impl FnOnce(&mut dyn Words) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.number().ok_or(Error::Truncated)?;
        let held = self.held().ok_or(Error::Truncated)?;
        pass(&mut Remaining(held))
    }

    /// The number that it was saved under; `None` where it is not whole.
    pub fn number(&self) -> Option<u64> {
        (self.digest() == Some(self.seal)).then_some(self.number)
    }

    /// The one of two to write to: one that is not whole, or that with the smaller number.
    pub fn older(slots: &mut [Self; 2]) -> &mut Self {
        let [first, second] = slots;
        // One that is not whole comes before every number.
        if first.number() <= second.number() {
            first
        } else {
            second
        }
    }

    /// The one of two to go on from; `None` where neither is whole.
    pub fn newer(slots: &[Self; 2]) -> Option<&Self> {
        let [first, second] = slots;
        let newer = if first.number() > second.number() {
            first
        } else {
            second
        };
        newer.number().map(|_| newer)
    }

    fn held(&self) -> Option<&[u8]> {
        self.words.get(..usize::try_from(self.length).ok()?)
    }

    /// Of the words, their number and their length; never 0, which is no seal.
    fn digest(&self) -> Option<u64> {
        let mut digester = Digester::new();
        digester.integers(&self.number.to_le_bytes());
        digester.integers(&self.length.to_le_bytes());
        digester.integers(self.held()?);
        Some(digester.digest().0 | 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Slots = [Slot<32>; 2];

    fn keep(slots: &mut Slots, number: u64) {
        let mut value = number as f64;
        let saved = Slot::older(slots).save(number, |words| words.scalar(&mut value));
        assert_eq!(saved, Ok(()));
    }

    fn kept(slots: &Slots) -> Option<f64> {
        let mut value = 0.0;
        let slot = Slot::newer(slots)?;
        assert_eq!(slot.load(|words| words.scalar(&mut value)), Ok(()));
        Some(value)
    }

    #[test]
    fn one_of_two_is_whole_whenever_power_is_lost() {
        let mut slots = Slots::default();
        assert_eq!(kept(&slots), None);
        for number in 1..20u64 {
            keep(&mut slots, number);
            assert_eq!(kept(&slots), Some(number as f64));
            // Power is lost before the second word, and then before the seal.
            for lost in [1, 2] {
                let mut words = 0;
                let mut cut = slots;
                let failed = Slot::older(&mut cut).save(number + 1, |out| {
                    while words < lost {
                        out.count(&mut words)?;
                        words += 1;
                    }
                    Err(Error::Interrupted)
                });
                assert_eq!(failed, Err(Error::Interrupted));
                assert_eq!(kept(&cut), Some(number as f64));
            }
        }
    }

    #[test]
    fn a_bit_that_flips_is_seen_and_the_other_slot_is_taken() {
        let mut slots = Slots::default();
        keep(&mut slots, 1);
        keep(&mut slots, 2);
        for byte in 0..8 {
            for bit in 0..8 {
                let mut flipped = slots;
                let word = flipped.get_mut(1).and_then(|slot| slot.words.get_mut(byte));
                *word.unwrap() ^= 1 << bit;
                assert_eq!(kept(&flipped), Some(1.0));
            }
        }
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let mut slot = Slot::<12>::new();
        let saved = slot.save(1, |words| words.scalars(&mut [1.0, 2.0]));
        assert_eq!((saved, slot.number()), (Err(Error::Truncated), None));
        assert_eq!(slot.load(|_| Ok(())), Err(Error::Truncated));
    }
}
