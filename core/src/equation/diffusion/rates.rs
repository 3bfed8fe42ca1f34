//! The right-hand sides of (4.3) or (4.6) for a whole cloud.

use super::direct::{Direct, imaged, prove_walls};
use super::dynamics::{DiffusionDynamics, Form};
use super::ledger::{Ledger, Share};
use super::mixed::{Divergence, Flux, MixedNode};
use super::node::DiffusionNode;
use super::problem::DiffusionProblem;
use super::storage::DiffusionWorkspace;
use super::wall::{Condition, Walls};
use crate::cloud::{Place, Register, State, VelocityField};
use crate::cutoff::{CutOff, across};
use crate::domain::Side;
use crate::equation::{prove_own, prove_rates, with_own};
use crate::error::Error;
use crate::neighbours::sort;
use crate::numbered::numbered;
use crate::pairs::{Engine, by_intervals_of, by_pairs};
use crate::scalar::Scalar;

impl<S, C, B, A, const D: usize, const P: usize> DiffusionDynamics<S, C, B, A, D, P>
where
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// Checks a state whose positions, weights and values have been set, makes its strengths, its
    /// rates and its neighbours. Must run once before the first step.
    ///
    /// Errors: arrays of unequal lengths, a weight that is not above 0, a particle without
    /// neighbours.
    pub fn prepare(
        &self,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut DiffusionWorkspace<'_, S, D, P>,
    ) -> Result<(), Error> {
        if !state.is_consistent() {
            return Err(Error::Lengths);
        }
        state.check()?;
        state.weigh();
        *work.grid = None;
        *work.ledger = Ledger::new();
        self.rates(engine, state, work, S::ZERO)?;
        let alone = |&neighbours: &S| !(neighbours > S::ZERO);
        match state.neighbours.iter().position(alone) {
            Some(particle) if state.len() > 1 => Err(Error::Isolated {
                particle: particle as u32,
            }),
            _ => Ok(()),
        }
    }

    /// The rates of all particles at the stage that `state` holds, into `work.last`, in id order:
    /// of positions and weights as they are, of strengths times ε².
    pub fn rates(
        &self,
        engine: &mut impl Engine<S, D>,
        state: &mut State<'_, S, D, P>,
        work: &mut DiffusionWorkspace<'_, S, D, P>,
        time: S,
    ) -> Result<(), Error> {
        let n = state.len();
        let is_fresh = work.grid.is_none();
        let grid = match *work.grid {
            Some(grid) => grid,
            None => {
                let reach = self.reach();
                let grid = sort(&self.domain, state.position, &|_| reach, &mut work.cells)?;
                engine.sorted();
                grid
            }
        };
        *work.grid = Some(grid);
        *work.time = time;
        *work.radius = None;
        self.show(state, work, time);
        let cells = work.cells.cells(grid, n);
        let (Some(nodes), Some(sums)) = (work.nodes.get_mut(..n), work.sums.get_mut(..n)) else {
            return Err(Error::Lengths);
        };
        let squared = self.epsilon * self.epsilon;
        prove_own(engine, (state.value, state.weight), squared, |u| {
            self.problem.largest_reaction(u)
        })?;
        let ledger = &mut *work.ledger;
        ledger.begin();
        if is_fresh {
            self.measure(&cells, nodes, &self.walls(time), ledger);
        }
        match self.form {
            Form::Direct => {
                let law = self.direct(ledger.conduction);
                let walls = self.walls(time);
                self.prove_passage::<Direct<S, C, D, P>>(
                    engine,
                    (&cells, nodes),
                    ledger,
                    |ground, nodes| {
                        prove_walls(&walls, ground, nodes)?;
                        let image = |node: &_, wall: &_| imaged(node, wall, &walls);
                        let proven = by_intervals_of(&law, ground, nodes, image);
                        match ground.cells.grid().has_walls() {
                            // What passes walls has products of its own.
                            true => proven,
                            false => proven.or_else(|_| by_pairs(&law, ground, nodes, image)),
                        }
                    },
                )?;
                // Proven: the image in a closed wall shows what the particle does.
                engine.sweep(&law, &cells, nodes, sums)?;
                self.join(&law, &cells, nodes, sums, time);
                let own = law.own_radius();
                for (settled, &id) in sums.iter_mut().zip(cells.order()) {
                    // What a particle does to itself is nothing, and bounds no step.
                    settled.sums.radius -= own(&settled.node);
                    let (rate, partners) = (settled.sums.rate, settled.sums.partners);
                    self.receive(state, (work.last, ledger), id, (rate, partners), time);
                }
                self.pass_direct(&law, &cells, nodes, time, (work.last, ledger));
            }
            Form::Mixed => {
                let Some(fluxes) = work.fluxes.get_mut(..n) else {
                    return Err(Error::Lengths);
                };
                let laws = self.law(time, ledger.conduction);
                engine.evaluate(&laws, &cells, nodes, fluxes)?;
                let (Some(shown), Some(sums)) =
                    (work.mixed.nodes.get_mut(..n), work.mixed.sums.get_mut(..n))
                else {
                    return Err(Error::Lengths);
                };
                let tensor = self.problem.tensor();
                // Pairs across the main direction of a tensor may give in the direct form.
                let share = match tensor {
                    None => laws.share(),
                    Some(_) => S::ZERO,
                };
                for (shown, settled) in shown.iter_mut().zip(fluxes.iter()) {
                    let (node, mut flux) = (settled.node, settled.sums.slope);
                    for (flux, &b) in flux.iter_mut().zip(&node.diffusivity) {
                        let slope = match &tensor {
                            Some(tensor) => tensor.map(|row| S::dot(&row, flux)),
                            None => *flux,
                        };
                        *flux = slope.map(|slope| -(b * slope));
                        if share > S::ZERO {
                            *flux = flux.map(|flux| flux - share * flux);
                        }
                    }
                    *shown = MixedNode { node, flux };
                }
                let law = Divergence { first: laws, share };
                let walls = self.walls(time);
                self.prove_passage::<Divergence<S, C, D, P>>(
                    engine,
                    (&cells, shown),
                    ledger,
                    |ground, nodes| {
                        let image = |node: &_, wall: &_| law.behind(node, wall, &walls);
                        by_intervals_of(&law, ground, nodes, image)
                    },
                )?;
                engine.evaluate(&law, &cells, shown, sums)?;
                let rows = sums.iter().zip(fluxes.iter()).zip(cells.order());
                for ((settled, first), &id) in rows {
                    let (rate, partners) = (settled.sums.rate, first.sums.partners);
                    self.receive(state, (work.last, ledger), id, (rate, partners), time);
                }
                self.pass_mixed(&law, &cells, shown, time, (work.last, ledger));
            }
        }
        prove_rates(engine, work.last.get(..n).unwrap_or(&[]))
    }

    /// What a particle exchanges with the outside under the mixed form, for each wall and species: the
    /// factor of `u - outside` in `-ε² du/dt`, and `outside`.
    ///
    /// `2 g ζ̄_ε(d)` at distance d, g the conductance of layer and wall in a row: the flux `g (u -
    /// outside)` of the particle itself, spread over the support, times the wall's share. Fluxes behind
    /// the wall are those of a closed one. With the flux of the image's particle behind the wall, a wave
    /// of two spacings would feed itself at any step; so it only decays.
    pub(super) fn at_exchanges(
        &self,
        walls: &Walls<S, D, P>,
        shares: &[[Share<S>; 2]; D],
        node: &DiffusionNode<S, D, P>,
        mut pay: impl FnMut((usize, usize), usize, (S, S)),
    ) {
        self.at_walls(&node.position, |(axis, end), spread, distance| {
            let conditions = walls.get(axis).and_then(|ends| ends.get(end));
            let share = shares.get(axis).and_then(|ends| ends.get(end));
            let (Some(conditions), Some(share)) = (conditions, share) else {
                return;
            };
            for (j, (condition, &b)) in numbered(conditions.iter().zip(&node.diffusivity)) {
                if let Some((conductance, outside)) = condition.conductance(b, distance) {
                    let factor = spread * (share.own * conductance);
                    pay((axis, end), j, (factor, outside));
                }
            }
        });
    }

    /// The walls within reach of a position, by direction and end: `ε² 2 ζ̄_ε(d)` at distance d, whose
    /// integral over d is ε², and d.
    pub(super) fn at_walls(&self, position: &[S; D], mut near: impl FnMut((usize, usize), S, S)) {
        for (i, (axis, &x)) in numbered(self.domain.axes.iter().zip(position)) {
            let sides = axis.sides.iter().zip([axis.lower, axis.upper]);
            for (end, (side, wall)) in numbered(sides) {
                let distance = (x - wall).abs();
                if *side == Side::Mirror && distance < self.reach() {
                    let across = across::<S, C, D>(self.cut_off, distance / self.epsilon);
                    near((i, end), (self.epsilon + self.epsilon) * across, distance);
                }
            }
        }
    }

    /// The law of the direct form, of pairs that conduct so many times as well.
    pub(super) fn direct(&self, conduction: S) -> Direct<S, C, D, P> {
        Direct {
            cut_off: self.cut_off,
            scale: self.cut_off.scale(S::ONE / self.epsilon),
            height: self.height(conduction),
            mean: self.mean,
            tensor: self.problem.tensor(),
        }
    }

    /// `σ ε^-D`, so many times.
    fn height(&self, conduction: S) -> S {
        let sigma = S::from_f64(self.cut_off.normalisation::<D>());
        let height = sigma / self.epsilon.powi(D);
        // Not a product that may round where nothing is to change.
        if conduction == S::ONE {
            height
        } else {
            conduction * height
        }
    }

    /// The first law of the mixed form, likewise.
    fn law(&self, time: S, conduction: S) -> Flux<S, C, D, P> {
        let inverse_epsilon = S::ONE / self.epsilon;
        Flux {
            cut_off: self.cut_off,
            inverse_epsilon,
            scale: self.cut_off.scale(inverse_epsilon),
            height: self.height(conduction),
            walls: self.walls(time),
        }
    }

    /// What holds at the walls.
    pub(crate) fn walls(&self, time: S) -> Walls<S, D, P> {
        let mut walls = [[[Condition::NoFlux; P]; 2]; D];
        for (axis, ends) in numbered(&mut walls) {
            for (end, conditions) in numbered(ends) {
                *conditions = self.problem.wall(axis, end, time);
            }
        }
        walls
    }

    /// Nodes, in sorted order.
    pub(super) fn show(
        &self,
        state: &State<'_, S, D, P>,
        work: &mut DiffusionWorkspace<'_, S, D, P>,
        time: S,
    ) {
        for (node, &id) in work.nodes.iter_mut().zip(work.cells.order.iter()) {
            let id = id as usize;
            let (Some(&position), Some(&weight), Some(&value)) = (
                state.position.get(id),
                state.weight.get(id),
                state.value.get(id),
            ) else {
                continue;
            };
            *node = DiffusionNode {
                weight,
                position,
                value,
                diffusivity: self.problem.diffusivity(&Place { position, time }),
            };
        }
    }

    /// Takes the sums of a particle over into its rates.
    fn receive(
        &self,
        state: &mut State<'_, S, D, P>,
        (last, ledger): (&mut [Register<S, D, P>], &mut Ledger<S, D, P>),
        id: u32,
        (rate, partners): ([S; P], S),
        time: S,
    ) {
        let id = id as usize;
        let (Some(&position), Some(&weight), Some(value), Some(rates)) = (
            state.position.get(id),
            state.weight.get(id),
            state.value.get(id),
            last.get_mut(id),
        ) else {
            return;
        };
        let place = Place { position, time };
        rates.position = self.field.velocity(&place);
        rates.weight = weight * self.field.divergence(&place);
        let reaction = self.problem.reaction(&place, value);
        let squared = self.epsilon * self.epsilon;
        let made = rates.strength.iter_mut().zip(&mut ledger.reactions);
        for ((sum, intake), (pairs, f)) in made.zip(rate.into_iter().zip(reaction)) {
            let reacted = squared * (weight * f);
            *sum = with_own(pairs, reacted);
            intake.add(reacted);
        }
        if let Some(neighbours) = state.neighbours.get_mut(id) {
            *neighbours = partners - S::ONE;
        }
    }
}
