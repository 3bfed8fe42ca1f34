//! Items and their numbers.

/// As `enumerate`, for which a compiler that checks overflow must keep a panic.
#[inline(always)]
pub(crate) fn numbered<I: IntoIterator>(items: I) -> impl Iterator<Item = (usize, I::Item)> {
    (0..usize::MAX).zip(items)
}
