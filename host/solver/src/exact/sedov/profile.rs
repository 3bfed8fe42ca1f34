//! The self-similar fields behind the shock, in units of the density outside and of the
//! speed of the shock, as functions of `lambda = r/R`.
//!
//! The parameter is `W = u / (lambda R')`, which rises from `1/gamma` in the centre to
//! `2/(gamma + 1)` at the shock (Kamm and Timmes's `V` is `2 W / (D+2)`); near the centre
//! `W - 1/gamma` falls below the rounding of `W`, so `s = ln` of its part of that at the
//! shock is what is solved for.
//!
//! - radius: `d ln lambda / dW = -a0/W - a2/(W - 1/gamma) + a1/(w1 - W)`, Kamm and Timmes
//!   (38) with `a0 = 2/(D+2)`, `a2 = -(gamma-1)/(2(gamma-1) + D)`, `w1 = (D+2)/(2 + D(gamma-1))`,
//!   `a1 = (D+2) gamma / (2 + D(gamma-1)) (2 D (2-gamma)/(gamma (D+2)^2) - a2)`
//! - density: continuity, `d ln rho = (D W d ln lambda + dW) / (1 - W)`
//! - pressure: the energy inside a given lambda is constant,
//!   `p/rho = (gamma-1) W^2 (1-W) lambda^2 / (2 (gamma W - 1))`
//!
//! Differs from the report: its exponents of the density, a4 and a5, are infinite at
//! gamma = 2; the integral of continuity here is not.

/// The similarity solution of one dimension and gamma.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Profile {
    d: f64,
    gamma: f64,
    a0: f64,
    a1: f64,
    a2: f64,
    /// `2/(gamma+1) - 1/gamma`, the range of W.
    range: f64,
    /// `w1 - 2/(gamma+1)` and `w1 - 1`.
    w1_less_shock: f64,
    w1_less_1: f64,
}

/// The fields at one lambda.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Similar {
    pub density: f64,
    pub velocity: f64,
    pub pressure: f64,
    pub energy: f64,
}

/// The least `s`, where `e^s` is 1e-217.
const LEAST: f64 = -500.0;

impl Profile {
    pub fn new(dimension: usize, gamma: f64) -> Self {
        let d = dimension as f64;
        let b = 2.0 + d * (gamma - 1.0);
        let a2 = -(gamma - 1.0) / (2.0 * (gamma - 1.0) + d);
        let inner = 2.0 * d * (2.0 - gamma) / (gamma * (d + 2.0) * (d + 2.0)) - a2;
        Self {
            d,
            gamma,
            a0: 2.0 / (d + 2.0),
            a1: (d + 2.0) * gamma / b * inner,
            a2,
            range: (gamma - 1.0) / (gamma * (gamma + 1.0)),
            w1_less_shock: (3.0 * d - 2.0 - (d - 2.0) * gamma) / (b * (gamma + 1.0)),
            w1_less_1: d * (2.0 - gamma) / b,
        }
    }

    /// W, 1 - W and w1 - W.
    fn w(&self, s: f64) -> [f64; 3] {
        let below_shock = -libm::expm1(s) * self.range;
        let shock = 2.0 / (self.gamma + 1.0);
        [
            shock - below_shock,
            (self.gamma - 1.0) / (self.gamma + 1.0) + below_shock,
            self.w1_less_shock + below_shock,
        ]
    }

    /// ln lambda and its derivative by s.
    fn ln_radius(&self, s: f64) -> (f64, f64) {
        let [w, _, w1_w] = self.w(s);
        let shock = 2.0 / (self.gamma + 1.0);
        let ln = -self.a0 * libm::log(w / shock)
            - self.a2 * s
            - self.a1 * libm::log(w1_w / self.w1_less_shock);
        let excess = self.range * libm::exp(s);
        let slope = excess * (self.a1 / w1_w - self.a0 / w) - self.a2;
        (ln, slope)
    }

    /// ln of the density as a part of that at the shock: the integral of continuity term
    /// by term.
    fn ln_density(&self, s: f64) -> f64 {
        let [_, v, w1_w] = self.w(s);
        let v_shock = (self.gamma - 1.0) / (self.gamma + 1.0);
        let ln_v = libm::log(v / v_shock);
        // 1/delta ln(1 + delta/v), 1/v for delta = 0, which is gamma = 2.
        let delta = self.w1_less_1;
        let part = |v: f64| {
            if delta == 0.0 {
                1.0 / v
            } else {
                libm::log1p(delta / v) / delta
            }
        };
        let outer = libm::log(w1_w / self.w1_less_shock) + part(v) - part(v_shock);
        let inner = (s - self.gamma * ln_v) / (self.gamma - 1.0);
        self.d * (self.a0 * ln_v - self.a2 * inner + self.a1 * outer) - ln_v
    }

    /// The fields at `lambda`, 0 to 1.
    pub fn at(&self, lambda: f64) -> Similar {
        let s = self.parameter(lambda);
        let [w, v, _] = self.w(s);
        let (ln_radius, _) = self.ln_radius(s);
        let gamma = self.gamma;
        let density = (gamma + 1.0) / (gamma - 1.0) * libm::exp(self.ln_density(s));
        let energy = self.energy_factor(w, v) * libm::exp(2.0 * ln_radius - s);
        Similar {
            density,
            velocity: lambda * w,
            pressure: (gamma - 1.0) * density * energy,
            energy,
        }
    }

    /// The energy per mass is this times `lambda^2 e^-s`.
    fn energy_factor(&self, w: f64, v: f64) -> f64 {
        w * w * v / (2.0 * self.gamma * self.range)
    }

    /// The s at lambda, not below [`LEAST`]: Newton's method between two bounds.
    fn parameter(&self, lambda: f64) -> f64 {
        let (mut lower, mut upper) = (LEAST, 0.0);
        let target = libm::log(lambda);
        if !(target > self.ln_radius(LEAST).0) {
            return LEAST;
        }
        let mut s = (-target / self.a2).clamp(lower, upper);
        // Bisection alone needs log2(500 / 1e-13) = 53.
        for _ in 0..100 {
            let (ln, slope) = self.ln_radius(s);
            let error = ln - target;
            if error > 0.0 {
                upper = s;
            } else {
                lower = s;
            }
            let newton = s - error / slope;
            let next = if lower <= newton && newton <= upper {
                newton
            } else {
                0.5 * (lower + upper)
            };
            if (next - s).abs() <= 2.0 * f64::EPSILON * s.abs() {
                return next;
            }
            s = next;
        }
        s
    }

    /// Energy of all of space in units of `rho_0 R^(D+2) / t^2`: alpha.
    ///
    /// `(2/(D+2))^2 S_D` times the integral of `rho (u^2/2 + e) lambda^(D-1)` over lambda,
    /// `S_D = 2, 2 pi, 4 pi`, over `s = -x / (D |a2|)`, along which it falls off as `e^-x`.
    /// `x = exp(tau - exp(-tau))` makes the trapezoidal rule converge exponentially:
    /// H. Takahasi and M. Mori, Publications of RIMS 9 (1974).
    pub fn energy(&self) -> f64 {
        let rate = -self.d * self.a2;
        let mut sum = 0.0;
        for i in -4 * STEPS..=4 * STEPS {
            let tau = f64::from(i) / f64::from(STEPS);
            let fall = libm::exp(-tau);
            let x = libm::exp(tau - fall);
            sum += self.energy_by_s(-x / rate) / rate * x * (1.0 + fall);
        }
        let gamma = self.gamma;
        let surface = match self.d {
            1.0 => 2.0,
            2.0 => 2.0 * std::f64::consts::PI,
            _ => 4.0 * std::f64::consts::PI,
        };
        let at_shock = (gamma + 1.0) / (gamma - 1.0);
        surface * self.a0 * self.a0 * at_shock * sum / f64::from(STEPS)
    }

    /// The integrand of [`Self::energy`] by s, the density as a part of that at the shock.
    fn energy_by_s(&self, s: f64) -> f64 {
        let [w, v, _] = self.w(s);
        let (ln_radius, slope) = self.ln_radius(s);
        let ln = (self.d + 2.0) * ln_radius + self.ln_density(s);
        let kinetic = 0.5 * w * w * libm::exp(ln);
        (kinetic + self.energy_factor(w, v) * libm::exp(ln - s)) * slope
    }
}

/// Points of the quadrature per unit of tau.
const STEPS: i32 = 32;
