//! The forms of the energy: two that conserve the total to round-off for any step, and the
//! leap-frog's, which drifts by the square of the step.

mod clouds;

use clouds::{Cloud, Following, sides};
use motes_core::cutoff::CubicSpline;
use motes_core::domain::Side;
use motes_core::equation::gas::viscosity::{
    Coefficients, GingoldMonaghan, Named, Pairwise, VonNeumann,
};
use motes_core::equation::gas::{Diffusion, EnergyForm, Gas, Options, Plain, Switch, Width};
use motes_solver::engine::Threads;
use motes_solver::families::gas::OptionsArrays;

const ADAPTIVE: Width<f64> = Width::adaptive(1.2);

/// Supersonic at random: particles run into each other and into the walls.
fn violent(per_side: usize) -> Cloud {
    Cloud {
        per_side,
        seed: 9,
        disorder: 0.35,
        speed: 2.0,
        masses: 0.4,
        eta: 1.2,
    }
}

fn coefficients() -> Coefficients<f64> {
    Coefficients {
        alpha: 1.0,
        beta: 2.0,
    }
}

fn von_neumann() -> Named<f64> {
    Named::VonNeumann(VonNeumann(coefficients()))
}

/// All options, but for external forces, which do work.
fn everything<const D: usize>(energy: EnergyForm) -> Options<f64, D> {
    Options {
        energy,
        limited: true,
        switch: Some(Switch {
            minimum: 0.1,
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
    }
}

fn only<const D: usize>(energy: EnergyForm) -> Options<f64, D> {
    Options {
        energy,
        ..Options::OFF
    }
}

/// A solver of the cloud's gas.
type Solver<const D: usize> = Following<f64, CubicSpline, Named<f64>, Options<f64, D>, D>;

fn total_energy<const D: usize>(gas: &Gas<'_, f64, D>) -> f64 {
    let velocities = gas.velocity.iter().map(|u| u.iter().map(|u| u * u).sum());
    let energies = gas.energy.iter().zip(velocities);
    let terms = energies.map(|(e, squared): (&f64, f64)| e + 0.5 * squared);
    gas.mass.iter().zip(terms).map(|(m, term)| m * term).sum()
}

/// The largest `|dE/E|` seen over 200 steps.
fn worst<const D: usize>(cloud: &Cloud, solver: &Solver<D>) -> f64 {
    let mut arrays = cloud.arrays_of_two(&solver.physics);
    let (mut gas, mut work) = arrays.parts();
    let mut engine = Threads::new(1).unwrap();
    let before = total_energy(&gas);
    solver.prepare(&mut engine, &mut gas, &mut work).unwrap();
    let mut worst = 0.0f64;
    for step in 0..200 {
        let dt = solver.time_step(&gas, 1.0).unwrap();
        if let Err(error) = solver.advance(&mut engine, &mut gas, &mut work, dt) {
            panic!(
                "{error} in step {step} of {}, {:?}",
                solver.courant, solver.physics
            );
        }
        worst = worst.max((total_energy(&gas) / before - 1.0).abs());
    }
    worst
}

/// Every kind of side, both of the steps, two viscosities, with and without other options.
///
/// The sum over n particles of s steps that round each energy twice walks by
/// `u (2 s/n)^(1/2)`, below 1e-15, and its evaluation by `u n^(1/2)`: a few 1e-15.
fn is_conserved<const D: usize>(cloud: &Cloud, second: Named<f64>) {
    let bound = 1e-13;
    let mut worst_of_all = 0.0f64;
    for energy in [EnergyForm::Exact, EnergyForm::Total] {
        for (kind, courant) in [0, 1, 2].into_iter().flat_map(|k| [(k, 0.05), (k, 0.3)]) {
            let sides: [[Side; 2]; D] = [sides::<1>(kind)[0]; D];
            for (options, viscosity) in [
                (
                    Options {
                        linear_exact: kind > 0,
                        ..everything(energy)
                    },
                    Named::Pairwise(Pairwise(coefficients())),
                ),
                (only(energy), second),
            ] {
                let width = Width::adaptive(cloud.eta);
                let mut solver = cloud.following(options, sides, CubicSpline, width, viscosity);
                solver.courant = courant;
                let drift = worst(cloud, &solver);
                assert!(
                    drift <= bound,
                    "energy drifts by {drift:e} > {bound:e} in {D}D, courant {courant}, \
                     {sides:?}, {options:?}"
                );
                worst_of_all = worst_of_all.max(drift);
            }
        }
    }
    println!("{D}D: energy drifts by {worst_of_all:.1e} at most");
}

#[test]
fn exact_and_total_energy_are_conserved_to_round_off_for_any_step_on_a_line() {
    is_conserved::<1>(&violent(60), von_neumann());
}

#[test]
fn exact_and_total_energy_are_conserved_to_round_off_for_any_step_in_a_plane() {
    is_conserved::<2>(&violent(14), von_neumann());
}

#[test]
fn exact_and_total_energy_are_conserved_to_round_off_for_any_step_in_space() {
    // Narrow, for three reaches in a period; few partners, so less violent. The pressure of
    // von Neumann would turn velocities round in one step of 0.3, and end below zero.
    let cloud = Cloud {
        eta: 0.8,
        speed: 1.0,
        ..violent(12)
    };
    let second = Named::GingoldMonaghan(GingoldMonaghan(coefficients()));
    is_conserved::<3>(&cloud, second);
}

/// Fluctuations so slow that pairs neither meet nor part within the run: the rates have no
/// kinks, and orders show.
fn smooth() -> Cloud {
    Cloud {
        disorder: 0.05,
        speed: 0.05,
        masses: 0.1,
        ..violent(12)
    }
}

/// The state at time 2 after steps of that length, and the drift of its energy.
fn after<const D: usize>(options: Options<f64, D>, dt: f64) -> (OptionsArrays<f64, D>, f64) {
    let cloud = smooth();
    let sides = [[Side::Periodic; 2]; D];
    let viscosity = Named::Inviscid;
    let solver: Solver<D> = cloud.following(options, sides, CubicSpline, ADAPTIVE, viscosity);
    let mut arrays = cloud.arrays_of_two(&Options {
        // Memory for any of the forms.
        energy: EnergyForm::Exact,
        ..options
    });
    let (mut gas, mut work) = arrays.parts();
    let mut engine = Threads::new(1).unwrap();
    let before = total_energy(&gas);
    solver.prepare(&mut engine, &mut gas, &mut work).unwrap();
    for _ in 0..(2.0 / dt) as u32 {
        solver
            .advance(&mut engine, &mut gas, &mut work, dt)
            .unwrap();
    }
    let drift = (total_energy(&gas) / before - 1.0).abs();
    (arrays, drift)
}

/// The largest difference of two states in velocity and internal energy.
fn difference<const D: usize>(a: &mut OptionsArrays<f64, D>, b: &mut OptionsArrays<f64, D>) -> f64 {
    let ((a, _), (b, _)) = (a.parts(), b.parts());
    let velocities = a
        .velocity
        .as_flattened()
        .iter()
        .zip(b.velocity.as_flattened());
    let pairs = velocities.chain(a.energy.iter().zip(b.energy.iter()));
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

const STEPS: [f64; 3] = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 256.0];

/// Each half of a step divides these by 4, within an eighth.
fn falls_by_four(what: &str, values: [f64; 3]) {
    println!("{what}: {values:?} at steps {STEPS:?}");
    for pair in values.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!(
            (3.5..4.5).contains(&ratio),
            "{what}: ratio {ratio}, expected 4, from {values:?}"
        );
    }
}

#[test]
fn the_leap_frog_drifts_by_the_square_of_the_step() {
    for linear_exact in [false, true] {
        let leap_frog = Options {
            linear_exact,
            ..only::<2>(EnergyForm::LeapFrog)
        };
        let drifts = STEPS.map(|dt| after(leap_frog, dt).1);
        falls_by_four(&format!("drift, linear-exact {linear_exact}"), drifts);
    }
}

#[test]
fn all_forms_agree_to_the_square_of_the_step() {
    for (diffusion, linear_exact) in [(0.0, false), (0.1, false), (0.0, true)] {
        let with = |energy| Options {
            diffusion: Diffusion {
                viscosity: diffusion,
                bulk_viscosity: diffusion,
                heat: diffusion,
            },
            plain: Plain {
                acceleration: [0.1, -0.2],
                ..Plain::DEFAULT
            },
            linear_exact,
            ..only::<2>(energy)
        };
        for form in [EnergyForm::Exact, EnergyForm::Total] {
            let differences = STEPS.map(|dt| {
                let (mut leap_frog, _) = after(with(EnergyForm::LeapFrog), dt);
                let (mut other, _) = after(with(form), dt);
                difference(&mut leap_frog, &mut other)
            });
            falls_by_four(&format!("{form:?}, diffusion {diffusion}"), differences);
        }
    }
}
