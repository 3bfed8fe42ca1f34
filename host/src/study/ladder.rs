//! How many particles each level has.

/// The coarsest level of a study that ends with `finest` particles: the spacing halves from level to
/// level. At least 16 particles in one dimension, 64 in two, 256 in three.
pub fn coarsest(finest: usize, levels: u32, dimension: u32) -> usize {
    let halvings = dimension.saturating_mul(levels.saturating_sub(1));
    let least = 4usize.pow(dimension + 1);
    finest.checked_shr(halvings).unwrap_or(0).max(least)
}

/// `coarsest` particles, then `2^dimension` times as many at each level; `None` where there
/// would be too many to count.
pub fn ladder(coarsest: usize, levels: u32, dimension: u32) -> Option<Vec<usize>> {
    let factor = 2usize.checked_pow(dimension)?;
    let count = |level: u32| coarsest.checked_mul(factor.checked_pow(level)?);
    (0..levels).map(count).collect()
}
