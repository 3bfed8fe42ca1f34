//! `[define]`: constants and functions for the formulas of a scenario.

use motes_formula::{Formula, FormulaError, FormulaFault, Scope, is_name};

use crate::entry::{ANY, Entry};
use crate::error::Fault;
use crate::keys::DEFINE;
use crate::problem::Problem;
use crate::section::Section;

/// The variables of a formula, in the order in which [`motes_formula::Formula::at`] takes them:
/// the place and the time. A direction beyond the dimension has no name.
const VARIABLES: [&str; 4] = ["x", "y", "z", "t"];

/// What the formulas of a scenario may use.
pub(super) struct Definitions<'a> {
    scope: Scope,
    /// Each head with the value that defines it.
    entries: Vec<(String, Entry<'a>)>,
}

impl<'a> Definitions<'a> {
    /// `[define]` of a scenario.
    ///
    /// # Errors
    /// A definition that cannot be read.
    pub fn of(root: &Section<'a>, dimension: usize) -> Result<Self, Fault> {
        let is_known = |i: usize| i < dimension || VARIABLES[i] == "t";
        let variables = (0..VARIABLES.len()).map(|i| if is_known(i) { VARIABLES[i] } else { "" });
        let mut definitions = Self {
            scope: Scope::new(variables),
            entries: Vec::new(),
        };
        let distance = ["abs(x)", "sqrt(x*x + y*y)", "sqrt(x*x + y*y + z*z)"][dimension - 1];
        let own = definitions.scope.define("r", distance);
        debug_assert!(own.is_ok());
        if let Some(entry) = root.optional(DEFINE) {
            for (head, entry) in entry.section()?.entries() {
                let text = text(&entry)?;
                let defined = definitions.scope.define(&head, &text);
                defined.map_err(|error| fault(&entry, &text, error))?;
                definitions.entries.push((head, entry));
            }
        }
        match definitions.scope.check() {
            Ok(()) => {}
            // It may be of the unknowns of a reaction: where it is used, they are known.
            Err(error) if matches!(error.fault, FormulaFault::Unknown { .. }) => {}
            Err(error) => return Err(definitions.located(error, None)),
        }
        Ok(definitions)
    }

    /// The same, for formulas of unknowns too. Their values follow those of place and time; each is
    /// known by its name, if that is one for formulas, and by its number, as `u0`.
    pub fn with_unknowns(&self, names: &[String]) -> Self {
        let own = VARIABLES.map(|name| if self.scope.has(name) { name } else { "" });
        let number = |i: usize| format!("u{i}");
        let numbers: Vec<String> = (0..names.len()).map(number).collect();
        let named = names.iter().zip(&numbers).map(|(name, number)| {
            let is_free =
                is_name(name) && !self.scope.has(name) && !VARIABLES.contains(&name.as_str());
            if is_free {
                name.as_str()
            } else {
                number.as_str()
            }
        });
        let mut scope = self.scope.with_variables(own.into_iter().chain(named));
        for (name, number) in names.iter().zip(&numbers) {
            if scope.has(name) && !scope.has(number) {
                let defined = scope.define(number, name);
                debug_assert!(defined.is_ok());
            }
        }
        Self {
            scope,
            entries: self.entries.clone(),
        }
    }

    /// The formula of a value: a number, or text.
    ///
    /// # Errors
    /// A formula that cannot be read.
    pub fn formula(&self, entry: &Entry<'_>) -> Result<Formula, Fault> {
        let text = text(entry)?;
        let formula = self.scope.formula(&text);
        formula.map_err(|error| self.located(error, Some((entry, &text))))
    }

    /// A list with one formula a component; of one component also without the brackets.
    ///
    /// # Errors
    /// Another length, or a formula that cannot be read.
    pub fn formulas(&self, entry: &Entry<'_>, components: usize) -> Result<Vec<Formula>, Fault> {
        if components == 1 && !entry.is_list() {
            return Ok(vec![self.formula(entry)?]);
        }
        let entries = entry.list("a list of formulas, one a component")?;
        if entries.len() != components {
            let found = entries.len();
            let reason = format!("its length is {found}, components = {components}");
            return Err(entry.does_not_fit(reason, "give one formula or number a component"));
        }
        entries.iter().map(|entry| self.formula(entry)).collect()
    }

    /// The fault of an error: in the formula, or in the definition that it is about.
    fn located(&self, error: FormulaError, formula: Option<(&Entry<'_>, &str)>) -> Fault {
        let name = error.definition.as_deref();
        let head = |head: &str| head.split('(').next().map(str::trim).map(str::to_owned);
        let defined = name.and_then(|name| {
            let mut entries = self.entries.iter();
            entries.find(|(of, _)| head(of).as_deref() == Some(name))
        });
        match (defined, formula) {
            (Some((_, entry)), _) => {
                let text = text(entry).unwrap_or_default();
                fault(entry, &text, error)
            }
            (None, Some((entry, text))) => fault(entry, text, error),
            (None, None) => unreachable!("only definitions are checked without a formula"),
        }
    }
}

/// A number or text, as text.
fn text(entry: &Entry<'_>) -> Result<String, Fault> {
    if entry.is_text() {
        return Ok(entry.text()?.to_owned());
    }
    let number = entry.number(ANY);
    let value = number.map_err(|_| entry.wrong_type("a number, or a formula in quotes"))?;
    Ok(value.to_string())
}

/// An error in the text of a value; its place is that in the text, where the value is written in
/// plain quotes.
fn fault(entry: &Entry<'_>, text: &str, error: FormulaError) -> Fault {
    let span = entry.span();
    let is_plain = entry.is_text() && span.len() == text.len() + 2;
    let at = match is_plain {
        true => span.start + 1 + error.span.start..span.start + 1 + error.span.end,
        false => span,
    };
    let problem = Problem::Formula {
        key: entry.key().to_owned(),
        text: entry.shown(),
        fault: error.fault,
    };
    Fault::new(problem, at)
}
