//! The symmetriser of Remark 1: for a system `∂u/∂t + Σ_i A^i ∂u/∂x_i = 0` with constant real
//! matrices, a symmetric positive definite `P` with every `P A^i` symmetric, or why there is
//! none.
//!
//! With it Theorem 2 holds for the system, in the norm `(Σ w_k u_k·P u_k)^(1/2)`, and every
//! `n·A` is diagonalisable with real eigenvalues. So `P` is looked for first, which is a linear
//! problem with one inequality; directions are only searched to say why there is none.
//!
//! Differs from the paper: constant coefficients.
//!
//! Same bits on every processor: no step depends on what it can do.

mod balance;
mod definite;
mod directions;
mod null_space;
mod reason;
#[cfg(test)]
mod tests;

use nalgebra::DMatrix;

use balance::Balanced;
use directions::{Directions, along};

/// `P`, and what it says of its system.
#[derive(Clone, Debug, PartialEq)]
pub struct Symmetriser {
    /// `P`, row by row: p x p, symmetric, positive definite, of trace p. The identity, exactly,
    /// where all A^i are symmetric.
    pub matrix: Vec<f64>,
    /// Its largest eigenvalue over its smallest, >= 1. It depends on the units of the unknowns.
    pub condition: f64,
    /// No `n·A` with `|n| = 1` has an eigenvalue above this in size. In one dimension it is the
    /// largest of them; in two it is at most 3.1e-5 above it, in three 4e-3.
    pub speed: f64,
}

/// Why a system has no symmetriser.
#[derive(Clone, Debug, PartialEq, thiserror::Error, miette::Diagnostic)]
pub enum SymmetriserError {
    /// Not one to three square matrices of one size.
    #[error("{count} matrices, of which number {matrix} has {entries} entries")]
    #[diagnostic(help(
        "give one matrix a direction of space, 1 to 3, each with p x p entries row by row"
    ))]
    Shape {
        /// How many matrices there are.
        count: usize,
        /// The first that does not fit, from 0.
        matrix: usize,
        /// How many entries it has.
        entries: usize,
    },
    /// An entry that is no number.
    #[error("A^{}[{row}][{column}] = {value} is not finite", matrix + 1)]
    #[diagnostic(help("give finite numbers"))]
    NotFinite {
        /// The matrix, from 0.
        matrix: usize,
        /// Its row, from 0.
        row: usize,
        /// Its column, from 0.
        column: usize,
        /// What is there.
        value: f64,
    },
    /// Waves in some direction would grow without bound.
    #[error(
        "the system is not hyperbolic: along {direction:?} it has the eigenvalue {} {} {}i",
        eigenvalue[0], if eigenvalue[1] < 0.0 { '-' } else { '+' }, eigenvalue[1].abs()
    )]
    #[diagnostic(help(
        "n·A must have real eigenvalues for every direction n: check the signs of the matrices"
    ))]
    NotHyperbolic {
        /// The unit vector n where it is worst, of those searched.
        direction: Vec<f64>,
        /// The real and the imaginary part of an eigenvalue of n·A.
        eigenvalue: [f64; 2],
    },
    /// All eigenvalues are real, but there are too few eigenvectors.
    #[error("the system is not hyperbolic: along {direction:?} it has too few eigenvectors")]
    #[diagnostic(help("n·A must be diagonalisable for every direction n"))]
    NotDiagonalisable {
        /// The unit vector n.
        direction: Vec<f64>,
    },
    /// No fault was found along any direction searched, but no `P` fits all A^i together.
    #[error("the system cannot be symmetrised: no P makes all P A^i symmetric")]
    #[diagnostic(help(
        "the method needs one (Raviart 1985, Remark 1): check the matrices against each other, \
         or take as unknowns those of a form that has an entropy"
    ))]
    NotSymmetrisable,
}

impl Symmetriser {
    /// Of the system with the matrices A^1, ..., A^D, each p x p and row by row; D is 1 to 3.
    /// Meant for p <= 8: the work grows with p^6.
    ///
    /// Among several `P` the one with the largest smallest eigenvalue is taken, to a
    /// thousandth, in unknowns scaled such that rows and columns of the A^i have one size.
    /// Accuracy: `|P A^i - (P A^i)^T| <= 1e-8 |P| |A^i|` in the scaled unknowns, usually
    /// 1e-14.
    ///
    /// # Errors
    /// What [`SymmetriserError`] lists. A fault between the directions that are searched, or a
    /// `P` whose smallest eigenvalue in the scaled unknowns would be below 1e-8, is told as
    /// `NotSymmetrisable`; a block of four and more unknowns with one eigenvector may be told
    /// as `NotHyperbolic`.
    pub fn of(matrices: &[Vec<f64>]) -> Result<Self, SymmetriserError> {
        let matrices = checked(matrices)?;
        let directions = Directions::new(matrices.len());
        let p = matrices[0].nrows();
        if matrices.iter().all(|a| *a == a.transpose()) {
            let identity = DMatrix::identity(p, p);
            return Ok(Self {
                speed: speed(&matrices, &identity, &directions),
                matrix: identity.as_slice().to_vec(),
                condition: 1.0,
            });
        }
        let balanced = Balanced::new(&matrices);
        let shapes = balanced.shapes();
        let found = null_space::symmetrisers(p, &shapes)
            .and_then(|space| definite::best(&space))
            .filter(|found| symmetrises(found, &shapes));
        let Some(scaled) = found else {
            return Err(reason::why(&balanced.matrices, &directions));
        };
        Ok(Self {
            speed: speed(&balanced.matrices, &scaled, &directions),
            condition: balanced.condition(&scaled),
            matrix: balanced.unscaled(&scaled).as_slice().to_vec(),
        })
    }

    /// `λ` with `d‖u‖/dt <= λ ‖u‖` in the norm `∫ u·Pu` where the system also has the constant
    /// `A⁰`, row by row: the largest eigenvalue of the symmetric part of `-A⁰` in the scalar
    /// product of `P`.
    pub fn growth(&self, reaction: &[f64]) -> f64 {
        let size = self.matrix.len().isqrt();
        let p = DMatrix::from_row_slice(size, size, &self.matrix);
        let a = DMatrix::from_row_slice(size, size, reaction);
        let Some(root) = p.clone().cholesky().map(|factors| factors.l()) else {
            return 0.0;
        };
        let symmetric = -0.5 * (&p * &a + (&p * &a).transpose());
        // L^-1 S L^-T has the eigenvalues of S in the scalar product of P = L L^T.
        let half = root.solve_lower_triangular(&symmetric);
        let whole = half.and_then(|half| root.solve_lower_triangular(&half.transpose()));
        let eigenvalues = whole.map(|whole| whole.symmetric_eigenvalues());
        eigenvalues.map_or(0.0, |eigenvalues| eigenvalues.max())
    }
}

/// The matrices, where they are what they should be.
fn checked(matrices: &[Vec<f64>]) -> Result<Vec<DMatrix<f64>>, SymmetriserError> {
    let p = matrices.first().map_or(0, |first| first.len().isqrt());
    let misfit = matrices.iter().position(|a| a.len() != p * p);
    if misfit.is_some() || p == 0 || matrices.len() > 3 {
        let matrix = misfit.unwrap_or(0);
        return Err(SymmetriserError::Shape {
            count: matrices.len(),
            matrix,
            entries: matrices.get(matrix).map_or(0, Vec::len),
        });
    }
    for (matrix, entries) in matrices.iter().enumerate() {
        if let Some(place) = entries.iter().position(|x| !x.is_finite()) {
            return Err(SymmetriserError::NotFinite {
                matrix,
                row: place / p,
                column: place % p,
                value: entries[place],
            });
        }
    }
    let matrix = |entries: &Vec<f64>| DMatrix::from_row_slice(p, p, entries);
    Ok(matrices.iter().map(matrix).collect())
}

/// Whether all `P A` are symmetric, for matrices of size one.
fn symmetrises(p: &DMatrix<f64>, matrices: &[DMatrix<f64>]) -> bool {
    let off = |a: &DMatrix<f64>| (p * a - (p * a).transpose()).norm();
    matrices.iter().all(|a| off(a) <= 1e-8 * p.norm())
}

/// A bound of `|λ|` for all `n·A`: with `P = L L^T` the `L^T A^i L^-T` are symmetric, the
/// largest `|λ|` is a norm in n, and between directions it exceeds its values in them by no more
/// than [`Directions::margin`].
fn speed(matrices: &[DMatrix<f64>], p: &DMatrix<f64>, directions: &Directions) -> f64 {
    let Some(cholesky) = p.clone().cholesky() else {
        return f64::NAN;
    };
    let lower = cholesky.l();
    let symmetric: Vec<DMatrix<f64>> = matrices
        .iter()
        // L^T A L^-T = (L^-1 (L^T A)^T)^T.
        .filter_map(|a| lower.solve_lower_triangular(&(lower.transpose() * a).transpose()))
        .map(|a| 0.5 * (&a + a.transpose()))
        .collect();
    let fastest = |n: &Vec<f64>| along(n, &symmetric).symmetric_eigenvalues().amax();
    directions.margin * directions.all.iter().map(fastest).fold(0.0, f64::max)
}
