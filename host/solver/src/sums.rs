//! Sums without the rounding of their length.

/// The sum of these values to about the last place of the result, however many they are
/// (Neumaier, Z. Angew. Math. Mech. 54, 39, 1974).
///
/// Of what is conserved to round-off only the drift is to be seen, and a mean mass is the mass
/// where all are equal.
pub fn compensated(values: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut lost) = (0.0f64, 0.0);
    for value in values {
        let next = sum + value;
        lost += if sum.abs() >= value.abs() {
            (sum - next) + value
        } else {
            (value - next) + sum
        };
        sum = next;
    }
    sum + lost
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
