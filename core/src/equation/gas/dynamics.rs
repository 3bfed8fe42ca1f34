//! The gas solver: what it is made of, its stable time step, and the order of its sums.

use crate::cutoff::CutOff;
use crate::domain::Domain;
use crate::equation::check_courant;
use crate::error::{Error, Quantity};
use crate::material::EquationOfState;
use crate::numbered::numbered;
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::density::Width;
use super::options::Weights;
use super::physics::Physics;
use super::state::{Gas, Row};
use super::storage::Workspace;
use super::viscosity::Viscosity;

/// A gas and how it is solved. All quantities in solver units: mean spacing, reference
/// density and reference sound speed are of order 1.
#[derive(Clone, Copy, Debug)]
pub struct GasDynamics<'a, S, C, V, E, P, const D: usize> {
    /// Where the gas is.
    pub domain: Domain<S, D>,
    /// ζ.
    pub cut_off: C,
    /// ε.
    pub width: Width<S>,
    /// Π and q.
    pub viscosity: V,
    /// p(ρ, e) of each material; particles name theirs by its place here.
    pub materials: &'a [E],
    /// Which law: [`Plain`](super::Plain), or [`Options`](super::Options) for more than the
    /// paper's equations.
    pub physics: P,
    /// The factor of the stable time step, in (0, 1].
    pub courant: S,
    /// The smallest Ω that is accepted.
    pub smallest_omega: S,
}

impl<S, C, V, E, P, const D: usize> GasDynamics<'_, S, C, V, E, P, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    /// Makes the densities and rates of a state whose positions, velocities, energies and
    /// expected ε have been set. Must run once before the first step.
    pub fn prepare(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, P::Shown, D>,
    ) -> Result<(), Error> {
        if !gas.is_consistent() {
            return Err(Error::Lengths);
        }
        let known = |&material: &u8| usize::from(material) < self.materials.len();
        if let Some(particle) = gas.material.iter().position(|material| !known(material)) {
            let particle = particle as u32;
            return Err(Error::Material { particle });
        }
        gas.position_remainder.fill([S::ZERO; D]);
        gas.velocity_remainder.fill([S::ZERO; D]);
        gas.force.fill([S::ZERO; D]);
        gas.power.fill(S::ZERO);
        gas.heat.fill(S::ZERO);
        gas.power_slope.fill(S::ZERO);
        gas.divergence.fill(S::ZERO);
        gas.approach.fill(S::ZERO);
        gas.signal.fill(S::ZERO);
        gas.viscosity_factor.fill(S::ZERO);
        self.rates(engine, gas, work, S::ZERO)
    }

    /// The stable time step `C min_k ε_k/signal_k` of a state that has been prepared, or
    /// `longest` if that is shorter. Error: a [`GasDynamics::courant`] out of its range.
    ///
    /// The signal speed of a particle is the largest of that of its viscosity
    /// ([`Viscosity::signal`]), to which `8 d/ε` of its physical diffusivity d is added
    /// ([`super::stress`]), and of `√(ε |a|)`, `|a|` the largest component of its acceleration.
    ///
    /// The sound speed in it is `max(c_k, max_l c_l ν_k/ν_l √(m_l/m_k)/√2)`. A particle that moves
    /// against its partners compresses them: with `ν_l` the sum of measures of partner l,
    /// `∂ν_l/∂x_k = μ_k ∇ζ_kl(ε_l)`, the diagonal of the stiffness matrix is
    /// `m_k ω_k² = Σ_l m_l c_l² (μ_k/ν_l)² |∇ζ_kl(ε_l)|²`, beside the `m_k c_k² (μ_k/ν_k)² |∇ζ_kl(ε_k)|²`
    /// of a gas of its own kind. A light particle beside stiff, heavy ones is bounded by them. The
    /// half is what the courant number allows beyond (see `core/tests/rest.rs`): in a gas of one
    /// kind the bound is that of its own sound.
    ///
    /// A step is rounded down to five binary digits. Sound of small amplitude then goes by steps of
    /// one length, and keeps its energy as the leap-frog does; steps that follow it from moment to
    /// moment would feed it.
    pub fn time_step(&self, gas: &Gas<'_, S, D>, longest: S) -> Result<S, Error> {
        check_courant(self.courant)?;
        let mut smallest = longest;
        for (particle, (&epsilon, &signal)) in numbered(gas.epsilon.iter().zip(gas.signal.iter())) {
            // A gas without sound and motion bounds nothing.
            if signal > S::ZERO {
                let step = self.courant * (epsilon / signal);
                if !(step > S::ZERO) {
                    let quantity = Quantity::TimeStep;
                    return Err(Error::NotFinite {
                        particle: particle as u32,
                        quantity,
                    });
                }
                smallest = smallest.lesser(step);
            }
        }
        Ok(match smallest < longest {
            true => coarse(smallest),
            false => longest,
        })
    }

    /// The measure μ of a particle of that mass.
    #[inline(always)]
    pub(super) fn measure(&self, mass: S) -> S {
        match self.physics.plain().weights {
            Weights::Mass => mass,
            Weights::Number => S::ONE,
        }
    }

    /// The density ρ where the sum of measures is ν.
    #[inline(always)]
    pub(super) fn density(&self, mass: S, sum: S) -> S {
        match self.physics.plain().weights {
            Weights::Mass => sum,
            Weights::Number => mass * sum,
        }
    }

    /// Pressure and sound speed of a particle's material; 0 without one.
    #[inline(always)]
    pub(super) fn pressure(&self, material: u8, density: S, energy: S) -> (S, S) {
        match self.materials.get(usize::from(material)) {
            Some(law) => (
                law.pressure(density, energy),
                law.sound_speed(density, energy),
            ),
            None => (S::ZERO, S::ZERO),
        }
    }

    /// The pair forces on a particle and its share of the external ones.
    #[inline(always)]
    pub(super) fn with_external(&self, mass: S, mut force: [S; D]) -> [S; D] {
        for (component, &acceleration) in force.iter_mut().zip(&self.physics.plain().acceleration) {
            *component += mass * acceleration;
        }
        force
    }

    /// The speed that bounds the time step of a particle whose force is final.
    #[inline(always)]
    pub(super) fn signal(
        &self,
        row: &Row<'_, S, D>,
        sound_speed: S,
        approach: S,
        diffusivity: S,
    ) -> S {
        let spread = S::count(8) * (diffusivity / *row.epsilon);
        let mut force = S::ZERO;
        for &component in row.force.iter() {
            force = force.greater(component.abs());
        }
        let pushed = (*row.epsilon * (force / row.mass)).sqrt();
        (self.viscosity.signal(sound_speed, approach) + spread).greater(pushed)
    }

    /// The first thing wrong with a particle.
    #[inline(always)]
    pub(super) fn problem(&self, row: &Row<'_, S, D>, id: u32) -> Option<Error> {
        let law = self.materials.get(usize::from(row.material));
        row.problem(id, law.is_some_and(E::feels_energy))
    }
}

/// A finite step > 0 rounded down to five binary digits; itself where the scalar has no more.
fn coarse<S: Scalar>(step: S) -> S {
    let mut first = S::ONE;
    while first > step {
        first = first.half();
    }
    while first <= step.half() {
        first += first;
    }
    let digit = first.half().half().half().half();
    if !(digit > S::ZERO) {
        return step;
    }
    let mut result = first;
    while result <= step - digit {
        result += digit;
    }
    result
}

/// The error of the particle with the lowest id: the same one whatever the order of search.
#[derive(Default)]
pub(super) struct Lowest(Option<(u32, Error)>);

impl Lowest {
    #[inline(always)]
    pub(super) fn add(&mut self, id: u32, error: Option<Error>) {
        if let Some(error) = error
            && self.0.is_none_or(|(lowest, _)| id < lowest)
        {
            self.0 = Some((id, error));
        }
    }

    pub(super) fn result(self) -> Result<(), Error> {
        self.0.map_or(Ok(()), |(_, error)| Err(error))
    }
}
