//! Pseudo-viscosity: what keeps shocks a few particles wide.
//!
//! Two ways to act, in one trait: a pressure `q` beside `p` (the paper's), and a pair term
//! `Π_kl`. Adding one: a type here with an implementation of [`Viscosity`], and its name.

use crate::scalar::{Number, Scalar};

/// A pair as the viscosity sees it. Sums, not means: symmetric to the bit.
pub struct Pair<N> {
    /// `(u_k - u_l)·r`; of reconstructed velocities where they are.
    pub approach: N,
    /// `|r|²`.
    pub distance_squared: N,
    /// `(u_k - u_l)·r/|r|`; 0 at `r = 0`.
    pub speed: N,
    /// `c_k + c_l`.
    pub sound_speeds: N,
    /// `ρ_k + ρ_l`.
    pub densities: N,
    /// `ε_k + ε_l`.
    pub epsilons: N,
    /// Factor of α, in [0, 1].
    pub linear: N,
    /// Factor of Π, in [0, 1].
    pub factor: N,
}

/// A particle as the viscosity sees it.
pub struct Local<S> {
    /// ρ.
    pub density: S,
    /// c.
    pub sound_speed: S,
    /// ε.
    pub epsilon: S,
    /// div u.
    pub divergence: S,
}

/// A pseudo-viscosity.
pub trait Viscosity<S: Scalar>: Copy + Send + Sync {
    /// Whether [`Viscosity::pressure`] wants `div u`, which costs a sweep of its own.
    fn needs_divergence(&self) -> bool {
        false
    }
    /// `q`, added to the pressure in both equations.
    fn pressure(&self, local: &Local<S>) -> S {
        let _ = local;
        S::ZERO
    }
    /// `Π_kl`; must be finite for `r = 0` and for pairs out of reach.
    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(&self, pair: &Pair<N>) -> N {
        let _ = pair;
        N::zero()
    }
    /// The signal speed that bounds the time step: `(1 + 0.6 α) c + 0.6 β s`, `s` the
    /// fastest approach of a partner (after Monaghan, ARA&A 30, 543, 1992, eq. 10.2).
    fn signal(&self, sound_speed: S, approach: S) -> S;
    /// A bound of all that `signal` and `pair` make on their way for speeds up to `speed` and sound
    /// speeds up to `sound_speed`, but for the quotients over densities: what a proof that a format holds
    /// them goes by. Infinite where nothing is said, and such a format then refuses the run.
    fn largest(&self, speed: f64, sound_speed: f64) -> f64 {
        let _ = (speed, sound_speed);
        f64::INFINITY
    }
}

/// The coefficients that all of them share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<S> {
    /// α, of the term linear in the velocity jump.
    pub alpha: S,
    /// β, of the quadratic one.
    pub beta: S,
}

impl<S: Scalar> Coefficients<S> {
    /// α = 1, β = 2.
    pub fn usual() -> Self {
        Self {
            alpha: S::ONE,
            beta: S::count(2),
        }
    }

    /// A bound of the bracket times `s`, and of the signal speed.
    fn largest(&self, s: f64, sound_speed: f64) -> f64 {
        let (alpha, beta) = (self.alpha.to_f64().abs(), self.beta.to_f64().abs());
        let bracket = 2.0 * alpha * sound_speed + 2.0 * beta * s;
        bracket.max(bracket * s).max(sound_speed + bracket)
    }

    fn signal(&self, sound_speed: S, approach: S) -> S {
        let part = S::from_f64(0.6);
        sound_speed + part * (self.alpha * sound_speed + self.beta * approach)
    }
}

/// The paper's: `q = ρ (-α ε c div u + β ε² (div u)²)` where `div u < 0`
/// (von Neumann & Richtmyer, J. Appl. Phys. 21, 232, 1950).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VonNeumann<S>(pub Coefficients<S>);

impl<S: Scalar> Viscosity<S> for VonNeumann<S> {
    fn needs_divergence(&self) -> bool {
        true
    }
    fn pressure(&self, local: &Local<S>) -> S {
        let jump = local.epsilon * local.divergence.lesser(S::ZERO);
        local.density * jump * (self.0.beta * jump - self.0.alpha * local.sound_speed)
    }
    fn signal(&self, sound_speed: S, approach: S) -> S {
        self.0.signal(sound_speed, approach)
    }
    fn largest(&self, speed: f64, sound_speed: f64) -> f64 {
        self.0.largest(speed, sound_speed)
    }
}

/// `μ = ε s|r|/(r² + 0.01 ε²)`, `s` the speed along the line of centres where the pair
/// approaches, `Π = (-α c μ + β μ²)/ρ` with means of the pair (Gingold & Monaghan, J. Comp.
/// Phys. 52, 374, 1983).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GingoldMonaghan<S>(pub Coefficients<S>);

impl<S: Scalar> Viscosity<S> for GingoldMonaghan<S> {
    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(&self, pair: &Pair<N>) -> N {
        let epsilon = N::literal(0.5) * pair.epsilons;
        let softened = pair.distance_squared + N::literal(0.01) * (epsilon * epsilon);
        let mu = epsilon * pair.approach.min(N::zero()) / softened;
        let bracket = N::splat(self.0.alpha) * pair.linear * pair.sound_speeds
            - N::splat(self.0.beta + self.0.beta) * mu;
        // -(α c̄ - β μ) μ / ρ̄ with both means written as sums.
        -(pair.factor * (bracket * mu / pair.densities))
    }
    fn signal(&self, sound_speed: S, approach: S) -> S {
        self.0.signal(sound_speed, approach)
    }
    fn largest(&self, speed: f64, sound_speed: f64) -> f64 {
        // `|μ| <= 5 |s|`, where `|r| = ε/10`.
        self.0.largest(5.0 * speed, sound_speed)
    }
}

/// `Π = -(α (c_k+c_l)/2 - β s/2) s / ((ρ_k+ρ_l)/2)`, `s = (u_k-u_l)·r/|r| < 0`: the operator
/// (4.6) applied to the velocity along the line of centres (Monaghan, J. Comp. Phys. 136,
/// 298, 1997).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pairwise<S>(pub Coefficients<S>);

impl<S: Scalar> Viscosity<S> for Pairwise<S> {
    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(&self, pair: &Pair<N>) -> N {
        let s = pair.speed.min(N::zero());
        let bracket =
            N::splat(self.0.alpha) * pair.linear * pair.sound_speeds - N::splat(self.0.beta) * s;
        -(pair.factor * (bracket * s / pair.densities))
    }
    fn signal(&self, sound_speed: S, approach: S) -> S {
        self.0.signal(sound_speed, approach)
    }
    fn largest(&self, speed: f64, sound_speed: f64) -> f64 {
        self.0.largest(speed, sound_speed)
    }
}

/// None.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inviscid;

impl<S: Scalar> Viscosity<S> for Inviscid {
    fn signal(&self, sound_speed: S, _: S) -> S {
        sound_speed
    }
    fn largest(&self, _: f64, _: f64) -> f64 {
        0.0
    }
}

/// A pseudo-viscosity chosen while the program runs; the bits of the one it names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Named<S> {
    /// [`VonNeumann`].
    VonNeumann(VonNeumann<S>),
    /// [`GingoldMonaghan`].
    GingoldMonaghan(GingoldMonaghan<S>),
    /// [`Pairwise`].
    Pairwise(Pairwise<S>),
    /// [`Inviscid`].
    Inviscid,
}

impl<S: Scalar> Viscosity<S> for Named<S> {
    fn needs_divergence(&self) -> bool {
        matches!(self, Self::VonNeumann(_))
    }
    fn pressure(&self, local: &Local<S>) -> S {
        match self {
            Self::VonNeumann(viscosity) => viscosity.pressure(local),
            _ => S::ZERO,
        }
    }
    #[inline(always)]
    fn pair<N: Number<Scalar = S>>(&self, pair: &Pair<N>) -> N {
        match self {
            Self::GingoldMonaghan(viscosity) => viscosity.pair(pair),
            Self::Pairwise(viscosity) => viscosity.pair(pair),
            _ => N::zero(),
        }
    }
    fn signal(&self, sound_speed: S, approach: S) -> S {
        match self {
            Self::VonNeumann(VonNeumann(c))
            | Self::GingoldMonaghan(GingoldMonaghan(c))
            | Self::Pairwise(Pairwise(c)) => c.signal(sound_speed, approach),
            Self::Inviscid => sound_speed,
        }
    }
    fn largest(&self, speed: f64, sound_speed: f64) -> f64 {
        match self {
            Self::VonNeumann(viscosity) => viscosity.largest(speed, sound_speed),
            Self::GingoldMonaghan(viscosity) => viscosity.largest(speed, sound_speed),
            Self::Pairwise(viscosity) => viscosity.largest(speed, sound_speed),
            Self::Inviscid => 0.0,
        }
    }
}
