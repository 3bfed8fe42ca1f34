//! Walls that a viscous gas sticks to, against exact flows, what a wall exerts, and what energy it gives.

mod clouds;

use std::f64::consts::PI;

use clouds::{Stream, lattice};
use motes_core::cutoff::WendlandC2;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{
    Diffusion, EnergyForm, Gas, GasDynamics, NoSlip, Options, Particle, Plain, WallForces, Width,
};
use motes_core::material::Tait;
use motes_core::pairs::{HalfLoop, PlainLoop};
use motes_solver::families::gas::OptionsArrays;

/// Spacings between the walls.
const ACROSS: usize = 16;
/// Along them, periodic.
const ALONG: usize = 10;
/// Of the wall, in sound speeds.
const SPEED: f64 = 0.05;
const VISCOSITY: f64 = 1.6;

type Solver<'m, const D: usize> =
    GasDynamics<'m, f64, WendlandC2, Inviscid, Tait<f64>, Options<f64, D>, D>;

/// A [`lattice`] whose particles have moved by up to half of `jitter`.
fn cloud<const D: usize>(counts: [usize; D], jitter: f64) -> Vec<Particle<f64, D>> {
    let mut stream = Stream::new(1);
    let mut particles = lattice(counts);
    for particle in &mut particles {
        // Of a gas that does not feel it the energy is only kept account of: from 0 its changes keep their digits.
        (particle.energy, particle.epsilon) = (0.0, 1.3);
        for x in &mut particle.position {
            *x += 0.5 * jitter * stream.next();
        }
    }
    particles
}

fn viscous<const D: usize>(walls: [[Option<[f64; D]>; 2]; D], pull: f64) -> Options<f64, D> {
    let mut acceleration = [0.0; D];
    acceleration[0] = pull;
    Options {
        diffusion: Diffusion {
            viscosity: VISCOSITY,
            ..Diffusion::OFF
        },
        walls: NoSlip { velocity: walls },
        plain: Plain {
            acceleration,
            ..Plain::DEFAULT
        },
        ..Options::OFF
    }
}

/// A gas without pressure at rest.
fn solver<'m, const D: usize>(
    domain: Domain<f64, D>,
    options: Options<f64, D>,
    materials: &'m [Tait<f64>],
) -> Solver<'m, D> {
    GasDynamics {
        domain,
        cut_off: WendlandC2,
        width: Width::adaptive(1.3),
        viscosity: Inviscid,
        materials,
        physics: options,
        courant: 0.3,
        smallest_omega: 1.0 / 32.0,
    }
}

/// A run of a cloud to a time, watched after each step.
fn run<const D: usize>(
    solver: &Solver<'_, D>,
    particles: Vec<Particle<f64, D>>,
    end: f64,
    mut watch: impl FnMut(f64, f64, &Gas<'_, f64, D>, &WallForces<D>),
) {
    let mut arrays = OptionsArrays::new(particles, &solver.physics);
    let (mut gas, mut work) = arrays.parts();
    solver.prepare(&mut HalfLoop, &mut gas, &mut work).unwrap();
    watch(0.0, 0.0, &gas, &solver.wall_forces(&gas, &work));
    let mut time = 0.0;
    while time < end {
        let dt = solver.time_step(&gas, end - time).unwrap();
        solver
            .advance(&mut HalfLoop, &mut gas, &mut work, dt)
            .unwrap();
        time += dt;
        watch(time, dt, &gas, &solver.wall_forces(&gas, &work));
    }
}

/// Between a wall at rest at y = 0 and one of velocity `u` at y = h, from rest, with acceleration `a`.
fn channel(y: f64, t: f64, [u, a]: [f64; 2]) -> f64 {
    let h = ACROSS as f64;
    let mut sum = u * y / h + 0.5 * a / VISCOSITY * y * (h - y);
    for n in 1..200 {
        let (k, sign) = (f64::from(n) * PI / h, if n % 2 == 0 { 1.0 } else { -1.0 });
        let coefficient = 2.0 * u * sign / k - 2.0 * a / VISCOSITY * (1.0 - sign) / (k * k * k);
        sum += coefficient / h * (-VISCOSITY * k * k * t).exp() * (k * y).sin();
    }
    sum
}

fn energies<const D: usize>(gas: &Gas<'_, f64, D>) -> f64 {
    let kinetic = |u: &[f64; D]| 0.5 * u.iter().map(|u| u * u).sum::<f64>();
    let rows = gas
        .mass
        .iter()
        .zip(gas.velocity.iter())
        .zip(gas.energy.iter());
    rows.map(|((m, u), e)| m * (kinetic(u) + e)).sum()
}

/// A channel in `D` dimensions: along x periodic, walls across y, along z periodic.
fn between_walls<const D: usize>() -> ([usize; D], Domain<f64, D>) {
    let counts = std::array::from_fn(|i| if i == 1 { ACROSS } else { ALONG });
    let side = |i: usize| counts[i] as f64;
    let axes = std::array::from_fn(|i| match i {
        1 => Axis::walls(0.0, side(1)),
        _ => Axis::periodic(0.0, side(i)),
    });
    (counts, Domain { axes })
}

/// The error of the velocity, root of the mean square over the largest speed, of a plane flow after `part`
/// of h²/ν.
fn error_of_plane_flow<const D: usize>([speed, pull]: [f64; 2], part: f64) -> f64 {
    let (counts, domain) = between_walls::<D>();
    let mut walls = [[None; 2]; D];
    let mut upper = [0.0; D];
    upper[0] = speed;
    walls[1] = [Some([0.0; D]), Some(upper)];
    let materials = [Tait::new(1.0, 1.0, 1)];
    let solver = solver(domain, viscous(walls, pull), &materials);
    let end = part * (ACROSS * ACROSS) as f64 / VISCOSITY;
    let mut error = f64::NAN;
    run(&solver, cloud(counts, 0.0), end, |time, _, gas, _| {
        let (mut sum, mut largest) = (0.0, 0.0f64);
        for (x, u) in gas.position.iter().zip(gas.velocity.iter()) {
            let exact = channel(x[1], time, [speed, pull]);
            largest = largest.max(exact.abs());
            sum += u[1..].iter().map(|u| u * u).sum::<f64>() + (u[0] - exact).powi(2);
        }
        error = (sum / gas.mass.len() as f64).sqrt() / largest;
    });
    error
}

#[test]
fn flow_between_walls_follows_the_solution_of_navier_and_stokes() {
    // At 32 across a fourth of these errors: 0.0004 and 0.0011.
    let couette = error_of_plane_flow::<2>([SPEED, 0.0], 0.1);
    assert!(couette < 0.004, "Couette's flow: {couette}");
    let poiseuille = error_of_plane_flow::<2>([0.0, 0.002], 0.1);
    assert!(poiseuille < 0.008, "Poiseuille's flow: {poiseuille}");
    let space = error_of_plane_flow::<3>([SPEED, 0.0], 0.03);
    assert!(space < 0.008, "Couette's flow in space: {space}");
}

#[test]
fn a_moving_wall_gives_the_energy_that_its_force_works() {
    for (form, bound) in [
        (EnergyForm::Exact, 1e-12),
        (EnergyForm::Total, 1e-12),
        (EnergyForm::LeapFrog, 2e-3),
    ] {
        let (counts, domain) = between_walls::<2>();
        let walls = [[None; 2], [Some([0.0; 2]), Some([SPEED, 0.0])]];
        let materials = [Tait::new(1.0, 1.0, 1)];
        let mut solver = solver(domain, viscous(walls, 0.0), &materials);
        solver.physics.energy = form;
        let (mut first, mut work, mut before) = (f64::NAN, 0.0, f64::NAN);
        let mut moved = f64::NAN;
        run(
            &solver,
            cloud(counts, 0.3),
            10.0,
            |time, dt, gas, forces| {
                let energy = energies(gas);
                if time == 0.0 {
                    first = energy;
                } else {
                    work += 0.5 * dt * (before + forces.power);
                }
                before = forces.power;
                // What acts on the wall in its own direction is all that does work.
                let power = -forces.force[1][1][0] * SPEED;
                assert!((forces.power - power).abs() < 1e-12 * power.abs().max(1e-6));
                moved = energy - first;
            },
        );
        assert!(work > 0.01, "{work}");
        let left = (moved - work).abs() / work;
        assert!(left < bound, "{form:?}: {moved} for {work}, {left} left");
    }
}

#[test]
fn walls_receive_what_the_gas_loses_of_momentum() {
    // Two walls at rest and two that move, and a corner between any two of them.
    let (side, end) = (12usize, 4.0);
    let domain = Domain {
        axes: [Axis::walls(0.0, side as f64); 2],
    };
    let walls = [
        [Some([0.0, 0.02]), Some([0.0; 2])],
        [None, Some([SPEED, 0.0])],
    ];
    let materials = [Tait::new(1.0, 1.0, 1)];
    let solver = solver(domain, viscous(walls, 0.0), &materials);
    let (mut before, mut impulse) = ([0.0; 2], [0.0; 2]);
    let mut momentum = [0.0; 2];
    run(&solver, cloud([side; 2], 0.3), end, |_, dt, gas, forces| {
        let now: [f64; 2] = std::array::from_fn(|i| {
            forces
                .force
                .iter()
                .flatten()
                .map(|force| force[i])
                .sum::<f64>()
        });
        for i in 0..2 {
            impulse[i] += 0.5 * dt * (before[i] + now[i]);
            momentum[i] = gas.velocity.iter().map(|u| u[i]).sum::<f64>();
            let forces: f64 = gas.force.iter().map(|force| force[i]).sum();
            assert!((forces + now[i]).abs() < 1e-11, "{forces} and {now:?}");
        }
        before = now;
    });
    for i in 0..2 {
        assert!(momentum[i].abs() > 0.01);
        let left = (momentum[i] + impulse[i]).abs();
        assert!(left < 1e-10, "{momentum:?} for {impulse:?}");
    }
}

#[test]
fn a_flow_that_is_linear_about_a_wall_has_its_gradient_there() {
    // Any cloud: the image of u = G x in a wall at rest at y = 0 is G x itself, and no stress of it
    // but that of the noise is left where G is that of a shear.
    let (counts, domain) = between_walls::<2>();
    let walls = [[None; 2], [Some([0.0; 2]), Some([SPEED, 0.0])]];
    let materials = [Tait::new(1.0, 1.0, 1)];
    let solver = solver(domain, viscous(walls, 0.0), &materials);
    let mut particles = cloud(counts, 0.0);
    for particle in &mut particles {
        particle.velocity[0] = SPEED * particle.position[1] / ACROSS as f64;
    }
    let mut arrays = OptionsArrays::new(particles, &solver.physics);
    let (mut gas, mut work) = arrays.parts();
    solver.prepare(&mut PlainLoop, &mut gas, &mut work).unwrap();
    for force in gas.force.iter() {
        assert!(force[0].abs() < 1e-15, "{force:?}");
    }
    // The stress is ρ ν u_w/h on every part of both walls.
    let exact = VISCOSITY * SPEED / ACROSS as f64 * ALONG as f64;
    let forces = solver.wall_forces(&gas, &work);
    for (end, sign) in [(0, 1.0), (1, -1.0)] {
        let force = sign * forces.force[1][end][0];
        assert!((force / exact - 1.0).abs() < 0.01, "{force} for {exact}");
    }
}

#[test]
fn a_wall_that_moves_with_the_gas_does_nothing() {
    // Everything moves with one velocity along the walls: nothing changes but the places.
    let (counts, domain) = between_walls::<3>();
    let velocity = [SPEED, 0.0, -0.5 * SPEED];
    let walls = [[None; 2], [Some(velocity); 2], [None; 2]];
    let materials = [Tait::new(1.0, 1.0, 1)];
    let solver = solver(domain, viscous(walls, 0.0), &materials);
    let mut particles = cloud(counts, 0.0);
    for particle in &mut particles {
        particle.velocity = velocity;
    }
    run(&solver, particles, 1.0, |_, _, gas, _| {
        for u in gas.velocity.iter() {
            for i in 0..3 {
                assert!((u[i] - velocity[i]).abs() < 1e-12, "{u:?}");
            }
        }
    });
}
