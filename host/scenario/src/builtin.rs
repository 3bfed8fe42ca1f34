//! The scenarios that come with the program, as text: `motes show NAME` prints
//! one for people to copy and edit. Adding one is a file in `scenarios/` and
//! its row here.

/// A scenario that comes with the program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BuiltIn {
    /// What it is called on the command line.
    pub name: &'static str,
    /// Its TOML text, comments included.
    pub text: &'static str,
    /// Seconds that a run in f64 takes on two cores of a server, to one digit.
    pub seconds: f64,
}

macro_rules! built_in {
    ($($name:literal $seconds:literal)*) => {
        /// All built-in scenarios, in the order they are listed.
        pub const BUILT_IN: &[BuiltIn] = &[$(BuiltIn {
            name: $name,
            text: include_str!(concat!("../../../scenarios/", $name, ".toml")),
            seconds: $seconds,
        },)*];
    };
}
built_in! {
    "sod" 0.1
    "toro2" 0.1
    "toro3" 1.0
    "toro4" 1.0
    "toro5" 3.0
    "noh1d" 0.1
    "woodward-colella" 5.0
    "shu-osher" 8.0
    "kidder" 0.4
    "sound-wave" 0.1
    "two-gas-sod" 0.1
    "water-air" 0.6
    "sod2d" 1.0
    "noh2d" 40.0
    "sedov2d" 10.0
    "yee-vortex" 3.0
    "gresho" 40.0
    "kelvin-helmholtz" 20.0
    "riemann2d" 2.0
    "taylor-green" 20.0
    "square" 0.5
    "couette" 1.0
    "poiseuille" 1.0
    "cavity" 30.0
    "shock-bubble" 10.0
    "wind-tunnel" 0.5
    "sod3d" 90.0
    "noh3d" 20.0
    "sedov3d" 100.0
    "acoustics1d" 0.3
    "acoustics2d" 2.0
    "acoustics3d" 1.0
    "telegraph" 0.2
    "transport-rotation" 3.0
    "transport-shear" 0.5
    "transport-compression" 0.5
    "transport-mesh" 6.0
    "manufactured" 1.0
    "acoustics-medium" 0.1
    "sloping-bed" 0.5
    "shallow-water" 1.0
    "maxwell-te" 1.0
    "elastic-waves" 2.0
    "linearised-gas" 1.0
    "heat1d" 0.1
    "heat2d" 0.7
    "unsteady-diffusion" 1.0
    "heat3d" 30.0
    "rotating-gaussian" 1.0
    "shear-gaussian" 0.7
    "variable-diffusivity" 0.1
    "layered-wall" 0.7
    "robin-wall" 0.3
    "decay-chain" 0.1
    "advection-dominated" 0.1
    "gray-scott" 60.0
    "wall-day" 0.2
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
