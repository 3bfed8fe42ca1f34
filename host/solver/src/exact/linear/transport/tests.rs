//! The equation, the paths, and what they keep.

use super::super::residual::{Equation, Probe, assert_holds};
use super::*;

const CENTER: [f64; 3] = [0.4, -0.3, 0.2];

/// Every field, with nothing about it special.
fn fields() -> [Field; 7] {
    let (rate, lower) = (0.7, -0.9);
    let center = CENTER;
    let compression = |dimension| Field::Compression {
        rate,
        center,
        dimension,
    };
    [
        Field::Still,
        Field::Uniform {
            velocity: [0.5, -0.8, 0.3],
        },
        Field::Rotation { rate, center },
        Field::Shear { rate, center },
        compression(2),
        compression(3),
        Field::Wave {
            amplitude: 0.2,
            lower,
            length: 2.0,
        },
    ]
}

fn problem(field: Field) -> TransportProblem {
    TransportProblem {
        field,
        center: [0.1, 0.2, -0.1],
        width: 0.8,
        amplitude: 1.5,
        decay: 0.4,
        source: if matches!(field, Field::Wave { .. }) {
            0.0
        } else {
            0.9
        },
        periods: [None; 3],
    }
}

impl Equation for TransportProblem {
    fn dimension(&self) -> usize {
        3
    }

    fn flux(&self, position: [f64; 3], axis: usize, state: &[f64]) -> Vec<f64> {
        vec![self.field.velocity(position)[axis] * state[0]]
    }

    fn reaction(&self, state: &[f64]) -> Vec<f64> {
        vec![self.decay * state[0] - self.source]
    }
}

/// The paths shrink the Gaussian by e^0.7 at most until t = 1: `2 pi 0.2/2 = 0.63` in the wave.
const PROBE: Probe = Probe {
    center: [0.1, 0.0, 0.0],
    size: 1.0,
    duration: 1.0,
    length: 0.3,
    pace: 0.5,
};

#[test]
fn the_equation_holds_in_every_field() {
    for field in fields() {
        let transport = problem(field).solve().unwrap();
        assert_holds(transport.problem(), &transport, PROBE);
    }
}

#[test]
fn it_holds_with_images_with_and_without_decay() {
    let [still, uniform, _, shear, .., wave] = fields();
    let all = [Some(2.0), Some(1.6), Some(3.0)];
    let cases = [
        (still, all),
        (uniform, all),
        (shear, [Some(2.0), None, Some(1.6)]),
        (wave, [Some(4.0), Some(1.6), None]),
    ];
    for (field, periods) in cases {
        for decay in [0.0, 0.4] {
            let problem = TransportProblem {
                periods,
                decay,
                ..problem(field)
            };
            assert_holds(&problem, &problem.solve().unwrap(), PROBE);
        }
    }
}

/// Whole periods are exact in binary, but the difference from the centre is not.
#[test]
fn images_have_the_period() {
    let [_, uniform, .., wave] = fields();
    for field in [uniform, wave] {
        let problem = TransportProblem {
            periods: [Some(2.0), Some(1.5), None],
            ..problem(field)
        };
        let transport = problem.solve().unwrap();
        for i in 0..20 {
            let x = 0.125 * f64::from(i);
            let here = transport.at([x, 0.25, 0.5], 0.5)[0];
            let there = transport.at([x - 4.0, 0.25 + 4.5, 0.5], 0.5)[0];
            assert!((here / there - 1.0).abs() < 2e-14, "{x}: {here} {there}");
        }
    }
}

/// Central differences with a step of 1e-5: error `(pi 1e-5)^2/6 = 2e-10` of the derivative in
/// the wave, 0 in the others, and rounding of 3e-16/1e-5 in each direction.
#[test]
fn the_divergence_is_that_of_the_velocity() {
    for field in fields() {
        for i in -10..10 {
            let x = [0.17 * f64::from(i), 0.3, -0.2];
            let slope = |axis: usize| {
                let [a, b] = [-1e-5, 1e-5].map(|step| {
                    let mut place = x;
                    place[axis] += step;
                    field.velocity(place)[axis]
                });
                (b - a) / 2e-5
            };
            let sum = (0..3).map(slope).sum::<f64>();
            let error = sum - field.divergence(x);
            assert!(error.abs() < 3e-10, "{field:?} {x:?}: {error:e}");
        }
    }
}

/// Three flow maps of condition e^0.7, each good to some 2e-16 of places of about 1.
#[test]
fn the_way_back_leads_to_where_it_began() {
    for field in fields() {
        for i in -20..20 {
            let x = [0.17 * f64::from(i), 0.3, -0.2];
            let there = field.foot(x, -1.0);
            let back = field.foot(there, 1.0);
            let half = field.foot(field.foot(x, 0.25), 0.75);
            let whole = field.foot(x, 1.0);
            for axis in 0..3 {
                assert!((back[axis] - x[axis]).abs() < 1e-14, "{field:?} {x:?}");
                assert!(
                    (half[axis] - whole[axis]).abs() < 1e-14,
                    "{field:?} {x:?} in two steps"
                );
            }
            let product = field.jacobian(x, 1.0) * field.jacobian(whole, -1.0);
            assert!((product - 1.0).abs() < 1e-14, "{field:?} {x:?}: {product}");
        }
    }
}

/// The trapezoidal rule on a period, 400 points, is exact but for rounding: the solution is
/// analytic, squeezed to a width of 0.8 / e^0.7 / 2.
#[test]
fn a_velocity_wave_keeps_the_integral() {
    let [.., wave] = fields();
    let problem = TransportProblem {
        decay: 0.0,
        periods: [Some(2.0), None, None],
        ..problem(wave)
    };
    let transport = problem.solve().unwrap();
    let integral = |time: f64| {
        let value = |i: i32| transport.at([0.005 * f64::from(i), 0.2, -0.1], time)[0];
        0.005 * (0..400).map(value).sum::<f64>()
    };
    for time in [0.0, 0.3, 1.0] {
        let expected = 1.5 * 0.8 * std::f64::consts::PI.sqrt();
        assert!((integral(time) / expected - 1.0).abs() < 1e-13, "{time}");
    }
}

/// Late in a wave all is where v = 0 and converges: finite, and growing as 1/J.
#[test]
fn late_times_are_finite() {
    let [.., wave] = fields();
    let problem = TransportProblem {
        decay: 0.0,
        ..problem(wave)
    };
    let transport = problem.solve().unwrap();
    for i in -20..20 {
        let u = transport.at([0.1 * f64::from(i), 0.0, 0.0], 300.0)[0];
        assert!(u.is_finite() && u >= 0.0, "{u}");
    }
}

#[test]
fn what_is_wrong_is_named() {
    let [_, uniform, rotation, .., wave] = fields();
    let good = problem(uniform);
    let period = [Some(2.0), None, None];
    let cases = [
        (
            TransportProblem {
                width: -1.0,
                ..good
            },
            "width must be > 0, not -1",
        ),
        (
            TransportProblem {
                decay: -0.5,
                ..good
            },
            "decay must be >= 0, not -0.5",
        ),
        (
            TransportProblem {
                source: 1.0,
                ..problem(wave)
            },
            "source must be 0 in a velocity wave, not 1",
        ),
        (
            TransportProblem {
                periods: period,
                ..problem(rotation)
            },
            "period along x must be a period of the velocity, not 2",
        ),
        (
            TransportProblem {
                periods: [Some(3.0), None, None],
                ..problem(wave)
            },
            "period along x must be a period of the velocity, not 3",
        ),
        (
            TransportProblem {
                periods: period,
                width: 201.0,
                ..good
            },
            "width must be at most 100 periods, not 201",
        ),
    ];
    for (problem, text) in cases {
        assert_eq!(problem.solve().unwrap_err().to_string(), text);
    }
}
