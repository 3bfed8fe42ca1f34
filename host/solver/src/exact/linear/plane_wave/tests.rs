//! Directions.

use super::*;

fn wave(wave_vector: [f64; 3]) -> PlaneWave {
    PlaneWave {
        wave_vector,
        amplitude: 1.0,
    }
}

/// Products of unit vectors, each good to 2e-16.
#[test]
fn the_direction_across_is_a_unit_vector_across() {
    let vectors = [
        [3.0, -1.0, 2.0],
        [0.1, 5.0, 1.0],
        [-1.0, 0.2, 7.0],
        [1.0, 1.0, 1.0],
        [0.0, 0.0, -2.0],
        [2.0, 0.0, 0.0],
    ];
    for vector in vectors {
        let across = wave(vector).across();
        assert!(dot(across, wave(vector).direction()).abs() < 5e-16);
        assert!((dot(across, across) - 1.0).abs() < 5e-16);
    }
}

#[test]
fn in_the_plane_it_is_a_quarter_turn_to_the_left() {
    assert_eq!(wave([3.0, 4.0, 0.0]).across(), [-0.8, 0.6, 0.0]);
    assert_eq!(wave([0.0, -2.0, 0.0]).across(), [1.0, 0.0, 0.0]);
    assert_eq!(wave([2.0, 0.0, 0.0]).across(), [0.0, 1.0, 0.0]);
}

#[test]
fn no_wave_has_no_direction() {
    assert_eq!(PlaneWave::NONE.direction(), [0.0; 3]);
    assert_eq!(PlaneWave::NONE.across(), [0.0; 3]);
}
