//! Sources, decay and reactions, by name.

use crate::scalar::Scalar;

/// `f(u)` of `∂u/∂t + div(a u) - div(b ∇u) = f`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reaction<S, const P: usize> {
    /// Nothing.
    None,
    /// `M u + s`: sources, decay, chains of decays.
    Linear {
        /// `M`, rows first, 1/time.
        matrix: [[S; P]; P],
        /// `s`, u/time.
        source: [S; P],
    },
    /// `r u (1 - u/K)` of each species (Verhulst 1838).
    Logistic {
        /// `r`, 1/time, >= 0.
        rate: S,
        /// `K`, > 0.
        capacity: S,
    },
    /// Of the first two species, `u + 2v -> 3v`, fed and drained (Gray & Scott, Chem. Eng. Sci. 39,
    /// 1984; with diffusion Pearson, Science 261, 1993, 189): `-u v² + F(1 - u)`,
    /// `u v² - (F + k) v`, per `unit` of time.
    GrayScott {
        /// `F`.
        feed: S,
        /// `k`.
        kill: S,
        /// The factor of all of it, 1/time.
        unit: S,
    },
}

impl<S: Scalar, const P: usize> Reaction<S, P> {
    /// `f(u)`.
    pub fn rate(&self, u: &[S; P]) -> [S; P] {
        let mut rates = [S::ZERO; P];
        match self {
            Self::None => {}
            Self::Linear { matrix, source } => {
                for ((rate, row), &source) in rates.iter_mut().zip(matrix).zip(source) {
                    *rate = source + S::dot(row, u);
                }
            }
            Self::Logistic { rate: r, capacity } => {
                for (rate, &u) in rates.iter_mut().zip(u) {
                    *rate = *r * u * (S::ONE - u / *capacity);
                }
            }
            Self::GrayScott { feed, kill, unit } => {
                if let ([u, v, ..], [rate_u, rate_v, ..]) = (u.as_slice(), rates.as_mut_slice()) {
                    let turned = *u * *v * *v;
                    *rate_u = *unit * (*feed * (S::ONE - *u) - turned);
                    *rate_v = *unit * (turned - (*feed + *kill) * *v);
                }
            }
        }
        rates
    }

    /// A bound of all that [`Reaction::rate`] makes on its way for values up to `u` in magnitude.
    pub fn largest(&self, u: f64) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Linear { matrix, source } => {
                let size = |a: &S| a.to_f64().abs();
                let row = |row: &[S; P]| row.iter().map(size).sum::<f64>() * u;
                let rows = matrix.iter().map(row).zip(source.iter().map(size));
                rows.fold(0.0, |most, (a, b)| f64::max(most, a + b))
            }
            Self::Logistic { rate, capacity } => {
                // The quotient saturates.
                let share = (u / capacity.to_f64()).min(S::LARGEST.to_f64());
                (rate.to_f64() * u).max(1.0) * (1.0 + share)
            }
            Self::GrayScott { feed, kill, unit } => {
                let turned = u.max(u * u).max(u * u * u);
                let drained = (feed.to_f64() + kill.to_f64()) * (1.0 + u);
                unit.to_f64().max(1.0) * (turned + drained)
            }
        }
    }

    /// A bound of the `|eigenvalues|` of `∂f/∂u`: of a linear one by the sums of its rows; of the
    /// others where they are meant to be, `-K <= u <= 2K`, and `0 <= u <= 1`, `0 <= v <= 1/2`.
    pub fn bound(&self) -> S {
        match self {
            Self::None => S::ZERO,
            Self::Linear { matrix, .. } => {
                let sum = |row: &[S; P]| row.iter().fold(S::ZERO, |sum, a| sum + a.abs());
                matrix.iter().map(sum).fold(S::ZERO, Scalar::greater)
            }
            Self::Logistic { rate, .. } => *rate + *rate + *rate,
            Self::GrayScott { feed, kill, unit } => {
                let turned = S::ONE + S::ONE.half().half();
                *unit * (turned + *feed + *kill)
            }
        }
    }
}
