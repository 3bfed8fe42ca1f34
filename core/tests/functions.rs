//! Coefficients that are functions: where they are looked at before a run, and systems made of them.

use motes_core::cloud::{Particle, Place, Still};
use motes_core::cutoff::QuinticSpline;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::diffusion::{Condition, Corners, LargestDiffusivity};
use motes_core::equation::linear::systems::{Matrices, MatrixField, VariableMatrices};
use motes_core::equation::linear::{
    Addition, FirstOrderSystem, LinearDynamics, LinearStorage, Sourced,
};
use motes_core::integrator::{RK4, Stepper};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;

const N: usize = 32;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

#[test]
fn every_corner_and_middle_is_looked_at_once() {
    let corners = Corners {
        dimension: 2,
        species: 1,
        middle: [1.0, -2.0, 0.0],
        half: [0.5, 2.0, 0.0],
        duration: 6.0,
    };
    let mut seen = Vec::new();
    corners.each(10.0, |point| seen.push(*point));
    let mut expected = Vec::new();
    for u in [-10.0, 0.0, 10.0] {
        for t in [0.0, 3.0, 6.0] {
            for y in [-4.0, -2.0, 0.0] {
                for x in [0.5, 1.0, 1.5] {
                    expected.push([x, y, 0.0, t, u, 0.0, 0.0, 0.0]);
                }
            }
        }
    }
    assert_eq!(seen, expected);
}

#[test]
fn headroom_is_what_is_yet_to_come_over_what_may_be_now() {
    let peaks = |values| LargestDiffusivity {
        values,
        duration: 3.0,
        margin: 1.5,
    };
    let risen = peaks(&[1.0, 2.0, 4.0, 3.0]);
    for (time, headroom) in [(0.0, 4.0), (2.0, 1.0), (2.5, 4.0 / 3.0), (9.0, 1.0)] {
        assert_eq!(risen.headroom(time), 1.5 * headroom, "at {time}");
    }
    assert_eq!(peaks(&[]).headroom(1.0), 1.0);
    assert_eq!(peaks(&[0.0, 1.0]).headroom(0.0), 1.5);
}

#[test]
fn a_condition_with_another_number_is_of_the_same_kind() {
    let outside = |outside| Condition::Exchange { rate: 2.0, outside };
    assert_eq!(Condition::NoFlux.with(3.0), Condition::NoFlux);
    assert_eq!(Condition::Value(1.0).with(3.0), Condition::Value(3.0));
    assert_eq!(Condition::Flux(1.0).with(3.0), Condition::Flux(3.0));
    assert_eq!(outside(1.0).with(3.0), outside(3.0));
}

/// Sound: `A = [[0, 1], [1, 0]]`, with friction.
struct Sound;

impl MatrixField<f64, 1, 2> for Sound {
    fn flux(&self, _: &Place<f64, 1>) -> [[[f64; 2]; 2]; 1] {
        [[[0.0, 1.0], [1.0, 0.0]]]
    }
    fn decay(&self, _: &Place<f64, 1>, u: &[f64; 2]) -> [f64; 2] {
        [0.0, 0.1 * u[1]]
    }
}

/// A wave after a while.
fn run<F: FirstOrderSystem<f64, 1, 2>>(system: F) -> Vec<[f64; 2]> {
    let mut storage = LinearStorage::<f64, F::Medium, 1, 2, N, CELLS>::new();
    for k in 0..N {
        let x = k as f64 + 0.5;
        let value = [(std::f64::consts::TAU * x / N as f64).sin(), 0.0];
        let particle = Particle {
            position: [x],
            weight: 1.0,
            value,
        };
        storage.push(particle).unwrap();
    }
    let domain = Domain {
        axes: [Axis::periodic(0.0, N as f64)],
    };
    let dynamics = LinearDynamics::new(domain, (QuinticSpline, 1.5), system, Still, 0.5);
    let mut run = Stepper::new(dynamics, RK4, HalfLoop, storage).unwrap();
    run.step = Some(0.25);
    run.advance_to(8.0).unwrap();
    run.state().value.to_vec()
}

/// Matrices that happen to be the same everywhere are those of the system that knows it: (1.18) with
/// `B_k u_l + B_l u_k` is that with `B (u_k + u_l)` to rounding.
#[test]
fn matrices_of_place_that_are_constant_are_constant_matrices() {
    let varied = run(VariableMatrices {
        matrices: Sound,
        speed: 1.0,
        damping: 0.1,
    });
    let constant = Matrices {
        flux: [[[0.0, 1.0], [1.0, 0.0]]],
        decay: [[0.0, 0.0], [0.0, 0.1]],
        symmetriser: [[1.0, 0.0], [0.0, 1.0]],
        speed: 1.0,
        damping: 0.1,
        growth: 0.0,
    };
    let plain = run(constant.rounded::<f64>());
    let moved = plain.iter().map(|u| u[1].abs()).fold(0.0, f64::max);
    assert!(moved > 0.3, "{moved}");
    for (varied, plain) in varied.iter().zip(&plain) {
        for (a, b) in varied.iter().zip(plain) {
            assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
    }
}

/// `f = (1, 0)`.
struct Rain;

impl Addition<f64, 1, 2> for Rain {
    fn add(&self, _: &Place<f64, 1>, rates: &mut [f64; 2]) {
        rates[0] += 1.0;
    }
}

/// Of a linear system with a constant source the first component rises by `f t`, everywhere alike.
#[test]
fn a_source_beside_a_system_is_added() {
    let system = || VariableMatrices {
        matrices: Sound,
        speed: 1.0,
        damping: 0.1,
    };
    let without = run(system());
    let with = run(Sourced {
        system: system(),
        source: Rain,
    });
    for (with, without) in with.iter().zip(&without) {
        assert!(
            (with[0] - without[0] - 8.0).abs() < 1e-12,
            "{with:?} {without:?}"
        );
        assert!((with[1] - without[1]).abs() < 1e-12, "{with:?} {without:?}");
    }
    let place = Place {
        position: [0.0],
        time: 0.0,
    };
    let none: Sourced<_, Option<Rain>> = Sourced {
        system: system(),
        source: None,
    };
    assert_eq!(none.source(&place), [0.0, 0.0]);
}
