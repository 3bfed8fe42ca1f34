//! Sine and cosine of angles in turns, from `+ - * /` alone: the same code for every scalar, so
//! that velocity fields and initial states do not depend on a mathematics library.

use super::Scalar;

/// Of a polynomial of degree 18.
const TERMS: usize = 10;

/// `sin(2π x)`; in f64 within 2e-15 for `|x| < 1`, else within the rounding of `x`.
pub fn sine_of_turns<S: Scalar>(x: S) -> S {
    let sign = if x < S::ZERO { -S::ONE } else { S::ONE };
    let mut turns = x.abs();
    turns -= S::count(turns.cells(S::ONE));
    let half = S::ONE.half();
    let sign = if turns < half { sign } else { -sign };
    if !(turns < half) {
        turns -= half;
    }
    let quarter = half.half();
    if quarter < turns {
        turns = half - turns;
    }
    // At most an eighth of a turn, in units of it: 0 to 1.
    let eighth = quarter.half();
    if turns < eighth {
        sign * odd(turns / eighth)
    } else {
        sign * even((quarter - turns) / eighth)
    }
}

/// `cos(2π x)`.
pub fn cosine_of_turns<S: Scalar>(x: S) -> S {
    sine_of_turns(x + S::ONE.half().half())
}

/// `sin(π/4 y)`, `0 <= y <= 1`: Taylor's polynomial of degree 17, off by less than 1e-18.
fn odd<S: Scalar>(y: S) -> S {
    y * series(y, const { &coefficients(1) })
}

/// `cos(π/4 y)`, `0 <= y <= 1`: of degree 18.
fn even<S: Scalar>(y: S) -> S {
    series(y, const { &coefficients(0) })
}

/// Of Taylor's polynomial in the square of `y`: `(-1)ʲ (π/4)^(2j+first) / (2j+first)!`.
const fn coefficients(first: u32) -> [f64; TERMS] {
    let eighth = core::f64::consts::FRAC_PI_4;
    let mut coefficients = [0.0; TERMS];
    let mut coefficient = if first == 0 { 1.0 } else { eighth };
    let mut j = 0;
    while j < TERMS {
        coefficients[j] = coefficient;
        let n = 2 * j as u32 + first;
        coefficient *= -eighth * eighth / ((n + 1) * (n + 2)) as f64;
        j += 1;
    }
    coefficients
}

/// `Σ_j c_j y^(2j)`.
#[inline(always)]
fn series<S: Scalar>(y: S, coefficients: &[f64; TERMS]) -> S {
    let square = y * y;
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = *coefficients;
    // Not a loop: it would make the numbers of the format from the coefficients at every call.
    let step = |sum: S, coefficient| sum * square + S::from_f64(coefficient);
    let sum = step(step(step(S::ZERO, c9), c8), c7);
    let sum = step(step(step(sum, c6), c5), c4);
    step(step(step(step(sum, c3), c2), c1), c0)
}
