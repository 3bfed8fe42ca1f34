//! The plain loop is the definition; the half loop, the lanes and the threads give its bits.

#[path = "../clouds/mod.rs"]
mod clouds;
mod engines;

use clouds::{Cloud, Following, sides};
use engines::AnyEngine;
use fixed::types::extra::{U19, U32};
use motes_core::cutoff::Named;
use motes_core::digest::Digest;
use motes_core::domain::Side;
use motes_core::equation::gas::viscosity::{
    Coefficients, GingoldMonaghan, Named as NamedViscosity, Pairwise, VonNeumann,
};
use motes_core::equation::gas::{
    Diffusion, EnergyForm, NoSlip, Options, Physics, Plain, Switch, Weights, Width,
};
use motes_core::error::Error;
use motes_core::pairs::Fields;
use motes_core::scalar::{Micro, Q32, Q64, Scalar};
use motes_solver::engine::{HostScalar, InstructionSet, Threads};
use proptest::prelude::*;

/// A law, and the options that its arrays are made for.
trait Case<S: Scalar, const D: usize>: Physics<S, D> + std::fmt::Debug {
    fn options(&self) -> Options<S, D>;
}

impl<S: Scalar, const D: usize> Case<S, D> for Plain<S, D> {
    fn options(&self) -> Options<S, D> {
        Options::OFF
    }
}

impl<S: Scalar, const D: usize> Case<S, D> for Options<S, D> {
    fn options(&self) -> Options<S, D> {
        *self
    }
}

const FORMS: [EnergyForm; 3] = [EnergyForm::Exact, EnergyForm::Total, EnergyForm::LeapFrog];
const WEIGHTS: [Weights; 2] = [Weights::Mass, Weights::Number];

/// Either weights, without external forces.
fn plain<S: Scalar, const D: usize>(by_number: bool) -> Plain<S, D> {
    Plain {
        weights: WEIGHTS[usize::from(by_number)],
        ..Plain::DEFAULT
    }
}

/// Everything on, with one of the [`FORMS`] of the energy; no external forces.
fn everything<S: Scalar, const D: usize>(form: usize, by_number: bool) -> Options<S, D> {
    Options {
        plain: plain(by_number),
        energy: FORMS[form],
        limited: true,
        linear_exact: !S::WRAPS,
        switch: Some(Switch {
            minimum: S::from_f64(0.05),
            decay: S::from_f64(0.2),
        }),
        balsara: true,
        conduction: S::from_f64(0.75),
        diffusion: Diffusion {
            viscosity: S::from_f64(0.05),
            bulk_viscosity: S::from_f64(0.02),
            heat: S::from_f64(0.08),
        },
        // Some walls that the gas sticks to, where there are any.
        walls: NoSlip {
            velocity: std::array::from_fn(|axis| {
                let speed = |i: usize| if i == axis { 0.0 } else { 0.125 };
                [Some(std::array::from_fn(|i| S::from_f64(speed(i)))), None]
            }),
        },
        background: S::from_f64(0.05),
    }
}

/// With cut-off and viscosity of any name.
type Solver<S, P, const D: usize> = Following<S, Named, NamedViscosity<S>, P, D>;

/// The digest of a cloud of two materials after `steps` steps.
fn run<S: HostScalar, const D: usize, P: Case<S, D>>(
    cloud: &Cloud,
    solver: &Solver<S, P, D>,
    engine: &mut AnyEngine,
    steps: usize,
) -> Result<Digest, Error> {
    let mut arrays = cloud.arrays_of_two::<S, P::Shown, D>(&solver.physics.options());
    let (mut gas, mut work) = arrays.parts();
    solver.prepare(engine, &mut gas, &mut work)?;
    for _ in 0..steps {
        let dt = solver.time_step(&gas, S::ONE)?;
        solver.advance(engine, &mut gas, &mut work, dt)?;
    }
    Ok(gas.digest())
}

/// The digest after three steps with the default cut-off and viscosity.
fn after_steps<P: Case<f32, 2>>(
    cloud: &Cloud,
    physics: P,
    sides: [[Side; 2]; 2],
) -> Result<Digest, Error> {
    let width = Width::adaptive(cloud.eta as f32);
    let solver = cloud.following(physics, sides, Named::CubicSpline, width, pairwise());
    run(cloud, &solver, &mut AnyEngine::Plain, 3)
}

/// All engines on one cloud.
fn all_engines_agree<S: HostScalar, const D: usize, P: Case<S, D>>(
    cloud: &Cloud,
    physics: P,
    sides: [[Side; 2]; D],
    cut_off: Named,
    viscosity: NamedViscosity<S>,
) {
    let width = Width::adaptive(S::from_f64(cloud.eta));
    let solver = cloud.following(physics, sides, cut_off, width, viscosity);
    let steps = 3;
    let plain = run(cloud, &solver, &mut AnyEngine::Plain, steps);
    let context = || {
        format!(
            "{} in {D}D, {cloud:?}, {sides:?}, {physics:?}",
            std::any::type_name::<S>()
        )
    };
    assert!(plain.is_ok(), "{plain:?}: {}", context());
    let threads = |set| AnyEngine::Threads(Threads::with(2, set).unwrap());
    let mut engines = vec![
        ("half", AnyEngine::Half),
        ("lanes", AnyEngine::lanes(37)),
        ("threads", threads(InstructionSet::Portable)),
    ];
    // Without lanes an instruction set changes nothing.
    if S::HAS_LANES {
        engines.push(("AVX2", threads(InstructionSet::Avx2)));
        engines.push(("AVX-512", threads(InstructionSet::Avx512)));
    }
    for (name, mut engine) in engines {
        let bits = run(cloud, &solver, &mut engine, steps);
        assert_eq!(plain, bits, "{name}: {}", context());
    }
}

fn pairwise<S: Scalar>() -> NamedViscosity<S> {
    NamedViscosity::Pairwise(Pairwise(Coefficients {
        alpha: S::ONE,
        beta: S::from_f64(2.0),
    }))
}

fn line(seed: u64) -> Cloud {
    cloud(60, seed)
}

fn square(seed: u64) -> Cloud {
    cloud(14, seed)
}

/// In three dimensions with a narrow cut-off: at a free corner ε is twice as large, and a
/// period holds three reaches.
fn solid(seed: u64) -> Cloud {
    Cloud {
        eta: 0.8,
        ..cloud(12, seed)
    }
}

fn cloud(per_side: usize, seed: u64) -> Cloud {
    Cloud {
        per_side,
        seed,
        disorder: 0.35,
        speed: 0.5,
        masses: 0.4,
        eta: 1.2,
    }
}

macro_rules! every_cloud {
    ($name:ident, $scalar:ty, $cases:expr, $clouds:tt, |$form:ident, $by_number:ident| $physics:expr) => {
        proptest! {
            #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases($cases) })]
            #[test]
            fn $name(
                seed in 1u64..,
                kind in 0usize..125,
                $form in 0..FORMS.len(),
                $by_number in any::<bool>(),
            ) {
                let _ = $form;
                each_of!($clouds, $scalar, seed, kind, $physics);
            }
        }
    };
}

macro_rules! each_of {
    ([$($dimension:literal: $cloud:expr),*], $scalar:ty, $seed:expr, $kind:expr, $physics:expr) => {
        $(all_engines_agree::<$scalar, $dimension, _>(
            &$cloud($seed), $physics, sides($kind), Named::CubicSpline, pairwise::<$scalar>());)*
    };
}

macro_rules! every_law {
    ($scalar:ty, $cases:expr, $clouds:tt, $plain:ident, $options:ident) => {
        every_cloud!($plain, $scalar, $cases, $clouds, |form, by_number| plain(
            by_number
        ));
        every_cloud!($options, $scalar, $cases, $clouds, |form, by_number| {
            everything(form, by_number)
        });
    };
}
every_law!(
    f64,
    12,
    [1: line, 2: square, 3: solid],
    all_loops_give_the_same_bits_in_f64,
    all_loops_give_the_same_bits_with_all_options_in_f64
);
every_law!(
    f32,
    12,
    [1: line, 2: square, 3: solid],
    all_loops_give_the_same_bits_in_f32,
    all_loops_give_the_same_bits_with_all_options_in_f32
);
every_law!(
    Q32<U19>,
    3,
    [1: line, 2: square, 3: solid],
    all_loops_give_the_same_bits_in_q12_19,
    all_loops_give_the_same_bits_with_all_options_in_q12_19
);
// What these do otherwise than q12.19 and f32 is products and roots: the loops are the same.
every_law!(
    Q64<U32>,
    2,
    [2: square],
    all_loops_give_the_same_bits_in_q31_32,
    all_loops_give_the_same_bits_with_all_options_in_q31_32
);
every_law!(
    Micro,
    4,
    [2: square],
    all_loops_give_the_same_bits_in_the_approximate_scalar,
    all_loops_give_the_same_bits_with_all_options_in_the_approximate_scalar
);

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(6) })]
    #[test]
    fn every_viscosity_keeps_the_bits(
        seed in 1u64..,
        kind in 0usize..25,
        form in 0..FORMS.len(),
        by_number in any::<bool>(),
    ) {
        let c = Coefficients { alpha: 1.0f32, beta: 2.0 };
        let (plain, all) = (plain(by_number), everything(form, by_number));
        let neumann = NamedViscosity::VonNeumann(VonNeumann(c));
        let gingold = NamedViscosity::GingoldMonaghan(GingoldMonaghan(c));
        let cloud = cloud(14, seed);
        all_engines_agree::<f32, 2, _>(&cloud, plain, sides(kind), Named::CubicSpline, neumann);
        all_engines_agree::<f32, 2, _>(&cloud, plain, sides(kind), Named::CubicSpline, gingold);
        all_engines_agree::<f32, 2, _>(&cloud, all, sides(kind), Named::CubicSpline, neumann);
        all_engines_agree::<f32, 2, _>(&cloud, all, sides(kind), Named::CubicSpline, gingold);
    }

    /// Each option alone: what the others would hide must show.
    #[test]
    fn every_option_alone_keeps_the_bits(
        seed in 1u64..,
        kind in 0usize..25,
        which in 0usize..8,
        form in 0..FORMS.len(),
    ) {
        let all = everything::<f32, 2>(form, false);
        let mut one = Options { energy: FORMS[form], ..Options::OFF };
        match which {
            0 => one.limited = true,
            1 => one.switch = all.switch,
            2 => one.balsara = true,
            3 => one.conduction = all.conduction,
            4 => one.diffusion.viscosity = all.diffusion.viscosity,
            5 => one.diffusion.heat = all.diffusion.heat,
            6 => one.linear_exact = true,
            // With nothing on at all the arrays would be made for `Plain`.
            _ => one.energy = FORMS[form % 2],
        }
        one.plain.acceleration = [0.01, -0.02];
        all_engines_agree::<f32, 2, _>(
            &cloud(14, seed), one, sides(kind), Named::CubicSpline, pairwise());
    }

    #[test]
    fn an_option_that_is_off_changes_no_bit(seed in 1u64.., kind in 0usize..25) {
        let digests = |by_number| {
            let paper = plain::<f32, 2>(by_number);
            let off = Options { plain: paper, ..Options::OFF };
            let (cloud, sides) = (cloud(14, seed), sides(kind));
            let paper = after_steps(&cloud, paper, sides);
            (paper, after_steps(&cloud, off, sides))
        };
        for by_number in [false, true] {
            let (paper, off) = digests(by_number);
            assert_eq!(paper, off, "kind {kind}, seed {seed}");
        }
    }

    #[test]
    fn wide_and_root_free_cut_offs_keep_the_bits(seed in 1u64.., kind in 0usize..25) {
        let (paper, all) = (plain(false), everything(0, false));
        // At a free side epsilon may double, and a period must still hold three reaches.
        let wide = cloud(24, seed);
        all_engines_agree::<f64, 2, _>(&wide, paper, sides(kind), Named::QuinticSpline, pairwise());
        all_engines_agree::<f64, 2, _>(&wide, all, sides(kind), Named::QuinticSpline, pairwise());
        let free = Cloud { eta: 2.4, ..cloud(14, seed) };
        all_engines_agree::<f64, 2, _>(&free, paper, sides(kind), Named::RootFree, pairwise());
        all_engines_agree::<f64, 2, _>(&free, all, sides(kind), Named::RootFree, pairwise());
    }
}

/// A first state with a bad guess of ε makes the cloud be sorted again and again: the order of
/// summation is that of the last sorting, for every engine.
#[test]
fn a_bad_first_guess_of_epsilon_keeps_the_bits() {
    let cloud = Cloud {
        eta: 1.2,
        ..cloud(20, 7)
    };
    let width = Width::adaptive(1.9f64);
    let all = everything(0, false);
    let solver = cloud.following(all, sides::<2>(12), Named::CubicSpline, width, pairwise());
    let run = |mut engine| run(&cloud, &solver, &mut engine, 2).unwrap();
    let plain = run(AnyEngine::Plain);
    assert_eq!(plain, run(AnyEngine::Half));
    assert_eq!(plain, run(AnyEngine::lanes(50)));
}

/// Sums up to 0 without being 0.
fn cancels<S: Scalar>(terms: impl Iterator<Item = S> + Clone) -> bool {
    let sum = terms.clone().fold(S::ZERO, |sum, term| sum + term);
    sum == S::ZERO && terms.into_iter().any(|term| term != S::ZERO)
}

/// Momentum rates cancel at every one of some steps, and rates of total energy where there are such.
fn rates_cancel<S: HostScalar, const D: usize, P: Case<S, D>>(
    physics: P,
    (per_side, steps): (usize, usize),
) {
    let flows = physics.options().energy == EnergyForm::Total;
    for seed in 1..5 {
        let cloud = cloud(per_side, seed);
        let width = Width::adaptive(S::from_f64(1.2));
        for sides in [sides::<D>(0), [[Side::Periodic; 2]; D]] {
            let solver =
                cloud.following(physics, sides, Named::CubicSpline, width, pairwise::<S>());
            let mut arrays = cloud.arrays_of_two::<S, P::Shown, D>(&physics.options());
            let (mut gas, mut work) = arrays.parts();
            let mut engine = AnyEngine::Half;
            solver.prepare(&mut engine, &mut gas, &mut work).unwrap();
            for _ in 0..steps {
                for i in 0..D {
                    let forces = gas.force.iter().map(|force| force[i]);
                    assert!(cancels(forces), "{D}D seed {seed}, {physics:?}");
                }
                let powers = gas.power.iter().copied();
                assert!(
                    !flows || cancels(powers),
                    "{D}D energy, seed {seed}, {physics:?}"
                );
                let dt = solver.time_step(&gas, S::ONE).unwrap();
                solver
                    .advance(&mut engine, &mut gas, &mut work, dt)
                    .unwrap();
            }
        }
    }
}

/// In fixed point the momentum rates of a free cloud sum to exactly 0, at every step.
#[test]
fn fixed_point_forces_of_a_free_cloud_cancel_exactly() {
    for by_number in [false, true] {
        rates_cancel::<Q32<U19>, 1, _>(plain(by_number), (60, 10));
        rates_cancel::<Q32<U19>, 2, _>(plain(by_number), (12, 10));
        rates_cancel::<Q32<U19>, 3, _>(plain(by_number), (11, 10));
        rates_cancel::<Q64<U32>, 2, _>(plain(by_number), (12, 10));
    }
}

/// And so they do with all options; and the flow of energy with [`EnergyForm::Total`]. Fewer steps:
/// with physical viscosity proofs go pair by pair.
#[test]
fn fixed_point_rates_with_all_options_cancel_exactly() {
    for form in 0..FORMS.len() {
        rates_cancel::<Q32<U19>, 1, _>(everything(form, false), (60, 3));
        rates_cancel::<Q32<U19>, 2, _>(everything(form, true), (12, 3));
        rates_cancel::<Q32<U19>, 3, _>(everything(form, false), (11, 3));
        rates_cancel::<Q64<U32>, 2, _>(everything(form, false), (12, 3));
    }
}

/// In a gas at rest all power is heat that is conducted: none is lost, and none crosses from
/// one material to the other.
#[test]
fn fixed_point_heat_cancels_exactly_within_each_material() {
    fn check<S: HostScalar, const D: usize>(per_side: usize) {
        for (seed, form) in (1..5).flat_map(|seed| [0, 2].map(|form| (seed, form))) {
            let cloud = Cloud {
                speed: 0.0,
                ..cloud(per_side, seed)
            };
            let width = Width::adaptive(S::from_f64(1.2));
            let options = everything(form, false);
            for sides in [sides::<D>(0), [[Side::Periodic; 2]; D]] {
                let solver =
                    cloud.following(options, sides, Named::CubicSpline, width, pairwise::<S>());
                let mut arrays = cloud.arrays_of_two::<S, _, D>(&options);
                let (mut gas, mut work) = arrays.parts();
                let mut engine = AnyEngine::Half;
                solver.prepare(&mut engine, &mut gas, &mut work).unwrap();
                for material in [0, 1] {
                    let here = gas.material.iter().zip(gas.power.iter());
                    let powers = here
                        .filter(|(number, _)| **number == material)
                        .map(|(_, &power)| power);
                    assert!(cancels(powers), "material {material}, {D}D seed {seed}");
                }
            }
        }
    }
    check::<Q32<U19>, 1>(60);
    check::<Q32<U19>, 2>(12);
    check::<Q32<U19>, 3>(11);
    check::<Q64<U32>, 2>(12);
}

/// The lane records are laid out by name: what goes into lane i comes out of it.
#[test]
fn records_survive_the_way_through_lanes() {
    use motes_core::equation::gas::motion::GasNode;
    use motes_core::scalar::Lanes;
    let node = |x: f64| GasNode {
        mass: x,
        measure: x + 0.05,
        pressure: x + 0.1,
        gradient: x + 0.2,
        scale: x + 0.3,
        sound_speed: x + 0.4,
        stiffness: x + 0.45,
        density: x + 0.5,
        epsilon: x + 0.6,
        velocity: [x + 0.7, x + 0.8],
        terms: [x + 0.9; 3],
    };
    let nodes = [node(1.0), node(2.0), node(3.0)];
    let gathered = GasNode::<f64, [f64; 3], 2>::gather::<Lanes<f64, 4>>(nodes.iter());
    for (i, expected) in nodes.iter().enumerate() {
        assert_eq!(&GasNode::<f64, [f64; 3], 2>::lane(&gathered, i), expected);
    }
}
