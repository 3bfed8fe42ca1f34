//! The solver of a linear system: what it is made of, and its stable time step.

use crate::cutoff::{CutOff, slope};
use crate::domain::Domain;
use crate::equation::check_courant;
use crate::error::{Error, Quantity};
use crate::pairs::holds;
use crate::scalar::Scalar;

use super::system::FirstOrderSystem;
use crate::cloud::Place;
use crate::cloud::State;
use crate::cloud::VelocityField;

/// A linear system and how it is solved. All quantities in solver units: mean spacing and
/// fastest wave are of order 1.
#[derive(Clone, Copy, Debug)]
pub struct LinearDynamics<S, C, F, A, const D: usize, const P: usize> {
    /// Where the cloud is.
    pub domain: Domain<S, D>,
    /// ζ.
    pub cut_off: C,
    /// ε, the same for all particles and all times.
    pub epsilon: S,
    /// The system.
    pub system: F,
    /// What the particles follow.
    pub field: A,
    /// The factor of the stable time step, in (0, 1].
    pub courant: S,
    /// `κ = ∫ |∂_1 ζ| dx`, see [`LinearDynamics::new`].
    pub slope: S,
}

/// What a time integrator stays stable in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// The largest `|λ dt|` on the imaginary axis: waves.
    pub imaginary: f64,
    /// The largest `-λ dt` on the real axis: decay.
    pub real: f64,
}

impl<S, C, F, A, const D: usize, const P: usize> LinearDynamics<S, C, F, A, D, P>
where
    S: Scalar,
    C: CutOff,
    F: FirstOrderSystem<S, D, P>,
    A: VelocityField<S, D>,
{
    /// A solver; makes `κ = ∫ |∂_1 ζ| dx` of its cut-off.
    pub fn new(
        domain: Domain<S, D>,
        (cut_off, epsilon): (C, S),
        system: F,
        field: A,
        courant: S,
    ) -> Self {
        Self {
            domain,
            cut_off,
            epsilon,
            system,
            field,
            courant,
            slope: S::from_f64(slope::<C, D>(cut_off)),
        }
    }

    /// The largest stable step from here: `min(L_i, L_r) / Λ`, and `None` where nothing bounds it.
    ///
    /// `Λ = κ ρ/ε + |A⁰|` bounds the spectral radius of the right-hand side of (1.18): on a dense
    /// cloud a wave of wave vector `ξ` sees `Σ_i B^i i ξ_i ζ̂(εξ)`, of radius at most `ρ(B) κ/ε`,
    /// `ρ(B) <= |v - a| + ` the wave speed of the coupling.
    ///
    /// Error: a bound that the format does not hold.
    pub fn stable_step(
        &self,
        state: &State<'_, S, D, P>,
        time: S,
        stability: Stability,
    ) -> Result<Option<S>, Error> {
        let mut fastest = S::ZERO;
        for &position in state.position.iter() {
            let place = Place { position, time };
            let drift = self.drift(&place, &self.field.velocity(&place));
            let coupling = self.system.speed(&self.system.medium(&place));
            let drift = S::length_squared(&drift).sqrt();
            fastest = fastest.greater(coupling + drift);
        }
        let damping = self.system.damping();
        let bound = self.slope.to_f64() * fastest.to_f64();
        let bound = bound.max(bound / self.epsilon.to_f64() + damping.to_f64());
        holds::<S>(Quantity::Stability, 0, bound)?;
        let radius = (self.slope * fastest) / self.epsilon + damping;
        let limit = S::from_f64(if stability.imaginary < stability.real {
            stability.imaginary
        } else {
            stability.real
        });
        Ok((radius > S::ZERO).then(|| limit / radius))
    }

    /// The step to make: [`LinearDynamics::courant`] times the stable one, at most an eighth of
    /// that over `|∇a|` (so that the characteristics are followed as well), at most `longest`.
    pub fn time_step(
        &self,
        state: &State<'_, S, D, P>,
        time: S,
        stability: Stability,
        longest: S,
    ) -> Result<S, Error> {
        check_courant(self.courant)?;
        let mut step = longest;
        if let Some(stable) = self.stable_step(state, time, stability)? {
            step = step.lesser(self.courant * stable);
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

    /// `v - a`.
    #[inline(always)]
    pub(super) fn drift(&self, place: &Place<S, D>, follows: &[S; D]) -> [S; D] {
        let mut drift = self.system.velocity(place);
        for (drift, &a) in drift.iter_mut().zip(follows) {
            *drift -= a;
        }
        drift
    }

    /// `u·Pu` of a state at a place: `Σ w u·Pu` is the square of the energy norm.
    pub fn energy_density(&self, place: &Place<S, D>, u: &[S; P]) -> S {
        let medium = self.system.medium(place);
        S::dot(u, &self.system.symmetrised(&medium, u))
    }

    /// How far a particle acts. The 1/64 is more than any rounding of `|r|/ε`, so that a pair
    /// beyond it contributes exactly 0.
    pub(super) fn reach(&self) -> S {
        let reach = S::count(self.cut_off.support()) * self.epsilon;
        reach + reach * S::from_f64(1.0 / 64.0)
    }
}
