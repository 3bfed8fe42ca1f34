//! Layers side by side, their ends, and the steady states that these admit.

use super::{End, Layer};

/// Layers from `lower` upwards.
#[derive(Debug)]
pub(super) struct Layers {
    pub(super) layers: Vec<Layer>,
    /// Where each begins.
    starts: Vec<f64>,
}

impl Layers {
    pub(super) fn new(lower: f64, layers: Vec<Layer>) -> Self {
        let mut upper = lower;
        let starts = layers.iter().map(|layer| {
            let start = upper;
            upper += layer.thickness;
            start
        });
        let starts = starts.collect();
        Self { layers, starts }
    }

    /// From end to end.
    pub(super) fn length(&self) -> f64 {
        self.layers.iter().map(|layer| layer.thickness).sum()
    }

    /// The layer of a place, and how far it is from where that begins. Beyond an end: that end.
    pub(super) fn locate(&self, x: f64) -> (usize, f64) {
        let after = self.starts.partition_point(|start| *start <= x);
        let index = after.saturating_sub(1);
        let distance = (x - self.starts[index]).clamp(0.0, self.layers[index].thickness);
        (index, distance)
    }
}

/// `value u + flux J = g` at an end, J the flux outwards.
struct Condition {
    value: f64,
    flux: f64,
    data: f64,
}

impl End {
    /// The condition with the drive g.
    fn condition(&self, g: f64) -> Condition {
        let [value, flux, data] = match self {
            Self::NoFlux => [0.0, 1.0, 0.0],
            Self::Flux(_) => [0.0, 1.0, g],
            Self::Value(_) => [1.0, 0.0, g],
            Self::Exchange { rate, .. } => [-rate, 1.0, -rate * g],
        };
        Condition { value, flux, data }
    }

    /// Whether the condition leaves the level open.
    pub(super) fn is_a_flux(&self) -> bool {
        matches!(self, Self::NoFlux | Self::Flux(_))
    }
}

/// A polynomial up to degree 4 of the distance from where its layer begins.
pub(super) type Polynomial = [f64; 5];

/// A polynomial in each layer.
#[derive(Debug, Clone)]
pub(super) struct Profile(pub(super) Vec<Polynomial>);

impl Profile {
    pub(super) fn uniform(value: f64, count: usize) -> Self {
        Self(vec![[value, 0.0, 0.0, 0.0, 0.0]; count])
    }

    /// Adds `factor` times another.
    pub(super) fn add(&mut self, factor: f64, other: &Self) {
        let pairs = self.0.iter_mut().zip(&other.0);
        for (sum, term) in pairs.flat_map(|(a, b)| a.iter_mut().zip(b)) {
            *sum += factor * term;
        }
    }

    /// Value and slope in a layer.
    pub(super) fn at(&self, (layer, distance): (usize, f64)) -> [f64; 2] {
        horner(&self.0[layer], distance)
    }

    fn mean(&self, layers: &Layers) -> f64 {
        let each = self.0.iter().zip(&layers.layers);
        let integral = each.map(|(p, layer)| {
            let means = [p[0], p[1] / 2.0, p[2] / 3.0, p[3] / 4.0, p[4] / 5.0];
            let [mean, _] = horner(&means, layer.thickness);
            mean * layer.thickness
        });
        integral.sum::<f64>() / layers.length()
    }
}

/// Value and slope.
fn horner(polynomial: &Polynomial, x: f64) -> [f64; 2] {
    let step = |[value, slope]: [f64; 2], c: &f64| [value * x + c, slope * x + value];
    polynomial.iter().rev().fold([0.0; 2], step)
}

/// The integral that is `constant` at 0. What would be of degree 5 is 0 in all that is solved.
fn integrated(p: &Polynomial, constant: f64) -> Polynomial {
    [constant, p[0], p[1] / 2.0, p[2] / 3.0, p[3] / 4.0]
}

impl Layers {
    /// w of `d_x(D d_x w) = source`, for drives g at both ends. Where both conditions are fluxes,
    /// that of mean 0; the source must then make up for the fluxes.
    pub(super) fn steady(&self, ends: &[End; 2], source: &Profile, g: [f64; 2]) -> Profile {
        let [left, right] = [0, 1].map(|side: usize| ends[side].condition(g[side]));
        // What starts with w = 0 and D w' = 0, and its values at the other end.
        let (_, [w, flux]) = self.shot(source, 0.0, 0.0);
        let resistances = self.layers.iter().map(|l| l.thickness / l.diffusivity);
        let resistance = resistances.sum::<f64>();
        // w = level + D w'(0) ∫dx/D + that; the flux outwards is D w' below, -D w' above.
        let across = right.value * resistance - right.flux;
        let data = right.data - right.value * w + right.flux * flux;
        let determinant = left.value * across - left.flux * right.value;
        let open = ends.iter().all(End::is_a_flux);
        let (level, slope) = if open {
            (0.0, left.data)
        } else {
            (
                (left.data * across - left.flux * data) / determinant,
                (left.value * data - right.value * left.data) / determinant,
            )
        };
        let (mut profile, _) = self.shot(source, level, slope);
        if open {
            let mean = profile.mean(self);
            for piece in &mut profile.0 {
                piece[0] -= mean;
            }
        }
        profile
    }

    /// w that starts with a level and a `D w'`, and both at the other end.
    fn shot(&self, source: &Profile, level: f64, flux: f64) -> (Profile, [f64; 2]) {
        let (mut w, mut flux) = (level, flux);
        let mut pieces = Vec::with_capacity(self.layers.len());
        for (layer, source) in self.layers.iter().zip(&source.0) {
            let fluxes = integrated(source, flux);
            let slopes = fluxes.map(|c| c / layer.diffusivity);
            let piece = integrated(&slopes, w);
            [w, _] = horner(&piece, layer.thickness);
            [flux, _] = horner(&fluxes, layer.thickness);
            pieces.push(piece);
        }
        (Profile(pieces), [w, flux])
    }
}
