//! The sections of a scenario that describes a gas, beside the shared ones.

use super::{Key, ROOT, key};

/// Every section with its keys.
pub(super) const SECTIONS: &[(&str, &[Key])] = &[
    (
        ROOT,
        &[
            key("name", "name = \"my-tube\""),
            key("description", "description = \"what this shows\""),
            key("dimension", "dimension = 1"),
            key("units", "[units]"),
            key("define", "[define]"),
            key("domain", "[domain]"),
            key("region", "[[region]]"),
            key("profile", "[profile]"),
            key("inflow", "[inflow]"),
            key("outflow", "[outflow]"),
            key("wall", "[[wall]]"),
            key("deposit", "[[deposit]]"),
            key("material", "[material]"),
            key("resolution", "[resolution]"),
            key("weights", "[weights]"),
            key("cut-off", "[cut-off]"),
            key("gradient", "[gradient]"),
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
        "outflow",
        &[
            key("pressure", "pressure = 1.0"),
            key("velocity", "velocity = [1.0]"),
        ],
    ),
    (
        "wall",
        &[
            key("axis", "axis = \"y\""),
            key("end", "end = \"upper\""),
            key("slip", "slip = \"none\""),
            key("velocity", "velocity = [1.0, 0.0]"),
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
            key("anchor", "anchor = \"corner\""),
            key("seed", "seed = 1"),
            key("jitter", "jitter = 0.1"),
            key("file", "file = \"cloud.csv\""),
        ],
    ),
    ("weights", &[key("rule", "rule = \"mass\"")]),
    ("gradient", &[key("kind", "kind = \"linear-exact\"")]),
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
            key("bulk-viscosity", "bulk-viscosity = 0.01"),
            key("heat", "heat = 0.01"),
        ],
    ),
    (
        "force",
        &[
            key("acceleration", "acceleration = [0.0, -9.81]"),
            key("background", "background = 1.0"),
        ],
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
            key("exact-times", "exact-times = true"),
            key("exact", "exact = \"riemann\""),
            key("ring", "ring = { inner = 0.05, outer = 0.35 }"),
            key("snapshots", "snapshots = { every = 0.01 }"),
        ],
    ),
    (
        "output.exact",
        &[
            key("density", "density = \"1 + 0.1*sin(x - t)\""),
            key("velocity", "velocity = [\"1\"]"),
            key("pressure", "pressure = \"1\""),
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
        "tolerance",
        &[
            key("density", "[tolerance.density]"),
            key("velocity", "[tolerance.velocity]"),
            key("pressure", "[tolerance.pressure]"),
            key("energy", "[tolerance.energy]"),
            key("momentum", "[tolerance.momentum]"),
            key("total_energy", "[tolerance.total_energy]"),
            key("velocity_radial", "[tolerance.velocity_radial]"),
            key("velocity_azimuthal", "[tolerance.velocity_azimuthal]"),
        ],
    ),
];
