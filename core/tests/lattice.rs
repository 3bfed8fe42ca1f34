//! A lattice has the density that it has, and a liquid at rest the pressure of hydrostatics.

use motes_core::cutoff::{CutOff, QuinticSpline, WendlandC2, WendlandC6};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{GasDynamics, Packing, Particle, Plain, PlainStorage, Width};
use motes_core::error::Error;
use motes_core::integrator::{LeapFrog, Stepper};
use motes_core::material::{IdealGas, Named, Tait};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::HalfLoop;
use motes_core::scalar::{Q32, Scalar};

use fixed::types::extra::U19;

const N: usize = 1000;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

/// Points in a box of these sides, one in a unit of volume.
struct Lattice<const D: usize> {
    points: Vec<[f64; D]>,
    sides: [f64; D],
}

/// So many steps along each direction.
fn cubic<const D: usize>(along: usize) -> Lattice<D> {
    let point = |k: usize| std::array::from_fn(|i| (k / along.pow(i as u32) % along) as f64 + 0.5);
    Lattice {
        points: (0..along.pow(D as u32)).map(point).collect(),
        sides: [along as f64; D],
    }
}

fn hexagonal(rows: usize) -> Lattice<2> {
    let side = (2.0 / 3f64.sqrt()).sqrt();
    let point = |k: usize| {
        let (row, place) = (k / rows, k % rows);
        let shift = 0.25 + 0.5 * (row % 2) as f64;
        [(place as f64 + shift) * side, (row as f64 + 0.5) / side]
    };
    Lattice {
        points: (0..rows * rows).map(point).collect(),
        sides: [rows as f64 * side, rows as f64 / side],
    }
}

/// Cells of four points.
fn face_centred(cells: usize) -> Lattice<3> {
    let edge = 4f64.cbrt();
    let corners = [[0.0; 3], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5], [0.5, 0.5, 0.0]];
    let point = |k: usize| {
        let cell = [k / 4 % cells, k / 4 / cells % cells, k / 4 / cells / cells];
        std::array::from_fn(|i| (cell[i] as f64 + corners[k % 4][i] + 0.25) * edge)
    };
    Lattice {
        points: (0..4 * cells.pow(3)).map(point).collect(),
        sides: [cells as f64 * edge; 3],
    }
}

fn gas<S: Scalar, C: CutOff, const D: usize>(
    cut_off: C,
    width: Width<S>,
    sides: [f64; D],
    materials: &[Named<S>],
) -> GasDynamics<'_, S, C, Pairwise<S>, Named<S>, Plain<S, D>, D> {
    GasDynamics {
        domain: Domain {
            axes: sides.map(|side| Axis::periodic(S::ZERO, S::from_f64(side))),
        },
        cut_off,
        width,
        viscosity: Pairwise(Coefficients {
            alpha: S::ONE,
            beta: S::count(2),
        }),
        materials,
        physics: Plain::DEFAULT,
        courant: S::from_f64(0.3),
        smallest_omega: S::from_f64(1.0 / 32.0),
    }
}

/// The largest difference of a density from 1.
fn off<S: Scalar, C: CutOff, const D: usize>(
    cut_off: C,
    (eta, packing): (f64, Packing),
    lattice: &Lattice<D>,
) -> f64 {
    let materials = [Named::IdealGas(IdealGas::new(1.4))];
    let eta = S::from_f64(eta);
    let width = Width::Adaptive { eta, packing };
    let dynamics = gas(cut_off, width, lattice.sides, &materials);
    let mut memory = PlainStorage::<S, D, N, CELLS>::new();
    for point in &lattice.points {
        let particle = Particle {
            position: point.map(S::from_f64),
            velocity: [S::ZERO; D],
            mass: S::ONE,
            energy: S::ONE,
            epsilon: eta,
            material: 0,
        };
        memory.push(particle).unwrap();
    }
    let mut run = Stepper::new(dynamics, LeapFrog, HalfLoop, memory).unwrap();
    let density = run.state().density.iter().map(|density| density.to_f64());
    density.fold(0.0, |most, density| f64::max(most, (density - 1.0).abs()))
}

/// Runs what keeps a cloud of that size on the stack.
fn with_room(test: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(1 << 26);
    thread.spawn(test).unwrap().join().unwrap();
}

/// The sums that they have are those that their densities are made for, to the square of the last step of
/// the iteration.
#[test]
fn a_lattice_has_its_density() {
    with_room(|| {
        use Packing::{Close, Cubic};
        fn check<C: CutOff>(cut_off: C, eta: f64) {
            let all = [
                off::<f64, _, 1>(cut_off, (eta, Cubic), &cubic(20)),
                off::<f64, _, 2>(cut_off, (eta, Cubic), &cubic(20)),
                off::<f64, _, 2>(cut_off, (eta, Close), &hexagonal(20)),
                off::<f64, _, 3>(cut_off, (eta, Cubic), &cubic(10)),
                off::<f64, _, 3>(cut_off, (eta, Close), &face_centred(6)),
            ];
            assert!(all.iter().all(|&off| off < 1e-9), "{eta}: {all:?}");
            // Of one and made for the other: what is left.
            let others = [
                off::<f64, _, 2>(cut_off, (eta, Close), &cubic(20)),
                off::<f64, _, 3>(cut_off, (eta, Cubic), &face_centred(6)),
            ];
            assert!(others.iter().all(|&off| off < 6e-3), "{eta}: {others:?}");
        }
        check(WendlandC2, 1.3);
        check(WendlandC6, 1.4);
        check(QuinticSpline, 1.0);
    });
}

#[test]
fn a_lattice_has_its_density_in_fixed_point() {
    with_room(|| {
        let close = (1.3, Packing::Close);
        let off = [
            off::<Q32<U19>, _, 2>(WendlandC2, (1.3, Packing::Cubic), &cubic(12)),
            off::<Q32<U19>, _, 2>(WendlandC2, close, &hexagonal(12)),
            off::<Q32<U19>, _, 3>(WendlandC2, close, &face_centred(6)),
        ];
        assert!(off.iter().all(|&off| off < 1e-3), "{off:?}");
    });
}

/// A liquid under its weight in a box, stiff enough that 1 % of density is the weight of all of it: in
/// the mean and in its lower half, from the start on.
#[test]
fn a_column_of_liquid_has_the_pressure_of_hydrostatics() {
    with_room(|| {
        const ALONG: usize = 16;
        let (sound_speed, gravity, side) = (10.0, 1.0 / ALONG as f64, ALONG as f64);
        let material = Named::Tait(Tait::new(1.0, sound_speed, 7));
        let materials = [material];
        let mut dynamics = gas(WendlandC2, Width::adaptive(1.3), [side; 2], &materials);
        dynamics.domain.axes = [Axis::walls(0.0, side); 2];
        dynamics.physics.acceleration = [0.0, -gravity];
        let mut memory = PlainStorage::<f64, 2, N, CELLS>::new();
        let depth = |y: f64| side - y;
        for position in cubic::<2>(ALONG).points {
            // p = c²/7 (ρ^7 - 1) = g times the depth.
            let density =
                (1.0f64 + 7.0 * gravity * depth(position[1]) / sound_speed.powi(2)).powf(1.0 / 7.0);
            let particle = Particle {
                position,
                velocity: [0.0; 2],
                mass: density,
                energy: 0.0,
                epsilon: 1.3,
                material: 0,
            };
            memory.push(particle).unwrap();
        }
        let mut run = Stepper::new(dynamics, LeapFrog, HalfLoop, memory).unwrap();
        let mut run_until = |time: f64| -> Result<(f64, f64), Error> {
            run.advance_to(time)?;
            let state = run.state();
            let pressure: Vec<f64> = (0..ALONG * ALONG)
                .map(|k| {
                    let density = state.density[k];
                    sound_speed.powi(2) / 7.0 * (density.powi(7) - 1.0)
                })
                .collect();
            let mean = pressure.iter().sum::<f64>() / pressure.len() as f64;
            let lower = state
                .position
                .iter()
                .zip(&pressure)
                .filter(|(x, _)| x[1] < 0.5 * side);
            let (count, sum) = lower.fold((0.0, 0.0), |(n, sum), (_, p)| (n + 1.0, sum + p));
            Ok((mean, sum / count))
        };
        // Sound that the start leaves behind runs up and down.
        let times = (0..40).map(f64::from);
        let (mut mean, mut lower) = (0.0, 0.0);
        for found in times.map(|time| run_until(time).unwrap()) {
            (mean, lower) = (mean + found.0 / 40.0, lower + found.1 / 40.0);
            assert!((found.0 / 0.5 - 1.0).abs() < 0.01, "{found:?}");
        }
        assert!((mean / 0.5 - 1.0).abs() < 0.01, "{mean}");
        assert!((lower / 0.75 - 1.0).abs() < 0.01, "{lower}");
    });
}
