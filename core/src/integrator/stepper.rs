//! A run that can be held, stepped and looked into: the same on a device and on a server.

use crate::cloud::Words;
use crate::equation::{Dynamics, Parts, Step, Storage};
use crate::error::Error;
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::Clock;

/// An equation, a method, an engine, the memory of a cloud and a clock: a run.
///
/// ```
/// # use motes_core::{cutoff::QuinticSpline, domain::{Axis, Domain}, error::Error};
/// # use motes_core::equation::linear::{LinearDynamics, LinearStorage, Particle, Still};
/// # use motes_core::equation::linear::systems::{Acoustics, Units};
/// # use motes_core::integrator::{RK4, Stepper};
/// # use motes_core::neighbours::cell_bound;
/// # use motes_core::pairs::{HalfLoop, Nothing};
/// const N: usize = 64;
/// const CELLS: usize = cell_bound(N as u32) as usize + 1;
/// let mut storage = LinearStorage::<f32, Nothing, 1, 2, N, CELLS>::new();
/// for k in 0..N {
///     let pressure = if k < N / 2 { 1.0 } else { 0.0 };
///     storage.push(Particle { position: [k as f32 + 0.5], weight: 1.0, value: [pressure, 0.0] })?;
/// }
/// let domain = Domain { axes: [Axis::periodic(0.0, N as f32)] };
/// let sound = Acoustics::new(1.0, 1.0, Units::ONE);
/// let dynamics = LinearDynamics::new(domain, (QuinticSpline, 1.5), sound, Still, 0.5);
/// let mut line = Stepper::new(dynamics, RK4, HalfLoop, storage)?;
/// line.advance_to(10.0)?;
/// let pressure = line.state().value[3][0];
/// # assert!(pressure > 0.2 && pressure < 0.8, "{pressure}");
/// # Ok::<(), Error>(())
/// ```
///
/// On an error the state is the last good one, and the run may go on when the cause is gone.
#[derive(Clone, Copy, Debug)]
pub struct Stepper<S, Y: Dynamics<S, D>, E, M, const D: usize>
where
    S: Scalar,
{
    /// The equation; what a control loop sets between steps lies in it.
    pub dynamics: Y,
    /// How time goes on.
    pub method: Y::Method,
    /// The length of a step where it is given; the stable one where it is `None`.
    pub step: Option<S>,
    engine: E,
    storage: M,
    clock: Clock<S>,
    evaluations: u64,
    stale: bool,
}

impl<S, Y, E, M, const D: usize> Stepper<S, Y, E, M, D>
where
    S: Scalar,
    Y: Dynamics<S, D>,
    E: Engine<S, D>,
    M: Storage<S, Y, D>,
{
    /// A run without an end, at time 0, of the particles that lie in the storage.
    pub fn new(dynamics: Y, method: Y::Method, engine: E, storage: M) -> Result<Self, Error> {
        let mut stepper = Self::resumed(dynamics, method, engine, storage);
        let Self {
            dynamics,
            engine,
            storage,
            ..
        } = &mut stepper;
        dynamics.prepare(engine, &mut storage.parts())?;
        stepper.stale = false;
        Ok(stepper)
    }

    /// A run that goes on from the state in the storage, which was prepared before.
    pub fn resumed(dynamics: Y, method: Y::Method, engine: E, storage: M) -> Self {
        Self {
            dynamics,
            method,
            step: None,
            engine,
            storage,
            clock: Clock::endless(),
            evaluations: 0,
            stale: true,
        }
    }

    /// The same, ending at that time.
    pub fn until(mut self, end: S) -> Self {
        self.clock.end = end;
        self
    }

    /// Where the run is.
    pub fn clock(&self) -> &Clock<S> {
        &self.clock
    }

    /// Sets the clock, which moves nothing: what drives a wall or a coefficient goes on from there.
    pub fn set_time(&mut self, time: S) {
        self.clock.time = time;
    }

    /// How many right-hand sides have been made.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// The state. What is written to it is what the next step starts from.
    pub fn state(&mut self) -> Y::State<'_> {
        self.storage.parts().state
    }

    /// The state and what a step works in.
    pub fn parts(&mut self) -> Parts<'_, S, Y, D> {
        self.storage.parts()
    }

    /// Adds a particle. Error: no room.
    pub fn insert(&mut self, particle: Y::Particle) -> Result<(), Error> {
        self.stale = true;
        self.storage.insert(particle)
    }

    /// Removes a particle; the last one gets its id.
    pub fn swap_remove(&mut self, id: usize) {
        self.stale = true;
        self.storage.swap_remove(id);
    }

    /// Passes the run: saves where it is, or makes it the one that was saved, of the same equation and as
    /// many particles. It goes on with the bits that it would have had.
    ///
    /// ```
    /// # use motes_core::{cloud::{Remaining, Save}, cutoff::QuinticSpline, domain::{Axis, Domain}, error::Error};
    /// # use motes_core::equation::linear::{LinearDynamics, LinearStorage, Particle, Still};
    /// # use motes_core::equation::linear::systems::{Acoustics, Units};
    /// # use motes_core::{integrator::{RK4, Stepper}, neighbours::cell_bound, pairs::{HalfLoop, Nothing}};
    /// # const N: usize = 16;
    /// # const CELLS: usize = cell_bound(N as u32) as usize + 1;
    /// # let mut storage = LinearStorage::<f32, Nothing, 1, 2, N, CELLS>::new();
    /// # for k in 0..N {
    /// #     storage.push(Particle { position: [k as f32 + 0.5], weight: 1.0, value: [k as f32, 0.0] })?;
    /// # }
    /// # let domain = Domain { axes: [Axis::periodic(0.0, N as f32)] };
    /// # let sound = Acoustics::new(1.0, 1.0, Units::ONE);
    /// # let dynamics = LinearDynamics::new(domain, (QuinticSpline, 1.5), sound, Still, 0.5);
    /// # let mut line = Stepper::new(dynamics, RK4, HalfLoop, storage)?;
    /// line.advance_to(1.0)?;
    /// let (mut memory, mut used) = ([0u8; 1024], 0);
    /// line.pass(&mut Save(|bytes: &[u8]| {
    ///     let room = memory.get_mut(used..used + bytes.len()).ok_or(Error::Truncated)?;
    ///     room.copy_from_slice(bytes);
    ///     used += bytes.len();
    ///     Ok(())
    /// }))?;
    /// line.advance_to(2.0)?;
    /// let there = line.state().digest();
    /// line.pass(&mut Remaining(&memory[..used]))?;
    /// line.advance_to(2.0)?;
    /// assert_eq!(line.state().digest(), there);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// Errors: those of [`Words`]. Of what is read neither the clock nor the state is to be used then; a
    /// memory that may lose bits is checked first, by [`crate::digest::Digester::integers`].
    pub fn pass(&mut self, words: &mut dyn Words) -> Result<(), Error> {
        self.clock.pass(words)?;
        words.count(&mut self.evaluations)?;
        let Self {
            dynamics,
            engine,
            storage,
            clock,
            ..
        } = self;
        let mut parts = storage.parts();
        if self.stale && !words.fills() {
            dynamics.resume(engine, &mut parts, clock.time)?;
        }
        dynamics.pass(&mut parts, words)?;
        self.stale = false;
        Ok(())
    }

    /// Makes one step; its length, and `None` where the end has been reached.
    pub fn step(&mut self) -> Result<Option<S>, Error> {
        match self.clock.left() {
            Some(left) => self.step_of_at_most(left).map(Some),
            None => Ok(None),
        }
    }

    /// Makes steps up to that time, or to the end where that comes first.
    pub fn advance_to(&mut self, time: S) -> Result<(), Error> {
        loop {
            let Some(left) = self.clock.left() else {
                return Ok(());
            };
            let wanted = time - self.clock.time;
            if !(wanted > S::ZERO) {
                return Ok(());
            }
            let longest = left.lesser(wanted);
            let dt = self.step_of_at_most(longest)?;
            if dt >= longest {
                // To the bit, however `time - dt` is rounded.
                self.clock.time = time.lesser(self.clock.end);
            }
        }
    }

    /// Makes one step of at most that length.
    fn step_of_at_most(&mut self, longest: S) -> Result<S, Error> {
        let Self {
            dynamics,
            engine,
            storage,
            ..
        } = self;
        dynamics.exchange(storage)?;
        let time = self.clock.time;
        let mut parts = storage.parts();
        if self.stale {
            dynamics.resume(engine, &mut parts, time)?;
            self.stale = false;
        }
        let dt = match self.step {
            Some(step) => step.lesser(longest),
            None => dynamics.stable_step(&self.method, &parts, time, longest)?,
        };
        let dt = Clock::with_rest(dt, longest);
        let step = Step { time, dt };
        dynamics.ready(step)?;
        let mut clock = self.clock;
        clock.tick(dt)?;
        drop(parts);
        storage.keep();
        let made = dynamics.advance(&self.method, engine, &mut storage.parts(), step);
        match made {
            Ok(evaluations) => {
                self.evaluations = self.evaluations.wrapping_add(u64::from(evaluations));
                self.clock = clock;
                Ok(dt)
            }
            Err(error) => {
                storage.restore();
                self.stale = true;
                Err(error)
            }
        }
    }
}
