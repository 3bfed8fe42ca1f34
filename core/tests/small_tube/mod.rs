//! Sod's tube with 72 particles.

use motes_core::domain::Side;
use motes_core::equation::gas::{Stretch, Tube, Width};

const DENSE: Stretch = Stretch {
    lower: -32.0,
    upper: 0.0,
    particles: 64,
    mass: 0.5,
    velocity: 0.0,
    energy: 1.8,
};

/// Between mirrors, the jump in the middle.
pub const TUBE: Tube = Tube {
    half_length: 32.0,
    sides: [Side::Mirror; 2],
    stretches: &[
        DENSE,
        Stretch {
            lower: 0.0,
            upper: 32.0,
            particles: 8,
            ..DENSE
        },
    ],
    gamma: 1.4,
    width: Width::adaptive(1.2),
    courant: 0.3,
    end: 8.0,
};
