//! The fixed-capacity storage of a device: what does not fit is an error value, and what fits
//! has the bits of the host.

mod clouds;

use clouds::Cloud;
use motes_core::cutoff::CubicSpline;
use motes_core::domain::Side;
use motes_core::equation::gas::exchange::Extras;
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{
    Diffusion, EnergyForm, GasStorage, Options, OptionsStorage, PlainStorage, Switch, Width,
};
use motes_core::equation::linear::Nothing;
use motes_core::error::{Container, Error};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::{Engine, HalfLoop};
use motes_core::scalar::Scalar;
use motes_solver::engine::Threads;
use motes_solver::families::gas::GasArrays;

const N: usize = 64;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

type Solver<S> = clouds::Solver<S, CubicSpline, Pairwise<S>, 1>;

fn cloud() -> Cloud {
    Cloud {
        per_side: N,
        seed: 3,
        disorder: 0.2,
        speed: 0.3,
        masses: 0.2,
        eta: 1.2,
    }
}

fn solver<S: Scalar>(sides: [Side; 2]) -> Solver<S> {
    let viscosity = Pairwise(Coefficients {
        alpha: S::ONE,
        beta: S::from_f64(2.0),
    });
    let width = Width::adaptive(S::from_f64(1.2));
    cloud().solver([sides], CubicSpline, width, viscosity)
}

fn filled<const C: usize>() -> PlainStorage<f32, 1, N, C> {
    let mut storage = PlainStorage::new();
    for particle in cloud().particles::<f32, 1>() {
        storage.push(particle).unwrap();
    }
    storage
}

#[test]
fn one_particle_too_many_is_an_error_that_says_how_many_fit() {
    let mut storage = filled::<CELLS>();
    let particle = cloud().particles::<f32, 1>()[0];
    let full = Error::Capacity {
        container: Container::Particles,
        needed: 65,
        capacity: 64,
    };
    assert_eq!(storage.push(particle), Err(full));
    assert!(
        full.to_string()
            .contains("65 particles do not fit: there is room for 64")
    );
    // What was there is still whole.
    let (mut gas, mut work) = storage.parts();
    assert_eq!(gas.len(), N);
    solver([Side::Mirror; 2])
        .prepare(&mut HalfLoop, &mut gas, &mut work)
        .unwrap();
}

#[test]
fn too_few_cells_are_an_error_that_says_how_many_are_needed() {
    let mut storage = filled::<20>();
    let (mut gas, mut work) = storage.parts();
    let error = solver([Side::Mirror; 2]).prepare(&mut HalfLoop, &mut gas, &mut work);
    let Err(Error::Capacity {
        container: Container::Cells,
        needed,
        capacity: 20,
    }) = error
    else {
        panic!("{error:?}");
    };
    // The number it asks for is enough.
    assert!(needed > 20 && needed as usize <= CELLS, "{needed}");
}

/// A gas that leaves into the open for as long as it likes: cells grow with it, their number
/// does not, and it has the bits of the host all the way.
#[test]
fn a_gas_that_spreads_never_outgrows_its_cells() {
    let solver = solver::<f32>([Side::Free; 2]);
    let mut storage = filled::<CELLS>();
    let (mut gas, mut work) = storage.parts();
    let mut arrays = cloud().arrays::<f32, 1>();
    let (mut on_host, mut host_work) = arrays.parts();
    let mut threads = Threads::new(1).unwrap();
    solver.prepare(&mut HalfLoop, &mut gas, &mut work).unwrap();
    solver
        .prepare(&mut threads, &mut on_host, &mut host_work)
        .unwrap();
    for _ in 0..2000 {
        let dt = solver.time_step(&gas, 1e3).unwrap();
        solver
            .advance(&mut HalfLoop, &mut gas, &mut work, dt)
            .unwrap();
        solver
            .advance(&mut threads, &mut on_host, &mut host_work, dt)
            .unwrap();
    }
    assert_eq!(gas.digest(), on_host.digest());
    let extent = |positions: &[[f32; 1]]| {
        let x = positions.iter().map(|x| x[0]);
        x.clone().fold(f32::MIN, f32::max) - x.fold(f32::MAX, f32::min)
    };
    assert!(
        extent(gas.position) > 5.0 * N as f32,
        "{}",
        extent(gas.position)
    );
}

#[test]
fn an_empty_storage_is_an_error_and_no_panic() {
    let mut storage = PlainStorage::<f64, 1, N, CELLS>::new();
    let (mut gas, mut work) = storage.parts();
    let error = solver([Side::Free; 2]).prepare(&mut HalfLoop, &mut gas, &mut work);
    assert_eq!(error, Err(Error::EmptyDomain { axis: 0 }));
}

/// What goes beyond the paper's equations works in memory of its own: without it an error, with
/// it the bits of the host.
#[test]
fn options_need_their_storage_and_have_the_bits_of_the_host() {
    let options = Options {
        energy: EnergyForm::Exact,
        limited: true,
        switch: Some(Switch {
            minimum: 0.05f32,
            decay: 0.2,
        }),
        balsara: true,
        conduction: 0.75,
        diffusion: Diffusion {
            viscosity: 0.1,
            bulk_viscosity: 0.05,
            heat: 0.1,
        },
        ..Options::OFF
    };
    let Solver::<f32> {
        cut_off,
        width,
        viscosity,
        ..
    } = solver([Side::Mirror; 2]);
    let solver = cloud().following(options, [[Side::Mirror; 2]], cut_off, width, viscosity);
    let particles = cloud().particles::<f32, 1>();
    let mut without = GasStorage::<f32, Extras<f32, 1>, 1, N, 0, CELLS>::new();
    for particle in &particles {
        without.push(*particle).unwrap();
    }
    let (mut gas, mut work) = without.parts();
    let without = solver.prepare(&mut HalfLoop, &mut gas, &mut work);
    assert_eq!(without, Err(Error::Lengths));

    let mut storage = OptionsStorage::<f32, 1, N, CELLS>::new();
    for particle in &particles {
        storage.push(*particle).unwrap();
    }
    let (mut gas, mut work) = storage.parts();
    let mut arrays = GasArrays::new(particles, &options);
    let (mut on_host, mut host_work) = arrays.parts();
    let mut threads = Threads::new(1).unwrap();
    solver.prepare(&mut HalfLoop, &mut gas, &mut work).unwrap();
    solver
        .prepare(&mut threads, &mut on_host, &mut host_work)
        .unwrap();
    for _ in 0..200 {
        let dt = solver.time_step(&gas, 1e3).unwrap();
        solver
            .advance(&mut HalfLoop, &mut gas, &mut work, dt)
            .unwrap();
        solver
            .advance(&mut threads, &mut on_host, &mut host_work, dt)
            .unwrap();
    }
    assert_eq!(gas.digest(), on_host.digest());
}

#[test]
fn a_material_that_is_not_there_is_an_error() {
    let mut particles = cloud().particles::<f32, 1>();
    let solver = solver([Side::Mirror; 2]);
    // The last one that there is.
    particles[7].material = solver.materials.len() as u8 - 1;
    for (more, expected) in [(0, Ok(())), (1, Err(Error::Material { particle: 7 }))] {
        particles[7].material += more;
        let mut arrays = GasArrays::new(particles.iter().copied(), &Options::OFF);
        let (mut gas, mut work) = arrays.parts();
        assert_eq!(solver.prepare(&mut HalfLoop, &mut gas, &mut work), expected);
    }
}

/// Nonsense in, errors out: whatever the state holds, nothing panics.
#[test]
fn broken_states_are_errors() {
    let solver = solver::<f32>([Side::Mirror; 2]);
    type Break = fn(&mut motes_core::equation::gas::Gas<'_, f32, 1>);
    let breaks: [(&str, Break); 5] = [
        ("a position that is no number", |gas| {
            gas.position[7][0] = f32::NAN
        }),
        ("an infinite velocity", |gas| {
            gas.velocity[7][0] = f32::INFINITY
        }),
        ("an energy that is no number", |gas| {
            gas.energy[7] = f32::NAN
        }),
        ("no width", |gas| gas.epsilon.fill(0.0)),
        ("an energy below zero", |gas| gas.energy[7] = -1.0),
    ];
    for (what, break_it) in breaks {
        for engine in [true, false] {
            let mut storage = filled::<CELLS>();
            let (mut gas, mut work) = storage.parts();
            break_it(&mut gas);
            let result = if engine {
                steps(&solver, &mut HalfLoop, &mut gas, &mut work)
            } else {
                steps(&solver, &mut Threads::new(1).unwrap(), &mut gas, &mut work)
            };
            assert!(result.is_err(), "{what}");
        }
    }
}

fn steps(
    solver: &Solver<f32>,
    engine: &mut impl Engine<f32, 1>,
    gas: &mut motes_core::equation::gas::Gas<'_, f32, 1>,
    work: &mut motes_core::equation::gas::Workspace<'_, f32, Nothing, 1>,
) -> Result<(), Error> {
    solver.prepare(engine, gas, work)?;
    let dt = solver.time_step(gas, 1.0)?;
    solver.advance(engine, gas, work, dt)
}
