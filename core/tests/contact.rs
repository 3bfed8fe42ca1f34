//! Two fluids at rest beside each other stay at rest at the default courant number, however unlike their
//! densities and stiffnesses: the stable step knows the partner.

use motes_core::cutoff::CubicSpline;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{GasDynamics, Particle, Plain, PlainStorage, Weights, Width};
use motes_core::equation::{Dynamics, Storage};
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::material::{EquationOfState, IdealGas, Named, StiffenedGas};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;

const N: usize = 64;
const CELLS: usize = cell_bound(N as u32) as usize + 1;
const GAMMA: f64 = 1.4;
const OF_LIQUID: f64 = 4.4;

type Gas<'a> = GasDynamics<'a, f64, CubicSpline, Pairwise<f64>, Named<f64>, Plain<f64, 1>, 1>;
type Memory = PlainStorage<f64, 1, N, CELLS>;

/// The largest speed within so many steps over the sound speed of the light fluid; infinite after an
/// error. The light fluid has density 1 and pressure 1 and is jittered so that the stiffer of the two
/// answers with as much energy as the light one alone would to a thousandth of a spacing.
fn fastest(density: f64, stiffness: f64, alpha: f64) -> f64 {
    // ρ c² = γ (p + p∞).
    let hidden = (GAMMA * stiffness / OF_LIQUID - 1.0).max(0.0);
    let (heavy, energy) = match hidden > 0.0 {
        true => {
            let energy = (1.0 + OF_LIQUID * hidden) / ((OF_LIQUID - 1.0) * density);
            (
                Named::StiffenedGas(StiffenedGas::new(OF_LIQUID, hidden)),
                energy,
            )
        }
        false => {
            let energy = 1.0 / ((GAMMA - 1.0) * density);
            (Named::IdealGas(IdealGas::new(GAMMA)), energy)
        }
    };
    let jitter = 1e-3 / stiffness.sqrt();
    let materials = [Named::IdealGas(IdealGas::new(GAMMA)), heavy];
    let dynamics = GasDynamics {
        domain: Domain {
            axes: [Axis::walls(0.0, N as f64)],
        },
        cut_off: CubicSpline,
        width: Width::Adaptive { eta: 1.2 },
        viscosity: Pairwise(Coefficients {
            alpha,
            beta: 2.0 * alpha,
        }),
        materials: &materials,
        physics: Plain {
            weights: Weights::Number,
            ..Plain::DEFAULT
        },
        courant: 0.3,
        smallest_omega: 1.0 / 32.0,
    };
    let mut memory = Memory::new();
    for k in 0..N {
        let is_heavy = k < N / 2;
        let noise = (k as f64 * 0.618_033_988_749_895).fract() - 0.5;
        let particle = Particle {
            position: [k as f64 + 0.5 + if is_heavy { 0.0 } else { jitter * noise }],
            velocity: [0.0],
            mass: if is_heavy { density } else { 1.0 },
            energy: if is_heavy {
                energy
            } else {
                1.0 / (GAMMA - 1.0)
            },
            epsilon: 1.2,
            material: u8::from(is_heavy),
        };
        memory.push(particle).unwrap();
    }
    // The sum of a lattice is not quite 1: the energies that make the pressure 1 all the same.
    let mut parts = Storage::<f64, Gas<'_>, 1>::parts(&mut memory);
    Dynamics::prepare(&dynamics, &mut HalfLoop, &mut parts).unwrap();
    let gas = &mut parts.state;
    for k in 0..N {
        let material = &materials[usize::from(gas.material[k])];
        let pressure = |energy: f64| material.pressure(gas.density[k], energy);
        let e = gas.energy[k];
        let slope = pressure(e + 1.0) - pressure(e);
        gas.energy[k] += (1.0 - pressure(e)) / slope;
    }
    let mut run = Stepper::new(dynamics, LeapFrog, HalfLoop, memory).unwrap();
    let mut fastest = 0.0f64;
    for _ in 0..10_000 {
        if run.step().is_err() {
            return f64::INFINITY;
        }
        let speeds = run
            .state()
            .velocity
            .iter()
            .map(|u| u[0].abs())
            .fold(0.0, f64::max);
        fastest = fastest.max(speeds);
    }
    fastest / GAMMA.sqrt()
}

#[test]
fn two_fluids_at_rest_stay_at_rest() {
    for density in [1.0, 1e3, 1e6] {
        for stiffness in [1.0, 1e3, 1e6] {
            for alpha in [0.0, 1.0] {
                let fastest = fastest(density, stiffness, alpha);
                assert!(
                    fastest < 0.01,
                    "density {density:e}, stiffness {stiffness:e}, α {alpha}: {fastest:e}"
                );
            }
        }
    }
}
