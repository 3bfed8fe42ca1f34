//! Two fluids at rest beside each other stay at rest at the default courant number, however unlike their
//! densities and stiffnesses: the stable step knows the partner.

use motes_core::cutoff::{CubicSpline, CutOff, WendlandC2};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{GasDynamics, Particle, Plain, PlainStorage, Weights, Width};
use motes_core::equation::{Dynamics, Storage};
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::material::{EquationOfState, IdealGas, Named, StiffenedGas};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;

const GAMMA: f64 = 1.4;
const OF_LIQUID: f64 = 4.4;
const STEPS: u32 = 10_000;

type Gas<'a, C, const D: usize> =
    GasDynamics<'a, f64, C, Pairwise<f64>, Named<f64>, Plain<f64, D>, D>;

/// Two fluids at pressure 1: the light one has density 1, the other these multiples of its density and of
/// its `ρ c²`.
#[derive(Clone, Copy, Debug)]
struct Contact {
    density: f64,
    stiffness: f64,
    /// Of the pseudo-viscosity.
    alpha: f64,
}

impl Contact {
    /// The law and the internal energy of the heavy fluid.
    fn heavy(&self) -> (Named<f64>, f64) {
        // ρ c² = γ (p + p∞).
        let hidden = (GAMMA * self.stiffness / OF_LIQUID - 1.0).max(0.0);
        if hidden > 0.0 {
            let energy = (1.0 + OF_LIQUID * hidden) / ((OF_LIQUID - 1.0) * self.density);
            let law = StiffenedGas::new(OF_LIQUID, hidden);
            return (Named::StiffenedGas(law), energy);
        }
        let energy = 1.0 / ((GAMMA - 1.0) * self.density);
        (Named::IdealGas(IdealGas::new(GAMMA)), energy)
    }

    /// The largest speed within [`STEPS`] over the sound speed of the light fluid; infinite after an
    /// error. The light fluid is jittered so that the stiffer of the two answers with as much energy as
    /// the light one alone would to a thousandth of a spacing.
    fn fastest<C: CutOff, const D: usize, const N: usize, const CELLS: usize>(
        &self,
        (cut_off, eta): (C, f64),
        (axes, lattice): ([Axis<f64>; D], impl Fn(usize) -> [f64; D]),
    ) -> f64 {
        let (law, energy) = self.heavy();
        let jitter = 1e-3 / self.stiffness.sqrt();
        let materials = [Named::IdealGas(IdealGas::new(GAMMA)), law];
        let middle = 0.5 * (axes[0].lower + axes[0].upper);
        let dynamics = GasDynamics {
            domain: Domain { axes },
            cut_off,
            width: Width::adaptive(eta),
            viscosity: Pairwise(Coefficients {
                alpha: self.alpha,
                beta: 2.0 * self.alpha,
            }),
            materials: &materials,
            physics: Plain {
                weights: Weights::Number,
                ..Plain::DEFAULT
            },
            courant: 0.3,
            smallest_omega: 1.0 / 32.0,
        };
        let mut memory = PlainStorage::<f64, D, N, CELLS>::new();
        for k in 0..N {
            let mut position = lattice(k);
            let is_heavy = position[0] < middle;
            for (i, x) in position.iter_mut().enumerate() {
                let noise = ((D * k + i) as f64 * 0.618_033_988_749_895).fract() - 0.5;
                *x += if is_heavy { 0.0 } else { jitter * noise };
            }
            let particle = Particle {
                position,
                velocity: [0.0; D],
                mass: if is_heavy { self.density } else { 1.0 },
                energy: if is_heavy {
                    energy
                } else {
                    1.0 / (GAMMA - 1.0)
                },
                epsilon: eta,
                material: u8::from(is_heavy),
            };
            memory.push(particle).unwrap();
        }
        // The sum of a lattice is not quite 1: the energies that make the pressure 1 all the same.
        let mut parts = Storage::<f64, Gas<'_, C, D>, D>::parts(&mut memory);
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
        for _ in 0..STEPS {
            if run.step().is_err() {
                return f64::INFINITY;
            }
            let components = run.state().velocity.iter().flatten();
            fastest = components.fold(fastest, |most, u| most.max(u.abs()));
        }
        fastest / GAMMA.sqrt()
    }

    fn check(&self, fastest: f64) {
        assert!(fastest < 0.01, "{self:?}: {fastest:e}");
    }
}

#[test]
fn two_fluids_at_rest_stay_at_rest() {
    const N: usize = 64;
    const CELLS: usize = cell_bound(N as u32) as usize + 1;
    for density in [1.0, 1e3, 1e6] {
        for stiffness in [1.0, 1e3, 1e6] {
            for alpha in [0.0, 1.0] {
                let contact = Contact {
                    density,
                    stiffness,
                    alpha,
                };
                let lattice = |k: usize| [k as f64 + 0.5];
                let tube = ([Axis::walls(0.0, N as f64)], lattice);
                contact.check(contact.fastest::<_, 1, N, CELLS>((CubicSpline, 1.2), tube));
            }
        }
    }
}

/// A hexagonal lattice in a periodic box: a slab of each fluid.
#[test]
fn they_do_in_two_dimensions() {
    const ROWS: usize = 12;
    const ROW: usize = 12;
    const N: usize = ROWS * ROW;
    const CELLS: usize = cell_bound(N as u32) as usize + 1;
    let spacing = (2.0 / 3.0f64.sqrt()).sqrt();
    let height = 1.0 / spacing;
    for (density, stiffness) in [(1e3, 1.0), (1e3, 1.5e4), (1e6, 1.0), (1.0, 1e6)] {
        let contact = Contact {
            density,
            stiffness,
            alpha: 0.0,
        };
        let lattice = |k: usize| {
            let (row, place) = (k / ROW, k % ROW);
            let shift = 0.25 + 0.5 * (row % 2) as f64;
            [
                (place as f64 + shift) * spacing,
                (row as f64 + 0.5) * height,
            ]
        };
        let axes = [
            Axis::periodic(0.0, ROW as f64 * spacing),
            Axis::periodic(0.0, ROWS as f64 * height),
        ];
        let fastest = contact.fastest::<_, 2, N, CELLS>((WendlandC2, 1.3), (axes, lattice));
        contact.check(fastest);
    }
}

/// A face-centred lattice in a periodic box; densities and stiffnesses of water and air.
fn in_three_dimensions() {
    const SIDE: usize = 6;
    const N: usize = 4 * SIDE * SIDE * SIDE;
    const CELLS: usize = cell_bound(N as u32) as usize + 1;
    let cell = 4.0f64.cbrt();
    let contact = Contact {
        density: 1e3,
        stiffness: 1.5e4,
        alpha: 0.0,
    };
    let lattice = |k: usize| {
        let corner = [[0.0; 3], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]][k % 4];
        let place = k / 4;
        let places = [place % SIDE, place / SIDE % SIDE, place / SIDE / SIDE];
        std::array::from_fn(|i| (places[i] as f64 + corner[i] + 0.25) * cell)
    };
    let axes = [Axis::periodic(0.0, SIDE as f64 * cell); 3];
    let fastest = contact.fastest::<_, 3, N, CELLS>((WendlandC2, 1.3), (axes, lattice));
    contact.check(fastest);
}

#[test]
fn they_do_in_three_dimensions() {
    // The arrays are moved by value more than once.
    let thread = std::thread::Builder::new().stack_size(1 << 26);
    thread.spawn(in_three_dimensions).unwrap().join().unwrap();
}
