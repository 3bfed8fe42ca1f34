//! Images: how particles are seen through the sides of a domain.

use crate::domain::Wall;
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
    /// Bits of a code; ten of them fit into a word.
    const BITS: u32 = 3;
    /// A word holds the codes of all directions: of more there is no [`Image::packed`].
    const FITS: () = assert!(
        D <= (u32::BITS / Self::BITS) as usize,
        "the codes of so many directions do not fit into a word"
    );

    /// The particles themselves.
    pub const SELF: Self = Self([code::DIRECT; D]);

    /// The walls that it is seen in: the direction and the end of each, 0 for the lower one.
    #[inline(always)]
    pub fn ends(&self) -> impl Iterator<Item = (usize, usize)> {
        numbered(&self.0).filter_map(|(axis, &seen)| match seen {
            code::LOWER_WALL => Some((axis, 0)),
            code::UPPER_WALL => Some((axis, 1)),
            _ => None,
        })
    }

    /// The same, of walls at these positions.
    #[inline(always)]
    pub(crate) fn walls<S: Copy>(
        &self,
        positions: &[[Option<S>; 2]; D],
    ) -> impl Iterator<Item = Wall<S>> {
        self.ends().filter_map(|(axis, end)| {
            let position = (*positions.get(axis)?.get(end)?)?;
            Some(Wall {
                axis,
                end,
                position,
            })
        })
    }

    /// All codes in one word.
    pub fn packed(self) -> u32 {
        let () = Self::FITS;
        self.0
            .iter()
            .fold(0, |word, &code| word << Self::BITS | u32::from(code))
    }

    /// The image of that word.
    pub fn unpacked(word: u32) -> Self {
        let () = Self::FITS;
        let (mut codes, mut rest) = ([0; D], word);
        for code in codes.iter_mut().rev() {
            (*code, rest) = ((rest & 7) as u8, rest >> Self::BITS);
        }
        Self(codes)
    }
}
