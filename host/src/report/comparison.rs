//! What `motes compare` tells: tables for people, as text and as Markdown, and a picture.

mod markdown;
mod parts;
mod picture;
mod table;

use std::fmt;

use crate::precision::{Comparison, Refusal};
use parts::{conclusions, differences, drifts, formats, refusals, title};

pub use markdown::markdown;
pub use picture::picture;

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", title(self))?;
        write!(f, "{}", formats(self))?;
        for table in [differences(self), drifts(self)] {
            if !table.rows.is_empty() {
                write!(f, "\n{table}")?;
            }
        }
        let refusals = refusals(self);
        if !refusals.is_empty() {
            writeln!(f)?;
        }
        for (scalar, Refusal { refused, cure }) in refusals {
            writeln!(f, "{scalar} did not run: {refused}")?;
            if let Some(cure) = cure {
                writeln!(f, "  cure: {cure}")?;
            }
        }
        let conclusions = conclusions(self);
        if !conclusions.is_empty() {
            writeln!(f)?;
        }
        for (what, text) in conclusions {
            writeln!(f, "{what:<11}{text}")?;
        }
        for warning in &self.warnings {
            writeln!(f, "warning: {warning}")?;
        }
        Ok(())
    }
}
