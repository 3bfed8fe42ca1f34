//! Particles sorted into cells.

use super::Grid;
use crate::domain::Domain;
use crate::error::{Container, Error};
use crate::scalar::Scalar;

/// What the search for partners needs to know of a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site<S, const D: usize> {
    /// Its position.
    pub position: [S; D],
    /// The square of the distance up to which it acts on others and they on it.
    pub reach_squared: S,
}

impl<S: Scalar, const D: usize> Site<S, D> {
    /// A site that nothing has been written to.
    pub const EMPTY: Self = Self {
        position: [S::ZERO; D],
        reach_squared: S::ZERO,
    };
}

/// Memory for sorting, lent by the caller. All but `starts` hold as many as there are
/// particles, `starts` holds [`super::cell_bound`] + 1.
pub struct CellBuffers<'a, S, const D: usize> {
    /// Sites in sorted order.
    pub sites: &'a mut [Site<S, D>],
    /// Ids in sorted order.
    pub order: &'a mut [u32],
    /// The cell of each id, while sorting.
    pub cell_of: &'a mut [u32],
    /// For each cell the place of its first particle in sorted order.
    pub starts: &'a mut [u32],
}

impl<S: Scalar, const D: usize> CellBuffers<'_, S, D> {
    /// The cloud of `particles` that [`sort`] left here with this geometry.
    pub fn cells(&self, grid: Grid<S, D>, particles: usize) -> Cells<'_, S, D> {
        Cells {
            grid,
            sites: self.sites.get(..particles).unwrap_or(&[]),
            order: self.order.get(..particles).unwrap_or(&[]),
            starts: self.starts,
        }
    }
}

/// A cloud in sorted order.
#[derive(Clone, Copy)]
pub struct Cells<'a, S, const D: usize> {
    grid: Grid<S, D>,
    sites: &'a [Site<S, D>],
    order: &'a [u32],
    starts: &'a [u32],
}

/// Sorts a cloud into cells by a stable counting sort and returns their geometry;
/// [`CellBuffers::cells`] then shows the result.
///
/// `reach_of(id)`: the distance up to which the particle has partners. Errors: those of
/// [`Grid::fit`], and buffers that are too small.
// Told the reach through a pointer: compiled once, whatever the equation.
pub fn sort<S: Scalar, const D: usize>(
    domain: &Domain<S, D>,
    positions: &[[S; D]],
    reach_of: &dyn Fn(usize) -> S,
    buffers: &mut CellBuffers<'_, S, D>,
) -> Result<Grid<S, D>, Error> {
    let n = positions.len();
    let reach = (0..n)
        .map(reach_of)
        .reduce(Scalar::greater)
        .unwrap_or(S::ONE);
    let grid = Grid::fit(domain, positions, reach)?;
    let room = buffers
        .sites
        .len()
        .min(buffers.order.len())
        .min(buffers.cell_of.len());
    let sites = buffers.sites.get_mut(..n);
    let (Some(sites), Some(order), Some(cell_of)) = (
        sites,
        buffers.order.get_mut(..n),
        buffers.cell_of.get_mut(..n),
    ) else {
        return Err(full(Container::Particles, n as u64, room));
    };
    let cells = grid.cells();
    let room = buffers.starts.len();
    let Some(starts) = buffers.starts.get_mut(..=cells as usize) else {
        return Err(full(Container::Cells, cells + 1, room));
    };

    // Count, sum up, place: `starts[c]` ends as the place of the first particle of cell c.
    starts.fill(0);
    for (cell, position) in cell_of.iter_mut().zip(positions) {
        *cell = grid.index(&grid.coordinates(position));
        if let Some(count) = starts.get_mut(*cell as usize) {
            *count = count.wrapping_add(1);
        }
    }
    let mut total = 0;
    for start in starts.iter_mut() {
        total = start.wrapping_add(total);
        *start = total;
    }
    // From the last id to the first, each cell filled from its end: stable.
    let rows = cell_of.iter().zip(positions).rev();
    for (id, (&cell, &position)) in (0..n).rev().zip(rows) {
        let Some(start) = starts.get_mut(cell as usize) else {
            continue;
        };
        *start = start.wrapping_sub(1);
        let place = *start as usize;
        let reach = reach_of(id);
        if let (Some(site), Some(slot)) = (sites.get_mut(place), order.get_mut(place)) {
            *site = Site {
                position,
                reach_squared: reach * reach,
            };
            *slot = id as u32;
        }
    }
    Ok(grid)
}

fn full(container: Container, needed: u64, capacity: usize) -> Error {
    Error::Capacity {
        container,
        needed: u32::try_from(needed).unwrap_or(u32::MAX),
        capacity: capacity as u32,
    }
}

impl<'a, S: Scalar, const D: usize> Cells<'a, S, D> {
    /// The geometry.
    #[inline]
    pub fn grid(&self) -> &Grid<S, D> {
        &self.grid
    }

    /// Sites in sorted order.
    #[inline]
    pub fn sites(&self) -> &'a [Site<S, D>] {
        self.sites
    }

    /// Ids in sorted order.
    #[inline]
    pub fn order(&self) -> &'a [u32] {
        self.order
    }

    /// Sorted particles in cells `first..=last`.
    #[inline]
    pub fn span(&self, first: u32, last: u32) -> (u32, u32) {
        let start = |cell: u32| self.starts.get(cell as usize).copied();
        match (start(first), start(last.wrapping_add(1))) {
            (Some(start), Some(end)) => (start, end),
            _ => (0, 0),
        }
    }

    /// The cell of the particle at a place of the sorted order.
    #[inline]
    pub fn cell(&self, place: usize) -> [u32; D] {
        self.sites
            .get(place)
            .map_or([0; D], |site| self.grid.coordinates(&site.position))
    }

    /// No receiver has more partners: the most candidates in cells within reach along the last
    /// direction, images among them, times the rows within reach across it.
    pub fn most_partners(&self) -> u64 {
        let grid = &self.grid;
        let along = D.saturating_sub(1);
        let (count, window, last) = (grid.count(along), grid.window(along), grid.last(along));
        let walls = [0, 1].map(|end| grid.is_wall(along, end));
        let is_periodic = grid.is_periodic(along);
        let mut most = 0u64;
        let rows = grid.cells() / u64::from(count.max(1));
        for row in 0..rows {
            let base = (row as u32).wrapping_mul(count);
            let within = |first: u32, last: u32| {
                let (start, end) = self.span(base.wrapping_add(first), base.wrapping_add(last));
                u64::from(end.saturating_sub(start))
            };
            for c in 0..count {
                let (below, beyond) = (window.saturating_sub(c), c.saturating_add(window));
                let above = beyond.saturating_sub(last);
                let mut partners = within(c.saturating_sub(window), beyond.min(last));
                if is_periodic && below > 0 {
                    partners += within(count.saturating_sub(below), last);
                }
                if is_periodic && above > 0 {
                    partners += within(0, above.saturating_sub(1));
                }
                if walls[0] && c <= window {
                    partners += within(0, below.min(last));
                }
                if walls[1] && beyond >= last {
                    partners += within(last.saturating_sub(above), last);
                }
                most = most.max(partners);
            }
        }
        for axis in 0..along {
            // Three rows; at a wall two, and as many images; between two walls three times two.
            let walls = [0, 1].map(|end| grid.is_wall(axis, end));
            most = most.saturating_mul(match walls {
                [false, false] => 3,
                [true, true] if grid.count(axis) < 3 => 6,
                _ => 4,
            });
        }
        most
    }

    /// The end of the row that contains `cell`, in sorted order; 0 of a cell that there is not.
    #[inline]
    pub fn row_end(&self, cell: &[u32; D]) -> u32 {
        let along = D.saturating_sub(1);
        // Wraps for a cell beyond the grid alone, and a span beyond it is empty.
        let place = cell.get(along).copied().unwrap_or(0);
        let row = self.grid.index(cell).wrapping_sub(place);
        self.span(row, row.wrapping_add(self.grid.last(along))).1
    }
}
