//! What every system must be: odd, symmetrisable by what it says, no faster than it says, and its
//! own mirror image.

use super::*;
use crate::domain::Wall;
use crate::equation::linear::{FirstOrderSystem, Nothing, Place, Still};
use crate::pairs::Fields;

/// Numbers in [-1, 1] from a seed.
fn numbers<const N: usize>(seed: u32) -> [f64; N] {
    let mut state = seed;
    core::array::from_fn(|_| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 23) - 1.0
    })
}

fn dot<const P: usize>(a: &[f64; P], b: &[f64; P]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Checks a system of constant coefficients; `has_parity`: whether it may meet walls.
fn check<F, const D: usize, const P: usize>(name: &str, system: &F, has_parity: bool)
where
    F: FirstOrderSystem<f64, D, P>,
{
    let medium = system.medium(&Place {
        position: [0.0; D],
        time: 0.0,
    });
    let shown = medium.splat::<f64>();
    for seed in 0..50 {
        let (n, u, v) = (
            numbers::<D>(seed),
            numbers::<P>(seed + 100),
            numbers::<P>(seed + 200),
        );
        let flux = |n: &[f64; D], u: &[f64; P]| system.flux(&shown, n, u);
        let weighed = |u: &[f64; P]| system.symmetrised(&medium, u);
        let size: f64 = flux(&n, &u).iter().map(|f| f.abs()).sum::<f64>() + 1.0;

        let back = flux(&n.map(|n| -n), &u);
        assert_eq!(back.map(|f| -f), flux(&n, &u), "{name} is not odd");

        assert!(dot(&u, &weighed(&u)) > 0.0, "{name}: P is not positive");
        let sides = [
            dot(&u, &weighed(&flux(&n, &v))),
            dot(&v, &weighed(&flux(&n, &u))),
        ];
        let room = 1e-13 * size * (weighed(&u).iter().map(|w| w.abs()).sum::<f64>() + 1.0);
        assert!(
            (sides[0] - sides[1]).abs() < room,
            "{name}: P A is not symmetric: {sides:?}"
        );

        // In the energy norm A(n) is symmetric: no vector grows by more than the speed.
        let length = dot(&n, &n).sqrt();
        let image = flux(&n, &u);
        let grown = (dot(&image, &weighed(&image)) / dot(&u, &weighed(&u))).sqrt();
        let speed = system.speed(&medium) * length;
        assert!(
            grown <= speed * (1.0 + 1e-12),
            "{name}: {grown} is faster than {speed}"
        );

        for axis in 0..if has_parity { D } else { 0 } {
            let mut mirrored = n;
            mirrored[axis] = -mirrored[axis];
            let one = flux(&mirrored, &system.reflected(&u, axis));
            let other = system.reflected(&flux(&n, &u), axis);
            assert_eq!(one, other, "{name} across {axis}");
            let twice = system.reflected(&system.reflected(&u, axis), axis);
            assert_eq!(twice, u, "{name}");
            // Where the losses are no mirror image of themselves, the image must not be one either.
            let place = Place {
                position: [0.0; D],
                time: 0.0,
            };
            let one = system.decay(&place, &system.reflected(&u, axis));
            let other = system.reflected(&system.decay(&place, &u), axis);
            let wall = Wall {
                axis,
                end: 0,
                position: -1.0,
            };
            let image = system.reflected(&u, axis);
            let seen = system.behind(&medium, &image, &wall);
            assert_eq!(one == other, seen == image, "{name} across {axis}");
        }
    }
    // The speed is reached along some direction: powers of A(n) on a vector find the fastest wave.
    let mut n = [0.0; D];
    n[0] = 1.0;
    let mut u = numbers::<P>(7);
    let mut grown = 0.0;
    for _ in 0..200 {
        // A² has the eigenvalues speed², of either sign of A.
        let image = system.flux(&shown, &n, &system.flux(&shown, &n, &u));
        let size = dot(&image, &image).sqrt();
        grown = (size / dot(&u, &u).sqrt()).sqrt();
        u = image.map(|f| f / size);
    }
    let speed = system.speed(&medium);
    assert!(
        (grown / speed - 1.0).abs() < 1e-9,
        "{name}: {grown}, it says {speed}"
    );
}

#[test]
fn every_system_is_what_it_says() {
    let units = Units {
        length: 0.3,
        velocity: 1.7,
    };
    check::<_, 1, 2>("acoustics", &Acoustics::new(1.3, 2.0, units), true);
    check::<_, 2, 3>("acoustics", &Acoustics::new(1.3, 2.0, units), true);
    check::<_, 3, 4>("acoustics", &Acoustics::new(1.3, 2.0, units), true);
    let line = Telegraph::new([2.0, 0.7], [0.1, 0.3], units);
    check::<_, 1, 2>("telegraph", &line, true);
    let water = ShallowWater::new(9.81, 3.0, 0.2, units);
    check::<_, 2, 3>("shallow water", &water, true);
    check::<_, 2, 3>("Maxwell", &MaxwellTe::new(2.0, 0.4, units), true);
    let solid = ElasticWaves::new(1.2, [2.0, 0.9], units);
    check::<_, 2, 5>("elastic waves", &solid, true);
    let gas = LinearisedGas::new(1.2, 1.5, [0.0], units);
    check::<_, 1, 3>("linearised gas", &gas, true);
    let gas = LinearisedGas::new(1.2, 1.5, [0.3, 0.1], units);
    check::<_, 2, 4>("linearised gas", &gas, true);
    let gas = LinearisedGas::new(1.2, 1.5, [0.3, 0.1, 0.0], units);
    check::<_, 3, 5>("linearised gas", &gas, true);
    let own = Matrices {
        flux: [[[0.3, 4.0], [1.0, 0.3]]],
        decay: [[0.0; 2]; 2],
        symmetriser: [[1.0, 0.0], [0.0, 4.0]],
        speed: 2.3,
        damping: 0.0,
        growth: 0.0,
    };
    check::<_, 1, 2>("matrices", &own, false);
}

#[test]
fn transport_passes_nothing_on() {
    let transport = Transport {
        velocity: Still,
        decay: 0.3,
        source: 0.0,
    };
    let flux = FirstOrderSystem::<f64, 2, 1>::flux(&transport, &Nothing, &[0.3, 0.4], &[2.0]);
    assert_eq!(flux, [0.0]);
}
