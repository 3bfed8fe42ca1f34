//! The run that can be held: the same bits as its parts called one by one, the last good state after
//! an error, and a state that can be written down and read back.

mod small_tube;

use motes_core::cloud::{Column, ColumnMut, Columns, Particle, Remaining, Save, Still, Wave};
use motes_core::cutoff::{CubicSpline, QuinticSpline};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::diffusion::{
    DiffusionDynamics, DiffusionStorage, Drive, DrivenCondition, Form, Mean, NamedProblem,
};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{GasDynamics, Plain, PlainStorage};
use motes_core::equation::linear::systems::{Acoustics, Units};
use motes_core::equation::linear::{LinearDynamics, LinearStorage};
use motes_core::error::{Error, Parameter};
use motes_core::integrator::{Clock, DiffusionMethod, LeapFrog, RK4, Scheme, Stepper};
use motes_core::material::IdealGas;
use motes_core::neighbours::cell_bound;
use motes_core::pairs::{HalfLoop, Nothing};
use small_tube::TUBE;

const N: usize = 96;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

type GasMemory = PlainStorage<f64, 1, N, CELLS>;
type Gas<'a> = GasDynamics<'a, f64, CubicSpline, Pairwise<f64>, IdealGas<f64>, Plain<f64, 1>, 1>;
type LineMemory = LinearStorage<f64, Nothing, 1, 2, N, CELLS>;
type Line = LinearDynamics<f64, QuinticSpline, Acoustics<f64>, Still, 1, 2>;
type WallMemory = DiffusionStorage<f64, 1, 1, N, CELLS>;
type Wall = DiffusionDynamics<f64, QuinticSpline, NamedProblem<'static, f64, 1, 1>, Still, 1, 1>;

fn gas(materials: &[IdealGas<f64>; 1]) -> Gas<'_> {
    TUBE.solver(CubicSpline, Pairwise(Coefficients::usual()), materials)
}

fn gas_memory() -> GasMemory {
    let mut memory = GasMemory::new();
    TUBE.fill(|particle| memory.push(particle)).unwrap();
    memory
}

fn line() -> Line {
    let domain = Domain {
        axes: [Axis::walls(0.0, 64.0)],
    };
    let sound = Acoustics::new(1.0, 1.0, Units::ONE);
    LinearDynamics::new(domain, (QuinticSpline, 1.5), sound, Still, 0.5)
}

fn line_memory() -> LineMemory {
    let mut memory = LineMemory::new();
    for k in 0..64 {
        let x = f64::from(k) + 0.5;
        let pressure = if k < 32 { 1.0 } else { 0.25 };
        let particle = Particle {
            position: [x],
            weight: 1.0,
            value: [pressure, 0.0],
        };
        memory.push(particle).unwrap();
    }
    memory
}

/// A wall of 64 spacings, held at 1 on its lower side.
fn wall() -> Wall {
    let mut problem = NamedProblem::heat([1.0]);
    problem.walls[0][0] = [DrivenCondition::Value(Drive::Constant(1.0))];
    DiffusionDynamics {
        domain: Domain {
            axes: [Axis::walls(0.0, 64.0)],
        },
        cut_off: QuinticSpline,
        epsilon: 1.5,
        problem,
        field: Still,
        form: Form::Direct,
        mean: Mean::Arithmetic,
        courant: 0.5,
    }
}

fn wall_memory() -> WallMemory {
    let mut memory = WallMemory::new();
    for k in 0..64 {
        let particle = Particle {
            position: [f64::from(k) + 0.5],
            weight: 1.0,
            value: [0.0],
        };
        memory.push(particle).unwrap();
    }
    memory
}

const METHOD: DiffusionMethod<f64> = DiffusionMethod {
    scheme: Scheme::Stabilised(9),
    longest: 1e9,
};

#[test]
fn steps_have_the_bits_of_their_parts_called_one_by_one() {
    let materials = [TUBE.material()];
    let mut held = Stepper::new(gas(&materials), LeapFrog, HalfLoop, gas_memory()).unwrap();
    held = held.until(TUBE.end);
    while held.step().unwrap().is_some() {}
    let solver = gas(&materials);
    let mut memory = gas_memory();
    let (mut state, mut work) = memory.parts();
    let mut clock = Clock::new(TUBE.end);
    solver
        .prepare(&mut HalfLoop, &mut state, &mut work)
        .unwrap();
    while let Some(left) = clock.left() {
        let dt = solver.time_step(&state, left).unwrap();
        solver
            .advance(&mut HalfLoop, &mut state, &mut work, dt)
            .unwrap();
        clock.tick(dt).unwrap();
    }
    assert!(clock.steps > 20);
    assert_eq!(held.state().digest(), state.digest());
    assert_eq!(
        (held.clock().time, held.clock().steps),
        (TUBE.end, clock.steps)
    );

    let mut held = Stepper::new(line(), RK4, HalfLoop, line_memory()).unwrap();
    held.advance_to(10.0).unwrap();
    let (solver, mut memory) = (line(), line_memory());
    let (mut state, mut work) = memory.parts();
    let mut clock = Clock::new(10.0);
    solver
        .prepare(&mut HalfLoop, &mut state, &mut work)
        .unwrap();
    while let Some(left) = clock.left() {
        let dt = solver
            .time_step(&state, clock.time, RK4.stability(), left)
            .unwrap();
        let step = (clock.time, dt);
        solver
            .advance(&RK4, &mut HalfLoop, &mut state, &mut work, step)
            .unwrap();
        clock.tick(dt).unwrap();
    }
    assert_eq!(held.state().digest(), state.digest());
    assert_eq!(held.clock().time, 10.0);
}

/// What a sensor says may be nonsense: it is named, the wall stays as it was, and goes on with the
/// bits of a run that has never met it.
#[test]
fn a_number_at_a_wall_that_is_not_finite_is_refused_before_it_touches_the_state() {
    let run = |nonsense: Option<f64>| {
        let mut wall = Stepper::new(wall(), METHOD, HalfLoop, wall_memory()).unwrap();
        wall.advance_to(4.0).unwrap();
        if let Some(nonsense) = nonsense {
            let before = wall.state().digest();
            let sound = wall.dynamics.problem.walls;
            wall.dynamics.problem.walls[0][0] = [DrivenCondition::Value(Drive::Constant(nonsense))];
            let wall_of_error = Parameter::Wall { axis: 0, end: 0 };
            let expected = Error::Parameter {
                parameter: wall_of_error,
            };
            assert_eq!(wall.step(), Err(expected));
            assert_eq!(wall.state().digest(), before);
            assert!(expected.to_string().contains("lower wall in direction 0"));
            wall.dynamics.problem.walls = sound;
        }
        wall.advance_to(16.0).unwrap();
        let warm = wall.state().value[3][0];
        assert!(warm > 0.1 && warm < 1.0, "{warm}");
        wall.state().digest()
    };
    let expected = run(None);
    for nonsense in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(run(Some(nonsense)), expected, "{nonsense}");
    }
}

#[test]
fn a_step_that_fails_leaves_the_last_good_state_and_the_run_goes_on() {
    let materials = [TUBE.material()];
    let run = |fails: bool| {
        let mut tube = Stepper::new(gas(&materials), LeapFrog, HalfLoop, gas_memory()).unwrap();
        tube.advance_to(2.0).unwrap();
        if fails {
            let (before, clock) = (tube.state().digest(), *tube.clock());
            // Positions and widths have changed when this is seen.
            let sound = tube.dynamics.smallest_omega;
            tube.dynamics.smallest_omega = 1e3;
            assert!(matches!(tube.step(), Err(Error::Omega { .. })));
            assert_eq!((tube.state().digest(), *tube.clock()), (before, clock));
            tube.dynamics.smallest_omega = sound;
        }
        tube.advance_to(4.0).unwrap();
        tube.state().digest()
    };
    assert_eq!(run(true), run(false));

    // A system whose step overflows: the strengths go back too.
    let run = |fails: bool| {
        let mut line = Stepper::new(line(), RK4, HalfLoop, line_memory()).unwrap();
        line.advance_to(2.0).unwrap();
        if fails {
            let before = line.state().digest();
            line.step = Some(f64::MAX);
            assert!(line.step().is_err());
            assert_eq!(line.state().digest(), before);
            line.step = None;
        }
        line.advance_to(4.0).unwrap();
        line.state().digest()
    };
    assert_eq!(run(true), run(false));
}

/// Copies every field from one state to another, through the description alone.
fn copy(from: &impl Columns<f64>, to: &mut impl Columns<f64>) {
    for field in 0..from.fields().len() {
        match (from.column(field), to.column_mut(field)) {
            (Some(Column::Scalars(from)), Some(ColumnMut::Scalars(to))) => to.copy_from_slice(from),
            (Some(Column::Strengths(from)), Some(ColumnMut::Strengths(to))) => {
                to.copy_from_slice(from);
            }
            (Some(Column::Integers(from)), Some(ColumnMut::Integers(to))) => {
                to.copy_from_slice(from);
            }
            other => panic!("{field}: {other:?}"),
        }
    }
    assert!(from.column(from.fields().len()).is_none());
}

/// What the description lists is all that the next step starts from.
#[test]
fn a_state_that_is_copied_field_by_field_goes_on_with_the_same_bits() {
    let materials = [TUBE.material()];
    let mut first = Stepper::new(gas(&materials), LeapFrog, HalfLoop, gas_memory()).unwrap();
    first.advance_to(2.0).unwrap();
    let mut memory = gas_memory();
    copy(&first.state(), &mut memory.parts().0);
    let mut second = Stepper::resumed(gas(&materials), LeapFrog, HalfLoop, memory);
    second.set_time(2.0);
    for run in [&mut first, &mut second] {
        run.advance_to(5.0).unwrap();
    }
    assert_eq!(first.state().digest(), second.state().digest());

    let mut first = Stepper::new(wall(), METHOD, HalfLoop, wall_memory()).unwrap();
    first.advance_to(4.0).unwrap();
    let mut memory = wall_memory();
    copy(&first.state(), &mut memory.parts().0);
    let mut second = Stepper::resumed(wall(), METHOD, HalfLoop, memory);
    second.set_time(4.0);
    for run in [&mut first, &mut second] {
        run.advance_to(9.0).unwrap();
    }
    assert_eq!(first.state().digest(), second.state().digest());
}

/// Saves a run, and what the words come to after it.
fn saved(pass: impl FnOnce(&mut dyn FnMut(&[u8]) -> Result<(), Error>)) -> Vec<u8> {
    let mut memory = Vec::new();
    pass(&mut |bytes| {
        memory.extend_from_slice(bytes);
        Ok(())
    });
    memory
}

/// Makes a run, saves it after some steps, loads that into another one at its start, and goes on with both.
macro_rules! goes_on_with_the_same_bits {
    ($run:expr, $steps:expr) => {
        for steps in 0..$steps {
            let mut first = $run;
            for _ in 0..steps {
                first.step().unwrap().unwrap();
            }
            let words = saved(|put| first.pass(&mut Save(put)).unwrap());
            let mut second = $run;
            second.pass(&mut Remaining(&words)).unwrap();
            assert_eq!(second.clock(), first.clock());
            assert_eq!(second.evaluations(), first.evaluations());
            for _ in 0..5 {
                assert_eq!(second.step(), first.step());
            }
            assert_eq!(second.state().digest(), first.state().digest(), "{steps}");
            // Saving has changed nothing either.
            let mut third = $run;
            for _ in 0..steps + 5 {
                third.step().unwrap().unwrap();
            }
            assert_eq!(third.state().digest(), first.state().digest(), "{steps}");
        }
    };
}

/// As a device that loses its power at any step.
#[test]
fn a_run_that_is_saved_and_loaded_at_any_step_goes_on_with_the_same_bits() {
    let materials = [TUBE.material()];
    goes_on_with_the_same_bits!(
        Stepper::new(gas(&materials), LeapFrog, HalfLoop, gas_memory()).unwrap(),
        20
    );
    goes_on_with_the_same_bits!(
        Stepper::new(line(), RK4, HalfLoop, line_memory()).unwrap(),
        20
    );
    goes_on_with_the_same_bits!(
        Stepper::new(wall(), METHOD, HalfLoop, wall_memory()).unwrap(),
        10
    );
    // A cloud that moves and is squeezed: the step follows from what the last stage saw.
    let squeezed = |form| DiffusionDynamics {
        domain: Domain {
            axes: [Axis::periodic(0.0, 64.0)],
        },
        cut_off: QuinticSpline,
        epsilon: 1.5,
        problem: NamedProblem::heat([1.0]),
        field: Wave {
            amplitude: 0.5,
            length: 64.0,
            phase: 0.1,
        },
        form,
        mean: Mean::Arithmetic,
        courant: 0.5,
    };
    let by_runge_kutta = DiffusionMethod {
        scheme: Scheme::RungeKutta(RK4),
        longest: 1e9,
    };
    let forms = [Form::Direct, Form::Mixed];
    for (form, method) in forms.into_iter().zip([by_runge_kutta, METHOD]) {
        goes_on_with_the_same_bits!(
            Stepper::new(squeezed(form), method, HalfLoop, wall_memory()).unwrap(),
            10
        );
    }
}

#[test]
fn words_that_end_too_soon_or_of_another_cloud_are_refused() {
    let mut run = Stepper::new(line(), RK4, HalfLoop, line_memory()).unwrap();
    run.advance_to(2.0).unwrap();
    let words = saved(|put| run.pass(&mut Save(put)).unwrap());
    let fresh = || Stepper::new(line(), RK4, HalfLoop, line_memory()).unwrap();
    for length in 0..words.len() {
        let short = fresh().pass(&mut Remaining(&words[..length]));
        assert_eq!(short, Err(Error::Truncated), "{length}");
    }
    let mut smaller = fresh();
    smaller.swap_remove(5);
    assert_eq!(smaller.pass(&mut Remaining(&words)), Err(Error::Lengths));
    assert!(Error::Truncated.to_string().contains("too small"));
}

#[test]
fn particles_come_and_go_up_to_the_capacity_in_every_family() {
    let mut line = Stepper::new(line(), RK4, HalfLoop, line_memory()).unwrap();
    line.advance_to(1.0).unwrap();
    let last = {
        let state = line.state();
        (state.position[63], state.value[63])
    };
    line.swap_remove(3);
    let state = line.state();
    assert_eq!(
        (state.len(), state.position[3], state.value[3]),
        (63, last.0, last.1)
    );
    let particle = Particle {
        position: [3.5],
        weight: 1.0,
        value: [1.0, 0.0],
    };
    line.insert(particle).unwrap();
    line.advance_to(2.0).unwrap();
    assert!(
        line.state()
            .value
            .as_flattened()
            .iter()
            .all(|u| u.abs() < 2.0)
    );
    for _ in 64..N {
        line.insert(particle).unwrap();
    }
    assert!(matches!(line.insert(particle), Err(Error::Capacity { .. })));

    let mut wall = Stepper::new(wall(), METHOD, HalfLoop, wall_memory()).unwrap();
    wall.advance_to(1.0).unwrap();
    wall.swap_remove(63);
    wall.advance_to(2.0).unwrap();
    assert_eq!(wall.state().len(), 63);
}

#[test]
fn a_run_without_an_end_goes_on_and_one_with_an_end_stops_there_to_the_bit() {
    let mut line = Stepper::new(line(), RK4, HalfLoop, line_memory()).unwrap();
    for _ in 0..100 {
        assert!(line.step().unwrap().is_some());
    }
    let mut line = line.until(200.1);
    line.advance_to(1e9).unwrap();
    assert_eq!((line.clock().time, line.step()), (200.1, Ok(None)));
}
