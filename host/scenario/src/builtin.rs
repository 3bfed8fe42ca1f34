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

macro_rules! built_in {
    ($($name:literal)*) => {
        /// All built-in scenarios, in the order they are listed.
        pub const BUILT_IN: &[BuiltIn] = &[$(BuiltIn {
            name: $name,
            text: include_str!(concat!("../../../scenarios/", $name, ".toml")),
        },)*];
    };
}
built_in! {
    "sod"
    "toro2"
    "toro3"
    "toro4"
    "toro5"
    "noh1d"
    "woodward-colella"
    "sound-wave"
    "two-gas-sod"
    "water-air"
    "sod2d"
    "noh2d"
    "sedov2d"
    "yee-vortex"
    "gresho"
    "kelvin-helmholtz"
    "square"
    "shock-bubble"
    "wind-tunnel"
    "sod3d"
    "noh3d"
    "sedov3d"
    "acoustics1d"
    "acoustics2d"
    "acoustics3d"
    "telegraph"
    "transport-rotation"
    "transport-shear"
    "transport-compression"
    "transport-mesh"
    "shallow-water"
    "maxwell-te"
    "elastic-waves"
    "linearised-gas"
    "heat1d"
    "heat2d"
    "heat3d"
    "rotating-gaussian"
    "shear-gaussian"
    "variable-diffusivity"
    "layered-wall"
    "robin-wall"
    "decay-chain"
    "advection-dominated"
    "gray-scott"
    "wall-day"
}

/// A file that a built-in scenario names: `motes show NAME` prints it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShippedFile {
    /// What scenarios call it.
    pub name: &'static str,
    /// All of it.
    pub text: &'static str,
}

/// All of them.
pub const SHIPPED_FILES: &[ShippedFile] = &[ShippedFile {
    name: "wall-day.csv",
    text: include_str!("../../../scenarios/wall-day.csv"),
}];

/// The file of this name that comes with the program, if there is one.
pub fn shipped_file(name: &str) -> Option<&'static ShippedFile> {
    SHIPPED_FILES.iter().find(|file| file.name == name)
}

/// The built-in scenario of this name, if there is one.
pub fn built_in(name: &str) -> Option<&'static BuiltIn> {
    BUILT_IN.iter().find(|scenario| scenario.name == name)
}
