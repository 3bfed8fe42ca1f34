//! What all exact solutions are to those who compare: fields of p components known everywhere.
//!
//! Units are the caller's, any consistent set. Elementary functions come from `libm`, so
//! that a solution has the same bits on every platform.

/// An exact solution: the components of u at a place and time.
pub trait Solution: Send + Sync {
    /// p, how many there are.
    fn components(&self) -> usize;

    /// Writes u(x, t) into `state`, whose length is [`Solution::components`]. `position` has
    /// zeros beyond the dimension.
    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]);

    /// Why it may not hold, if it may not.
    fn doubt(&self) -> Option<String> {
        None
    }

    /// u(x, t) as a list of its own.
    fn at(&self, position: [f64; 3], time: f64) -> Vec<f64> {
        let mut state = vec![0.0; self.components()];
        self.write(position, time, &mut state);
        state
    }
}

/// Writes the components one after the other.
pub(in crate::exact) fn fill(state: &mut [f64], values: &[f64]) {
    for (slot, value) in state.iter_mut().zip(values) {
        *slot = *value;
    }
}
