//! What the solver needs of a run, in solver units, every number still an `f64`.

use motes_core::cutoff::Named;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::viscosity::{
    Coefficients, GingoldMonaghan, Named as NamedViscosity, Pairwise, VonNeumann,
};
use motes_core::equation::gas::{
    Diffusion, GasDynamics, NoSlip, Options, Particle, Plain, Stretch, Switch, Tube, Width,
};
use motes_core::material::{IdealGas, Isothermal, Named as NamedMaterial, StiffenedGas, Tait};
use motes_core::pairs::Fields;
use motes_core::scalar::Scalar;

use super::memory::GasArrays;
use super::opening::OpenSides;
use crate::run::Abscissa;
use crate::scenario::{EquationOfState, Viscosity, ViscosityKind};
use crate::units::SolverUnits;

/// A gas run in solver units. Vectors have three components; those beyond the dimension mean
/// nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// What the solver units are.
    pub units: SolverUnits,
    /// The middle of the domain, in the scenario's units: 0 for the solver.
    pub middle: [f64; 3],
    /// The domain.
    pub axes: [Axis<f64>; 3],
    /// What is beyond inflow and outflow sides, where there are any.
    pub opening: Option<OpenSides>,
    /// The gas at the start, without what is beyond inflow and outflow sides.
    pub particles: Vec<Particle<f64, 3>>,
    /// The stretches that the particles fill, where the run is one that a device can be given:
    /// one ideal gas in one dimension.
    pub stretches: Option<Vec<Stretch>>,
    /// The materials, by number.
    pub materials: Vec<EquationOfState>,
    /// The cut-off.
    pub cut_off: Named,
    /// Its width.
    pub width: Width<f64>,
    /// Pseudo-viscosity.
    pub viscosity: Viscosity,
    /// What goes beyond the paper's equations.
    pub options: Options<f64, 3>,
    /// Duration.
    pub end: f64,
    /// Factor of the time step.
    pub courant: f64,
    /// What it is drawn over.
    pub abscissa: Abscissa,
    /// Why the results may not mean what they say.
    pub doubts: Vec<String>,
}

/// The smallest Ω that a run accepts. Next to a jump of density it falls to about 0.4; at 0
/// the density would not answer to ε at all.
pub const SMALLEST_OMEGA: f64 = 1.0 / 32.0;

impl Plan {
    /// The solver, in the scalar of the run.
    pub fn solver<'m, S: Scalar, C, V, P, const D: usize>(
        &self,
        cut_off: C,
        viscosity: V,
        physics: P,
        materials: &'m [NamedMaterial<S>],
    ) -> GasDynamics<'m, S, C, V, NamedMaterial<S>, P, D> {
        GasDynamics {
            domain: self.domain(),
            cut_off,
            width: match self.width {
                Width::Constant { epsilon } => Width::Constant {
                    epsilon: S::from_f64(epsilon),
                },
                Width::Adaptive { eta, packing } => Width::Adaptive {
                    eta: S::from_f64(eta),
                    packing,
                },
            },
            viscosity,
            materials,
            physics,
            courant: S::from_f64(self.courant),
            smallest_omega: S::from_f64(SMALLEST_OMEGA),
        }
    }

    /// The domain, in the scalar and dimension of the run.
    pub fn domain<S: Scalar, const D: usize>(&self) -> Domain<S, D> {
        Domain {
            axes: std::array::from_fn(|i| Axis {
                lower: S::from_f64(self.axes[i].lower),
                upper: S::from_f64(self.axes[i].upper),
                sides: self.axes[i].sides,
            }),
        }
    }

    /// The options, in the scalar of the run.
    pub fn options<S: Scalar, const D: usize>(&self) -> Options<S, D> {
        let options = &self.options;
        Options {
            plain: Plain {
                weights: options.plain.weights,
                acceleration: std::array::from_fn(|i| S::from_f64(options.plain.acceleration[i])),
                far: self
                    .opening
                    .as_ref()
                    .map_or([None; 2], OpenSides::rounded_far),
            },
            energy: options.energy,
            limited: options.limited,
            linear_exact: options.linear_exact,
            switch: options.switch.map(|switch| Switch {
                minimum: S::from_f64(switch.minimum),
                decay: S::from_f64(switch.decay),
            }),
            balsara: options.balsara,
            conduction: S::from_f64(options.conduction),
            diffusion: Diffusion {
                viscosity: S::from_f64(options.diffusion.viscosity),
                bulk_viscosity: S::from_f64(options.diffusion.bulk_viscosity),
                heat: S::from_f64(options.diffusion.heat),
            },
            background: S::from_f64(options.background),
            walls: self.no_slip(),
        }
    }

    /// The walls that the gas sticks to, in the scalar and dimension of the run.
    fn no_slip<S: Scalar, const D: usize>(&self) -> NoSlip<S, D> {
        let walls = &self.options.walls.velocity;
        let component = |velocity: [f64; 3]| std::array::from_fn(|i| S::from_f64(velocity[i]));
        NoSlip {
            velocity: std::array::from_fn(|axis| walls[axis].map(|wall| wall.map(component))),
        }
    }

    /// The materials, in the scalar of the run.
    pub fn materials<S: Scalar>(&self) -> Vec<NamedMaterial<S>> {
        let material = |law: &EquationOfState| match *law {
            EquationOfState::IdealGas { gamma } => NamedMaterial::IdealGas(IdealGas::new(gamma)),
            EquationOfState::StiffenedGas {
                gamma,
                pressure_at_infinity,
            } => NamedMaterial::StiffenedGas(StiffenedGas::new(gamma, pressure_at_infinity)),
            EquationOfState::Isothermal { sound_speed } => {
                NamedMaterial::Isothermal(Isothermal::new(sound_speed))
            }
            EquationOfState::Tait {
                density,
                sound_speed,
                exponent,
            } => NamedMaterial::Tait(Tait::new(density, sound_speed, exponent)),
        };
        self.materials.iter().map(material).collect()
    }

    /// The viscosity, in the scalar of the run.
    pub fn viscosity<S: Scalar>(&self) -> NamedViscosity<S> {
        let coefficients = Coefficients {
            alpha: S::from_f64(self.viscosity.alpha),
            beta: S::from_f64(self.viscosity.beta),
        };
        match self.viscosity.kind {
            ViscosityKind::Pairwise | ViscosityKind::Limited => {
                NamedViscosity::Pairwise(Pairwise(coefficients))
            }
            ViscosityKind::GingoldMonaghan => {
                NamedViscosity::GingoldMonaghan(GingoldMonaghan(coefficients))
            }
            ViscosityKind::VonNeumann => NamedViscosity::VonNeumann(VonNeumann(coefficients)),
            ViscosityKind::None => NamedViscosity::Inviscid,
        }
    }

    /// The particles, in the scalar and dimension of the run; the plan has none then.
    pub fn take_particles<S: Scalar, const D: usize>(
        &mut self,
    ) -> impl Iterator<Item = Particle<S, D>> + use<S, D> {
        let flat = |vector: &[f64; 3]| std::array::from_fn(|i| vector[i]);
        std::mem::take(&mut self.particles)
            .into_iter()
            .map(move |particle| {
                let particle = Particle::<f64, D> {
                    position: flat(&particle.position),
                    velocity: flat(&particle.velocity),
                    mass: particle.mass,
                    energy: particle.energy,
                    epsilon: particle.epsilon,
                    material: particle.material,
                };
                particle.rounded()
            })
    }

    /// The densities that the widths at the start stand for.
    pub(super) fn expected_densities<S: Scalar, X: Fields<S>, const D: usize>(
        &self,
        memory: &GasArrays<S, X, D>,
    ) -> Vec<S> {
        let eta = match self.width {
            Width::Adaptive { eta, .. } => eta,
            Width::Constant { .. } => 1.0,
        };
        let particles = memory.mass.iter().zip(&memory.epsilon);
        particles
            .map(|(mass, epsilon)| {
                let spacing = epsilon.to_f64() / eta;
                S::from_f64(mass.to_f64() / Scalar::powi(spacing, D))
            })
            .collect()
    }

    /// The tube that a device can be given, where the run is one.
    pub fn tube(&self) -> Option<Tube<'_>> {
        let stretches = self.stretches.as_deref()?;
        let [EquationOfState::IdealGas { gamma }] = self.materials[..] else {
            return None;
        };
        let is_plain = self.options == Options::OFF && self.opening.is_none();
        is_plain.then_some(Tube {
            half_length: self.axes[0].upper,
            sides: self.axes[0].sides,
            stretches,
            gamma,
            width: self.width,
            courant: self.courant,
            end: self.end,
        })
    }
}
