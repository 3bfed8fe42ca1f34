//! Where the viscosity acts: the switch in time, and Balsara's factor.

use std::f64::consts::TAU;

use motes_core::cutoff::CubicSpline;
use motes_core::domain::Domain;
use motes_core::equation::gas::viscosity::{Inviscid, Pairwise};
use motes_core::equation::gas::{Options, Particle, Switch};
use motes_core::material::Isothermal;

use super::{Matrix, Setup, cloud, lattice, pairwise, periodic, times};

const SWITCH: Switch<f64> = Switch {
    minimum: 0.05,
    decay: 0.2,
};
const SOUND_SPEED: f64 = 0.5;
const COUNTS: [usize; 2] = [36, 12];
/// `(h/ε)²` of [`CubicSpline`], whose support has radius 2ε.
const REACH_SQUARED: f64 = 4.0;

fn switched<const D: usize>() -> Options<f64, D> {
    Options {
        switch: Some(SWITCH),
        ..Options::OFF
    }
}

fn with_balsara<const D: usize>() -> Options<f64, D> {
    Options {
        balsara: true,
        ..Options::OFF
    }
}

/// The gas, prepared.
fn setup<const D: usize>(
    particles: Vec<Particle<f64, D>>,
    domain: Domain<f64, D>,
    materials: &[Isothermal<f64>],
    options: Options<f64, D>,
) -> Setup<'_, CubicSpline, Pairwise<f64>, Isothermal<f64>, D> {
    let of = (pairwise(), materials);
    Setup::new(particles, domain, (CubicSpline, 1.6), of, options)
}

/// The factors of a disordered free cloud with that velocity gradient at the start, and the
/// widths that go with them.
fn at_start<const D: usize>(
    per_side: usize,
    gradient: &Matrix<D>,
    options: Options<f64, D>,
) -> Vec<(f64, f64)> {
    let mut particles = cloud(per_side, 2).particles::<f64, D>();
    for particle in &mut particles {
        particle.velocity = times(gradient, &particle.position).map(|u| u + 3.0);
    }
    let materials = [Isothermal::new(SOUND_SPEED)];
    let mut setup = setup(particles, Domain::FREE, &materials, options);
    let gas = setup.gas();
    let factors = gas.viscosity_factor.iter().copied();
    factors.zip(gas.epsilon.iter().copied()).collect()
}

/// Rotation about, and shear in, the plane of the first and last direction.
fn rotation<const D: usize>(rate: f64) -> Matrix<D> {
    let mut gradient = [[0.0; D]; D];
    (gradient[0][D - 1], gradient[D - 1][0]) = (rate, -rate);
    gradient
}

fn shear<const D: usize>(rate: f64) -> Matrix<D> {
    let mut gradient = [[0.0; D]; D];
    gradient[0][D - 1] = rate;
    gradient
}

fn expansion<const D: usize>(rate: f64) -> Matrix<D> {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { rate } else { 0.0 }))
}

/// At the start `-div u v/ε` stands for the rate: with `s = (h/ε)² D H ε` it is `a = s/(c + s)` in
/// a compression of rate H, up to the round-off of gradients.
fn rises_where_the_gas_is_compressed<const D: usize>(per_side: usize) {
    for rate in [0.1, 10.0] {
        let mut smallest = f64::INFINITY;
        for (factor, epsilon) in at_start(per_side, &expansion::<D>(-rate), switched()) {
            let squeezed = REACH_SQUARED * D as f64 * rate * epsilon;
            let expected = squeezed / (SOUND_SPEED + squeezed);
            assert!(
                (factor - expected).abs() < 1e-11,
                "{factor}, not {expected} in {D}D at rate {rate}"
            );
            smallest = smallest.min(factor);
        }
        assert!(rate < 1.0 || smallest > 0.9, "{smallest}");
    }
}

#[test]
fn the_switch_rises_to_near_1_in_a_strong_compression() {
    rises_where_the_gas_is_compressed::<1>(40);
    rises_where_the_gas_is_compressed::<2>(10);
    rises_where_the_gas_is_compressed::<3>(7);
}

#[test]
fn the_switch_stays_at_its_minimum_in_expansion_rotation_shear_and_uniform_flow() {
    fn check<const D: usize>(per_side: usize, gradient: Matrix<D>) {
        for (factor, _) in at_start(per_side, &gradient, switched()) {
            assert_eq!(factor, SWITCH.minimum, "{gradient:?}");
        }
    }
    check(10, rotation::<2>(2.0));
    check(10, shear::<2>(2.0));
    check(10, [[0.0; 2]; 2]);
    check(10, expansion::<2>(0.5));
    check(7, rotation::<3>(2.0));
    check(7, shear::<3>(2.0));
}

/// Over steps, with the rate of div u: a uniform flow, and a shear wave of twice the speed of
/// sound whose particles slide past each other. In place of the divergence its curl would give
/// more than 0.03.
#[test]
fn the_switch_stays_at_its_minimum_over_steps() {
    let k = TAU / COUNTS[0] as f64;
    let mut options = switched();
    options.switch = Some(Switch {
        minimum: 1e-3,
        ..SWITCH
    });
    for (shear, bound) in [(0.0, 1e-15), (1.0, 1e-12)] {
        let mut particles = lattice(COUNTS);
        for particle in &mut particles {
            particle.velocity = [0.8, shear * (k * particle.position[0]).sin()];
        }
        let materials = [Isothermal::new(SOUND_SPEED)];
        let mut setup = setup(particles, periodic(COUNTS), &materials, options);
        setup.advance(20, 0.05);
        let factors = setup.gas().viscosity_factor.to_vec();
        let largest = factors.iter().copied().fold(0.0, f64::max);
        println!("shear of {shear}: factor up to {largest}");
        assert!(largest <= 1e-3 + bound, "{largest}, shear {shear}");
    }
}

/// Two streams of up to eight times the speed of sound: where they meet, the factor rises the
/// higher the faster they are, and elsewhere it does not. The gas is compressed in one of two
/// directions: `ξ = 2/3`.
#[test]
fn the_switch_rises_where_streams_meet() {
    let mut highest = vec![SWITCH.minimum];
    for speed in [0.5, 2.0, 4.0] {
        let mut particles = lattice(COUNTS);
        for particle in &mut particles {
            let upstream = particle.position[0] < 18.0;
            particle.velocity[0] = if upstream { speed } else { -speed };
        }
        let materials = [Isothermal::new(SOUND_SPEED)];
        let mut setup = setup(particles, periodic(COUNTS), &materials, switched());
        setup.advance(3, 0.02);
        let gas = setup.gas();
        let mut here = 1.0f64;
        for (x, &factor) in gas.position.iter().zip(gas.viscosity_factor.iter()) {
            let from_shock = (x[0] - 18.0).abs();
            if from_shock < 1.0 {
                here = here.min(factor);
            } else if (8.0..10.0).contains(&from_shock) {
                assert!(factor <= SWITCH.minimum + 1e-9, "{factor} at {x:?}");
            }
        }
        highest.push(here);
    }
    println!("factors where streams meet: {highest:?}");
    assert!(highest.is_sorted_by(|a, b| a < b), "{highest:?}");
    assert!(highest[3] > 0.8, "{highest:?}");
}

/// From its minimum, the factor follows the rate of div u in a free fall towards a point:
/// `div u = -D H/(1 - H t)`, whose rate is `-D H²/(1 - H t)²`; `a = h² A/(v² + h² A)`.
#[test]
fn the_switch_follows_the_rate_of_compression() {
    const SLOW: f64 = 0.05;
    let (h, dt) = (0.3, 0.01);
    let mut particles = cloud(10, 2).particles::<f64, 2>();
    for particle in &mut particles {
        particle.velocity = particle.position.map(|x| -h * x);
    }
    let materials = [Isothermal::new(SLOW)];
    let of = (Inviscid, &materials[..]);
    let mut setup = Setup::new(particles, Domain::FREE, (CubicSpline, 1.6), of, switched());
    setup.gas().viscosity_factor.fill(0.0);
    let approach = setup.gas().approach.to_vec();
    setup.advance(1, dt);
    let gas = setup.gas();
    let rate = 2.0 * h * h / (1.0 - h * dt);
    for (id, &factor) in gas.viscosity_factor.iter().enumerate() {
        let trigger = REACH_SQUARED * gas.epsilon[id] * gas.epsilon[id] * rate;
        let signal = SLOW + approach[id];
        let expected = trigger / (signal * signal + trigger);
        // Pressure changes div u by up to c²/ε² or so a unit of time, 1 % of the rate.
        let bound = 0.02 * (1.0 - expected);
        assert!(
            (factor - expected).abs() < bound,
            "{factor}, not {expected} at {id}"
        );
        // Most of v is the approach of the farthest partner, up to `2 ε H`: 2/3 with many.
        assert!((0.3..0.7).contains(&expected), "{expected}");
    }
}

/// `a - a_min` falls as `exp(-ℓ c t/ε)` in a gas at rest. An implicit step of part d of the
/// decay time leaves `1/(1+d)`, above the exponential by `d²/2` each.
#[test]
fn the_switch_decays_at_the_stated_rate() {
    decays_at_the_stated_rate(switched());
}

/// Balsara's factor is that of a moment, 0 in a gas at rest: the switch does not remember it.
#[test]
fn balsaras_factor_leaves_the_memory_of_the_switch_alone() {
    decays_at_the_stated_rate(Options {
        balsara: true,
        ..switched()
    });
}

fn decays_at_the_stated_rate(options: Options<f64, 2>) {
    let (steps, dt) = (320, 0.02);
    let materials = [Isothermal::new(SOUND_SPEED)];
    let mut setup = setup(lattice(COUNTS), periodic(COUNTS), &materials, options);
    setup.gas().viscosity_factor.fill(1.0);
    setup.advance(steps, dt);
    let gas = setup.gas();
    for (&factor, &epsilon) in gas.viscosity_factor.iter().zip(gas.epsilon.iter()) {
        let part = SWITCH.decay * SOUND_SPEED / epsilon * dt;
        let exact = f64::exp(-part * steps as f64);
        let left = (factor - SWITCH.minimum) / (1.0 - SWITCH.minimum);
        let excess = (left / exact).ln() / (0.5 * part * part * steps as f64);
        assert!(
            (0.98..1.01).contains(&excess),
            "{left} left, expected {exact}; excess {excess} of d²/2 a step"
        );
        assert!(exact < 0.75, "{exact}");
    }
}

/// `|div u|/(|div u| + |curl u| + c/10⁴ε)`: 0 in shear and rotation, 1 in compression, and
/// between them what the formula says.
#[test]
fn balsaras_factor_is_0_in_shear_and_1_in_compression() {
    fn check<const D: usize>(per_side: usize) {
        let (h, w) = (0.4, 0.7);
        let mut mixed = rotation::<D>(w);
        for (i, row) in mixed.iter_mut().enumerate() {
            row[i] = -h;
        }
        let divergence = D as f64 * h;
        for (gradient, divergence, curl) in [
            (rotation::<D>(w), 0.0, 2.0 * w),
            (shear::<D>(w), 0.0, w),
            (expansion::<D>(h), divergence, 0.0),
            (expansion::<D>(-h), divergence, 0.0),
            (mixed, divergence, 2.0 * w),
        ] {
            for (factor, epsilon) in at_start(per_side, &gradient, with_balsara()) {
                let noise = 1e-4 * SOUND_SPEED / epsilon;
                let expected = divergence / (divergence + curl + noise);
                assert!(
                    (factor - expected).abs() < 1e-11,
                    "{factor}, not {expected} for {gradient:?}"
                );
                assert!(curl > 0.0 || factor > 0.999);
                assert!(divergence > 0.0 || factor < 1e-11);
            }
        }
    }
    check::<2>(10);
    check::<3>(7);
}
