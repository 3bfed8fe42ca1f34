//! How large the shape of a cut-off is.

use super::CutOff;
use crate::scalar::Scalar;

/// Bounds of the magnitudes of a shape and of its derivatives, `q` from 0 to the support.
///
/// The largest of nine values, and a quarter more: a test of all cut-offs holds that to be enough.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peaks {
    /// Of `z`.
    pub value: f64,
    /// Of `F`.
    pub gradient: f64,
    /// Of `q F = z'`.
    pub slope: f64,
    /// Of `q² F`.
    pub first: f64,
    /// Of `z''`; 0 where it was not asked for.
    pub curvature: f64,
    /// Of `q² (F + z'')`; 0 where it was not asked for.
    pub second: f64,
}

impl Peaks {
    /// Those of a cut-off; made in `S`, which a device without `f64` does sooner.
    pub fn of<S: Scalar, C: CutOff, const D: usize>(cut_off: C, curved: bool) -> Self {
        const POINTS: u32 = 8;
        let step = S::count(cut_off.support()) / S::count(POINTS);
        let scale = cut_off.scale(S::ONE);
        let mut peaks = [S::ZERO; 6];
        for i in 0..=POINTS {
            let q = S::count(i) * step;
            let squared = q * q;
            let a = cut_off.argument(squared) * scale;
            let slope = cut_off.gradient::<D, S>(a);
            let mut values = [
                cut_off.value::<D, S>(a),
                slope,
                q * slope,
                squared * slope,
                S::ZERO,
                S::ZERO,
            ];
            if curved {
                let curvature = cut_off.curvature::<D, S>(a);
                values[4] = curvature;
                values[5] = squared * (slope + curvature);
            }
            for (peak, value) in peaks.iter_mut().zip(values) {
                *peak = peak.greater(value.abs());
            }
        }
        let [value, gradient, slope, first, curvature, second] =
            peaks.map(|peak| 1.25 * peak.to_f64());
        Self {
            value,
            gradient,
            slope,
            first,
            curvature,
            second,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cutoff::Named;

    #[test]
    fn no_cut_off_exceeds_its_peaks() {
        fn check<const D: usize>() {
            for name in Named::NAMES {
                let cut_off = Named::from_name(name).unwrap();
                let peaks = Peaks::of::<f64, _, D>(cut_off, true);
                for i in 0..=3000 {
                    let q = f64::from(i) / 3000.0 * f64::from(cut_off.support());
                    let a = cut_off.argument(q * q) * cut_off.scale(1.0);
                    let (f, z) = (
                        cut_off.gradient::<D, f64>(a),
                        cut_off.curvature::<D, f64>(a),
                    );
                    for (what, value, peak) in [
                        ("z", cut_off.value::<D, f64>(a), peaks.value),
                        ("F", f, peaks.gradient),
                        ("q F", q * f, peaks.slope),
                        ("q^2 F", q * q * f, peaks.first),
                        ("z''", z, peaks.curvature),
                        ("q^2 (F + z'')", q * q * (f + z), peaks.second),
                    ] {
                        assert!(
                            value.abs() <= peak,
                            "{name} {D}D q = {q}: {what} {value} {peak}"
                        );
                    }
                }
            }
        }
        check::<1>();
        check::<2>();
        check::<3>();
    }
}
