//! What passes through walls: added to the rates of the particles near them, and to the ledger.
//!
//! Behind a wall the laws of all pairs see the image of a closed one, so that what they give adds up
//! to 0. What a condition lets through comes on top, here, where it can be counted. Spread over the
//! particles as the pairs across the wall are, it is multiplied by the wall's share, so that it
//! adds up to the flux times the area of the wall for any cloud and any `ε/h`.

use super::direct::{Direct, imaged};
use super::dynamics::{DiffusionDynamics, Form};
use super::ledger::{Ledger, Share};
use super::mixed::{Divergence, MixedNode};
use super::node::DiffusionNode;
use super::problem::DiffusionProblem;
use super::wall::{Condition, Walls, end_of};
use crate::cloud::{Register, VelocityField};
use crate::cutoff::CutOff;
use crate::domain::{Side, Wall};
use crate::error::Error;
use crate::neighbours::{Cells, Image};
use crate::numbered::numbered;
use crate::pairs::{Engine, Ground, Law, Partner, each_image, each_partner};
use crate::scalar::Scalar;

impl<S, C, B, A, const D: usize, const P: usize> DiffusionDynamics<S, C, B, A, D, P>
where
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// Whether anything may pass through a wall.
    pub(super) fn is_open(&self, walls: &Walls<S, D, P>) -> bool {
        let sides = walls.iter().zip(&self.domain.axes);
        let mut ends = sides.flat_map(|(ends, axis)| ends.iter().zip(axis.sides));
        ends.any(|(end, side)| side == Side::Mirror && !is_closed(end))
    }

    /// The walls in which an image is seen.
    fn walls_of(&self, image: &Image<D>) -> impl Iterator<Item = Wall<S>> {
        image.ends().filter_map(|(axis, end)| {
            let sides = self.domain.axes.get(axis)?;
            let position = if end == 0 { sides.lower } else { sides.upper };
            Some(Wall {
                axis,
                end,
                position,
            })
        })
    }

    /// The area of a wall across a direction: the product of the lengths of the others. `None` where one
    /// of them has no end.
    fn area(&self, across: usize) -> Option<S> {
        let mut area = S::ONE;
        for (i, axis) in numbered(&self.domain.axes) {
            if i != across {
                if axis.sides.iter().any(|side| side.is_passable()) {
                    return None;
                }
                area = area * (axis.upper - axis.lower);
            }
        }
        Some(area)
    }

    /// `ε² area flux`: what is to come in together.
    fn whole(&self, across: usize, flux: S) -> Option<S> {
        let area = self.area(across)?;
        Some((self.epsilon * self.epsilon) * (area * flux))
    }

    /// Measures a cloud that has just been sorted: how well its pairs conduct, and the shares of its walls.
    ///
    /// The first on clouds that stand still between sides through which nothing leaves them.
    #[inline(never)]
    pub(super) fn measure(
        &self,
        cells: &Cells<'_, S, D>,
        nodes: &[DiffusionNode<S, D, P>],
        walls: &Walls<S, D, P>,
        ledger: &mut Ledger<S, D, P>,
    ) {
        ledger.conduction = S::ONE;
        if !self.is_open(walls) {
            return;
        }
        let sides = self.domain.axes.iter().flat_map(|axis| axis.sides);
        if self.field.is_still() && !sides.into_iter().any(Side::is_passable) {
            ledger.conduction = self.conduction(cells, nodes);
        }
        let law = self.direct(ledger.conduction);
        let mut sums = [[[S::NOTHING; 2]; 2]; D];
        let mut add = |axis: usize, end: usize, which: usize, term: S::Wide| {
            let sum = sums.get_mut(axis).and_then(|ends| ends.get_mut(end));
            if let Some(sum) = sum.and_then(|sums| sums.get_mut(which)) {
                *sum = S::wide_sum(*sum, term);
            }
        };
        for (place, k) in numbered(nodes) {
            if !cells.grid().near_wall(&cells.cell(place)) {
                continue;
            }
            each_image(cells, place, |partner| {
                let Some(l) = nodes.get(partner.place) else {
                    return;
                };
                for wall in self.walls_of(&partner.image) {
                    let spread = self.spread(&law, [k, l], partner, &wall);
                    add(wall.axis, wall.end, 0, S::product(S::ONE, spread));
                }
            });
            if self.form == Form::Mixed {
                self.at_walls(&k.position, |(axis, end), spread, _| {
                    add(axis, end, 1, S::product(k.weight, spread));
                });
            }
        }
        for (axis, (shares, sums)) in numbered(ledger.shares.iter_mut().zip(sums)) {
            let whole = self.whole(axis, S::ONE);
            for (share, sums) in shares.iter_mut().zip(sums) {
                let [pairs, own] = sums.map(|sum| match (whole, S::rounded(sum)) {
                    (Some(whole), sum) if sum > S::ZERO => whole / sum,
                    _ => S::ONE,
                });
                *share = Share { pairs, own };
            }
        }
    }

    /// What a pair across a wall carries of a flux 1 through it, times ε²; that of the particle `k`.
    ///
    /// Direct form: `4 w_k w_l d_l` times the bracket, which makes straight lines steady. Mixed form:
    /// `-2 w_k w_l n·∇ζ_kl`.
    fn spread(
        &self,
        law: &Direct<S, C, D, P>,
        [k, l]: [&DiffusionNode<S, D, P>; 2],
        partner: &Partner<S, D>,
        wall: &Wall<S>,
    ) -> S {
        let apart = partner.apart(law, law.scale);
        let weights = k.weight * l.weight;
        match self.form {
            Form::Direct => {
                let depth = depth(l, wall);
                let twice = (weights * law.bracket(&apart)) * (depth + depth);
                twice + twice
            }
            // The bracket is -∇ζ over r, both times ε²; r points inwards.
            Form::Mixed => {
                let across = depth(k, wall) + depth(l, wall);
                (weights * law.plain_bracket(&apart)) * (across + across)
            }
        }
    }

    /// 1 over the second moment `Σ_l w_l bracket |r|²/D` of the direct form, in the mean over the
    /// cloud; the slopes of the mixed form have the same one.
    #[inline(never)]
    fn conduction(&self, cells: &Cells<'_, S, D>, nodes: &[DiffusionNode<S, D, P>]) -> S {
        let law = self.direct(S::ONE);
        let inverse = S::ONE / self.epsilon;
        let (mut moments, mut volume) = (S::NOTHING, S::NOTHING);
        for (place, k) in numbered(nodes) {
            let mut moment = S::ZERO;
            let mut add = |partner: &Partner<S, D>| {
                let Some(l) = nodes.get(partner.place) else {
                    return;
                };
                let n = partner.r.map(|r| r * inverse);
                let bracket = law.plain_bracket(&partner.apart(&law, law.scale));
                moment += (l.weight * bracket) * S::dot(&n, &n);
            };
            each_partner(cells, place, &mut add);
            each_image(cells, place, &mut add);
            moments = S::wide_sum(moments, S::product(k.weight, moment / S::count(D as u32)));
            volume = S::wide_sum(volume, S::product(k.weight, S::ONE));
        }
        let (moments, volume) = (S::rounded(moments), S::rounded(volume));
        if moments > S::ZERO {
            volume / moments
        } else {
            S::ONE
        }
    }

    /// Asks for a proof that sums over pairs and what passes through walls stay in the range of a format
    /// that wraps; shares of walls count as more partners.
    #[inline(never)]
    pub(super) fn prove_passage<W: Law<S, D>>(
        &self,
        engine: &mut impl Engine<S, D>,
        (cells, nodes): (&Cells<'_, S, D>, &[W::Node]),
        ledger: &Ledger<S, D, P>,
        proof: impl Fn(&Ground<'_, '_, S, D>, &[W::Node]) -> Result<(), Error>,
    ) -> Result<(), Error> {
        if !S::WRAPS {
            return Ok(());
        }
        let shares = ledger.shares.iter().flatten();
        let largest = |most: S, share: &Share<S>| most.greater(share.pairs).greater(share.own);
        let mut ground = Ground::of(cells);
        ground.partners *= shares.fold(S::ONE, largest).to_f64();
        proof(&ground, nodes).or_else(|error| engine.unproven(error))
    }

    /// Visits what particles near walls see behind those that let something through: the place and id of
    /// the particle, and the partner.
    #[inline(always)]
    fn each_passage(
        &self,
        cells: &Cells<'_, S, D>,
        shared: &Walls<S, D, P>,
        mut visit: impl FnMut((usize, u32), &Partner<S, D>),
    ) {
        for (place, &id) in numbered(cells.order()) {
            if !cells.grid().near_wall(&cells.cell(place)) {
                continue;
            }
            each_image(cells, place, |partner| {
                let mut walls = self.walls_of(&partner.image);
                if walls.any(|wall| passes(shared, &wall)) {
                    visit((place, id), partner);
                }
            });
        }
    }

    /// Adds what passes through walls under the direct form.
    #[inline(never)]
    pub(super) fn pass_direct(
        &self,
        law: &Direct<S, C, D, P>,
        cells: &Cells<'_, S, D>,
        nodes: &[DiffusionNode<S, D, P>],
        time: S,
        (last, ledger): (&mut [Register<S, D, P>], &mut Ledger<S, D, P>),
    ) {
        let walls = self.walls(time);
        if !self.is_open(&walls) {
            return;
        }
        let shared = shared(&walls, ledger);
        let mut final_ids = [[None; 2]; D];
        self.each_passage(cells, &shared, |(place, id), partner| {
            let pair = (nodes.get(place), nodes.get(partner.place));
            let ((Some(k), Some(l)), Some(rates)) = (pair, last.get_mut(id as usize)) else {
                return;
            };
            let bracket = law.bracket(&partner.apart(law, law.scale));
            let factor = (k.weight * l.weight) * bracket;
            let twice = self.twice([k, l], &partner.image, time);
            let mut value = l.value;
            for wall in self.walls_of(&partner.image) {
                let at = (wall.axis, wall.position);
                let [out_k, out_l] = [k, l].map(|node| self.way_out(node, at, time));
                let [depth_k, depth_l] = [k, l].map(|node| depth(node, &wall));
                let Some(conditions) = end_of(&shared, &wall) else {
                    continue;
                };
                let Some(intakes) = ledger.wall(wall.axis, wall.end) else {
                    continue;
                };
                mark(&mut final_ids, &wall, id);
                for j in 0..P {
                    let seen = conditions[j].image(value[j], out_l[j], depth_l);
                    let term = match conditions[j] {
                        Condition::NoFlux => continue,
                        Condition::Flux(flux) => {
                            // Of the way, the part behind the wall, by resistance.
                            let (k, l) = (depth_k * out_l[j], depth_l * out_k[j]);
                            let behind = match out_k[j] == out_l[j] || !(k + l > S::ZERO) {
                                true => depth_l,
                                false => (depth_k + depth_l) * (l / (k + l)),
                            };
                            -(factor * (behind + behind)) * (flux + flux)
                        }
                        _ => factor * (twice[j] * (seen - value[j])),
                    };
                    rates.strength[j] += term;
                    intakes[j].add(term);
                    value[j] = seen;
                }
            }
        });
        self.settle(&walls, &final_ids, (last, ledger));
    }

    /// The same under the mixed form, where fluxes are exchanged.
    #[inline(never)]
    pub(super) fn pass_mixed(
        &self,
        law: &Divergence<S, C, D, P>,
        cells: &Cells<'_, S, D>,
        nodes: &[MixedNode<S, D, P>],
        time: S,
        (last, ledger): (&mut [Register<S, D, P>], &mut Ledger<S, D, P>),
    ) {
        let walls = self.walls(time);
        if !self.is_open(&walls) {
            return;
        }
        let shared = shared(&walls, ledger);
        let inverse = law.first.inverse_epsilon;
        let mut final_ids = [[None; 2]; D];
        self.each_passage(cells, &shared, |(place, id), partner| {
            let pair = (nodes.get(place), nodes.get(partner.place));
            let ((Some(k), Some(l)), Some(rates)) = (pair, last.get_mut(id as usize)) else {
                return;
            };
            let n = partner.r.map(|r| r * inverse);
            let apart = partner.apart(law, law.first.scale);
            let factor = (k.node.weight * l.node.weight) * law.first.factor(&apart);
            // What each wall adds to the flux of the image of a closed one; later walls reflect it.
            let mut added = [[[S::ZERO; D]; P]; D];
            // And to what its share of the direct form conducts.
            let mut conducted = [[S::ZERO; P]; D];
            let (mut node, mut seen) = (*l, l.node);
            for wall in self.walls_of(&partner.image) {
                let closed = law.reflected(&node, &wall);
                let before = seen.value;
                seen = imaged(&seen, &wall, &walls);
                node = law.behind(&node, &wall, &shared);
                let depth = depth(&l.node, &wall);
                let conditions = end_of(&shared, &wall);
                if let (Some(conducted), Some(conditions)) =
                    (conducted.get_mut(wall.axis), conditions)
                {
                    for j in 0..P {
                        let b = k.node.diffusivity[j] + l.node.diffusivity[j];
                        conducted[j] = match conditions[j] {
                            Condition::Flux(flux) => {
                                let twice = depth + depth;
                                -(twice + twice) * flux
                            }
                            _ => b * (seen.value[j] - before[j]),
                        };
                    }
                }
                for flux in added.iter_mut().flatten() {
                    if let Some(component) = flux.get_mut(wall.axis) {
                        *component = -*component;
                    }
                }
                let Some(added) = added.get_mut(wall.axis) else {
                    continue;
                };
                for j in 0..P {
                    for i in 0..D {
                        added[j][i] = node.flux[j][i] - closed.flux[j][i];
                    }
                }
                mark(&mut final_ids, &wall, id);
            }
            for wall in self.walls_of(&partner.image) {
                let (Some(intakes), Some(added), Some(conducted)) = (
                    ledger.wall(wall.axis, wall.end),
                    added.get(wall.axis),
                    conducted.get(wall.axis),
                ) else {
                    continue;
                };
                for j in 0..P {
                    let sum = S::dot(&added[j], &n) + law.share * conducted[j];
                    let term = -(factor * sum);
                    rates.strength[j] += term;
                    intakes[j].add(term);
                }
            }
        });
        // What the share of the direct form exchanges has been paid.
        let own = S::ONE - law.share;
        let shares = ledger.shares;
        for (k, &id) in nodes.iter().zip(cells.order()) {
            let Some(rates) = last.get_mut(id as usize) else {
                continue;
            };
            let node = &k.node;
            self.at_exchanges(&walls, &shares, node, |wall, j, (factor, outside)| {
                let difference = own * (node.value[j] - outside);
                let term = -(node.weight * (factor * difference));
                rates.strength[j] += term;
                if let Some(intakes) = ledger.wall(wall.0, wall.1) {
                    intakes[j].add(term);
                }
            });
        }
        self.settle(&walls, &final_ids, (last, ledger));
    }

    /// Gives what rounding has left of a given flux to one particle.
    #[inline(never)]
    fn settle(
        &self,
        walls: &Walls<S, D, P>,
        final_ids: &[[Option<u32>; 2]; D],
        (last, ledger): (&mut [Register<S, D, P>], &mut Ledger<S, D, P>),
    ) {
        for (axis, (ends, ids)) in numbered(walls.iter().zip(final_ids)) {
            for (end, (conditions, id)) in numbered(ends.iter().zip(ids)) {
                let rates = id.and_then(|id| last.get_mut(id as usize));
                let (Some(rates), Some(intakes)) = (rates, ledger.wall(axis, end)) else {
                    continue;
                };
                for j in 0..P {
                    if let Condition::Flux(flux) = conditions[j]
                        && let Some(whole) = self.whole(axis, flux)
                    {
                        let left = -whole - intakes[j].rate();
                        rates.strength[j] += left;
                        intakes[j].add(left);
                    }
                }
            }
        }
    }
}

/// How far a particle is from a wall.
fn depth<S: Scalar, const D: usize, const P: usize>(
    node: &DiffusionNode<S, D, P>,
    wall: &Wall<S>,
) -> S {
    let x = node.position.get(wall.axis);
    x.map_or(S::ZERO, |&x| (x - wall.position).abs())
}

/// The conditions with the shares of their walls.
fn shared<S: Scalar, const D: usize, const P: usize>(
    walls: &Walls<S, D, P>,
    ledger: &Ledger<S, D, P>,
) -> Walls<S, D, P> {
    let mut shared = *walls;
    for (axis, ends) in numbered(&mut shared) {
        for (end, conditions) in numbered(ends) {
            let share = ledger.share(axis, end).pairs;
            *conditions = conditions.map(|condition| condition.shared(share));
        }
    }
    shared
}

/// Whether no species passes.
fn is_closed<S: Scalar, const P: usize>(conditions: &[Condition<S>; P]) -> bool {
    conditions
        .iter()
        .all(|condition| *condition == Condition::NoFlux)
}

/// Whether something may pass through that wall.
fn passes<S: Scalar, const D: usize, const P: usize>(
    walls: &Walls<S, D, P>,
    wall: &Wall<S>,
) -> bool {
    end_of(walls, wall).is_some_and(|conditions| !is_closed(conditions))
}

/// Remembers a particle that a wall reaches.
fn mark<S, const D: usize>(ids: &mut [[Option<u32>; 2]; D], wall: &Wall<S>, id: u32) {
    let entry = ids
        .get_mut(wall.axis)
        .and_then(|ends| ends.get_mut(wall.end));
    if let Some(entry) = entry {
        *entry = Some(id);
    }
}
