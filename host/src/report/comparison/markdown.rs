//! The comparison as Markdown.

use super::parts::{conclusions, differences, drifts, formats, refusals, title};
use crate::precision::Comparison;

/// Its tables, for a report; `command`, one line, is what made it, `picture` the name of the file beside it.
pub fn markdown(comparison: &Comparison, command: &str, picture: &str) -> String {
    let mut text = format!("# {}\n\n    {command}\n\n", title(comparison));
    text += &formats(comparison).markdown();
    text += "\nSteps a second are those of runs side by side. Bits kept: the binary digits in which a field \
             agrees with the reference, -log2 of the relative L2 difference.\n";
    text += &format!("\n![difference and error over the step of the format]({picture})\n");
    for table in [differences(comparison), drifts(comparison)] {
        if !table.rows.is_empty() {
            text += &format!("\n{}", table.markdown());
        }
    }
    let mut items = Vec::new();
    for (scalar, refusal) in refusals(comparison) {
        let cure = refusal.cure.iter().map(|cure| format!(" ({cure})"));
        items.push(format!(
            "**{scalar} did not run**: {}{}",
            refusal.refused,
            cure.collect::<String>()
        ));
    }
    let said = conclusions(comparison).into_iter();
    items.extend(said.map(|(what, text)| format!("**{what}**: {text}")));
    let warnings = comparison.warnings.iter();
    items.extend(warnings.map(|warning| format!("**warning**: {warning}")));
    if !items.is_empty() {
        text += &format!("\n- {}\n", items.join("\n- "));
    }
    text
}
