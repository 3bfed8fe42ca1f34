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

const SECTIONS: &[(&str, &[Key])] = &[
    (
        ROOT,
        &[
            key("name", "name = \"my-tube\""),
            key("description", "description = \"what this shows\""),
            key("dimension", "dimension = 1"),
            key("units", "[units]"),
            key("domain", "[domain]"),
            key("region", "[[region]]"),
            key("material", "[material]"),
            key("resolution", "[resolution]"),
            key("cut-off", "[cut-off]"),
            key("viscosity", "[viscosity]"),
            key("time", "[time]"),
            key("output", "[output]"),
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
            key("density", "density = 1.0"),
            key("velocity", "velocity = [0.0]"),
            key("pressure", "pressure = 1.0"),
        ],
    ),
    (
        "material",
        &[
            key("equation-of-state", "equation-of-state = \"ideal-gas\""),
            key("gamma", "gamma = 1.4"),
        ],
    ),
    (
        "resolution",
        &[
            key("particles", "particles = 900"),
            key("arrangement", "arrangement = \"equal-mass\""),
        ],
    ),
    (
        "cut-off",
        &[
            key("name", "name = \"cubic-spline\""),
            key("eta", "eta = 1.2"),
            key("epsilon", "epsilon = 0.01"),
        ],
    ),
    (
        "viscosity",
        &[
            key("kind", "kind = \"pairwise\""),
            key("alpha", "alpha = 1.0"),
            key("beta", "beta = 2.0"),
        ],
    ),
    (
        "time",
        &[key("end", "end = 0.2"), key("courant", "courant = 0.3")],
    ),
    (
        "output",
        &[
            key("window", "window = { lower = [-0.5], upper = [0.5] }"),
            key("samples", "samples = 100"),
            key("exact", "exact = \"riemann\""),
        ],
    ),
    (
        "output.window",
        &[
            key("lower", "lower = [-0.5]"),
            key("upper", "upper = [0.5]"),
        ],
    ),
];

/// The keys of a section (`""` for those above all sections; `region.3` is a
/// `region`); none if there is no such section.
pub(super) fn keys_of(section: &str) -> &'static [Key] {
    let kind = match section.split_once('.') {
        Some(("region", index)) if index.bytes().all(|b| b.is_ascii_digit()) => "region",
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
