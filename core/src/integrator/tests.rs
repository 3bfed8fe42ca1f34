//! The order of the methods on an equation with a known solution, and their limits of stability.

use super::{From, RK4, RungeKutta, SSP_RK3, SemiDiscrete};
use crate::error::Error;

/// `y' = λ y + μ cos t`, two components for a complex `λ`.
struct Oscillator {
    lambda: [f64; 2],
    drive: f64,
    y: [f64; 2],
    start: [f64; 2],
    last: [f64; 2],
    sum: [f64; 2],
}

impl Oscillator {
    fn new(lambda: [f64; 2], drive: f64) -> Self {
        let zero = [0.0; 2];
        Self {
            lambda,
            drive,
            y: [1.0, 0.0],
            start: zero,
            last: zero,
            sum: zero,
        }
    }
}

impl SemiDiscrete<f64> for Oscillator {
    fn start(&mut self) -> Result<(), Error> {
        (self.start, self.sum) = (self.y, [0.0; 2]);
        Ok(())
    }
    fn rates(&mut self, time: f64) -> Result<(), Error> {
        let [a, b] = self.lambda;
        let [x, y] = self.y;
        self.last = [a * x - b * y + self.drive * libm::cos(time), b * x + a * y];
        Ok(())
    }
    fn accumulate(&mut self, n: u32) {
        for (sum, last) in self.sum.iter_mut().zip(self.last) {
            *sum += f64::from(n) * last;
        }
    }
    fn stage(&mut self, dt: f64, from: From) -> Result<(), Error> {
        let rates = match from {
            From::Last => self.last,
            From::Sum => self.sum,
        };
        self.y = core::array::from_fn(|i| self.start[i] + dt * rates[i]);
        Ok(())
    }
}

/// The error at t = 1 of `y' = -y + cos t`, `y = (cos t + sin t + e^-t)/2`.
fn error(method: &RungeKutta, steps: u32) -> f64 {
    let mut system = Oscillator::new([-1.0, 0.0], 1.0);
    let dt = 1.0 / f64::from(steps);
    for i in 0..steps {
        method.advance(&mut system, f64::from(i) * dt, dt).unwrap();
    }
    let exact = 0.5 * (libm::cos(1.0) + libm::sin(1.0) + libm::exp(-1.0));
    libm::fabs(system.y[0] - exact)
}

#[test]
fn each_method_has_its_order() {
    for method in RungeKutta::ALL {
        for steps in [10, 20, 40] {
            let order = libm::log2(error(&method, steps) / error(&method, 2 * steps));
            let expected = f64::from(method.order);
            assert!(
                (order - expected).abs() < 0.25,
                "{}: {order} at {steps} steps, expected {expected}",
                method.name
            );
        }
    }
}

/// A step below the stated limit does not grow a mode, one 2 % above does.
#[test]
fn the_limits_of_stability_are_as_stated() {
    for method in [RK4, SSP_RK3] {
        for (lambda, limit) in [([0.0, 1.0], method.imaginary), ([-1.0, 0.0], method.real)] {
            let growth = |dt: f64| {
                let mut system = Oscillator::new(lambda, 0.0);
                method.advance(&mut system, 0.0, dt).unwrap();
                libm::hypot(system.y[0], system.y[1])
            };
            assert!(growth(0.999 * limit) <= 1.0, "{} {lambda:?}", method.name);
            assert!(growth(1.02 * limit) > 1.0, "{} {lambda:?}", method.name);
        }
    }
}

#[test]
fn the_weights_add_up_to_the_divisor_and_the_first_stage_counts() {
    for method in RungeKutta::ALL {
        let sum: u32 = method.stages.iter().map(|stage| stage.weight).sum();
        assert_eq!(method.first + sum, method.divisor, "{}", method.name);
    }
}
