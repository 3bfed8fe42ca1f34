//! What is proven to stay in the range of a format does: the twin that marks every overflow finds none
//! in a step whose sums were proven. And a state beyond the range is refused before it is computed.

mod made;

use fixed::types::extra::U19;
use made::{Made, agree};
use motes_core::cloud::{Particle, Still};
use motes_core::cutoff::{CubicSpline, QuinticSpline};
use motes_core::domain::{Axis, Domain, Side};
use motes_core::equation::diffusion::{
    DiffusionDynamics, DiffusionStorage, Drive, DrivenCondition, Form, Mean, NamedProblem,
};
use motes_core::equation::gas::viscosity::{Coefficients, Pairwise};
use motes_core::equation::gas::{PlainStorage, Stretch, Tube, Width};
use motes_core::equation::linear::systems::{Acoustics, Transport, Units};
use motes_core::equation::linear::{LinearDynamics, LinearStorage};
use motes_core::integrator::{DiffusionMethod, LeapFrog, RK4, SSP_RK3, Scheme, Stepper};
use motes_core::neighbours::cell_bound;
use motes_core::pairs::{HalfLoop, Nothing};
use motes_core::scalar::{Checked, Q32, Scalar};

type Q = Q32<U19>;
const N: usize = 96;
const CELLS: usize = cell_bound(N as u32) as usize + 1;

/// Steps of a wave between walls with values of that size.
fn wave<S: Scalar>(size: f64, weight: f64) -> Made {
    let mut memory = LinearStorage::<S, Nothing, 1, 2, N, CELLS>::new();
    for k in 0..64 {
        let part = if k < 32 { 1.0 } else { 0.25 };
        let particle = Particle {
            position: [S::from_f64(f64::from(k) + 0.5)],
            weight: S::from_f64(weight),
            value: [S::from_f64(part * size), S::ZERO],
        };
        memory.push(particle).unwrap();
    }
    let domain = Domain {
        axes: [Axis::walls(S::ZERO, S::count(64))],
    };
    let sound = Acoustics::new(1.0, 1.0, Units::ONE);
    let width = (QuinticSpline, S::from_f64(1.5));
    let dynamics = LinearDynamics::new(domain, width, sound, Still, S::ONE.half());
    Made::from((|| {
        let mut run = Stepper::new(dynamics, RK4, HalfLoop, memory)?;
        for _ in 0..5 {
            run.step()?;
        }
        Ok(())
    })())
}

/// Steps of what is made at that rate where it lies.
fn spring<S: Scalar>(source: f64) -> Made {
    let mut memory = LinearStorage::<S, Nothing, 1, 1, N, CELLS>::new();
    for k in 0..64 {
        let particle = Particle {
            position: [S::from_f64(f64::from(k) + 0.5)],
            weight: S::count(2),
            value: [S::ONE],
        };
        memory.push(particle).unwrap();
    }
    let domain = Domain {
        axes: [Axis::periodic(S::ZERO, S::count(64))],
    };
    let made_here = Transport {
        velocity: Still,
        decay: S::ZERO,
        source: S::from_f64(source),
    };
    let width = (QuinticSpline, S::from_f64(1.5));
    let dynamics = LinearDynamics::new(domain, width, made_here, Still, S::ONE.half());
    Made::from((|| {
        let mut run = Stepper::new(dynamics, SSP_RK3, HalfLoop, memory)?;
        run.advance_to(S::from_f64(0.001))
    })())
}

/// Steps of a wall that is driven.
fn wall<S: Scalar>(diffusivity: f64, drive: DrivenCondition<'static, S>, form: Form) -> Made {
    let mut memory = DiffusionStorage::<S, 1, 1, N, CELLS>::new();
    for k in 0..64 {
        let particle = Particle {
            position: [S::from_f64(f64::from(k) + 0.5)],
            weight: S::ONE,
            value: [S::count(12)],
        };
        memory.push(particle).unwrap();
    }
    let mut problem = NamedProblem::heat([S::from_f64(diffusivity)]);
    problem.walls[0][0] = [drive];
    let dynamics = DiffusionDynamics {
        domain: Domain {
            axes: [Axis::walls(S::ZERO, S::count(64))],
        },
        cut_off: QuinticSpline,
        epsilon: S::from_f64(1.5),
        problem,
        field: Still,
        form,
        mean: Mean::Harmonic,
        courant: S::ONE.half(),
    };
    let method = DiffusionMethod {
        scheme: Scheme::RungeKutta(SSP_RK3),
        longest: S::ONE,
    };
    Made::from((|| {
        let mut run = Stepper::new(dynamics, method, HalfLoop, memory)?;
        for _ in 0..5 {
            run.step()?;
        }
        Ok(())
    })())
}

/// Steps of a tube of gas with that energy, and that velocity on the left.
fn tube<S: Scalar>(energy: f64, velocity: f64, contrast: u32) -> Made {
    let dense = Stretch {
        lower: -32.0,
        upper: 0.0,
        particles: 64,
        mass: 0.5,
        velocity,
        energy,
    };
    let stretches = [
        dense,
        Stretch {
            lower: 0.0,
            upper: 32.0,
            particles: 64 / contrast,
            velocity: 0.0,
            ..dense
        },
    ];
    let tube = Tube {
        half_length: 32.0,
        sides: [Side::Mirror; 2],
        stretches: &stretches,
        gamma: 1.4,
        width: Width::adaptive(1.0),
        courant: 0.3,
        end: 8.0,
    };
    let materials = [tube.material()];
    let viscosity = Pairwise(Coefficients::usual());
    let gas = tube.solver::<S, _, _>(CubicSpline, viscosity, &materials);
    let mut memory = PlainStorage::<S, 1, 128, { cell_bound(128) as usize + 1 }>::new();
    tube.fill(|particle| memory.push(particle)).unwrap();
    Made::from((|| {
        let mut run = Stepper::new(gas, LeapFrog, HalfLoop, memory)?;
        for _ in 0..5 {
            run.step()?;
        }
        Ok(())
    })())
}

#[test]
fn a_proven_wave_does_not_overflow() {
    let mut pairs = Vec::new();
    for power in 0..12 {
        for weight in [0.5, 1.0, 1.9] {
            let size = 1.7 * f64::from(1 << power);
            pairs.push((wave::<Q>(size, weight), wave::<Checked<Q>>(size, weight)));
        }
    }
    agree(&pairs);
}

/// Where 4096 is the end, 2 times 4090 wraps to -12, a rate like any other.
#[test]
fn a_source_beyond_the_format_is_refused() {
    assert_eq!(spring::<Q>(100.0), Made::Steps);
    assert_eq!(spring::<Checked<Q>>(100.0), Made::Steps);
    for source in [2000.0, -4090.0, 4090.0] {
        assert_eq!(spring::<Q>(source), Made::Unproven, "{source}");
    }
}

#[test]
fn a_proven_wall_does_not_overflow() {
    for form in [Form::Direct, Form::Mixed] {
        let mut pairs = Vec::new();
        for power in 0..12 {
            let size = f64::from(1 << power);
            fn drives<S: Scalar>(size: f64) -> [DrivenCondition<'static, S>; 3] {
                let drive = |value: f64| Drive::Constant(S::from_f64(value));
                [
                    DrivenCondition::Value(drive(size)),
                    DrivenCondition::Flux(drive(size)),
                    DrivenCondition::Exchange {
                        rate: S::from_f64(0.1),
                        outside: drive(size),
                    },
                ]
            }
            for i in 0..3 {
                pairs.push((
                    wall::<Q>(1.0, drives(size)[i], form),
                    wall::<Checked<Q>>(1.0, drives(size)[i], form),
                ));
                pairs.push((
                    wall::<Q>(size, drives(1.0)[i], form),
                    wall::<Checked<Q>>(size, drives(1.0)[i], form),
                ));
            }
        }
        agree(&pairs);
    }
}

#[test]
fn a_proven_gas_does_not_overflow() {
    let mut pairs = Vec::new();
    for contrast in [1, 2, 8] {
        for power in 0..12 {
            let size = f64::from(1 << power);
            for (energy, velocity) in [(size, 0.0), (1.0, size), (0.01, -size)] {
                pairs.push((
                    tube::<Q>(energy, velocity, contrast),
                    tube::<Checked<Q>>(energy, velocity, contrast),
                ));
            }
        }
    }
    agree(&pairs);
}

#[test]
fn what_cannot_be_proven_says_how_many_bits_would_do() {
    let refused = motes_core::pairs::holds::<Q>(motes_core::error::Quantity::Force, 7, 5000.0);
    let text = refused.unwrap_err().to_string();
    assert!(
        text.contains("particle 7") && text.contains("13 integer bits"),
        "{text}"
    );
    assert_eq!(
        motes_core::pairs::holds::<Q>(motes_core::error::Quantity::Force, 7, 4000.0),
        Ok(())
    );
    assert_eq!(
        motes_core::pairs::holds::<f32>(motes_core::error::Quantity::Force, 7, f64::INFINITY),
        Ok(())
    );
}
