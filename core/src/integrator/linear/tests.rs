//! Acoustics on a moving cloud: accuracy, conservation, walls, probe; engines among each other.

use std::boxed::Box;
use std::vec::Vec;

use fixed::types::extra::{U16, U19, U32};

use crate::cutoff::Named;
use crate::domain::{Axis, Domain};
use crate::equation::linear::systems::{Acoustics, Telegraph, Transport, Units};
use crate::equation::linear::{LinearDynamics, LinearStorage, Nothing, Particle, State, Wave};
use crate::error::Error;
use crate::integrator::{Clock, RK4, RungeKutta};
use crate::pairs::{Engine, HalfLoop, PlainLoop};
use crate::scalar::{Q32, Q64, Scalar, cosine_of_turns, sine_of_turns};

const MOST: usize = 1024;
const CELLS: usize = 4 * MOST + 129;
type Storage<S, const P: usize> = LinearStorage<S, Nothing, 1, P, MOST, CELLS>;
type Tube<S> = LinearDynamics<S, Named, Acoustics<S>, Wave<S>, 1, 2>;

/// The wave problem of `[0, 1]` with `n` particles, in units of their spacing, centred on 0:
/// periodic, `a = α sin 2πx`, c = 1.
fn solver<S: Scalar>(n: u32, cut_off: Named, epsilon: f64, amplitude: f64) -> Tube<S> {
    let half = S::count(n).half();
    LinearDynamics::new(
        Domain {
            axes: [Axis::periodic(-half, half)],
        },
        (cut_off, S::from_f64(epsilon)),
        Acoustics::new(1.0, 1.0, Units::ONE),
        Wave {
            amplitude: S::from_f64(amplitude),
            length: S::count(n),
            phase: S::ONE.half(),
        },
        S::ONE.half(),
    )
}

/// Particles at the middles of cells, `p = exp(sin 2πx)`, `v = 0`.
fn fill<S: Scalar>(storage: &mut Storage<S, 2>, n: u32) {
    for k in 0..n {
        let x = (f64::from(k) + 0.5) / f64::from(n);
        let particle = Particle {
            position: [S::from_f64((x - 0.5) * f64::from(n))],
            weight: S::ONE,
            value: [S::from_f64(libm::exp(sine_of_turns(x))), S::ZERO],
        };
        storage.push(particle).unwrap();
    }
}

/// Runs to `end`, a part of the box.
fn run<S: Scalar>(
    solver: &Tube<S>,
    method: &RungeKutta,
    engine: &mut impl Engine<S, 1>,
    storage: &mut Storage<S, 2>,
    end: S,
) -> Result<u64, Error> {
    let (mut state, mut work) = storage.parts();
    solver.prepare(engine, &mut state, &mut work)?;
    let mut clock = Clock::new(end);
    while let Some(left) = clock.left() {
        let dt = solver.time_step(&state, clock.time, method.stability(), left)?;
        solver.advance(method, engine, &mut state, &mut work, (clock.time, dt))?;
        clock.tick(dt)?;
    }
    Ok(clock.steps)
}

/// L2 over both components against d'Alembert at t = 1/4.
fn error(n: u32, cut_off: Named, epsilon: f64) -> f64 {
    let mut storage = Box::new(Storage::<f64, 2>::new());
    fill(&mut storage, n);
    let solver = solver(n, cut_off, epsilon, 0.2);
    let end = 0.25 * f64::from(n);
    run(&solver, &RK4, &mut HalfLoop, &mut storage, end).unwrap();
    let (state, _) = storage.parts();
    let (mut sum, mut total) = (0.0, 0.0);
    for k in 0..state.len() {
        let x = state.position[k][0] / f64::from(n) + 0.5;
        let [right, left] = [x - 0.25, x + 0.25].map(|x| libm::exp(sine_of_turns(x)));
        let exact = [0.5 * (right + left), 0.5 * (right - left)];
        let w = state.weight[k];
        for (u, exact) in state.value[k].iter().zip(exact) {
            sum += w * (u - exact) * (u - exact);
        }
        total += w;
    }
    libm::sqrt(sum / total)
}

/// `ε = C h^θ` in spacings.
fn width(n: u32, constant: f64, theta: f64) -> f64 {
    constant * libm::pow(f64::from(n), 1.0 - theta)
}

#[test]
fn acoustics_on_a_moving_cloud_has_the_predicted_order() {
    for (cut_off, constant, ladder, bound, expected, room) in [
        (
            Named::QuinticSpline,
            0.7,
            [256, 512, 1024],
            4.6e-4,
            1.5,
            0.1,
        ),
        (Named::SmoothFour, 1.0, [64, 128, 256], 1.0, 3.0, 0.3),
    ] {
        let errors = ladder.map(|n| error(n, cut_off, width(n, constant, 0.75)));
        for pair in errors.windows(2) {
            let order = libm::log2(pair[0] / pair[1]);
            assert!(
                (order - expected).abs() < room,
                "{cut_off:?}: {errors:?}, order {order}"
            );
        }
        assert!(errors[2] <= bound, "{cut_off:?}: {errors:?}");
    }
    let finest = error(1024, Named::SmoothFour, width(1024, 1.0, 0.75));
    assert!(finest <= 2e-6, "{finest}");
}

/// The wave problem in a scalar, a quarter of the box long, by the engine; the storage at its end.
fn wave<S: Scalar>(method: &RungeKutta, engine: &mut impl Engine<S, 1>) -> Box<Storage<S, 2>> {
    let n = 64;
    let mut storage = Box::new(Storage::<S, 2>::new());
    fill(&mut storage, n);
    let solver = solver::<S>(n, Named::QuinticSpline, 1.98, 0.2);
    run(&solver, method, engine, &mut storage, S::count(n / 4)).unwrap();
    storage
}

/// Bits of all that the state is.
fn bits<S: Scalar>(storage: &mut Storage<S, 2>) -> Vec<u128> {
    let (state, _) = storage.parts();
    let places = state.position.iter().map(|[x]| u128::from(x.bits()));
    let weights = state.weight.iter().map(|w| u128::from(w.bits()));
    let strengths = state.strength.iter().flatten().map(|&q| S::wide_bits(q));
    places.chain(weights).chain(strengths).collect()
}

#[test]
fn the_half_loop_gives_the_bits_of_the_plain_loop() {
    fn check<S: Scalar>() {
        for method in RungeKutta::ALL {
            let plain = bits(&mut wave::<S>(&method, &mut PlainLoop));
            let half = bits(&mut wave::<S>(&method, &mut HalfLoop));
            assert_eq!(plain, half, "{}", method.name);
        }
    }
    check::<f64>();
    check::<f32>();
    check::<Q32<U19>>();
    check::<Q64<U32>>();
}

/// (1.21)' without losses: in fixed point Σ q is the same number at the end, to the last bit of
/// the double width, with weights that have become unequal on the way; in floats to rounding.
#[test]
fn the_sum_of_strengths_is_conserved() {
    fn drift<S: Scalar>(method: &RungeKutta) -> (f64, bool) {
        let mut before = Box::new(Storage::<S, 2>::new());
        fill(&mut before, 64);
        let first = before.parts().0.total();
        let mut after = wave::<S>(method, &mut HalfLoop);
        let (state, _) = after.parts();
        let spread = state.weight.iter().map(|w| w.to_f64());
        let widest = spread.clone().fold(0.0, f64::max) - spread.fold(2.0, f64::min);
        assert!(widest > 0.3, "the weights hardly changed: {widest}");
        let last = state.total();
        let moved = |i: usize| S::rounded(last[i]).to_f64() - S::rounded(first[i]).to_f64();
        let same = (0..2).all(|i| S::wide_bits(last[i]) == S::wide_bits(first[i]));
        (moved(0).abs().max(moved(1).abs()), same)
    }
    for method in RungeKutta::ALL {
        assert!(drift::<Q32<U19>>(&method).1, "q12.19, {}", method.name);
        assert!(drift::<Q32<U16>>(&method).1, "q15.16, {}", method.name);
        assert!(drift::<Q64<U32>>(&method).1, "q31.32, {}", method.name);
        // 64 strengths of size 1, some hundred additions each.
        assert!(drift::<f64>(&method).0 < 1e-12);
        assert!(drift::<f32>(&method).0 < 1e-3);
    }
}

/// (1.21)' with losses: on a line whose voltage has a mean, `d/dt Σ q = -(G/C) Σ q` whatever passes
/// between the particles.
#[test]
fn the_sum_of_strengths_decays_as_its_losses_say() {
    let n = 64;
    let mut storage = Box::new(Storage::<f64, 2>::new());
    for k in 0..n {
        let x = (f64::from(k) + 0.5) / f64::from(n);
        let particle = Particle {
            position: [(x - 0.5) * f64::from(n)],
            weight: 1.0,
            value: [1.5 + sine_of_turns(x), 0.2],
        };
        storage.push(particle).unwrap();
    }
    let waves = solver::<f64>(n, Named::QuinticSpline, 1.98, 0.2);
    let losses = [0.03, 0.02];
    let system = Telegraph::new([1.0, 1.0], losses, Units::ONE);
    let width = (waves.cut_off, waves.epsilon);
    let line = LinearDynamics::new(waves.domain, width, system, waves.field, 0.5);
    let (mut state, mut work) = storage.parts();
    let engine = &mut HalfLoop;
    line.prepare(engine, &mut state, &mut work).unwrap();
    let first = state.total();
    let mut clock = Clock::new(20.0);
    while let Some(left) = clock.left() {
        let dt = line
            .time_step(&state, clock.time, RK4.stability(), left)
            .unwrap();
        let step = (clock.time, dt);
        line.advance(&RK4, engine, &mut state, &mut work, step)
            .unwrap();
        clock.tick(dt).unwrap();
    }
    for (i, (last, first)) in state.total().iter().zip(first).enumerate() {
        let exact = first * libm::exp(-losses[i] * 20.0);
        // The integrator's own error, (λ dt)⁴/120 λ t with λ dt = 0.06: 6.5e-8.
        assert!((last / exact - 1.0).abs() < 1e-7, "{i}: {last} {exact}");
    }
}

/// Between walls, with `v` odd across them, a standing wave keeps its shape: `p = cos πx cos πt`.
#[test]
fn a_wall_reflects_waves_as_its_parity_says() {
    let n = 128;
    let mut storage = Box::new(Storage::<f64, 2>::new());
    for k in 0..n {
        let x = (f64::from(k) + 0.5) / f64::from(n);
        let particle = Particle {
            position: [(x - 0.5) * f64::from(n)],
            weight: 1.0,
            value: [cosine_of_turns(0.5 * x), 0.0],
        };
        storage.push(particle).unwrap();
    }
    let half = 0.5 * f64::from(n);
    let mut solver = solver(n, Named::SmoothFour, 3.3, 0.0);
    solver.domain.axes = [Axis::walls(-half, half)];
    let end = 0.3;
    let clock_end = end * f64::from(n);
    run(&solver, &RK4, &mut HalfLoop, &mut storage, clock_end).unwrap();
    let (state, _) = storage.parts();
    for (x, u) in state.position.iter().zip(state.value.iter()) {
        let x = x[0] / f64::from(n) + 0.5;
        let pressure = cosine_of_turns(0.5 * x) * cosine_of_turns(0.5 * end);
        let velocity = sine_of_turns(0.5 * x) * sine_of_turns(0.5 * end);
        let off = (u[0] - pressure).abs().max((u[1] - velocity).abs());
        assert!(off < 2e-5, "at {x}: {u:?}, {off}");
    }
}

/// On particles that follow the flow nothing passes between them: `u_k` decays as `e^-λt` to the
/// accuracy of the integrator, whatever the cut-off.
#[test]
fn carried_particles_have_the_error_of_the_integrator_alone() {
    let n = 64;
    let (decay, end) = (0.02, 32.0);
    let error = |courant: f64| {
        let mut storage = Box::new(Storage::<f64, 1>::new());
        let profile = |x: f64| libm::exp(-x * x / 50.0);
        for k in 0..n {
            let x = f64::from(k) + 0.5 - 32.0;
            let value = [profile(x)];
            let particle = Particle {
                position: [x],
                weight: 1.0,
                value,
            };
            storage.push(particle).unwrap();
        }
        let flow = Wave {
            amplitude: 0.3,
            length: f64::from(n),
            phase: 0.0,
        };
        let system = Transport {
            velocity: flow,
            decay,
            source: 0.0,
        };
        let half = 0.5 * f64::from(n);
        let domain = Domain {
            axes: [Axis::periodic(-half, half)],
        };
        let cut_off = (Named::QuinticSpline, 1.4);
        let solver = LinearDynamics::new(domain, cut_off, system, flow, courant);
        let (mut state, mut work) = storage.parts();
        let engine = &mut HalfLoop;
        solver.prepare(engine, &mut state, &mut work).unwrap();
        let mut clock = Clock::new(end);
        while let Some(left) = clock.left() {
            let dt = solver
                .time_step(&state, clock.time, RK4.stability(), left)
                .unwrap();
            let step = (clock.time, dt);
            solver
                .advance(&RK4, engine, &mut state, &mut work, step)
                .unwrap();
            clock.tick(dt).unwrap();
        }
        // u w = u0 w0 e^-λt along a characteristic, w0 = 1: the weight is the Jacobian.
        let mut worst: f64 = 0.0;
        for k in 0..n as usize {
            let foot = k as f64 + 0.5 - 32.0;
            let exact = profile(foot) * libm::exp(-decay * end);
            let q = state.value[k][0] * state.weight[k];
            worst = worst.max((q - exact).abs());
        }
        worst
    };
    let (coarse, fine) = (error(0.8), error(0.4));
    let order = libm::log2(coarse / fine);
    assert!((order - 4.0).abs() < 0.3, "{coarse} {fine}: order {order}");
    assert!(fine < 1e-6, "{fine}");
}

/// (1.13) of a smooth function is off by O(ε^r), on particles and between them.
#[test]
fn a_probe_sees_the_field() {
    let n = 256;
    let errors = [2.0, 4.0].map(|epsilon| {
        let mut storage = Box::new(Storage::<f64, 2>::new());
        fill(&mut storage, n);
        let solver = solver(n, Named::SmoothTwo, epsilon, 0.0);
        let (state, mut work) = storage.parts();
        let points: Vec<[f64; 1]> = (0..40).map(|i| [f64::from(i) * 6.31 - 126.0]).collect();
        let mut values = std::vec![[0.0; 2]; points.len()];
        let probed = solver.reconstruct(&state, &mut work, &points, &mut values);
        probed.unwrap();
        let off = points.iter().zip(&values).map(|([x], value)| {
            let exact = libm::exp(sine_of_turns(x / 256.0 + 0.5));
            assert_eq!(value[1], 0.0);
            (value[0] - exact).abs()
        });
        off.fold(0.0, f64::max)
    });
    let order = libm::log2(errors[1] / errors[0]);
    assert!((order - 2.0).abs() < 0.1, "{errors:?}: order {order}");
}

#[test]
fn what_no_run_can_start_from_is_refused() {
    let mut storage = Box::new(Storage::<f64, 2>::new());
    fill(&mut storage, 64);
    let alone = solver(64, Named::QuinticSpline, 0.3, 0.0);
    let (mut state, mut work) = storage.parts();
    let prepared = alone.prepare(&mut HalfLoop, &mut state, &mut work);
    assert_eq!(prepared, Err(Error::Isolated { particle: 0 }));
    let good = solver(64, Named::QuinticSpline, 1.4, 0.0);
    state.weight[5] = 0.0;
    let prepared = good.prepare(&mut HalfLoop, &mut state, &mut work);
    assert_eq!(prepared, Err(Error::Weight { particle: 5 }));
    state.weight[5] = f64::NAN;
    assert!(good.prepare(&mut HalfLoop, &mut state, &mut work).is_err());
}

/// The stated limit holds: at it a random state does not grow, at twice the limit it does.
#[test]
fn the_stable_step_is_stable_and_not_idle() {
    for method in RungeKutta::ALL {
        let grown = |factor: f64| {
            let mut storage = Box::new(Storage::<f64, 2>::new());
            fill(&mut storage, 64);
            let solver = solver(64, Named::QuinticSpline, 1.4, 0.0);
            let (mut state, mut work) = storage.parts();
            let mut seed = 1u32;
            for value in state.value.iter_mut().flatten() {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                *value = f64::from(seed >> 8) / f64::from(1 << 24) - 0.5;
            }
            let engine = &mut HalfLoop;
            solver.prepare(engine, &mut state, &mut work).unwrap();
            let energy = |state: &State<'_, f64, 1, 2>| -> f64 {
                state.value.iter().flatten().map(|u| u * u).sum()
            };
            let before = energy(&state);
            let limit = solver
                .stable_step(&state, 0.0, method.stability())
                .unwrap()
                .unwrap();
            for _ in 0..200 {
                let step = (0.0, factor * limit);
                solver
                    .advance(&method, engine, &mut state, &mut work, step)
                    .unwrap();
            }
            energy(&state) / before
        };
        assert!(grown(1.0) < 1.01, "{}: {}", method.name, grown(1.0));
        assert!(grown(2.5) > 10.0, "{}: {}", method.name, grown(2.5));
    }
}
