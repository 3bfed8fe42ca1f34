//! What comes in and goes out, against what a sum changes by.

use std::collections::BTreeMap;

use super::Series;

const AXES: [&str; 3] = ["x", "y", "z"];
const ENDS: [&str; 2] = ["lower", "upper"];

/// The name of a side in files: `x_lower`.
pub(crate) fn side(axis: usize, end: usize) -> String {
    format!("{}_{}", AXES[axis], ENDS[end])
}

/// The column of the time series for what has come in through a side.
pub(crate) fn inflow(axis: usize, end: usize, component: &str) -> String {
    format!("inflow_{}_{component}", side(axis, end))
}

/// Why the sum of a component is what it is at the end.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Balance {
    /// Name of the component.
    pub component: String,
    /// What its sum has changed by.
    pub change: f64,
    /// What has come in through each wall, below 0 where it went out.
    pub walls: BTreeMap<String, f64>,
    /// What reactions have made; `null` without any.
    pub reactions: Option<f64>,
    /// What is left of the change: rounding.
    pub residual: f64,
}

impl Balance {
    /// That of a component at the end of a run, from the columns of its series: of its sum, of what
    /// came through these sides (direction and end), and of what reactions made.
    pub(crate) fn of(
        series: &Series,
        (component, total): (&str, &str),
        sides: impl Iterator<Item = (usize, usize)>,
        reactions: Option<&str>,
    ) -> Self {
        let last = |name: &str| series.of(name).last().copied().unwrap_or(f64::NAN);
        let first = series.of(total).first().copied().unwrap_or(f64::NAN);
        let change = last(total) - first;
        let through = |(axis, end)| (side(axis, end), last(&inflow(axis, end, component)));
        let walls: BTreeMap<String, f64> = sides.map(through).collect();
        let reactions = reactions.map(last);
        let came = walls.values().chain(&reactions).sum::<f64>();
        Self {
            component: component.to_owned(),
            change,
            walls,
            reactions,
            residual: change - came,
        }
    }
}
