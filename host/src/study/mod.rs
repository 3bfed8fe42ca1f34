//! A convergence study: one problem at several resolutions, the order at which its error falls,
//! and what Theorem 2 says of that order.
//!
//! Knows no equation: [`Study::run`] is given a closure that makes one level.

mod fit;
mod ladder;
mod level;
mod subject;
#[cfg(test)]
mod tests;
mod theory;

pub use fit::{PowerLaw, order};
pub use ladder::{coarsest, ladder};
pub use level::level;
pub use subject::Subject;
pub use theory::Theory;

/// One resolution and what came out.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Level {
    /// Number of particles.
    pub n: usize,
    /// Mean spacing at the start, `(volume/n)^(1/D)`.
    pub h: f64,
    /// Mean width of the cut-off at the end.
    pub eps: f64,
    /// Mean of the error over the volume.
    pub l1: f64,
    /// Root of the mean square over the volume.
    pub l2: f64,
    /// Largest.
    pub linf: f64,
}

/// The norm of which the order is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorNorm {
    /// [`Level::l1`].
    L1,
    /// [`Level::l2`]: the norm of the theorems.
    L2,
    /// [`Level::linf`].
    Linf,
}

impl ErrorNorm {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::L1, Self::L2, Self::Linf];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::L1 => "l1",
            Self::L2 => "l2",
            Self::Linf => "linf",
        }
    }

    /// The norm of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|norm| norm.name() == name)
    }
}

impl Level {
    /// The error in that norm.
    pub fn error(&self, norm: ErrorNorm) -> f64 {
        match norm {
            ErrorNorm::L1 => self.l1,
            ErrorNorm::L2 => self.l2,
            ErrorNorm::Linf => self.linf,
        }
    }
}

/// The local order below which an error has stopped falling, where none is predicted. A shock
/// alone gives 0.5 in L2.
const STALLED: f64 = 0.25;

/// One problem at several resolutions.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// The coarsest first.
    pub levels: Vec<Level>,
    /// The norm of the orders.
    pub norm: ErrorNorm,
    /// What the theorem promises; `None` where none applies.
    pub theory: Option<Theory>,
}

impl Study {
    /// Makes a level of each number of particles, in their order.
    ///
    /// # Errors
    /// The first that `level` returns.
    pub fn run<E>(
        counts: &[usize],
        norm: ErrorNorm,
        theory: Option<Theory>,
        level: impl FnMut(usize) -> Result<Level, E>,
    ) -> Result<Self, E> {
        let levels = counts.iter().copied().map(level);
        Ok(Self {
            levels: levels.collect::<Result<_, E>>()?,
            norm,
            theory,
        })
    }

    /// Spacing and error of each level.
    fn errors(&self) -> Vec<(f64, f64)> {
        let error = |level: &Level| (level.h, level.error(self.norm));
        self.levels.iter().map(error).collect()
    }

    /// `error = factor h^exponent`, by least squares of the logarithms; `None` where an error is
    /// 0 or not finite, or all spacings are equal.
    pub fn fit(&self) -> Option<PowerLaw> {
        PowerLaw::fit(&self.errors())
    }

    /// `eps = C h^theta` as it was in the runs.
    pub fn width(&self) -> Option<PowerLaw> {
        let widths: Vec<_> = self
            .levels
            .iter()
            .map(|level| (level.h, level.eps))
            .collect();
        PowerLaw::fit(&widths)
    }

    /// The order from each level to the next: one fewer than levels.
    pub fn orders(&self) -> Vec<Option<f64>> {
        let exponent = |pair: &[(f64, f64)]| PowerLaw::fit(pair).map(|law| law.exponent);
        self.errors().windows(2).map(exponent).collect()
    }

    /// What a careful reader should know.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        let count = self.levels.len();
        if count < 3 {
            warnings.push(format!(
                "an order from {count} levels cannot be told from chance: use 3 or more"
            ));
        }
        if self.fit().is_none() {
            warnings.push(
                "there is no order: an error is 0 or not finite, or all levels have the same \
                 spacing"
                    .to_owned(),
            );
        }
        warnings.extend(self.theory.and_then(|theory| theory.warning()));
        warnings.extend(self.stall());
        warnings
    }

    /// A warning where the error of the finest pair hardly falls.
    fn stall(&self) -> Option<String> {
        let order = (*self.orders().last()?)?;
        let [.., before, last] = &self.levels[..] else {
            return None;
        };
        let pair = format!(
            "from n = {} to {} the order is {order:.2}",
            before.n, last.n
        );
        let Some(theory) = &self.theory else {
            return (order < STALLED).then(|| {
                format!(
                    "{pair}: the error has stopped falling; where eps/h is constant the sums have \
                     a part that does not fall with h (take theta < 1), and so has rounding"
                )
            });
        };
        let predicted = theory.predicted_order();
        (order < 0.5 * predicted).then(|| {
            format!(
                "{pair}, less than half of {predicted:.2}: the quadrature term \
                 h^m/eps^(m+s) governs; a smaller theta, a larger eps or a smoother cut-off lower it"
            )
        })
    }
}
