//! Gradients are exact for linear fields, whatever the cloud.

use motes_core::cutoff::CubicSpline;
use motes_core::domain::Domain;
use motes_core::equation::gas::Particle;
use motes_core::equation::gas::gradient::{Gradient, GradientNode, GradientSums, Slopes};
use motes_core::equation::gas::{NoSlip, Options};
use motes_core::neighbours::sort;
use motes_core::pairs::{Engine, Fields, PlainLoop, Settled};
use motes_solver::families::gas::PlainArrays;

use super::{Matrix, cloud, dot, times};
use crate::clouds::Stream;

/// The gradients of a cloud in empty space, each summed over a width of its own, in id order.
fn slopes<const D: usize>(particles: &[Particle<f64, D>]) -> Vec<Slopes<f64, D>> {
    let positions: Vec<_> = particles.iter().map(|particle| particle.position).collect();
    let width = |id: usize| particles[id].epsilon;
    let mut arrays = PlainArrays::new(particles.iter().copied(), &Options::OFF);
    let (_, mut work) = arrays.parts();
    let reach = |id| 2.0 * width(id);
    let grid = sort(&Domain::FREE, &positions, &reach, &mut work.cells).unwrap();
    let cells = work.cells.cells(grid, particles.len());
    let node = |&id: &u32| {
        let particle = &particles[id as usize];
        GradientNode {
            measure: particle.mass,
            scale: 1.0 / particle.epsilon,
            energy: particle.energy,
            velocity: particle.velocity,
        }
    };
    let nodes: Vec<_> = cells.order().iter().map(node).collect();
    let mut settled = vec![Settled::new(GradientNode::ZERO, GradientSums::ZERO); nodes.len()];
    let law = Gradient {
        walls: NoSlip::NONE,
        cut_off: CubicSpline,
    };
    PlainLoop.sweep(&law, &cells, &nodes, &mut settled).unwrap();
    let mut slopes = vec![settled[0].sums.slopes(); nodes.len()];
    for (settled, &id) in settled.iter().zip(cells.order()) {
        slopes[id as usize] = settled.sums.slopes();
    }
    slopes
}

/// The particles with a linear velocity and energy, and widths that differ.
fn with_linear_fields<const D: usize>(
    mut particles: Vec<Particle<f64, D>>,
    velocity: &Matrix<D>,
    energy: &[f64; D],
) -> Vec<Particle<f64, D>> {
    let mut stream = Stream::new(4);
    for particle in &mut particles {
        let x = particle.position;
        particle.velocity = times(velocity, &x).map(|u| u - 0.7);
        particle.energy = 1.5 + dot(energy, &x);
        particle.epsilon *= 1.0 + 0.1 * stream.next();
    }
    particles
}

/// Fields of up to 60 have differences good to 60 `u`, u = 2^-53, over distances of about 1;
/// a mean over partners is no worse, and the inverse of the moments at the rim of a cloud
/// multiplies that by a few.
const BOUND: f64 = 3.0 * 60.0 / (1u64 << 53) as f64;

fn linear_fields_are_exact<const D: usize>(per_side: usize) {
    let mut stream = Stream::new(D as u64);
    let mut worst = 0.0f64;
    for seed in 1..6 {
        let velocity: Matrix<D> = std::array::from_fn(|_| std::array::from_fn(|_| stream.next()));
        let energy: [f64; D] = std::array::from_fn(|_| stream.next());
        let particles = cloud(per_side, seed).particles::<f64, D>();
        let particles = with_linear_fields(particles, &velocity, &energy);
        for (id, slopes) in slopes(&particles).iter().enumerate() {
            let found = slopes.velocity.as_flattened().iter().chain(&slopes.energy);
            let exact = velocity.as_flattened().iter().chain(&energy);
            for (found, exact) in found.zip(exact) {
                let error = (found - exact).abs();
                assert!(
                    error <= BOUND,
                    "{found}, not {exact}: {id} of cloud {seed} in {D}D"
                );
                worst = worst.max(error);
            }
        }
    }
    println!("{D}D: gradients off by {worst:.1e} at most, bound {BOUND:.1e}");
    assert!(worst > 0.05 * BOUND, "{worst:e}");
}

#[test]
fn gradients_of_linear_fields_are_exact_in_every_dimension() {
    linear_fields_are_exact::<1>(60);
    linear_fields_are_exact::<2>(14);
    linear_fields_are_exact::<3>(8);
}

/// Flattened into a line or plane askew, a cloud no longer determines a gradient: what is left
/// of it is round-off.
fn degenerate<const D: usize>(per_side: usize) {
    let velocity: Matrix<D> = std::array::from_fn(|i| std::array::from_fn(|j| (i + j) as f64));
    let mut particles = cloud(per_side, 3).particles::<f64, D>();
    for particle in &mut particles {
        particle.position[D - 1] = 0.3 * particle.position[0] + 0.1;
    }
    let nothing = Slopes {
        velocity: [[0.0; D]; D],
        energy: [0.0; D],
    };
    let particles = with_linear_fields(particles, &velocity, &[1.0; D]);
    for slopes in slopes(&particles) {
        assert_eq!(slopes, nothing, "{D}D");
    }
}

#[test]
fn partners_on_a_line_or_in_a_plane_give_no_gradient() {
    degenerate::<2>(9);
    degenerate::<3>(5);
    let lonely = cloud(1, 1).particles::<f64, 1>();
    assert_eq!(slopes(&lonely)[0].velocity, [[0.0]]);
}
