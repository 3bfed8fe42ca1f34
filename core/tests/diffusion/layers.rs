//! Layers: resistances in series, however thin.

use fixed::types::extra::{U16, U19};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::diffusion::{
    Conductor, DiffusionDynamics, Drive, DrivenCondition, Form, Mean, NamedProblem,
};
use motes_core::equation::linear::{Particle, Still};
use motes_core::integrator::SSP_RK3;
use motes_core::pairs::{HalfLoop, PlainLoop};
use motes_core::scalar::{Q32, Scalar};

use crate::clouds::{fill, line, storage, with_a_large_stack};

const BOUNDS: &[&[f64]] = &[
    // Sheets of a tenth and a fiftieth of a spacing, between particles and around one.
    &[-3.04, -2.94, 4.99, 5.01],
    // At the walls, and several between two particles.
    &[-19.7, -4.3, -4.1, -3.9, -3.8, 19.4],
    &[0.25],
    &[-30.0, 1.0, 2.5, 50.0],
];

/// Between conductors and insulators, up and down.
const FACTORS: &[&[f64]] = &[
    &[1.0, 1e-4, 2.0, 1e-3, 0.5],
    &[1e-3, 1.0, 0.01, 3.0, 1e-5, 1.0, 0.02],
    &[1.0, 100.0],
    &[7.0, 1.0, 30.0, 2.0, 7.0],
];

/// `∫ dx/factor` from -20.
fn resistance(bounds: &[f64], factors: &[f64], x: f64) -> f64 {
    let clip = |x: f64, top: f64| x.clamp(-20.0, top);
    let starts = std::iter::once(f64::NEG_INFINITY).chain(bounds.iter().copied());
    let ends = bounds.iter().copied().chain([f64::INFINITY]);
    let layers = starts.zip(ends).zip(factors);
    let part = |((start, end), factor): ((f64, f64), &f64)| {
        (clip(end, x) - clip(start, x)).max(0.0) / factor
    };
    layers.map(part).sum()
}

/// Through layers of any thickness the profile `flux R(x)` is steady to rounding on a lattice, between
/// walls of every kind: in one and two dimensions.
#[test]
fn the_profile_through_any_layers_is_steady() {
    with_a_large_stack(|| {
        for (bounds, factors) in BOUNDS.iter().zip(FACTORS) {
            let (b, flux, epsilon) = (0.5, 0.01, 1.13);
            let u = |x: f64| 1.0 - flux * resistance(bounds, factors, x) / b;
            let constant = |value: f64| Drive::Constant(value);
            let held = [u(-20.0), u(20.0)].map(|u| DrivenCondition::Value(constant(u)));
            let given = [-flux, flux].map(|flux| DrivenCondition::Flux(constant(flux)));
            let exchange = DrivenCondition::Exchange {
                rate: 0.3,
                outside: constant(u(20.0) - flux / 0.3),
            };
            for ends in [held, given, [given[0], exchange], [held[0], given[1]]] {
                let mut problem = NamedProblem::heat([b]);
                problem.conductor = Conductor::Layers { bounds, factors };
                problem.walls = [[[ends[0]], [ends[1]]]];
                let mut solver = line(40, problem, Form::Direct, epsilon);
                solver.mean = Mean::Harmonic;
                let mut storage = storage::<f64, 1, 64>();
                fill(&mut storage, 40, u);
                let (mut state, mut work) = storage.parts();
                solver
                    .prepare(&mut HalfLoop, &mut state, &mut work)
                    .unwrap();
                for (k, rates) in work.last.iter().take(40).enumerate() {
                    let rate = rates.strength[0] / flux;
                    assert!(rate.abs() < 1e-10, "{bounds:?} {ends:?}, {k}: {rate}");
                }
            }
            let mut problem = NamedProblem::heat([b]);
            problem.conductor = Conductor::Layers { bounds, factors };
            problem.walls[0] = [[given[0]], [held[1]]];
            let solver = DiffusionDynamics {
                domain: Domain {
                    axes: [Axis::walls(-20.0, 20.0), Axis::walls(-4.0, 4.0)],
                },
                cut_off: motes_core::cutoff::Named::QuinticSpline,
                epsilon,
                problem,
                field: Still,
                form: Form::Direct,
                mean: Mean::Harmonic,
                courant: 0.5,
            };
            let mut storage = storage::<f64, 2, 512>();
            for i in 0..320 {
                let [x, y] = [f64::from(i % 40) - 19.5, f64::from(i / 40) - 3.5];
                let particle = Particle {
                    position: [x, y],
                    weight: 1.0,
                    value: [u(x)],
                };
                storage.push(particle).unwrap();
            }
            let (mut state, mut work) = storage.parts();
            solver
                .prepare(&mut HalfLoop, &mut state, &mut work)
                .unwrap();
            for (k, rates) in work.last.iter().take(320).enumerate() {
                let rate = rates.strength[0] / flux;
                assert!(rate.abs() < 1e-10, "2D {bounds:?}, {k}: {rate}");
            }
        }
    });
}

/// What pairs conduct across joints they give and take in equal parts: sums are exact in fixed point,
/// between closed walls and around a ring whose ends are unlike.
#[test]
fn joints_keep_the_sums_and_the_bits() {
    fn check<S: Scalar>(is_ring: bool) {
        let layers = [[-3.04, -2.94, 4.6], [1.0, 0.01, 0.5]].map(|row| row.map(S::from_f64));
        let factors = [layers[1][0], layers[1][1], layers[1][2], S::from_f64(0.1)];
        let bits = |plain: bool| {
            let mut problem = NamedProblem::heat([S::ONE.half()]);
            problem.conductor = Conductor::Layers {
                bounds: &layers[0],
                factors: &factors,
            };
            let mut solver = line(24, problem, Form::Direct, 1.3);
            solver.mean = Mean::Harmonic;
            if is_ring {
                solver.domain.axes = [Axis::periodic(S::from_f64(-12.0), S::from_f64(12.0))];
            }
            let mut storage = storage::<S, 1, 64>();
            fill(&mut storage, 24, |x| (0.7 * x).sin());
            let (mut state, mut work) = storage.parts();
            solver
                .prepare(&mut HalfLoop, &mut state, &mut work)
                .unwrap();
            let first = S::wide_bits(state.total()[0]);
            for _ in 0..12 {
                let step = (S::ZERO, S::from_f64(0.4));
                match plain {
                    true => solver.advance(&SSP_RK3, &mut PlainLoop, &mut state, &mut work, step),
                    false => solver.advance(&SSP_RK3, &mut HalfLoop, &mut state, &mut work, step),
                }
                .unwrap();
            }
            if S::HAS_EXACT_SUMS {
                assert_eq!(S::wide_bits(state.total()[0]), first, "ring: {is_ring}");
            }
            let strengths = state.strength.iter();
            strengths.map(|q| S::wide_bits(q[0])).collect::<Vec<_>>()
        };
        assert_eq!(bits(true), bits(false));
    }
    for is_ring in [false, true] {
        check::<Q32<U19>>(is_ring);
        check::<Q32<U16>>(is_ring);
        check::<f64>(is_ring);
    }
}

/// The way between two places is the same from both ends, between the smallest and the largest `b` on
/// it, and `1/b` averaged.
#[test]
fn the_way_is_resistances_in_a_row() {
    for (bounds, factors) in BOUNDS.iter().zip(FACTORS) {
        let conductor = Conductor::Layers { bounds, factors };
        for (from, to) in [(-19.9, 19.9), (-4.0, -3.0), (0.1, 0.6), (7.0, 7.5)] {
            let way = conductor.between([from, to]).unwrap();
            assert_eq!(way, conductor.between([to, from]).unwrap());
            let resists = resistance(bounds, factors, to) - resistance(bounds, factors, from);
            let expected = (to - from) / resists;
            assert!((way / expected - 1.0).abs() < 1e-10, "{way}, {expected}");
        }
    }
    assert_eq!(Conductor::<f64>::Uniform.between([0.0, 1.0]), None);
}
