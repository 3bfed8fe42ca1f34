//! How the difference falls with the bits behind the point, and which formats are fine enough.

use crate::study::PowerLaw;

/// A format of which the difference from the reference is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Loss {
    /// Name of the format.
    pub scalar: String,
    /// Whether it is fixed point.
    pub is_fixed: bool,
    /// Its bits behind the point at 1.
    pub bits: u32,
    /// Its relative difference.
    pub difference: f64,
}

/// By how many bits the reference has to be finer than a format, for the difference to be the rounding
/// of the format alone: a part of 2^-8 of it is that of the reference.
const FINER: u32 = 8;

/// The part of the error of the method that rounding may have and be no matter.
const PART: f64 = 0.1;

/// `difference = factor 2^(slope bits)` over the fixed-point formats, and the error of the method that
/// is below it.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Rounding {
    /// The formats that the line is drawn through.
    pub formats: Vec<String>,
    /// Its slope, in bits of difference a bit; -1 where each bit halves it. `None` with fewer than two
    /// formats.
    pub slope: Option<f64>,
    /// The difference of the line at 0 bits; `None` likewise.
    pub factor: Option<f64>,
    /// How far the formats lie off the line at the most, in bits: what it says is good to so many. `None`
    /// likewise.
    pub off: Option<f64>,
    /// The error of the reference against the exact solution, relative as the differences are: what no
    /// format gets below; `None` without one.
    pub floor: Option<f64>,
    /// Bits from which on the line is below a tenth of the floor; `None` without either.
    pub enough_bits: Option<f64>,
    /// The formats of the list, floats too, that differ by less than a tenth of the floor: in their order.
    pub enough: Vec<String>,
}

impl Rounding {
    /// Through the fixed-point formats that are some bits coarser than the reference.
    pub fn new(points: &[Loss], reference_bits: u32, floor: Option<f64>) -> Self {
        let coarse = |point: &&Loss| {
            point.is_fixed && point.bits + FINER <= reference_bits && point.difference > 0.0
        };
        let taken: Vec<&Loss> = points.iter().filter(coarse).collect();
        let pairs: Vec<(f64, f64)> = taken
            .iter()
            .map(|point| (step(point.bits), point.difference))
            .collect();
        let line = (pairs.len() > 1).then(|| PowerLaw::fit(&pairs)).flatten();
        let floor = floor.filter(|floor| *floor > 0.0);
        let enough_bits = line.zip(floor).and_then(|(line, floor)| {
            let bits = (line.factor / (PART * floor)).log2() / line.exponent;
            (line.exponent > 0.0 && bits.is_finite()).then_some(bits)
        });
        let off = |line: PowerLaw| {
            let off = pairs
                .iter()
                .map(|(step, found)| (found / line.at(*step)).log2());
            off.fold(0.0, |most, off| off.abs().max(most))
        };
        let enough = |floor: f64| {
            let points = points.iter();
            let fine = points.filter(move |point| point.difference <= PART * floor);
            fine.map(|point| point.scalar.clone())
        };
        Self {
            formats: taken.iter().map(|point| point.scalar.clone()).collect(),
            slope: line.map(|line| -line.exponent),
            factor: line.map(|line| line.factor),
            off: line.map(off),
            floor,
            enough_bits,
            enough: floor.into_iter().flat_map(enough).collect(),
        }
    }

    /// The line over the step of a format at 1.
    pub fn line(&self) -> Option<PowerLaw> {
        let (factor, slope) = self.factor.zip(self.slope)?;
        Some(PowerLaw {
            factor,
            exponent: -slope,
        })
    }
}

/// The step of a format at 1.
pub fn step(bits: u32) -> f64 {
    0.5f64.powi(bits as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn loss(scalar: &str, bits: u32, difference: f64) -> Loss {
        Loss {
            scalar: scalar.to_owned(),
            is_fixed: scalar.starts_with('q'),
            bits,
            difference,
        }
    }

    #[test]
    fn a_difference_that_halves_with_each_bit_has_slope_minus_one() {
        let formats = [("q19.12", 12), ("q15.16", 16), ("q12.19", 19)];
        let mut points: Vec<Loss> = formats
            .map(|(name, bits)| loss(name, bits, 3.0 * step(bits)))
            .to_vec();
        // Neither a float nor what is as fine as the reference is on the line.
        points.push(loss("f32", 23, 7e-4));
        points.push(loss("q15.48", 48, 1e-3));
        let rounding = Rounding::new(&points, 52, Some(1e-3));
        assert_eq!(rounding.formats, ["q19.12", "q15.16", "q12.19"]);
        assert!((rounding.slope.unwrap() + 1.0).abs() < 1e-12);
        assert!((rounding.factor.unwrap() - 3.0).abs() < 1e-9);
        assert!(rounding.off.unwrap() < 1e-9);
        // 3 * 2^-bits = 1e-4.
        assert!((rounding.enough_bits.unwrap() - 3e4f64.log2()).abs() < 1e-9);
        assert_eq!(rounding.enough, ["q15.16", "q12.19"]);
    }

    #[test]
    fn the_line_says_how_far_the_formats_lie_off_it() {
        // The middle one of three at equal distances is 1.5 bits too large: the line of least squares lies
        // half a bit above the others, one below it.
        let formats = [
            ("q19.12", 12, 1.0),
            ("q15.16", 16, 1.5f64.exp2()),
            ("q11.20", 20, 1.0),
        ];
        let points = formats.map(|(name, bits, factor)| loss(name, bits, factor * step(bits)));
        let rounding = Rounding::new(&points, 52, None);
        assert!((rounding.slope.unwrap() + 1.0).abs() < 1e-12);
        assert!((rounding.off.unwrap() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn without_formats_there_is_no_line_and_without_a_solution_no_floor() {
        let one = [loss("q15.16", 16, 1e-4)];
        let rounding = Rounding::new(&one, 52, None);
        assert_eq!((rounding.slope, rounding.enough_bits), (None, None));
        assert!(rounding.enough.is_empty() && rounding.floor.is_none());
        assert_eq!(rounding.line(), None);
        // Equal to the bit.
        let same = [loss("q15.16", 16, 0.0), loss("q12.19", 19, 0.0)];
        let rounding = Rounding::new(&same, 52, Some(1e-3));
        assert_eq!(rounding.slope, None);
        assert_eq!(rounding.enough.len(), 2);
    }
}
