//! Diffusivities and reactions that formulas give, in the place of those of the core.

use motes_core::cloud::{Frame, Place};
use motes_core::equation::diffusion::{
    Condition, Corners, DiffusionProblem, LargestDiffusivity, NamedProblem, ReactionPoint,
};
use motes_core::scalar::Scalar;

use crate::families::strengths::{BETWEEN, Plan, all_over, times};
use crate::scenario::formula::Formula;
use crate::scenario::linear::{Conductor, ConvectionDiffusion, Drive, Reaction, WallCondition};

/// A problem of the core, with formulas for what they say. What they compute is an `f64`, rounded once
/// to the scalar.
pub struct RunProblem<'a, S, const D: usize, const P: usize> {
    /// The rest.
    pub named: NamedProblem<'a, S, D, P>,
    pub(super) formulas: &'a Formulas,
}

/// The formulas of a problem.
#[derive(Clone, Debug)]
pub struct Formulas {
    frame: Frame,
    /// One a species; none where numbers give them.
    pub diffusivity: Vec<Formula>,
    /// The largest diffusivity of the domain at some times of the run; empty where none depends on time.
    peaks: Vec<f64>,
    duration: f64,
    /// One a species; none where there is no reaction of this kind.
    pub rates: Vec<Formula>,
    /// A bound of the `|eigenvalues|` of `∂f/∂u`, in 1 / time.
    pub stiffness: f64,
    /// Where the reaction is looked at.
    pub corners: Corners,
    /// The walls whose numbers are formulas.
    pub walls: Vec<DrivenWall>,
}

/// A wall whose number is a formula of the time.
#[derive(Clone, Debug)]
pub struct DrivenWall {
    /// The direction across it.
    pub axis: usize,
    /// 0: the lower one, 1: the upper one.
    pub end: usize,
    /// Of which unknown.
    pub species: usize,
    /// The number.
    pub number: Formula,
    /// Whether it is a flux, and no value.
    pub is_flux: bool,
}

/// The variables of a formula before the unknowns: place and time.
const BEFORE: usize = 4;

/// What the bound of a reaction may be beyond that at the points where it was looked at.
pub const MARGIN: f64 = BETWEEN;

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
        let (extent, frame) = (&plan.extent, plan.frame());
        let half = |i: usize| match i < plan.dimension {
            true => 0.5 * (extent.upper[i] - extent.lower[i]),
            false => 0.0,
        };
        let mut formulas = Self {
            frame,
            peaks: Vec::new(),
            duration: plan.duration,
            stiffness: 0.0,
            corners: Corners {
                dimension: plan.dimension,
                species: rates.len(),
                middle: frame.middle,
                half: std::array::from_fn(half),
                duration: plan.duration,
            },
            walls: walls(of),
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
        self.corners.each(size, |point| {
            let rows = slopes.iter().map(|slopes| row(slopes, point));
            largest = rows.fold(largest, f64::max);
        });
        BETWEEN * largest
    }

    /// A bound of the rates for unknowns up to a size, per unit of time of the solver.
    fn largest(&self, size: f64) -> f64 {
        let mut largest = 0.0f64;
        self.corners.each(size, |point| {
            let rates = self.rates.iter().map(|rate| rate.at(point).abs());
            largest = rates.fold(largest, f64::max);
        });
        MARGIN * largest * self.frame.units.time()
    }

    /// The largest diffusivities.
    pub fn peaks(&self) -> LargestDiffusivity<'_> {
        LargestDiffusivity {
            values: &self.peaks,
            duration: self.duration,
            margin: BETWEEN,
        }
    }
}

/// The walls of a problem whose numbers are formulas.
fn walls(of: &ConvectionDiffusion) -> Vec<DrivenWall> {
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
                        is_flux: matches!(condition, WallCondition::Flux(_)),
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
        let of = |j: usize| formulas.diffusivity.get(j).map_or(0.0, |b| b.at(&point));
        std::array::from_fn(|j| formulas.frame.diffusivity(of(j)))
    }
    fn between(&self, ends: [S; 2], time: S) -> Option<[S; P]> {
        DiffusionProblem::<S, D, P>::between(&self.named, ends, time)
    }
    fn headroom(&self, time: S) -> S {
        match self.formulas.peaks.is_empty() {
            true => DiffusionProblem::<S, D, P>::headroom(&self.named, time),
            false => {
                let now = self.formulas.frame.seconds(time);
                S::from_f64(self.formulas.peaks().headroom(now))
            }
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
        let mut point: ReactionPoint = [0.0; 8];
        point[..BEFORE].copy_from_slice(&formulas.frame.point(place));
        for (slot, u) in point[BEFORE..].iter_mut().zip(u) {
            *slot = u.to_f64();
        }
        let of = |j: usize| formulas.rates.get(j).map_or(0.0, |rate| rate.at(&point));
        std::array::from_fn(|j| formulas.frame.rate(of(j)))
    }
    fn reaction_rate(&self) -> S {
        match self.formulas.rates.is_empty() {
            true => DiffusionProblem::<S, D, P>::reaction_rate(&self.named),
            false => self.formulas.frame.rate(self.formulas.stiffness),
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
            let frame = &self.formulas.frame;
            let number = wall.number.at(&[0.0, 0.0, 0.0, frame.seconds(time)]);
            let number = match wall.is_flux {
                true => frame.velocity(number),
                false => frame.number(number),
            };
            if let Some(condition) = conditions.get_mut(wall.species) {
                *condition = condition.with(number);
            }
        }
        conditions
    }
}
