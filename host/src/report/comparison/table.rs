//! A table of words and numbers, as text and as Markdown.

use std::fmt;

/// Rows under a heading; the first columns hold names, the rest numbers.
pub(super) struct Table {
    /// What the columns are called.
    pub heading: Vec<String>,
    /// How many columns hold names.
    pub names: usize,
    /// As many words each as the heading has.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// The same in Markdown.
    pub fn markdown(&self) -> String {
        let line = |words: &[String]| format!("| {} |\n", words.join(" | "));
        let rule = vec!["---".to_owned(); self.heading.len()];
        let rows = self.rows.iter().map(|row| line(row));
        [line(&self.heading), line(&rule)]
            .into_iter()
            .chain(rows)
            .collect()
    }
}

/// Names to the left, numbers to the right.
impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines = || std::iter::once(&self.heading).chain(&self.rows);
        let width = |column: usize| {
            let words = lines().filter_map(|row| row.get(column));
            words.map(String::len).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.heading.len()).map(width).collect();
        for row in lines() {
            let words = row.iter().zip(&widths).enumerate();
            let cells = words.map(|(column, (word, &width))| match column < self.names {
                true => format!("{word:<width$}"),
                false => format!("{word:>width$}"),
            });
            writeln!(f, "{}", cells.collect::<Vec<_>>().join("  ").trim_end())?;
        }
        Ok(())
    }
}
