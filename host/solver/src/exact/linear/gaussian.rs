//! A Gaussian and its periodic images.

#[cfg(test)]
mod tests;

use super::error::{Number, positive};

/// Widths beyond which a Gaussian is nothing: `exp(-6.3^2) = 6e-18`.
const REACH: f64 = 6.3;

/// Of a periodic sum, in periods: the sum has 13 images a period of width.
const WIDEST: f64 = 100.0;

/// `Σ_n exp(-(distance + n period)^2 / width^2)`, all images within [`REACH`]; the left-out
/// ones are below 1e-17 of the sum. Without a period the one Gaussian.
pub(super) fn gaussian(distance: f64, width: f64, period: Option<f64>) -> f64 {
    let single = |distance: f64| {
        let part = distance / width;
        libm::exp(-part * part)
    };
    let Some(period) = period else {
        return single(distance);
    };
    let nearest = distance - period * libm::round(distance / period);
    // |nearest| <= period/2, so that the first image left out is (count + 1/2) periods away.
    let count = libm::ceil(REACH * width / period - 0.5) as i32;
    (-count..=count)
        .map(|n| single(nearest + f64::from(n) * period))
        .sum()
}

/// What must hold for the width and one period.
pub(super) fn gaussian_numbers(width: f64, period: Option<f64>) -> [Number; 3] {
    let period = period.unwrap_or(f64::MAX);
    let narrow = width <= WIDEST * period;
    [
        positive("width", width),
        positive("period", period),
        ("width", width, "at most 100 periods", narrow),
    ]
}
