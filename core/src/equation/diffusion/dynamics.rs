//! The solver of a convection-diffusion problem: what it is made of, and its stable time step.

use super::mean::Mean;
use super::problem::DiffusionProblem;
use super::storage::DiffusionWorkspace;
use crate::cloud::{State, VelocityField};
use crate::cutoff::{CutOff, slope};
use crate::domain::Domain;
use crate::equation::check_courant;
use crate::error::{Error, Quantity};
use crate::numbered::numbered;
use crate::pairs::holds;
use crate::scalar::Scalar;

/// Which form.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// (4.6): one sum over pairs.
    #[default]
    Direct,
    /// (4.3): flux and divergence, two sums. Conserves energy better and sees waves of two
    /// spacings not at all.
    Mixed,
}

/// A convection-diffusion problem and how it is solved, in solver units: mean spacing 1.
#[derive(Clone, Copy, Debug)]
pub struct DiffusionDynamics<S, C, B, A, const D: usize, const P: usize> {
    /// Where the cloud is.
    pub domain: Domain<S, D>,
    /// ζ.
    pub cut_off: C,
    /// ε, the same for all particles and all times.
    pub epsilon: S,
    /// The problem.
    pub problem: B,
    /// What the particles follow: the `a` of the equation.
    pub field: A,
    /// Direct or mixed.
    pub form: Form,
    /// Of the direct form.
    pub mean: Mean,
    /// The factor of the stable time step, in (0, 1].
    pub courant: S,
}

impl<S, C, B, A, const D: usize, const P: usize> DiffusionDynamics<S, C, B, A, D, P>
where
    S: Scalar,
    C: CutOff,
    B: DiffusionProblem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// A bound `Λ` of the spectral radius of the right-hand side, of a state whose rates have just
    /// been made: no explicit method needs more.
    ///
    /// Direct form: Gershgorin's circles, `2 max_k Σ_(l≠k) w_l (b_k + b_l) |bracket_kl|`. Mixed
    /// form: `max b (κ/ε)²`, `κ = ∫ |∂_1 ζ| dx`, times the trace of the tensor, and what walls
    /// exchange, and of the share of the direct form its circles. Times what `b` may yet grow by; to it comes the bound of the reactions.
    ///
    /// Error: a bound that the format does not hold. One that had wrapped would bound nothing.
    pub fn radius(
        &self,
        state: &State<'_, S, D, P>,
        work: &DiffusionWorkspace<'_, S, D, P>,
    ) -> Result<S, Error> {
        if let Some(radius) = *work.radius {
            return Ok(radius);
        }
        let n = state.len();
        let mut particle = 0;
        let largest = match self.form {
            Form::Direct => {
                let sums = work.sums.get(..n).unwrap_or(&[]);
                let circles = sums.iter().map(|settled| settled.sums.radius);
                let widest = numbered(circles).reduce(|a, b| if b.1 > a.1 { b } else { a });
                let (place, widest) = widest.unwrap_or((0, S::ZERO));
                particle = work.cells.order.get(place).copied().unwrap_or(0);
                let bound = 2.0 * widest.to_f64();
                holds::<S>(Quantity::Stability, particle, bound)?;
                widest + widest
            }
            Form::Mixed => {
                let nodes = work.nodes.get(..n).unwrap_or(&[]);
                let all = nodes.iter().flat_map(|node| node.diffusivity);
                let conductor = all.reduce(Scalar::greater).unwrap_or(S::ZERO);
                let kappa = S::from_f64(slope::<C, D>(self.cut_off));
                let walls = self.walls(*work.time);
                let mut exchanged = S::ZERO;
                for node in nodes {
                    // Two walls that are near add up.
                    let mut sums = [S::ZERO; P];
                    self.at_exchanges(&walls, &work.ledger.shares, node, |_, j, (factor, _)| {
                        if let Some(sum) = sums.get_mut(j) {
                            *sum += factor;
                        }
                    });
                    exchanged = sums.into_iter().fold(exchanged, Scalar::greater);
                }
                let kappa = kappa * work.ledger.conduction;
                let squared = kappa.to_f64() * kappa.to_f64();
                let stretch = self.stretch();
                let bound = conductor.to_f64() * squared * stretch.to_f64().max(1.0);
                let shared = work.mixed.sums.get(..n).unwrap_or(&[]);
                let circles = shared.iter().map(|settled| settled.sums.radius);
                let widest = circles.reduce(Scalar::greater).unwrap_or(S::ZERO);
                let bound = bound + exchanged.to_f64() + 2.0 * widest.to_f64();
                holds::<S>(Quantity::Stability, particle, bound)?;
                conductor * (kappa * kappa) * stretch + exchanged + (widest + widest)
            }
        };
        let headroom = self.problem.headroom(*work.time);
        let bound = largest.to_f64() * headroom.to_f64();
        holds::<S>(Quantity::Stability, particle, bound)?;
        let largest = largest * headroom;
        let (pairs, reactions) = (
            largest / self.epsilon / self.epsilon,
            self.problem.reaction_rate(),
        );
        let bound = pairs.to_f64() + reactions.to_f64();
        holds::<S>(Quantity::Stability, particle, bound)?;
        let radius = pairs + reactions;
        match radius < S::ZERO {
            // A sum of circles that has wrapped all the same.
            true => holds::<S>(Quantity::Stability, particle, f64::INFINITY).map(|()| radius),
            false => Ok(radius),
        }
    }

    /// A bound of the eigenvalues of the tensor: its trace.
    fn stretch(&self) -> S {
        let Some(tensor) = self.problem.tensor() else {
            return S::ONE;
        };
        let rows = numbered(tensor);
        let diagonal = rows.filter_map(|(i, row)| row.get(i).copied());
        diagonal.fold(S::ZERO, |trace, t| trace + t)
    }

    /// The step to make: `courant reach / Λ`, where an explicit method is stable up to `λ dt =
    /// -reach`; at most an eighth of `courant / |∇a|`, and at most `longest`.
    pub fn time_step(&self, radius: S, reach: S, longest: S) -> Result<S, Error> {
        check_courant(self.courant)?;
        let mut step = longest;
        if radius > S::ZERO {
            step = step.lesser(self.courant * (reach / radius));
        }
        let gradient = self.field.gradient();
        if gradient > S::ZERO {
            step = step.lesser((self.courant / S::count(8)) / gradient);
        }
        if step > S::ZERO {
            Ok(step)
        } else {
            Err(Error::NotFinite {
                particle: 0,
                quantity: Quantity::TimeStep,
            })
        }
    }

    /// How far a particle acts: a little more than the support, so that a pair beyond it
    /// contributes exactly 0.
    pub fn reach(&self) -> S {
        let reach = S::count(self.cut_off.support()) * self.epsilon;
        reach + reach * S::from_f64(1.0 / 64.0)
    }
}
