//! Physical viscosity against exact solutions of Navier and Stokes, and against what it must not do.

use std::f64::consts::TAU;

use motes_core::cutoff::{CubicSpline, CutOff, WendlandC2, WendlandC4};
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{Diffusion, Gas, Options, Particle, Width};
use motes_core::material::Isothermal;
use motes_core::pairs::HalfLoop;

use super::{Setup, dot, lattice, periodic};
use crate::clouds::Stream;

pub const SHEAR: Diffusion<f64> = Diffusion {
    viscosity: 0.4,
    ..Diffusion::OFF
};
pub const BULK: Diffusion<f64> = Diffusion {
    bulk_viscosity: 0.5,
    ..Diffusion::OFF
};
pub const BOTH: Diffusion<f64> = Diffusion {
    viscosity: 0.3,
    bulk_viscosity: 0.7,
    heat: 0.0,
};

pub fn viscous<const D: usize>(diffusion: Diffusion<f64>) -> Options<f64, D> {
    Options {
        diffusion,
        ..Options::OFF
    }
}

/// A [`lattice`] whose particles have been thrown about and have pushed each other apart, into a glass
/// of even density.
fn glass<const D: usize>(counts: [usize; D]) -> Vec<Particle<f64, D>> {
    let mut particles = lattice(counts);
    let mut stream = Stream::new(7);
    for particle in &mut particles {
        for x in &mut particle.position {
            *x += 0.4 * stream.next();
        }
    }
    let width = 1.3;
    for particle in &mut particles {
        particle.epsilon = width;
    }
    for _ in 0..60 {
        let before = particles.clone();
        for particle in &mut particles {
            let mut push = [0.0; D];
            for other in &before {
                let mut r = particle.position;
                for i in 0..D {
                    let side = counts[i] as f64;
                    r[i] -= other.position[i];
                    r[i] -= side * (r[i] / side).round();
                }
                let q = dot(&r, &r).sqrt() / width;
                if q > 0.0 && q < 2.0 {
                    let t = 1.0 - 0.5 * q;
                    for i in 0..D {
                        push[i] += r[i] * t * t * t;
                    }
                }
            }
            for i in 0..D {
                particle.position[i] += 0.1 * push[i].clamp(-1.0, 1.0);
            }
        }
        for particle in &mut particles {
            for (x, &count) in particle.position.iter_mut().zip(&counts) {
                *x = x.rem_euclid(count as f64);
            }
        }
    }
    particles
}

/// Of the waves, in sound speeds.
const AMPLITUDE: f64 = 1e-3;

/// A wave of velocity, `direction sin(k x)`.
#[derive(Clone, Copy, Debug)]
struct Wave<const D: usize> {
    k: [f64; D],
    direction: [f64; D],
}

impl<const D: usize> Wave<D> {
    /// With `waves` wave lengths in each side of a box.
    fn new(counts: [usize; D], waves: [usize; D], direction: [f64; D]) -> Self {
        let length = dot(&direction, &direction).sqrt();
        Self {
            k: std::array::from_fn(|i| TAU * waves[i] as f64 / counts[i] as f64),
            direction: direction.map(|x| x / length),
        }
    }

    fn set(&self, particles: &mut [Particle<f64, D>]) {
        for particle in particles {
            let sine = dot(&self.k, &particle.position).sin();
            particle.velocity = self.direction.map(|x| AMPLITUDE * x * sine);
        }
    }

    fn amplitude(&self, gas: &Gas<'_, f64, D>) -> f64 {
        let mut sums = [0.0; 2];
        for (x, u) in gas.position.iter().zip(gas.velocity.iter()) {
            let sine = dot(&self.k, x).sin();
            sums[0] += dot(u, &self.direction) * sine;
            sums[1] += sine * sine;
        }
        sums[0] / sums[1]
    }

    fn k_squared(&self) -> f64 {
        dot(&self.k, &self.k)
    }
}

/// What a wave runs in.
type Case<C, const D: usize> = (Vec<Particle<f64, D>>, Domain<f64, D>, (C, f64));

/// The rate at which a shear wave decays over half a decay time, over `ν k²`.
fn shear_rate<C: CutOff, const D: usize>(of: Case<C, D>, wave: Wave<D>) -> f64 {
    let (mut particles, domain, cut_off) = of;
    wave.set(&mut particles);
    // With little pressure: a lattice resists shear by some of it.
    let materials = [Isothermal::new(0.005)];
    let gas = (Inviscid, &materials[..]);
    let mut setup = Setup::new(particles, domain, cut_off, gas, viscous(SHEAR));
    let exact = SHEAR.viscosity * wave.k_squared();
    let end = 0.5 / exact;
    let longest = setup
        .solver
        .time_step(&setup.arrays.parts().0, 1.0)
        .unwrap();
    let steps = (end / longest).ceil();
    let before = wave.amplitude(&setup.gas());
    setup.advance(steps as usize, end / steps);
    (before / wave.amplitude(&setup.gas())).ln() / (end * exact)
}

/// How particles are placed.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Cloud {
    Lattice,
    Glass,
}

/// The rate at which standing sound of speed 1 decays, over `(4/3 ν + ν_b) k²/2`: from an extreme of its
/// velocity to that a period later. What a glass does by itself is taken off.
fn sound_rate<C: CutOff, const D: usize>(
    (particles, domain, cut_off): Case<C, D>,
    wave: Wave<D>,
    diffusion: Diffusion<f64>,
    cloud: Cloud,
) -> f64 {
    let materials = [Isothermal::new(1.0)];
    let start = |is_moving: bool| {
        let mut particles = particles.clone();
        if is_moving {
            wave.set(&mut particles);
        }
        let gas = (Inviscid, &materials[..]);
        Setup::new(particles, domain, cut_off, gas, viscous(diffusion))
    };
    let mut moving = start(true);
    let mut still = match cloud {
        Cloud::Lattice => None,
        Cloud::Glass => Some(start(false)),
    };
    let dt = moving
        .solver
        .time_step(&moving.arrays.parts().0, 1.0)
        .unwrap();
    let mut seen = Vec::new();
    let mut extremes = Vec::new();
    while extremes.len() < 3 {
        let by_itself = still.as_mut().map_or(0.0, |still| {
            still.advance(1, dt);
            wave.amplitude(&still.gas())
        });
        moving.advance(1, dt);
        seen.push(wave.amplitude(&moving.gas()) - by_itself);
        let [.., a, b, c] = seen[..] else { continue };
        if (b - a) * (c - b) < 0.0 {
            // The vertex of the parabola through the three.
            let (slope, bend) = (0.5 * (c - a), c - 2.0 * b + a);
            let off = -slope / bend;
            let time = (seen.len() as f64 - 2.0 + off) * dt;
            extremes.push((time, (b + 0.5 * slope * off).abs()));
        }
    }
    let (start, end) = (extremes[0], extremes[2]);
    let exact = (4.0 / 3.0 * diffusion.viscosity + diffusion.bulk_viscosity) * wave.k_squared();
    (start.1 / end.1).ln() / ((end.0 - start.0) * 0.5 * exact)
}

/// Sums over a lattice have no error but that of the width over the wave length.
const ON_LATTICES: f64 = 0.01;
const ON_GLASSES: f64 = 0.03;

#[track_caller]
fn is_right(what: &str, rate: f64, bound: f64) {
    println!("{what}: {rate:.4} of the exact rate, bound {bound}");
    assert!((rate - 1.0).abs() < bound, "{what}: {rate}");
}

fn on_lattice<C: CutOff, const D: usize>(counts: [usize; D], of: (C, f64)) -> Case<C, D> {
    let mut particles = lattice(counts);
    for particle in &mut particles {
        particle.epsilon = of.1;
    }
    (particles, periodic(counts), of)
}

/// The same between walls across the last direction, which need less room.
fn between_walls<C: CutOff, const D: usize>(counts: [usize; D], of: (C, f64)) -> Case<C, D> {
    let (particles, mut domain, of) = on_lattice(counts, of);
    domain.axes[D - 1] = Axis::walls(0.0, counts[D - 1] as f64);
    (particles, domain, of)
}

/// Along the axes of a lattice, and at 45 degrees.
fn shear_in_a_plane<C: CutOff>(name: &str, of: (C, f64)) {
    let (plane, square) = ([32, 12], [44, 44]);
    let along = Wave::new(plane, [1, 0], [0.0, 1.0]);
    let across = Wave::new(square, [1, 1], [1.0, -1.0]);
    is_right(name, shear_rate(on_lattice(plane, of), along), ON_LATTICES);
    let turned = shear_rate(on_lattice(square, of), across);
    is_right(&format!("{name}, 45°"), turned, ON_LATTICES);
}

#[test]
fn shear_waves_on_lattices_decay_by_the_shear_viscosity() {
    shear_in_a_plane("C2 1.3", (WendlandC2, 1.3));
    shear_in_a_plane("M4 1.2", (CubicSpline, 1.2));
    shear_in_a_plane("C4 1.6", (WendlandC4, 1.6));
    let space = [28, 8, 4];
    let along = Wave::new(space, [1, 0, 0], [0.0, 1.0, 0.0]);
    let of = (CubicSpline, 1.2);
    is_right(
        "3D, M4 1.2",
        shear_rate(between_walls(space, of), along),
        ON_LATTICES,
    );
}

#[test]
fn sound_on_lattices_is_damped_by_both_viscosities() {
    for (name, diffusion) in [("shear", SHEAR), ("bulk", BULK), ("both", BOTH)] {
        let line = [64];
        let wave = Wave::new(line, [1], [1.0]);
        let rate = sound_rate(
            on_lattice(line, (CubicSpline, 1.0)),
            wave,
            diffusion,
            Cloud::Lattice,
        );
        is_right(&format!("1D, {name}"), rate, ON_LATTICES);
        let plane = [64, 12];
        let wave = Wave::new(plane, [1, 0], [1.0, 0.0]);
        let rate = sound_rate(
            on_lattice(plane, (WendlandC2, 1.3)),
            wave,
            diffusion,
            Cloud::Lattice,
        );
        is_right(&format!("2D, {name}"), rate, ON_LATTICES);
    }
    let space = [40, 8, 4];
    let wave = Wave::new(space, [1, 0, 0], [1.0, 0.0, 0.0]);
    let rate = sound_rate(
        between_walls(space, (CubicSpline, 1.2)),
        wave,
        BOTH,
        Cloud::Lattice,
    );
    is_right("3D, both", rate, ON_LATTICES);
}

/// Sound needs a wider cut-off: pressure scatters it where the cloud is disordered, which at 1.3 spacings
/// damps it by more than viscosity does, and at 1.6 by as much as a viscosity of 0.02.
#[test]
fn waves_in_glasses_decay_by_both_viscosities() {
    let plane = [40, 16];
    let glass_of = |eta| (glass(plane), periodic(plane), (WendlandC2, eta));
    let shear = Wave::new(plane, [1, 0], [0.0, 1.0]);
    is_right("2D, shear", shear_rate(glass_of(1.3), shear), ON_GLASSES);
    let sound = Wave::new(plane, [1, 0], [1.0, 0.0]);
    for (name, diffusion) in [("shear", SHEAR), ("both", BOTH)] {
        let rate = sound_rate(glass_of(1.6), sound, diffusion, Cloud::Glass);
        is_right(&format!("2D, sound, {name}"), rate, ON_GLASSES);
    }
    let space = [20, 9, 9];
    let shear = Wave::new(space, [1, 0, 0], [0.0, 0.6, 0.8]);
    let of = (glass(space), periodic(space), (CubicSpline, 1.2));
    is_right("3D, shear", shear_rate(of, shear), ON_GLASSES);
}

/// The heat of a moment over that of the stress, of sound along the first direction.
#[test]
fn sound_in_glasses_makes_the_heat_of_both_viscosities() {
    fn check<const D: usize>(counts: [usize; D], eta: f64) {
        let mut particles = glass(counts);
        let mut waves = [0; D];
        waves[0] = 1;
        let wave = Wave::new(
            counts,
            waves,
            std::array::from_fn(|i| f64::from(u8::from(i == 0))),
        );
        wave.set(&mut particles);
        let materials = [Isothermal::new(1.0)];
        for (name, diffusion) in [("shear", SHEAR), ("bulk", BULK)] {
            let gas = (Inviscid, &materials[..]);
            let of = (CubicSpline, eta);
            let mut setup = Setup::new(
                particles.clone(),
                periodic(counts),
                of,
                gas,
                viscous(diffusion),
            );
            let heat: f64 = setup.gas().heat.iter().sum();
            let viscosity = 4.0 / 3.0 * diffusion.viscosity + diffusion.bulk_viscosity;
            let exact = viscosity * wave.k_squared() * AMPLITUDE * AMPLITUDE / 2.0;
            let rate = heat / (particles.len() as f64 * exact);
            is_right(&format!("{D}D, heat, {name}"), rate, ON_GLASSES);
        }
    }
    check([64], 1.2);
    check([64, 16], 1.3);
    check([40, 9, 9], 1.2);
}

/// On a lattice of squares, with widths that follow the density and with one that does not: the heat that
/// a wave of the internal energy passes on, over `χ k²`.
#[test]
fn heat_on_lattices_is_conducted_by_the_diffusivity() {
    let (plane, chi) = ([40, 12], 0.4);
    let options = viscous(Diffusion {
        heat: chi,
        ..Diffusion::OFF
    });
    let materials = [Isothermal::new(1.0)];
    let gas = (Inviscid, &materials[..]);
    let k = TAU / 40.0;
    let (mut particles, domain, of) = on_lattice(plane, (WendlandC2, 1.3));
    for particle in &mut particles {
        particle.energy += AMPLITUDE * (k * particle.position[0]).sin();
    }
    let mut setup = Setup::new(particles, domain, of, gas, options);
    for width in [
        Width::adaptive(1.3),
        Width::Constant { epsilon: 1.3 },
        Width::Constant { epsilon: 1.2 },
    ] {
        setup.solver.width = width;
        let (mut gas, mut work) = setup.arrays.parts();
        setup
            .solver
            .prepare(&mut HalfLoop, &mut gas, &mut work)
            .unwrap();
        let terms = gas.heat.iter().zip(gas.position.iter());
        let passed: f64 = terms.map(|(heat, x)| -heat * (k * x[0]).sin()).sum();
        let rate = 2.0 * passed / (gas.len() as f64 * AMPLITUDE * chi * k * k);
        is_right(&format!("{width:?}"), rate, ON_LATTICES);
    }
}
