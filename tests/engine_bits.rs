//! The plain loop is the definition; the half loop, the lanes and the threads give its bits.

mod clouds;

use clouds::{Cloud, sides};
use fixed::types::extra::{U19, U32};
use motes::engine::{GrowingList, HostScalar, InstructionSet, Threads};
use motes_core::cutoff::{CubicSpline, CutOff, QuinticSpline, RootFree};
use motes_core::digest::Digest;
use motes_core::domain::Side;
use motes_core::equation::gas::viscosity::{Coefficients, GingoldMonaghan, Pairwise, VonNeumann};
use motes_core::equation::gas::{Viscosity, Width};
use motes_core::error::Error;
use motes_core::neighbours::Cells;
use motes_core::pairs::{Engine, Fields, HalfLoop, Law, PlainLoop, Portable, Settled, lanes};
use motes_core::scalar::{Micro, Q32, Q64, Scalar};
use proptest::prelude::*;

/// Lanes without threads, over a few ranges that cut rows anywhere.
struct LaneLoop<const L: usize> {
    lists: Vec<GrowingList>,
    fresh: bool,
    range: usize,
}

impl<const L: usize> LaneLoop<L> {
    fn new(range: usize) -> Self {
        Self {
            lists: Vec::new(),
            fresh: true,
            range,
        }
    }
}

impl<S: Scalar, const D: usize, const L: usize> Engine<S, D> for LaneLoop<L> {
    fn sorted(&mut self) {
        self.fresh = true;
    }
    fn sweep<W: Law<S, D>>(
        &mut self,
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        settled: &mut [Settled<W::Node, W::Sums>],
    ) -> Result<(), Error> {
        self.lists
            .resize_with(nodes.len().div_ceil(self.range), GrowingList::default);
        for (i, (settled, list)) in settled
            .chunks_mut(self.range)
            .zip(&mut self.lists)
            .enumerate()
        {
            if self.fresh {
                list.clear();
            }
            let first = i * self.range;
            let fresh = self.fresh;
            assert!(lanes::<Portable, S, D, L, W>(
                law, cells, nodes, first, settled, list, fresh
            ));
        }
        self.fresh = false;
        Ok(())
    }
}

/// The digest after `steps` steps, and of the smallest and largest neighbour counts.
fn run<S: Scalar, const D: usize, C: CutOff, V: Viscosity<S>>(
    cloud: &Cloud,
    solver: &clouds::Solver<S, C, V, D>,
    engine: &mut impl Engine<S, D>,
    steps: usize,
) -> Result<Digest, Error> {
    let mut arrays = cloud.arrays::<S, D>();
    let (mut gas, mut work) = arrays.parts();
    solver.prepare(engine, &mut gas, &mut work)?;
    for _ in 0..steps {
        let dt = solver.time_step(&gas, S::ONE)?;
        solver.advance(engine, &mut gas, &mut work, dt)?;
    }
    Ok(gas.digest())
}

/// All engines on one cloud.
fn all_engines_agree<S: HostScalar, const D: usize, C: CutOff, V: Viscosity<S>>(
    cloud: &Cloud,
    sides: [[Side; 2]; D],
    cut_off: C,
    viscosity: V,
) {
    let width = Width::Adaptive {
        eta: S::from_f64(cloud.eta),
    };
    let solver = cloud.solver(sides, cut_off, width, viscosity);
    let steps = 3;
    let plain = run(cloud, &solver, &mut PlainLoop, steps);
    assert!(plain.is_ok(), "{plain:?} on {cloud:?} with {sides:?}");
    let context = || {
        format!(
            "{} in {D}D, {cloud:?}, {sides:?}",
            std::any::type_name::<S>()
        )
    };
    assert_eq!(
        plain,
        run(cloud, &solver, &mut HalfLoop, steps),
        "half: {}",
        context()
    );
    assert_eq!(
        plain,
        run(cloud, &solver, &mut LaneLoop::<3>::new(37), steps),
        "3: {}",
        context()
    );
    assert_eq!(
        plain,
        run(cloud, &solver, &mut LaneLoop::<8>::new(999), steps),
        "8: {}",
        context()
    );
    for set in [
        InstructionSet::Portable,
        InstructionSet::Avx2,
        InstructionSet::Avx512,
    ] {
        let mut threads = Threads::with(2, set).unwrap();
        let bits = run(cloud, &solver, &mut threads, steps);
        assert_eq!(plain, bits, "{}: {}", set.name(), context());
    }
}

fn pairwise<S: Scalar>() -> Pairwise<S> {
    Pairwise(Coefficients {
        alpha: S::ONE,
        beta: S::from_f64(2.0),
    })
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

macro_rules! every_dimension {
    ($name:ident, $scalar:ty, $cases:expr) => {
        proptest! {
            #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases($cases) })]
            #[test]
            fn $name(seed in 1u64.., kind in 0usize..125) {
                let viscosity = pairwise::<$scalar>();
                all_engines_agree::<$scalar, 1, _, _>(
                    &cloud(60, seed), sides(kind), CubicSpline, viscosity);
                all_engines_agree::<$scalar, 2, _, _>(
                    &cloud(14, seed), sides(kind), CubicSpline, viscosity);
                all_engines_agree::<$scalar, 3, _, _>(
                    &solid(seed), sides(kind), CubicSpline, viscosity);
            }
        }
    };
}
every_dimension!(all_loops_give_the_same_bits_in_f64, f64, 24);
every_dimension!(all_loops_give_the_same_bits_in_f32, f32, 24);
every_dimension!(all_loops_give_the_same_bits_in_q12_19, Q32<U19>, 8);
every_dimension!(all_loops_give_the_same_bits_in_q31_32, Q64<U32>, 4);
every_dimension!(
    all_loops_give_the_same_bits_in_the_approximate_scalar,
    Micro,
    8
);

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(12) })]
    #[test]
    fn every_viscosity_keeps_the_bits(seed in 1u64.., kind in 0usize..25) {
        let c = Coefficients { alpha: 1.0f32, beta: 2.0 };
        all_engines_agree::<f32, 2, _, _>(&cloud(14, seed), sides(kind), CubicSpline, VonNeumann(c));
        let gingold = GingoldMonaghan(c);
        all_engines_agree::<f32, 2, _, _>(&cloud(14, seed), sides(kind), CubicSpline, gingold);
    }

    #[test]
    fn wide_and_root_free_cut_offs_keep_the_bits(seed in 1u64.., kind in 0usize..25) {
        all_engines_agree::<f64, 2, _, _>(
            &cloud(19, seed), sides(kind), QuinticSpline, pairwise());
        let root_free = Cloud { eta: 2.4, ..cloud(14, seed) };
        all_engines_agree::<f64, 2, _, _>(&root_free, sides(kind), RootFree::<4>, pairwise());
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
    let width = Width::Adaptive { eta: 1.9f64 };
    let solver = cloud.solver(sides::<2>(12), CubicSpline, width, pairwise());
    let plain = run(&cloud, &solver, &mut PlainLoop, 2).unwrap();
    assert_eq!(plain, run(&cloud, &solver, &mut HalfLoop, 2).unwrap());
    assert_eq!(
        plain,
        run(&cloud, &solver, &mut LaneLoop::<8>::new(50), 2).unwrap()
    );
}

/// In fixed point the momentum rates of a free cloud sum to exactly 0, at every step.
#[test]
fn fixed_point_forces_of_a_free_cloud_cancel_exactly() {
    fn check<S: HostScalar, const D: usize>(per_side: usize) {
        for seed in 1..5 {
            let cloud = cloud(per_side, seed);
            let width = Width::Adaptive {
                eta: S::from_f64(1.2),
            };
            for sides in [sides::<D>(0), [[Side::Periodic; 2]; D]] {
                let solver = cloud.solver(sides, CubicSpline, width, pairwise::<S>());
                let mut arrays = cloud.arrays::<S, D>();
                let (mut gas, mut work) = arrays.parts();
                solver.prepare(&mut HalfLoop, &mut gas, &mut work).unwrap();
                for _ in 0..10 {
                    for i in 0..D {
                        let sum = gas.force.iter().fold(S::ZERO, |sum, force| sum + force[i]);
                        assert_eq!(sum, S::ZERO, "{D}D seed {seed}");
                        assert!(gas.force.iter().any(|force| force[i] != S::ZERO));
                    }
                    let dt = solver.time_step(&gas, S::ONE).unwrap();
                    solver
                        .advance(&mut HalfLoop, &mut gas, &mut work, dt)
                        .unwrap();
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
        density: x + 0.5,
        epsilon: x + 0.6,
        velocity: [x + 0.7, x + 0.8],
    };
    let nodes = [node(1.0), node(2.0), node(3.0)];
    let gathered = GasNode::<f64, 2>::gather::<Lanes<f64, 4>>(nodes.iter());
    for (i, expected) in nodes.iter().enumerate() {
        assert_eq!(&GasNode::<f64, 2>::lane(&gathered, i), expected);
    }
}
