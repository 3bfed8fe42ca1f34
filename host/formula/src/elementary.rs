//! What formulas compute beyond the signs of Rust and the functions of `libm`. A program that is made
//! of a formula holds this very file: it has the bits of the formula.

/// `a^b`: a whole exponent up to 64 is multiplied out.
pub(super) fn power(a: f64, b: f64) -> f64 {
    if !(libm::fabs(b) <= 64.0 && b == libm::floor(b)) {
        return libm::pow(a, b);
    }
    let (mut product, mut square, mut left) = (1.0, a, libm::fabs(b) as u32);
    while left > 0 {
        if left % 2 == 1 {
            product *= square;
        }
        square *= square;
        left /= 2;
    }
    if b < 0.0 { 1.0 / product } else { product }
}

/// What a division by b leaves, of the sign of b, so that it is periodic: `x % 1` is a saw.
pub(super) fn remainder(a: f64, b: f64) -> f64 {
    a - b * libm::floor(a / b)
}

/// The smaller of two. A NaN is kept: `f64::min` would hide it.
pub(super) fn minimum(a: f64, b: f64) -> f64 {
    if a.is_nan() || a < b { a } else { b }
}

/// The larger of two; a NaN is kept.
pub(super) fn maximum(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// -1, 0 or 1; 0 at 0, where `signum` is 1, and for a NaN.
pub(super) fn sign(a: f64) -> f64 {
    truth(a > 0.0) - truth(a < 0.0)
}

/// 1 where something holds, else 0.
pub(super) fn truth(holds: bool) -> f64 {
    if holds { 1.0 } else { 0.0 }
}

/// The second where the first is not 0, else the third.
pub(super) fn choice(condition: f64, a: f64, b: f64) -> f64 {
    if condition == 0.0 { b } else { a }
}
