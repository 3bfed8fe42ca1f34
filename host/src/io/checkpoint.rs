//! Checkpoints: a run in a file, to go on from.
//!
//! | bytes | what |
//! |---|---|
//! | 8 | `89 6d 6f 74 65 73 0d 0a`: what is copied as text is not this any more |
//! | 4 | the layout, 1 |
//! | 8, 8 | the length of the header and its XXH64 |
//! | | the header, JSON: [`Header`] |
//! | | the words of the run, see [`Words`] |
//! | 8, 8 | their length and their XXH64 |
//! | 8 | the XXH64 of all before |
//!
//! Numbers are little-endian on every machine.

use std::io::Write;
use std::path::{Path, PathBuf};

use motes_core::cloud::{Remaining, Save, Words};
use motes_core::error::Error;
use serde::{Deserialize, Serialize};
use xxhash_rust::xxh64::{Xxh64, xxh64};

use super::table::{WriteError, whole};

const MAGIC: &[u8; 8] = b"\x89motes\r\n";
const LAYOUT: u32 = 1;
/// Bytes before the header.
const BEFORE: usize = 28;
/// Bytes after the words.
const AFTER: usize = 24;

/// What a checkpoint is of. Enough to go on, but for the state itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// The version of motes that wrote it.
    pub motes: String,
    /// The name of the scenario.
    pub scenario: String,
    /// Where the scenario is from.
    pub origin: Origin,
    /// The scenario as it is run, with all that was set.
    pub text: String,
    /// Files that the scenario names.
    pub inputs: Vec<Input>,
    /// The scalar.
    pub scalar: String,
    /// Whether overflow is looked for.
    pub check_overflow: bool,
    /// Whether what cannot be proven to stay in range is computed all the same.
    pub allow_unproven: bool,
    /// Particles to see.
    pub particles: u64,
    /// Steps made.
    pub step: u64,
    /// Time reached, in the scenario's unit.
    pub time: f64,
    /// Time of the end.
    pub end: f64,
    /// Digest of the state.
    pub digest: String,
}

/// Where a scenario is from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Origin {
    /// It comes with the program.
    BuiltIn(String),
    /// A file, from the root of the file system.
    File(PathBuf),
}

/// A file that a scenario names.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Input {
    /// Its name.
    pub file: String,
    /// The XXH64 of its bytes.
    pub xxh64: String,
}

impl Input {
    /// That of a file with those bytes.
    pub fn new(file: impl Into<String>, bytes: &[u8]) -> Self {
        Self {
            file: file.into(),
            xxh64: format!("{:016x}", xxh64(bytes, 0)),
        }
    }
}

/// Why a file is no checkpoint to go on from.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum CheckpointError {
    /// It cannot be read.
    #[error("cannot read `{}`", path.display())]
    #[diagnostic(help("`motes run --checkpoint-every` writes checkpoints, and so does Ctrl-C"))]
    Unreadable {
        /// Which.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// It is something else.
    #[error("`{}` is no checkpoint of motes", path.display())]
    #[diagnostic(help("give a file out/NAME/checkpoints/step_*.motes, or the folder out/NAME"))]
    Foreign {
        /// Which.
        path: PathBuf,
    },
    /// It is of a layout that this version does not know, or of another version.
    #[error("`{}` was written by {by}, and this is motes {}", path.display(), env!("CARGO_PKG_VERSION"))]
    #[diagnostic(help("go on with that version: another may compute other bits"))]
    Version {
        /// Which.
        path: PathBuf,
        /// By what.
        by: String,
    },
    /// It is not as it was written.
    #[error("`{}` is damaged: {what}", path.display())]
    #[diagnostic(help("two are kept: give the other one, or begin the run anew"))]
    Damaged {
        /// Which.
        path: PathBuf,
        /// What is not as it was.
        what: &'static str,
    },
    /// There is none.
    #[error("`{}` holds no checkpoints", path.display())]
    #[diagnostic(help("`motes run --checkpoint-every` writes them, and so does Ctrl-C"))]
    None {
        /// The folder.
        path: PathBuf,
    },
}

/// A checkpoint in memory, whole and checked.
#[derive(Clone, Debug)]
pub struct Checkpoint {
    /// What it is of.
    pub header: Header,
    bytes: Vec<u8>,
    words: std::ops::Range<usize>,
}

impl Checkpoint {
    /// Reads one.
    ///
    /// # Errors
    /// [`CheckpointError`]: any file that is not, to the bit, what [`write_checkpoint`] of this version wrote.
    pub fn read(path: &Path) -> Result<Self, CheckpointError> {
        let bytes = std::fs::read(path).map_err(|source| CheckpointError::Unreadable {
            path: path.to_owned(),
            source,
        })?;
        Self::parse(path, bytes)
    }

    fn parse(path: &Path, bytes: Vec<u8>) -> Result<Self, CheckpointError> {
        let path = || path.to_owned();
        let damaged = |what| CheckpointError::Damaged { path: path(), what };
        if !bytes.starts_with(MAGIC) {
            return Err(CheckpointError::Foreign { path: path() });
        }
        let number = |at: usize| {
            let word = bytes.get(at..at + 8).and_then(|word| word.try_into().ok());
            word.map(u64::from_le_bytes)
        };
        let layout = bytes.get(8..12).and_then(|word| word.try_into().ok());
        match layout.map(u32::from_le_bytes) {
            Some(LAYOUT) => {}
            None => return Err(damaged("it ends too soon")),
            Some(layout) => {
                let by = format!("a version with layout {layout}");
                return Err(CheckpointError::Version { path: path(), by });
            }
        }
        let end = bytes.len().checked_sub(AFTER).filter(|&end| end >= BEFORE);
        let end = end.ok_or_else(|| damaged("it ends too soon"))?;
        if number(end + 16) != Some(xxh64(&bytes[..end + 16], 0)) {
            return Err(damaged("its XXH64 is another"));
        }
        let length = number(12).and_then(|length| usize::try_from(length).ok());
        let start = length.and_then(|length| BEFORE.checked_add(length));
        let start = start.filter(|&start| start <= end);
        let start = start.ok_or_else(|| damaged("its header is longer than the file"))?;
        let (header, words) = (&bytes[BEFORE..start], &bytes[start..end]);
        if number(20) != Some(xxh64(header, 0)) {
            return Err(damaged("the XXH64 of its header is another"));
        }
        if number(end) != Some(words.len() as u64) || number(end + 8) != Some(xxh64(words, 0)) {
            return Err(damaged("the XXH64 of its state is another"));
        }
        let header: serde_json::Result<Header> = serde_json::from_slice(header);
        let header = header.map_err(|_| damaged("its header cannot be read"))?;
        if header.motes != env!("CARGO_PKG_VERSION") {
            let by = format!("motes {}", header.motes);
            return Err(CheckpointError::Version { path: path(), by });
        }
        Ok(Self {
            header,
            words: start..end,
            bytes,
        })
    }

    /// The state, to be read from its start.
    pub fn words(&self) -> Remaining<'_> {
        Remaining(&self.bytes[self.words.clone()])
    }

    /// Bytes of the whole file.
    pub fn size(&self) -> usize {
        self.bytes.len()
    }
}

/// Writes a checkpoint, whole or not at all; `pass` passes the words of the run.
///
/// # Errors
/// A file that cannot be written, and what `pass` says.
pub fn write_checkpoint(
    path: &Path,
    header: &Header,
    pass: impl FnOnce(&mut dyn Words) -> Result<(), Error>,
) -> Result<(), WriteError> {
    let json = serde_json::to_vec(header).map_err(|error| WriteError::new(path, error))?;
    whole(path, |file| {
        let mut out = Out {
            file,
            all: Xxh64::new(0),
        };
        out.put(MAGIC)?;
        out.put(&LAYOUT.to_le_bytes())?;
        out.number(json.len() as u64)?;
        out.number(xxh64(&json, 0))?;
        out.put(&json)?;
        let (mut hash, mut length, mut failed) = (Xxh64::new(0), 0, None);
        let mut full: Vec<u8> = Vec::with_capacity(2 * CHUNK);
        let mut empty = |full: &mut Vec<u8>| {
            hash.update(full);
            length += full.len() as u64;
            let put = out.put(full);
            full.clear();
            put.map_err(|error| {
                failed = Some(error);
                Error::Truncated
            })
        };
        let mut words = Save(|bytes: &[u8]| {
            full.extend_from_slice(bytes);
            match full.len() < CHUNK {
                true => Ok(()),
                false => empty(&mut full),
            }
        });
        let passed = pass(&mut words).and_then(|()| empty(&mut full));
        if let Some(error) = failed {
            return Err(error);
        }
        passed.map_err(std::io::Error::other)?;
        out.number(length)?;
        out.number(hash.digest())?;
        let all = out.all.digest();
        out.number(all)
    })
}

/// Bytes that are written at once.
const CHUNK: usize = 1 << 16;

/// A file and the hash of what has been written to it.
struct Out<W> {
    file: W,
    all: Xxh64,
}

impl<W: Write> Out<W> {
    fn put(&mut self, bytes: &[u8]) -> std::io::Result<()> {
        self.all.update(bytes);
        self.file.write_all(bytes)
    }
    fn number(&mut self, number: u64) -> std::io::Result<()> {
        self.put(&number.to_le_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header() -> Header {
        Header {
            motes: env!("CARGO_PKG_VERSION").to_owned(),
            scenario: "sod".to_owned(),
            origin: Origin::File("/somewhere/mine.toml".into()),
            text: "name = \"sod\"\n".to_owned(),
            inputs: vec![Input::new("cloud.csv", b"x\n1\n")],
            scalar: "f64".to_owned(),
            check_overflow: false,
            allow_unproven: true,
            particles: 3,
            step: 7,
            time: 0.1,
            end: 0.2,
            digest: "0123456789abcdef".to_owned(),
        }
    }

    fn written(header: &Header, numbers: &[f64]) -> (tempfile::TempDir, PathBuf, Vec<u8>) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("step_000007.motes");
        let mut numbers = numbers.to_vec();
        write_checkpoint(&path, header, |words| words.scalars(&mut numbers)).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        (folder, path, bytes)
    }

    #[test]
    fn what_is_written_is_read_to_the_bit() {
        let numbers: Vec<f64> = (0..20_000).map(|k| 1.0 / f64::from(k)).collect();
        let (_folder, path, bytes) = written(&header(), &numbers);
        let checkpoint = Checkpoint::read(&path).unwrap();
        assert_eq!(checkpoint.header, header());
        assert_eq!(checkpoint.size(), bytes.len());
        let mut words = checkpoint.words();
        let words: &mut dyn Words = &mut words;
        let mut read = vec![0.0; numbers.len()];
        words.scalars(&mut read).unwrap();
        let bits = |numbers: &[f64]| -> Vec<u64> { numbers.iter().map(|x| x.to_bits()).collect() };
        assert_eq!(bits(&read), bits(&numbers));
        assert_eq!(words.count(&mut 0), Err(Error::Truncated));
    }

    #[test]
    fn a_flipped_bit_or_a_missing_byte_anywhere_is_seen() {
        let (_folder, path, bytes) = written(&header(), &[1.5, -0.0, 3.0]);
        for bit in 0..8 * bytes.len() {
            let mut flipped = bytes.clone();
            flipped[bit / 8] ^= 1 << (bit % 8);
            assert!(Checkpoint::parse(&path, flipped).is_err(), "{bit}");
        }
        for length in 0..bytes.len() {
            let short = bytes[..length].to_vec();
            assert!(Checkpoint::parse(&path, short).is_err(), "{length}");
        }
        let mut longer = bytes;
        longer.push(0);
        assert!(Checkpoint::parse(&path, longer).is_err());
    }

    #[test]
    fn another_version_is_refused_by_name() {
        let older = Header {
            motes: "0.0.9".to_owned(),
            ..header()
        };
        let (_folder, path, bytes) = written(&older, &[1.0]);
        let error = Checkpoint::parse(&path, bytes.clone()).unwrap_err();
        assert!(error.to_string().contains("motes 0.0.9"), "{error}");
        let mut other = bytes;
        other[8] = 9;
        let error = Checkpoint::parse(&path, other).unwrap_err();
        assert!(error.to_string().contains("layout 9"), "{error}");
        let error = Checkpoint::parse(&path, b"x,y\n1,2\n".to_vec()).unwrap_err();
        assert!(error.to_string().contains("no checkpoint"), "{error}");
    }

    #[test]
    fn a_state_that_cannot_be_passed_leaves_the_file_as_it_was() {
        let (_folder, path, bytes) = written(&header(), &[1.0]);
        let result = write_checkpoint(&path, &header(), |_| Err(Error::Lengths));
        assert!(result.is_err());
        assert_eq!(std::fs::read(&path).unwrap(), bytes);
        assert_eq!(path.parent().unwrap().read_dir().unwrap().count(), 1);
    }
}
