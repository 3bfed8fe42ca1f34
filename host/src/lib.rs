//! motes on a server: from a scenario's name or text to a run that can be held, stepped and looked
//! into, whatever it describes, in any scalar.
//!
//! A gas:
//!
//! ```
//! use motes::engine::Threads;
//! use motes::run::{ScalarName, start};
//! use motes::scenario::{AnyScenario, Source};
//!
//! let scenario = AnyScenario::read(Source::from("sod"), &["resolution.particles=225".to_owned()])?;
//! let mut engine = Threads::new(1)?;
//! let mut sod = start(&scenario, ScalarName::F32, &mut engine)?;
//! sod.advance_to(0.1, &mut engine)?;
//! let density = sod.column("density").unwrap();
//! assert_eq!(density.len(), 225);
//! assert!(density.iter().all(|density| (0.1..1.1).contains(density)));
//! # Ok::<(), miette::Report>(())
//! ```
//!
//! A linear first-order system, to its end, against its exact solution:
//!
//! ```
//! use motes::engine::Threads;
//! use motes::experiment::Experiment;
//! use motes::run::{Control, ScalarName};
//! use motes::scenario::{AnyScenario, Source};
//!
//! let scenario = AnyScenario::read(Source::from("telegraph"), &[])?;
//! let mut control = Control {
//!     samples: scenario.samples(),
//!     progress: &mut |_| true,
//!     look: &mut |_| Ok(()),
//!     keep: None,
//!     from: None,
//! };
//! let (mut engine, how) = (Threads::new(1)?, (ScalarName::F64, false));
//! let line = Experiment::run(scenario, how, &mut engine, &mut control)?;
//! assert!(line.errors.unwrap()["state"].l2 < 2e-3);
//! # Ok::<(), miette::Report>(())
//! ```
//!
//! Convection-diffusion, from a text, step by step:
//!
//! ```
//! use motes::engine::Threads;
//! use motes::run::{ScalarName, start};
//! use motes::scenario::{AnyScenario, Source, built_in};
//!
//! let text = built_in("heat1d").unwrap().text.to_owned();
//! let scenario = AnyScenario::read(Source::Text(text), &[])?;
//! let mut engine = Threads::new(1)?;
//! let mut heat = start(&scenario, ScalarName::F64, &mut engine)?;
//! let before = heat.measures().sums;
//! while let Some(step) = heat.step(&mut engine)? {
//!     assert!(step.length > 0.0);
//! }
//! let moved = heat.measures().sums[0].value[0] - before[0].value[0];
//! assert!(moved.abs() < 1e-12);
//! # Ok::<(), miette::Report>(())
//! ```
//!
//! # Map
//!
//! | module | holds |
//! |---|---|
//! | [`scenario`] | what to simulate, read from TOML |
//! | [`families`] | from a scenario to a plan and an exact solution; the table of all that can be run |
//! | [`run`] | [`run::Simulation`], the run loop, what a run comes to, errors against a solution |
//! | [`experiment`] | a scenario run and measured |
//! | [`study`], [`precision`], [`suite`] | several resolutions; several number formats; the standard cases and their bounds |
//! | [`io`], [`report`], [`snapshots`], [`export`] | tables, pictures and summaries; states on the way; Rust source for a device |
//! | [`checkpoints`] | a run in a file, to go on from |
//! | [`engine`] | threads and lanes |
//! | [`cli`] | the program |
//!
//! # Words
//!
//! | word | means |
//! |---|---|
//! | width | ε of the cut-off `ζ_ε(x) = ε^-n ζ(x/ε)` |
//! | support | where ζ is not 0, in widths: 2 or 3 |
//! | reach | support times width, and a little more against rounding: how far a particle acts |
//! | weight | `w_k`, the volume that a particle stands for |
//! | strength | `q_k = w_k u_k`: what a particle of a linear system or of convection-diffusion carries |
//! | measure | `Σ_k q_k δ(x - x_k)`, which the particles are: what a solution is tested against |
//! | spacing | the mean distance of particles at the start, the solver's unit of length |
//! | evaluation | a right-hand side made |

pub mod benchmark;
pub mod checkpoints;
pub mod cli;
pub mod experiment;
pub mod export;
pub mod io;
pub mod precision;
pub mod report;
pub mod run;
mod scalars;
pub mod snapshots;
pub mod study;
pub mod suite;

pub use motes_solver::{engine, exact, families, flows, scenario, setup, sums, symmetriser, units};
