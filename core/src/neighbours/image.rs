//! Images: how particles are seen through the sides of a domain.

use crate::numbered::numbered;

/// How a run is seen along one direction.
pub mod code {
    /// Not an image.
    pub const DIRECT: u8 = 0;
    /// Cells at the low end, seen beyond the high end of a periodic direction.
    pub const LOW: u8 = 1;
    /// Cells at the high end, seen beyond the low end of a periodic direction.
    pub const HIGH: u8 = 2;
    /// The mirror image in the lower wall.
    pub const LOWER_WALL: u8 = 3;
    /// The mirror image in the upper wall.
    pub const UPPER_WALL: u8 = 4;
}

/// How a run is seen: a [`code`] for each direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Image<const D: usize>(pub [u8; D]);

impl<const D: usize> Image<D> {
    /// The particles themselves.
    pub const SELF: Self = Self([code::DIRECT; D]);

    /// All codes in one word.
    pub fn packed(self) -> u32 {
        self.0
            .iter()
            .fold(0, |word, &code| word << 3 | u32::from(code))
    }

    /// The image of that word.
    pub fn unpacked(word: u32) -> Self {
        let mut codes = [0; D];
        for (i, code) in numbered(codes.iter_mut().rev()) {
            *code = (word >> (3 * i) & 7) as u8;
        }
        Self(codes)
    }
}
