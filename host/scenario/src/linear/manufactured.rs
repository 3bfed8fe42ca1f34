//! Manufactured solutions: the user says what `u(x,t)` is, and `f` is made so that it solves the equation.

use motes_formula::Formula;

use super::{Conductor, ConvectionDiffusion, Reaction, System};
use crate::Domain;

/// The system with the source that makes `state` its solution, and that source where it is not a part
/// of the system.
pub(super) fn made(
    system: System,
    state: &[Formula],
    domain: &Domain,
) -> (System, Option<Vec<Formula>>) {
    if let System::ConvectionDiffusion(of) = system {
        let rates = rates(&of, state, domain);
        let of = ConvectionDiffusion {
            reaction: Reaction::Formula { rates },
            ..*of
        };
        return (System::ConvectionDiffusion(Box::new(of)), None);
    }
    let source = system.coefficients(domain).map(|of| of.source(state));
    match (system, source) {
        // What the system has itself is left out.
        (
            System::Transport {
                velocity, decay, ..
            },
            source,
        ) => {
            let system = System::Transport {
                velocity,
                decay,
                source: 0.0,
            };
            (system, source)
        }
        (system, source) => (system, source),
    }
}

/// `f(x,t,u) = ∂w/∂t + div(a w) - div(b T grad w) + R(u) - R(w)` for a solution w.
fn rates(of: &ConvectionDiffusion, state: &[Formula], domain: &Domain) -> Vec<Formula> {
    const TIME: usize = 3;
    let dimension = domain.sides.len();
    let zero = || Formula::constant(0.0);
    let velocity = of.velocity.formulas(domain);
    let rate = |j: usize| {
        let (w, b) = (&state[j], conductivity(of, j));
        let mut rate = w.derivative(TIME);
        for (axis, a) in velocity.iter().enumerate() {
            let along = (0..dimension).fold(zero(), |sum, i| {
                let t = of
                    .tensor
                    .as_ref()
                    .map_or(f64::from(u8::from(i == axis)), |rows| rows[axis][i]);
                &sum + &(&Formula::constant(t) * &w.derivative(i))
            });
            let flux = &(a * w) - &(&b * &along);
            rate = &rate + &flux.derivative(axis);
        }
        rate
    };
    // The unknowns of a reaction stand behind place and time.
    let known = (0..=TIME).map(Formula::variable);
    let known: Vec<Formula> = known.chain(state.iter().cloned()).collect();
    let reactions = reactions(&of.reaction, state.len());
    let reactions = reactions.iter().map(|of| of - &of.with(&known));
    (0..state.len())
        .map(rate)
        .zip(reactions)
        .map(|(rate, of)| &rate + &of)
        .collect()
}

/// `b` of a species.
fn conductivity(of: &ConvectionDiffusion, species: usize) -> Formula {
    let constant = Formula::constant;
    let b = constant(of.diffusivity[species]);
    let b = match &of.profile {
        Conductor::Formula { diffusivity } => return diffusivity[species].clone(),
        Conductor::Uniform => b,
        Conductor::Parabola { center, radius } => {
            let arm = &(&Formula::variable(0) - &constant(*center)) * &constant(1.0 / radius);
            let inside = &constant(1.0) - &(&arm * &arm);
            &b * &inside.maximum(&constant(0.0))
        }
        // Refused: what a jump of b does to a smooth state, no formula says.
        Conductor::Layers { .. } => b,
    };
    match of.modulation {
        None => b,
        Some(modulation) => {
            let angle = &constant(modulation.rate) * &Formula::variable(3);
            let swing = &constant(modulation.amplitude) * &angle.sine();
            &b * &(&constant(1.0) + &swing)
        }
    }
}

/// `R(u)`, with the unknowns behind place and time.
fn reactions(of: &Reaction, species: usize) -> Vec<Formula> {
    let constant = Formula::constant;
    let u = |j: usize| Formula::variable(4 + j);
    match of {
        Reaction::None => vec![constant(0.0); species],
        Reaction::Linear { matrix, source } => {
            let row = |i: usize| {
                (0..species).fold(constant(source[i]), |sum, j| {
                    &sum + &(&constant(matrix[i * species + j]) * &u(j))
                })
            };
            (0..species).map(row).collect()
        }
        Reaction::Logistic { rate, capacity } => {
            let grown = |j: usize| {
                let room = &constant(1.0) - &(&constant(1.0 / capacity) * &u(j));
                &(&constant(*rate) * &u(j)) * &room
            };
            (0..species).map(grown).collect()
        }
        Reaction::GrayScott { feed, kill } => {
            let turned = &u(0) * &(&u(1) * &u(1));
            let fed = &constant(*feed) * &(&constant(1.0) - &u(0));
            let drained = &constant(feed + kill) * &u(1);
            vec![&fed - &turned, &turned - &drained]
        }
        Reaction::Formula { rates } => rates.clone(),
    }
}
