//! The engine: one loop over pairs, many laws.
//!
//! An equation is a [`Law`]: what a particle shows, the term of a pair, what becomes of the
//! sum. The **plain loop** ([`plain`]) is the definition of a sum: partners in ascending
//! sorted order, real and periodic ones first, then the mirror images wall by wall, starting
//! from +0. The [`half`] loop and the [`lanes`] give the same bits faster: skipped terms are
//! exactly 0, and no sum is ever -0.

mod engine;
mod half;
mod kernel;
mod lanes;
mod law;
mod mirror;
mod partners;
mod plain;
mod proof;
mod record;
mod run;
mod visit;

pub use engine::{Engine, HalfLoop, PlainLoop};
pub use half::half;
pub use kernel::{Kernel, Operands, Portable, Receivers, find, sum};
pub use lanes::{Block, Blocks, List, lanes};
pub use law::{Law, Separation, Settled, by_intervals, by_intervals_of, by_pairs};
pub use plain::{plain, receive_at};
pub use proof::{Ground, Largest, holds};
pub use record::{Fields, Nothing};
pub(crate) use visit::{Partner, each_image, each_partner};
