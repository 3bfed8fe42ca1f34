//! `motes new`.

use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use miette::{IntoDiagnostic, WrapErr, miette};

use super::Failure;
use super::arguments::NewArguments;
use crate::scenario::{AnyScenario, Source, shipped_file};

/// Writes a scenario of one's own, and the files that it names beside it. Nothing is written over.
pub(super) fn new(arguments: &NewArguments) -> Result<(), Failure> {
    let path = &arguments.file;
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    let is_toml = path.extension().is_some_and(|kind| kind == "toml");
    let (true, Some(stem)) = (is_toml, stem) else {
        return Err(Failure::Input(miette!(
            help = "give a name such as tube.toml",
            "`{}` does not end in .toml",
            path.display()
        )));
    };
    let source = Source::BuiltIn(arguments.from.clone());
    let name = format!("name={stem}");
    let scenario = AnyScenario::read(source, &[name]).map_err(Failure::input)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut files: Vec<(PathBuf, &str)> = Vec::new();
    for (_, series) in scenario.driven() {
        if let Some(file) = shipped_file(&series.file) {
            files.push((folder.join(&series.file), file.text));
        }
    }
    files.push((path.clone(), scenario.text()));
    if let Some((there, _)) = files.iter().find(|(path, _)| path.exists()) {
        return Err(Failure::Input(miette!(
            help = "choose another name, or move it away",
            "`{}` is there already",
            there.display()
        )));
    }
    for (path, text) in &files {
        create(path, text)?;
    }
    super::print(&format!(
        "{} is `{}` under a name of its own; `motes run {0}` runs it\n",
        path.display(),
        arguments.from
    ))
}

/// Writes a file that is not there yet.
fn create(path: &Path, text: &str) -> Result<(), Failure> {
    let file = std::fs::File::create_new(path);
    let written = file.and_then(|mut file| file.write_all(text.as_bytes()));
    match written {
        Err(error) if error.kind() == ErrorKind::NotFound => Err(Failure::Input(miette!(
            help = "make the folder first",
            "`{}` cannot be written: its folder is not there",
            path.display()
        ))),
        written => written
            .into_diagnostic()
            .wrap_err_with(|| format!("cannot write `{}`", path.display()))
            .map_err(Failure::Input),
    }
}
