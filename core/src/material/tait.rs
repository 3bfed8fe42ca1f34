//! Tait's law: a weakly compressible liquid.

use super::EquationOfState;
use crate::scalar::Scalar;

/// `p = B ((ρ/ρ0)^n - 1)`, `B = ρ0 c0²/n`, `c² = c0² (ρ/ρ0)^(n-1)`; n a whole number >= 1, 7
/// for water (Monaghan, J. Comp. Phys. 110, 399, 1994). The internal energy plays no part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tait<S> {
    inverse_density: S,
    sound_speed: S,
    stiffness: S,
    exponent: u32,
}

impl<S: Scalar> Tait<S> {
    /// A liquid with rest density `ρ0` > 0, sound speed `c0` > 0 at rest, and exponent `n`; 1 where
    /// it is 0. The work of a power is bounded whatever `n` is: see [`Scalar::powi`].
    pub fn new(density: f64, sound_speed: f64, exponent: u32) -> Self {
        let exponent = exponent.max(1);
        Self {
            inverse_density: S::from_f64(1.0 / density),
            sound_speed: S::from_f64(sound_speed),
            stiffness: S::from_f64(density * sound_speed * sound_speed / f64::from(exponent)),
            exponent,
        }
    }
}

impl<S: Scalar> EquationOfState<S> for Tait<S> {
    #[inline]
    fn pressure(&self, density: S, _: S) -> S {
        let ratio = density * self.inverse_density;
        self.stiffness * (ratio.powi(self.exponent as usize) - S::ONE)
    }

    #[inline]
    fn sound_speed(&self, density: S, _: S) -> S {
        let ratio = density * self.inverse_density;
        self.sound_speed * ratio.powi(self.exponent as usize - 1).sqrt()
    }

    fn largest(&self, [_, density]: [f64; 2], _: f64) -> f64 {
        let ratio = density * self.inverse_density.to_f64();
        let power = Scalar::powi(ratio.max(1.0), self.exponent as usize);
        power.max((power + 1.0) * self.stiffness.to_f64())
    }

    fn feels_energy(&self) -> bool {
        false
    }
}
