//! Random numbers with the same bits everywhere.

/// SplitMix64 (Steele, Lea & Flood, OOPSLA 2014): a counter, mixed. Integers only.
pub(super) struct Random {
    state: u64,
}

impl Random {
    /// A sequence that the seed determines.
    pub(super) fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// The next 64 bits.
    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// The next number in [-1, 1): a multiple of 2^-52, so the conversion is exact.
    pub(super) fn signed(&mut self) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1u64 << 53) as f64;
        2.0 * unit - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sequence_is_that_of_the_reference_implementation() {
        // The first three of seed 1234567, as in Vigna's splitmix64.c.
        let mut random = Random::new(1_234_567);
        let three = [random.bits(), random.bits(), random.bits()];
        assert_eq!(
            three,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423
            ]
        );
    }

    #[test]
    fn signed_numbers_fill_their_interval_evenly() {
        let mut random = Random::new(1);
        let n = 100_000;
        let numbers: Vec<f64> = (0..n).map(|_| random.signed()).collect();
        assert!(numbers.iter().all(|x| (-1.0..1.0).contains(x)));
        // Mean 0 and variance 1/3, each within five standard errors.
        let mean = numbers.iter().sum::<f64>() / f64::from(n);
        let square = numbers.iter().map(|x| x * x).sum::<f64>() / f64::from(n);
        assert!(
            mean.abs() < 5.0 * (1.0 / 3.0 / f64::from(n)).sqrt(),
            "{mean}"
        );
        assert!(
            (square - 1.0 / 3.0).abs() < 5.0 * (4.0 / 45.0 / f64::from(n)).sqrt(),
            "{square}"
        );
    }
}
