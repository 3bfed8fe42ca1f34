//! Carrying laws out on a server: threads over ranges of receivers, lanes within them.
//!
//! Every choice made here (threads, instruction set, number of lanes) is one of speed. The
//! bits are those of the plain loop.

mod instruction_set;
mod kernels;
mod list;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use motes_core::error::{Container, Error};
use motes_core::neighbours::Cells;
use motes_core::pairs::{Engine, Law, Settled, plain};
use motes_core::scalar::Scalar;
use rayon::prelude::*;

pub use instruction_set::InstructionSet;
pub use kernels::HostScalar;
pub use list::GrowingList;

/// Receivers of one task at the least: below it, handing work over costs more than it saves.
const SMALLEST_TASK: usize = 1024;

/// Receivers of one task at the most: between two tasks a run can be stopped.
const LARGEST_TASK: usize = 1 << 16;

/// The engine of the host: receiver lanes over ranges of the sorted order, in parallel.
pub struct Threads {
    pool: rayon::ThreadPool,
    instruction_set: InstructionSet,
    lists: Vec<GrowingList>,
    fresh: bool,
    /// Whose lists they are.
    served: u64,
    /// Whether to stop, where somebody may say so.
    stop: Option<Arc<AtomicBool>>,
    /// Whether what cannot be proven to stay in the range of its format is computed all the same.
    is_unproven_allowed: bool,
    /// The first of it.
    unproven: Option<Error>,
}

/// Who keeps a sorted cloud between calls. The engine's neighbour lists are those of one cloud:
/// of one cloud after another they are made anew.
#[derive(Debug)]
pub(crate) struct Holder(u64);

impl Holder {
    /// One that there has not been.
    pub fn new() -> Self {
        static COUNT: AtomicU64 = AtomicU64::new(1);
        Self(COUNT.fetch_add(1, Ordering::Relaxed))
    }
}

/// More threads than any machine this is meant for has cores; a slip of the keyboard.
const MOST_THREADS: usize = 1024;

/// The threads asked for could not be started.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum ThreadsError {
    /// Too many.
    #[error("{threads} threads are more than the {MOST_THREADS} that may be asked for")]
    #[diagnostic(help("use --threads 0 for as many as the machine has cores"))]
    TooMany {
        /// How many were asked for.
        threads: usize,
    },
    /// The system refused.
    #[error("cannot start {threads} threads")]
    #[diagnostic(help("use a smaller number with --threads"))]
    Start {
        /// How many were asked for.
        threads: usize,
        /// Why.
        source: rayon::ThreadPoolBuildError,
    },
}

impl Threads {
    /// An engine of `threads` threads (0: as many as the machine has cores) with the widest
    /// instruction set that the processor has.
    pub fn new(threads: usize) -> Result<Self, ThreadsError> {
        Self::with(threads, InstructionSet::detect())
    }

    /// The same with an instruction set of choice; falls back to what the processor has.
    pub fn with(threads: usize, set: InstructionSet) -> Result<Self, ThreadsError> {
        if threads > MOST_THREADS {
            return Err(ThreadsError::TooMany { threads });
        }
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|source| ThreadsError::Start { threads, source })?;
        Ok(Self {
            pool,
            instruction_set: set.available(),
            lists: Vec::new(),
            fresh: true,
            served: 0,
            stop: None,
            is_unproven_allowed: false,
            unproven: None,
        })
    }

    /// Stops between two tasks, in the middle of a step, once the flag is set
    /// ([`Error::Interrupted`]): a step of many particles takes long.
    pub fn stop_on(&mut self, flag: Arc<AtomicBool>) {
        self.stop = Some(flag);
    }

    /// Whether to go on where in fixed point a sum cannot be proven to stay in the range of its
    /// format ([`Error::Unproven`]); at first it is not.
    pub fn allow_unproven(&mut self, is_allowed: bool) {
        self.is_unproven_allowed = is_allowed;
    }

    /// The first proof that failed where the engine went on all the same.
    pub fn unproven(&self) -> Option<Error> {
        self.unproven
    }

    /// The first proof that failed where the engine went on all the same; forgets it.
    pub fn take_unproven(&mut self) -> Option<Error> {
        self.unproven.take()
    }

    /// Forgets the neighbour lists if they are those of another cloud.
    pub(crate) fn serve(&mut self, holder: &Holder) {
        self.fresh |= self.served != holder.0;
        self.served = holder.0;
    }

    /// The instruction set of the inner loops.
    pub fn instruction_set(&self) -> InstructionSet {
        self.instruction_set
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Receivers of a task where there are so many in all.
    fn task_length(&self, receivers: usize) -> usize {
        // Several tasks a thread: the ranges are not equally much work.
        let even = receivers.div_ceil(4 * self.threads());
        let task = match self.threads() {
            1 => receivers.max(1),
            _ => even.max(SMALLEST_TASK),
        };
        task.min(LARGEST_TASK)
    }
}

impl<S: HostScalar, const D: usize> Engine<S, D> for Threads {
    fn sorted(&mut self) {
        self.fresh = true;
    }

    fn unproven(&mut self, error: Error) -> Result<(), Error> {
        if !self.is_unproven_allowed {
            return Err(error);
        }
        self.unproven.get_or_insert(error);
        Ok(())
    }

    fn sweep<W: Law<S, D>>(
        &mut self,
        law: &W,
        cells: &Cells<'_, S, D>,
        nodes: &[W::Node],
        settled: &mut [Settled<W::Node, W::Sums>],
    ) -> Result<(), Error> {
        let task = self.task_length(nodes.len());
        let fresh = std::mem::replace(&mut self.fresh, false);
        self.lists
            .resize_with(nodes.len().div_ceil(task), GrowingList::default);
        let set = self.instruction_set;
        let stop = self.stop.as_deref();
        let stops = || stop.is_some_and(|stop| stop.load(Ordering::Relaxed));
        let stops = &stops;
        let ranges = settled.chunks_mut(task).zip(&mut self.lists);
        let tasks = ranges.enumerate().map(|(i, (settled, list))| {
            let run = move || {
                if fresh {
                    list.clear();
                }
                if stops() {
                    return false;
                }
                S::sweep(set, law, cells, nodes, i * task, settled, list, fresh)
            };
            Box::new(run) as Task<'_>
        });
        let complete = carry_out(&self.pool, tasks.collect());
        let particles = nodes.len() as u32;
        let full = Error::Capacity {
            container: Container::Candidates,
            needed: u32::MAX,
            capacity: particles,
        };
        match complete {
            true => Ok(()),
            false if stops() => Err(Error::Interrupted),
            false => Err(full),
        }
    }
}

/// A range of receivers; `false` where its memory is full.
///
/// Boxed, so that the code that hands tasks to threads exists once, and not for each law.
type Task<'a> = Box<dyn FnOnce() -> bool + Send + 'a>;

/// Carries tasks out, each on some thread; `true` if all are complete. A task that is alone is
/// done here: waking a thread takes longer than many a task.
fn carry_out(pool: &rayon::ThreadPool, tasks: Vec<Task<'_>>) -> bool {
    if tasks.len() == 1 || pool.current_num_threads() == 1 {
        return tasks.into_iter().all(|task| task());
    }
    pool.install(|| {
        let done = tasks.into_par_iter().map(|task| task());
        done.reduce(|| true, |a, b| a && b)
    })
}

/// Threads over the plain loop: for scalars that lanes do not speed up.
pub(crate) fn plain_range<S: Scalar, const D: usize, W: Law<S, D>>(
    law: &W,
    cells: &Cells<'_, S, D>,
    nodes: &[W::Node],
    first: usize,
    settled: &mut [Settled<W::Node, W::Sums>],
) -> bool {
    plain(law, cells, nodes, first, settled);
    true
}
