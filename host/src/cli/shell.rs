//! `motes completions` and `motes man`: what a shell and a manual know of the command line.

use clap::CommandFactory;
use clap_complete::Shell;
use miette::{IntoDiagnostic, miette};

use super::Failure;
use super::arguments::Arguments;
use crate::scenario::shortened;

/// Prints the completions of a shell.
pub(super) fn completions(shell: Shell) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "motes", &mut text);
    super::print(&String::from_utf8_lossy(&text))
}

/// Prints the manual page of the program, or of one of its commands, in roff.
pub(super) fn man(command: Option<&str>) -> Result<(), Failure> {
    let mut program = Arguments::command();
    // Commands have their whole names from then on.
    program.build();
    let described = match command {
        None => program,
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| {
            Failure::Input(miette!(
                help = "`motes --help` lists the commands",
                "`{}` is no command of motes",
                shortened(name)
            ))
        })?,
    };
    let mut text = Vec::new();
    let page = clap_mangen::Man::new(described);
    let rendered = page.render(&mut text).into_diagnostic();
    rendered.map_err(Failure::Run)?;
    super::print(&String::from_utf8_lossy(&text))
}
