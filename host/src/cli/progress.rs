//! The progress of several runs.

use indicatif::ProgressBar;

use super::watch::progress_bar;

/// The bar: each level has a part of it that is as long as its work.
pub(super) struct Progress {
    /// As it is drawn.
    pub bar: ProgressBar,
    dimension: usize,
    total: f64,
    before: f64,
    level: f64,
}

impl Progress {
    /// A bar of levels with so many particles.
    pub fn new(hidden: bool, counts: &[usize], dimension: usize) -> Self {
        Self {
            bar: progress_bar(hidden, 1000, "{wide_bar} {percent}% {msg}"),
            total: counts.iter().map(|&count| work(count, dimension)).sum(),
            dimension,
            before: 0.0,
            level: 0.0,
        }
    }

    /// Begins the next level.
    pub fn begin(&mut self, count: usize) {
        self.before += self.level;
        self.level = work(count, self.dimension);
        self.bar.set_message(format!("{count} particles"));
    }

    /// Shows the part of the level that is done.
    pub fn show(&self, done: f64) {
        let share = (self.before + done * self.level) / self.total;
        self.bar.set_position((1000.0 * share) as u64);
    }
}

/// Particles times steps, which are as many as spacings along an edge.
fn work(count: usize, dimension: usize) -> f64 {
    libm::pow(count as f64, 1.0 + 1.0 / dimension as f64)
}
