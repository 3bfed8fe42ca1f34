//! What holds in every slab: the equation, the interfaces, the ends, the modes.

use super::super::super::super::linear::residual::Probe;
use super::super::super::residual::{Equation, residual, scaled};
use super::super::super::tensor::IDENTITY;
use super::super::*;

pub(super) fn layer(thickness: f64, diffusivity: f64) -> Layer {
    Layer {
        thickness,
        diffusivity,
    }
}

/// Up and down and up again, with corners at 0.1 and 0.5.
pub(super) fn zigzag(size: f64) -> Drive {
    let points = [(-1.0, 0.4), (0.1, 1.0), (0.5, -0.7), (2.5, 0.8)];
    let points = points.map(|(time, value)| (time, size * value));
    Drive {
        points: points.to_vec(),
    }
}

pub(super) fn exchange(rate: f64, outside: Drive) -> End {
    End::Exchange { rate, outside }
}

/// All pairs of kinds.
pub(super) fn ends() -> Vec<[End; 2]> {
    let below = [
        End::NoFlux,
        End::Value(zigzag(1.0)),
        End::Flux(zigzag(-0.6)),
        exchange(2.0, zigzag(0.9)),
    ];
    let above = [
        End::NoFlux,
        End::Value(zigzag(-0.5)),
        End::Flux(zigzag(0.3)),
        exchange(0.3, zigzag(-1.2)),
    ];
    let pairs = below.iter().flat_map(|a| {
        let pair = |b: &End| [a.clone(), b.clone()];
        above.iter().map(pair)
    });
    pairs.collect()
}

/// One layer and three, all of length 1.2 from -0.3.
pub(super) fn stacks() -> [Vec<Layer>; 2] {
    [
        vec![layer(1.2, 0.7)],
        vec![layer(0.5, 0.6), layer(0.3, 0.2), layer(0.4, 1.7)],
    ]
}

pub(super) fn slab(layers: &[Layer], ends: &[End; 2]) -> Slab {
    let problem = SlabProblem {
        lower: -0.3,
        layers: layers.to_vec(),
        ends: ends.clone(),
        initial: 0.25,
    };
    problem.solve().unwrap()
}

/// In one layer.
struct Bulk(f64);

impl Equation for Bulk {
    fn dimension(&self) -> usize {
        1
    }

    fn diffusion(&self, _: [f64; 3], _: f64, _: usize) -> [[f64; 3]; 3] {
        scaled(IDENTITY, self.0)
    }
}

/// `u(x, t + from)`.
struct Later<'a>(&'a Slab, f64);

impl Solution for Later<'_> {
    fn components(&self) -> usize {
        1
    }

    fn write(&self, position: [f64; 3], time: f64, state: &mut [f64]) {
        self.0.write(position, time + self.1, state);
    }
}

/// Between the corners, and once the modes after the last of 400 are nothing. The steps are short
/// for the sake of thin layers: rounding leaves `1e-15 D/(0.01 length)^2`, up to 1e-9 of u, where
/// little heat flows and the terms are a tenth of that or less.
#[test]
fn the_equation_holds_in_every_layer() {
    for layers in stacks() {
        // Every kind on either side, and two fluxes.
        for ends in [3, 6, 9, 10, 12].map(|pair: usize| ends()[pair].clone()) {
            let slab = slab(&layers, &ends);
            let mut lower = -0.3;
            for layer in &layers {
                let half = 0.5 * layer.thickness;
                // The length is half as far as heat comes in the time since the last corner, or more.
                for (from, duration, pace, part) in [
                    (0.03, 0.06, 0.012, 0.18),
                    (0.16, 0.3, 0.1, 0.5),
                    (3.0, 2.0, 0.3, 0.6),
                ] {
                    let length = part * layer.diffusivity.sqrt();
                    let probe = Probe {
                        center: [lower + half, 0.0, 0.0],
                        size: 0.8 * half,
                        duration,
                        length: length.min(half),
                        pace,
                    };
                    let bulk = Bulk(layer.diffusivity);
                    let residual = residual(&bulk, &Later(&slab, from), probe);
                    assert!(residual < 3e-8, "{residual:e}: {ends:?} {probe:?}");
                }
                lower += layer.thickness;
            }
        }
    }
}

#[test]
fn at_first_it_is_uniform() {
    for layers in stacks() {
        for ends in ends() {
            let slab = slab(&layers, &ends);
            let later = slab.at([0.1, 0.0, 0.0], 0.3);
            for i in -5..15 {
                let place = [0.1 * f64::from(i), 0.0, 0.0];
                assert_eq!(slab.at(place, 0.0), [0.25]);
                assert_eq!(slab.at(place, -1.0), [0.25]);
            }
            assert_eq!(slab.at([0.1, 0.0, 0.0], 0.3), later);
        }
    }
}

/// Both sides of an interface, a step of 1e-9 apart: u and the flux differ by that times slopes of
/// some 20.
#[test]
fn value_and_flux_are_continuous() {
    let layers = &stacks()[1];
    for ends in ends() {
        let slab = slab(layers, &ends);
        for interface in [0.2, 0.5] {
            for time in [0.02, 0.3, 1.7] {
                let sides = [-5e-10, 5e-10].map(|step| {
                    let x = interface + step;
                    [slab.at([x, 0.0, 0.0], time)[0], slab.flux(x, time)]
                });
                for (a, b) in sides[0].iter().zip(sides[1]) {
                    assert!((a - b).abs() < 1e-7, "{interface} {time}: {a} {b}");
                }
            }
        }
    }
}

#[test]
fn the_ends_are_as_given() {
    for layers in stacks() {
        for ends in ends() {
            let slab = slab(&layers, &ends);
            for (end, (x, outwards)) in ends.iter().zip([(-0.3, -1.0), (0.9, 1.0)]) {
                for time in [0.02, 0.3, 1.7, 4.0] {
                    let u = slab.at([x, 0.0, 0.0], time)[0];
                    let flux = outwards * slab.flux(x, time);
                    let error = match end {
                        End::NoFlux => flux,
                        End::Value(drive) => u - drive.at(time),
                        End::Flux(drive) => flux - drive.at(time),
                        End::Exchange { rate, outside } => flux - rate * (u - outside.at(time)),
                    };
                    assert!(error.abs() < 1e-12, "{end:?} {time}: {error:e}");
                }
            }
        }
    }
}

/// The trapezoidal rule on 1000 steps a layer: error `step^2/12` of the difference of the slopes,
/// below `(0.5/1000)^2/12 (20) = 4e-7`.
#[test]
fn two_fluxes_take_what_they_carry() {
    for layers in stacks() {
        for ends in ends() {
            if !ends.iter().all(End::is_a_flux) {
                continue;
            }
            let slab = slab(&layers, &ends);
            for time in [0.001, 0.3, 4.0] {
                let (mut lower, mut sum) = (-0.3, 0.0);
                for layer in &layers {
                    let step = layer.thickness / 1000.0;
                    let u = |i: i32| slab.at([lower + step * f64::from(i), 0.0, 0.0], time)[0];
                    let inner = (1..1000).map(u).sum::<f64>();
                    sum += step * (0.5 * (u(0) + u(1000)) + inner);
                    lower += layer.thickness;
                }
                let step = time / 1e4;
                let left = |i: i32| {
                    let at = step * (f64::from(i) + 0.5);
                    let drives = ends.iter().filter_map(End::drive);
                    drives.map(|drive| step * drive.at(at)).sum::<f64>()
                };
                let expected = 0.25 * 1.2 - (0..10_000).map(left).sum::<f64>();
                let error = sum - expected;
                assert!(error.abs() < 4e-7, "{ends:?} {time}: {error:e}");
            }
        }
    }
}

/// Mode n has n nodes inside, counted from 1 where lambda = 0 is left out, and the modes are
/// orthogonal: Gram's matrix by the trapezoidal rule on 600 steps a layer.
#[test]
fn no_mode_is_missing() {
    let contrast = vec![layer(0.2, 1e3), layer(0.1, 1e-4), layer(0.4, 1.0)];
    for layers in [stacks()[1].clone(), contrast] {
        let stack = Layers::new(-0.3, layers.clone());
        for ends in ends() {
            let open = ends.iter().all(End::is_a_flux);
            let modes = eigenmodes(&stack, &ends, 12);
            let mut values = vec![Vec::new(); modes.len()];
            let mut weights = Vec::new();
            for (index, layer) in layers.iter().enumerate() {
                for i in 0..=600 {
                    let step = layer.thickness / 600.0;
                    let half = if i % 600 == 0 { 0.5 } else { 1.0 };
                    weights.push(half * step);
                    for (mode, values) in modes.iter().zip(&mut values) {
                        values.push(mode.at(layer, (index, step * f64::from(i)))[0]);
                    }
                }
            }
            for (n, a) in values.iter().enumerate() {
                let inside = &a[1..a.len() - 1];
                let signs = inside.windows(2).filter(|pair| pair[0] * pair[1] < 0.0);
                assert_eq!(signs.count(), if open { n + 1 } else { n }, "{ends:?}");
                for (m, b) in values.iter().enumerate() {
                    let pairs = weights.iter().zip(a.iter().zip(b));
                    let product = pairs.map(|(w, (a, b))| w * a * b).sum::<f64>();
                    let expected = if n == m { 1.0 } else { 0.0 };
                    assert!((product - expected).abs() < 1e-4, "{n} {m}: {product}");
                }
            }
        }
    }
}

#[test]
fn what_is_wrong_is_named() {
    let good = || SlabProblem {
        lower: 0.0,
        layers: stacks()[1].clone(),
        ends: [End::NoFlux, End::Value(zigzag(1.0))],
        initial: 0.0,
    };
    let text = |problem: SlabProblem| problem.solve().unwrap_err().to_string();
    let drive = |points: &[(f64, f64)]| {
        let points = points.to_vec();
        let mut problem = good();
        problem.ends[0] = End::Flux(Drive { points });
        text(problem)
    };
    let mut wrong = good();
    wrong.layers.clear();
    assert_eq!(text(wrong), "number of layers must be 1 to 100, not 0");
    let mut wrong = good();
    wrong.layers[1].thickness = 0.0;
    assert_eq!(text(wrong), "thickness must be > 0, not 0");
    let mut wrong = good();
    wrong.layers[2].diffusivity = -1.0;
    assert_eq!(text(wrong), "diffusivity must be > 0, not -1");
    let mut wrong = good();
    wrong.layers[2] = layer(1e-90, 1e30);
    let expected = "thickness / sqrt(diffusivity) must be 1e-100 to 1e100, not 0.";
    assert!(text(wrong).starts_with(expected));
    let mut wrong = good();
    wrong.ends[1] = exchange(0.0, zigzag(1.0));
    assert_eq!(text(wrong), "rate of exchange must be > 0, not 0");
    let mut wrong = good();
    wrong.initial = f64::NAN;
    assert_eq!(text(wrong), "initial must be finite, not NaN");
    assert_eq!(drive(&[]), "number of points of a drive must be > 0, not 0");
    assert_eq!(
        drive(&[(1.0, 0.0), (1.0, 2.0)]),
        "time of a drive must be above the one before, not 1"
    );
    assert_eq!(
        drive(&[(0.0, 0.0), (1e-300, 1e300)]),
        "slope of a drive must be finite, not inf"
    );
    assert_eq!(
        drive(&[(0.0, f64::INFINITY)]),
        "value of a drive must be finite, not inf"
    );
}
