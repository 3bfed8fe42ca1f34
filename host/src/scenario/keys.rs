//! Which keys a scenario may have: the one list that reading, `--set` and the
//! error texts share.

/// A key that a section may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Key {
    /// Its name in the file.
    pub name: &'static str,
    /// A line that could stand in a file.
    pub example: &'static str,
}

const fn key(name: &'static str, example: &'static str) -> Key {
    Key { name, example }
}

/// The section of the keys above all sections.
pub(super) const ROOT: &str = "";

/// The sections of which a file may have several, numbered from 0.
pub(super) const LISTS: [&str; 3] = ["region", "material", "deposit"];

/// Every section with its keys.
pub(super) const SECTIONS: &[(&str, &[Key])] = &[
    (
        ROOT,
        &[
            key("name", "name = \"my-tube\""),
            key("description", "description = \"what this shows\""),
            key("dimension", "dimension = 1"),
            key("units", "[units]"),
            key("domain", "[domain]"),
            key("region", "[[region]]"),
            key("profile", "[profile]"),
            key("inflow", "[inflow]"),
            key("deposit", "[[deposit]]"),
            key("material", "[material]"),
            key("resolution", "[resolution]"),
            key("weights", "[weights]"),
            key("cut-off", "[cut-off]"),
            key("viscosity", "[viscosity]"),
            key("conduction", "[conduction]"),
            key("diffusion", "[diffusion]"),
            key("force", "[force]"),
            key("time", "[time]"),
            key("output", "[output]"),
            key("tolerance", "[tolerance.density]"),
        ],
    ),
    (
        "units",
        &[
            key("length", "length = \"m\""),
            key("mass", "mass = \"kg\""),
            key("time", "time = \"s\""),
        ],
    ),
    (
        "domain",
        &[
            key("lower", "lower = [-1.0]"),
            key("upper", "upper = [1.0]"),
            key("sides", "sides = [\"mirror\"]"),
        ],
    ),
    (
        "region",
        &[
            key("lower", "lower = [-1.0]"),
            key("upper", "upper = [0.0]"),
            key("center", "center = [0.0]"),
            key("radius", "radius = 0.1"),
            key("material", "material = \"water\""),
            key("density", "density = 1.0"),
            key("velocity", "velocity = [0.0]"),
            key("pressure", "pressure = 1.0"),
        ],
    ),
    (
        "profile",
        &[
            key("kind", "kind = \"sound-wave\""),
            key("density", "density = 1.0"),
            key("pressure", "pressure = 1.0"),
            key("speed", "speed = 1.0"),
            key("amplitude", "amplitude = 1e-3"),
            key("strength", "strength = 5.0"),
            key("velocity", "velocity = [1.0, 0.0]"),
            key("mach", "mach = 0.1"),
        ],
    ),
    (
        "inflow",
        &[
            key("material", "material = \"water\""),
            key("density", "density = 1.0"),
            key("velocity", "velocity = [1.0]"),
            key("pressure", "pressure = 1.0"),
        ],
    ),
    (
        "deposit",
        &[
            key("center", "center = [0.0]"),
            key("radius", "radius = 0.1"),
            key("energy", "energy = 1.0"),
        ],
    ),
    (
        "material",
        &[
            key("equation-of-state", "equation-of-state = \"ideal-gas\""),
            key("gamma", "gamma = 1.4"),
            key("pressure-at-infinity", "pressure-at-infinity = 3e8"),
            key("sound-speed", "sound-speed = 1.0"),
            key("density", "density = 1000.0"),
            key("exponent", "exponent = 7"),
            key("name", "name = \"water\""),
        ],
    ),
    (
        "resolution",
        &[
            key("particles", "particles = 900"),
            key("arrangement", "arrangement = \"equal-mass\""),
            key("share", "share = \"volume\""),
            key("rotation", "rotation = [1, 2]"),
            key("seed", "seed = 1"),
            key("jitter", "jitter = 0.1"),
            key("file", "file = \"cloud.csv\""),
        ],
    ),
    ("weights", &[key("rule", "rule = \"mass\"")]),
    (
        "cut-off",
        &[
            key("name", "name = \"cubic-spline\""),
            key("eta", "eta = 1.2"),
            key("theta", "theta = 0.75"),
            key("epsilon", "epsilon = 0.01"),
        ],
    ),
    (
        "viscosity",
        &[
            key("kind", "kind = \"pairwise\""),
            key("alpha", "alpha = 1.0"),
            key("beta", "beta = 2.0"),
            key("switch", "switch = { minimum = 0.1, decay = 0.1 }"),
            key("balsara", "balsara = true"),
        ],
    ),
    (
        "viscosity.switch",
        &[key("minimum", "minimum = 0.1"), key("decay", "decay = 0.1")],
    ),
    ("conduction", &[key("alpha", "alpha = 1.0")]),
    (
        "diffusion",
        &[
            key("viscosity", "viscosity = 0.01"),
            key("heat", "heat = 0.01"),
        ],
    ),
    (
        "force",
        &[key("acceleration", "acceleration = [0.0, -9.81]")],
    ),
    (
        "time",
        &[
            key("end", "end = 0.2"),
            key("courant", "courant = 0.3"),
            key("energy", "energy = \"exact\""),
        ],
    ),
    (
        "output",
        &[
            key("window", "window = { lower = [-0.5], upper = [0.5] }"),
            key("samples", "samples = 100"),
            key("exact", "exact = \"riemann\""),
            key("ring", "ring = { inner = 0.05, outer = 0.35 }"),
            key("snapshots", "snapshots = { every = 0.01 }"),
        ],
    ),
    (
        "output.window",
        &[
            key("lower", "lower = [-0.5]"),
            key("upper", "upper = [0.5]"),
        ],
    ),
    (
        "output.ring",
        &[
            key("center", "center = [0.0]"),
            key("inner", "inner = 0.05"),
            key("outer", "outer = 0.35"),
        ],
    ),
    (
        "output.snapshots",
        &[
            key("every", "every = 0.01"),
            key("steps", "steps = 10"),
            key("format", "format = \"vtu\""),
        ],
    ),
    (
        "tolerance",
        &[
            key("density", "[tolerance.density]"),
            key("velocity", "[tolerance.velocity]"),
            key("pressure", "[tolerance.pressure]"),
            key("energy", "[tolerance.energy]"),
        ],
    ),
    (
        "tolerance.FIELD",
        &[
            key("l1", "l1 = 0.0035"),
            key("l2", "l2 = 0.01"),
            key("linf", "linf = 0.1"),
            key("mean", "mean = 0.0035"),
            key("rms", "rms = 0.01"),
            key("reason", "reason = \"1.05 of what 900 particles give\""),
        ],
    ),
];

/// The keys of a section (`""` for those above all sections; `region.3` is a
/// `region`, `tolerance.density` a `tolerance.FIELD`); none if there is no such section.
pub(super) fn keys_of(section: &str) -> &'static [Key] {
    let kind = match section.split_once('.') {
        Some((list, index))
            if LISTS.contains(&list) && index.bytes().all(|b| b.is_ascii_digit()) =>
        {
            list
        }
        Some(("tolerance", field)) if !field.contains('.') => "tolerance.FIELD",
        _ => section,
    };
    SECTIONS
        .iter()
        .find(|(name, _)| *name == kind)
        .map_or(&[], |(_, keys)| keys)
}

/// The line to write for a key given by its section and name.
pub(super) fn example(section: &str, name: &str) -> &'static str {
    keys_of(section)
        .iter()
        .find(|key| key.name == name)
        .map_or("", |key| key.example)
}

/// The path of a key: `section.key`, or `key` above all sections.
pub(super) fn path(section: &str, key: &str) -> String {
    if section.is_empty() {
        key.to_owned()
    } else {
        format!("{section}.{key}")
    }
}
