//! The `motes` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    motes::cli::main()
}
