//! What the textbooks have.

use super::super::*;
use super::slabs::{exchange, layer, slab, stacks, zigzag};
use std::f64::consts::PI;

fn at(slab: &Slab, x: f64, time: f64) -> f64 {
    slab.at([x, 0.0, 0.0], time)[0]
}

fn values(below: f64, above: f64) -> [End; 2] {
    [below, above].map(|value| End::Value(Drive::constant(value)))
}

/// `u = V + (u_0 - V) Σ_odd 4/(pi n) sin(n pi x/L) e^(-D (n pi/L)^2 t)`: Carslaw and Jaeger, 3.3.
#[test]
fn between_equal_values_it_is_the_sine_series() {
    let slab = slab(&stacks()[0], &values(1.3, 1.3));
    for time in [0.01, 0.1, 0.7, 3.0] {
        for i in 0..=12 {
            let x = 0.1 * f64::from(i);
            let term = |n: i32| {
                let k = PI * f64::from(2 * n + 1) / 1.2;
                4.0 / (1.2 * k) * (k * x).sin() * (-0.7 * k * k * time).exp()
            };
            let series = (0..100).map(term).sum::<f64>();
            let expected = 1.3 + (0.25 - 1.3) * series;
            let error = at(&slab, x - 0.3, time) - expected;
            assert!(error.abs() < 1e-14, "{time} {x}: {error:e}");
        }
    }
}

/// Cut into layers of the same material it is the same slab.
#[test]
fn layers_of_one_material_are_one_layer() {
    for ends in super::slabs::ends() {
        let whole = slab(&stacks()[0], &ends);
        let parts = [layer(0.3, 0.7), layer(0.85, 0.7), layer(0.05, 0.7)];
        let parts = slab(&parts, &ends);
        for time in [1e-6, 0.01, 0.3, 2.0] {
            for i in 0..=12 {
                let x = 0.1 * f64::from(i) - 0.3;
                let error = at(&whole, x, time) - at(&parts, x, time);
                assert!(error.abs() < 1e-12, "{time} {x}: {error:e}");
            }
        }
    }
}

/// A plate of half thickness l that loses heat on both sides, `Bi = rate l/D`:
/// `u = Σ 4 sin z/(2 z + sin 2 z) cos(z x/l) e^(-z^2 D t/l^2)`, `z tan z = Bi`: Crank, 4.3.6.
#[test]
fn between_equal_exchanges_it_is_the_cosine_series() {
    let (rate, half, b) = (0.9, 0.6, 0.7);
    let ends = || exchange(rate, Drive::constant(0.0));
    let slab = slab(&stacks()[0], &[ends(), ends()]);
    let root = |n: i32| {
        let (mut low, mut high) = (PI * f64::from(n), PI * (f64::from(n) + 0.5));
        for _ in 0..100 {
            let z = 0.5 * (low + high);
            if z * z.sin() * if n % 2 == 0 { 1.0 } else { -1.0 }
                < rate * half / b * z.cos() * if n % 2 == 0 { 1.0 } else { -1.0 }
            {
                low = z;
            } else {
                high = z;
            }
        }
        0.5 * (low + high)
    };
    for time in [0.01, 0.1, 0.7, 3.0] {
        for i in -6..=6 {
            let x = 0.1 * f64::from(i);
            let term = |n: i32| {
                let z = root(n);
                let fade = (-z * z * b * time / half / half).exp();
                4.0 * z.sin() / (2.0 * z + (2.0 * z).sin()) * (z * x / half).cos() * fade
            };
            let expected = 0.25 * (0..60).map(term).sum::<f64>();
            let error = at(&slab, x + 0.3, time) - expected;
            assert!(error.abs() < 1e-14, "{time} {x}: {error:e}");
        }
    }
}

/// Two layers between values: straight lines that the same flux passes, `(V_1 - V_2)/Σ l/D`.
#[test]
fn two_layers_come_to_rest_with_one_flux() {
    let layers = [layer(0.5, 0.6), layer(0.7, 0.05)];
    let slab = slab(&layers, &values(2.0, -1.0));
    let flux = 3.0 / (0.5 / 0.6 + 0.7 / 0.05);
    for i in 0..=12 {
        let x = 0.1 * f64::from(i);
        let drop = if x < 0.5 {
            x / 0.6
        } else {
            0.5 / 0.6 + (x - 0.5) / 0.05
        };
        let expected = 2.0 - flux * drop;
        let u = at(&slab, x - 0.3, 1e3);
        assert!((u - expected).abs() < 3e-15, "{x}: {u} {expected}");
        let steady = slab.steady(x - 0.3).unwrap();
        assert!(
            (steady - expected).abs() < 3e-15,
            "{x}: {steady} {expected}"
        );
        assert!((slab.flux(x - 0.3, 1e3) - flux).abs() < 3e-15);
    }
}

/// What came in by the ramp stays: the mean of u.
#[test]
fn insulated_ends_level_out_and_others_may_not() {
    let ramp = |last: f64| Drive {
        points: vec![(0.0, 0.0), (1.0, -0.6), (2.0, last)],
    };
    let level = |last: f64| slab(&stacks()[1], &[End::NoFlux, End::Flux(ramp(last))]);
    let expected = 0.25 + 0.6 / 1.2;
    let steady = level(0.0).steady(0.1).unwrap();
    assert!((steady - expected).abs() < 1e-15, "{steady}");
    let u = at(&level(0.0), 0.1, 1e3);
    assert!((u - expected).abs() < 1e-15, "{u}");
    assert_eq!(level(-0.1).steady(0.1), None);
}

/// A value jumps: `u = erfc(x/(2 sqrt(D t)))`, Carslaw and Jaeger, 2.4, until the other end
/// notices, `e^-(1.2^2/(4 D t))`. The modes left out are `e^-(lambda_N t)`, `lambda_N = 7.7e5`.
#[test]
fn a_jump_enters_as_into_a_half_space() {
    let slab = slab(&stacks()[0], &values(1.25, 0.25));
    let cases = [
        (1e-6, 0.1),
        (1e-5, 2e-5),
        (5e-5, 1e-14),
        (1e-3, 1e-14),
        (0.01, 1e-14),
    ];
    for (time, bound) in cases {
        for i in 0..200 {
            let x = 0.02 * f64::from(i) * f64::sqrt(0.7 * time);
            let expected = 0.25 + libm::erfc(x / (2.0 * f64::sqrt(0.7 * time)));
            let error = at(&slab, x - 0.3, time) - expected;
            assert!(error.abs() < bound, "{time} {x}: {error:e}");
        }
    }
}

/// A value ramps by 1 a time from 0 on: `u = 4 t i^2erfc(x/(2 sqrt(D t)))`, Carslaw and Jaeger, 2.5.
/// Right after the corner of g the modes left out are `2/(pi^3 n^3)` each, of `T^2`, with signs:
/// below `1/(pi^3 N^2) = 2e-7` in all.
#[test]
fn a_ramp_enters_as_into_a_half_space() {
    let ramp = Drive {
        points: vec![(0.0, 0.25), (1.0, 1.25)],
    };
    let slab = slab(&stacks()[0], &[End::Value(ramp), End::NoFlux]);
    let square = 1.2 * 1.2 / 0.7;
    let error = |time: f64| {
        let each = (0..200).map(|i| {
            let y = 0.01 * f64::from(i);
            let gauss = 2.0 * y / PI.sqrt() * libm::exp(-y * y);
            let integral = (1.0 + 2.0 * y * y) * libm::erfc(y) - gauss;
            let x = 2.0 * y * f64::sqrt(0.7 * time);
            (at(&slab, x - 0.3, time) - 0.25 - time * integral).abs()
        });
        each.fold(0.0, f64::max)
    };
    let early = error(1e-6) / square;
    assert!((2e-8..2e-7).contains(&early), "{early:e}");
    for time in [5e-5, 1e-3, 0.01] {
        let late = error(time);
        assert!(late < 1e-14, "{time}: {late:e}");
    }
}

/// Points on one line change nothing, wherever the modes forget them.
#[test]
fn points_on_a_line_change_nothing() {
    let line = |count: i32| Drive {
        points: (0..=count)
            .map(|i| 3.0 * f64::from(i) / f64::from(count))
            .map(|time| (time, 0.25 + 0.5 * time))
            .collect(),
    };
    for end in [End::Value, End::Flux, |drive| exchange(1.4, drive)] {
        let [few, many] = [1, 433].map(|n| slab(&stacks()[1], &[End::NoFlux, end(line(n))]));
        for time in [1e-5, 0.01, 1.2, 2.999, 3.1, 8.0] {
            for i in 0..=12 {
                let x = 0.1 * f64::from(i) - 0.3;
                let error = at(&few, x, time) - at(&many, x, time);
                assert!(error.abs() < 1e-13, "{time} {x}: {error:e}");
            }
        }
    }
}

#[test]
fn a_drive_is_its_lines() {
    let drive = zigzag(1.0);
    for (time, value) in [
        (-3.0, 0.4),
        (-1.0, 0.4),
        (0.3, 0.15),
        (0.5, -0.7),
        (9.0, 0.8),
    ] {
        assert!((drive.at(time) - value).abs() < 1e-15, "{time}");
    }
    assert_eq!(Drive::constant(0.7).at(-5.0), 0.7);
}
