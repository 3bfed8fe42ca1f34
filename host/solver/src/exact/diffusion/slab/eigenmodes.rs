//! The modes of layers: `d_x(D d_x phi) = -lambda phi`, phi and `F = D phi'` continuous.
//!
//! With `mu = sqrt(lambda)` and `s = mu sqrt(D)`, Prüfer's angle, `phi = R sin theta` and
//! `F = s R cos theta`, grows by `mu thickness/sqrt(D)` in a layer; where s changes to s' it changes
//! to `tan theta' = (s'/s) tan theta` in the same quarter. `phi/F` at the last end grows with
//! lambda, hence mode n is where theta passes the n-th angle of the condition there: bisection
//! misses none. E. A. Coddington and N. Levinson, Theory of Ordinary Differential Equations, 1955,
//! chapter 8, theorem 2.1. mu is good to some roundings, and the modes are as well conditioned as
//! a product of rotations and of the steps of `sqrt(D)`.

use std::f64::consts::{FRAC_PI_2, PI};

use super::layers::Layers;
use super::{End, Layer};

/// A mode, `∫ phi^2 dx = 1`.
#[derive(Debug)]
pub(super) struct Eigenmode {
    root: f64,
    /// phi and F/s where each layer begins.
    parts: Vec<[f64; 2]>,
    /// phi and F at both ends.
    pub(super) ends: [[f64; 2]; 2],
}

/// theta at the first end, and pi less theta at the last: 0 to pi/2.
fn angle(end: &End, s: f64) -> f64 {
    match end {
        End::Value(_) => 0.0,
        End::NoFlux | End::Flux(_) => FRAC_PI_2,
        // F = rate phi at the first, -rate phi at the last.
        End::Exchange { rate, .. } => libm::atan2(s, *rate),
    }
}

/// `s` for a root.
fn scale(root: f64, layer: &Layer) -> f64 {
    root * libm::sqrt(layer.diffusivity)
}

/// How far theta at the last end is beyond the first angle of the condition there.
fn beyond(layers: &[Layer], ends: &[End; 2], root: f64) -> f64 {
    let mut before: Option<f64> = None;
    let mut theta = 0.0;
    for layer in layers {
        let s = scale(root, layer);
        theta = match before {
            None => angle(&ends[0], s),
            Some(before) => {
                let turn = PI * libm::round(theta / PI);
                let rest = theta - turn;
                turn + libm::atan2(s / before * libm::sin(rest), libm::cos(rest))
            }
        };
        theta += root * layer.duration();
        before = Some(s);
    }
    theta - PI + angle(&ends[1], before.unwrap_or(0.0))
}

/// The first modes with lambda > 0, ascending.
pub(super) fn eigenmodes(layers: &Layers, ends: &[End; 2], count: usize) -> Vec<Eigenmode> {
    let total = layers.layers.iter().map(Layer::duration).sum::<f64>();
    // Of two fluxes the first mode is lambda = 0, theta = pi/2.
    let open = ends.iter().all(End::is_a_flux);
    let first = if open { 1 } else { 0 };
    let mut modes: Vec<Eigenmode> = Vec::with_capacity(count);
    for n in first..first + count {
        let target = PI * n as f64;
        let below = |root: f64| beyond(&layers.layers, ends, root) < target;
        let mut low = modes.last().map_or(0.0, |mode| mode.root);
        let mut step = PI / total;
        while below(low + step) {
            low += step;
            step *= 2.0;
        }
        let mut high = low + step;
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if below(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        modes.push(Eigenmode::new(&layers.layers, ends, high));
    }
    modes
}

impl Eigenmode {
    /// The mode of a root, from the first end on.
    fn new(layers: &[Layer], ends: &[End; 2], root: f64) -> Self {
        let start = match &ends[0] {
            End::Value(_) => [0.0, root],
            End::NoFlux | End::Flux(_) => [1.0, 0.0],
            End::Exchange { rate, .. } => [1.0, *rate],
        };
        let [mut phi, mut flux] = start;
        let mut square = 0.0;
        let mut parts = Vec::with_capacity(layers.len());
        for layer in layers {
            let s = scale(root, layer);
            let [p, q] = [phi, flux / s];
            parts.push([p, q]);
            let theta = root * layer.duration();
            let (sine, cosine) = libm::sincos(theta);
            // ∫ (p cos + q sin)^2 over the layer, by the angle.
            let integral = 0.5 * (p * p + q * q) * theta
                + 0.5 * (p * p - q * q) * sine * cosine
                + p * q * sine * sine;
            square += integral * layer.thickness / theta;
            phi = p * cosine + q * sine;
            flux = s * (q * cosine - p * sine);
        }
        let norm = libm::sqrt(square);
        let divided = |pair: [f64; 2]| pair.map(|part| part / norm);
        Self {
            root,
            parts: parts.into_iter().map(divided).collect(),
            ends: [divided(start), divided([phi, flux])],
        }
    }

    /// lambda.
    pub(super) fn rate(&self) -> f64 {
        self.root * self.root
    }

    /// phi and F at a place in a layer.
    pub(super) fn at(&self, layer: &Layer, (index, distance): (usize, f64)) -> [f64; 2] {
        let [p, q] = self.parts[index];
        let s = scale(self.root, layer);
        let (sine, cosine) = libm::sincos(self.root * distance / libm::sqrt(layer.diffusivity));
        [p * cosine + q * sine, s * (q * cosine - p * sine)]
    }
}
