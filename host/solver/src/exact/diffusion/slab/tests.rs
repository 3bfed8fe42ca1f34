//! The equation, the textbooks' series, the balance, and the drives.

mod march;
mod series;
mod slabs;
