//! The engine: one loop over pairs, many laws.
//!
//! An equation is a [`Law`]: what a particle shows, the term of a pair, what becomes of the
//! sum. The **plain loop** ([`plain`]) is the definition of a sum: partners in ascending
//! sorted order, real and periodic ones first, then the mirror images wall by wall, starting
//! from +0. The [`half`] loop and the [`lanes`] give the same bits faster: skipped terms are
//! exactly 0, and no sum is ever -0.

mod half;
mod lanes;
mod law;
mod mirror;
mod plain;

pub use half::half;
pub use lanes::{Block, Blocks, Kernel, List, Operands, Portable, Receivers, find, lanes, sum};
pub use law::{Engine, Fields, HalfLoop, Law, PlainLoop, Settled};
pub use plain::plain;
