//! A gas as a [`Dynamics`]: by leap-frog, alone or with open sides.

use crate::cloud::Words;
use crate::cutoff::CutOff;
use crate::equation::gas::{
    Cloud, Gas, GasDynamics, Opening, Particle, Physics, Viscosity, Workspace, Zone,
};
use crate::equation::{Dynamics, Parts, Step, Storage};
use crate::error::{Error, Parameter};
use crate::material::EquationOfState;
use crate::pairs::Engine;
use crate::scalar::Scalar;

/// The leap-frog: the method of a gas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LeapFrog;

impl<S, C, V, E, P, const D: usize> Dynamics<S, D> for GasDynamics<'_, S, C, V, E, P, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    type Method = LeapFrog;
    type State<'a> = Gas<'a, S, D>;
    type Work<'a> = Workspace<'a, S, P::Shown, D>;
    type Particle = Particle<S, D>;

    fn prepare<N: Engine<S, D>>(
        &self,
        engine: &mut N,
        parts: &mut Parts<'_, S, Self, D>,
    ) -> Result<(), Error> {
        self.prepare(engine, &mut parts.state, &mut parts.work)
    }

    fn pass(&self, parts: &mut Parts<'_, S, Self, D>, words: &mut dyn Words) -> Result<(), Error> {
        if words.fills() {
            *parts.work.grid = None;
        }
        words.columns(&mut parts.state)
    }

    fn stable_step(
        &self,
        _: &LeapFrog,
        parts: &Parts<'_, S, Self, D>,
        _: S,
        longest: S,
    ) -> Result<S, Error> {
        self.time_step(&parts.state, longest)
    }

    fn ready(&self, _: Step<S>) -> Result<(), Error> {
        let acceleration = self.physics.plain().acceleration;
        if !acceleration.iter().all(|component| component.is_finite()) {
            return Err(Error::Parameter {
                parameter: Parameter::Acceleration,
            });
        }
        match self.physics.no_slip().invalid() {
            None => Ok(()),
            Some((axis, end)) => Err(Error::Parameter {
                parameter: Parameter::Wall {
                    axis: axis as u8,
                    end: end as u8,
                },
            }),
        }
    }

    fn advance<N: Engine<S, D>>(
        &self,
        _: &LeapFrog,
        engine: &mut N,
        parts: &mut Parts<'_, S, Self, D>,
        step: Step<S>,
    ) -> Result<u32, Error> {
        self.advance(engine, &mut parts.state, &mut parts.work, step.dt)?;
        Ok(1)
    }
}

/// A gas that comes in and goes out through the sides of one direction.
#[derive(Clone, Copy, Debug)]
pub struct OpenGas<'a, Y, S, const D: usize> {
    /// The gas.
    pub gas: Y,
    /// The sides.
    pub opening: Opening<'a, S, D>,
}

impl<S, C, V, E, P, const D: usize> Dynamics<S, D>
    for OpenGas<'_, GasDynamics<'_, S, C, V, E, P, D>, S, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    type Method = LeapFrog;
    type State<'a> = Gas<'a, S, D>;
    type Work<'a> = Workspace<'a, S, P::Shown, D>;
    type Particle = Particle<S, D>;

    fn prepare<N: Engine<S, D>>(
        &self,
        engine: &mut N,
        parts: &mut Parts<'_, S, Self, D>,
    ) -> Result<(), Error> {
        self.gas.prepare(engine, &mut parts.state, &mut parts.work)
    }

    fn pass(&self, parts: &mut Parts<'_, S, Self, D>, words: &mut dyn Words) -> Result<(), Error> {
        if words.fills() {
            *parts.work.grid = None;
        }
        words.columns(&mut parts.state)
    }

    fn stable_step(
        &self,
        _: &LeapFrog,
        parts: &Parts<'_, S, Self, D>,
        _: S,
        longest: S,
    ) -> Result<S, Error> {
        self.gas.time_step(&parts.state, longest)
    }

    fn ready(&self, step: Step<S>) -> Result<(), Error> {
        for zone in &self.opening.zones {
            let (Zone::Inflow(inflow) | Zone::Reservoir(inflow, _)) = zone else {
                continue;
            };
            let particle = &inflow.particle;
            let numbers = [inflow.density, particle.energy, particle.mass];
            let mut all = numbers.iter().chain(&particle.velocity);
            if !all.all(|number| number.is_finite()) {
                return Err(Error::Parameter {
                    parameter: Parameter::Inflow,
                });
            }
        }
        Dynamics::ready(&self.gas, step)
    }

    fn advance<N: Engine<S, D>>(
        &self,
        _: &LeapFrog,
        engine: &mut N,
        parts: &mut Parts<'_, S, Self, D>,
        step: Step<S>,
    ) -> Result<u32, Error> {
        self.gas
            .advance(engine, &mut parts.state, &mut parts.work, step.dt)?;
        Ok(1)
    }

    fn exchange<M: Storage<S, Self, D>>(&self, storage: &mut M) -> Result<(), Error> {
        let mut cloud = Stored {
            storage,
            of: core::marker::PhantomData::<fn(&Self)>,
        };
        self.opening.exchange(&self.gas.domain, &mut cloud)
    }
}

/// A storage as a cloud that particles come to and go from.
struct Stored<'a, M, Y> {
    storage: &'a mut M,
    of: core::marker::PhantomData<fn(&Y)>,
}

impl<S, Y, M, const D: usize> Cloud<S, D> for Stored<'_, M, Y>
where
    S: Scalar,
    Y: for<'a> Dynamics<S, D, State<'a> = Gas<'a, S, D>, Particle = Particle<S, D>>,
    M: Storage<S, Y, D>,
{
    fn gas(&mut self) -> Gas<'_, S, D> {
        self.storage.parts().state
    }

    fn insert(&mut self, particle: Particle<S, D>, density: S) -> Result<(), Error> {
        self.storage.insert(particle)?;
        if let Some(last) = self.gas().density.last_mut() {
            *last = density;
        }
        Ok(())
    }

    fn swap_remove(&mut self, id: usize) {
        self.storage.swap_remove(id);
    }
}
