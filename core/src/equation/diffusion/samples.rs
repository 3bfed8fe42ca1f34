//! What is known of a problem of functions: samples of it, taken before a run.

/// The largest diffusivity of a domain at equally spaced times, from 0 to the end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargestDiffusivity<'a> {
    /// Each, >= 0; none where the diffusivity does not depend on the time.
    pub values: &'a [f64],
    /// The time of the last one.
    pub duration: f64,
    /// What it may be between them, in what it is at them, >= 1.
    pub margin: f64,
}

impl LargestDiffusivity<'_> {
    /// By what factor the largest diffusivity may yet exceed that of a time.
    pub fn headroom(&self, time: f64) -> f64 {
        let Some(last) = self.values.len().checked_sub(1) else {
            return 1.0;
        };
        let place = (time / self.duration * last as f64)
            .max(0.0)
            .min(last as f64);
        let (before, after) = (libm::floor(place) as usize, libm::ceil(place) as usize);
        let rest = self.values.get(before..).unwrap_or(&[]);
        let at = |place: usize| self.values.get(place).copied().unwrap_or(0.0);
        let now = at(before).min(at(after));
        let later = rest.iter().copied().fold(0.0, f64::max);
        match now > 0.0 {
            true => self.margin * later / now,
            false => self.margin,
        }
    }
}

/// Numbers that a function of place, time and unknowns is given: `x, y, z, t`, then up to four unknowns.
pub type ReactionPoint = [f64; 8];

/// Corners and middles of a domain, of the time of a run, and of unknowns up to a size: where a reaction
/// that is a function is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// How many unknowns there are, at most 4.
    pub species: usize,
    /// The middle of the domain.
    pub middle: [f64; 3],
    /// Half its lengths.
    pub half: [f64; 3],
    /// The time of the run.
    pub duration: f64,
}

impl Corners {
    /// Calls a function at each of them.
    pub fn each(&self, size: f64, mut of: impl FnMut(&ReactionPoint)) {
        let mut corners = 3usize;
        for _ in 0..self.dimension.saturating_add(self.species) {
            corners = corners.saturating_mul(3);
        }
        for mut number in 0..corners {
            let mut part = || {
                let part = number % 3;
                number /= 3;
                part as f64 - 1.0
            };
            let mut point = [0.0; 8];
            for (i, slot) in point.iter_mut().enumerate() {
                *slot = match (i, self.middle.get(i), self.half.get(i)) {
                    (_, Some(middle), Some(half)) if i < self.dimension => middle + part() * half,
                    (3, ..) => 0.5 * (1.0 + part()) * self.duration,
                    (_, None, _) if i < self.species.saturating_add(4) => part() * size,
                    _ => 0.0,
                };
            }
            of(&point);
        }
    }
}
