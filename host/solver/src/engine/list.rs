//! A neighbour list that grows.

use motes_core::pairs::List;

/// Candidates of a range of receivers, in memory that grows as needed.
#[derive(Debug, Default)]
pub struct GrowingList {
    words: Vec<u32>,
    used: usize,
}

impl GrowingList {
    /// Forgets the candidates, keeps the memory.
    pub fn clear(&mut self) {
        self.used = 0;
    }
}

impl List for GrowingList {
    #[inline]
    fn room(&mut self, words: usize) -> Option<&mut [u32]> {
        let needed = self.used.checked_add(words)?;
        if self.words.len() < needed {
            self.words.try_reserve(needed - self.words.len()).ok()?;
            let all = needed.max(self.words.capacity());
            self.words.resize(all, 0);
        }
        self.words.get_mut(self.used..)
    }

    #[inline]
    fn commit(&mut self, words: usize) {
        self.used += words;
    }

    #[inline]
    fn words(&self, start: usize) -> &[u32] {
        self.words.get(start..self.used).unwrap_or(&[])
    }
}
