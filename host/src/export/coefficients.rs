//! Matrices of formulas as Rust source.

use super::expressions::Expressions;
use super::module::Module;
use crate::families::strengths::Plan;
use crate::scenario::formula::Formula;

/// Matrices of formulas: an item of the module.
pub(super) fn coefficients<const D: usize, const P: usize>(
    module: &mut Module,
    plan: &Plan,
    (size, flux, decay): (usize, &[Vec<Formula>], &[Formula]),
) {
    module.import("motes_core::equation::linear", ["Place"]);
    module.frame(plan.frame());
    let is_there = |formula: &Formula| formula.value() != Some(0.0);
    let entry = |formula: &Formula| Expressions::expression(formula, 8);
    let mut fluxes = String::new();
    for (i, matrix) in flux.iter().enumerate() {
        for (place, formula) in matrix.iter().enumerate().filter(|(_, of)| is_there(of)) {
            let (row, column) = (place / size, place % size);
            let value = entry(formula);
            fluxes += &format!("        flux[{i}][{row}][{column}] = FRAME.velocity({value});\n");
        }
    }
    let mut decays = String::new();
    for (place, formula) in decay.iter().enumerate().filter(|(_, of)| is_there(of)) {
        let (row, column) = (place / size, place % size);
        let value = entry(formula);
        decays += &format!("        rates[{row}] += FRAME.rate::<S>({value}) * u[{column}];\n");
    }
    let all: Vec<Formula> = flux.iter().flatten().cloned().collect();
    let (all, decay) = (Expressions::of(&all), Expressions::of(decay));
    // Without one the trait has zeros.
    let decay = match decays.is_empty() {
        true => String::new(),
        false => format!(
            "    fn decay(&self, {}: &Place<S, {D}>, u: &[S; {P}]) -> [S; {P}] {{
{}        let mut rates = [S::ZERO; {P}];
{decays}        rates
    }}\n",
            decay.place(),
            decay.point(),
        ),
    };
    module.item(format!(
        "/// The matrices: what formulas say.
#[derive(Clone, Copy, Debug)]
pub struct Coefficients;

impl<S: Scalar> MatrixField<S, {D}, {P}> for Coefficients {{
    fn flux(&self, {}: &Place<S, {D}>) -> [[[S; {P}]; {P}]; {D}] {{
{}        let mut flux = [[[S::ZERO; {P}]; {P}]; {D}];
{fluxes}        flux
    }}
{decay}}}\n",
        all.place(),
        all.point(),
    ));
}
