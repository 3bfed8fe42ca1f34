//! What particles are compared with: a grid of the same resolution.

/// A square grid of cells of side 1 around 0, values row by row, nothing beyond it.
pub struct Grid {
    size: usize,
    values: Vec<f64>,
}

impl Grid {
    /// Cells with the values of a function at their middles.
    pub fn new(size: usize, u: impl Fn(f64, f64) -> f64) -> Self {
        let middle = |i: usize| i as f64 + 0.5 - 0.5 * size as f64;
        let cells = (0..size * size).map(|cell| u(middle(cell % size), middle(cell / size)));
        Self {
            size,
            values: cells.collect(),
        }
    }

    /// The largest and the smallest value.
    pub fn range(&self) -> (f64, f64) {
        let values = || self.values.iter().copied();
        (
            values().fold(f64::NEG_INFINITY, f64::max),
            values().fold(f64::INFINITY, f64::min),
        )
    }

    fn at(values: &[f64], size: usize, i: isize, j: isize) -> f64 {
        let inside = |i: isize| (0..size as isize).contains(&i);
        match inside(i) && inside(j) {
            true => values[j as usize * size + i as usize],
            false => 0.0,
        }
    }

    /// `-div(a u) + b Δu`, `a = rate (-y, x)`: finite volumes, the value at a face from the two cells
    /// upwind of it on a straight line (Warming & Beam, AIAA J. 14, 1976, 1241), central diffusion.
    fn rates(&self, values: &[f64], rate: f64, b: f64) -> Vec<f64> {
        let size = self.size;
        let half = 0.5 * size as f64;
        let u = |i: isize, j: isize| Self::at(values, size, i, j);
        // Between a cell and the one before it in a direction.
        let flux = |speed: f64, [far, near, here, next]: [f64; 4]| {
            let face = match speed > 0.0 {
                true => 1.5 * near - 0.5 * far,
                false => 1.5 * here - 0.5 * next,
            };
            speed * face - b * (here - near)
        };
        let along = |i: isize, j: isize| {
            let speed = -rate * (j as f64 + 0.5 - half);
            flux(speed, [u(i - 2, j), u(i - 1, j), u(i, j), u(i + 1, j)])
        };
        let across = |i: isize, j: isize| {
            let speed = rate * (i as f64 + 0.5 - half);
            flux(speed, [u(i, j - 2), u(i, j - 1), u(i, j), u(i, j + 1)])
        };
        let cells = (0..size * size).map(|cell| {
            let (i, j) = ((cell % size) as isize, (cell / size) as isize);
            along(i, j) - along(i + 1, j) + across(i, j) - across(i, j + 1)
        });
        cells.collect()
    }

    /// Makes a step of SSP-RK3 (Shu & Osher 1988).
    pub fn advance(&mut self, dt: f64, rate: f64, b: f64) {
        let blend = |part: f64, from: &[f64], rates: Vec<f64>| -> Vec<f64> {
            let cells = self.values.iter().zip(from).zip(&rates);
            let cell = |((old, new), rate): ((&f64, &f64), &f64)| {
                (1.0 - part) * old + part * (new + dt * rate)
            };
            cells.map(cell).collect()
        };
        let first = blend(1.0, &self.values, self.rates(&self.values, rate, b));
        let second = blend(0.25, &first, self.rates(&first, rate, b));
        self.values = blend(2.0 / 3.0, &second, self.rates(&second, rate, b));
    }
}
