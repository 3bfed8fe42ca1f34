//! The coefficients of a system as formulas: what a manufactured solution is put into.

use motes_formula::Formula;

use super::{Field, System};
use crate::Domain;

/// `A^i` and `A⁰` of `∂u/∂t + Σ_i ∂_i(A^i u) + A⁰ u = f`.
pub(super) struct Coefficients {
    /// A direction: the matrix, row by row.
    pub flux: Vec<Vec<Formula>>,
    /// Row by row.
    pub decay: Vec<Formula>,
    components: usize,
}

impl Coefficients {
    fn zero(dimension: usize, components: usize) -> Self {
        let matrix = vec![Formula::constant(0.0); components * components];
        Self {
            flux: vec![matrix.clone(); dimension],
            decay: matrix,
            components,
        }
    }

    /// An entry of `A^i`, i = `axis` from 0.
    fn flux(mut self, axis: usize, [row, column]: [usize; 2], value: f64) -> Self {
        self.flux[axis][row * self.components + column] = Formula::constant(value);
        self
    }

    /// An entry of `A⁰`.
    fn decay(mut self, [row, column]: [usize; 2], value: f64) -> Self {
        self.decay[row * self.components + column] = Formula::constant(value);
        self
    }

    /// What a pressure does to the velocities behind it, and they to it, in every direction.
    fn sound(self, pressure: usize, velocity: usize, [spreads, pushes]: [f64; 2]) -> Self {
        let dimension = self.flux.len();
        (0..dimension).fold(self, |system, axis| {
            system
                .flux(axis, [pressure, velocity + axis], spreads)
                .flux(axis, [velocity + axis, pressure], pushes)
        })
    }

    /// `f` of a state that solves the equation: what its left side is.
    pub fn source(&self, state: &[Formula]) -> Vec<Formula> {
        let p = self.components;
        let time = 3;
        let row = |matrix: &[Formula], i: usize| {
            let products = (0..p).map(|j| &matrix[i * p + j] * &state[j]);
            products.fold(Formula::constant(0.0), |sum, product| &sum + &product)
        };
        let of = |i: usize| {
            let begun = &state[i].derivative(time) + &row(&self.decay, i);
            let axes = self.flux.iter().enumerate();
            axes.fold(begun, |sum, (axis, matrix)| {
                &sum + &row(matrix, i).derivative(axis)
            })
        };
        (0..p).map(of).collect()
    }
}

impl System {
    /// Its coefficients; `None` for [`System::ConvectionDiffusion`], which is of second order.
    pub(super) fn coefficients(&self, domain: &Domain) -> Option<Coefficients> {
        let dimension = domain.sides.len();
        let zero = Coefficients::zero(dimension, self.components(dimension));
        Some(match self {
            Self::Transport {
                velocity, decay, ..
            } => Coefficients {
                flux: velocity
                    .formulas(domain)
                    .into_iter()
                    .map(|a| vec![a])
                    .collect(),
                ..zero.decay([0, 0], *decay)
            },
            Self::Acoustics {
                density,
                sound_speed,
            } => zero.sound(0, 1, [density * sound_speed * sound_speed, 1.0 / density]),
            Self::Telegraph {
                inductance,
                capacitance,
                resistance,
                conductance,
            } => zero
                .flux(0, [0, 1], 1.0 / capacitance)
                .flux(0, [1, 0], 1.0 / inductance)
                .decay([0, 0], conductance / capacitance)
                .decay([1, 1], resistance / inductance),
            Self::ShallowWater {
                gravity,
                depth,
                coriolis,
            } => zero
                .sound(0, 1, [*depth, *gravity])
                .decay([1, 2], -coriolis)
                .decay([2, 1], *coriolis),
            Self::MaxwellTe {
                permittivity,
                permeability,
            } => zero
                .flux(0, [1, 2], 1.0 / permittivity)
                .flux(0, [2, 1], 1.0 / permeability)
                .flux(1, [0, 2], -1.0 / permittivity)
                .flux(1, [2, 0], -1.0 / permeability),
            Self::ElasticWaves {
                density,
                lambda,
                mu,
            } => {
                let (light, stiff) = (-1.0 / density, -(lambda + 2.0 * mu));
                zero.flux(0, [0, 2], light)
                    .flux(0, [1, 4], light)
                    .flux(0, [2, 0], stiff)
                    .flux(0, [3, 0], -lambda)
                    .flux(0, [4, 1], -mu)
                    .flux(1, [0, 4], light)
                    .flux(1, [1, 3], light)
                    .flux(1, [2, 1], -lambda)
                    .flux(1, [3, 1], stiff)
                    .flux(1, [4, 0], -mu)
            }
            Self::LinearisedGas {
                density,
                pressure,
                gamma,
                velocity,
            } => {
                let last = dimension + 1;
                let axes = velocity.iter().enumerate();
                let carried = axes.fold(zero, |system, (axis, u)| {
                    (0..=last).fold(system, |system, i| system.flux(axis, [i, i], *u))
                });
                let sounding = carried.sound(last, 1, [gamma * pressure, 1.0 / density]);
                (0..dimension).fold(sounding, |system, axis| {
                    system.flux(axis, [0, 1 + axis], *density)
                })
            }
            Self::Matrices { flux, decay, .. } => {
                let constants =
                    |matrix: &Vec<f64>| matrix.iter().copied().map(Formula::constant).collect();
                Coefficients {
                    flux: flux.iter().map(constants).collect(),
                    decay: constants(decay),
                    ..zero
                }
            }
            Self::VariableMatrices { flux, decay, .. } => Coefficients {
                flux: flux.clone(),
                decay: decay.clone(),
                ..zero
            },
            Self::ConvectionDiffusion(_) => return None,
        })
    }
}

impl Field {
    /// Its components as formulas.
    pub(super) fn formulas(&self, domain: &Domain) -> Vec<Formula> {
        let dimension = domain.sides.len();
        let constant = Formula::constant;
        let arm = |i: usize, center: &[f64]| &Formula::variable(i) - &constant(center[i]);
        let mut field = vec![constant(0.0); dimension];
        match self {
            Self::Still => {}
            Self::Uniform { velocity } => field = velocity.iter().copied().map(constant).collect(),
            Self::Rotation { rate, center } => {
                field[0] = &constant(-rate) * &arm(1, center);
                field[1] = &constant(*rate) * &arm(0, center);
            }
            Self::Shear { rate, center } => field[0] = &constant(*rate) * &arm(1, center),
            Self::Compression { rate, center } => {
                let along = |i: usize| &constant(-rate) * &arm(i, center);
                field = (0..dimension).map(along).collect();
            }
            Self::Wave { amplitude } => {
                let extent = &domain.extent;
                let number = std::f64::consts::TAU / (extent.upper[0] - extent.lower[0]);
                let angle = &constant(number) * &arm(0, &extent.lower);
                field[0] = &constant(*amplitude) * &angle.sine();
            }
            Self::Formula(of) => field.clone_from(&of.velocity),
        }
        field
    }
}
