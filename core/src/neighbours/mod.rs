//! Who is near whom: a uniform grid of cells, and the order in which a particle receives
//! its terms.
//!
//! Cells are `reach × reach × reach/4`, the short edge along the last direction; a *row* is
//! a line of cells in that direction. Particles are sorted by cell, rows in order, inside a
//! cell by id. The geometry is a function of the state alone and belongs to the
//! determinism contract: it defines the order of summation.

mod cells;
#[cfg(any(test, not(feature = "heapless")))]
mod few;
mod grid;
mod image;
mod runs;

pub use cells::{CellBuffers, Cells, Site, sort};
#[cfg(not(feature = "heapless"))]
pub use few::Few;
pub use grid::{Grid, cell_bound};
pub use image::{Image, code};
pub use runs::{Run, Runs};
