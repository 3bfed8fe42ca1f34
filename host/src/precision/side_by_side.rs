//! Runs side by side, where there are threads for more than one.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::engine::Threads;

/// Particles from which on runs follow one another, each on all threads: such runs keep these busy, and
/// one at a time takes the memory of one.
const LARGE: usize = 50_000;

/// How many threads each of the runs at a time has: as many runs as there are threads for, the first with
/// what is left over.
pub fn shares(threads: usize, runs: usize, particles: usize) -> Vec<usize> {
    let threads = threads.max(1);
    if particles >= LARGE {
        return vec![threads];
    }
    let abreast = threads.min(runs).max(1);
    let (each, rest) = (threads / abreast, threads % abreast);
    let share = |place| each + usize::from(place < rest);
    (0..abreast).map(share).collect()
}

/// Carries out so many jobs, each on one of the engines as soon as it is free: what they return, in
/// the order of the jobs. A job must not depend on the engine that it is given.
pub fn side_by_side<R: Send>(
    engines: &mut [Threads],
    jobs: usize,
    job: impl Fn(usize, &mut Threads) -> R + Sync,
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::with_capacity(jobs));
    std::thread::scope(|scope| {
        for engine in engines {
            let (next, done, job) = (&next, &done, &job);
            scope.spawn(move || {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    if place >= jobs {
                        return;
                    }
                    let result = job(place, engine);
                    let mut done = done.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
                    done.push((place, result));
                }
            });
        }
    });
    let mut done = done
        .into_inner()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_are_shared_out_whole() {
        assert_eq!(shares(1, 6, 100), [1]);
        assert_eq!(shares(4, 6, 100), [1, 1, 1, 1]);
        assert_eq!(shares(8, 3, 100), [3, 3, 2]);
        assert_eq!(shares(8, 3, LARGE), [8]);
        assert_eq!(shares(0, 0, 0), [1]);
    }

    #[test]
    fn every_job_is_carried_out_once_and_told_in_its_place() {
        let mut engines: Vec<Threads> = (0..3).map(|_| Threads::new(1).unwrap()).collect();
        let squares = side_by_side(&mut engines, 20, |place, _| place * place);
        assert_eq!(squares, (0..20).map(|i| i * i).collect::<Vec<_>>());
    }
}
