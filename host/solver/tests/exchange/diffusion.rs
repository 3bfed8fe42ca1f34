//! Physical viscosity and heat conduction against the decay of a wave.

use std::f64::consts::TAU;

use motes_core::cutoff::WendlandC4;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{Diffusion, EnergyForm, Gas, Options, Particle};
use motes_core::material::Isothermal;

use super::Setup;

const NU: f64 = 0.4;
const AMPLITUDE: f64 = 1e-3;
/// In spacings: a wide cut-off, whose sums over a lattice are nearly integrals.
const ETA: f64 = 2.0;

/// What is diffused: a component of velocity across the wave, or the internal energy.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Diffused {
    Shear,
    Heat,
}

/// Rows of the lattice, and the distance between them.
const ROWS: usize = 16;
const ROW: f64 = 0.866_025_403_784_438_6;

/// Particles of density 1 in a lattice of equal triangles: its sums over `r r r r`, which a
/// viscosity along lines of centres is made of, have no direction. (Those of a lattice of
/// squares have: shear along it decays by 6 % less at this width.)
fn hexagons(per_row: usize) -> Vec<Particle<f64, 2>> {
    let place = |i: usize| {
        let (row, x) = (i / per_row, i % per_row);
        let shift = if row % 2 == 0 { 0.25 } else { 0.75 };
        Particle {
            position: [x as f64 + shift, (row as f64 + 0.5) * ROW],
            velocity: [0.0; 2],
            mass: ROW,
            energy: 1.8,
            epsilon: ETA * ROW.sqrt(),
            material: 0,
        }
    };
    (0..ROWS * per_row).map(place).collect()
}

/// The amplitude of `sin(k x)` in a field of the gas.
fn amplitude(gas: &Gas<'_, f64, 2>, what: Diffused, k: f64) -> f64 {
    let values = (0..gas.len()).map(|id| match what {
        Diffused::Shear => gas.velocity[id][1],
        Diffused::Heat => gas.energy[id],
    });
    let waves = gas.position.iter().map(|x| (k * x[0]).sin());
    let sum: f64 = values.zip(waves).map(|(value, wave)| value * wave).sum();
    2.0 * sum / gas.len() as f64
}

/// The rate of decay of a wave of that many particles over `D k²`, which is 1, over half of a
/// decay time.
fn rate(what: Diffused, energy: EnergyForm, per_wave: usize) -> f64 {
    let k = TAU / per_wave as f64;
    let mut particles = hexagons(per_wave);
    for particle in &mut particles {
        let wave = AMPLITUDE * (k * particle.position[0]).sin();
        match what {
            Diffused::Shear => particle.velocity[1] = wave,
            Diffused::Heat => particle.energy += wave,
        }
    }
    let diffusion = match what {
        Diffused::Shear => Diffusion {
            viscosity: NU,
            ..Diffusion::OFF
        },
        Diffused::Heat => Diffusion {
            heat: NU,
            ..Diffusion::OFF
        },
    };
    let options = Options {
        energy,
        diffusion,
        ..Options::OFF
    };
    // Held at one temperature it does not move, but keeps account of its energy.
    // With little pressure: a lattice resists shear by some of it.
    let of = (Inviscid, &[Isothermal::new(0.005)][..]);
    let cut_off = (WendlandC4, ETA);
    let sides = [per_wave as f64, ROWS as f64 * ROW];
    let domain = Domain {
        axes: sides.map(|side| Axis::periodic(0.0, side)),
    };
    let mut setup = Setup::new(particles, domain, cut_off, of, options);
    let before = amplitude(&setup.gas(), what, k);
    let end = 0.5 / (NU * k * k);
    let longest = {
        let solver = setup.solver;
        solver.time_step(&setup.gas(), 1.0).unwrap()
    };
    let steps = (end / longest).ceil();
    setup.advance(steps as usize, end / steps);
    let after = amplitude(&setup.gas(), what, k);
    (before / after).ln() / (NU * k * k * end)
}

/// Sums of (4.6) err by the square of the width over the wave length, 4 for each doubling, and
/// by the 0.1 % by which a sum over the lattice is no integral.
fn converges(what: Diffused, energy: EnergyForm) {
    let sizes = [16, 32, 64];
    let errors = sizes.map(|size| rate(what, energy, size) - 1.0);
    println!("{what:?}, {energy:?}: rates off by {errors:?} with {sizes:?} particles a wave");
    assert!(errors[2].abs() < 0.005, "{what:?}: {errors:?}");
    let ratio = (errors[0] - errors[1]) / (errors[1] - errors[2]);
    assert!(
        (3.5..4.5).contains(&ratio),
        "{what:?}: ratio {ratio}, expected 4, from {errors:?} with {sizes:?}"
    );
}

#[test]
fn a_shear_wave_decays_by_the_kinematic_viscosity() {
    converges(Diffused::Shear, EnergyForm::LeapFrog);
}

#[test]
fn a_wave_of_heat_decays_by_the_thermal_diffusivity_in_every_form_of_the_energy() {
    for energy in [EnergyForm::LeapFrog, EnergyForm::Exact, EnergyForm::Total] {
        converges(Diffused::Heat, energy);
    }
}
