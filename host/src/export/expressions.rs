//! Formulas of place and time as Rust expressions.

use crate::scenario::formula::Formula;

/// The variables of formulas of place and time.
pub(super) const VARIABLES: [&str; 4] = ["x", "y", "z", "t"];

/// Formulas that are evaluated at one place.
pub(super) struct Expressions<'a> {
    formulas: &'a [Formula],
}

impl<'a> Expressions<'a> {
    /// These formulas.
    pub fn of(formulas: &'a [Formula]) -> Self {
        Self { formulas }
    }

    fn uses(&self, variable: usize) -> bool {
        let mut formulas = self.formulas.iter();
        formulas.any(|formula| formula.depends_on(variable))
    }

    /// The name of the place: with a bar in front where nothing depends on it.
    pub fn place(&self) -> &'static str {
        match (0..VARIABLES.len()).any(|variable| self.uses(variable)) {
            true => "place",
            false => "_",
        }
    }

    /// The line that takes the variables from `place`; nothing where none is used.
    pub fn point(&self) -> String {
        match self.place() {
            "place" => format!("        let {} = FRAME.point(place);\n", self.pattern(4)),
            _ => String::new(),
        }
    }

    /// A pattern of the variables that are used, of so many; unknowns behind place and time.
    pub fn pattern(&self, length: usize) -> String {
        let names: Vec<String> = (0..length)
            .map(|variable| match self.uses(variable) {
                true => variable_name(variable),
                false => "_".to_owned(),
            })
            .collect();
        format!("[{}]", names.join(", "))
    }

    /// An expression, its further lines behind so many blanks.
    pub fn expression(formula: &Formula, indent: usize) -> String {
        let names: Vec<String> = (0..8).map(variable_name).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        formula.rust(&names, indent)
    }

    /// A line for each, its value passed to a function of that name; zeros up to that length.
    pub fn rows(&self, function: &str, length: usize) -> String {
        let row = |formula: &Formula| {
            let value = Self::expression(formula, 12);
            format!("            {function}({value}),\n")
        };
        let zeros = length.saturating_sub(self.formulas.len());
        let rows = self.formulas.iter().map(row);
        rows.chain(vec!["            S::ZERO,\n".to_owned(); zeros])
            .collect()
    }

    /// A line for each.
    pub fn list(&self) -> String {
        let row = |formula: &Formula| format!("        {},\n", Self::expression(formula, 8));
        self.formulas.iter().map(row).collect()
    }

    /// Their sum, from the first on.
    pub fn sum(&self) -> String {
        let terms = self.formulas.iter().map(|formula| {
            let term = Self::expression(formula, 8);
            match term.contains(' ') && self.formulas.len() > 1 {
                true => format!("({term})"),
                false => term,
            }
        });
        terms.collect::<Vec<_>>().join(" + ")
    }
}

/// `x`, `y`, `z`, `t`, `u0`, `u1`, ...
fn variable_name(variable: usize) -> String {
    match VARIABLES.get(variable) {
        Some(name) => (*name).to_owned(),
        None => format!("u{}", variable - VARIABLES.len()),
    }
}
