//! A wall is the mirror image of the gas in front of it, with all options.

use motes_core::cutoff::CubicSpline;
use motes_core::domain::{Axis, Domain, Side};
use motes_core::equation::gas::{EnergyForm, Gas, Particle, Weights};

use super::{Setup, cloud, everything, pairwise};
use crate::clouds::materials;

/// Two materials, the second one a little away from the wall, in rows across it.
fn half<const D: usize>(per_side: usize) -> Vec<Particle<f64, D>> {
    let mut particles = cloud(per_side, 8).particles::<f64, D>();
    for particle in &mut particles {
        particle.material = u8::from(particle.position[D - 1] > 0.5 * per_side as f64);
    }
    particles
}

/// The particles and their mirror images at `x_0 = 0`.
fn doubled<const D: usize>(half: &[Particle<f64, D>]) -> Vec<Particle<f64, D>> {
    let image = |particle: &Particle<f64, D>| {
        let mut image = *particle;
        image.position[0] = -image.position[0];
        image.velocity[0] = -image.velocity[0];
        image
    };
    half.iter().copied().chain(half.iter().map(image)).collect()
}

/// Position, velocity, energy, density, factor of the viscosity, force and power.
fn state<const D: usize>(gas: &Gas<'_, f64, D>, id: usize) -> Vec<f64> {
    let scalars = [
        gas.energy[id],
        gas.density[id],
        gas.viscosity_factor[id],
        gas.power[id],
    ];
    let vectors = [gas.position[id], gas.velocity[id], gas.force[id]];
    scalars
        .into_iter()
        .chain(vectors.as_flattened().iter().copied())
        .collect()
}

const STEPS: usize = 5;

/// Sums of up to 100 terms have them in another order: a few `u` of quantities of order 1, and
/// of positions of up to 40, which `div u` and forces multiply over five steps.
const BOUND: f64 = 400.0 / (1u64 << 53) as f64;

fn is_a_mirror<const D: usize>(per_side: usize, eta: f64) {
    let length = per_side as f64;
    let along = [Side::Periodic; 2];
    let axis = |lower, sides| Axis {
        lower,
        upper: length,
        sides,
    };
    let forms = [EnergyForm::LeapFrog, EnergyForm::Exact, EnergyForm::Total];
    for (energy, weights) in forms
        .into_iter()
        .zip([Weights::Mass, Weights::Number].into_iter().cycle())
    {
        for (sides, of_both) in [
            ([Side::Mirror, Side::Free], [Side::Free; 2]),
            ([Side::Mirror; 2], [Side::Periodic; 2]),
        ] {
            let mut options = everything::<D>(energy);
            options.plain.weights = weights;
            let mut axes = [axis(0.0, along); D];
            axes[0] = axis(0.0, sides);
            let domain = Domain { axes };
            axes[0] = axis(-length, of_both);
            let whole = Domain { axes };
            let particles = half::<D>(per_side);
            let both = doubled(&particles);
            let n = particles.len();
            let of = (pairwise(), materials());
            let mut half = Setup::new(particles, domain, (CubicSpline, eta), of, options);
            let mut both = Setup::new(both, whole, (CubicSpline, eta), of, options);
            half.advance(STEPS, 0.05);
            both.advance(STEPS, 0.05);
            let (half, both) = (half.gas(), both.gas());
            let mut worst = 0.0f64;
            for id in 0..n {
                for (a, b) in state(&half, id).into_iter().zip(state(&both, id)) {
                    let error = (a - b).abs();
                    assert!(
                        error <= BOUND,
                        "{a}, not {b} at {id} in {D}D, {sides:?}, {energy:?}, {weights:?}"
                    );
                    worst = worst.max(error);
                }
            }
            println!("{D}D, {sides:?}, {energy:?}, {weights:?}: off by {worst:.1e}");
        }
    }
}

#[test]
fn walls_are_mirrors_with_all_options() {
    is_a_mirror::<1>(40, 1.6);
    is_a_mirror::<2>(14, 1.5);
    is_a_mirror::<3>(12, 0.8);
}
