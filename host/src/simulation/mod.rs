//! A run: the state in memory, the solver around it, what is measured of it.

mod arrays;

pub use arrays::GasArrays;
