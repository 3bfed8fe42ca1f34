//! The scenarios that come with the program, as text: `motes show NAME` prints
//! one for people to copy and edit. Adding one is a file in `scenarios/` and
//! its row here.

/// A scenario that comes with the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BuiltIn {
    /// What it is called on the command line.
    pub name: &'static str,
    /// Its TOML text, comments included.
    pub text: &'static str,
}

/// All built-in scenarios, in the order they are listed.
pub const BUILT_IN: &[BuiltIn] = &[
    BuiltIn {
        name: "sod",
        text: include_str!("../../../scenarios/sod.toml"),
    },
    BuiltIn {
        name: "wind-tunnel",
        text: include_str!("../../../scenarios/wind-tunnel.toml"),
    },
];

/// The built-in scenario of this name, if there is one.
pub fn built_in(name: &str) -> Option<&'static BuiltIn> {
    BUILT_IN.iter().find(|scenario| scenario.name == name)
}
