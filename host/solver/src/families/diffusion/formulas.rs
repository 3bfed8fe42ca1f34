//! Diffusivities and reactions that formulas give, in the place of those of the core.

use motes_core::cloud::Place;
use motes_core::equation::diffusion::{Condition, DiffusionProblem, NamedProblem};
use motes_core::scalar::Scalar;

use crate::families::strengths::{BETWEEN, Frame, Plan, all_over, rounded, times};
use crate::scenario::Extent;
use crate::scenario::formula::Formula;
use crate::scenario::linear::{Conductor, ConvectionDiffusion, Drive, Reaction};

/// A problem of the core, with formulas for what they say. What they compute is an `f64`, rounded once
/// to the scalar.
pub struct RunProblem<'a, S, const D: usize, const P: usize> {
    /// The rest.
    pub named: NamedProblem<'a, S, D, P>,
    pub(super) formulas: &'a Formulas,
}

/// The formulas of a problem.
#[derive(Clone, Debug)]
pub(super) struct Formulas {
    frame: Frame,
    /// One a species; none where numbers give them.
    diffusivity: Vec<Formula>,
    /// The largest diffusivity of the domain at [`times`]; empty where none depends on time.
    peaks: Vec<f64>,
    duration: f64,
    /// One a species; none where there is no reaction of this kind.
    pub rates: Vec<Formula>,
    /// A bound of the `|eigenvalues|` of `∂f/∂u`, in 1 / time.
    stiffness: f64,
    extent: Extent,
    walls: Vec<DrivenWall>,
}

/// A wall whose number is a formula of the time.
#[derive(Clone, Debug)]
struct DrivenWall {
    axis: usize,
    end: usize,
    species: usize,
    number: Formula,
    /// Of the number.
    unit: f64,
}

/// The variables of a formula before the unknowns: place and time.
const BEFORE: usize = 4;
/// The most unknowns.
const MOST: usize = 4;

impl Formulas {
    /// Those of a problem of a plan.
    pub fn new(plan: &Plan, of: &ConvectionDiffusion) -> Self {
        let diffusivity = match &of.profile {
            Conductor::Formula { diffusivity } => diffusivity.clone(),
            _ => Vec::new(),
        };
        let rates = match &of.reaction {
            Reaction::Formula { rates } => rates.clone(),
            _ => Vec::new(),
        };
        let mut formulas = Self {
            frame: plan.frame(),
            peaks: Vec::new(),
            duration: plan.duration,
            stiffness: 0.0,
            extent: plan.extent.clone(),
            walls: walls(plan, of),
            diffusivity,
            rates,
        };
        if formulas
            .diffusivity
            .iter()
            .any(|of| of.depends_on(BEFORE - 1))
        {
            let peak = |time| {
                let mut peak = 0.0f64;
                all_over(&plan.extent, time, |point| {
                    let all = formulas.diffusivity.iter().map(|of| of.at(point));
                    peak = all.fold(peak, f64::max);
                });
                peak
            };
            formulas.peaks = times(plan.duration).map(peak).collect();
        }
        // The amplitude is the power of two below the largest value.
        formulas.stiffness = formulas.stiffest(4.0 * plan.amplitude);
        formulas
    }

    /// The largest sum of `|∂f_i/∂u_j|` of a row, for unknowns up to a size.
    fn stiffest(&self, size: f64) -> f64 {
        let p = self.rates.len();
        let slopes = self.rates.iter().map(|rate| {
            (0..p)
                .map(|j| rate.derivative(BEFORE + j))
                .collect::<Vec<_>>()
        });
        let slopes: Vec<Vec<Formula>> = slopes.collect();
        let row = |row: &[Formula], point: &[f64]| {
            row.iter().map(|slope| slope.at(point).abs()).sum::<f64>()
        };
        let mut largest = 0.0f64;
        self.over(size, |point| {
            let rows = slopes.iter().map(|slopes| row(slopes, point));
            largest = rows.fold(largest, f64::max);
        });
        BETWEEN * largest
    }

    /// Calls a function at corners and middles of the domain and of unknowns up to a size.
    fn over(&self, size: f64, mut of: impl FnMut(&[f64])) {
        let (p, dimension) = (self.rates.len(), self.extent.lower.len());
        let corners = 3usize.pow((dimension + 1 + p) as u32);
        let mut point = vec![0.0; BEFORE + p];
        for mut number in 0..corners {
            let mut part = || {
                let part = number % 3;
                number /= 3;
                part as f64 - 1.0
            };
            for (i, x) in point.iter_mut().enumerate().take(dimension) {
                let half = 0.5 * (self.extent.upper[i] - self.extent.lower[i]);
                *x = self.frame.middle[i] + part() * half;
            }
            point[BEFORE - 1] = 0.5 * (1.0 + part()) * self.duration;
            for u in &mut point[BEFORE..] {
                *u = part() * size;
            }
            of(&point);
        }
    }

    /// A bound of the rates for unknowns up to a size, per unit of time of the solver.
    fn largest(&self, size: f64) -> f64 {
        let mut largest = 0.0f64;
        self.over(size, |point| {
            let rates = self.rates.iter().map(|rate| rate.at(point).abs());
            largest = rates.fold(largest, f64::max);
        });
        BETWEEN * largest * self.frame.time()
    }

    /// By what factor the largest diffusivity may yet exceed that of a time.
    fn headroom(&self, time: f64) -> f64 {
        let Some(last) = self.peaks.len().checked_sub(1) else {
            return 1.0;
        };
        let place = (time / self.duration * last as f64).clamp(0.0, last as f64);
        let (before, after) = (place.floor() as usize, place.ceil() as usize);
        let now = self.peaks[before].min(self.peaks[after]);
        let later = self.peaks[before..].iter().copied().fold(0.0, f64::max);
        match now > 0.0 {
            true => BETWEEN * later / now,
            false => BETWEEN,
        }
    }
}

/// The walls of a problem whose numbers are formulas.
fn walls(plan: &Plan, of: &ConvectionDiffusion) -> Vec<DrivenWall> {
    let mut walls = Vec::new();
    for (axis, ends) in of.walls.iter().enumerate() {
        for (end, conditions) in ends.iter().enumerate() {
            for (species, condition) in conditions.iter().enumerate() {
                if let Some(Drive::Formula(number)) = condition.drive() {
                    walls.push(DrivenWall {
                        axis,
                        end,
                        species,
                        number: number.clone(),
                        unit: plan.unit_of_flux(condition),
                    });
                }
            }
        }
    }
    walls
}

impl<S: Scalar, const D: usize, const P: usize> DiffusionProblem<S, D, P>
    for RunProblem<'_, S, D, P>
{
    fn diffusivity(&self, place: &Place<S, D>) -> [S; P] {
        let formulas = self.formulas;
        if formulas.diffusivity.is_empty() {
            return self.named.diffusivity(place);
        }
        let point = formulas.frame.point(place);
        let unit = formulas.frame.units.length * formulas.frame.units.velocity;
        let of = |j: usize| formulas.diffusivity.get(j).map_or(0.0, |b| b.at(&point));
        std::array::from_fn(|j| rounded(of(j) / unit))
    }
    fn between(&self, ends: [S; 2], time: S) -> Option<[S; P]> {
        DiffusionProblem::<S, D, P>::between(&self.named, ends, time)
    }
    fn headroom(&self, time: S) -> S {
        match self.formulas.peaks.is_empty() {
            true => DiffusionProblem::<S, D, P>::headroom(&self.named, time),
            false => S::from_f64(
                self.formulas
                    .headroom(time.to_f64() * self.formulas.frame.time()),
            ),
        }
    }
    fn tensor(&self) -> Option<[[S; D]; D]> {
        self.named.tensor()
    }
    fn reaction(&self, place: &Place<S, D>, u: &[S; P]) -> [S; P] {
        let formulas = self.formulas;
        if formulas.rates.is_empty() {
            return self.named.reaction(place, u);
        }
        let mut point = [0.0; BEFORE + MOST];
        point[..BEFORE].copy_from_slice(&formulas.frame.point(place));
        for (slot, u) in point[BEFORE..].iter_mut().zip(u) {
            *slot = u.to_f64();
        }
        let of = |j: usize| formulas.rates.get(j).map_or(0.0, |rate| rate.at(&point));
        std::array::from_fn(|j| rounded(of(j) * formulas.frame.time()))
    }
    fn reaction_rate(&self) -> S {
        match self.formulas.rates.is_empty() {
            true => DiffusionProblem::<S, D, P>::reaction_rate(&self.named),
            false => S::from_f64(self.formulas.stiffness * self.formulas.frame.time()),
        }
    }
    fn largest_reaction(&self, u: f64) -> f64 {
        match self.formulas.rates.is_empty() {
            true => DiffusionProblem::<S, D, P>::largest_reaction(&self.named, u),
            false => self.formulas.largest(u),
        }
    }
    fn wall(&self, axis: usize, end: usize, time: S) -> [Condition<S>; P] {
        let mut conditions = self.named.wall(axis, end, time);
        for wall in &self.formulas.walls {
            if (wall.axis, wall.end) != (axis, end) {
                continue;
            }
            let now = time.to_f64() * self.formulas.frame.time();
            let number = rounded(wall.number.at(&[0.0, 0.0, 0.0, now]) / wall.unit);
            match conditions.get_mut(wall.species) {
                Some(Condition::Value(value)) => *value = number,
                Some(Condition::Flux(flux)) => *flux = number,
                Some(Condition::Exchange { outside, .. }) => *outside = number,
                Some(Condition::NoFlux) | None => {}
            }
        }
        conditions
    }
}
