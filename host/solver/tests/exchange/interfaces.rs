//! Weights by number: two fluids on one lattice, each with its own density up to the interface.

use motes_core::cutoff::CubicSpline;
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{EnergyForm, Options, Weights};

use super::{Setup, lattice, periodic};
use crate::clouds::materials;

const COUNTS: [usize; 2] = [16, 12];
const HEAVY: f64 = 8.0;
const PRESSURE: f64 = 0.7;
const GAMMAS: [f64; 2] = [1.4, 1.6];

/// The largest relative error of the density and the largest force, over the pressure, with a
/// heavy fluid in the lower half of a periodic box and a light one in the upper.
fn errors(weights: Weights, energy: EnergyForm) -> [f64; 2] {
    let mut particles = lattice(COUNTS);
    for particle in &mut particles {
        let light = particle.position[0] > 8.0;
        particle.material = u8::from(light);
        particle.mass = if light { 1.0 } else { HEAVY };
        // One particle in a cell of side 1.
        particle.energy = PRESSURE / ((GAMMAS[usize::from(light)] - 1.0) * particle.mass);
    }
    let mut options = Options {
        energy,
        ..Options::OFF
    };
    options.plain.weights = weights;
    let of = (Inviscid, materials());
    let mut setup = Setup::new(particles, periodic(COUNTS), (CubicSpline, 1.2), of, options);
    let gas = setup.gas();
    // The same sum over the lattice for all: that of a lattice of one fluid, far from 1 by less
    // than 1 %.
    let unit = gas.density[0] / gas.mass[0];
    assert!(
        weights == Weights::Mass || (unit - 1.0).abs() < 0.01,
        "{unit}"
    );
    let density = gas.density.iter().zip(gas.mass.iter());
    let off = density.map(|(density, mass)| (density / mass - 1.0).abs() - (unit - 1.0).abs());
    let force = gas
        .force
        .as_flattened()
        .iter()
        .map(|force| force.abs() / PRESSURE);
    [off.fold(0.0, f64::max), force.fold(0.0, f64::max)]
}

#[test]
fn weights_by_number_keep_two_fluids_apart_and_at_rest() {
    for energy in [EnergyForm::LeapFrog, EnergyForm::Exact, EnergyForm::Total] {
        let [density, force] = errors(Weights::Number, energy);
        println!("by number, {energy:?}: density off by {density:.1e}, force {force:.1e}");
        // Sums of some 20 terms in the order of their cells.
        assert!(density < 1e-14, "{density:e}");
        assert!(force < 1e-14, "{force:e}");
    }
}

/// The other side: what the option is for. A light particle at the interface has heavy
/// partners on one side, and half of the difference in its density.
#[test]
fn weights_by_mass_do_not() {
    let [density, force] = errors(Weights::Mass, EnergyForm::LeapFrog);
    println!("by mass: density off by {density:.2}, force {force:.2}");
    assert!((0.3..3.5).contains(&density), "{density}");
    assert!(force > 0.1, "{force}");
}
