//! What a cut-off sums to over a lattice.

use crate::cutoff::CutOff;
use crate::scalar::Scalar;

/// The lattice of which the density (3.13) is exact: one particle in a unit of volume has density 1.
///
/// `Σ_n z(|n|/η)` over its points, the one at 0 included, differs from the integral `η^D/σ`, most for
/// cut-offs whose value at 0 is large: by 1.0 % for `wendland-c2` with `η = 1.3` in the plane. Particles
/// in other arrangements have densities that are off by what is left, some 0.1 %; those of a glass are
/// nearest to the cubic one's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Packing {
    /// Equal spacings on a line, squares, cubes.
    #[default]
    Cubic,
    /// Equal spacings on a line, triangles, closely packed spheres (face-centred cubic).
    Close,
}

/// The reach of a cut-off, in spacings, beyond which its sum is its integral for all that matters.
const WIDE: f64 = 16.0;

impl Packing {
    /// `Σ_n z(|n|/η)`; the integral `η^D/σ` where the cut-off is wide.
    pub fn sum<S: Scalar, C: CutOff, const D: usize>(self, cut_off: C, eta: S) -> S {
        let reach = S::count(cut_off.support()) * eta;
        if !(eta > S::ZERO && reach < S::from_f64(WIDE).lesser(S::REACH_LIMIT)) {
            return eta.powi(D) / S::from_f64(cut_off.normalisation::<D>());
        }
        let scale = cut_off.scale(S::ONE / eta);
        let value = |r: [S; D]| {
            let argument = cut_off.argument(S::length_squared(&r));
            cut_off.value::<D, S>(argument * scale)
        };
        // Rows of the closest lattice are 0.79 apart.
        let most = (reach + reach.half())
            .cells(S::ONE)
            .saturating_add(1)
            .min(24);
        // Small numbers: nothing wraps, and nothing is divided by 0.
        let side = most.wrapping_mul(2).wrapping_add(1).max(1);
        let mut sum = S::ZERO;
        for number in 0..(0..D).fold(1u32, |points, _| points.saturating_mul(side)) {
            let mut rest = number;
            let mut steps = [0i32; D];
            for step in &mut steps {
                *step = rest.checked_rem(side).unwrap_or(0).wrapping_sub(most) as i32;
                rest = rest.checked_div(side).unwrap_or(0);
            }
            if let Some(place) = self.place(steps) {
                sum += value(place);
            }
        }
        sum
    }

    /// The point that is so many steps along each direction from the one at 0, if there is one.
    fn place<S: Scalar, const D: usize>(self, steps: [i32; D]) -> Option<[S; D]> {
        let plain = steps.map(S::from_i32);
        match (self, D) {
            (Self::Cubic, _) | (_, 0 | 1) => Some(plain),
            (Self::Close, 2) => {
                // Triangles of an area of 1/2: every other row is moved by half a side.
                let side = S::from_f64(1.074_569_931_823_542);
                let height = S::from_f64(0.930_604_859_102_1);
                let mut place = plain;
                if steps[1] % 2 != 0 {
                    place[0] += S::ONE.half();
                }
                (place[0], place[1]) = (place[0] * side, place[1] * height);
                Some(place)
            }
            (Self::Close, _) => {
                // Every other point of a cubic lattice.
                let sum = steps.iter().fold(0i32, |sum, step| sum.wrapping_add(*step));
                let edge = S::from_f64(0.793_700_525_984_1);
                (sum % 2 == 0).then(|| plain.map(|x| x * edge))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cutoff::{CubicSpline, WendlandC2, WendlandC6};
    use crate::scalar::Q32;
    use fixed::types::extra::U19;

    /// By how much the sum exceeds the integral.
    fn excess<C: CutOff, const D: usize>(packing: Packing, cut_off: C, eta: f64) -> f64 {
        let integral = eta.powi(D as i32) / cut_off.normalisation::<D>();
        packing.sum::<f64, C, D>(cut_off, eta) / integral - 1.0
    }

    /// Values of a program of its own, over 25 points in each direction.
    #[test]
    fn sums_exceed_integrals_by_what_they_do() {
        let off = |found: f64, right: f64| {
            assert!(
                (found - right).abs() < 6e-3 * right.abs(),
                "{found} {right}"
            );
        };
        use Packing::{Close, Cubic};
        off(excess::<_, 2>(Cubic, WendlandC2, 1.3), 1.05e-2);
        off(excess::<_, 2>(Close, WendlandC2, 1.3), 8.84e-3);
        off(excess::<_, 3>(Cubic, WendlandC2, 1.3), 9.50e-3);
        off(excess::<_, 3>(Close, WendlandC2, 1.3), 6.80e-3);
        off(excess::<_, 3>(Close, WendlandC6, 2.0), 1.41e-4);
        off(excess::<_, 1>(Cubic, CubicSpline, 1.2), 1.80e-3);
        assert!(excess::<_, 1>(Cubic, CubicSpline, 1.0).abs() < 1e-15);
    }

    /// Wide ones end, and give their integral.
    #[test]
    fn wide_cut_offs_sum_to_their_integral() {
        for eta in [8.5, 1e3, 1e100, f64::NAN] {
            let sum = Packing::Cubic.sum::<f64, _, 2>(WendlandC2, eta);
            let integral = Scalar::powi(eta, 2) / WendlandC2.normalisation::<2>();
            assert_eq!(sum.to_bits(), integral.to_bits(), "{eta}");
        }
        let eta = Q32::<U19>::from_f64(1.3);
        let sum = Packing::Close.sum::<_, _, 3>(WendlandC2, eta).to_f64();
        let exact = Packing::Close.sum::<f64, _, 3>(WendlandC2, 1.3);
        assert!((sum - exact).abs() < 1e-3, "{sum} {exact}");
    }
}
