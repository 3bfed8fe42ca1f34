//! Straight lines through logarithms.

/// `value = factor h^exponent`.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct PowerLaw {
    /// The value at h = 1.
    pub factor: f64,
    /// The order.
    pub exponent: f64,
}

impl PowerLaw {
    /// Through pairs of h and value, by least squares of the logarithms; `None` with fewer than
    /// two different h, or where something is not above 0 and finite.
    pub fn fit(points: &[(f64, f64)]) -> Option<Self> {
        let usable = |x: f64| x > 0.0 && x.is_finite();
        let differ = points.iter().any(|(h, _)| *h != points[0].0);
        if !differ || !points.iter().all(|&(h, value)| usable(h) && usable(value)) {
            return None;
        }
        let exponent = order(points);
        let n = points.len() as f64;
        let rest = points.iter().map(|(h, e)| e.ln() - exponent * h.ln());
        Some(Self {
            factor: (rest.sum::<f64>() / n).exp(),
            exponent,
        })
    }

    /// The value at h.
    pub fn at(&self, h: f64) -> f64 {
        self.factor * h.powf(self.exponent)
    }
}

/// The slope of `ln value` over `ln h`, by least squares.
pub fn order(points: &[(f64, f64)]) -> f64 {
    let points: Vec<(f64, f64)> = points.iter().map(|(h, e)| (h.ln(), e.ln())).collect();
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let (mut above, mut below) = (0.0, 0.0);
    for (a, b) in &points {
        above += (a - x) * (b - y);
        below += (a - x) * (a - x);
    }
    above / below
}
