//! A problem put together from named parts while the program runs.

use super::conductor::{Conductor, Modulation};
use super::drive::DrivenCondition;
use super::problem::DiffusionProblem;
use super::reaction::Reaction;
use super::wall::Condition;
use crate::cloud::Place;
use crate::scalar::Scalar;

/// `b_j(x,t) = diffusivity_j conductor(x) modulation(t)` times a constant tensor, a reaction, and
/// conditions at walls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedProblem<'a, S, const D: usize, const P: usize> {
    /// Of each species, length²/time, >= 0.
    pub diffusivity: [S; P],
    /// Its factor in space.
    pub conductor: Conductor<'a, S>,
    /// Its factor in time.
    pub modulation: Modulation<S>,
    /// Its factor by direction, see [`DiffusionProblem::tensor`].
    pub tensor: Option<[[S; D]; D]>,
    /// `f`.
    pub reaction: Reaction<S, P>,
    /// By direction, end and species.
    pub walls: [[[DrivenCondition<'a, S>; P]; 2]; D],
}

impl<S: Scalar, const D: usize, const P: usize> NamedProblem<'_, S, D, P> {
    /// The same `b` everywhere, walls that let nothing through, no reaction.
    pub const fn heat(diffusivity: [S; P]) -> Self {
        Self {
            diffusivity,
            conductor: Conductor::Uniform,
            modulation: Modulation::NONE,
            tensor: None,
            reaction: Reaction::None,
            walls: [[[DrivenCondition::NoFlux; P]; 2]; D],
        }
    }
}

impl<S: Scalar, const D: usize, const P: usize> DiffusionProblem<S, D, P>
    for NamedProblem<'_, S, D, P>
{
    fn diffusivity(&self, place: &Place<S, D>) -> [S; P] {
        let factor = self.conductor.factor(place) * self.modulation.factor(place.time);
        self.diffusivity.map(|b| factor * b)
    }
    fn between(&self, ends: [S; 2], time: S) -> Option<[S; P]> {
        let factor = self.conductor.between(ends)? * self.modulation.factor(time);
        Some(self.diffusivity.map(|b| factor * b))
    }
    fn headroom(&self, time: S) -> S {
        self.modulation.headroom(time)
    }
    fn tensor(&self) -> Option<[[S; D]; D]> {
        self.tensor
    }
    fn reaction(&self, _: &Place<S, D>, u: &[S; P]) -> [S; P] {
        self.reaction.rate(u)
    }
    fn reaction_rate(&self) -> S {
        self.reaction.bound()
    }
    fn largest_reaction(&self, u: f64) -> f64 {
        self.reaction.largest(u)
    }
    fn wall(&self, axis: usize, end: usize, time: S) -> [Condition<S>; P] {
        let walls = self.walls.get(axis).and_then(|ends| ends.get(end));
        walls.map_or([Condition::NoFlux; P], |walls| {
            walls.map(|wall| wall.at(time))
        })
    }
}
