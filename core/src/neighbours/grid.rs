//! The geometry of the cells.

use crate::domain::{Domain, Offset, Side};
use crate::error::{Container, Error, Quantity};
use crate::numbered::numbered;
use crate::scalar::Scalar;

use super::image::{Image, code};

/// Cells that a cloud of `particles` may take, whatever its shape: beyond it, cells grow.
///
/// Below the largest number there is, also for 2^30 particles and more: a place beyond the last
/// cell has a number of its own.
pub const fn cell_bound(particles: u32) -> u32 {
    let bound = particles.saturating_mul(4).saturating_add(128);
    if bound < u32::MAX {
        bound
    } else {
        u32::MAX - 1
    }
}

/// One direction of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
struct GridAxis<S> {
    origin: S,
    end: S,
    cell: S,
    count: u32,
    /// Cells on either side that can hold partners.
    window: u32,
    sides: [Side; 2],
}

impl<S> GridAxis<S> {
    /// The last cell.
    #[inline(always)]
    fn last(&self) -> u32 {
        // There is at least one: nothing wraps.
        self.count.wrapping_sub(1)
    }
}

/// The cells over a cloud.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid<S, const D: usize> {
    axes: [GridAxis<S>; D],
    reach: S,
}

impl<S: Scalar, const D: usize> Grid<S, D> {
    /// Fits cells to the cloud: any two positions within `reach` of each other lie at most
    /// one cell apart, four along the last direction.
    ///
    /// Errors: a domain upside down, a period below three reaches, two walls that are nearer than
    /// one, a reach beyond [`Scalar::REACH_LIMIT`], a position that is no finite number.
    pub fn fit(domain: &Domain<S, D>, positions: &[[S; D]], reach: S) -> Result<Self, Error> {
        // Not `reach > limit`: that would let a NaN pass.
        if !(reach > S::ZERO && reach < S::REACH_LIMIT) {
            return Err(Error::Range);
        }
        let lost = |x: &[S; D]| !x.iter().all(|component| component.is_finite());
        if let Some(particle) = positions.iter().position(lost) {
            return Err(Error::NotFinite {
                particle: particle as u32,
                quantity: Quantity::Position,
            });
        }
        let particles = u32::try_from(positions.len()).unwrap_or(u32::MAX);
        let bound = u64::from(cell_bound(particles));
        // 1/64: what rounding may move a position in units of cells, see CELL_LIMIT.
        let mut edge = reach + reach * S::from_f64(1.0 / 64.0);
        let bounds = extent(domain, positions)?;
        long_enough(domain, edge, &bounds)?;
        for _ in 0..40 {
            let grid = Self::with_edge(domain, &bounds, edge)?;
            if grid.cells() <= bound {
                return Ok(Self { reach, ..grid });
            }
            edge = edge + edge;
        }
        Err(Error::Capacity {
            container: Container::Cells,
            needed: u32::MAX,
            capacity: bound as u32,
        })
    }

    /// Cells whose long edge is at least `edge`.
    fn with_edge(domain: &Domain<S, D>, bounds: &[[S; 2]; D], edge: S) -> Result<Self, Error> {
        let mut axes = [GridAxis {
            origin: S::ZERO,
            end: S::ZERO,
            cell: S::ONE,
            count: 1,
            window: 1,
            sides: [Side::Free; 2],
        }; D];
        let rows = numbered(axes.iter_mut().zip(&domain.axes).zip(bounds));
        for (i, ((axis, sides), &[lower, upper])) in rows {
            axis.window = if i + 1 == D { 4 } else { 1 };
            axis.sides = sides.sides;
            (axis.origin, axis.end) = (lower, upper);
            let length = upper - lower;
            axis.count = (length.cells(edge / S::count(axis.window)))
                .min(S::CELL_LIMIT.saturating_mul(axis.window))
                .max(1);
            if sides.is_periodic() {
                // Wide enough: `long_enough` has seen that a third of the period is.
                axis.count = axis.count.max(axis.window.saturating_mul(3));
            }
            axis.cell = length / S::count(axis.count);
            if !(axis.cell > S::ZERO) {
                axis.cell = edge;
            }
        }
        Ok(Self { axes, reach: edge })
    }

    /// No two partners are farther apart, for all the rounding of squares.
    pub fn farthest(&self) -> S {
        let unit = S::TINIEST;
        self.reach + unit / self.reach.lesser(S::ONE) + unit
    }

    /// Number of cells.
    pub fn cells(&self) -> u64 {
        self.axes.iter().fold(1, |cells: u64, axis| {
            cells.saturating_mul(u64::from(axis.count))
        })
    }

    /// Number of cells along direction `axis`.
    pub fn count(&self, axis: usize) -> u32 {
        self.axes.get(axis).map_or(1, |axis| axis.count)
    }

    /// The last cell along direction `axis`.
    pub(super) fn last(&self, axis: usize) -> u32 {
        self.axes.get(axis).map_or(0, GridAxis::last)
    }

    /// Cells on either side along direction `axis` that can hold partners.
    pub(super) fn window(&self, axis: usize) -> u32 {
        self.axes.get(axis).map_or(1, |axis| axis.window)
    }

    /// Whether the direction closes on itself.
    pub(super) fn is_periodic(&self, axis: usize) -> bool {
        self.axes
            .get(axis)
            .is_some_and(|axis| axis.sides == [Side::Periodic; 2])
    }

    /// Whether there is a wall at the lower (0) or upper (1) end of a direction.
    pub(super) fn is_wall(&self, axis: usize, end: usize) -> bool {
        self.axes
            .get(axis)
            .and_then(|axis| axis.sides.get(end))
            .is_some_and(|&side| side == Side::Mirror)
    }

    /// Whether any side is a wall.
    #[inline]
    pub(crate) fn has_walls(&self) -> bool {
        self.axes
            .iter()
            .any(|axis| axis.sides.contains(&Side::Mirror))
    }

    /// Where the walls are, by direction and end.
    pub(crate) fn walls(&self) -> [[Option<S>; 2]; D] {
        self.axes.map(|axis| {
            let [lower, upper] = axis.sides.map(|side| side == Side::Mirror);
            [lower.then_some(axis.origin), upper.then_some(axis.end)]
        })
    }

    /// Whether anything in this cell can have a partner behind a wall.
    #[inline]
    pub(crate) fn near_wall(&self, cell: &[u32; D]) -> bool {
        self.axes.iter().zip(cell).any(|(axis, &c)| {
            axis.sides[0] == Side::Mirror && c <= axis.window
                || axis.sides[1] == Side::Mirror && axis.last().wrapping_sub(c) <= axis.window
        })
    }

    /// The cell of a position along each direction; positions beyond the ends belong to the
    /// first and the last one.
    #[inline]
    pub fn coordinates(&self, position: &[S; D]) -> [u32; D] {
        let mut coordinates = [0; D];
        let components = coordinates.iter_mut().zip(position).zip(&self.axes);
        for ((coordinate, &x), axis) in components {
            *coordinate = (x - axis.origin).cells(axis.cell).min(axis.last());
        }
        coordinates
    }

    /// The place of a cell in the order of cells: the last direction runs fastest.
    #[inline]
    pub fn index(&self, coordinates: &[u32; D]) -> u32 {
        let components = coordinates.iter().zip(&self.axes);
        components.fold(0, |index: u32, (&coordinate, axis)| {
            index.wrapping_mul(axis.count).wrapping_add(coordinate)
        })
    }

    /// How neighbours of an image are seen.
    pub fn offsets(&self, image: Image<D>) -> [Offset<S>; D] {
        let mut offsets = [Offset::Shift(S::ZERO); D];
        let components = offsets.iter_mut().zip(&self.axes).zip(image.0);
        for ((offset, axis), code) in components {
            let length = axis.end - axis.origin;
            *offset = match code {
                code::DIRECT => Offset::Shift(S::ZERO),
                code::LOW => Offset::Shift(-length),
                code::HIGH => Offset::Shift(length),
                code::LOWER_WALL => Offset::Wall(axis.origin),
                _ => Offset::Wall(axis.end),
            };
        }
        offsets
    }
}

/// Refuses periods and boxes in which a particle would meet images that are not looked for: of
/// itself, or behind both walls.
fn long_enough<S: Scalar, const D: usize>(
    domain: &Domain<S, D>,
    edge: S,
    bounds: &[[S; 2]; D],
) -> Result<(), Error> {
    for (i, (axis, &[lower, upper])) in numbered(domain.axes.iter().zip(bounds)) {
        let reaches = (upper - lower).cells(edge);
        if axis.is_periodic() && reaches < 3 {
            return Err(Error::PeriodTooShort { axis: i as u8 });
        }
        if axis.sides == [Side::Mirror; 2] && reaches < 1 {
            return Err(Error::WallsTooNear { axis: i as u8 });
        }
    }
    Ok(())
}

/// Lower and upper end of each direction: its sides, or the cloud's own where it is free.
fn extent<S: Scalar, const D: usize>(
    domain: &Domain<S, D>,
    positions: &[[S; D]],
) -> Result<[[S; 2]; D], Error> {
    let mut bounds = [[S::ZERO; 2]; D];
    for (i, (bound, axis)) in numbered(bounds.iter_mut().zip(&domain.axes)) {
        let error = Error::EmptyDomain { axis: i as u8 };
        let components = || positions.iter().filter_map(|x| x.get(i).copied());
        let lowest = components().reduce(Scalar::lesser).ok_or(error)?;
        let highest = components().reduce(Scalar::greater).ok_or(error)?;
        let free = axis.sides.map(Side::is_passable);
        bound[0] = if free[0] { lowest } else { axis.lower };
        bound[1] = if free[1] { highest } else { axis.upper };
        let flat = free[0] || free[1];
        if !(bound[0] < bound[1] || flat && bound[0] <= bound[1]) {
            return Err(error);
        }
    }
    Ok(bounds)
}
