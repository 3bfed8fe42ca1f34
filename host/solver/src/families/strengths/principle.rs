//! The maximum principle of diffusion, held against what a run has come to.

use motes_core::cutoff::CutOff;

use super::plan::Plan;
use crate::run::Series;
use crate::scenario::linear::{Drive, Field, Form, Reaction, System, WallCondition};

/// The part of its range by which a state may leave it: what steps of the stabilised method do.
const BEYOND: f64 = 1e-3;

/// Species beyond what the start and the walls allow. The maximum principle: diffusion alone, in a
/// flow without sources, makes no value that there was not at the start or at a wall. A cut-off of
/// higher order is negative somewhere and promises none of it.
pub(super) fn beyond(plan: &Plan, series: &Series) -> Vec<String> {
    let System::ConvectionDiffusion(of) = &plan.system else {
        return Vec::new();
    };
    let spreads = |field: &Field| {
        !matches!(
            field,
            Field::Still | Field::Uniform { .. } | Field::Rotation { .. } | Field::Shear { .. }
        )
    };
    if of.reaction != Reaction::None || spreads(&of.velocity) || plan.cut_off.order() > 2 {
        return Vec::new();
    }
    let species = plan.names.iter().enumerate();
    let beyond = species.filter_map(|(i, name)| {
        let conditions = of.walls.iter().flatten().map(|species| &species[i]);
        let mut allowed = Allowed::default();
        for condition in conditions {
            match condition {
                WallCondition::Flux(Drive::Constant(flux)) if *flux == 0.0 => {}
                WallCondition::Flux(_) => return None,
                condition => match condition.drive() {
                    None => {}
                    Some(Drive::Constant(value)) => allowed.add(*value),
                    Some(drive @ Drive::Formula(_)) => {
                        let points = drive.sampled(plan.duration, 1024);
                        points.iter().for_each(|&(_, value)| allowed.add(value));
                    }
                    Some(Drive::Series(series)) => {
                        series.values.iter().for_each(|&value| allowed.add(value));
                    }
                },
            }
        }
        let [least, most] = ["min", "max"].map(|part| series.of(&format!("{name}_{part}")));
        allowed.add(*least.first()?);
        allowed.add(*most.first()?);
        let room = BEYOND * (allowed.most - allowed.least).max(f64::MIN_POSITIVE);
        let times = || series.samples.iter().map(|sample| sample.time);
        let low = times().zip(&least).min_by(|a, b| a.1.total_cmp(b.1))?;
        let high = times().zip(&most).max_by(|a, b| a.1.total_cmp(b.1))?;
        let (time, value, bound, side) = match (low, high) {
            ((t, &u), _) if u < allowed.least - room => (t, u, allowed.least, "below"),
            (_, (t, &u)) if u > allowed.most + room => (t, u, allowed.most, "above"),
            _ => return None,
        };
        let cure = match of.form {
            Form::Mixed => "set system.form = \"direct\", or use more particles",
            Form::Direct => "use more particles, a smaller time.courant, or particles that follow \
                             the flow",
        };
        Some(format!(
            "{name} is {value:.4e} at t = {time:?}, {side} the {bound:.4e} of the start and the walls, \
             which diffusion alone never is: {cure}"
        ))
    });
    beyond.collect()
}

/// The least and the largest of some values.
struct Allowed {
    least: f64,
    most: f64,
}

impl Default for Allowed {
    fn default() -> Self {
        Self {
            least: f64::INFINITY,
            most: f64::NEG_INFINITY,
        }
    }
}

impl Allowed {
    fn add(&mut self, value: f64) {
        (self.least, self.most) = (self.least.min(value), self.most.max(value));
    }
}
