//! Checkpoints of a run, as often as they are asked for, and what a run goes on from.

use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::io::{
    Checkpoint, CheckpointError, Header, Input, Origin, RunFolder, WriteError, write_checkpoint,
};
use crate::run::{Logbook, Simulation, pass_run};
use crate::scenario::{AnyScenario, ScenarioError, Source};
use crate::snapshots::SnapshotWriter;

/// How often checkpoints are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Often {
    /// After so many steps.
    Steps(u64),
    /// After so many seconds, by the clock on the wall.
    Seconds(f64),
}

/// Not as often as that.
#[derive(Clone, Debug, thiserror::Error)]
#[error("`{0}` is neither a number of steps, such as 500, nor a time, such as 60s, 10m or 2h")]
pub struct UnknownOften(String);

impl std::str::FromStr for Often {
    type Err = UnknownOften;

    fn from_str(text: &str) -> Result<Self, UnknownOften> {
        let unknown = || UnknownOften(text.to_owned());
        let unit = match text.chars().last() {
            Some('s') => 1.0,
            Some('m') => 60.0,
            Some('h') => 3600.0,
            _ => {
                let steps = text.parse().ok().filter(|&steps: &u64| steps > 0);
                return steps.map(Self::Steps).ok_or_else(unknown);
            }
        };
        let number: Option<f64> = text[..text.len() - 1].parse().ok();
        let seconds = number.map(|number| number * unit);
        let seconds = seconds.filter(|seconds| *seconds > 0.0 && seconds.is_finite());
        seconds.map(Self::Seconds).ok_or_else(unknown)
    }
}

/// The folder of the checkpoints in that of the run.
pub const FOLDER: &str = "checkpoints";
/// How many are kept.
const KEPT: usize = 2;

/// Writes checkpoints of a run and keeps the last two.
pub struct CheckpointWriter {
    often: Option<Often>,
    last: Instant,
    header: Header,
}

impl CheckpointWriter {
    /// For a run that is described by that header; without `often` only where it is asked to.
    pub fn new(header: Header, often: Option<Often>) -> Self {
        Self {
            often,
            last: Instant::now(),
            header,
        }
    }

    /// Writes a checkpoint if one is due, or `asked` for; not at the end, from where nothing goes on. The
    /// file, relative to the folder of the run.
    ///
    /// # Errors
    /// A file that cannot be written. The checkpoints before are still there then.
    pub fn look(
        &mut self,
        (simulation, logbook): (&mut dyn Simulation, &mut Logbook),
        snapshots: &mut SnapshotWriter,
        folder: &mut RunFolder,
        asked: bool,
    ) -> Result<Option<String>, WriteError> {
        let step = simulation.steps();
        let due = match self.often {
            None => false,
            Some(Often::Steps(every)) => step.is_multiple_of(every),
            Some(Often::Seconds(every)) => self.last.elapsed().as_secs_f64() >= every,
        };
        if !(due || asked) || simulation.is_over() {
            return Ok(None);
        }
        let header = Header {
            particles: simulation.particles() as u64,
            step,
            time: simulation.time(),
            digest: simulation.digest().to_string(),
            ..self.header.clone()
        };
        let name = format!("{FOLDER}/step_{step:06}.motes");
        // A run that nobody wanted checkpoints of leaves the results of the one before it alone.
        let path = match self.often {
            Some(_) => folder.place(&name)?,
            None => folder.place_beside(&name)?,
        };
        write_checkpoint(&path, &header, |words| {
            snapshots.pass(words)?;
            pass_run(simulation, logbook, words)
        })?;
        let all = folder.path().join(FOLDER);
        let others = found(&all).into_iter().filter(|other| other.step != step);
        // What lies ahead is of a run that was given up.
        let (ahead, mut behind): (Vec<_>, Vec<_>) = others.partition(|other| other.step > step);
        behind.truncate(behind.len().saturating_sub(KEPT - 1));
        for other in ahead.into_iter().chain(behind) {
            folder.remove(&format!("{FOLDER}/{}", other.name));
        }
        self.last = Instant::now();
        Ok(Some(name))
    }
}

/// A checkpoint among others.
struct Found {
    step: u64,
    name: String,
}

/// The checkpoints in a folder, the oldest first.
fn found(folder: &Path) -> Vec<Found> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut all: Vec<Found> = entries
        .filter_map(|entry| {
            let name = entry.file_name().into_string().ok()?;
            let step = name.strip_prefix("step_")?.strip_suffix(".motes")?;
            let step = step.parse().ok()?;
            Some(Found { step, name })
        })
        .collect();
    all.sort_by_key(|found| found.step);
    all
}

/// Where a run is gone on with.
#[derive(Debug)]
pub struct Resumption {
    /// What from.
    pub checkpoint: Checkpoint,
    /// Its file.
    pub file: PathBuf,
    /// The folder of the run, where the file lies in one.
    pub folder: Option<PathBuf>,
    /// Why a later checkpoint is passed over.
    pub passed_over: Vec<CheckpointError>,
}

impl Resumption {
    /// The checkpoint of that file, or the last whole one of the folder of a run.
    ///
    /// # Errors
    /// [`CheckpointError`].
    pub fn find(path: &Path) -> Result<Self, CheckpointError> {
        if !path.is_dir() {
            let checkpoint = Checkpoint::read(path)?;
            let above = path.parent().filter(|folder| folder.ends_with(FOLDER));
            return Ok(Self {
                checkpoint,
                file: path.to_owned(),
                folder: above.and_then(Path::parent).map(Path::to_owned),
                passed_over: Vec::new(),
            });
        }
        let folder = match path.ends_with(FOLDER) {
            true => path.to_owned(),
            false => path.join(FOLDER),
        };
        let mut passed_over = Vec::new();
        for found in found(&folder).into_iter().rev() {
            let file = folder.join(found.name);
            match Checkpoint::read(&file) {
                Ok(checkpoint) => {
                    return Ok(Self {
                        checkpoint,
                        file,
                        folder: folder.parent().map(Path::to_owned),
                        passed_over,
                    });
                }
                Err(error) => passed_over.push(error),
            }
        }
        let none = CheckpointError::None {
            path: path.to_owned(),
        };
        Err(passed_over.into_iter().next().unwrap_or(none))
    }
}

/// Why a run that was kept cannot be gone on with.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum ResumeError {
    /// Its scenario cannot be read any more.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scenario(#[from] ScenarioError),
    /// A file that the scenario names is not what it was.
    #[error("`{file}` has changed since the run began, or is gone")]
    #[diagnostic(help("put the file back that the run began with, or begin the run anew"))]
    Changed {
        /// Which.
        file: String,
    },
}

/// The scenario of a checkpoint, as it was run.
///
/// # Errors
/// [`ResumeError`].
pub fn scenario(header: &Header) -> Result<AnyScenario, ResumeError> {
    let of = match &header.origin {
        Origin::BuiltIn(name) => Source::BuiltIn(name.clone()),
        Origin::File(path) => Source::File(path.clone()),
    };
    let source = Source::Kept {
        text: header.text.clone(),
        of: Box::new(of),
    };
    let scenario = AnyScenario::read(source, &[])?;
    let now = inputs(&scenario);
    let changed = header.inputs.iter().find(|input| !now.contains(input));
    match changed {
        None => Ok(scenario),
        Some(input) => Err(ResumeError::Changed {
            file: input.file.clone(),
        }),
    }
}

/// The files that a scenario names, as they are now; one that cannot be read is not among them.
pub fn inputs(scenario: &AnyScenario) -> Vec<Input> {
    let series = scenario.driven().into_iter();
    let mut inputs: Vec<Input> = series
        .map(|(_, series)| Input::new(&series.file, series.text.as_bytes()))
        .collect();
    let cloud = scenario.cloud_file();
    let cloud = cloud.and_then(|path| Some((path, std::fs::read(path).ok()?)));
    inputs.extend(cloud.map(|(path, bytes)| Input::new(path.display().to_string(), &bytes)));
    inputs
}

/// Where a scenario is from, for a checkpoint.
pub fn origin(argument: &str) -> Origin {
    match Source::from(argument) {
        Source::File(path) => Origin::File(std::path::absolute(&path).unwrap_or(path)),
        _ => Origin::BuiltIn(argument.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn how_often_is_a_number_of_steps_or_a_time() {
        let often = |text: &str| text.parse::<Often>().ok();
        assert_eq!(often("500"), Some(Often::Steps(500)));
        assert_eq!(often("60s"), Some(Often::Seconds(60.0)));
        assert_eq!(often("1.5m"), Some(Often::Seconds(90.0)));
        assert_eq!(often("2h"), Some(Often::Seconds(7200.0)));
        for wrong in [
            "", "0", "-1", "1.5", "s", "0s", "nans", "infh", "5 min", "1é",
        ] {
            let error = wrong.parse::<Often>().unwrap_err();
            assert!(error.to_string().contains("60s"), "{wrong}");
        }
    }
}
