//! Errors of a simulation against an exact solution.

use std::collections::BTreeMap;

use super::derived::{Derived, distance, length};
use super::description::Kind;
use super::simulation::{Row, Simulation};
use crate::exact::solution::Solution;
use crate::scenario::{Extent, Norm, Ring};

/// Norms of the error of one field over a window.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Norms {
    /// `Σ V_k |err_k| / Σ V_k`, `V_k = m_k/ρ_k`.
    pub l1: f64,
    /// `(Σ V_k err_k² / Σ V_k)^(1/2)`.
    pub l2: f64,
    /// `max_k |err_k|`.
    pub linf: f64,
    /// `Σ |err_k| / n`: every particle counts the same.
    pub mean: f64,
    /// `(Σ err_k² / n)^(1/2)`: likewise.
    pub rms: f64,
    /// `Σ V_k |err_k| / Σ V_k |exact_k|`; `None` of a field that is 0.
    pub relative_l1: Option<f64>,
    /// `Σ m_k |err_k| / Σ m_k`; `None` where particles have no mass.
    pub mass_l1: Option<f64>,
}

impl Norms {
    /// One of them.
    pub fn of(&self, norm: Norm) -> f64 {
        match norm {
            Norm::L1 => self.l1,
            Norm::L2 => self.l2,
            Norm::Linf => self.linf,
            Norm::Mean => self.mean,
            Norm::Rms => self.rms,
            Norm::RelativeL1 => self.relative_l1.unwrap_or(f64::NAN),
            Norm::MassL1 => self.mass_l1.unwrap_or(f64::NAN),
        }
    }
}

/// The sums that [`Norms`] are made of.
#[derive(Clone, Copy, Debug, Default)]
pub struct NormSums {
    volume: f64,
    count: f64,
    l1: f64,
    l2: f64,
    linf: f64,
    mean: f64,
    squares: f64,
    exact: f64,
    mass: f64,
    by_mass: f64,
}

/// How much a particle counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Portion {
    /// Its volume.
    pub volume: f64,
    /// Its mass; 0 where there is none.
    pub mass: f64,
}

impl NormSums {
    /// Adds the error of a particle where the exact value is of size `exact`.
    pub fn add(&mut self, Portion { volume, mass }: Portion, error: f64, exact: f64) {
        let size = error.abs();
        self.exact += volume * exact.abs();
        self.mass += mass;
        self.by_mass += mass * size;
        self.volume += volume;
        self.count += 1.0;
        self.l1 += volume * size;
        self.l2 += volume * size * size;
        self.linf = self.linf.max(size);
        self.mean += size;
        self.squares += size * size;
    }

    /// The norms; `None` without particles.
    pub fn norms(&self) -> Option<Norms> {
        (self.volume > 0.0).then(|| Norms {
            l1: self.l1 / self.volume,
            l2: (self.l2 / self.volume).sqrt(),
            linf: self.linf,
            mean: self.mean / self.count,
            rms: (self.squares / self.count).sqrt(),
            relative_l1: (self.exact > 0.0).then(|| self.l1 / self.exact),
            mass_l1: (self.mass > 0.0).then(|| self.by_mass / self.mass),
        })
    }
}

/// The name of all components together: the length of the difference.
pub const STATE: &str = "state";

/// The name of all components together in the energy norm, `(δu·P δu)^(1/2)`: of a state whose
/// components have units of their own, which [`STATE`] adds up as bare numbers.
pub const ENERGY: &str = "energy_norm";

/// The name of the reconstruction (1.13) at the particles, all components together.
pub const RECONSTRUCTION: &str = "reconstruction";

/// Where errors are measured.
#[derive(Clone, Copy, Debug)]
pub struct Window<'a> {
    /// A box.
    pub extent: &'a Extent,
    /// Only at some distances from a point, if not everywhere.
    pub ring: Option<&'a Ring>,
}

impl Window<'_> {
    /// Whether a particle is in it.
    pub fn contains(&self, position: &[f64; 3]) -> bool {
        self.extent.contains(position)
            && self.ring.is_none_or(|ring| {
                let from = ring.center.iter().zip(position);
                let squares: f64 = from.map(|(c, x)| (x - c) * (x - c)).sum();
                (ring.inner..=ring.outer).contains(&squares.sqrt())
            })
    }
}

/// The norms of the error of each field that a solution has, over the particles in the window;
/// `None` if there are none. Where the fields are one state also of [`STATE`], and of
/// [`RECONSTRUCTION`], given at all particles; of a gas also those of `momentum`, `total_energy` and, about
/// a center, `velocity_radial` and `velocity_azimuthal`.
///
/// The error of a vector is the length of the difference.
pub fn errors(
    simulation: &dyn Simulation,
    solution: &dyn Solution,
    window: Window<'_>,
    reconstruction: &[f64],
) -> Option<BTreeMap<String, Norms>> {
    let description = simulation.description();
    let fields: Vec<_> = description.compared().collect();
    let mut sums = vec![NormSums::default(); fields.len()];
    let (mut state, mut smoothed) = (NormSums::default(), NormSums::default());
    let (mut energy, weights) = (NormSums::default(), simulation.energy_weights());
    let derived = Derived::of(description);
    let names = derived.as_ref().map_or(&[][..], Derived::names);
    let mut more = vec![NormSums::default(); names.len()];
    let mass = description.fields.iter().find(|field| field.name == "mass");
    let mut exact = vec![0.0; solution.components()];
    let (time, mut id) = (simulation.time(), 0);
    simulation.each(|row: &Row| {
        id += 1;
        if !window.contains(&row.position) {
            return;
        }
        solution.write(row.position, time, &mut exact);
        let portion = Portion {
            volume: row.volume,
            mass: mass.map_or(0.0, |mass| row.values[mass.first]),
        };
        let mut rest = &exact[..];
        for (field, sums) in fields.iter().zip(&mut sums) {
            let (of_field, after) = rest.split_at(field.components);
            rest = after;
            let values = &row.values[field.places()];
            let error = match field.kind {
                Kind::Vector => distance(values, of_field),
                _ => values[0] - of_field[0],
            };
            sums.add(portion, error, length(of_field));
        }
        if let Some(derived) = &derived {
            let errors = derived.errors(&row.values, &exact, &row.position);
            for (sums, (error, size)) in more.iter_mut().zip(errors) {
                sums.add(portion, error, size);
            }
        }
        if description.is_state {
            let p = exact.len();
            let first = fields[0].first;
            let error = distance(&row.values[first..first + p], &exact);
            state.add(portion, error, length(&exact));
            if !weights.is_empty() {
                let values = &row.values[first..first + p];
                let nothing = vec![0.0; p];
                let size = weighted(&nothing, &exact, &weights);
                energy.add(portion, weighted(values, &exact, &weights), size);
            }
            let smooth = &reconstruction[(id - 1) * p..id * p];
            smoothed.add(portion, distance(smooth, &exact), length(&exact));
        }
    });
    let more = names.iter().copied().zip(more);
    let names = fields.iter().map(|field| field.name.as_str());
    let whole = [(STATE, state), (RECONSTRUCTION, smoothed)];
    let whole = whole.into_iter().filter(|_| description.is_state);
    let energy = (!weights.is_empty()).then_some((ENERGY, energy));
    names
        .zip(sums)
        .chain(whole)
        .chain(energy)
        .chain(more)
        .map(|(name, sums)| Some((name.to_owned(), sums.norms()?)))
        .collect()
}

/// `((a - b)·P(a - b))^(1/2)`.
fn weighted(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    let off: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    let rows = off.iter().zip(weights.chunks_exact(off.len()));
    let terms = rows.map(|(x, row)| x * row.iter().zip(&off).map(|(p, y)| p * y).sum::<f64>());
    terms.sum::<f64>().max(0.0).sqrt()
}
