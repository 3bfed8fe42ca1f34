//! Disordered clouds for tests: unequal masses, every kind of side, any scalar.
#![allow(dead_code, reason = "every test uses its part of this module")]

use motes_core::cutoff::CutOff;
use motes_core::domain::{Axis, Domain, Side};
use motes_core::equation::gas::{GasDynamics, Options, Particle, Physics, Plain, Viscosity, Width};
use motes_core::material::IdealGas;
use motes_core::pairs::Fields;
use motes_core::scalar::Scalar;
use motes_solver::families::gas::{GasArrays, PlainArrays};

/// A gas solver of the tests, with the law `P`.
pub type Following<S, C, V, P, const D: usize> = GasDynamics<'static, S, C, V, IdealGas<S>, P, D>;

/// The same with the paper's equations.
pub type Solver<S, C, V, const D: usize> = Following<S, C, V, Plain<S, D>, D>;

/// The materials of the tests, 0 and 1; few enough to live as long as the test.
pub fn materials<S: Scalar>() -> &'static [IdealGas<S>] {
    Box::leak(Box::new([IdealGas::new(1.4), IdealGas::new(1.6)]))
}

/// A reproducible stream of numbers in [-1, 1).
pub struct Stream(u64);

impl Stream {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// A cloud of `per_side^D` particles of spacing 1 in the box [0, per_side]^D.
#[derive(Clone, Copy, Debug)]
pub struct Cloud {
    pub per_side: usize,
    pub seed: u64,
    /// Displacement from the lattice, in spacings.
    pub disorder: f64,
    /// Velocity, in sound speeds.
    pub speed: f64,
    /// Relative spread of the masses.
    pub masses: f64,
    pub eta: f64,
}

impl Cloud {
    pub fn particles<S: Scalar, const D: usize>(&self) -> Vec<Particle<S, D>> {
        let mut stream = Stream::new(self.seed);
        let side = self.per_side as f64;
        let mut place = |i: usize| {
            let mut rest = i;
            let mut position = [S::ZERO; D];
            for x in position.iter_mut().rev() {
                let lattice = (rest % self.per_side) as f64 + 0.5;
                rest /= self.per_side;
                let moved = lattice + self.disorder * stream.next();
                *x = S::from_f64(moved.clamp(0.001, side - 0.001));
            }
            Particle {
                position,
                velocity: std::array::from_fn(|_| S::from_f64(self.speed * stream.next())),
                mass: S::from_f64(1.0 + self.masses * stream.next()),
                energy: S::from_f64(1.8 + 0.5 * stream.next()),
                epsilon: S::from_f64(self.eta),
                material: 0,
            }
        };
        (0..self.per_side.pow(D as u32)).map(&mut place).collect()
    }

    pub fn arrays<S: Scalar, const D: usize>(&self) -> PlainArrays<S, D> {
        GasArrays::new(self.particles(), &Options::OFF)
    }

    /// The same with memory for these options, and the upper half of material 1.
    pub fn arrays_of_two<S: Scalar, X: Fields<S>, const D: usize>(
        &self,
        options: &Options<S, D>,
    ) -> GasArrays<S, X, D> {
        let half = S::from_f64(0.5 * self.per_side as f64);
        let mut particles = self.particles::<S, D>();
        for particle in &mut particles {
            particle.material = u8::from(particle.position[0] > half);
        }
        GasArrays::new(particles, options)
    }

    /// The box `[0, per_side]^D` with these sides.
    pub fn domain<S: Scalar, const D: usize>(&self, sides: [[Side; 2]; D]) -> Domain<S, D> {
        let upper = S::from_f64(self.per_side as f64);
        Domain {
            axes: sides.map(|sides| Axis {
                lower: S::ZERO,
                upper,
                sides,
            }),
        }
    }

    pub fn solver<S: Scalar, C: CutOff, V: Viscosity<S>, const D: usize>(
        &self,
        sides: [[Side; 2]; D],
        cut_off: C,
        width: Width<S>,
        viscosity: V,
    ) -> Solver<S, C, V, D> {
        self.following(Plain::DEFAULT, sides, cut_off, width, viscosity)
    }

    /// The solver with the law `physics`.
    pub fn following<S, C, V, P, const D: usize>(
        &self,
        physics: P,
        sides: [[Side; 2]; D],
        cut_off: C,
        width: Width<S>,
        viscosity: V,
    ) -> Following<S, C, V, P, D>
    where
        S: Scalar,
        C: CutOff,
        V: Viscosity<S>,
        P: Physics<S, D>,
    {
        GasDynamics {
            domain: self.domain(sides),
            cut_off,
            width,
            viscosity,
            materials: materials(),
            physics,
            courant: S::from_f64(0.3),
            smallest_omega: S::from_f64(1.0 / 32.0),
        }
    }
}

/// All kinds of sides, by number: free, periodic, walls, and a wall on one side only.
pub fn sides<const D: usize>(number: usize) -> [[Side; 2]; D] {
    let kinds = [
        [Side::Free; 2],
        [Side::Periodic; 2],
        [Side::Mirror; 2],
        [Side::Mirror, Side::Free],
        [Side::Free, Side::Mirror],
    ];
    let mut rest = number;
    std::array::from_fn(|_| {
        let kind = kinds[rest % kinds.len()];
        rest /= kinds.len();
        kind
    })
}

/// Equal particles in the middles of cells of side 1 that fill a box from 0 to `counts`, at
/// rest.
pub fn lattice<const D: usize>(counts: [usize; D]) -> Vec<Particle<f64, D>> {
    let place = |i: usize| {
        let mut rest = i;
        let mut position = [0.0; D];
        for (x, count) in position.iter_mut().zip(counts).rev() {
            *x = (rest % count) as f64 + 0.5;
            rest /= count;
        }
        Particle {
            position,
            velocity: [0.0; D],
            mass: 1.0,
            energy: 1.8,
            epsilon: 1.6,
            material: 0,
        }
    };
    (0..counts.iter().product()).map(place).collect()
}
