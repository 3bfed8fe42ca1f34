//! Bytes of a file, as many as are bounded: regular files only, so that nothing is waited for.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// The longest scenario, in bytes.
pub(super) const MOST_OF_SCENARIO: u64 = 1 << 24;

/// The longest table, in bytes.
pub(super) const MOST_OF_TABLE: u64 = 1 << 34;

/// Why a file is not read.
#[derive(Debug)]
pub(super) enum Unread {
    /// There is none.
    Missing,
    /// A directory.
    Directory,
    /// A pipe, a device, a socket: it may have no end, or never begin.
    NotRegular,
    /// More bytes than that.
    TooLong(u64),
    /// The operating system refuses.
    Refused(io::Error),
}

/// All bytes of a regular file.
///
/// # Errors
/// What [`Unread`] lists.
pub(super) fn bytes(path: &Path, most: u64) -> Result<Vec<u8>, Unread> {
    let refused = |error: io::Error| match error.kind() {
        ErrorKind::NotFound => Unread::Missing,
        _ => Unread::Refused(error),
    };
    // Before it is opened: opening a pipe waits for who writes into it.
    let found = std::fs::metadata(path).map_err(refused)?;
    match found.file_type() {
        kind if kind.is_dir() => return Err(Unread::Directory),
        kind if !kind.is_file() => return Err(Unread::NotRegular),
        _ if found.len() > most => return Err(Unread::TooLong(most)),
        _ => {}
    }
    let file = File::open(path).map_err(refused)?;
    let mut bytes = Vec::new();
    // What a system makes as it is read has length 0 and may have no end.
    let read = file.take(most + 1).read_to_end(&mut bytes);
    read.map_err(refused)?;
    match bytes.len() as u64 > most {
        true => Err(Unread::TooLong(most)),
        false => Ok(bytes),
    }
}

impl Unread {
    /// What it says of a file of that name.
    pub fn message(&self, name: &str) -> String {
        match self {
            Self::Missing => format!("there is no file `{name}`"),
            Self::Directory => format!("`{name}` is a directory, need a file"),
            Self::NotRegular => format!("`{name}` is a pipe or a device, need a file"),
            Self::TooLong(most) => format!("`{name}` has more than {most} bytes"),
            Self::Refused(error) => format!("`{name}` cannot be read: {error}"),
        }
    }

    /// The cure where the operating system is not at fault.
    pub fn cure(&self) -> Option<&'static str> {
        match self {
            Self::NotRegular => Some("write what comes out of it into a file, and give that"),
            Self::TooLong(_) => Some("check that it is the file that you mean"),
            _ => None,
        }
    }
}
