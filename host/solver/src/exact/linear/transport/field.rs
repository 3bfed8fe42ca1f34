//! Velocity fields whose paths have a closed form.

use std::f64::consts::PI;

use super::super::error::{Number, dimension_up_to, finite, positive};

/// A velocity that does not change with time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Field {
    /// v = 0.
    Still,
    /// The same everywhere.
    Uniform {
        /// v.
        velocity: [f64; 3],
    },
    /// `v = rate (-(y - c_y), x - c_x, 0)`: a rigid rotation about the z axis through c.
    Rotation {
        /// Radians / time, counterclockwise if > 0.
        rate: f64,
        /// c.
        center: [f64; 3],
    },
    /// `v = (rate (y - c_y), 0, 0)`.
    Shear {
        /// 1 / time.
        rate: f64,
        /// c, of which only y matters.
        center: [f64; 3],
    },
    /// `v = -rate (x - c)` in the first directions, 0 in the others; `div v = -rate dimension`.
    Compression {
        /// 1 / time; an expansion if < 0.
        rate: f64,
        /// c.
        center: [f64; 3],
        /// How many directions, 1 to 3.
        dimension: usize,
    },
    /// `v_x = amplitude sin theta`, `theta = 2 pi (x - lower) / length`. Along a path
    /// `tan(theta/2)` grows as `exp(2 pi amplitude t / length)`.
    Wave {
        /// The largest velocity.
        amplitude: f64,
        /// Where theta = 0.
        lower: f64,
        /// Of the wave, > 0.
        length: f64,
    },
}

/// A place in [`Field::Wave`]: the whole lengths below it and half the angle beyond them,
/// `theta/2` in [-pi/2, pi/2].
fn half_angle(x: f64, lower: f64, length: f64) -> (f64, f64) {
    let phase = (x - lower) / length;
    let whole = libm::round(phase);
    (whole, PI * (phase - whole))
}

impl Field {
    /// v at a place.
    pub fn velocity(&self, position: [f64; 3]) -> [f64; 3] {
        let [x, y, _] = position;
        match *self {
            Self::Still => [0.0; 3],
            Self::Uniform { velocity } => velocity,
            Self::Rotation { rate, center } => {
                [-rate * (y - center[1]), rate * (x - center[0]), 0.0]
            }
            Self::Shear { rate, center } => [rate * (y - center[1]), 0.0, 0.0],
            Self::Compression {
                rate,
                center,
                dimension,
            } => scaled(position, center, dimension, -rate),
            Self::Wave {
                amplitude,
                lower,
                length,
            } => {
                let (_, half) = half_angle(x, lower, length);
                [amplitude * libm::sin(2.0 * half), 0.0, 0.0]
            }
        }
    }

    /// div v at a place; uniform in every field but [`Field::Wave`].
    pub fn divergence(&self, position: [f64; 3]) -> f64 {
        match *self {
            Self::Compression {
                rate, dimension, ..
            } => -rate * dimension as f64,
            Self::Wave {
                amplitude,
                lower,
                length,
            } => {
                let (_, half) = half_angle(position[0], lower, length);
                2.0 * PI * amplitude / length * libm::cos(2.0 * half)
            }
            _ => 0.0,
        }
    }

    /// Where that is at t = 0 which the flow carries to a place by a time.
    pub fn foot(&self, position: [f64; 3], time: f64) -> [f64; 3] {
        let [x, y, z] = position;
        match *self {
            Self::Still => position,
            Self::Uniform { velocity } => {
                std::array::from_fn(|axis| position[axis] - velocity[axis] * time)
            }
            Self::Rotation { rate, center } => {
                let (sine, cosine) = (libm::sin(rate * time), libm::cos(rate * time));
                let (a, b) = (x - center[0], y - center[1]);
                let turned = [cosine * a + sine * b, cosine * b - sine * a];
                [center[0] + turned[0], center[1] + turned[1], z]
            }
            Self::Shear { rate, center } => [x - rate * (y - center[1]) * time, y, z],
            Self::Compression {
                rate,
                center,
                dimension,
            } => {
                let growth = libm::expm1(rate * time);
                let back = scaled(position, center, dimension, growth);
                std::array::from_fn(|axis| position[axis] + back[axis])
            }
            Self::Wave {
                amplitude,
                lower,
                length,
            } => {
                let (whole, half) = half_angle(x, lower, length);
                let root = libm::exp(PI * amplitude * time / length);
                // tan(theta_0/2) = tan(theta/2) / root^2, without the poles of tan.
                let before = libm::atan2(libm::sin(half) / root, libm::cos(half) * root);
                [lower + length * (whole + before / PI), y, z]
            }
        }
    }

    /// `J = det dx/dX` from t = 0 to a time at the place x then.
    pub fn jacobian(&self, position: [f64; 3], time: f64) -> f64 {
        match *self {
            Self::Compression { .. } => libm::exp(self.divergence(position) * time),
            Self::Wave {
                amplitude,
                lower,
                length,
            } => {
                let (_, half) = half_angle(position[0], lower, length);
                let (sine, cosine) = (libm::sin(half), libm::cos(half));
                let growth = libm::exp(2.0 * PI * amplitude * time / length);
                cosine * cosine * growth + sine * sine / growth
            }
            _ => 1.0,
        }
    }

    /// Whether the velocity repeats along an axis, 0 to 2, after a length. A velocity wave: after
    /// whole wavelengths, to 1e-12 of them.
    pub fn has_period(&self, axis: usize, period: f64) -> bool {
        match *self {
            Self::Still | Self::Uniform { .. } => true,
            Self::Rotation { .. } => axis == 2,
            Self::Shear { .. } => axis != 1,
            Self::Compression { dimension, .. } => axis >= dimension,
            Self::Wave { length, .. } => {
                let waves = period / length;
                let whole = libm::round(waves);
                axis != 0 || (whole >= 1.0 && (waves - whole).abs() <= 1e-12 * whole)
            }
        }
    }

    /// What must hold.
    pub(in crate::exact) fn numbers(&self) -> Vec<Number> {
        let vector = |name, [x, y, z]: [f64; 3]| [x, y, z].map(|value| finite(name, value));
        let about = |rate, center| {
            let center = vector("center of the velocity", center);
            [vec![finite("rate", rate)], center.to_vec()].concat()
        };
        match *self {
            Self::Still => Vec::new(),
            Self::Uniform { velocity } => vector("velocity", velocity).to_vec(),
            Self::Rotation { rate, center } | Self::Shear { rate, center } => about(rate, center),
            Self::Compression {
                rate,
                center,
                dimension,
            } => [about(rate, center), vec![dimension_up_to(dimension, 3)]].concat(),
            Self::Wave {
                amplitude,
                lower,
                length,
            } => vec![
                finite("amplitude of the velocity", amplitude),
                finite("lower end of the velocity", lower),
                positive("length of the velocity", length),
            ],
        }
    }
}

/// `factor (x - center)` in the first directions, 0 in the others.
fn scaled(x: [f64; 3], center: [f64; 3], dimension: usize, factor: f64) -> [f64; 3] {
    std::array::from_fn(|axis| {
        if axis < dimension {
            factor * (x[axis] - center[axis])
        } else {
            0.0
        }
    })
}
