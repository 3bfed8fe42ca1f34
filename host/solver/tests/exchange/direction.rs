//! Forces along gradients that are exact for linear fields.

use motes_core::cutoff::WendlandC2;
use motes_core::domain::Domain;
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{Options, Particle, Weights, Width};
use motes_core::material::IdealGas;
use motes_core::pairs::HalfLoop;
use motes_solver::families::gas::OptionsArrays;

use super::{Matrix, cloud, dot, everything, lattice, periodic, times};
use crate::clouds::Stream;
use motes_core::equation::gas::EnergyForm;

const GAMMA: f64 = 1.4;
const ETA: f64 = 1.4;

fn along<const D: usize>(linear_exact: bool) -> Options<f64, D> {
    Options {
        linear_exact,
        ..Options::OFF
    }
}

/// A particle of a cloud as it is after the sums at the start.
struct Seen<const D: usize> {
    position: [f64; D],
    density: f64,
    epsilon: f64,
    acceleration: [f64; D],
    heating: f64,
}

/// What the particles of a cloud in empty space do.
fn seen<const D: usize>(
    particles: Vec<Particle<f64, D>>,
    domain: Domain<f64, D>,
    width: Width<f64>,
    options: Options<f64, D>,
) -> Vec<Seen<D>> {
    let materials = [IdealGas::new(GAMMA)];
    let solver = motes_core::equation::gas::GasDynamics {
        domain,
        cut_off: WendlandC2,
        width,
        viscosity: Inviscid,
        materials: &materials,
        physics: options,
        courant: 0.3,
        smallest_omega: 1.0 / 32.0,
    };
    let mut arrays = OptionsArrays::new(particles, &everything(EnergyForm::Exact));
    let (mut gas, mut work) = arrays.parts();
    solver.prepare(&mut HalfLoop, &mut gas, &mut work).unwrap();
    let one = |id: usize| Seen {
        position: gas.position[id],
        density: gas.density[id],
        epsilon: gas.epsilon[id],
        acceleration: gas.force[id].map(|force| force / gas.mass[id]),
        heating: gas.power[id] / gas.mass[id],
    };
    (0..gas.len()).map(one).collect()
}

/// A lattice mapped by a matrix, with an energy that is linear in space.
fn strained<const D: usize>(
    per_side: usize,
    strain: &Matrix<D>,
    slope: &[f64; D],
) -> Vec<Particle<f64, D>> {
    let mut particles = lattice([per_side; D]);
    for particle in &mut particles {
        let centred = particle.position.map(|x| x - 0.5 * per_side as f64);
        particle.position = times(strain, &centred);
        particle.energy = 3.0 + dot(slope, &particle.position);
        particle.epsilon = ETA;
    }
    particles
}

/// The largest error of the acceleration of particles that see no rim, over `|∇p|/ρ`.
fn error_of_linear_pressure<const D: usize>(
    per_side: usize,
    strain: &Matrix<D>,
    (width, options): (Width<f64>, Options<f64, D>),
) -> f64 {
    let slope: [f64; D] = std::array::from_fn(|i| [0.05, -0.03, 0.04][i]);
    let particles = strained(per_side, strain, &slope);
    let all = seen(particles, Domain::FREE, width, options);
    // Far enough inside that the partners have the widths of an endless lattice.
    let inner = all.iter().filter(|one| {
        let distance = one.position.iter().map(|x| x.abs()).fold(0.0, f64::max);
        distance < 0.75
    });
    let (mut worst, mut count) = (0.0f64, 0);
    for one in inner {
        count += 1;
        for i in 0..D {
            let exact = -(GAMMA - 1.0) * slope[i];
            worst = worst.max((one.acceleration[i] - exact).abs() / (GAMMA - 1.0));
        }
    }
    assert!(count >= 1, "none is inside");
    worst / dot(&slope, &slope).sqrt()
}

/// Stretched and sheared at once.
fn strain<const D: usize>() -> Matrix<D> {
    let mut strain: Matrix<D> = std::array::from_fn(|i| std::array::from_fn(|j| (i == j).into()));
    strain[0][0] = 1.25;
    if D > 1 {
        strain[0][1] = 0.3;
        strain[1][1] = 0.8;
    }
    strain
}

fn linear_pressure<const D: usize>(per_side: usize, least: f64) {
    let widths = [Width::adaptive(ETA), Width::Constant { epsilon: ETA }];
    let measures = [Weights::Mass, Weights::Number];
    for (width, weights) in widths.into_iter().flat_map(|w| measures.map(|m| (w, m))) {
        let [plain, exact] = [false, true].map(|linear_exact| {
            let mut options = along(linear_exact);
            options.plain.weights = weights;
            error_of_linear_pressure::<D>(per_side, &strain(), (width, options))
        });
        println!("{D}D {width:?} {weights:?}: plain {plain:.1e}, linear-exact {exact:.1e}");
        // Sums of some hundred pressures of 1, each rounded, over a slope of 0.06.
        assert!(exact < 1e-12, "{exact:e} in {D}D, {width:?}, {weights:?}");
        assert!(plain > least, "{plain:e} in {D}D, {width:?}, {weights:?}");
    }
}

#[test]
fn on_a_strained_lattice_the_force_of_a_linear_pressure_is_exact() {
    linear_pressure::<2>(21, 0.005);
    linear_pressure::<3>(19, 0.005);
}

/// A cloud with a linear velocity: `de/dt = -p/ρ div u` of those with partners all around.
fn linear_velocity<const D: usize>(per_side: usize) {
    let mut stream = Stream::new(D as u64 + 7);
    let gradient: Matrix<D> = std::array::from_fn(|_| std::array::from_fn(|_| stream.next()));
    let trace: f64 = (0..D).map(|i| gradient[i][i]).sum();
    let mut worst = [0.0f64; 2];
    for seed in 1..4 {
        let mut particles = cloud(per_side, seed).particles::<f64, D>();
        for particle in &mut particles {
            particle.velocity = times(&gradient, &particle.position);
            particle.energy = 2.0;
            particle.material = 0;
        }
        for (form, linear_exact) in [false, true].into_iter().enumerate() {
            let all = seen(
                particles.clone(),
                Domain::FREE,
                Width::adaptive(1.6),
                along(linear_exact),
            );
            let side = per_side as f64;
            for one in all {
                let inside = |x: &f64| *x > 0.3 * side && *x < 0.7 * side;
                if one.position.iter().all(inside) {
                    assert!(one.density > 0.0 && one.epsilon > 0.0);
                    let exact = -(GAMMA - 1.0) * 2.0 * trace;
                    worst[form] = worst[form].max((one.heating / exact - 1.0).abs());
                }
            }
        }
    }
    println!(
        "{D}D: work off by {:.1e}, linear-exact {:.1e}",
        worst[0], worst[1]
    );
    assert!(worst[1] < 1e-12, "{D}D: {:e}", worst[1]);
    assert!(worst[0] > 1e-3, "{D}D: {:e}", worst[0]);
}

#[test]
fn the_work_of_a_linear_velocity_is_exact_on_any_cloud() {
    linear_velocity::<2>(16);
    linear_velocity::<3>(9);
}

/// Momentum of a cloud of unlike masses with every other option on, and what its energy forms keep.
fn pairs_are_opposite<const D: usize>(per_side: usize) {
    for weights in [Weights::Mass, Weights::Number] {
        let mut options = everything(EnergyForm::Exact);
        options.linear_exact = true;
        options.plain.weights = weights;
        let particles = cloud(per_side, 5).particles::<f64, D>();
        let all = seen(
            particles.clone(),
            Domain::FREE,
            Width::adaptive(1.6),
            options,
        );
        let (mut sum, mut size) = ([0.0f64; D], 0.0f64);
        for (one, particle) in all.iter().zip(&particles) {
            for i in 0..D {
                let force = particle.mass * one.acceleration[i];
                sum[i] += force;
                size += force.abs();
            }
        }
        for sum in sum {
            assert!(sum.abs() < 1e-14 * size, "{sum:e} of {size:e} in {D}D");
        }
    }
}

#[test]
fn forces_are_opposite_in_each_pair() {
    pairs_are_opposite::<1>(40);
    pairs_are_opposite::<2>(12);
    pairs_are_opposite::<3>(7);
}

/// A jittered box at constant pressure: the mean acceleration that should not be there, over `p/(ρ h)`.
fn stray<const D: usize>(per_side: usize, linear_exact: bool) -> f64 {
    let mut stream = Stream::new(3);
    let mut particles = lattice([per_side; D]);
    for particle in &mut particles {
        for x in &mut particle.position {
            *x += 0.2 * stream.next();
        }
        particle.epsilon = ETA;
    }
    let (domain, width) = (periodic([per_side; D]), Width::adaptive(ETA));
    // The densities that make the pressure constant.
    let at_rest = seen(particles.clone(), domain, width, along(false));
    for (particle, one) in particles.iter_mut().zip(&at_rest) {
        particle.energy = 1.0 / ((GAMMA - 1.0) * one.density);
    }
    let all = seen(particles, domain, width, along(linear_exact));
    let squares = all
        .iter()
        .map(|one| dot(&one.acceleration, &one.acceleration));
    (squares.sum::<f64>() / all.len() as f64).sqrt()
}

/// No sum of opposite pairs is exact for a constant on any cloud: what is left is what it was.
#[test]
fn a_constant_pressure_on_a_disordered_cloud_pushes_as_it_did() {
    for (dimension, [plain, exact]) in [
        (2, [false, true].map(|form| stray::<2>(16, form))),
        (3, [false, true].map(|form| stray::<3>(10, form))),
    ] {
        println!("{dimension}D: stray acceleration {plain:.4}, linear-exact {exact:.4}");
        let ratio = exact / plain;
        assert!((0.7..1.3).contains(&ratio), "{ratio} in {dimension}D");
    }
}

/// A wall is as good as the other half of a mirrored cloud.
fn mirrored<const D: usize>() {
    let mut stream = Stream::new(11);
    let counts: [usize; D] = std::array::from_fn(|i| if i == 0 { 7 } else { 10 });
    let mut particles = lattice(counts);
    for particle in &mut particles {
        for x in &mut particle.position {
            *x += 0.15 * stream.next();
        }
        particle.velocity = std::array::from_fn(|_| 0.3 * stream.next());
        particle.energy = 2.0 + 0.3 * stream.next();
        particle.epsilon = ETA;
    }
    let mut whole = particles.clone();
    for particle in &particles {
        let mut image = *particle;
        image.position[0] = -image.position[0];
        image.velocity[0] = -image.velocity[0];
        whole.push(image);
    }
    let mut options = everything(EnergyForm::Exact);
    options.linear_exact = true;
    let mut walled = periodic(counts);
    walled.axes[0] = motes_core::domain::Axis::walls(0.0, counts[0] as f64);
    let mut doubled = periodic(counts);
    doubled.axes[0] = motes_core::domain::Axis::walls(-(counts[0] as f64), counts[0] as f64);
    let width = Width::adaptive(ETA);
    let all = seen(whole, doubled, width, options);
    for (half, one) in seen(particles, walled, width, options).iter().zip(&all) {
        for (a, b) in half.acceleration.iter().zip(one.acceleration) {
            assert!((a - b).abs() < 1e-12, "{a}, not {b} in {D}D");
        }
    }
}

#[test]
fn behind_a_wall_directions_are_mirrored() {
    mirrored::<2>();
    mirrored::<3>();
}
