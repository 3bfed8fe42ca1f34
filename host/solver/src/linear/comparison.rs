//! Errors of a linear system against its exact solution.

use std::collections::BTreeMap;

use super::outcome::{Cloud, Outcome};
use crate::comparison::{NormSums, Norms};
use crate::exact::linear::solution::Solution;
use crate::scenario::Extent;

/// The name of all components together: the length of the difference.
pub const STATE: &str = "state";

/// The name of the reconstruction (1.13) at the particles, all components together.
pub const RECONSTRUCTION: &str = "reconstruction";

/// The norms of the error of each component, of [`STATE`] and [`RECONSTRUCTION`], over the
/// particles in the window; `None` if there are none.
pub fn errors(
    solution: &dyn Solution,
    outcome: &Outcome,
    names: &[String],
    window: &Extent,
) -> Option<BTreeMap<String, Norms>> {
    let cloud = &outcome.cloud;
    let inside: Vec<usize> = (0..cloud.len())
        .filter(|&id| window.contains(&cloud.positions[id]))
        .collect();
    let exact: Vec<Vec<f64>> = inside
        .iter()
        .map(|&id| solution.at(cloud.positions[id], outcome.time))
        .collect();
    let mut errors = BTreeMap::new();
    for (component, name) in names.iter().enumerate() {
        let norms = norms(cloud, &inside, |i, id| {
            cloud.value(id)[component] - exact[i][component]
        })?;
        errors.insert(name.clone(), norms);
    }
    let distance = |u: &[f64], exact: &[f64]| -> f64 {
        let squares = u
            .iter()
            .zip(exact)
            .map(|(u, exact)| (u - exact) * (u - exact));
        squares.sum::<f64>().sqrt()
    };
    let state = norms(cloud, &inside, |i, id| distance(cloud.value(id), &exact[i]))?;
    errors.insert(STATE.to_owned(), state);
    let p = names.len();
    let reconstruction = norms(cloud, &inside, |i, id| {
        distance(&outcome.reconstruction[id * p..(id + 1) * p], &exact[i])
    })?;
    errors.insert(RECONSTRUCTION.to_owned(), reconstruction);
    Some(errors)
}

/// The norms of an error given for the place in the list and the id of each particle.
fn norms(cloud: &Cloud, inside: &[usize], error: impl Fn(usize, usize) -> f64) -> Option<Norms> {
    let mut norms = NormSums::default();
    for (i, &id) in inside.iter().enumerate() {
        norms.add(cloud.weights[id], error(i, id));
    }
    norms.norms()
}
