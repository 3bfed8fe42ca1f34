//! What [`Options`] add to the paper's equations, against exact solutions and identities.

#[path = "../clouds/mod.rs"]
mod clouds;

mod conduction;
mod diffusion;
mod direction;
mod gradients;
mod interfaces;
mod limiter;
mod navier_stokes;
mod stress;
mod switches;
mod walls;

use clouds::{Cloud, lattice};
use motes_core::cutoff::CutOff;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::exchange::Extras;
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{
    Diffusion, EnergyForm, Gas, GasDynamics, Options, Particle, Switch, Viscosity, Width, Workspace,
};
use motes_core::material::EquationOfState;
use motes_core::pairs::HalfLoop;
use motes_solver::families::gas::OptionsArrays;

/// A vector field or a velocity gradient, `∂u_i/∂x_j`.
type Matrix<const D: usize> = [[f64; D]; D];

/// A disordered cloud in which every particle has partners on all sides of it that determine
/// a gradient.
fn cloud(per_side: usize, seed: u64) -> Cloud {
    Cloud {
        per_side,
        seed,
        disorder: 0.3,
        speed: 0.5,
        masses: 0.4,
        eta: 1.6,
    }
}

fn pairwise() -> Pairwise<f64> {
    Pairwise(Coefficients {
        alpha: 1.0,
        beta: 2.0,
    })
}

/// All options, but for external forces.
fn everything<const D: usize>(energy: EnergyForm) -> Options<f64, D> {
    Options {
        energy,
        limited: true,
        switch: Some(Switch {
            minimum: 0.05,
            decay: 0.2,
        }),
        balsara: true,
        conduction: 0.75,
        diffusion: Diffusion {
            viscosity: 0.1,
            bulk_viscosity: 0.05,
            heat: 0.15,
        },
        ..Options::OFF
    }
}

fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `a x`.
fn times<const D: usize>(a: &Matrix<D>, x: &[f64; D]) -> [f64; D] {
    a.map(|row| dot(&row, x))
}

/// The periodic box of a [`lattice`].
fn periodic<const D: usize>(counts: [usize; D]) -> Domain<f64, D> {
    Domain {
        axes: counts.map(|count| Axis::periodic(0.0, count as f64)),
    }
}

/// A gas and how it is solved.
struct Setup<'a, C, V, E, const D: usize> {
    solver: GasDynamics<'a, f64, C, V, E, Options<f64, D>, D>,
    arrays: OptionsArrays<f64, D>,
}

impl<'a, C: CutOff, V: Viscosity<f64>, E: EquationOfState<f64>, const D: usize>
    Setup<'a, C, V, E, D>
{
    /// Prepared.
    fn new(
        particles: Vec<Particle<f64, D>>,
        domain: Domain<f64, D>,
        (cut_off, eta): (C, f64),
        (viscosity, materials): (V, &'a [E]),
        options: Options<f64, D>,
    ) -> Self {
        // Memory for the widest of options: a law that needs less ignores the rest.
        let mut setup = Self {
            arrays: OptionsArrays::new(particles, &everything(EnergyForm::Exact)),
            solver: GasDynamics {
                domain,
                cut_off,
                width: Width::adaptive(eta),
                viscosity,
                materials,
                physics: options,
                courant: 0.3,
                smallest_omega: 1.0 / 32.0,
            },
        };
        let (mut gas, mut work) = setup.arrays.parts();
        let prepared = setup.solver.prepare(&mut HalfLoop, &mut gas, &mut work);
        assert_eq!(prepared, Ok(()));
        setup
    }

    /// Steps of that length.
    fn advance(&mut self, steps: usize, dt: f64) {
        let (mut gas, mut work): (Gas<'_, f64, D>, Workspace<'_, f64, Extras<f64, D>, D>) =
            self.arrays.parts();
        for step in 0..steps {
            let advanced = self.solver.advance(&mut HalfLoop, &mut gas, &mut work, dt);
            assert_eq!(advanced, Ok(()), "step {step}");
        }
    }

    fn gas(&mut self) -> Gas<'_, f64, D> {
        self.arrays.parts().0
    }
}
