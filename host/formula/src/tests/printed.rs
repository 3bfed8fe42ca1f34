//! Made by rust.rs, not by hand.

use crate::elementary;

/// The value of a formula at x, y and t.
type Value = fn([f64; 3]) -> f64;

/// What is written of each formula.
pub const PRINTED: [Value; 59] = [
    |[x, _, _]| x,
    |[_, _, _]| 3.0,
    |[x, _, _]| -x,
    |[x, y, _]| -2.0 * x - -y,
    |[x, y, t]| x + y - t,
    |[x, y, t]| x - (y + t),
    |[x, y, t]| x - (y - t),
    |[x, y, t]| x * y / t,
    |[x, y, t]| x / (y * t),
    |[x, y, t]| x / (y / t),
    |[x, y, t]| (x + y) * (x - t),
    |[x, y, t]| -(x + y) * t,
    |[x, _, _]| elementary::power(-x, 2.0) - elementary::power(x, 2.0),
    |[x, y, _]| elementary::power(2.0, elementary::power(x, y)),
    |[x, y, t]| {
        let v0 = elementary::power(x, -3.0) + elementary::power(y, 7.0) + elementary::power(t, 0.5);
        v0 + elementary::power(x, y)
    },
    |[x, y, t]| elementary::remainder(x, 1.0) + elementary::remainder(y, -3.0) + elementary::remainder(x, t),
    |[x, y, _]| elementary::truth(x < y),
    |[x, y, _]| elementary::truth(x <= y),
    |[x, y, _]| elementary::truth(y < x),
    |[x, y, _]| elementary::truth(y <= x),
    |[x, y, _]| elementary::truth(x == y),
    |[x, y, _]| 1.0 - elementary::truth(x == y),
    |[x, y, t]| elementary::choice(elementary::truth(x < y), elementary::choice(elementary::truth(y < t), 1.0, 0.0), 0.0),
    |[x, y, t]| elementary::choice(elementary::truth(x < y), 1.0, elementary::choice(elementary::truth(y < t), 1.0, 0.0)),
    |[x, y, _]| elementary::choice(x - y, 0.0, 1.0),
    |[x, y, t]| elementary::choice(elementary::truth(x < y + t), x * t, y - 1.0),
    |[x, y, t]| elementary::choice(x, y, t),
    |[x, y, t]| elementary::minimum(elementary::minimum(x, y), t),
    |[x, y, t]| elementary::maximum(elementary::maximum(x, y), t),
    |[x, y, _]| libm::atan2(y, x),
    |[x, _, _]| libm::fabs(x),
    |[x, _, _]| libm::acos(x),
    |[x, _, _]| libm::asin(x),
    |[x, _, _]| libm::atan(x),
    |[x, _, _]| libm::cbrt(x),
    |[x, _, _]| libm::ceil(x),
    |[x, _, _]| libm::cos(x),
    |[x, _, _]| libm::cosh(x),
    |[x, _, _]| libm::erf(x),
    |[x, _, _]| libm::exp(x),
    |[x, _, _]| libm::floor(x),
    |[x, _, _]| libm::log(x),
    |[x, _, _]| libm::log10(x),
    |[x, _, _]| elementary::sign(x),
    |[x, _, _]| libm::sin(x),
    |[x, _, _]| libm::sinh(x),
    |[x, _, _]| libm::sqrt(x),
    |[x, _, _]| libm::tan(x),
    |[x, _, _]| libm::tanh(x),
    |[x, y, t]| core::f64::consts::TAU * x + core::f64::consts::PI * y + 1e300 * t + 1e-300,
    |[x, y, _]| {
        let v0 = x + y;
        let v1 = elementary::power(libm::sin(v0), 2.0) + elementary::power(libm::cos(v0), 2.0);
        v1 - 1.0 / v0
    },
    |[x, y, t]| {
        let v0 = -(elementary::power(x - 0.25, 2.0) + elementary::power(y - 0.75, 2.0)) / 0.02;
        libm::exp(v0) * libm::cos(core::f64::consts::TAU * (x - y - t)) + 0.1 * libm::tanh((x + y) / 0.05) * libm::exp(-t)
    },
    |[x, y, t]| {
        let v0 = x - t;
        let v1 = libm::sin(core::f64::consts::TAU * v0) / (1.0 + elementary::power(v0, 2.0));
        let v2 = x + t;
        let v3 = libm::sin(core::f64::consts::TAU * v2) / (1.0 + elementary::power(v2, 2.0));
        let v4 = libm::sin(core::f64::consts::TAU * y) / (1.0 + elementary::power(y, 2.0));
        let v5 = elementary::choice(elementary::truth(v2 < 0.0), 0.0, v3) * elementary::choice(elementary::truth(y < 0.0), 0.0, v4);
        elementary::choice(elementary::truth(v0 < 0.0), 0.0, v1) + v5
    },
    |[x, y, t]| libm::sin(y - 2.0 * x) * libm::sin(t - x),
    |[_, _, _]| core::f64::consts::TAU,
    |[x, y, _]| {
        let v0 = x + y;
        let v1 = libm::sin(v0);
        let v2 = libm::cos(v0);
        2.0 * v1 * v2 + 2.0 * v2 * (-v1) - (0.0 - 1.0 / v0) / v0
    },
    |[x, y, t]| {
        let v0 = x - 0.25;
        let v1 = libm::exp(-(elementary::power(v0, 2.0) + elementary::power(y - 0.75, 2.0)) / 0.02);
        let v2 = core::f64::consts::TAU * (x - y - t);
        let v3 = libm::tanh((x + y) / 0.05);
        let v4 = v1 * (-(2.0 * v0) / 0.02) * libm::cos(v2) + v1 * (-libm::sin(v2) * core::f64::consts::TAU);
        v4 + 0.1 * ((1.0 - v3 * v3) * 20.0) * libm::exp(-t)
    },
    |[x, y, t]| {
        let v0 = x - t;
        let v1 = core::f64::consts::TAU * v0;
        let v2 = 1.0 + elementary::power(v0, 2.0);
        let v3 = x + t;
        let v4 = core::f64::consts::TAU * v3;
        let v5 = 1.0 + elementary::power(v3, 2.0);
        let v6 = libm::sin(core::f64::consts::TAU * y) / (1.0 + elementary::power(y, 2.0));
        let v7 = (libm::cos(v1) * core::f64::consts::TAU - libm::sin(v1) / v2 * (2.0 * v0)) / v2;
        let v8 = (libm::cos(v4) * core::f64::consts::TAU - libm::sin(v4) / v5 * (2.0 * v3)) / v5;
        let v9 = elementary::choice(elementary::truth(v3 < 0.0), 0.0, v8) * elementary::choice(elementary::truth(y < 0.0), 0.0, v6);
        elementary::choice(elementary::truth(v0 < 0.0), 0.0, v7) + v9
    },
    |[x, y, t]| {
        let v0 = y - 2.0 * x;
        let v1 = t - x;
        libm::cos(v0) * (-2.0) * libm::sin(v1) + libm::sin(v0) * (-libm::cos(v1))
    },
];
