//! A state as words: out of a run into memory that outlives it, and back.
//!
//! What writes and what reads is one function, so that they cannot differ: it names every number once,
//! and a [`Words`] takes the number out or puts another in its place.

use super::column::{ColumnMut, Columns};
use crate::error::Error;
use crate::numbered::numbered;
use crate::scalar::Scalar;

/// Takes numbers out of a state, or puts numbers into it, one after the other.
///
/// The bytes of a number are its bit pattern, least significant first, on every machine.
pub trait Words {
    /// Takes the bytes of a word, or fills them in.
    ///
    /// Errors: [`Error::Truncated`] where the words end before, or where no more have room; what a
    /// memory says of itself.
    fn word(&mut self, bytes: &mut [u8]) -> Result<(), Error>;

    /// Whether numbers are put into the state, and not taken out of it.
    fn fills(&self) -> bool;
}

/// Takes numbers out of a state: a function receives the bytes of each.
#[derive(Clone, Copy, Debug)]
pub struct Save<F>(pub F);

impl<F: FnMut(&[u8]) -> Result<(), Error>> Words for Save<F> {
    fn word(&mut self, bytes: &mut [u8]) -> Result<(), Error> {
        (self.0)(bytes)
    }
    fn fills(&self) -> bool {
        false
    }
}

/// Puts numbers into a state: a function fills in the bytes of each.
#[derive(Clone, Copy, Debug)]
pub struct Load<F>(pub F);

impl<F: FnMut(&mut [u8]) -> Result<(), Error>> Words for Load<F> {
    fn word(&mut self, bytes: &mut [u8]) -> Result<(), Error> {
        (self.0)(bytes)
    }
    fn fills(&self) -> bool {
        true
    }
}

/// Words in memory that have not been read yet.
#[derive(Clone, Copy, Debug)]
pub struct Remaining<'a>(pub &'a [u8]);

impl Words for Remaining<'_> {
    fn word(&mut self, bytes: &mut [u8]) -> Result<(), Error> {
        let split = self.0.split_at_checked(bytes.len());
        let (first, rest) = split.ok_or(Error::Truncated)?;
        bytes.copy_from_slice(first);
        self.0 = rest;
        Ok(())
    }
    fn fills(&self) -> bool {
        true
    }
}

impl dyn Words + '_ {
    /// Passes a scalar: [`Scalar::BYTES`] bytes.
    pub fn scalar<S: Scalar>(&mut self, value: &mut S) -> Result<(), Error> {
        let mut bytes = value.bits().to_le_bytes();
        if let Some(bytes) = bytes.get_mut(..S::BYTES) {
            self.word(bytes)?;
        }
        if self.fills() {
            *value = S::from_bits(u64::from_le_bytes(bytes));
        }
        Ok(())
    }

    /// Passes scalars, one after the other.
    pub fn scalars<S: Scalar>(&mut self, values: &mut [S]) -> Result<(), Error> {
        values.iter_mut().try_for_each(|value| self.scalar(value))
    }

    /// Passes a sum of products: twice as many bytes as a scalar has.
    pub fn wide<S: Scalar>(&mut self, value: &mut S::Wide) -> Result<(), Error> {
        let mut bytes = S::wide_bits(*value).to_le_bytes();
        if let Some(bytes) = bytes.get_mut(..2 * S::BYTES) {
            self.word(bytes)?;
        }
        if self.fills() {
            *value = S::from_wide_bits(u128::from_le_bytes(bytes));
        }
        Ok(())
    }

    /// Passes a whole number: eight bytes.
    pub fn count(&mut self, value: &mut u64) -> Result<(), Error> {
        let mut bytes = value.to_le_bytes();
        self.word(&mut bytes)?;
        *value = u64::from_le_bytes(bytes);
        Ok(())
    }

    /// Passes a number that must be the same on both sides.
    ///
    /// Error: [`Error::Lengths`] where another one is read.
    pub fn same(&mut self, value: u64) -> Result<(), Error> {
        let mut read = value;
        self.count(&mut read)?;
        if read == value {
            Ok(())
        } else {
            Err(Error::Lengths)
        }
    }

    /// Passes all fields of a state, in order: how many numbers a field has, then the numbers.
    ///
    /// Errors: those of [`Words::word`], and [`Error::Lengths`] where the state that is read has another
    /// number of particles.
    pub fn columns<S: Scalar>(&mut self, state: &mut dyn Columns<S>) -> Result<(), Error> {
        for (place, _) in numbered(state.fields()) {
            let Some(column) = state.column_mut(place) else {
                return Err(Error::Lengths);
            };
            match column {
                ColumnMut::Scalars(values) => {
                    self.same(values.len() as u64)?;
                    self.scalars(values)?;
                }
                ColumnMut::Strengths(values) => {
                    self.same(values.len() as u64)?;
                    values
                        .iter_mut()
                        .try_for_each(|value| self.wide::<S>(value))?;
                }
                ColumnMut::Integers(values) => {
                    self.same(values.len() as u64)?;
                    self.word(values)?;
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Checked, Q32, Q64};
    use fixed::types::extra::{U16, U19, U32};

    /// A number of each kind, through memory and back.
    fn passed<S: Scalar>(value: S, wide: S::Wide) -> (S, S::Wide, u64) {
        let mut memory = [0u8; 64];
        let mut used = 0;
        let mut put = Save(|bytes: &[u8]| {
            let room = memory.get_mut(used..used + bytes.len());
            room.ok_or(Error::Truncated)?.copy_from_slice(bytes);
            used += bytes.len();
            Ok(())
        });
        let words: &mut dyn Words = &mut put;
        let (mut v, mut w, mut n) = (value, wide, 1 << 40);
        words.scalar(&mut v).unwrap();
        words.wide::<S>(&mut w).unwrap();
        words.count(&mut n).unwrap();
        assert_eq!(used, 3 * S::BYTES + 8);
        let mut take = Remaining(memory.get(..used).unwrap());
        let words: &mut dyn Words = &mut take;
        let (mut v, mut w, mut n) = (S::ZERO, S::NOTHING, 0);
        words.scalar(&mut v).unwrap();
        words.wide::<S>(&mut w).unwrap();
        words.count(&mut n).unwrap();
        assert_eq!(words.count(&mut 0), Err(Error::Truncated));
        (v, w, n)
    }

    fn keeps_every_bit<S: Scalar>(value: f64) {
        let value = S::from_f64(value);
        let wide = S::product(value, S::from_f64(-1.7));
        let (v, w, n) = passed(value, wide);
        assert_eq!(v.bits(), value.bits());
        assert_eq!(S::wide_bits(w), S::wide_bits(wide));
        assert_eq!(n, 1 << 40);
    }

    #[test]
    fn a_number_that_is_written_is_read_with_every_bit_in_every_scalar() {
        for value in [0.1, -0.0, -3.7, 1.0 / 3.0, -100.0] {
            keeps_every_bit::<f64>(value);
            keeps_every_bit::<f32>(value);
            keeps_every_bit::<Q32<U19>>(value);
            keeps_every_bit::<Q32<U16>>(value);
            keeps_every_bit::<Q64<U32>>(value);
            keeps_every_bit::<Checked<Q32<U19>>>(value);
        }
        // What is no number keeps its pattern, too.
        keeps_every_bit::<f64>(f64::NAN);
    }

    #[test]
    fn another_length_is_refused() {
        let mut take = Load(|bytes: &mut [u8]| {
            bytes.fill(3);
            Ok(())
        });
        let words: &mut dyn Words = &mut take;
        assert_eq!(words.same(3), Err(Error::Lengths));
        assert_eq!(words.same(0x0303_0303_0303_0303), Ok(()));
    }
}
