//! Pairs a second: the density sum over a jittered periodic box by the plain loop, the half
//! loop and the lanes, in 1, 2 and 3 dimensions and three scalars.
//!
//! `cargo bench --bench pairs` measures them all; `cargo bench --bench pairs -- --ratio` prints
//! lanes over plain for f32 in two dimensions and fails where that is below what vectors give.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use criterion::{BenchmarkId, Criterion, Throughput};
use fixed::types::extra::U19;
use motes::benchmark::{CASES, Case, plan};
use motes::engine::{GrowingList, HostScalar, InstructionSet, Threads};
use motes::families::gas::PlainArrays;
use motes_core::cutoff::CubicSpline;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::gas::density::{Density, DensityNode, DensitySums};
use motes_core::equation::gas::{Options, Width};
use motes_core::error::Error;
use motes_core::neighbours::{Cells, sort};
use motes_core::pairs::{Engine, Fields, HalfLoop, Law, PlainLoop, Portable, Settled, lanes};
use motes_core::scalar::{Q32, Scalar};

/// Lanes over plain for f32 in 2D that vectors give at the least; without them it is 1.0.
///
/// It depends on the processor. With AVX2 it is 4.7 on a Zen 5, 4.2 on a Xeon and 2.7 on an older server
/// that the bench has also been run on; with AVX-512 that Xeon, whose plain loop is fast, gains 3.5 to 4.0, by
/// code that others have gained more than 4 with.
fn smallest_ratio(set: InstructionSet) -> f64 {
    match set {
        InstructionSet::Avx512 => 2.5,
        InstructionSet::Avx2 | InstructionSet::Portable => 2.0,
    }
}

type Result<S, const D: usize> = Settled<DensityNode<S, D>, DensitySums<S, D>>;

/// Lanes of the portable kernel, for scalars that runs do not use lanes for.
#[derive(Default)]
struct PortableLanes(GrowingList);

impl<S: Scalar, const D: usize> Engine<S, D> for PortableLanes {
    fn sweep<W: Law<S, D>>(
        &mut self,
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        settled: &mut [Settled<W::Node, W::Sums>],
    ) -> std::result::Result<(), Error> {
        self.0.clear();
        let list = &mut self.0;
        assert!(lanes::<Portable, S, D, 4, W>(
            law, cells, nodes, 0, settled, list, true
        ));
        Ok(())
    }
}

/// A sorted cloud with everything that one density sum needs.
struct Sum<'a, S: Scalar, const D: usize> {
    law: Density<S, CubicSpline, D>,
    cells: Cells<'a, S, D>,
    nodes: Vec<DensityNode<S, D>>,
    settled: Vec<Result<S, D>>,
}

impl<S: HostScalar, const D: usize> Sum<'_, S, D> {
    fn run(&mut self, engine: &mut impl Engine<S, D>) {
        // The lanes look their candidates up again, as in a step.
        engine.sorted();
        let done = engine.sweep(&self.law, &self.cells, &self.nodes, &mut self.settled);
        assert_eq!(done, Ok(()));
    }

    /// Pairs within the support, each seen from both sides.
    fn pairs(&mut self) -> u64 {
        self.run(&mut PlainLoop);
        self.settled
            .iter()
            .map(|settled| settled.sums.partners.to_f64())
            .sum::<f64>() as u64
    }
}

/// Sorts the cloud of a case, made smaller, and hands it over.
fn with_sum<S: HostScalar, const D: usize>(case: Case, then: impl FnOnce(Sum<'_, S, D>)) {
    let particles: Vec<_> = plan(case).take_particles::<S, D>().collect();
    let positions: Vec<_> = particles.iter().map(|particle| particle.position).collect();
    let mut arrays = PlainArrays::<S, D>::new(particles, &Options::OFF);
    let (_, mut work) = arrays.parts();
    let side = S::from_f64(case.per_side as f64);
    let domain = Domain {
        axes: [Axis::periodic(S::ZERO, side); D],
    };
    let epsilon = S::from_f64(case.eta);
    let grid = sort(&domain, &positions, &|_| epsilon + epsilon, &mut work.cells).unwrap();
    let law = Density::new(CubicSpline, Width::Constant { epsilon });
    then(Sum {
        nodes: vec![law.node(S::ONE, epsilon); positions.len()],
        settled: vec![Settled::new(DensityNode::ZERO, DensitySums::ZERO); positions.len()],
        cells: work.cells.cells(grid, positions.len()),
        law,
    });
}

/// The case with about 10,000 particles: they stay in the cache, so the loop is what counts.
fn small(case: Case) -> Case {
    let per_side = [4_000, 100, 22][case.dimension - 1];
    Case { per_side, ..case }
}

fn measure<S: HostScalar, const D: usize>(criterion: &mut Criterion, scalar: &str) {
    with_sum::<S, D>(small(CASES[D - 1]), |mut sum| {
        let mut group = criterion.benchmark_group(format!("{D}d {scalar}"));
        group.throughput(Throughput::Elements(sum.pairs()));
        let id = |loop_name: &str| BenchmarkId::from_parameter(loop_name);
        group.bench_function(id("plain"), |bencher| {
            bencher.iter(|| sum.run(&mut PlainLoop))
        });
        group.bench_function(id("half"), |bencher| {
            bencher.iter(|| sum.run(&mut HalfLoop))
        });
        if S::HAS_LANES {
            let mut lanes = Threads::new(1).unwrap();
            group.bench_function(id("lanes"), |bencher| bencher.iter(|| sum.run(&mut lanes)));
        } else {
            let mut lanes = PortableLanes::default();
            group.bench_function(id("lanes"), |bencher| bencher.iter(|| sum.run(&mut lanes)));
        }
        group.finish();
    });
}

fn all(criterion: &mut Criterion) {
    measure::<f32, 1>(criterion, "f32");
    measure::<f32, 2>(criterion, "f32");
    measure::<f32, 3>(criterion, "f32");
    measure::<f64, 1>(criterion, "f64");
    measure::<f64, 2>(criterion, "f64");
    measure::<f64, 3>(criterion, "f64");
    measure::<Q32<U19>, 1>(criterion, "q12.19");
    measure::<Q32<U19>, 2>(criterion, "q12.19");
    measure::<Q32<U19>, 3>(criterion, "q12.19");
}

/// Lanes over plain, f32 in 2D, the median of pairs of runs one after the other.
fn ratio(set: InstructionSet) -> f64 {
    let mut median = 0.0;
    with_sum::<f32, 2>(small(CASES[1]), |mut sum| {
        let mut lanes = Threads::with(1, set).unwrap();
        let mut ratios: Vec<f64> = (0..21)
            .map(|_| {
                let started = Instant::now();
                sum.run(&mut PlainLoop);
                let plain = started.elapsed();
                let started = Instant::now();
                for _ in 0..8 {
                    sum.run(&mut lanes);
                }
                8.0 * plain.as_secs_f64() / started.elapsed().as_secs_f64()
            })
            .collect();
        ratios.sort_by(f64::total_cmp);
        median = ratios[ratios.len() / 2];
    });
    median
}

/// Prints the ratio for every instruction set of this processor; fails where the widest one,
/// which runs use, gives too little.
fn ratios() -> ExitCode {
    let mut code = ExitCode::SUCCESS;
    for set in [
        InstructionSet::Portable,
        InstructionSet::Avx2,
        InstructionSet::Avx512,
    ] {
        if set.available() != set {
            continue;
        }
        let ratio = ratio(set);
        println!(
            "lanes are {ratio:.1} times the plain loop (2D, f32, {})",
            set.name()
        );
        let used = set == InstructionSet::detect() && set != InstructionSet::Portable;
        let smallest = smallest_ratio(set);
        if used && ratio < smallest {
            eprintln!("expected {smallest}: the inner loops are no longer vectorised");
            code = ExitCode::FAILURE;
        }
    }
    code
}

fn main() -> ExitCode {
    if std::env::args().any(|argument| argument == "--ratio") {
        return ratios();
    }
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2))
        .sample_size(20)
        .configure_from_args();
    all(&mut criterion);
    criterion.final_summary();
    ExitCode::SUCCESS
}
