//! Gradients of velocity and internal energy, exact for fields linear in space.
//!
//! `∇u_k = N_k M_k^-1`, `N_k = Σ_l μ_l F_kl (u_k-u_l) ⊗ r`, `M_k = Σ_l μ_l F_kl r ⊗ r`, and
//! likewise `∇e_k`,
//!
//! with `r = x_k - x_l` and `F_kl` the factor of the cut-off's gradient at width ε_k. Any
//! weights and any cloud give the exact gradient of a linear field (Lanson & Vila, SIAM J.
//! Numer. Anal. 46, 1912, 2008).

use crate::cutoff::{CutOff, Needs, Parts, Widths};
use crate::domain::Wall;
use crate::error::Error;
use crate::neighbours::Image;
use crate::pairs::{Ground, Law, Separation, by_pairs};
use crate::record;
use crate::scalar::{Number, Scalar};

use super::walls::{NoSlip, Reversal, apart_as};

record! {
    /// What a particle shows.
    pub struct GradientNode<N, const D: usize> {
        /// Measure μ.
        pub measure: N,
        /// The particle's part of the argument of the cut-off.
        pub scale: N,
        /// Internal energy `e`.
        pub energy: N,
        /// Velocity `u`.
        pub velocity: [N; D],
    }
}

record! {
    /// What it receives: `-M` and `-N`.
    pub struct GradientSums<N, const D: usize> {
        /// `-Σ μ F (e_k-e_l) r`.
        pub energy: [N; D],
        /// `-Σ μ F r ⊗ r`, positive definite where partners surround the particle.
        pub moments: [[N; D]; D],
        /// `-Σ μ F (u_k-u_l) ⊗ r`.
        pub velocity: [[N; D]; D],
    }
}

/// The sums that give gradients.
#[derive(Clone, Copy, Debug)]
pub struct Gradient<S, C, const D: usize> {
    /// The cut-off.
    pub cut_off: C,
    /// The walls that velocities are odd about; they are mirrored in all others.
    pub walls: NoSlip<S, D>,
}

impl<S: Scalar, C: CutOff, const D: usize> Gradient<S, C, D> {
    /// Adds the term of a pair; `seen`: how the velocity of `l` is seen.
    #[inline(always)]
    fn add<N: Number<Scalar = S>>(
        [k, l]: [&GradientNode<N, D>; 2],
        apart: &Separation<N, D>,
        seen: Option<&Reversal<N, D>>,
        to_k: &mut GradientSums<N, D>,
        to_l: &mut GradientSums<N, D>,
    ) {
        let Separation { r, zeta, .. } = apart;
        let f_k = l.measure * zeta.k.gradient;
        let f_l = k.measure * zeta.l.gradient;
        let e = k.energy - l.energy;
        let u = apart_as(seen, &k.velocity, &l.velocity);
        for i in 0..D {
            let er = e * r[i];
            to_k.energy[i] -= f_k * er;
            to_l.energy[i] -= f_l * er;
            for j in 0..D {
                let (rr, ur) = (r[i] * r[j], u[i] * r[j]);
                to_k.moments[i][j] -= f_k * rr;
                to_l.moments[i][j] -= f_l * rr;
                to_k.velocity[i][j] -= f_k * ur;
                to_l.velocity[i][j] -= f_l * ur;
            }
        }
    }
}

impl<S: Scalar, C: CutOff, const D: usize> Law<S, D> for Gradient<S, C, D> {
    type Node = GradientNode<S, D>;
    type Sums = GradientSums<S, D>;
    type CutOff = C;
    const NEEDS: Needs = Needs {
        parts: Parts::Gradient,
        widths: Widths::Own,
        distance: false,
    };

    fn cut_off(&self) -> C {
        self.cut_off
    }
    #[inline(always)]
    fn scale<N: Number<Scalar = S>>(&self, node: &GradientNode<N, D>) -> N {
        node.scale
    }

    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(
        &self,
        k: &GradientNode<N, D>,
        l: &GradientNode<N, D>,
        apart: &Separation<N, D>,
        to_k: &mut GradientSums<N, D>,
        to_l: &mut GradientSums<N, D>,
    ) {
        Self::add([k, l], apart, None, to_k, to_l);
    }

    #[inline(always)]
    fn pair_behind<N: Number<Scalar = S>>(
        &self,
        pair: [&GradientNode<N, D>; 2],
        image: &Image<D>,
        apart: &Separation<N, D>,
        to_k: &mut GradientSums<N, D>,
        to_l: &mut GradientSums<N, D>,
    ) {
        Self::add(pair, apart, self.walls.seen(image).as_ref(), to_k, to_l);
    }

    fn proof(&self, ground: &Ground<'_, '_, S, D>, nodes: &[Self::Node]) -> Result<(), Error> {
        self.prove(ground, nodes)
            .or_else(|_| by_pairs(self, ground, nodes, |node, wall| self.reflected(node, wall)))
    }

    fn reflected(&self, node: &GradientNode<S, D>, wall: &Wall<S>) -> GradientNode<S, D> {
        let mut node = *node;
        if let Some(component) = node.velocity.get_mut(wall.axis) {
            *component = -*component;
        }
        node
    }
}

/// The smallest determinant of `M/(tr M/D)` that is inverted: partners on one line, or all on
/// one side, do not give a gradient.
const SMALLEST_DETERMINANT: f64 = 1.0 / 64.0;

/// The gradients of a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slopes<S, const D: usize> {
    /// `∂u_i/∂x_j`.
    pub velocity: [[S; D]; D],
    /// `∂e/∂x_j`.
    pub energy: [S; D],
}

/// The inverse of the moments M of a particle.
pub(super) struct Inverse<S, const D: usize> {
    /// `D/tr M`.
    unit: S,
    /// The adjugate of `U = M/(tr M/D)`: its inverse times the determinant.
    pub adjugate: [[S; D]; D],
    /// The determinant of U, in (0, 1]: 1 where partners surround the particle evenly.
    pub determinant: S,
}

impl<S: Scalar, const D: usize> GradientSums<S, D> {
    /// The gradients; 0 where the partners do not determine them.
    pub fn slopes(&self) -> Slopes<S, D> {
        let mut slopes = Slopes {
            velocity: [[S::ZERO; D]; D],
            energy: [S::ZERO; D],
        };
        let Some(Inverse {
            unit,
            adjugate,
            determinant,
        }) = self.inverse()
        else {
            return slopes;
        };
        let solved = |row: &[S; D]| {
            let mut solution = [S::ZERO; D];
            for j in 0..D {
                for m in 0..D {
                    solution[j] += row[m] * unit * adjugate[m][j];
                }
                solution[j] = solution[j] / determinant;
            }
            solution
        };
        slopes.velocity = self.velocity.map(|row| solved(&row));
        slopes.energy = solved(&self.energy);
        slopes
    }

    /// The inverse of the moments; `None` where the partners do not determine gradients.
    pub(super) fn inverse(&self) -> Option<Inverse<S, D>> {
        let mut trace = S::ZERO;
        for i in 0..D {
            trace += self.moments[i][i];
        }
        if !(trace > S::ZERO) {
            return None;
        }
        // Of order 1, also in fixed point.
        let unit = S::count(D as u32) / trace;
        let mut moments = self.moments;
        for row in &mut moments {
            for entry in row {
                *entry = *entry * unit;
            }
        }
        let (adjugate, determinant) = adjugate(&moments);
        (determinant > S::from_f64(SMALLEST_DETERMINANT)).then_some(Inverse {
            unit,
            adjugate,
            determinant,
        })
    }
}

/// The adjugate and the determinant of a symmetric matrix of up to three rows.
fn adjugate<S: Scalar, const D: usize>(m: &[[S; D]; D]) -> ([[S; D]; D], S) {
    let mut adjugate = [[S::ZERO; D]; D];
    match D {
        1 => adjugate[0][0] = S::ONE,
        2 => {
            for i in 0..D {
                for j in 0..D {
                    let minor = m[1 - i][1 - j];
                    adjugate[j][i] = if i == j { minor } else { -minor };
                }
            }
        }
        _ => {
            for i in 0..D {
                for j in 0..D {
                    // Cyclic rows and columns carry the sign of the cofactor.
                    let (a, b) = ((i + 1) % D, (i + 2) % D);
                    let (c, d) = ((j + 1) % D, (j + 2) % D);
                    adjugate[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
                }
            }
        }
    }
    let mut determinant = S::ZERO;
    for i in 0..D {
        determinant += m[0][i] * adjugate[i][0];
    }
    (adjugate, determinant)
}

/// `div u`, the trace of a velocity gradient.
pub fn divergence<S: Scalar, const D: usize>(gradient: &[[S; D]; D]) -> S {
    let mut sum = S::ZERO;
    for i in 0..D {
        sum += gradient[i][i];
    }
    sum
}

/// `Σ_i<j (∂_i u_j - ∂_j u_i)²`, the square of the curl.
pub fn curl_squared<S: Scalar, const D: usize>(gradient: &[[S; D]; D]) -> S {
    let mut sum = S::ZERO;
    for i in 0..D {
        for j in 0..i {
            let difference = gradient[i][j] - gradient[j][i];
            sum += difference * difference;
        }
    }
    sum
}

/// The squares of the entries of the traceless symmetric part, summed: 0 in one dimension.
pub fn shear_squared<S: Scalar, const D: usize>(gradient: &[[S; D]; D]) -> S {
    let mean = divergence(gradient) / S::count(D as u32);
    let mut sum = S::ZERO;
    for i in 0..D {
        for j in 0..D {
            let entry = (gradient[i][j] + gradient[j][i]).half();
            let entry = if i == j { entry - mean } else { entry };
            sum += entry * entry;
        }
    }
    sum
}
