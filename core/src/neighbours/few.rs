//! A list with a bound that is known when it is compiled: what `heapless` has, without that crate.

use core::ops::Deref;

/// At most `N` of something, in the order in which they came.
///
/// All of its room is written when it is made, which `heapless` saves: 6 % of a step of acoustics in
/// f32 on a Cortex-M4F.
#[derive(Clone, Copy, Debug)]
pub struct Few<T, const N: usize> {
    items: [T; N],
    length: usize,
}

impl<T: Copy + Default, const N: usize> Few<T, N> {
    /// None of them yet.
    #[inline(always)]
    pub fn new() -> Self {
        Self {
            items: [T::default(); N],
            length: 0,
        }
    }

    /// Adds one, or hands it back where there is no room.
    #[inline(always)]
    pub fn push(&mut self, item: T) -> Result<(), T> {
        let Some(place) = self.items.get_mut(self.length) else {
            return Err(item);
        };
        *place = item;
        self.length += 1;
        Ok(())
    }
}

impl<T: Copy + Default, const N: usize> Default for Few<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T, const N: usize> Deref for Few<T, N> {
    type Target = [T];

    #[inline(always)]
    fn deref(&self) -> &[T] {
        self.items.get(..self.length).unwrap_or(&[])
    }
}

impl<'a, T, const N: usize> IntoIterator for &'a Few<T, N> {
    type Item = &'a T;
    type IntoIter = core::slice::Iter<'a, T>;

    #[inline(always)]
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::Few;

    #[test]
    fn it_does_what_the_list_of_heapless_does() {
        let mut few = Few::<u8, 3>::new();
        let mut theirs = heapless::Vec::<u8, 3>::new();
        for item in 5..9 {
            assert_eq!(few.push(item), theirs.push(item));
            assert_eq!(&*few, &*theirs);
        }
        assert!(few.iter().eq(&theirs));
    }
}
