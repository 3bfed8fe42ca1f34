//! Materials: what pressure and sound speed a density and an internal energy give.
//!
//! Adding one: a file here with an implementation of [`EquationOfState`], and its row in
//! [`Named`].

mod ideal_gas;
mod isothermal;
mod named;
mod stiffened_gas;
mod tait;
#[cfg(test)]
mod tests;

pub use ideal_gas::IdealGas;
pub use isothermal::Isothermal;
pub use named::Named;
pub use stiffened_gas::StiffenedGas;
pub use tait::Tait;

use crate::scalar::Scalar;

/// An equation of state (3.2): `p = p(ρ, e)`, and its sound speed.
pub trait EquationOfState<S: Scalar>: Copy + Send + Sync {
    /// Pressure; `density` in mass per volume, `energy` internal energy per mass.
    fn pressure(&self, density: S, energy: S) -> S;
    /// Sound speed; 0 where its square would be negative.
    fn sound_speed(&self, density: S, energy: S) -> S;
    /// The internal energy where the density goes from the first to the second of two without heat,
    /// `de = p dρ/ρ²`; both > 0.
    ///
    /// A law that does not say it in closed form gets the midpoint rule, which is symmetric: back from
    /// the second density to the first the energy is what it was. What is left out is of the third
    /// order in the difference of the densities.
    fn compressed(&self, [before, after]: [S; 2], energy: S) -> S {
        /// Each adds two digits where the density changes by a per cent.
        const PASSES: usize = 4;
        let passes = if self.feels_energy() { PASSES } else { 1 };
        let density = before.half() + after.half();
        let step = (after - before) / before / after;
        let mut result = energy;
        for _ in 0..passes {
            let middle = energy.half() + result.half();
            result = energy + step * self.pressure(density, middle);
        }
        result
    }
    /// Whether the pressure depends on the internal energy. Where it does not, the energy is
    /// only kept account of, and may fall below 0.
    fn feels_energy(&self) -> bool {
        true
    }
    /// A bound of all that the two make on their way, of densities from the first to the second and
    /// energies up to `energy` in magnitude: what a proof that a format holds them goes by. Infinite
    /// where nothing is said, and such a format then refuses the run.
    fn largest(&self, densities: [f64; 2], energy: f64) -> f64 {
        let _ = (densities, energy);
        f64::INFINITY
    }
}

/// `ln(b/a) = 2 artanh y`, `y = (b-a)/(b+a)`, by its series to `y^13`; exactly opposite for `ln(a/b)`.
///
/// Errors `2/15 y^15`: 1e-16 where the density changes by a fifth in one step.
#[inline]
fn logarithm<S: Scalar>([a, b]: [S; 2]) -> S {
    let difference = b - a;
    // 2 y, not y: doubled, its rounding would be too.
    let double = (difference + difference) / (a + b);
    let y = double.half();
    let square = y * y;
    let mut series = S::ZERO;
    for odd in [13, 11, 9, 7, 5, 3] {
        series = square * (S::from_f64(1.0 / f64::from(odd)) + series);
    }
    double + double * series
}

/// `(b/a)^k - 1` by Padé's approximant [4/4] of the exponential; those of `(b/a)^k` and `(a/b)^k` are one
/// over the other, so that what was compressed expands to what it was.
///
/// With `x = k ln(b/a)`: `2 s/(c - s)`, `s = x/2 (1 + x²/42)`, `c = 1 + 3x²/28 + x⁴/1680`; errors
/// `x^9/25401600`.
#[inline]
fn growth<S: Scalar>(densities: [S; 2], exponent: S) -> S {
    let x = exponent * logarithm(densities);
    let square = x * x;
    // 2 s, not s: in fixed point halves round away from 0, and each step of a slow change would be too large.
    let double = x * (S::ONE + square * S::from_f64(1.0 / 42.0));
    let even = S::ONE + square * (S::from_f64(3.0 / 28.0) + square * S::from_f64(1.0 / 1680.0));
    double / (even - double.half())
}
