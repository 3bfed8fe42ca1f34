//! A wave vector and an amplitude: what every plane wave is given by.

#[cfg(test)]
mod tests;

use super::error::{Number, finite};

/// A plane wave; which quantity its amplitude is of, the problem says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneWave {
    /// k, radians / length; not zero, and zeros beyond the dimension.
    pub wave_vector: [f64; 3],
    /// Any number.
    pub amplitude: f64,
}

impl PlaneWave {
    /// No wave: amplitude 0, the only one whose wave vector may be zero.
    pub const NONE: Self = Self {
        wave_vector: [0.0; 3],
        amplitude: 0.0,
    };

    /// |k|.
    pub fn wave_number(&self) -> f64 {
        dot(self.wave_vector, self.wave_vector).sqrt()
    }

    /// k/|k|; 0 for no wave.
    pub fn direction(&self) -> [f64; 3] {
        let k = self.wave_number();
        if k > 0.0 {
            self.wave_vector.map(|component| component / k)
        } else {
            [0.0; 3]
        }
    }

    /// A direction across k; 0 for no wave. In the plane k/|k| a quarter turn to the left,
    /// `(-k_y, k_x)/|k|`. In space `e x k / |e x k|` with e the axis along which k is smallest,
    /// the last of equals: the same for a k in the plane.
    pub fn across(&self) -> [f64; 3] {
        let [x, y, z] = self.wave_vector;
        let (a, b, c) = (x.abs(), y.abs(), z.abs());
        let across = if c <= a && c <= b {
            [-y, x, 0.0]
        } else if b <= a {
            [z, 0.0, -x]
        } else {
            [0.0, -z, y]
        };
        let wave = Self {
            wave_vector: across,
            amplitude: 0.0,
        };
        wave.direction()
    }

    /// `k.x - omega t`. Its rounding, 2e-16 of the phase, is that of the wave.
    pub(super) fn phase(&self, position: [f64; 3], frequency: f64, time: f64) -> f64 {
        dot(self.wave_vector, position) - frequency * time
    }

    /// What must hold in a dimension; `names` are those of the wave vector and the amplitude.
    pub(super) fn numbers(&self, names: [&'static str; 2], dimension: usize) -> [Number; 3] {
        let [vector, amplitude] = names;
        let k = self.wave_number();
        let there = k > 0.0 || self.amplitude == 0.0;
        let beyond = self.wave_vector.iter().skip(dimension);
        let stray = beyond.fold(0.0, |most: f64, k| most.max(k.abs()));
        [
            finite(amplitude, self.amplitude),
            (vector, k, "finite and not zero", there),
            (vector, stray, "zero beyond the dimension", stray == 0.0),
        ]
    }
}

/// The scalar product.
pub(in crate::exact) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
