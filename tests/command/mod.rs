//! The program called as a user or a script calls it.
#![allow(dead_code, reason = "every test uses its part of this module")]

use std::path::Path;
use std::process::{Command, Output};

/// What a call came to.
pub fn motes(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_motes"));
    command
        .current_dir(folder)
        .args(arguments)
        .output()
        .unwrap()
}

/// Standard output of a call that must succeed.
pub fn stdout(folder: &Path, arguments: &[&str]) -> String {
    let output = motes(folder, arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {errors}");
    String::from_utf8(output.stdout).unwrap()
}

/// Standard error of a call that must fail with that code. Nothing is left behind.
pub fn failure(folder: &Path, arguments: &[&str], code: i32) -> String {
    let output = motes(folder, arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {errors}");
    assert_eq!(output.stdout, b"", "{arguments:?}");
    assert!(!errors.contains("panicked"), "{errors}");
    errors
}
