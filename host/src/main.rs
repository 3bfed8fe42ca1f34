//! The `motes` program.
fn main() {}
