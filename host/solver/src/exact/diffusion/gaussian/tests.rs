//! The equation in every flow, the mass, and the start.

use super::super::super::linear::residual::Probe;
use super::super::super::linear::transport::TransportProblem;
use super::super::residual::{Equation, assert_holds, product, scaled};
use super::*;
use std::f64::consts::PI;

const SWING: Modulation = Modulation {
    amplitude: 0.8,
    rate: 3.0,
};

/// Positive definite, nothing about it special.
const TENSOR: [[f64; 3]; 3] = [[1.0, 0.3, -0.2], [0.3, 0.5, 0.1], [-0.2, 0.1, 0.7]];

fn cut(mut tensor: [[f64; 3]; 3], dimension: usize) -> [[f64; 3]; 3] {
    for (row, line) in tensor.iter_mut().enumerate() {
        for (column, entry) in line.iter_mut().enumerate() {
            if row >= dimension || column >= dimension {
                *entry = 0.0;
            }
        }
    }
    tensor
}

fn fields(dimension: usize) -> Vec<Field> {
    let (rate, center) = (0.7, [0.4, -0.3, 0.2]);
    let mut velocity = [0.5, -0.8, 0.3];
    velocity[dimension..].fill(0.0);
    let mut fields = vec![
        Field::Still,
        Field::Uniform { velocity },
        Field::Compression {
            rate,
            center,
            dimension,
        },
    ];
    if dimension > 1 {
        fields.push(Field::Rotation { rate, center });
        fields.push(Field::Shear { rate, center });
    }
    fields
}

fn problem(dimension: usize, field: Field) -> GaussianProblem {
    let mut center = [0.1, 0.2, -0.1];
    center[dimension..].fill(0.0);
    GaussianProblem {
        dimension,
        field,
        center,
        width: 0.8,
        state: vec![1.5, -0.4],
        diffusivity: 0.15,
        tensor: None,
        modulation: None,
        reaction: vec![-0.4, 0.3, -0.6, 0.2],
        periods: [None; 3],
    }
}

impl Equation for GaussianProblem {
    fn dimension(&self) -> usize {
        self.dimension
    }

    fn velocity(&self, position: [f64; 3]) -> [f64; 3] {
        self.field.velocity(position)
    }

    fn diffusion(&self, _: [f64; 3], time: f64, _: usize) -> [[f64; 3]; 3] {
        let swing = self.modulation.map_or(1.0, |m| m.factor(time));
        scaled(self.tensor_or_identity(), self.diffusivity * swing)
    }

    fn reaction(&self, state: &[f64]) -> Vec<f64> {
        product(&self.reaction, state)
    }
}

/// The compression takes the width to 0.8 e^-0.5 at least.
const PROBE: Probe = Probe {
    center: [0.1, 0.0, 0.0],
    size: 0.8,
    duration: 0.7,
    length: 0.4,
    pace: 0.4,
};

fn holds(problem: GaussianProblem) {
    assert_holds(&problem.clone(), &problem.solve().unwrap(), PROBE);
}

#[test]
fn the_equation_holds_in_every_flow() {
    for dimension in 1..=3 {
        for field in fields(dimension) {
            let plain = problem(dimension, field);
            let tensor = Some(cut(TENSOR, dimension));
            holds(plain.clone());
            holds(GaussianProblem { tensor, ..plain });
        }
    }
}

#[test]
fn it_holds_with_a_modulation() {
    let modulation = Some(SWING);
    for dimension in 1..=3 {
        for field in fields(dimension) {
            let plain = GaussianProblem {
                modulation,
                ..problem(dimension, field)
            };
            let tensor = Some(cut(TENSOR, dimension));
            match field {
                Field::Still | Field::Uniform { .. } => {
                    holds(plain.clone());
                    holds(GaussianProblem { tensor, ..plain });
                }
                Field::Rotation { .. } => holds(plain),
                _ => {}
            }
        }
    }
}

#[test]
fn it_holds_with_images() {
    let periods = [
        [Some(1.0), None, None],
        [None, Some(1.2), None],
        [Some(1.4), Some(1.2), Some(2.0)],
    ];
    for periods in periods {
        for tensor in [None, Some(TENSOR)] {
            holds(GaussianProblem {
                periods,
                tensor,
                ..problem(3, fields(3)[1])
            });
        }
    }
    let shear = GaussianProblem {
        periods: [Some(1.1), None, Some(2.0)],
        ..problem(3, fields(3)[4])
    };
    holds(shear);
}

/// The trapezoidal rule over 8 widths is exact for a Gaussian up to `e^(-(pi w/h)^2) < 1e-16`.
#[test]
fn the_mass_grows_by_the_reaction_only() {
    for field in fields(2) {
        let modulation = matches!(field, Field::Still).then_some(SWING);
        let problem = GaussianProblem {
            reaction: vec![-0.4, 0.0, 0.0, 0.2],
            tensor: Some(cut(TENSOR, 2)),
            modulation,
            ..problem(2, field)
        };
        let (gaussian, time, step) = (problem.solve().unwrap(), 0.9, 0.08);
        let mut mass = [0.0; 2];
        for i in -150..150 {
            for j in -150..150 {
                let place = [step * f64::from(i), step * f64::from(j), 0.0];
                let u = gaussian.at(place, time);
                mass[0] += u[0] * step * step;
                mass[1] += u[1] * step * step;
            }
        }
        let initial = PI * 0.8 * 0.8;
        for (mass, (peak, rate)) in mass.iter().zip([(1.5, -0.4), (-0.4, 0.2)]) {
            let expected = peak * initial * libm::exp(rate * time);
            assert!((mass / expected - 1.0).abs() < 1e-13, "{field:?}: {mass}");
        }
    }
}

#[test]
fn it_starts_with_its_width_and_keeps_it_without_diffusion() {
    for dimension in 1..=3 {
        for field in fields(dimension) {
            let mut problem = problem(dimension, field);
            problem.diffusivity = 0.0;
            problem.reaction.clear();
            let transport = TransportProblem {
                field,
                center: problem.center,
                width: 0.8,
                amplitude: 1.5,
                decay: 0.0,
                source: 0.0,
                periods: [None; 3],
            };
            let (transport, gaussian) = (transport.solve().unwrap(), problem.solve().unwrap());
            for i in -10..10 {
                let mut place = [0.13 * f64::from(i), -0.07 * f64::from(i), 0.2];
                place[dimension..].fill(0.0);
                for time in [0.0, 0.6] {
                    let (a, b) = (transport.at(place, time)[0], gaussian.at(place, time)[0]);
                    assert!((a - b).abs() < 1e-14, "{field:?} {time}: {a} {b}");
                }
            }
        }
    }
}

/// `exp(-x^2/(w^2 + 4 b t)) (w^2/(w^2 + 4 b t))^(d/2)`.
#[test]
fn at_rest_it_is_the_classical_solution() {
    for dimension in 1..=3 {
        let gaussian = problem(dimension, Field::Still);
        let gaussian = GaussianProblem {
            reaction: Vec::new(),
            ..gaussian
        };
        let gaussian = gaussian.solve().unwrap();
        let spread = 0.64 + 4.0 * 0.15 * 2.3;
        for i in -10..10 {
            let x = 0.2 * f64::from(i);
            let mut place = gaussian.problem().center;
            place[0] += x;
            let peak = (0.64_f64 / spread).powf(0.5 * dimension as f64);
            let expected = 1.5 * peak * (-x * x / spread).exp();
            let error = gaussian.at(place, 2.3)[0] - expected;
            assert!(error.abs() < 1e-14, "{dimension} {x}: {error:e}");
        }
    }
}

/// Spread over a hundred periods it is `mass/volume`.
#[test]
fn a_wide_gaussian_in_a_box_is_uniform() {
    let problem = GaussianProblem {
        periods: [Some(1.0), Some(1.5), Some(2.0)],
        tensor: Some(TENSOR),
        reaction: Vec::new(),
        ..problem(3, Field::Still)
    };
    let gaussian = problem.solve().unwrap();
    let expected = 1.5 * (PI.sqrt() * 0.8).powi(3) / 3.0;
    for i in 0..10 {
        let u = gaussian.at([0.1 * f64::from(i), 0.3, 0.2], 1e5)[0];
        assert!((u / expected - 1.0).abs() < 1e-14, "{u} {expected}");
    }
}

#[test]
fn what_is_wrong_is_named() {
    let text = |problem: GaussianProblem| problem.solve().unwrap_err().to_string();
    let good = || problem(2, Field::Still);
    let [_, uniform, compression, rotation, shear] = fields(2)[..] else {
        panic!("five fields")
    };
    let mut wrong = good();
    wrong.width = 0.0;
    assert_eq!(text(wrong), "width must be > 0, not 0");
    let mut wrong = good();
    wrong.diffusivity = -1.0;
    assert_eq!(text(wrong), "diffusivity must be >= 0, not -1");
    let mut wrong = good();
    wrong.reaction.pop();
    assert_eq!(text(wrong), "reaction must have 4 numbers, not 3");
    let mut wrong = good();
    wrong.state.clear();
    assert_eq!(text(wrong), "components must be 1 to 8, not 0");
    let mut wrong = good();
    wrong.center[2] = 1.0;
    assert_eq!(
        text(wrong),
        "center must be zero beyond the dimension, not 1"
    );
    let mut wrong = good();
    wrong.tensor = Some([[1.0, 2.0, 0.0], [2.0, 3.0, 0.0], [0.0; 3]]);
    let expected = "tensor must be without negative eigenvalues, not -1";
    assert_eq!(text(wrong), expected);
    let mut wrong = good();
    wrong.tensor = Some([[1.0, 0.2, 0.0], [0.1, 3.0, 0.0], [0.0; 3]]);
    assert_eq!(text(wrong), "tensor must be symmetric, not 0.2");
    let mut wrong = good();
    wrong.tensor = Some(TENSOR);
    assert_eq!(
        text(wrong),
        "tensor must be zero beyond the dimension, not -0.2"
    );
    let mut wrong = good();
    wrong.modulation = Some(Modulation {
        amplitude: 1.1,
        ..SWING
    });
    let expected = "amplitude of the modulation must be -1 to 1, not 1.1";
    assert_eq!(text(wrong), expected);
    let mut wrong = problem(2, uniform);
    wrong.periods[2] = Some(1.0);
    let expected = "period along z must be none beyond the dimension, not 1";
    assert_eq!(text(wrong), expected);
    let mut wrong = problem(2, rotation);
    wrong.periods[0] = Some(1.0);
    let expected = "period along x must be a period of the velocity, not 1";
    assert_eq!(text(wrong), expected);
    for (field, name) in [(shear, "a shear"), (compression, "a compression")] {
        let mut wrong = problem(2, field);
        wrong.modulation = Some(SWING);
        let expected = format!(
            "a modulation together with {name} has no closed form here: leave one of them out"
        );
        assert_eq!(text(wrong), expected);
    }
    let mut wrong = problem(2, rotation);
    (wrong.modulation, wrong.tensor) = (Some(SWING), Some(cut(TENSOR, 2)));
    assert!(text(wrong).starts_with("a modulation together with a tensor in a rotation has no"));
    let wave = Field::Wave {
        amplitude: 0.2,
        lower: 0.0,
        length: 2.0,
    };
    assert!(text(problem(2, wave)).starts_with("a velocity wave together with diffusion"));
    let expected = "dimension must be 2 or 3 in rotation and shear, not 1";
    assert_eq!(text(problem(1, shear)), expected);
    let expected = "dimension must be that of the compression, not 3";
    assert_eq!(text(problem(3, compression)), expected);
}
