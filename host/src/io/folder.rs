//! The folder of a run: its own while it runs, and of its files alone afterwards.
//!
//! A hidden file, [`RECORD`], is locked by the run that owns the folder and lists what it wrote, each
//! name before the file is made, so that the next run knows what it may remove. The system lifts the
//! lock of a run that has ended, however it ended.

use std::collections::BTreeSet;
use std::fs::{File, TryLockError};
use std::io::{ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::table::{PREFIX, WriteError, writable, write_text};

/// The file that is locked and lists the others.
const RECORD: &str = ".motes";

/// A folder that one run owns.
///
/// Dropped before anything was written, it leaves nothing: not even the folder, where it was made for
/// the run.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    record: File,
    /// What earlier runs left, until it is removed.
    old: BTreeSet<String>,
    /// Whether it has been.
    is_cleared: bool,
    /// What this run has written.
    own: BTreeSet<String>,
    /// Names that stay, whoever wrote them: this run reads them.
    kept: BTreeSet<String>,
    /// Folders that were made for it, the outermost first.
    made: Vec<PathBuf>,
    /// Whether the record was here before.
    is_known: bool,
    removed: usize,
}

/// Why a folder cannot be had.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum FolderError {
    /// Another run has it.
    #[error("another run of motes writes into `{}`", path.display())]
    #[diagnostic(help("wait until it has ended, or choose another folder with --out"))]
    Owned {
        /// The folder.
        path: PathBuf,
    },
    /// It cannot be written to.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Write(#[from] WriteError),
}

impl RunFolder {
    /// Makes the folder where there is none, and owns it.
    ///
    /// # Errors
    /// [`FolderError`].
    pub fn claim(path: &Path) -> Result<Self, FolderError> {
        let made = missing(path);
        if let Err(error) = writable(path) {
            remove_empty(&made);
            return Err(error.into());
        }
        let name = path.join(RECORD);
        let is_known = name.exists();
        let at = |source| WriteError::new(&name, source);
        let mut record = loop {
            let mut options = File::options();
            let open = options.read(true).write(true).create(true).truncate(false);
            let record = open.open(&name).map_err(at)?;
            match record.try_lock() {
                Err(TryLockError::WouldBlock) => {
                    let path = path.to_owned();
                    return Err(FolderError::Owned { path });
                }
                // A file system without locks: as if the run were alone.
                Err(TryLockError::Error(error)) if error.kind() != ErrorKind::Unsupported => {
                    return Err(at(error).into());
                }
                _ => {}
            }
            // A run that left nothing took its record with it between the two lines above.
            if name.exists() {
                break record;
            }
        };
        let mut text = String::new();
        record.read_to_string(&mut text).map_err(at)?;
        let mut old: BTreeSet<String> = text.lines().map(str::to_owned).collect();
        if !is_known {
            old.extend(unrecorded(path));
        }
        old.retain(|name| is_name(name));
        Ok(Self {
            old,
            is_cleared: false,
            own: BTreeSet::new(),
            kept: BTreeSet::new(),
            path: path.to_owned(),
            record,
            made,
            is_known,
            removed: 0,
        })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Leaves a file where it is until this run writes one in its place; does nothing for a file
    /// elsewhere.
    pub fn keep(&mut self, file: &Path) {
        let name = self.old.iter().find(|name| self.has(name, file));
        self.kept.extend(name.cloned());
    }

    /// Whether a name in this folder is that file.
    pub fn has(&self, name: &str, file: &Path) -> bool {
        let [there, here] = [&self.path.join(name), file].map(std::fs::canonicalize);
        matches!((there, here), (Ok(there), Ok(here)) if there == here)
    }

    /// Takes over what the run that is gone on with has written below a folder in this one.
    pub fn adopt(&mut self, below: &str) {
        let is_below = |name: &String| Path::new(name).starts_with(below);
        let adopted = self.old.iter().filter(|name| is_below(name)).cloned();
        let adopted: BTreeSet<String> = adopted.collect();
        self.old.retain(|name| !is_below(name));
        self.sweep(&adopted);
        self.own.extend(adopted);
    }

    /// Removes a file that a run of motes wrote; one that is gone already is no error.
    pub fn remove(&mut self, name: &str) {
        if self.own.contains(name) || self.old.contains(name) {
            let _ = std::fs::remove_file(self.path.join(name));
        }
    }

    /// How many files of earlier runs were removed.
    pub fn removed(&self) -> usize {
        self.removed
    }

    /// The place of a file that is about to be written, `/` between folders. The first removes what
    /// earlier runs left.
    ///
    /// # Errors
    /// A file that cannot be removed, or a name that cannot be noted.
    pub fn place(&mut self, name: &str) -> Result<PathBuf, WriteError> {
        if !self.is_cleared {
            self.clear()?;
            let at = |source| WriteError::new(&self.path.join(RECORD), source);
            self.record.set_len(0).map_err(at)?;
            self.record.seek(SeekFrom::Start(0)).map_err(at)?;
            for name in self.kept.union(&self.own) {
                writeln!(self.record, "{name}").map_err(at)?;
            }
            self.is_cleared = true;
        }
        self.place_beside(name)
    }

    /// The place of a file that is about to be written beside what earlier runs left.
    ///
    /// # Errors
    /// A name that cannot be noted.
    pub fn place_beside(&mut self, name: &str) -> Result<PathBuf, WriteError> {
        let path = self.path.join(name);
        if !self.own.contains(name) {
            let noted = writeln!(self.record, "{name}");
            noted.map_err(|source| WriteError::new(&self.path.join(RECORD), source))?;
            self.own.insert(name.to_owned());
            if let Some(folder) = path.parent().filter(|folder| *folder != self.path) {
                std::fs::create_dir_all(folder)
                    .map_err(|source| WriteError::new(folder, source))?;
            }
        }
        Ok(path)
    }

    /// Writes a file whole or not at all.
    ///
    /// # Errors
    /// Those of [`Self::place`] and [`write_text`].
    pub fn write(&mut self, name: &str, text: &str) -> Result<(), WriteError> {
        write_text(&self.place(name)?, text)
    }

    /// Removes what this run wrote, as if it had not been.
    pub fn discard(mut self) {
        if self.own.is_empty() {
            return;
        }
        let own = std::mem::take(&mut self.own);
        for name in &own {
            let _ = std::fs::remove_file(self.path.join(name));
        }
        remove_folders(&self.path, &own);
        let _ = self.record.set_len(0);
        self.is_known = false;
    }

    /// Removes what earlier runs left: what is listed, and what was being written when one was cut
    /// off.
    fn clear(&mut self) -> Result<(), WriteError> {
        for name in self.old.difference(&self.kept) {
            let path = self.path.join(name);
            match std::fs::remove_file(&path) {
                Ok(()) => self.removed += 1,
                Err(error) if error.kind() == ErrorKind::NotFound => {}
                Err(error) => return Err(WriteError::new(&path, error)),
            }
        }
        self.sweep(&self.old);
        remove_folders(&self.path, &self.old);
        self.old.clear();
        Ok(())
    }

    /// Removes what was being written, beside files of those names, when a run was cut off.
    fn sweep(&self, names: &BTreeSet<String>) {
        let folders = names.iter().filter_map(|name| Path::new(name).parent());
        let folders: BTreeSet<PathBuf> = folders.map(|folder| self.path.join(folder)).collect();
        for folder in folders.iter().chain([&self.path]) {
            let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
            for entry in entries {
                if entry.file_name().to_string_lossy().starts_with(PREFIX) {
                    let _ = std::fs::remove_file(entry.path());
                }
            }
        }
    }
}

impl Drop for RunFolder {
    fn drop(&mut self) {
        if self.own.is_empty() && !self.is_known {
            let _ = std::fs::remove_file(self.path.join(RECORD));
            remove_empty(&self.made);
        }
    }
}

/// A name as a record has it: of a file in the folder or below it, never above.
fn is_name(line: &str) -> bool {
    let parts = || Path::new(line).components();
    let normal = |part| matches!(part, std::path::Component::Normal(_));
    parts().next().is_some() && parts().all(normal)
}

/// Snapshots and their lists, of runs that kept no record: what the lists name.
fn unrecorded(path: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(path).into_iter().flatten().flatten() {
        let list = entry.file_name().to_string_lossy().into_owned();
        let text = || std::fs::read_to_string(entry.path()).unwrap_or_default();
        let files: Vec<String> = match list.strip_suffix(".pvd") {
            Some(name) => {
                let text = text();
                let files = text
                    .split(" file=\"")
                    .skip(1)
                    .filter_map(|rest| rest.split('"').next());
                let own = format!("snapshots/{name}_");
                files
                    .filter(|file| file.starts_with(&own))
                    .map(str::to_owned)
                    .collect()
            }
            None if list == "snapshots.csv" => {
                let text = text();
                let rows = text
                    .strip_prefix("file,time,step\n")
                    .unwrap_or_default()
                    .lines();
                let files = rows.filter_map(|row| row.split(',').next());
                files
                    .filter(|file| file.starts_with("snapshots/"))
                    .map(str::to_owned)
                    .collect()
            }
            None => Vec::new(),
        };
        if !files.is_empty() {
            names.extend(files);
            names.push(list);
        }
    }
    names
}

/// The folders on the way to a path that are not there yet, the outermost first.
fn missing(path: &Path) -> Vec<PathBuf> {
    let ancestors = path
        .ancestors()
        .filter(|folder| !folder.as_os_str().is_empty());
    let mut missing: Vec<PathBuf> = ancestors
        .take_while(|folder| !folder.exists())
        .map(Path::to_owned)
        .collect();
    missing.reverse();
    missing
}

/// Removes the folders of some files where nothing else is in them.
fn remove_folders(path: &Path, names: &BTreeSet<String>) {
    let below = names.iter().filter_map(|name| Path::new(name).parent());
    let below: BTreeSet<&Path> = below
        .filter(|folder| !folder.as_os_str().is_empty())
        .collect();
    for folder in below {
        // What is not empty stays.
        let _ = std::fs::remove_dir(path.join(folder));
    }
}

fn remove_empty(folders: &[PathBuf]) {
    for folder in folders.iter().rev() {
        let _ = std::fs::remove_dir(folder);
    }
}
