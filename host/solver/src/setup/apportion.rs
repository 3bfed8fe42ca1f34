//! Particles shared out over the regions of one dimension.

use super::SetupError;

/// Shares `particles` out in proportion to the parts, the largest remainders first, so that
/// their sum is exact.
///
/// # Errors
/// A part that would get none, by its number.
pub fn apportion(parts: &[f64], particles: usize) -> Result<Vec<u32>, SetupError> {
    let total: f64 = parts.iter().sum();
    let shares: Vec<f64> = parts
        .iter()
        .map(|part| part / total * particles as f64)
        .collect();
    // A share a rounding below a whole number is that number.
    let mut counts: Vec<u32> = shares
        .iter()
        .map(|share| (share + 1e-9).floor() as u32)
        .collect();
    let mut order: Vec<usize> = (0..parts.len()).collect();
    let remainder = |i: usize| shares[i] - f64::from(counts[i]);
    order.sort_by(|&a, &b| remainder(b).total_cmp(&remainder(a)));
    let missing = particles.saturating_sub(counts.iter().map(|&count| count as usize).sum());
    for &region in order.iter().cycle().take(missing) {
        counts[region] += 1;
    }
    match counts.iter().position(|&count| count == 0) {
        Some(region) => Err(SetupError::EmptyRegion {
            region,
            share: shares[region],
        }),
        None => Ok(counts),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn particles_are_shared_out_by_mass_and_none_is_lost() {
        assert_eq!(apportion(&[1.0, 0.125], 900).unwrap(), [800, 100]);
        assert_eq!(apportion(&[1.0, 0.125], 225).unwrap(), [200, 25]);
        assert_eq!(
            apportion(&[1.0, 1.0, 1.0], 100)
                .unwrap()
                .iter()
                .sum::<u32>(),
            100
        );
        assert!(matches!(
            apportion(&[1.0, 1e-6], 100),
            Err(SetupError::EmptyRegion { region: 1, .. })
        ));
    }
}
