//! Where a scenario's text comes from.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::builtin::{BUILT_IN, built_in};
use crate::error::{Place, ScenarioError};
use crate::files::Files;
use crate::problem::Problem;
use crate::read::{self, MOST_OF_SCENARIO, Unread};

/// What a scenario is read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Source {
    /// A scenario that comes with the program, by its name.
    BuiltIn(String),
    /// A TOML file.
    File(PathBuf),
    /// TOML itself. Files that it names are looked for in the current folder.
    Text(String),
    /// TOML that was made of another source: files that it names are looked for where that one's are.
    Kept {
        /// The TOML.
        text: String,
        /// What it was made of.
        of: Box<Source>,
    },
}

impl From<&str> for Source {
    /// A command-line argument: a file if it ends in `.toml` or contains a path
    /// separator, else a built-in name. So no file lying about can shadow a name.
    fn from(argument: &str) -> Self {
        let is_file = argument.ends_with(".toml") || argument.contains(std::path::is_separator);
        if is_file {
            Self::File(PathBuf::from(argument))
        } else {
            Self::BuiltIn(argument.to_owned())
        }
    }
}

impl fmt::Display for Source {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BuiltIn(name) => write!(formatter, "{name} (built in)"),
            Self::File(path) => write!(formatter, "{}", path.display()),
            Self::Text(_) => write!(formatter, "a text"),
            Self::Kept { of, .. } => of.fmt(formatter),
        }
    }
}

impl Source {
    /// Where files named in the text are looked for.
    pub(super) fn files(&self) -> Files<'_> {
        match self {
            Self::BuiltIn(_) => Files::Shipped,
            Self::File(path) => Files::Folder(path.parent().unwrap_or(Path::new(""))),
            Self::Text(_) => Files::Folder(Path::new("")),
            Self::Kept { of, .. } => of.files(),
        }
    }

    /// The TOML text as it stands there.
    ///
    /// # Errors
    /// An unknown built-in name; a file that is missing, is a directory, a pipe or a device, is
    /// longer than 16 MiB, cannot be read or is not UTF-8.
    pub fn text(&self) -> Result<String, ScenarioError> {
        match self {
            Self::BuiltIn(name) => built_in(name)
                .map(|scenario| scenario.text.to_owned())
                .ok_or_else(|| unknown_built_in(name)),
            Self::File(path) => file_text(path),
            Self::Text(text) | Self::Kept { text, .. } => Ok(text.clone()),
        }
    }
}

fn unknown_built_in(name: &str) -> ScenarioError {
    ScenarioError::without_place(Problem::UnknownBuiltIn {
        name: name.to_owned(),
        known: BUILT_IN.iter().map(|scenario| scenario.name).collect(),
    })
}

fn file_text(path: &Path) -> Result<String, ScenarioError> {
    let file = path.to_path_buf();
    let bytes = read::bytes(path, MOST_OF_SCENARIO).map_err(|unread| {
        ScenarioError::without_place(match unread {
            Unread::Missing => Problem::NoSuchFile { file },
            Unread::Directory => Problem::Directory { file },
            Unread::NotRegular => Problem::NotRegular { file },
            Unread::TooLong(most) => Problem::TooLong { file, most },
            Unread::Refused(error) => Problem::Unreadable { file, error },
        })
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let offset = error.utf8_error().valid_up_to();
        let bytes = error.as_bytes();
        let byte = bytes.get(offset).copied().unwrap_or_default();
        ScenarioError::new(
            Problem::NotUtf8 { byte },
            Place {
                // Lossy text has the same bytes up to the fault, so the span holds in it.
                text: String::from_utf8_lossy(bytes).into_owned(),
                name: path.display().to_string(),
                span: offset..offset + char::REPLACEMENT_CHARACTER.len_utf8(),
            },
        )
    })
}
