//! Where the files are that a scenario names.

use std::borrow::Cow;
use std::path::Path;

use crate::builtin::shipped_file;
use crate::entry::Entry;
use crate::error::Fault;
use crate::read::{self, MOST_OF_TABLE, Unread};

/// Where the files are that a scenario names.
#[derive(Debug, Clone, Copy)]
pub(super) enum Files<'a> {
    /// Of a built-in scenario: those that come with the program, others in the current folder.
    Shipped,
    /// In the folder of the scenario.
    Folder(&'a Path),
}

/// The text of a file, and what errors call it.
pub(super) struct FileText {
    /// A path, or the name of a file that comes with the program.
    pub name: String,
    /// All of it.
    pub text: Cow<'static, str>,
}

impl Files<'_> {
    /// The folder that they are in.
    pub fn folder(&self) -> &Path {
        match self {
            Self::Shipped => Path::new(""),
            Self::Folder(folder) => folder,
        }
    }

    /// The text of the file that an entry names.
    ///
    /// # Errors
    /// A file that is missing, cannot be read or is not UTF-8.
    pub fn text(&self, entry: &Entry<'_>) -> Result<FileText, Fault> {
        let name = entry.text()?;
        let shipped = shipped_file(name);
        if let (Self::Shipped, Some(file)) = (self, shipped) {
            return Ok(FileText {
                name: format!("{name} (built in)"),
                text: Cow::Borrowed(file.text),
            });
        }
        let path = self.folder().join(name);
        let bytes = read::bytes(&path, MOST_OF_TABLE).map_err(|unread| {
            let reason = unread.message(&path.display().to_string());
            let cure = match unread {
                Unread::Missing => cure(name, &path, shipped.is_some()),
                _ => {
                    let usual = "give a file that may be read by you";
                    unread.cure().unwrap_or(usual).to_owned()
                }
            };
            entry.does_not_fit(reason, &cure)
        })?;
        let text = String::from_utf8(bytes).map_err(|_| {
            let reason = format!("`{}` is not UTF-8 text", path.display());
            entry.does_not_fit(reason, "give a CSV file with a heading, saved as UTF-8")
        })?;
        Ok(FileText {
            name: path.display().to_string(),
            text: Cow::Owned(text),
        })
    }
}

/// How a file comes to where it is looked for.
fn cure(name: &str, path: &Path, is_shipped: bool) -> String {
    if is_shipped {
        let path = path.display();
        return format!("`motes show {name} > {path}` writes the one that comes with motes");
    }
    "check its name: it is looked for in the folder of the scenario".to_owned()
}
