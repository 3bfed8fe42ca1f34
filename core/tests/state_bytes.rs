//! Bytes of a particle that the next step starts from.

use fixed::types::extra::U16;
use motes_core::cloud::Columns;
use motes_core::equation::linear::State;
use motes_core::scalar::{Q32, Scalar};

/// Of so many particles in two dimensions with three unknowns.
fn bytes<S: Scalar>(particles: usize) -> usize {
    let mut position = vec![[S::ZERO; 2]; particles];
    let mut weight = vec![S::ONE; particles];
    let mut strength = vec![[S::product(S::ZERO, S::ZERO); 3]; particles];
    let mut value = vec![[S::ZERO; 3]; particles];
    let mut neighbours = vec![S::ZERO; particles];
    let state = State::<S, 2, 3> {
        position: &mut position,
        weight: &mut weight,
        strength: &mut strength,
        value: &mut value,
        neighbours: &mut neighbours,
    };
    state.state_bytes()
}

/// Position, weight, strength and value; neighbours are made anew.
#[test]
fn what_is_made_anew_does_not_count_and_strengths_are_wide_in_fixed_point() {
    assert_eq!(bytes::<f64>(5), (2 + 1 + 3 + 3) * 8);
    assert_eq!(bytes::<f32>(5), (2 + 1 + 3 + 3) * 4);
    assert_eq!(bytes::<Q32<U16>>(5), (2 + 1 + 3) * 4 + 3 * 8);
    assert_eq!(bytes::<f64>(0), 0);
}
