//! A gas without dissipation: at rest it stays at rest, sound in it keeps its energy and leads back the
//! way it came, up to the step that the fastest vibration of the particles allows.
//!
//! The pressure is a function of the positions, so the leap-frog is symplectic: its energy oscillates,
//! does not drift, and steps are stable for `ω dt < 2` (Hairer, Lubich & Wanner, Geometric Numerical
//! Integration, 2006, I.5).

use std::f64::consts::PI;

use motes_core::cutoff::{CubicSpline, WendlandC2};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{
    EnergyForm, Gas, GasDynamics, Options, OptionsStorage, Particle, Width,
};
use motes_core::equation::{Dynamics, Step, Storage};
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::material::{EquationOfState, IdealGas, Named, StiffenedGas};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;

const MOST: usize = 64;
const CELLS: usize = cell_bound(MOST as u32) as usize + 1;
const FORMS: [EnergyForm; 3] = [EnergyForm::LeapFrog, EnergyForm::Exact, EnergyForm::Total];

type Memory = OptionsStorage<f64, 1, MOST, CELLS>;
type Line<'a> = GasDynamics<'a, f64, CubicSpline, Pairwise<f64>, Named<f64>, Options<f64, 1>, 1>;

fn materials() -> [Named<f64>; 3] {
    [
        Named::IdealGas(IdealGas::new(1.4)),
        Named::IdealGas(IdealGas::new(5.0 / 3.0)),
        Named::StiffenedGas(StiffenedGas::new(4.4, 6.0)),
    ]
}

/// `n` spacings, periodic, of density 1 and pressure 1, without viscosity.
fn line(n: usize, material: &[Named<f64>; 1], energy: EnergyForm) -> Line<'_> {
    GasDynamics {
        domain: Domain {
            axes: [Axis::periodic(0.0, n as f64)],
        },
        cut_off: CubicSpline,
        width: Width::adaptive(1.2),
        viscosity: Pairwise(Coefficients {
            alpha: 0.0,
            beta: 0.0,
        }),
        materials: material,
        physics: Options {
            energy,
            ..Options::OFF
        },
        courant: 0.3,
        smallest_omega: 1.0 / 32.0,
    }
}

/// The energy that gives pressure 1 at density 1: pressures are linear in it.
fn energy_at_rest(material: &Named<f64>) -> f64 {
    let [low, high] = [1.0, 2.0].map(|e| material.pressure(1.0, e));
    1.0 + (1.0 - low) / (high - low)
}

/// Particle `k` is off its place by `off(k)` spacings, and moves by `velocity(k)`.
fn memory(
    n: usize,
    material: &Named<f64>,
    off: impl Fn(usize) -> f64,
    velocity: impl Fn(usize) -> f64,
) -> Memory {
    let mut memory = Memory::new();
    for k in 0..n {
        let particle = Particle {
            position: [k as f64 + 0.5 + off(k)],
            velocity: [velocity(k)],
            mass: 1.0,
            energy: energy_at_rest(material),
            epsilon: 1.2,
            material: 0,
        };
        memory.push(particle).unwrap();
    }
    memory
}

/// A sequence without pattern in [-1/2, 1/2].
fn noise(k: usize) -> f64 {
    (k as f64 * 0.618_033_988_749_895).fract() - 0.5
}

fn kinetic<const D: usize>(gas: &Gas<'_, f64, D>) -> f64 {
    let of = |(m, u): (&f64, &[f64; D])| 0.5 * m * u.iter().map(|u| u * u).sum::<f64>();
    gas.mass.iter().zip(gas.velocity.iter()).map(of).sum()
}

fn total<const D: usize>(gas: &Gas<'_, f64, D>) -> f64 {
    let internal = gas.mass.iter().zip(gas.energy.iter()).map(|(m, e)| m * e);
    kinetic(gas) + internal.sum::<f64>()
}

#[test]
fn a_gas_at_rest_stays_at_rest_for_100_000_steps() {
    let n = 32;
    for energy in FORMS {
        for material in materials().into_iter().take(match energy {
            EnergyForm::LeapFrog => 3,
            EnergyForm::Exact | EnergyForm::Total => 1,
        }) {
            let of = [material];
            let displaced = memory(n, &material, |k| 0.01 * noise(k), |_| 0.0);
            let dynamics = line(n, &of, energy);
            let mut run = Stepper::new(dynamics, LeapFrog, HalfLoop, displaced).unwrap();
            let start = total(&run.state());
            // Means over a tenth of the run each: what oscillates has no part in them.
            let mut means = [0.0; 10];
            let (mut worst, mut fastest) = (0.0f64, 0.0f64);
            for mean in &mut means {
                for _ in 0..10_000 {
                    run.step().unwrap_or_else(|error| {
                        panic!("{error:?}: {energy:?}, {material:?}");
                    });
                    let change = total(&run.state()) / start - 1.0;
                    worst = worst.max(change.abs());
                    *mean += change / 10_000.0;
                    fastest = fastest.max(kinetic(&run.state()));
                }
            }
            let what = format!("{energy:?}, {material:?}: {worst:e}, {means:?}");
            assert!(worst < 1e-5, "{what}");
            assert!((means[9] - means[1]).abs() < 1e-6, "{what}");
            // As much as the displacements hold, and never more.
            assert!(fastest < 0.01, "{what}: {fastest:e}");
        }
    }
}

#[test]
fn sound_keeps_its_energy_for_10_000_periods() {
    let n = 16;
    let material = [Named::IdealGas(IdealGas::new(1.4))];
    let speed = material[0].sound_speed(1.0, energy_at_rest(&material[0]));
    let wave = |k: usize| 0.01 * (2.0 * PI * (k as f64 + 0.5) / n as f64).sin();
    let dynamics = line(n, &material, EnergyForm::LeapFrog);
    let moving = memory(n, &material[0], |_| 0.0, wave);
    let mut run = Stepper::new(dynamics, LeapFrog, HalfLoop, moving).unwrap();
    let start = total(&run.state());
    let of_wave = kinetic(&run.state());
    let periods = 1e4 * n as f64 / speed;
    let (mut worst, mut last) = (0.0f64, 0.0f64);
    while run.clock().time < periods {
        run.step().unwrap();
        let is_late = run.clock().time > 0.99 * periods;
        let state = run.state();
        worst = worst.max((total(&state) - start).abs() / of_wave);
        if is_late {
            last = last.max(kinetic(&state) / of_wave);
        }
    }
    assert!(worst < 0.02, "{worst:e} of the wave's energy");
    // The wave is still there.
    assert!((0.9..1.05).contains(&last), "{last}");
}

#[test]
fn sound_leads_back_the_way_it_came() {
    let n = 32;
    let steps = 1000;
    let step = Step { time: 0.0, dt: 0.3 };
    for material in materials().map(|material| [material]) {
        let dynamics = line(n, &material, EnergyForm::LeapFrog);
        let mut memory = memory(n, &material[0], |k| 0.05 * noise(k), |k| 0.1 * noise(k + 7));
        let mut engine = HalfLoop;
        let mut parts = Storage::<f64, Line<'_>, 1>::parts(&mut memory);
        Dynamics::prepare(&dynamics, &mut engine, &mut parts).unwrap();
        let state = |gas: &Gas<'_, f64, 1>| -> Vec<f64> {
            let positions = gas.position.iter().map(|x| x[0]);
            positions.chain(gas.energy.iter().copied()).collect()
        };
        let start = state(&parts.state);
        let mut apart = 0.0f64;
        for way in 0..2 {
            for _ in 0..steps {
                Dynamics::advance(&dynamics, &LeapFrog, &mut engine, &mut parts, step).unwrap();
            }
            let now = state(&parts.state);
            let differences = start.iter().zip(&now).map(|(a, b)| (a - b).abs());
            let most = differences.fold(0.0, f64::max);
            match way {
                0 => apart = most,
                _ => assert!(most < 1e-7 * apart, "{most:e} of {apart:e}: {material:?}"),
            }
            for velocity in parts.state.velocity.iter_mut() {
                velocity[0] = -velocity[0];
            }
        }
    }
}

/// The largest `ω²` of the waves that fit, from the forces of displaced particles whose entropy is that
/// of the lattice.
fn largest_frequency_squared(n: usize, material: &[Named<f64>; 1]) -> f64 {
    let size = 1e-5;
    let dynamics = line(n, material, EnergyForm::LeapFrog);
    let mut engine = HalfLoop;
    let mut largest = 0.0f64;
    for number in 1..=n / 2 {
        let shape = |k: usize| (2.0 * PI * (number * k) as f64 / n as f64 + 0.3).cos();
        let mut memory = memory(n, &material[0], |k| size * shape(k), |_| 0.0);
        let mut parts = Storage::<f64, Line<'_>, 1>::parts(&mut memory);
        Dynamics::prepare(&dynamics, &mut engine, &mut parts).unwrap();
        let of_lattice = parts.state.density.iter().sum::<f64>() / n as f64;
        let state = &mut parts.state;
        for (energy, density) in state.energy.iter_mut().zip(state.density.iter()) {
            *energy = material[0].compressed([of_lattice, *density], *energy);
        }
        Dynamics::prepare(&dynamics, &mut engine, &mut parts).unwrap();
        let (mut back, mut norm) = (0.0, 0.0);
        for (k, force) in parts.state.force.iter().enumerate() {
            back -= force[0] * shape(k);
            norm += size * shape(k) * shape(k);
        }
        largest = largest.max(back / norm);
    }
    largest
}

#[test]
fn steps_are_stable_up_to_two_over_the_largest_frequency() {
    let n = 32;
    for material in materials().map(|material| [material]) {
        let limit = 2.0 / largest_frequency_squared(n, &material).sqrt();
        for energy in FORMS {
            // The largest kinetic energy after so many steps of that share of the limit; infinite
            // after an error.
            let after = |share: f64| {
                let dynamics = line(n, &material, energy);
                let mut memory = memory(n, &material[0], |k| 1e-4 * noise(k), |_| 0.0);
                let mut engine = HalfLoop;
                let mut parts = Storage::<f64, Line<'_>, 1>::parts(&mut memory);
                Dynamics::prepare(&dynamics, &mut engine, &mut parts).unwrap();
                let step = Step {
                    time: 0.0,
                    dt: share * limit,
                };
                let mut largest = 0.0f64;
                for _ in 0..10_000 {
                    let advanced =
                        Dynamics::advance(&dynamics, &LeapFrog, &mut engine, &mut parts, step);
                    if advanced.is_err() {
                        return f64::INFINITY;
                    }
                    largest = largest.max(kinetic(&parts.state));
                }
                largest
            };
            let [stable, unstable] = [0.9, 1.1].map(after);
            let what = format!("{energy:?}, {material:?}, limit {limit}");
            assert!(stable < 1e-5, "{what}: {stable:e}");
            assert!(unstable > 1e-2, "{what}: {unstable:e}");
        }
    }
}

/// A hexagonal lattice in a periodic box, jittered as the box at rest of other codes is.
#[test]
fn a_plane_at_rest_stays_at_rest_for_100_000_steps() {
    const ROWS: usize = 12;
    const N: usize = ROWS * ROWS;
    const CELLS: usize = cell_bound(N as u32) as usize + 1;
    let spacing = (2.0 / 3.0f64.sqrt()).sqrt();
    let height = 1.0 / spacing;
    let material = Named::IdealGas(IdealGas::new(1.4));
    for (energy, steps) in FORMS.into_iter().zip([100_000, 10_000, 10_000]) {
        let dynamics = GasDynamics {
            domain: Domain {
                axes: [spacing, height].map(|side| Axis::periodic(0.0, ROWS as f64 * side)),
            },
            cut_off: WendlandC2,
            width: Width::adaptive(1.3),
            viscosity: Pairwise(Coefficients {
                alpha: 0.0,
                beta: 0.0,
            }),
            materials: &[material],
            physics: Options {
                energy,
                ..Options::OFF
            },
            courant: 0.3,
            smallest_omega: 1.0 / 32.0,
        };
        let mut memory = OptionsStorage::<f64, 2, N, CELLS>::new();
        for k in 0..N {
            let (row, place) = (k / ROWS, k % ROWS);
            let shift = 0.25 + 0.5 * (row % 2) as f64 + 0.01 * noise(2 * k);
            let particle = Particle {
                position: [
                    (place as f64 + shift) * spacing,
                    (row as f64 + 0.5 + 0.01 * noise(2 * k + 1)) * height,
                ],
                velocity: [0.0; 2],
                mass: 1.0,
                energy: energy_at_rest(&material),
                epsilon: 1.3,
                material: 0,
            };
            memory.push(particle).unwrap();
        }
        let mut run = Stepper::new(dynamics, LeapFrog, HalfLoop, memory).unwrap();
        let start = total(&run.state());
        let (mut worst, mut last) = (0.0f64, 0.0);
        for _ in 0..steps {
            run.step()
                .unwrap_or_else(|error| panic!("{error:?}: {energy:?}"));
            last = total(&run.state()) / start - 1.0;
            worst = worst.max(last.abs());
        }
        // What the jitter has put in is 1e-4 of the energy of a gas.
        let moving = kinetic(&run.state()) / start;
        assert!(
            worst < 1e-5 && moving < 1e-4,
            "{energy:?}: {worst:e}, {last:e}, {moving:e}"
        );
    }
}
