//! Quantities that follow from the fields of a gas, as other codes measure their errors.

use super::description::{Abscissa, Description, Field};

/// What errors of a gas are measured of, beside its fields.
pub(super) struct Derived {
    density: [usize; 2],
    velocity: [usize; 2],
    energy: [usize; 2],
    dimension: usize,
    /// Of polar coordinates, where there is one.
    center: Option<[f64; 3]>,
}

/// An error, and the size of what it is an error of.
pub(super) type Off = (f64, f64);

impl Derived {
    /// Those of a simulation; `None` where it is no gas, or where not all of it is compared.
    pub fn of(description: &Description) -> Option<Self> {
        let mut exact = 0;
        let mut places = Vec::new();
        for field in description.compared() {
            places.push((field, exact));
            exact += field.components;
        }
        let find = |name: &str| {
            let is_it = |(field, _): &&(&Field, usize)| field.name == name;
            let (field, exact) = places.iter().find(is_it)?;
            Some([field.first, *exact])
        };
        Some(Self {
            density: find("density")?,
            velocity: find("velocity")?,
            energy: find("energy")?,
            dimension: description.dimension,
            center: match description.view.abscissa {
                Abscissa::From(center) if description.dimension > 1 => Some(center),
                _ => None,
            },
        })
    }

    /// What they are called.
    pub fn names(&self) -> &'static [&'static str] {
        let all = &[
            "momentum",
            "total_energy",
            "velocity_radial",
            "velocity_azimuthal",
        ];
        match self.center {
            Some(_) => all,
            None => &all[..2],
        }
    }

    /// Errors of a particle with these values: of `ρu`; of `ρ(e + u²/2)`; of the velocity away from the
    /// center, in the plane of x and y in two dimensions; and of that around it, about z.
    pub fn errors(&self, values: &[f64], exact: &[f64], position: &[f64; 3]) -> Vec<Off> {
        let [found, right] = [(values, 0), (exact, 1)].map(|(row, i)| {
            let velocity = &row[self.velocity[i]..self.velocity[i] + self.dimension];
            (row[self.density[i]], velocity, row[self.energy[i]])
        });
        let momentum = |(density, u, _): (f64, &[f64], f64)| -> Vec<f64> {
            u.iter().map(|u| density * u).collect()
        };
        let energy = |(density, u, e): (f64, &[f64], f64)| {
            density * (e + 0.5 * u.iter().map(|u| u * u).sum::<f64>())
        };
        let mut all = vec![
            (
                distance(&momentum(found), &momentum(right)),
                length(&momentum(right)),
            ),
            (energy(found) - energy(right), energy(right)),
        ];
        if let Some(center) = self.center {
            let away: Vec<f64> = (0..self.dimension)
                .map(|i| position[i] - center[i])
                .collect();
            let around = [-away[1], away[0]];
            for direction in [&away[..], &around[..]] {
                let size = length(direction);
                let along = |u: &[f64]| match size > 0.0 {
                    true => direction.iter().zip(u).map(|(n, u)| n * u).sum::<f64>() / size,
                    false => 0.0,
                };
                all.push((along(found.1) - along(right.1), along(right.1)));
            }
        }
        all
    }
}

/// `|a - b|`.
pub(super) fn distance(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// `|a|`.
pub(super) fn length(a: &[f64]) -> f64 {
    a.iter().map(|a| a * a).sum::<f64>().sqrt()
}
