//! The problem of a convection-diffusion plan in the scalar of a run.

use std::f64::consts::TAU;

use motes_core::equation::diffusion::{
    Conductor, Drive, DrivenCondition, Form, Mean, Modulation, NamedProblem, Reaction,
};
use motes_core::scalar::Scalar;

use super::formulas::{Formulas, RunProblem};
use crate::families::strengths::Plan;
use crate::scenario::linear as scenario;
use crate::scenario::linear::{ConvectionDiffusion, System, WallCondition};

/// The lists that a problem refers to, in solver units.
pub struct Media<S> {
    bounds: Vec<S>,
    factors: Vec<S>,
    /// By direction, end and species; empty where nothing changes in time.
    series: Vec<[Vec<Series<S>>; 2]>,
    /// What formulas say.
    pub formulas: Formulas,
}

/// Times and values.
type Series<S> = Vec<(S, S)>;

impl Plan {
    /// The convection-diffusion of the plan; `None` for another system.
    pub fn convection_diffusion(&self) -> Option<&ConvectionDiffusion> {
        match &self.system {
            System::ConvectionDiffusion(problem) => Some(problem),
            _ => None,
        }
    }

    /// The coordinate along x in solver units.
    fn along(&self, x: f64) -> f64 {
        (x - self.middle[0]) / self.units.length
    }

    /// The unit of what passes through a wall.
    fn unit_of_flux(&self, condition: &WallCondition) -> f64 {
        match condition {
            WallCondition::Flux(_) => self.units.velocity,
            _ => 1.0,
        }
    }

    /// The largest number that drives a wall during the run, in solver units; 0 without any.
    pub(in crate::families) fn largest_drive(&self) -> f64 {
        let Some(problem) = self.convection_diffusion() else {
            return 0.0;
        };
        let largest = |condition: &WallCondition| {
            let largest = match condition.drive() {
                Some(scenario::Drive::Constant(value)) => value.abs(),
                Some(drive @ scenario::Drive::Formula(_)) => drive
                    .sampled(self.duration, 1024)
                    .iter()
                    .fold(0.0, |largest: f64, (_, value)| largest.max(value.abs())),
                Some(scenario::Drive::Series(series)) => within(series, self.duration)
                    .iter()
                    .fold(0.0, |largest: f64, (_, value)| largest.max(value.abs())),
                None => 0.0,
            };
            largest / self.unit_of_flux(condition)
        };
        let walls = problem.walls.iter().flatten().flatten();
        walls.map(largest).fold(0.0, f64::max)
    }

    /// The lists of a problem.
    pub fn media<S: Scalar>(&self, problem: &ConvectionDiffusion) -> Media<S> {
        let (bounds, factors) = match &problem.profile {
            scenario::Conductor::Layers { bounds, factors } => {
                (bounds.as_slice(), factors.as_slice())
            }
            _ => (&[][..], &[][..]),
        };
        let series = |condition: &WallCondition| {
            let Some(series) = condition.series() else {
                return Vec::new();
            };
            let unit = self.unit_of_flux(condition);
            let point = |(time, value): (f64, f64)| {
                let time = time / self.unit_of_time();
                (S::from_f64(time), S::from_f64(value / unit))
            };
            let points = within(series, self.duration).into_iter();
            points.map(point).collect()
        };
        let ends = |ends: &[Vec<WallCondition>; 2]| {
            let end = |species: &Vec<WallCondition>| species.iter().map(series).collect();
            [end(&ends[0]), end(&ends[1])]
        };
        Media {
            bounds: bounds.iter().map(|&x| S::from_f64(self.along(x))).collect(),
            factors: factors.iter().map(|&factor| S::from_f64(factor)).collect(),
            series: problem.walls.iter().map(ends).collect(),
            formulas: Formulas::new(self, problem),
        }
    }

    /// The problem, with nothing for species beyond those of the plan.
    pub fn problem<'a, S: Scalar, const D: usize, const P: usize>(
        &self,
        of: &ConvectionDiffusion,
        media: &'a Media<S>,
    ) -> RunProblem<'a, S, D, P> {
        RunProblem {
            named: self.named_problem(of, media),
            formulas: &media.formulas,
        }
    }

    /// The same without what formulas give: the problem of a device.
    pub fn named_problem<'a, S: Scalar, const D: usize, const P: usize>(
        &self,
        of: &ConvectionDiffusion,
        media: &'a Media<S>,
    ) -> NamedProblem<'a, S, D, P> {
        let unit = self.units.length * self.units.velocity;
        let number = S::from_f64;
        NamedProblem {
            diffusivity: std::array::from_fn(|j| {
                of.diffusivity
                    .get(j)
                    .map_or(S::ZERO, |b| S::from_f64(b / unit))
            }),
            conductor: match of.profile {
                scenario::Conductor::Uniform | scenario::Conductor::Formula { .. } => {
                    Conductor::Uniform
                }
                scenario::Conductor::Parabola { center, radius } => Conductor::Parabola {
                    center: number(self.along(center)),
                    radius: number(radius / self.units.length),
                },
                scenario::Conductor::Layers { .. } => Conductor::Layers {
                    bounds: &media.bounds,
                    factors: &media.factors,
                },
            },
            modulation: of.modulation.map_or(Modulation::NONE, |of| Modulation {
                amplitude: number(of.amplitude),
                frequency: number(of.rate * self.unit_of_time() / TAU),
            }),
            tensor: of
                .tensor
                .as_ref()
                .map(|tensor| tensor_of(tensor).map(|row| row.map(number))),
            reaction: self.reaction(&of.reaction),
            walls: std::array::from_fn(|axis| {
                std::array::from_fn(|end| {
                    std::array::from_fn(|j| {
                        let condition = of.walls.get(axis).and_then(|ends| ends[end].get(j));
                        let points = media.series.get(axis).and_then(|ends| ends[end].get(j));
                        match (condition, points) {
                            (Some(condition), Some(points)) => self.wall(condition, points),
                            _ => DrivenCondition::NoFlux,
                        }
                    })
                })
            }),
        }
    }

    fn wall<'a, S: Scalar>(
        &self,
        condition: &WallCondition,
        points: &'a [(S, S)],
    ) -> DrivenCondition<'a, S> {
        let unit = self.unit_of_flux(condition);
        let driven = |drive: &scenario::Drive| match drive {
            scenario::Drive::Constant(value) => Drive::Constant(S::from_f64(value / unit)),
            scenario::Drive::Series(_) => Drive::Series(points),
            // `RunProblem` puts its value in the place of this.
            scenario::Drive::Formula(_) => Drive::Constant(S::ZERO),
        };
        match condition {
            WallCondition::NoFlux => DrivenCondition::NoFlux,
            WallCondition::Value(value) => DrivenCondition::Value(driven(value)),
            WallCondition::Flux(flux) => DrivenCondition::Flux(driven(flux)),
            WallCondition::Exchange { rate, outside } => DrivenCondition::Exchange {
                rate: S::from_f64(rate / self.units.velocity),
                outside: driven(outside),
            },
        }
    }

    /// The reaction.
    pub(super) fn reaction<S: Scalar, const P: usize>(
        &self,
        of: &scenario::Reaction,
    ) -> Reaction<S, P> {
        let time = self.unit_of_time();
        let rate = |rate: f64| S::from_f64(rate * time);
        match of {
            scenario::Reaction::None | scenario::Reaction::Formula { .. } => Reaction::None,
            scenario::Reaction::Linear { matrix, source } => {
                let p = source.len();
                Reaction::Linear {
                    matrix: std::array::from_fn(|i| {
                        std::array::from_fn(|j| match i.max(j) < p {
                            true => rate(matrix[i * p + j]),
                            false => S::ZERO,
                        })
                    }),
                    source: std::array::from_fn(|i| source.get(i).map_or(S::ZERO, |&s| rate(s))),
                }
            }
            scenario::Reaction::Logistic { rate: r, capacity } => Reaction::Logistic {
                rate: rate(*r),
                capacity: S::from_f64(*capacity),
            },
            scenario::Reaction::GrayScott { feed, kill } => Reaction::GrayScott {
                feed: S::from_f64(*feed),
                kill: S::from_f64(*kill),
                unit: rate(1.0),
            },
        }
    }
}

/// The part of a series that a run of that duration meets: what lies beyond may not fit its format.
fn within(series: &scenario::Series, duration: f64) -> Vec<(f64, f64)> {
    let points = series
        .times
        .iter()
        .copied()
        .zip(series.values.iter().copied());
    let points: Vec<(f64, f64)> = points.collect();
    let start = Drive::Series(&points).at(0.0);
    let end = Drive::Series(&points).at(duration);
    let between = points.iter().filter(|(t, _)| (0.0..=duration).contains(t));
    let mut part: Vec<(f64, f64)> = between.copied().collect();
    if points.first().is_some_and(|(first, _)| *first < 0.0) {
        part.insert(0, (0.0, start));
        part.dedup_by_key(|(time, _)| *time);
    }
    if points.last().is_some_and(|(last, _)| *last > duration) {
        part.push((duration, end));
        part.dedup_by_key(|(time, _)| *time);
    }
    part
}

/// The form of the core, and its mean.
pub fn form(of: &ConvectionDiffusion) -> (Form, Mean) {
    let form = match of.form {
        scenario::Form::Direct => Form::Direct,
        scenario::Form::Mixed => Form::Mixed,
    };
    let mean = match of.mean {
        scenario::Mean::Arithmetic => Mean::Arithmetic,
        scenario::Mean::Harmonic => Mean::Harmonic,
    };
    (form, mean)
}

/// A tensor in the dimension of a run.
fn tensor_of<const D: usize>(tensor: &[Vec<f64>]) -> [[f64; D]; D] {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| tensor.get(i).and_then(|row| row.get(j)).map_or(0.0, |t| *t))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_is_cut_to_the_run() {
        let cut = |times: &[f64], values: &[f64]| {
            let series = scenario::Series {
                file: String::new(),
                text: String::new(),
                times: times.to_vec(),
                values: values.to_vec(),
                is_held: true,
            };
            within(&series, 4.0)
        };
        assert_eq!(cut(&[1.0, 4.0], &[5.0, 6.0]), [(1.0, 5.0), (4.0, 6.0)]);
        assert_eq!(
            cut(&[-1e9, 1e9, 2e9], &[0.0, 1.0, 9.0]),
            [(0.0, 0.5), (4.0, 0.5 + 2e-9)]
        );
        assert_eq!(
            cut(&[-2.0, 0.0, 2.0, 6.0], &[1.0, 2.0, 3.0, 7.0]),
            [(0.0, 2.0), (2.0, 3.0), (4.0, 5.0)]
        );
        assert_eq!(cut(&[-2.0, -1.0], &[1.0, 2.0]), [(0.0, 2.0)]);
        assert_eq!(cut(&[7.0, 9.0], &[1.0, 2.0]), [(4.0, 1.0)]);
    }
}
