//! Velocity fields `a(x,t)`: what particles follow, (1.6) and (1.20), and what carries a transported
//! quantity.

use crate::scalar::{Scalar, cosine_of_turns, sine_of_turns};

use super::place::Place;

/// A velocity field. Positions are the solver's: the middle of the domain is 0.
pub trait VelocityField<S: Scalar, const D: usize>: Sync {
    /// `a(x,t)`.
    fn velocity(&self, place: &Place<S, D>) -> [S; D];
    /// `div a(x,t)`.
    fn divergence(&self, place: &Place<S, D>) -> S;
    /// A bound of `|∂_i a^j|`: what limits the step along the characteristics.
    fn gradient(&self) -> S;
    /// A bound of `-div a`.
    fn convergence(&self) -> S;
    /// Whether nothing ever moves.
    fn is_still(&self) -> bool {
        false
    }
}

/// `a = 0`: a fixed cloud, generalised finite differences.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Still;

impl<S: Scalar, const D: usize> VelocityField<S, D> for Still {
    fn velocity(&self, _: &Place<S, D>) -> [S; D] {
        [S::ZERO; D]
    }
    fn divergence(&self, _: &Place<S, D>) -> S {
        S::ZERO
    }
    fn gradient(&self) -> S {
        S::ZERO
    }
    fn convergence(&self) -> S {
        S::ZERO
    }
    fn is_still(&self) -> bool {
        true
    }
}

/// The same velocity everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform<S, const D: usize> {
    /// It.
    pub velocity: [S; D],
}

impl<S: Scalar, const D: usize> VelocityField<S, D> for Uniform<S, D> {
    fn velocity(&self, _: &Place<S, D>) -> [S; D] {
        self.velocity
    }
    fn divergence(&self, _: &Place<S, D>) -> S {
        S::ZERO
    }
    fn gradient(&self) -> S {
        S::ZERO
    }
    fn convergence(&self) -> S {
        S::ZERO
    }
}

/// `a = ω (-(y-c_y), x-c_x)` in the first two directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation<S, const D: usize> {
    /// ω, radians a unit of time.
    pub rate: S,
    /// c.
    pub center: [S; D],
}

impl<S: Scalar, const D: usize> VelocityField<S, D> for Rotation<S, D> {
    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        let mut velocity = [S::ZERO; D];
        let [x, y] = arm(place, &self.center);
        for (component, value) in velocity.iter_mut().zip([-(self.rate * y), self.rate * x]) {
            *component = value;
        }
        velocity
    }
    fn divergence(&self, _: &Place<S, D>) -> S {
        S::ZERO
    }
    fn gradient(&self) -> S {
        self.rate.abs()
    }
    fn convergence(&self) -> S {
        S::ZERO
    }
}

/// `a = γ (y-c_y)` along x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shear<S, const D: usize> {
    /// γ.
    pub rate: S,
    /// c.
    pub center: [S; D],
}

impl<S: Scalar, const D: usize> VelocityField<S, D> for Shear<S, D> {
    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        let mut velocity = [S::ZERO; D];
        let [_, y] = arm(place, &self.center);
        if let Some(first) = velocity.first_mut() {
            *first = self.rate * y;
        }
        velocity
    }
    fn divergence(&self, _: &Place<S, D>) -> S {
        S::ZERO
    }
    fn gradient(&self) -> S {
        self.rate.abs()
    }
    fn convergence(&self) -> S {
        S::ZERO
    }
}

/// `a = -κ (x-c)`, towards a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compression<S, const D: usize> {
    /// κ; below 0 it expands.
    pub rate: S,
    /// c.
    pub center: [S; D],
}

impl<S: Scalar, const D: usize> VelocityField<S, D> for Compression<S, D> {
    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        let mut velocity = place.position;
        for (x, &center) in velocity.iter_mut().zip(&self.center) {
            *x = -(self.rate * (*x - center));
        }
        velocity
    }
    fn divergence(&self, _: &Place<S, D>) -> S {
        -(S::count(D as u32) * self.rate)
    }
    fn gradient(&self) -> S {
        self.rate.abs()
    }
    fn convergence(&self) -> S {
        (S::count(D as u32) * self.rate).greater(S::ZERO)
    }
}

/// `a = α sin(2π (x/λ + φ))` along x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave<S> {
    /// α.
    pub amplitude: S,
    /// λ, > 0.
    pub length: S,
    /// φ, in turns.
    pub phase: S,
}

impl<S: Scalar> Wave<S> {
    fn turns<const D: usize>(&self, place: &Place<S, D>) -> S {
        let x = place.position.first().copied().unwrap_or(S::ZERO);
        x / self.length + self.phase
    }

    /// `2π α/λ`, the largest slope.
    fn slope(&self) -> S {
        S::from_f64(core::f64::consts::TAU) * (self.amplitude / self.length)
    }
}

impl<S: Scalar, const D: usize> VelocityField<S, D> for Wave<S> {
    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        let mut velocity = [S::ZERO; D];
        if let Some(first) = velocity.first_mut() {
            *first = self.amplitude * sine_of_turns(self.turns(place));
        }
        velocity
    }
    fn divergence(&self, place: &Place<S, D>) -> S {
        self.slope() * cosine_of_turns(self.turns(place))
    }
    fn gradient(&self) -> S {
        self.slope().abs()
    }
    fn convergence(&self) -> S {
        self.slope().abs()
    }
}

/// The arm from a centre in the first two directions.
fn arm<S: Scalar, const D: usize>(place: &Place<S, D>, center: &[S; D]) -> [S; 2] {
    let mut arm = [S::ZERO; 2];
    for (arm, (&x, &c)) in arm.iter_mut().zip(place.position.iter().zip(center)) {
        *arm = x - c;
    }
    arm
}

/// A field chosen while the program runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Named<S, const D: usize> {
    /// [`Still`].
    Still,
    /// [`Uniform`].
    Uniform(Uniform<S, D>),
    /// [`Rotation`].
    Rotation(Rotation<S, D>),
    /// [`Shear`].
    Shear(Shear<S, D>),
    /// [`Compression`].
    Compression(Compression<S, D>),
    /// [`Wave`].
    Wave(Wave<S>),
}

macro_rules! delegate {
    ($self:ident, $field:ident => $value:expr) => {
        match $self {
            Named::Still => {
                let $field = &Still;
                $value
            }
            Named::Uniform($field) => $value,
            Named::Rotation($field) => $value,
            Named::Shear($field) => $value,
            Named::Compression($field) => $value,
            Named::Wave($field) => $value,
        }
    };
}

impl<S: Scalar, const D: usize> VelocityField<S, D> for Named<S, D> {
    fn velocity(&self, place: &Place<S, D>) -> [S; D] {
        delegate!(self, field => field.velocity(place))
    }
    fn divergence(&self, place: &Place<S, D>) -> S {
        delegate!(self, field => VelocityField::<S, D>::divergence(field, place))
    }
    fn gradient(&self) -> S {
        delegate!(self, field => VelocityField::<S, D>::gradient(field))
    }
    fn convergence(&self) -> S {
        delegate!(self, field => VelocityField::<S, D>::convergence(field))
    }
    fn is_still(&self) -> bool {
        delegate!(self, field => VelocityField::<S, D>::is_still(field))
    }
}
