//! What comes in through walls: as much as the conditions say, and all of it counted.

use fixed::types::extra::{U16, U19, U32};
use motes_core::cutoff::Named;
use motes_core::domain::{Axis, Domain, Side};
use motes_core::equation::diffusion::{
    Condition, DiffusionDynamics, Drive, DrivenCondition, Form, Heat, Mean, NamedProblem, Reaction,
};
use motes_core::equation::linear::{Particle, Still, Uniform, VelocityField};
use motes_core::integrator::{RK4, Rkl2, RungeKutta, SSP_RK3};
use motes_core::pairs::HalfLoop;
use motes_core::scalar::{Q32, Q64, Scalar};

use crate::clouds::{Slab, Storage, fill, line, storage, with_a_large_stack};

/// Numbers between 0 and 1 that look random.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }
}

/// A box of so many spacings each way, a jittered lattice in it; every wall another condition.
fn problem<'a, const D: usize>(
    dice: &mut Dice,
    walls: impl Fn(&mut Dice) -> DrivenCondition<'a, f64>,
) -> NamedProblem<'a, f64, D, 1> {
    let mut problem = NamedProblem::heat([dice.between(0.2, 2.0)]);
    for ends in &mut problem.walls {
        for end in ends {
            *end = [walls(dice)];
        }
    }
    problem
}

fn cloud<const D: usize, const N: usize>(
    dice: &mut Dice,
    counts: [u32; D],
    jitter: f64,
) -> Box<Storage<f64, D, N>> {
    let mut storage = storage::<f64, D, N>();
    let all = counts.iter().product();
    for id in 0..all {
        let mut rest = id;
        let position = counts.map(|count| {
            let i = rest % count;
            rest /= count;
            let x = f64::from(i) + 0.5 + jitter * (dice.roll() - 0.5);
            x - 0.5 * f64::from(count)
        });
        let particle = Particle {
            position,
            weight: 1.0 + jitter * (dice.roll() - 0.5),
            value: [dice.roll()],
        };
        storage.push(particle).unwrap();
    }
    storage
}

/// What the sum has changed by, and what is to have come in: by wall, and by reactions.
struct Came {
    change: f64,
    walls: Vec<[f64; 2]>,
    reactions: f64,
    time: f64,
}

impl Came {
    fn together(&self) -> f64 {
        self.walls.iter().flatten().sum::<f64>() + self.reactions
    }
}

fn run<A: VelocityField<f64, D>, const D: usize, const N: usize>(
    solver: &DiffusionDynamics<f64, Named, NamedProblem<'_, f64, D, 1>, A, D, 1>,
    storage: &mut Storage<f64, D, N>,
    method: Option<&RungeKutta>,
    steps: u32,
) -> Came {
    let (mut state, mut work) = storage.parts();
    let engine = &mut HalfLoop;
    solver.prepare(engine, &mut state, &mut work).unwrap();
    let first = state.total()[0];
    let mut time = 0.0;
    for _ in 0..steps {
        let radius = solver.radius(&state, &work).unwrap();
        let reach = method.map_or(Rkl2::with_stages(7).reach(), |method| method.real);
        let dt = solver.time_step(radius, reach, 1.0).unwrap();
        let step = (time, dt);
        match method {
            Some(method) => solver.advance(method, engine, &mut state, &mut work, step),
            None => {
                let method = Rkl2::with_stages(7);
                solver.advance_split(method, engine, &mut state, &mut work, step)
            }
        }
        .unwrap();
        time += dt;
    }
    let walls = work.ledger.walls.iter();
    Came {
        change: state.total()[0] - first,
        walls: walls
            .map(|ends| [0, 1].map(|end| ends[end][0].total()))
            .collect(),
        reactions: work.ledger.reactions[0].total(),
        time,
    }
}

fn solver<'a, A, const D: usize>(
    counts: [u32; D],
    problem: NamedProblem<'a, f64, D, 1>,
    field: A,
    form: Form,
    epsilon: f64,
) -> DiffusionDynamics<f64, Named, NamedProblem<'a, f64, D, 1>, A, D, 1> {
    DiffusionDynamics {
        domain: Domain {
            axes: counts.map(|count| {
                let half = 0.5 * f64::from(count);
                Axis::walls(-half, half)
            }),
        },
        cut_off: Named::QuinticSpline,
        epsilon,
        problem,
        field,
        form,
        mean: Mean::Arithmetic,
        courant: 0.5,
    }
}

/// Flux times area times time, whatever the width, the cloud, the form and the number of dimensions.
#[test]
fn a_given_flux_is_what_comes_in() {
    fn check<const D: usize>(counts: [u32; D], form: Form, method: Option<&RungeKutta>) {
        let dice = &mut Dice(7 + D as u64);
        for case in 0..6 {
            let jitter = [0.0, 0.3][case % 2];
            let epsilon = dice.between(0.5, 1.6);
            let flux =
                |dice: &mut Dice| DrivenCondition::Flux(Drive::Constant(dice.between(-1.0, 1.0)));
            let problem = problem(dice, flux);
            let solver = solver(counts, problem, Still, form, epsilon);
            let mut storage = cloud::<D, 256>(dice, counts, jitter);
            let came = run(&solver, &mut storage, method, 4);
            let (mut all, mut size) = (0.0, 0.0);
            for (axis, ends) in problem.walls.iter().enumerate() {
                let others = counts.iter().enumerate().filter(|(i, _)| *i != axis);
                let area: f64 = others.map(|(_, count)| f64::from(*count)).product();
                for (end, [condition]) in ends.iter().enumerate() {
                    let Condition::Flux(flux) = condition.at(0.0) else {
                        unreachable!()
                    };
                    let expected = -flux * area * came.time;
                    let came = came.walls[axis][end];
                    assert!(
                        (came - expected).abs() < 1e-12 * expected.abs(),
                        "{form:?}, {D}D, eps {epsilon}, jitter {jitter}: {came}, {expected}"
                    );
                    all += expected;
                    size += expected.abs();
                }
            }
            assert!(
                (came.change - all).abs() < 1e-11 * size,
                "{form:?}, {D}D, eps {epsilon}, jitter {jitter}: {} of {all}",
                came.change
            );
        }
    }
    with_a_large_stack(|| {
        for form in [Form::Direct, Form::Mixed] {
            for method in [None, Some(&SSP_RK3)] {
                check([20], form, method);
                check([12, 9], form, method);
                check([6, 5, 6], form, method);
            }
        }
    });
}

/// The sum changes by what is counted, to rounding: any walls, with reactions, on clouds that move too.
#[test]
fn the_balance_closes_to_rounding() {
    fn check<const D: usize>(counts: [u32; D], form: Form, method: Option<&RungeKutta>) {
        let dice = &mut Dice(70 + D as u64);
        for case in 0..6 {
            let epsilon = dice.between(0.6, 1.6);
            let any = |dice: &mut Dice| {
                let drive = Drive::Constant(dice.between(-1.0, 1.0));
                match (4.0 * dice.roll()) as u32 {
                    0 => DrivenCondition::NoFlux,
                    1 => DrivenCondition::Value(drive),
                    2 => DrivenCondition::Flux(drive),
                    _ => DrivenCondition::Exchange {
                        rate: dice.between(0.0, 2.0),
                        outside: drive,
                    },
                }
            };
            let mut problem = problem(dice, any);
            problem.reaction = Reaction::Logistic {
                rate: 0.3,
                capacity: 2.0,
            };
            let mut storage = cloud::<D, 256>(dice, counts, 0.3);
            let came = match case % 2 {
                0 => {
                    let solver = solver(counts, problem, Still, form, epsilon);
                    run(&solver, &mut storage, method, 4)
                }
                _ => {
                    let mut field = [0.0; D];
                    field[0] = 0.05;
                    let mut solver =
                        solver(counts, problem, Uniform { velocity: field }, form, epsilon);
                    // A period takes three reaches.
                    if case == 3 && D < 3 {
                        solver.epsilon = 0.9;
                        solver.domain.axes[0].sides = [Side::Periodic; 2];
                    }
                    run(&solver, &mut storage, method, 4)
                }
            };
            let size: f64 = came.walls.iter().flatten().map(|came| came.abs()).sum();
            let off = came.change - came.together();
            assert!(
                off.abs() < 1e-12 * (size + came.reactions.abs() + 100.0),
                "{form:?}, {D}D, case {case}: {} of {}",
                came.change,
                came.together()
            );
            assert!(came.reactions != 0.0);
        }
    }
    with_a_large_stack(|| {
        for form in [Form::Direct, Form::Mixed] {
            for method in [None, Some(&RK4)] {
                check([20], form, method);
                check([12, 9], form, method);
                check([6, 5, 6], form, method);
            }
        }
    });
}

/// In fixed point a Runge-Kutta method keeps the balance to the last bit, and a given flux comes in but
/// for the rounding of a step.
#[test]
fn the_balance_is_exact_in_fixed_point() {
    fn check<S: Scalar>(form: Form) {
        let n = 40;
        let ends = [
            Condition::Flux(S::from_f64(-0.25)),
            Condition::Exchange {
                rate: S::from_f64(0.3),
                outside: S::from_f64(2.0),
            },
        ];
        let mut storage = storage::<S, 1, 64>();
        fill(&mut storage, n, |x| (0.3 * x).cos());
        let solver = line::<S, _>(n, Slab { ends }, form, 1.3);
        let (mut state, mut work) = storage.parts();
        let engine = &mut HalfLoop;
        solver.prepare(engine, &mut state, &mut work).unwrap();
        let first = state.total()[0];
        let dt = S::from_f64(0.25);
        for i in 0..40 {
            let step = (S::from_f64(0.25 * f64::from(i)), dt);
            solver
                .advance(&RK4, engine, &mut state, &mut work, step)
                .unwrap();
        }
        let [lower, upper] = [0, 1].map(|end| work.ledger.walls[0][end][0].total());
        let expected = S::wide_sum(first, S::wide_sum(lower, upper));
        assert_eq!(S::wide_bits(state.total()[0]), S::wide_bits(expected));
        let (lower, upper) = (S::wide_to_f64(lower), S::wide_to_f64(upper));
        assert!((lower / 2.5 - 1.0).abs() < 2e-4, "{form:?}: {lower}");
        assert!(upper > 0.1, "{form:?}: {upper}");
    }
    for form in [Form::Direct, Form::Mixed] {
        check::<Q32<U19>>(form);
        check::<Q32<U16>>(form);
        check::<Q64<U32>>(form);
    }
}

/// A line that falls from a wall with a given flux to one that is held, and the same through walls that
/// exchange, is steady at any width: pairs conduct as much as walls let in.
#[test]
fn straight_lines_are_steady_at_any_width() {
    let (n, slope, b) = (40, 0.03, 0.5);
    let u = |x: f64| 2.0 + slope * x;
    for form in [Form::Direct, Form::Mixed] {
        for epsilon in [0.5, 0.62, 0.9, 1.37] {
            let exchange = Condition::Exchange {
                rate: 0.2,
                outside: u(20.0) + b * slope / 0.2,
            };
            let far = match form {
                Form::Direct => exchange,
                // What each particle pays by itself is an integral.
                Form::Mixed => Condition::Value(u(20.0)),
            };
            let mut storage = storage::<f64, 1, 64>();
            fill(&mut storage, n, u);
            let ends = [Condition::Flux(b * slope), far];
            let solver = line(n, Slab { ends }, form, epsilon);
            let (mut state, mut work) = storage.parts();
            solver
                .prepare(&mut HalfLoop, &mut state, &mut work)
                .unwrap();
            for (k, rates) in work.last.iter().take(n as usize).enumerate() {
                let rate = rates.strength[0];
                assert!(rate.abs() < 1e-14, "{form:?} eps {epsilon} at {k}: {rate}");
            }
        }
    }
}

/// A wall that exchanges little takes `rate (u - outside)` of an even state.
#[test]
fn a_wall_that_exchanges_takes_its_rate_times_the_difference() {
    for form in [Form::Direct, Form::Mixed] {
        for epsilon in [0.55, 0.8, 1.2] {
            let rate = 1e-6;
            let outside = -1.0;
            let exchange = Condition::Exchange { rate, outside };
            let mut storage = storage::<f64, 1, 64>();
            fill(&mut storage, 30, |_| 2.0);
            let ends = [Condition::NoFlux, exchange];
            let solver = line(30, Slab { ends }, form, epsilon);
            let (mut state, mut work) = storage.parts();
            let engine = &mut HalfLoop;
            solver.prepare(engine, &mut state, &mut work).unwrap();
            let step = (0.0, 0.125);
            solver
                .advance(&SSP_RK3, engine, &mut state, &mut work, step)
                .unwrap();
            let came = work.ledger.walls[0][1][0].total() / 0.125;
            // What the layer before the wall resists besides is of the order of rate ε/b.
            assert!(
                (came / (-3.0 * rate) - 1.0).abs() < 1e-5,
                "{form:?}: {came}"
            );
        }
    }
}

/// The heat that a held wall gives is that of the exact solution: `2 √(b t/π)` for a step of 1.
#[test]
fn a_held_wall_gives_what_the_slab_takes() {
    let n = 100;
    let ends = [Condition::Value(1.0), Condition::NoFlux];
    let mut storage = storage::<f64, 1, 128>();
    fill(&mut storage, n, |_| 0.0);
    let solver = line(n, Slab { ends }, Form::Direct, 1.5);
    let (mut state, mut work) = storage.parts();
    crate::clouds::run(&solver, &SSP_RK3, &mut state, &mut work, 400.0);
    let came = work.ledger.walls[0][0][0].total();
    let exact = 2.0 * (0.5 * 400.0 / std::f64::consts::PI).sqrt();
    assert!((came / exact - 1.0).abs() < 5e-3, "{came}, {exact}");
    assert!((came - state.total()[0]).abs() < 1e-12);
}

/// Nothing is counted where nothing comes in, and the bits are those of a cloud without walls to pass.
#[test]
fn closed_walls_let_nothing_in() {
    let mut storage = storage::<f64, 1, 64>();
    fill(&mut storage, 30, |x| x);
    let solver = line(30, Heat { diffusivity: 1.0 }, Form::Direct, 1.2);
    let (mut state, mut work) = storage.parts();
    crate::clouds::run(&solver, &SSP_RK3, &mut state, &mut work, 3.0);
    for ends in &work.ledger.walls[0] {
        assert_eq!(ends[0].total(), 0.0);
    }
}
