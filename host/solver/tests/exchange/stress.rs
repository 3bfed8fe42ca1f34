//! What holds for the viscous stress on any cloud, to rounding.

use motes_core::cutoff::CubicSpline;
use motes_core::domain::Domain;
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{Diffusion, Options, Particle, Weights};
use motes_core::material::Isothermal;

use super::navier_stokes::{BOTH, BULK, SHEAR, viscous};
use super::{Matrix, Setup, cloud, dot, times};
use crate::clouds::Stream;

/// A disordered cloud with free sides that moves as `u = a x` does.
fn moving<const D: usize>(
    per_side: usize,
    gradient: &Matrix<D>,
    options: Options<f64, D>,
) -> (
    Vec<Particle<f64, D>>,
    Setup<'static, CubicSpline, Inviscid, Isothermal<f64>, D>,
) {
    let mut particles = cloud(per_side, 3).particles::<f64, D>();
    for particle in &mut particles {
        particle.velocity = times(gradient, &particle.position);
    }
    let materials: &'static [_] = Box::leak(Box::new([Isothermal::new(0.0)]));
    let of = (CubicSpline, 1.6);
    let gas = (Inviscid, materials);
    let setup = Setup::new(particles.clone(), Domain::FREE, of, gas, options);
    (particles, setup)
}

/// A gradient without symmetry.
fn gradient<const D: usize>() -> Matrix<D> {
    let mut stream = Stream::new(5);
    std::array::from_fn(|_| std::array::from_fn(|_| stream.next()))
}

/// Exact on any cloud: `m (2 ν |S|² + (ν_b - 2/3 ν) (div u)²)` of each particle, and nothing where the
/// cloud turns as a rigid body.
#[test]
fn the_heat_of_a_linear_field_is_that_of_the_stress() {
    fn check<const D: usize>(per_side: usize) {
        let a = gradient::<D>();
        let part = |sign: f64| -> Matrix<D> {
            std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (a[i][j] + sign * a[j][i])))
        };
        for weights in [Weights::Mass, Weights::Number] {
            let mut options = viscous(BOTH);
            options.plain.weights = weights;
            let strain = part(1.0);
            let trace: f64 = (0..D).map(|i| a[i][i]).sum();
            let squared = strain.as_flattened().iter().map(|s| s * s).sum::<f64>();
            let per_mass = 2.0 * BOTH.viscosity * squared
                + (BOTH.bulk_viscosity - 2.0 / 3.0 * BOTH.viscosity) * trace * trace;
            let (particles, mut setup) = moving(per_side, &a, options);
            for (heat, particle) in setup.gas().heat.iter().zip(&particles) {
                let share = heat / (particle.mass * per_mass);
                assert!((share - 1.0).abs() < 1e-6, "{share} in {D}D, {weights:?}");
            }
            let (_, mut setup) = moving(per_side, &part(-1.0), options);
            let gas = setup.gas();
            let forces = gas.force.as_flattened().iter().chain(gas.heat.iter());
            let largest = forces.fold(0.0f64, |most, f| most.max(f.abs()));
            assert!(largest < 1e-11, "{largest:e} in {D}D, {weights:?}");
        }
    }
    check::<1>(40);
    check::<2>(10);
    check::<3>(7);
}

/// With velocities at random: the force sums to 0, so does its moment about any point, and the heat is the
/// work, particle by particle not below 0.
#[test]
fn momentum_and_its_moment_are_conserved_and_heat_is_the_work() {
    fn check<const D: usize>(per_side: usize, eta: f64) {
        let particles = cloud(per_side, 4).particles::<f64, D>();
        let materials = [Isothermal::new(0.0)];
        for weights in [Weights::Mass, Weights::Number] {
            let mut options = viscous(BOTH);
            options.plain.weights = weights;
            let gas = (Inviscid, &materials[..]);
            let of = (CubicSpline, eta);
            let mut setup = Setup::new(particles.clone(), Domain::FREE, of, gas, options);
            let gas = setup.gas();
            let of_all = |term: &dyn Fn(usize) -> f64| -> f64 { (0..gas.len()).map(term).sum() };
            let work = of_all(&|id| dot(&gas.velocity[id], &gas.force[id]));
            let heat = of_all(&|id| gas.heat[id]);
            assert!(
                (work / heat + 1.0).abs() < 1e-13,
                "{work} by {heat} in {D}D"
            );
            assert!(gas.heat.iter().all(|&heat| heat > -1e-12));
            for i in 0..D {
                let force = of_all(&|id| gas.force[id][i]);
                assert!(force.abs() < 1e-11, "{force:e} in {D}D, {weights:?}");
                for j in 0..i {
                    let moment = of_all(&|id| {
                        let (x, f) = (&gas.position[id], &gas.force[id]);
                        x[i] * f[j] - x[j] * f[i]
                    });
                    assert!(moment.abs() < 1e-10, "{moment:e} in {D}D, {weights:?}");
                }
            }
        }
    }
    check::<1>(40, 1.6);
    check::<2>(12, 1.6);
    check::<3>(7, 1.2);
}

/// Steps of the stable length at the largest factor take energy from whatever moves, also at the rim of a
/// free cloud and across a jump of masses.
#[test]
fn steps_of_the_stable_length_only_take_energy() {
    fn check<const D: usize>(per_side: usize, eta: f64, diffusion: Diffusion<f64>) {
        let mut particles = cloud(per_side, 6).particles::<f64, D>();
        for particle in &mut particles {
            particle.velocity = particle.velocity.map(|u| 1e-6 * u);
        }
        let materials = [Isothermal::new(0.0)];
        let gas = (Inviscid, &materials[..]);
        let of = (CubicSpline, eta);
        let mut setup = Setup::new(particles, Domain::FREE, of, gas, viscous(diffusion));
        setup.solver.courant = 1.0;
        let dt = setup
            .solver
            .time_step(&setup.arrays.parts().0, 10.0)
            .unwrap();
        let kinetic = |setup: &mut Setup<'_, _, _, _, D>| -> f64 {
            let gas = setup.gas();
            (0..gas.len())
                .map(|id| gas.mass[id] * dot(&gas.velocity[id], &gas.velocity[id]))
                .sum()
        };
        let mut before = kinetic(&mut setup);
        for _ in 0..50 {
            setup.advance(1, dt);
            let after = kinetic(&mut setup);
            assert!(
                after <= before,
                "{after:e} after {before:e} in {D}D, {diffusion:?}"
            );
            before = after;
        }
    }
    for diffusion in [SHEAR, BULK, BOTH] {
        check::<1>(40, 1.2, diffusion);
        check::<2>(12, 1.2, diffusion);
        check::<3>(7, 1.2, diffusion);
    }
}
