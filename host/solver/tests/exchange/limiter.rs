//! The limited viscosity spares what is linear in space, and nothing else.

use motes_core::cutoff::CubicSpline;
use motes_core::domain::Domain;
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{Options, Viscosity};

use super::{Matrix, Setup, cloud, pairwise, times};
use crate::clouds::materials;

/// The forces on a free cloud with that velocity field.
fn forces<V: Viscosity<f64>, const D: usize>(
    per_side: usize,
    viscosity: V,
    limited: bool,
    field: impl Fn([f64; D]) -> [f64; D],
) -> Vec<[f64; D]> {
    let mut particles = cloud(per_side, 6).particles::<f64, D>();
    for particle in &mut particles {
        particle.velocity = field(particle.position);
    }
    let options = Options {
        limited,
        ..Options::OFF
    };
    let of = (viscosity, materials());
    let mut setup = Setup::new(particles, Domain::FREE, (CubicSpline, 1.6), of, options);
    setup.gas().force.to_vec()
}

/// The largest component of the viscous force, as it is and limited.
fn viscous<const D: usize>(
    per_side: usize,
    field: impl Fn([f64; D]) -> [f64; D] + Copy,
) -> [f64; 2] {
    let none = forces(per_side, Inviscid, false, field);
    [false, true].map(|limited| {
        let with = forces(per_side, pairwise(), limited, field);
        let pairs = with.as_flattened().iter().zip(none.as_flattened());
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    })
}

/// `a` on the diagonal and `b` beside it, of opposite signs above and below.
fn matrix<const D: usize>(a: f64, b: f64) -> Matrix<D> {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match i.cmp(&j) {
            std::cmp::Ordering::Less => b,
            std::cmp::Ordering::Equal => a,
            std::cmp::Ordering::Greater => -b,
        })
    })
}

/// Forces are of order 1, and so are the viscous ones: the sum of two round-offs of a force,
/// and of velocities of up to 16 in sound speeds whose differences cancel.
const BOUND: f64 = 16.0 / (1u64 << 53) as f64;

fn spares_linear_fields<const D: usize>(per_side: usize) {
    let mut fields = vec![matrix(0.4, 0.0), matrix(-0.4, 0.0)];
    if D > 1 {
        let mut shear = [[0.0; D]; D];
        shear[0][D - 1] = 0.4;
        fields.extend([shear, matrix(-0.3, 0.5)]);
    }
    for gradient in fields {
        let [full, limited] = viscous(per_side, |x: [f64; D]| times(&gradient, &x));
        println!("{D}D {gradient:?}: viscous forces up to {full:.2}, limited {limited:.1e}");
        assert!(limited <= BOUND, "{limited:e} of {full} for {gradient:?}");
        // Where all pairs recede there is none to be spared.
        let expands = gradient[0][0] > 0.0;
        assert_eq!(full == 0.0, expands, "{full} for {gradient:?}");
    }
}

#[test]
fn limited_viscosity_vanishes_in_linear_fields() {
    spares_linear_fields::<1>(40);
    spares_linear_fields::<2>(12);
    spares_linear_fields::<3>(7);
}

/// Two streams that meet: the gradient is what they differ by over the width of a cut-off, and
/// most of the difference of two neighbours remains.
fn acts_on_jumps<const D: usize>(per_side: usize) {
    let middle = 0.5 * per_side as f64;
    let [full, limited] = viscous(per_side, |x: [f64; D]| {
        let mut velocity = [0.0; D];
        velocity[0] = if x[0] < middle { 1.0 } else { -1.0 };
        velocity
    });
    println!("{D}D jump: viscous forces up to {full:.2}, limited {limited:.2}");
    let part = limited / full;
    assert!((0.25..1.0).contains(&part), "{limited} of {full} in {D}D");
}

#[test]
fn limited_viscosity_acts_on_jumps() {
    acts_on_jumps::<1>(40);
    acts_on_jumps::<2>(12);
    acts_on_jumps::<3>(7);
}
