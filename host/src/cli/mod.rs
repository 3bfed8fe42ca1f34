//! The command line. Others script against it: add, do not change.

mod arguments;
mod bench;
mod compare;
mod converge;
mod export;
mod inspect;
mod list;
mod new;
mod progress;
mod run;
mod shell;
mod suite;
mod watch;

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;
use miette::{IntoDiagnostic, WrapErr};

use crate::scenario::{Source, shortened_sentence};
use arguments::{Arguments, Command};

/// What the program ends with.
enum Failure {
    /// Input that cannot be used: exit code 2.
    Input(miette::Report),
    /// A run that failed: exit code 1.
    Run(miette::Report),
    /// Ctrl-C: exit code 130, as a shell expects of a program that stopped at an interrupt.
    Interrupted(miette::Report),
}

impl Failure {
    /// Input that cannot be used.
    fn input(error: impl Into<miette::Report>) -> Self {
        Self::Input(error.into())
    }
}

/// Runs the program with the arguments of the process.
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return refused(&error),
    };
    let result = match arguments.command {
        Command::Run(arguments) => run::run(&arguments),
        Command::Resume(arguments) => run::resume(&arguments),
        Command::Inspect(arguments) => inspect::inspect(&arguments),
        Command::List => list::list(),
        Command::Show { name } => show(&name),
        Command::New(arguments) => new::new(&arguments),
        Command::Export(arguments) => export::export(&arguments),
        Command::Suite(arguments) => suite::suite(&arguments),
        Command::Converge(arguments) => converge::converge(&arguments),
        Command::Compare(arguments) => compare::compare(&arguments),
        Command::Bench(arguments) => bench::bench(&arguments),
        Command::Completions { shell } => shell::completions(shell),
        Command::Man { command } => shell::man(command.as_deref()),
    };
    let (report, code) = match result {
        Ok(()) => return ExitCode::SUCCESS,
        Err(Failure::Input(report)) => (report, 2),
        Err(Failure::Run(report)) => (report, 1),
        Err(Failure::Interrupted(report)) => (report, 130),
    };
    // Where nobody reads it the exit code still says it.
    let _ = writeln!(std::io::stderr(), "{report:?}");
    ExitCode::from(code)
}

/// Prints help, the version, or what is wrong with the arguments, of which long ones are cut.
fn refused(error: &clap::Error) -> ExitCode {
    let text = error.render().to_string();
    if text.lines().all(|line| line.len() < 1000) {
        error.exit();
    }
    let lines: Vec<String> = text.lines().map(shortened_sentence).collect();
    let _ = writeln!(std::io::stderr(), "{}", lines.join("\n"));
    ExitCode::from(2)
}

/// Prints to standard output. A reader that has gone away is no failure.
fn print(text: &str) -> Result<(), Failure> {
    let mut output = std::io::stdout();
    match output
        .write_all(text.as_bytes())
        .and_then(|()| output.flush())
    {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            let report = Err::<(), _>(error).into_diagnostic();
            report
                .wrap_err("cannot write to standard output")
                .map_err(Failure::Run)
        }
        _ => Ok(()),
    }
}

/// `motes show NAME`.
fn show(name: &str) -> Result<(), Failure> {
    if let Some(file) = crate::scenario::shipped_file(name) {
        return print(file.text);
    }
    let source = Source::from(name);
    let text = source
        .text()
        .map_err(|error| Failure::Input(error.into()))?;
    print(&text)
}
