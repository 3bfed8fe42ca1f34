//! A reference where no exact solution is known: a finite-volume scheme for an ideal gas in
//! one dimension, with nothing in common with particles. MUSCL-Hancock and HLLC; second order
//! where smooth, first order in the mean error at shocks and contacts. The sources of its
//! formulae are in `finite_volume/sweep.rs`.
//!
//! Made for the two blast waves of P. Woodward and P. Colella, Journal of Computational Physics
//! 54 (1984), section IV.a: x from 0 to 1 between walls, gamma 1.4, density 1, pressure 1000,
//! 0.01 and 100 with steps at 0.1 and 0.9, t = 0.038.

pub(super) mod sweep;
#[cfg(test)]
mod tests;

use super::flow::{Flow, FlowError, FlowState, check, gamma_number};
use sweep::{Conserved, GHOSTS, Scratch};

/// Both ends of the row of cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// Walls at rest.
    Reflecting,
    /// Each the continuation of the other.
    Periodic,
    /// The gas goes on as it is in the last cell.
    Transmissive,
}

/// Equal cells along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Number, >= 2.
    pub cells: usize,
    /// Where they begin and end.
    pub extent: [f64; 2],
    /// What is there.
    pub ends: Ends,
}

/// A flow along x at one time.
#[derive(Debug, Clone)]
pub struct FiniteVolume {
    grid: Grid,
    gamma: f64,
    time: f64,
    /// [`GHOSTS`] more on either side.
    cells: Vec<Conserved>,
    scratch: Scratch,
}

/// Largest part of a cell that a wave may cross in a step; 1 is the limit of the scheme, half
/// of it leaves room for a shock that leaves a step of the initial state faster than sound.
const COURANT: f64 = 0.5;

/// Most cells advanced, all steps together: about a minute. The two blast waves take a tenth.
const MOST_WORK: f64 = 1e9;

impl FiniteVolume {
    /// At t = 0, each cell as the flow is in its middle; the velocity along x and y is kept,
    /// the energy is that of the pressure.
    ///
    /// # Errors
    /// A number out of range.
    pub fn new(
        grid: Grid,
        gamma: f64,
        initial: impl Fn(f64) -> FlowState,
    ) -> Result<Self, FlowError> {
        let [lower, upper] = grid.extent;
        check(&[
            gamma_number(gamma),
            ("cells", grid.cells as f64, ">= 2", grid.cells >= 2),
            ("lower end", lower, "a finite number", true),
            ("upper end", upper, "> the lower end", upper > lower),
        ])?;
        let mut flow = Self {
            grid,
            gamma,
            time: 0.0,
            cells: vec![[1.0; 4]; grid.cells + 2 * GHOSTS],
            scratch: Scratch::default(),
        };
        for i in 0..grid.cells {
            let x = lower + (i as f64 + 0.5) * flow.cell_size();
            let state = initial(x);
            let [u, v, _] = state.velocity;
            check(&[
                ("density", state.density, "> 0", state.density > 0.0),
                ("velocity", u + v, "a finite number", true),
                ("pressure", state.pressure, "> 0", state.pressure > 0.0),
            ])?;
            let primitive = [state.density, u, v, state.pressure];
            flow.cells[i + GHOSTS] = sweep::conserved(primitive, gamma);
        }
        flow.fill_ghosts();
        Ok(flow)
    }

    /// The same flow at a later time.
    ///
    /// # Errors
    /// As [`Self::run_to_watched`].
    pub fn run_to(self, time: f64) -> Result<Self, FlowError> {
        self.run_to_watched(time, &mut |_| ())
    }

    /// The same; `progress` is called with the part of the way that is done, in [0, 1].
    ///
    /// # Errors
    /// [`FlowError::NotPositive`] if density or pressure are no longer positive anywhere;
    /// [`FlowError::OutOfRange`] for a time before that of the flow; [`FlowError::Endless`] if it
    /// takes more than a billion cells and steps.
    pub fn run_to_watched(
        mut self,
        time: f64,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Self, FlowError> {
        check(&[("time", time, ">= that of the flow", time >= self.time)])?;
        let (start, most) = (self.time, MOST_WORK / self.grid.cells as f64);
        let mut steps = 0.0;
        while self.time < time {
            let failed = FlowError::NotPositive { time: self.time };
            let fastest = self.fastest().ok_or(failed)?;
            let left = time - self.time;
            let step = COURANT * self.cell_size() / fastest;
            steps += 1.0;
            // Waves of the start may slow down: until then four times as many are let pass.
            let all = steps + left / step;
            if steps > most || all > 4.0 * most {
                return Err(FlowError::Endless { steps: all, most });
            }
            let last = !(step < left);
            let step = if last { left } else { step };
            let later = if last { time } else { self.time + step };
            if !(later > self.time) {
                return Err(failed);
            }
            let ratio = step / self.cell_size();
            sweep::advance(&mut self.cells, ratio, self.gamma, &mut self.scratch);
            self.fill_ghosts();
            self.time = later;
            progress((later - start) / (time - start));
        }
        let failed = FlowError::NotPositive { time: self.time };
        self.fastest().map(|_| ()).ok_or(failed)?;
        Ok(self)
    }

    /// Of the flow.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Length of a cell.
    pub fn cell_size(&self) -> f64 {
        let [lower, upper] = self.grid.extent;
        (upper - lower) / self.grid.cells as f64
    }

    /// Mass, momentum along x and total energy between the ends.
    pub fn totals(&self) -> [f64; 3] {
        let inner = &self.cells[GHOSTS..GHOSTS + self.grid.cells];
        [0, 1, 3].map(|i| inner.iter().map(|q| q[i]).sum::<f64>() * self.cell_size())
    }

    fn fastest(&self) -> Option<f64> {
        self.cells.iter().try_fold(0.0, |fastest: f64, q| {
            let [u, _, sound] = sweep::speeds(q, self.gamma)?;
            Some(fastest.max(u + sound))
        })
    }

    fn fill_ghosts(&mut self) {
        let n = self.grid.cells;
        for i in 0..GHOSTS {
            // Outwards from the lower end, and from the upper one.
            let (below, above) = (GHOSTS - 1 - i, GHOSTS + n + i);
            let (from_below, from_above) = match self.grid.ends {
                Ends::Reflecting => (GHOSTS + i, GHOSTS + n - 1 - i),
                Ends::Periodic => (GHOSTS + n - 1 - i, GHOSTS + i),
                Ends::Transmissive => (GHOSTS, GHOSTS + n - 1),
            };
            let sign = if self.grid.ends == Ends::Reflecting {
                -1.0
            } else {
                1.0
            };
            for (to, from) in [(below, from_below), (above, from_above)] {
                let [mass, along, across, energy] = self.cells[from];
                self.cells[to] = [mass, sign * along, across, energy];
            }
        }
    }
}

impl Flow for FiniteVolume {
    /// At the time of the flow, whatever the one asked for: density, velocity and pressure
    /// linear between the middles of the cells. Beyond the ends: the state at the end.
    fn at(&self, position: [f64; 3], _time: f64) -> FlowState {
        let [lower, upper] = self.grid.extent;
        let x = position[0].clamp(lower, upper);
        // Cell `i` has its middle at `i + 1/2 - GHOSTS`.
        let place = (x - lower) / self.cell_size() + GHOSTS as f64 - 0.5;
        let i = (place as usize).min(self.cells.len() - 2);
        let part = place - i as f64;
        let [a, b] = [i, i + 1].map(|i| sweep::primitive(&self.cells[i], self.gamma));
        let [density, u, v, pressure] = std::array::from_fn(|k| a[k] + part * (b[k] - a[k]));
        FlowState::ideal(density, [u, v, 0.0], pressure, self.gamma)
    }
}
