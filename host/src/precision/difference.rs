//! How far the particles of one run lie from those of another.

use std::collections::BTreeMap;

use super::last::{LastState, POSITION, edges, is_open};
use crate::run::{NormSums, Window};
use crate::scenario::AnyScenario;

/// How far a run lies from the reference in one field at the same time, particle by particle: norms
/// over the particles that are in the window in the reference, with their volumes there, in the
/// scenario's units.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Difference {
    /// `Σ V_k |d_k| / Σ V_k`; of a vector `|d_k|` is the length.
    pub l1: f64,
    /// `(Σ V_k d_k² / Σ V_k)^(1/2)`.
    pub l2: f64,
    /// `max_k |d_k|`.
    pub linf: f64,
    /// `l2` over the same norm of the field itself in the reference, of positions over the longest edge of
    /// the domain; `None` of a field that is 0.
    pub relative_l2: Option<f64>,
    /// Significant bits kept: `-log2(relative_l2)`; `None` where nothing differs, or of a field that is
    /// 0.
    pub bits: Option<f64>,
}

/// Where particles are compared, and which way round a periodic domain a distance goes.
pub struct Matching<'a> {
    window: Window<'a>,
    /// Length of each edge, and whether it is periodic.
    edges: Vec<(f64, bool)>,
    is_open: bool,
}

impl<'a> Matching<'a> {
    /// The window and the domain of a scenario.
    pub fn of(scenario: &'a AnyScenario) -> Self {
        Self {
            window: Window {
                extent: scenario.window(),
                ring: scenario.ring(),
            },
            edges: edges(scenario),
            is_open: is_open(scenario),
        }
    }

    /// Why the particles of two runs cannot be matched, if they cannot.
    pub fn obstacle(&self, reference: &LastState, other: &LastState) -> Option<String> {
        if self.is_open {
            return Some(
                "particles come and go: one of a run has no partner in another".to_owned(),
            );
        }
        let [here, there] = [other, reference].map(LastState::particles);
        (here != there).then(|| format!("{here} particles have no {there} partners"))
    }

    /// The difference in each field; none without particles in the window.
    pub fn differences(
        &self,
        reference: &LastState,
        other: &LastState,
    ) -> BTreeMap<String, Difference> {
        let mut sums = vec![[NormSums::default(); 2]; reference.spans.len()];
        for ((portion, right), (_, found)) in reference.rows().zip(other.rows()) {
            if !self.window.contains(&position(right, self.edges.len())) {
                continue;
            }
            for (span, [off, size]) in reference.spans.iter().zip(&mut sums) {
                let places = || span.places.clone();
                let (right, found) = (&right[places()], &found[places()]);
                let apart = right.iter().zip(found).map(|(right, found)| found - right);
                let error = match span.name == POSITION {
                    true => length(apart.zip(&self.edges).map(|(d, edge)| shortest(d, *edge))),
                    false => length(apart),
                };
                off.add(portion, error, 0.0);
                size.add(portion, length(right.iter().copied()), 0.0);
            }
        }
        let longest = self.edges.iter().fold(0.0, |most, edge| edge.0.max(most));
        let spans = reference.spans.iter().zip(sums);
        let field = |(span, [off, size]): (&super::last::Span, [NormSums; 2])| {
            let (off, size) = (off.norms()?, size.norms()?);
            let size = match span.name == POSITION {
                true => longest,
                false => size.l2,
            };
            let relative_l2 = (size > 0.0).then(|| off.l2 / size);
            let bits = relative_l2.filter(|off| *off > 0.0).map(|off| -off.log2());
            let difference = Difference {
                l1: off.l1,
                l2: off.l2,
                linf: off.linf,
                relative_l2,
                bits,
            };
            Some((span.name.clone(), difference))
        };
        spans.filter_map(field).collect()
    }

    /// The L2 norm of a field itself over the window; `None` of one that there is not, and without
    /// particles in the window.
    pub fn size(&self, state: &LastState, field: &str) -> Option<f64> {
        let span = state.spans.iter().find(|span| span.name == field)?;
        let mut sums = NormSums::default();
        for (portion, values) in state.rows() {
            if self.window.contains(&position(values, self.edges.len())) {
                let values = values[span.places.clone()].iter().copied();
                sums.add(portion, length(values), 0.0);
            }
        }
        sums.norms().map(|norms| norms.l2)
    }
}

/// The position that the values of a particle begin with; 0 beyond the dimension.
fn position(values: &[f64], dimension: usize) -> [f64; 3] {
    std::array::from_fn(|axis| match axis < dimension {
        true => values[axis],
        false => 0.0,
    })
}

/// A distance along an edge, the shorter way round where it is periodic.
fn shortest(distance: f64, (edge, is_periodic): (f64, bool)) -> f64 {
    match is_periodic {
        true => distance - edge * (distance / edge).round(),
        false => distance,
    }
}

fn length(values: impl Iterator<Item = f64>) -> f64 {
    values.map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::Source;

    /// `sod` in a window of [-0.5, 0.5], `sound-wave` in a periodic domain of length 1.
    fn scenario(name: &str) -> AnyScenario {
        AnyScenario::read(Source::BuiltIn(name.to_owned()), &[]).unwrap()
    }

    #[test]
    fn the_difference_is_that_of_the_particles_in_the_window() {
        let scenario = scenario("sod");
        let matching = Matching::of(&scenario);
        let right = LastState::line(&[(0.0, 1.0), (0.2, 1.0), (0.9, 5.0)]);
        let found = LastState::line(&[(0.0, 1.25), (0.3, 1.0), (0.9, 9.0)]);
        let all = matching.differences(&right, &found);
        let density = all["density"];
        assert_eq!((density.l1, density.linf), (0.125, 0.25));
        assert_eq!(density.l2, (0.5f64 * 0.0625).sqrt());
        // The field is 1 in the window: 1/4 over the root of 2.
        assert_eq!(density.bits, Some(2.5));
        assert_eq!(matching.size(&right, "density"), Some(1.0));
        // Over the length of the domain, 2.
        let moved = all[POSITION].relative_l2.unwrap();
        assert!((moved - 0.5f64.sqrt() * 0.1 / 2.0).abs() < 1e-15);
        let same = matching.differences(&right, &right)["density"];
        assert_eq!((same.relative_l2, same.bits), (Some(0.0), None));
    }

    #[test]
    fn a_periodic_distance_is_the_shorter_one() {
        let scenario = scenario("sound-wave");
        let matching = Matching::of(&scenario);
        let right = LastState::line(&[(0.999, 0.0)]);
        let found = LastState::line(&[(0.001, 0.0)]);
        let all = matching.differences(&right, &found);
        assert!((all[POSITION].linf - 0.002).abs() < 1e-15);
        // A field of 0 has no relative difference.
        assert_eq!(all["density"].relative_l2, None);
    }

    #[test]
    fn particles_without_partners_are_told() {
        let (sod, tunnel) = (scenario("sod"), scenario("wind-tunnel"));
        let [two, one] = [&[(0.0, 1.0), (0.1, 1.0)][..], &[(0.0, 1.0)]].map(LastState::line);
        let obstacle = |scenario, a, b| Matching::of(scenario).obstacle(a, b);
        assert_eq!(obstacle(&sod, &two, &two), None);
        assert!(obstacle(&sod, &two, &one).unwrap().contains("1 particles"));
        assert!(
            obstacle(&tunnel, &two, &two)
                .unwrap()
                .contains("come and go")
        );
    }
}
