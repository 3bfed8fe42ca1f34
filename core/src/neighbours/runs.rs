//! Runs: contiguous stretches of the sorted order that can hold partners of a receiver.

#[cfg(feature = "heapless")]
use heapless::Vec as List;

use super::cells::Cells;
#[cfg(not(feature = "heapless"))]
use super::few::Few as List;
use super::grid::Grid;
use super::image::{Image, code};
use crate::numbered::numbered;
use crate::scalar::Scalar;

/// Sorted particles `start..end`, seen as `image`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run<const D: usize> {
    /// The first of them in sorted order.
    pub start: u32,
    /// One beyond the last.
    pub end: u32,
    /// How they are seen.
    pub image: Image<D>,
}

impl<const D: usize> Default for Run<D> {
    /// One without particles.
    fn default() -> Self {
        Self {
            start: 0,
            end: 0,
            image: Image::SELF,
        }
    }
}

/// Cells `first..=last` of one direction with one code.
#[derive(Clone, Copy, Default)]
struct Segment {
    first: u32,
    last: u32,
    code: u8,
}

/// 3 cells across each of two slow directions, times 3 segments of the fast one.
const MAX_RUNS: usize = 27;

/// The runs of one receiver, or of several in one row, in the order of summation.
pub type Runs<const D: usize> = List<Run<D>, MAX_RUNS>;

type Segments = List<Segment, 3>;

/// Real and periodic partners of cells `low..=high` of one direction, in ascending order.
fn segments<S: Scalar, const D: usize>(
    grid: &Grid<S, D>,
    axis: usize,
    [low, high]: [u32; 2],
) -> Segments {
    let (count, window, last) = (grid.count(axis), grid.window(axis), grid.last(axis));
    let mut segments = Segments::new();
    let mut push = |first: u32, last: u32, code| {
        // At most three are pushed: there is room.
        let _ = segments.push(Segment { first, last, code });
    };
    let beyond = high.saturating_add(window);
    if grid.is_periodic(axis) && beyond >= count {
        // No farther than the last cell, also of receivers beyond it.
        push(0, (beyond - count).min(last), code::LOW);
    }
    push(low.saturating_sub(window), beyond.min(last), code::DIRECT);
    if grid.is_periodic(axis) && low < window {
        push(count.wrapping_sub(window - low), last, code::HIGH);
    }
    segments
}

/// Partners of cell `c` of one direction in the mirror behind one of its ends; none where
/// there is no wall, or none in reach.
fn mirrored<S: Scalar, const D: usize>(
    grid: &Grid<S, D>,
    axis: usize,
    c: u32,
    end: usize,
) -> Segments {
    let (window, last) = (grid.window(axis), grid.last(axis));
    let mut segments = Segments::new();
    let from_wall = if end == 0 { c } else { last.wrapping_sub(c) };
    if grid.is_wall(axis, end) && from_wall <= window {
        let depth = (window - from_wall).min(last);
        let segment = if end == 0 {
            Segment {
                first: 0,
                last: depth,
                code: code::LOWER_WALL,
            }
        } else {
            Segment {
                first: last - depth,
                last,
                code: code::UPPER_WALL,
            }
        };
        let _ = segments.push(segment);
    }
    segments
}

impl<S: Scalar, const D: usize> Cells<'_, S, D> {
    /// Real and periodic partners of receivers in cells `cell` to `last` of one row, `last`
    /// being the coordinate along the row.
    #[inline]
    pub fn runs(&self, cell: &[u32; D], last: u32) -> Runs<D> {
        let grid = self.grid();
        let mut choices = core::array::from_fn::<_, D, _>(|_| Segments::new());
        for (i, (choice, &c)) in numbered(choices.iter_mut().zip(cell)) {
            let high = if i + 1 == D { last } else { c };
            *choice = segments(grid, i, [c, high]);
        }
        self.combine(&choices)
    }

    /// Partners of a receiver in `cell` in the mirrors `mirror`: for each direction 0 for
    /// none, 1 for the lower and 2 for the upper wall.
    pub fn mirror_runs(&self, cell: &[u32; D], mirror: &[u8; D]) -> Runs<D> {
        let grid = self.grid();
        let mut choices = core::array::from_fn::<_, D, _>(|_| Segments::new());
        for (i, ((choice, &c), &mirror)) in numbered(choices.iter_mut().zip(cell).zip(mirror)) {
            *choice = match mirror {
                0 => segments(grid, i, [c, c]),
                wall => mirrored(grid, i, c, usize::from(wall) - 1),
            };
        }
        self.combine(&choices)
    }

    /// Runs of all combinations of segments: slow directions cell by cell, the fast one
    /// whole.
    fn combine(&self, choices: &[Segments; D]) -> Runs<D> {
        const { assert!(D > 0, "a grid has a direction at the least") }
        let mut runs = Runs::new();
        if choices.iter().any(|choice| choice.is_empty()) {
            return runs;
        }
        // An odometer over (segment, cell) of each slow direction.
        let mut place = [(0, 0); D];
        loop {
            let mut cell = [0; D];
            let mut image = Image::SELF;
            for i in 0..D {
                let Some(segment) = choices[i].get(place[i].0) else {
                    return runs;
                };
                cell[i] = segment.first.wrapping_add(place[i].1);
                image.0[i] = segment.code;
            }
            // The number of a cell is below that of all cells: nothing wraps.
            let row = self.grid().index(&cell).wrapping_sub(cell[D - 1]);
            for segment in &choices[D - 1] {
                image.0[D - 1] = segment.code;
                let (start, end) = self.span(
                    row.wrapping_add(segment.first),
                    row.wrapping_add(segment.last),
                );
                if start < end {
                    let _ = runs.push(Run { start, end, image });
                }
            }
            let mut axis = D - 1;
            loop {
                if axis == 0 {
                    return runs;
                }
                axis -= 1;
                let (segment, offset) = &mut place[axis];
                if let Some(s) = choices[axis].get(*segment) {
                    // At most the last cell: a segment that begins beyond it ends here.
                    *offset += 1;
                    if s.first.saturating_add(*offset) <= s.last {
                        break;
                    }
                    (*segment, *offset) = (*segment + 1, 0);
                    if *segment < choices[axis].len() {
                        break;
                    }
                }
                place[axis] = (0, 0);
            }
        }
    }
}
