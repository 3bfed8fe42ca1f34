//! The error of reading a scenario, with the place in the text it comes from.

use std::fmt;
use std::ops::Range;

use miette::{Diagnostic, LabeledSpan, SourceCode};

use crate::problem::Problem;
use crate::snippet::Snippet;

/// Why a scenario was refused, where in which text, and what to do.
///
/// As a `miette::Report` it prints `file:line:column`, the line itself and the cure.
#[derive(Debug)]
pub struct ScenarioError(Box<Located>);

#[derive(Debug)]
struct Located {
    problem: Problem,
    place: Option<Snippet>,
}

/// A stretch of a named text.
#[derive(Debug)]
pub(super) struct Place {
    /// What the text is called: a path, a built-in name, `--set`.
    pub name: String,
    /// The whole text.
    pub text: String,
    /// Bytes of the text.
    pub span: Range<usize>,
}

/// A problem at some bytes of the scenario, or of a file that it names.
#[derive(Debug)]
pub(super) struct Fault {
    pub problem: Box<Problem>,
    pub span: Range<usize>,
    /// What the bytes are of, where it is not the scenario: name and text.
    file: Option<Box<(String, String)>>,
}

impl Fault {
    pub fn new(problem: Problem, span: Range<usize>) -> Self {
        let problem = Box::new(problem);
        Self {
            problem,
            span,
            file: None,
        }
    }

    /// A problem at some bytes of a file that the scenario names.
    pub fn of_file(problem: Problem, span: Range<usize>, name: String, text: String) -> Self {
        Self {
            file: Some(Box::new((name, text))),
            ..Self::new(problem, span)
        }
    }

    /// The error, once it is known what the scenario is called and how it reads.
    pub fn within(self, name: &str, text: &str) -> ScenarioError {
        let (name, text) = match self.file {
            Some(file) => *file,
            None => (name.to_owned(), text.to_owned()),
        };
        let span = self.span;
        ScenarioError::new(*self.problem, Place { name, text, span })
    }
}

impl ScenarioError {
    pub(super) fn new(problem: Problem, place: Place) -> Self {
        let place = Some(Snippet::new(place.name, place.text, place.span));
        Self(Box::new(Located { problem, place }))
    }

    pub(super) fn without_place(problem: Problem) -> Self {
        let place = None;
        Self(Box::new(Located { problem, place }))
    }

    /// What is wrong.
    pub fn problem(&self) -> &Problem {
        &self.0.problem
    }

    /// Line and column, each from 1, unless no text could be read.
    pub fn line_and_column(&self) -> Option<(usize, usize)> {
        self.0.place.as_ref()?.line_and_column()
    }
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.problem.fmt(formatter)
    }
}

impl std::error::Error for ScenarioError {}

impl Diagnostic for ScenarioError {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.0.problem.help()))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        let place = self.0.place.as_ref()?;
        Some(place)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let place = self.0.place.as_ref()?;
        Some(Box::new(std::iter::once(place.label())))
    }
}
