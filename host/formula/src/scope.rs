//! The names that a formula may use.

use std::collections::BTreeMap;

use crate::error::{FormulaError, FormulaFault};
use crate::formula::Formula;
use crate::function::{BINARY, FUNCTIONS};
use crate::graph::Graph;
use crate::parser::Parser;
use crate::token::is_letter;

/// Variables, whose values come with every evaluation, and definitions.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scope {
    pub(crate) variables: Vec<String>,
    pub(crate) definitions: BTreeMap<String, Definition>,
}

/// A constant or function of the user.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Definition {
    /// `None`: a constant, written without parentheses.
    pub parameters: Option<Vec<String>>,
    pub text: String,
}

/// The constant of every scope.
pub(crate) const PI: &str = "pi";
/// The choice of every scope: `if(condition, a, b)`.
pub(crate) const IF: &str = "if";

impl Scope {
    /// A scope of variables, in the order in which evaluations give their values. An empty name keeps
    /// a place in that order for a value that no formula may use.
    pub fn new<'n>(variables: impl IntoIterator<Item = &'n str>) -> Self {
        Self {
            variables: variables.into_iter().map(str::to_owned).collect(),
            definitions: BTreeMap::new(),
        }
    }

    /// The same definitions with other variables.
    pub fn with_variables<'n>(&self, variables: impl IntoIterator<Item = &'n str>) -> Self {
        Self {
            definitions: self.definitions.clone(),
            ..Self::new(variables)
        }
    }

    /// Adds a constant, `k`, or a function, `c(s)`. It may use what is defined later.
    ///
    /// # Errors
    /// A head that is no name or whose name is taken; its `span` is of the head. What is wrong with
    /// the text is found where the definition is used, and by [`Scope::check`].
    pub fn define(&mut self, head: &str, text: &str) -> Result<(), FormulaError> {
        let bad = |reason: &str| {
            let (name, reason) = (head.to_owned(), reason.to_owned());
            FormulaError::new(FormulaFault::BadName { name, reason }, 0..head.len())
        };
        let (name, parameters) = match head.split_once('(') {
            None => (head.trim(), None),
            Some((name, rest)) => {
                let inside = rest.trim_end().strip_suffix(')');
                let inside = inside.ok_or_else(|| bad("its parenthesis is not closed"))?;
                let parameters = inside.split(',').map(|part| part.trim().to_owned());
                (name.trim(), Some(parameters.collect::<Vec<_>>()))
            }
        };
        if ![name]
            .into_iter()
            .chain(parameters.iter().flatten().map(String::as_str))
            .all(is_name)
        {
            return Err(bad("it is no name"));
        }
        if self.variables.iter().any(|variable| variable == name) {
            return Err(bad("it is a variable"));
        }
        if name == PI
            || name == IF
            || FUNCTIONS.iter().any(|of| of.0 == name)
            || BINARY.iter().any(|of| of.0 == name)
        {
            return Err(bad("every formula has it already"));
        }
        if parameters
            .iter()
            .flatten()
            .any(|parameter| parameter == name)
        {
            return Err(bad("an argument has its name"));
        }
        let text = text.to_owned();
        match self
            .definitions
            .insert(name.to_owned(), Definition { parameters, text })
        {
            None => Ok(()),
            Some(_) => Err(bad("it is defined already")),
        }
    }

    /// Whether a variable or a definition has that name.
    pub fn has(&self, name: &str) -> bool {
        self.variables.iter().any(|of| of == name) || self.definitions.contains_key(name)
    }

    /// That every definition can be read, used or not.
    ///
    /// # Errors
    /// The first that cannot.
    pub fn check(&self) -> Result<(), FormulaError> {
        let mut graph = Graph::default();
        for (name, definition) in &self.definitions {
            let parameters = definition.parameters.iter().flatten().enumerate();
            // Arguments are any numbers: as if they were variables beyond those of the scope.
            let arguments = parameters.map(|(i, parameter)| {
                (parameter.clone(), graph.variable(self.variables.len() + i))
            });
            let arguments: Vec<_> = arguments.collect();
            Parser::definition(self, &mut graph, name, &arguments)?;
        }
        Ok(())
    }

    /// Reads a formula.
    ///
    /// # Errors
    /// What cannot be read, with its place.
    pub fn formula(&self, text: &str) -> Result<Formula, FormulaError> {
        let mut graph = Graph::default();
        let result = Parser::formula(self, &mut graph, text)?;
        Ok(Formula::new(text, &graph, result))
    }

    /// The names of a scope, for a message: variables, definitions, constants and functions.
    pub(crate) fn names(&self) -> Vec<String> {
        let defined =
            self.definitions
                .iter()
                .map(|(name, definition)| match definition.parameters {
                    Some(_) => format!("{name}()"),
                    None => name.clone(),
                });
        let variables = self.variables.iter().filter(|name| !name.is_empty());
        let mut names: Vec<String> = variables.cloned().chain(defined).collect();
        names.push(PI.to_owned());
        let functions = FUNCTIONS
            .iter()
            .map(|of| of.0)
            .chain(BINARY.iter().map(|of| of.0));
        names.extend(functions.chain([IF]).map(|name| format!("{name}()")));
        names
    }
}

/// Whether a variable or a definition may be called so.
pub fn is_name(name: &str) -> bool {
    name.starts_with(is_letter) && name.chars().all(|c| is_letter(c) || c.is_ascii_digit())
}
