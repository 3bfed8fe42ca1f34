//! The equation, and the exponentials known in closed form.

use super::super::super::linear::residual::Probe;
use super::super::residual::{Equation, assert_holds, product, scaled};
use super::*;
use std::f64::consts::PI;

const TENSOR: [[f64; 3]; 3] = [[1.0, 0.3, -0.2], [0.3, 0.5, 0.1], [-0.2, 0.1, 0.7]];

fn some() -> ModeProblem {
    ModeProblem {
        wave_vector: [1.3, -0.7, 0.4],
        lower: [0.1, 0.2, -0.3],
        state: vec![1.0, -0.4, 0.3],
        diffusivities: vec![0.3, 0.0, 1.2],
        tensor: Some(TENSOR),
        reaction: vec![0.3, -0.5, 0.0, 0.5, 0.1, 0.0, 0.2, 0.0, -0.7],
    }
}

impl Equation for ModeProblem {
    fn dimension(&self) -> usize {
        3
    }

    fn diffusion(&self, _: [f64; 3], _: f64, component: usize) -> [[f64; 3]; 3] {
        let tensor = self.tensor.unwrap_or(IDENTITY);
        scaled(tensor, self.diffusivities[component])
    }

    fn reaction(&self, state: &[f64]) -> Vec<f64> {
        product(&self.reaction, state)
    }
}

#[test]
fn the_equation_holds() {
    let probe = Probe {
        center: [0.0; 3],
        size: 3.0,
        duration: 2.0,
        length: 0.7,
        pace: 0.6,
    };
    for tensor in [None, Some(TENSOR)] {
        let problem = ModeProblem { tensor, ..some() };
        assert_holds(&problem.clone(), &problem.solve().unwrap(), probe);
    }
}

/// `u_i = c_i e^(-b_i k^2 t) cos(k (x - lower))` without a reaction.
#[test]
fn species_that_do_not_react_fade_by_themselves() {
    let mut problem = some();
    (problem.tensor, problem.reaction) = (None, Vec::new());
    (problem.wave_vector, problem.lower) = ([PI, 0.0, 0.0], [0.5, 0.0, 0.0]);
    let mode = problem.solve().unwrap();
    for i in 0..20 {
        let (x, time) = (0.17 * f64::from(i), 0.1 * f64::from(i));
        let wave = (PI * (x - 0.5)).cos();
        let state = mode.at([x, 0.0, 0.0], time);
        for (u, (c, b)) in state.iter().zip([(1.0, 0.3), (-0.4, 0.0), (0.3, 1.2)]) {
            let expected = c * (-b * PI * PI * time).exp() * wave;
            assert!((u - expected).abs() < 3e-15, "{time}: {u} {expected}");
        }
    }
}

/// Two species that turn into each other at the same rate, with the same b: their sum fades by
/// diffusion, their difference by both.
#[test]
fn an_exchange_levels_the_difference() {
    let (b, rate, k) = (0.2, 0.7, 1.5);
    let problem = ModeProblem {
        wave_vector: [k, 0.0, 0.0],
        lower: [0.0; 3],
        state: vec![1.0, 0.2],
        diffusivities: vec![b; 2],
        tensor: None,
        reaction: vec![-rate, rate, rate, -rate],
    };
    let mode = problem.solve().unwrap();
    for i in 0..20 {
        let time = 0.3 * f64::from(i);
        let state = mode.at([0.0; 3], time);
        let fade = (-b * k * k * time).exp();
        let sum = state[0] + state[1] - 1.2 * fade;
        let difference = state[0] - state[1] - 0.8 * fade * (-2.0 * rate * time).exp();
        assert!(sum.abs() < 3e-15 && difference.abs() < 3e-15, "{time}");
    }
}

#[test]
fn times_in_any_order_give_the_same_bits() {
    let mode = some().solve().unwrap();
    let x = [0.3, 0.4, 0.0];
    let first = mode.at(x, 1.5);
    assert_ne!(first, mode.at(x, 0.7));
    assert_eq!(first, mode.at(x, 1.5));
    assert_eq!(first, some().solve().unwrap().at(x, 1.5));
}

#[test]
fn what_is_wrong_is_named() {
    let text = |problem: ModeProblem| problem.solve().unwrap_err().to_string();
    let mut problem = some();
    problem.diffusivities.pop();
    assert_eq!(text(problem), "diffusivities must have 3 numbers, not 2");
    let mut problem = some();
    problem.diffusivities[1] = -0.5;
    assert_eq!(text(problem), "diffusivity must be >= 0, not -0.5");
    let mut problem = some();
    problem.reaction[8] = f64::NAN;
    assert_eq!(text(problem), "reaction must be finite, not NaN");
    let mut problem = some();
    problem.lower[2] = f64::INFINITY;
    assert_eq!(text(problem), "lower must be finite, not inf");
    let mut problem = some();
    problem.state = vec![0.0; 9];
    assert_eq!(text(problem), "components must be 1 to 8, not 9");
}
