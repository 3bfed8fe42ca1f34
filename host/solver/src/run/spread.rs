//! Smallest, mean and largest.

/// Smallest, mean and largest of something.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Spread {
    /// The smallest.
    pub min: f64,
    /// The mean.
    pub mean: f64,
    /// The largest.
    pub max: f64,
}

impl Spread {
    /// Of these values; all NaN if there are none.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut spreading = Spreading::default();
        values.for_each(|value| spreading.add(value));
        spreading.spread()
    }
}

/// A [`Spread`] that is being made, value by value.
#[derive(Clone, Copy, Debug)]
pub struct Spreading {
    min: f64,
    max: f64,
    sum: f64,
    count: f64,
}

impl Default for Spreading {
    fn default() -> Self {
        Self {
            min: f64::INFINITY,
            max: f64::NEG_INFINITY,
            sum: 0.0,
            count: 0.0,
        }
    }
}

impl Spreading {
    /// Adds a value.
    pub fn add(&mut self, value: f64) {
        self.min = self.min.min(value);
        self.max = self.max.max(value);
        self.sum += value;
        self.count += 1.0;
    }

    /// The spread of all values; all NaN if there are none.
    pub fn spread(&self) -> Spread {
        let some = |value| if self.count > 0.0 { value } else { f64::NAN };
        Spread {
            min: some(self.min),
            mean: self.sum / self.count,
            max: some(self.max),
        }
    }
}
