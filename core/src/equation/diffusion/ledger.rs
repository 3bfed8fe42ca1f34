//! What has come in through walls and from reactions: the other side of the sums of the strengths.

use crate::cloud::Words;
use crate::error::Error;
use crate::scalar::Scalar;

/// A sum that is stepped as strengths are, with the registers of a particle.
#[derive(Clone, Copy, Debug)]
pub struct Intake<S: Scalar> {
    /// `ε²` times its rate at the last stage: a sum over particles, which a scalar may not hold.
    last: S::Wide,
    total: S::Wide,
    start: S::Wide,
    sum: S::Wide,
    stages: [S::Wide; 3],
}

impl<S: Scalar> Intake<S> {
    const NOTHING: Self = Self {
        last: S::NOTHING,
        total: S::NOTHING,
        start: S::NOTHING,
        sum: S::NOTHING,
        stages: [S::NOTHING; 3],
    };

    /// What has come in since the run was prepared; below 0 where it went out.
    pub fn total(&self) -> S::Wide {
        self.total
    }

    /// Adds a particle's term to the rate of this stage.
    #[inline(always)]
    pub(super) fn add(&mut self, term: S) {
        self.last = S::wide_sum(self.last, S::product(S::ONE, term));
    }

    /// The rate of this stage so far.
    pub(super) fn rate(&self) -> S {
        S::saturated(self.last)
    }

    fn put(&mut self, per_power: S, rate: S::Wide) {
        self.total = S::wide_sum(self.start, S::scaled(per_power, rate));
    }
}

/// How much what is spread over the particles near a wall is to be multiplied by, so that it adds up to
/// what the wall lets through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Share<S> {
    /// Where it is spread as the pairs across the wall are.
    pub pairs: S,
    /// Where each particle pays by itself.
    pub own: S,
}

/// The balance of a convection-diffusion problem: `Σ_k q_k` has grown by what came in through each
/// wall, and by what reactions made.
///
/// In fixed point with a Runge-Kutta method to the last bit; in floats, and with the stabilised
/// method, to rounding.
#[derive(Clone, Copy, Debug)]
pub struct Ledger<S: Scalar, const D: usize, const P: usize> {
    /// Through walls, by direction, end and species.
    pub walls: [[[Intake<S>; P]; 2]; D],
    /// From reactions, by species.
    pub reactions: [Intake<S>; P],
    pub(super) shares: [[Share<S>; 2]; D],
    /// What the sums over pairs are multiplied by so that they conduct as much as `b` says: 1 over their
    /// mean second moment.
    pub(super) conduction: S,
}

impl<S: Scalar, const D: usize, const P: usize> Default for Ledger<S, D, P> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const D: usize, const P: usize> Ledger<S, D, P> {
    /// Nothing has come in.
    pub const fn new() -> Self {
        Self {
            walls: [[[Intake::NOTHING; P]; 2]; D],
            reactions: [Intake::NOTHING; P],
            shares: [[Share {
                pairs: S::ONE,
                own: S::ONE,
            }; 2]; D],
            conduction: S::ONE,
        }
    }

    fn intakes(&mut self) -> impl Iterator<Item = &mut Intake<S>> {
        let walls = self.walls.iter_mut().flatten().flatten();
        walls.chain(&mut self.reactions)
    }

    /// Passes what has come in so far.
    pub(crate) fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        self.intakes()
            .try_for_each(|intake| words.wide::<S>(&mut intake.total))
    }

    /// Begins the rates of a stage.
    pub(super) fn begin(&mut self) {
        self.intakes().for_each(|intake| intake.last = S::NOTHING);
    }

    /// The intake through a wall.
    pub(super) fn wall(&mut self, axis: usize, end: usize) -> Option<&mut [Intake<S>; P]> {
        self.walls.get_mut(axis).and_then(|ends| ends.get_mut(end))
    }

    /// The share of a wall.
    pub(super) fn share(&self, axis: usize, end: usize) -> Share<S> {
        let share = self.shares.get(axis).and_then(|ends| ends.get(end));
        share.copied().unwrap_or(Share {
            pairs: S::ONE,
            own: S::ONE,
        })
    }

    /// Remembers itself as the start of a step, with empty registers.
    pub(crate) fn start(&mut self) {
        self.intakes().for_each(|intake| {
            intake.start = intake.total;
            intake.sum = S::NOTHING;
            intake.stages = [S::NOTHING; 3];
        });
    }

    /// Goes back to the start of the step.
    #[cfg(feature = "heapless")]
    pub(super) fn restore(&mut self) {
        self.intakes()
            .for_each(|intake| intake.total = intake.start);
    }

    /// Adds `n` times the last rates to the sum of the step, as for strengths.
    pub(crate) fn accumulate(&mut self, n: u32) {
        self.intakes().for_each(|intake| {
            for _ in 0..n {
                intake.sum = S::wide_sum(intake.sum, intake.last);
            }
        });
    }

    /// Puts the intakes at the start of the step plus the last rates times `per_power`.
    pub(crate) fn put_last(&mut self, per_power: S) {
        self.intakes()
            .for_each(|intake| intake.put(per_power, intake.last));
    }

    /// The same with the sum of the rates of the step.
    pub(crate) fn put_sum(&mut self, per_power: S) {
        self.intakes()
            .for_each(|intake| intake.put(per_power, intake.sum));
    }

    /// Keeps the last rates as those of the first stage.
    pub(crate) fn keep(&mut self) {
        self.intakes()
            .for_each(|intake| intake.stages[0] = intake.last);
    }

    /// A stage of the stabilised method, with the weights that strengths have there.
    pub(crate) fn combine(&mut self, [mu, nu]: [S; 2], fresh: S, first: S) {
        self.intakes().for_each(|intake| {
            let [rate, before, earlier] = intake.stages;
            let terms = [(nu, earlier), (fresh, intake.last), (first, rate)];
            let increment = terms.iter().fold(S::scaled(mu, before), |sum, &(a, b)| {
                S::wide_sum(sum, S::scaled(a, b))
            });
            intake.stages = [rate, increment, before];
            intake.put(S::ONE, increment);
        });
    }
}
