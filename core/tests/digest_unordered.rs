//! The digest that does not know the order of the particles.

mod small_tube;

use fixed::types::extra::U19;
use motes_core::cutoff::CubicSpline;
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{PlainStorage, Tube};
use motes_core::equation::linear::State;
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;
use motes_core::scalar::{Q32, Scalar};
use small_tube::TUBE;

/// Position, weight and strength of a particle.
type Row = ([f64; 2], f64, [f64; 3]);

fn digests(rows: &[Row]) -> [u64; 2] {
    let mut position: Vec<_> = rows.iter().map(|row| row.0).collect();
    let mut weight: Vec<_> = rows.iter().map(|row| row.1).collect();
    let mut strength: Vec<_> = rows.iter().map(|row| row.2).collect();
    let (mut value, mut neighbours) = (strength.clone(), vec![0.0; rows.len()]);
    let state = State::<f64, 2, 3> {
        position: &mut position,
        weight: &mut weight,
        strength: &mut strength,
        value: &mut value,
        neighbours: &mut neighbours,
    };
    [state.digest().0, state.digest_unordered().0]
}

fn rows() -> Vec<Row> {
    let row = |k: i32| {
        let x = f64::from(k);
        ([0.1 * x, -x], 1.0 + 0.01 * x, [x, 2.0, -0.5 * x])
    };
    (0..7).map(row).collect()
}

#[test]
fn particles_may_change_places_but_not_what_they_have() {
    let rows = rows();
    let first = digests(&rows);
    for turn in 1..rows.len() {
        let mut turned = rows.clone();
        turned.rotate_left(turn);
        turned.swap(0, 3);
        let [ordered, unordered] = digests(&turned);
        assert_ne!(ordered, first[0]);
        assert_eq!(unordered, first[1]);
    }
    // What one has is in its own row: two that exchange a number are two others.
    let mut exchanged = rows.clone();
    (exchanged[1].1, exchanged[4].1) = (rows[4].1, rows[1].1);
    assert_ne!(digests(&exchanged)[1], first[1]);
    // So are two numbers of one.
    let mut swapped = rows.clone();
    swapped[3].2.swap(0, 1);
    assert_ne!(digests(&swapped)[1], first[1]);
    for bit in [0, 51, 63] {
        let mut changed = rows.clone();
        changed[5].2[2] = f64::from_bits(changed[5].2[2].to_bits() ^ (1 << bit));
        assert_ne!(digests(&changed)[1], first[1]);
    }
}

/// A sum, and not an exclusive or: twins count.
#[test]
fn twins_are_counted() {
    let one = rows()[..1].to_vec();
    let sums = [1, 2, 3, 4].map(|count| digests(&one.repeat(count))[1]);
    assert_eq!(sums[1], sums[0].wrapping_add(sums[0]));
    assert!(sums.iter().all(|&sum| sum != 0));
    assert_ne!(sums[1], sums[3]);
    let two = [rows()[1]; 2];
    assert_ne!(digests(&two)[1], sums[1]);
    assert_eq!(digests(&[])[1], 0);
}

/// Both zeros are one, as in the other digest.
#[test]
fn a_zero_has_no_sign() {
    let with = |zero: f64| digests(&[([zero, 1.0], 1.0, [zero, 0.0, zero])]);
    assert_eq!(with(-0.0), with(0.0));
}

/// In fixed point a shuffled cloud goes the same way: its rows have the same bits at the end, in another
/// order.
#[test]
fn in_fixed_point_a_shuffled_gas_has_the_same_digest_after_a_hundred_steps() {
    let digests = [1, 5, 31].map(tube::<Q32<U19>>);
    assert!(digests[0][0] != digests[1][0] && digests[1][0] != digests[2][0]);
    assert_eq!(digests[0][1], digests[1][1]);
    assert_eq!(digests[0][1], digests[2][1]);
}

/// Sod's tube, its particles taken by a stride that has no factor in common with 72.
fn tube<S: Scalar>(stride: usize) -> [u64; 2] {
    const CELLS: usize = cell_bound(72) as usize + 1;
    let tube = Tube { end: 16.0, ..TUBE };
    let mut all = Vec::new();
    let taken = tube.fill::<S>(|particle| {
        all.push(particle);
        Ok(())
    });
    taken.unwrap();
    let mut memory = PlainStorage::<S, 1, 72, CELLS>::new();
    for place in 0..all.len() {
        memory.push(all[place * stride % all.len()]).unwrap();
    }
    let materials = [tube.material()];
    let solver = tube.solver(CubicSpline, Pairwise(Coefficients::usual()), &materials);
    let mut run = Stepper::new(solver, LeapFrog, HalfLoop, memory).unwrap();
    for _ in 0..100 {
        run.step().unwrap();
    }
    let state = run.state();
    [state.digest().0, state.digest_unordered().0]
}
