//! Sums without the rounding of their length.

use motes_core::cloud::Words;
use motes_core::error::Error;

/// A sum to about the last place of the result, however many terms there are (Neumaier, Z. Angew.
/// Math. Mech. 54, 39, 1974).
///
/// Of what is conserved to round-off only the drift is to be seen, and a mean mass is the mass
/// where all are equal.
#[derive(Clone, Copy, Debug, Default)]
pub struct Compensated {
    sum: f64,
    lost: f64,
}

impl Compensated {
    /// Adds a term.
    pub fn add(&mut self, value: f64) {
        let next = self.sum + value;
        self.lost += if self.sum.abs() >= value.abs() {
            (self.sum - next) + value
        } else {
            (value - next) + self.sum
        };
        self.sum = next;
    }

    /// Passes it.
    ///
    /// # Errors
    /// Those of [`Words`].
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        words.scalar(&mut self.sum)?;
        words.scalar(&mut self.lost)
    }

    /// The sum.
    pub fn value(&self) -> f64 {
        self.sum + self.lost
    }
}

/// The [`Compensated`] sum of these values.
pub fn compensated(values: impl Iterator<Item = f64>) -> f64 {
    let mut sum = Compensated::default();
    values.for_each(|value| sum.add(value));
    sum.value()
}

#[cfg(test)]
mod tests {
    use super::compensated;

    #[test]
    fn what_a_plain_sum_loses_is_kept() {
        assert_eq!(compensated([1.0, 1e100, 1.0, -1e100].into_iter()), 2.0);
        let tenths = || std::iter::repeat_n(0.1, 1_000_000);
        assert_eq!(compensated(tenths()), 100_000.0);
        assert_ne!(tenths().sum::<f64>(), 100_000.0);
    }
}
