//! What formulas say of a convection-diffusion problem, as Rust source.

use std::fmt::Write;

use motes_core::equation::diffusion::LargestDiffusivity;

use super::expressions::Expressions;
use super::module::{Module, literal};
use super::problem::DIFFUSION;
use crate::families::diffusion::{Formulas, MARGIN};
use crate::families::strengths::Plan;

/// Whether formulas say anything of a problem.
pub(super) fn is_written(formulas: &Formulas) -> bool {
    !(formulas.diffusivity.is_empty() && formulas.rates.is_empty() && formulas.walls.is_empty())
}

/// A problem of formulas in the place of some of its numbers: a type `Problem`.
pub(super) fn written<const D: usize, const P: usize>(
    module: &mut Module,
    plan: &Plan,
    formulas: &Formulas,
) {
    module.import(DIFFUSION, ["Condition", "DiffusionProblem"]);
    module.import("motes_core::equation::linear", ["Place"]);
    module.frame(plan.frame());
    let (diffusivity, headroom) = (diffusivity(formulas, P), headroom(module, formulas.peaks()));
    let (reaction, bounds) = reaction::<P>(module, formulas);
    let walls = walls(formulas);
    module.item(
        format!(
            "/// The problem: what formulas say, and the rest.
#[derive(Clone, Copy, Debug)]
pub struct Problem<'m, S> {{
    /// The rest.
    pub named: NamedProblem<'m, S, {D}, {P}>,
}}

impl<S: Scalar> DiffusionProblem<S, {D}, {P}> for Problem<'_, S> {{
    fn diffusivity(&self, {diffusivity}    }}
    fn between(&self, ends: [S; 2], time: S) -> Option<[S; {P}]> {{
        DiffusionProblem::<S, {D}, {P}>::between(&self.named, ends, time)
    }}
    fn headroom(&self, time: S) -> S {{
{headroom}    }}
    fn tensor(&self) -> Option<[[S; {D}]; {D}]> {{
        self.named.tensor
    }}
    fn reaction(&self, {reaction}    }}
{bounds}    fn wall(&self, axis: usize, end: usize, time: S) -> [Condition<S>; {P}] {{
{walls}    }}
}}\n"
        )
        .replace("Place<S, D>", &format!("Place<S, {D}>")),
    );
}

/// The arguments and the body of the diffusivity.
fn diffusivity(formulas: &Formulas, row: usize) -> String {
    let of = Expressions::of(&formulas.diffusivity);
    if formulas.diffusivity.is_empty() {
        return format!(
            "place: &Place<S, D>) -> [S; {row}] {{\n        self.named.diffusivity(place)\n"
        );
    }
    format!(
        "{}: &Place<S, D>) -> [S; {row}] {{\n{}        [\n{}        ]\n",
        of.place(),
        of.point(),
        of.rows("FRAME.diffusivity", row)
    )
}

/// The body of the headroom.
fn headroom(module: &mut Module, peaks: LargestDiffusivity<'_>) -> String {
    if peaks.values.is_empty() {
        return "        self.named.modulation.headroom(time)\n".to_owned();
    }
    module.import(DIFFUSION, ["LargestDiffusivity"]);
    let LargestDiffusivity {
        values,
        duration,
        margin,
    } = peaks;
    module.item(format!(
        "/// The largest diffusivity of the domain, in the scenario's units.
const PEAKS: LargestDiffusivity<'static> = LargestDiffusivity {{
    values: &{values:?},
    duration: {duration:?},
    margin: {margin:?},
}};\n"
    ));
    "        S::from_f64(PEAKS.headroom(FRAME.seconds(time)))\n".to_owned()
}

/// The arguments and the body of the reaction, and the two functions that bound it.
fn reaction<const P: usize>(module: &mut Module, formulas: &Formulas) -> (String, String) {
    let count = formulas.rates.len();
    if count == 0 {
        return (
            format!(
                "_: &Place<S, D>, u: &[S; {P}]) -> [S; {P}] {{\n        self.named.reaction.rate(u)\n"
            ),
            "    fn reaction_rate(&self) -> S {
        self.named.reaction.bound()
    }
    fn largest_reaction(&self, u: f64) -> f64 {
        self.named.reaction.largest(u)
    }\n"
            .to_owned(),
        );
    }
    module.import(DIFFUSION, ["ReactionPoint", "Corners"]);
    let of = Expressions::of(&formulas.rates);
    let corners = formulas.corners;
    module.item(format!(
        "/// The rates of the reaction at a place, a time and unknowns, in the scenario's units.
fn rates(&{pattern}: &ReactionPoint) -> [f64; {count}] {{
    [
{rates}    ]
}}

/// Where they are looked at for the largest.
const CORNERS: Corners = Corners {{
    dimension: {},
    species: {},
    middle: {:?},
    half: {:?},
    duration: {:?},
}};\n",
        corners.dimension,
        corners.species,
        corners.middle,
        corners.half,
        corners.duration,
        pattern = of.pattern(8),
        rates = of.list(),
    ));
    let rows: String = (0..P)
        .map(|j| match j < count {
            true => format!("            FRAME.rate(rates[{j}]),\n"),
            false => "            S::ZERO,\n".to_owned(),
        })
        .collect();
    let body = format!(
        "place: &Place<S, D>, u: &[S; {P}]) -> [S; {P}] {{
        let [x, y, z, t] = FRAME.point(place);
        let mut point = [x, y, z, t, 0.0, 0.0, 0.0, 0.0];
        for (slot, u) in point.iter_mut().skip(4).zip(u) {{
            *slot = u.to_f64();
        }}
        let rates = rates(&point);
        [
{rows}        ]\n"
    );
    let bounds = format!(
        "    fn reaction_rate(&self) -> S {{
        FRAME.rate({})
    }}
    fn largest_reaction(&self, u: f64) -> f64 {{
        let mut largest = 0.0;
        CORNERS.each(u, |point| {{
            for rate in rates(point) {{
                largest = f64::max(largest, libm::fabs(rate));
            }}
        }});
        {MARGIN:?} * largest * FRAME.units.time()
    }}\n",
        literal(formulas.stiffness)
    );
    (body, bounds)
}

/// The body of the conditions at walls.
fn walls(formulas: &Formulas) -> String {
    let named = "self.named.wall(axis, end, time)";
    if formulas.walls.is_empty() {
        return format!("        {named}\n");
    }
    let mut text = format!("        let mut conditions = {named};\n");
    let numbers = formulas.walls.iter();
    if numbers.clone().any(|wall| wall.number.depends_on(3)) {
        text += "        let t = FRAME.seconds(time);\n";
    }
    for wall in numbers {
        let (axis, end, j) = (wall.axis, wall.end, wall.species);
        let number = Expressions::expression(&wall.number, 16);
        let rounded = match wall.is_flux {
            true => "FRAME.velocity",
            false => "FRAME.number",
        };
        let _ = write!(
            text,
            "        if (axis, end) == ({axis}, {end}) {{
            conditions[{j}] = conditions[{j}].with({rounded}({number}));
        }}\n"
        );
    }
    text + "        conditions\n"
}
