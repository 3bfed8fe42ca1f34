//! The sections of a scenario that describes a linear system, beside the shared ones.

use super::{Key, ROOT, key};

/// The keys of a field of velocities.
const FIELD: &[Key] = &[
    key("kind", "kind = \"rotation\""),
    key("velocity", "velocity = [1.0]"),
    key("rate", "rate = 1.0"),
    key("center", "center = [0.0, 0.0]"),
    key("amplitude", "amplitude = 0.2"),
];

/// Every section with its keys.
pub(super) const SECTIONS: &[(&str, &[Key])] = &[
    (
        ROOT,
        &[
            key("name", "name = \"my-wave\""),
            key("description", "description = \"what this shows\""),
            key("dimension", "dimension = 1"),
            key("units", "[units]"),
            key("define", "[define]"),
            key("domain", "[domain]"),
            key("system", "[system]"),
            key("motion", "[motion]"),
            key("wall", "[[wall]]"),
            key("initial", "[initial]"),
            key("resolution", "[resolution]"),
            key("cut-off", "[cut-off]"),
            key("time", "[time]"),
            key("output", "[output]"),
            key("tolerance", "[tolerance.state]"),
        ],
    ),
    (
        "system",
        &[
            key("kind", "kind = \"acoustics\""),
            key("velocity", "velocity = { kind = \"rotation\", rate = 1.0 }"),
            key("decay", "decay = 0.5"),
            key("source", "source = [\"sin(x - t)\"]"),
            key("density", "density = 1.0"),
            key("sound-speed", "sound-speed = 1.0"),
            key("inductance", "inductance = 1.0"),
            key("capacitance", "capacitance = 1.0"),
            key("resistance", "resistance = 0.5"),
            key("conductance", "conductance = 0.5"),
            key("gravity", "gravity = 9.81"),
            key("depth", "depth = 1.0"),
            key("coriolis", "coriolis = 0.0"),
            key("permittivity", "permittivity = 1.0"),
            key("permeability", "permeability = 1.0"),
            key("lambda", "lambda = 1.0"),
            key("mu", "mu = 1.0"),
            key("pressure", "pressure = 1.0"),
            key("gamma", "gamma = 1.4"),
            key("components", "components = 2"),
            key("flux", "flux = [[[0.0, 1.0], [1.0, 0.0]]]"),
            key("names", "names = [\"u0\", \"u1\"]"),
            key("species", "species = [\"u\"]"),
            key("diffusivity", "diffusivity = 0.01"),
            key("form", "form = \"direct\""),
            key("mean", "mean = \"harmonic\""),
            key("profile", "profile = { kind = \"parabola\" }"),
            key("modulation", "modulation = { amplitude = 0.5, rate = 1.0 }"),
            key("tensor", "tensor = [[1.0, 0.3], [0.3, 0.5]]"),
            key(
                "reaction",
                "reaction = { kind = \"linear\", matrix = [[-1.0]] }",
            ),
        ],
    ),
    ("system.velocity", FIELD),
    (
        "system.profile",
        &[
            key("kind", "kind = \"layers\""),
            key("center", "center = 0.0"),
            key("radius", "radius = 1.0"),
            key("bounds", "bounds = [0.0]"),
            key("factors", "factors = [1.0, 10.0]"),
        ],
    ),
    (
        "system.modulation",
        &[
            key("amplitude", "amplitude = 0.5"),
            key("rate", "rate = 1.0"),
        ],
    ),
    (
        "system.reaction",
        &[
            key("kind", "kind = \"linear\""),
            key("matrix", "matrix = [[-1.0]]"),
            key("source", "source = [0.0]"),
            key("rate", "rate = 1.0"),
            key("capacity", "capacity = 1.0"),
            key("feed", "feed = 0.037"),
            key("kill", "kill = 0.06"),
            key("rates", "rates = [\"u*(1 - u) + sin(x)\"]"),
        ],
    ),
    (
        "wall",
        &[
            key("axis", "axis = \"x\""),
            key("end", "end = \"lower\""),
            key("species", "species = \"u\""),
            key("kind", "kind = \"value\""),
            key("value", "value = 1.0"),
            key("flux", "flux = 0.0"),
            key("rate", "rate = 0.05"),
            key("outside", "outside = 20.0"),
            key(
                "series",
                "series = { file = \"wall-day.csv\", column = \"temperature\" }",
            ),
        ],
    ),
    (
        "wall.series",
        &[
            key("file", "file = \"wall-day.csv\""),
            key("column", "column = \"temperature\""),
            key("beyond", "beyond = \"hold\""),
        ],
    ),
    ("motion", FIELD),
    (
        "initial",
        &[
            key("kind", "kind = \"gaussian\""),
            key("center", "center = [0.0]"),
            key("width", "width = 0.1"),
            key("amplitude", "amplitude = 1.0"),
            key("wave", "wave = [1]"),
            key("state", "state = [1.0, 0.0]"),
            key("length", "length = 0.5"),
            key("degree", "degree = 3"),
            key("background", "background = [1.0, 0.0]"),
            key("spot", "spot = [0.5, 0.25]"),
            key("centers", "centers = [[0.5, 0.5]]"),
        ],
    ),
    (
        "resolution",
        &[
            key("particles", "particles = 1000"),
            key("arrangement", "arrangement = \"lattice\""),
            key("amplitude", "amplitude = 0.05"),
            key("file", "file = \"cloud.csv\""),
        ],
    ),
    (
        "time",
        &[
            key("end", "end = 0.2"),
            key("method", "method = \"rk4\""),
            key("courant", "courant = 0.5"),
            key("step", "step = 0.001"),
            key("stages", "stages = 9"),
            key("growth-margin", "growth-margin = 0.1"),
        ],
    ),
    (
        "output",
        &[
            key("window", "window = { lower = [-0.5], upper = [0.5] }"),
            key("samples", "samples = 100"),
            key("exact-times", "exact-times = true"),
            key("exact", "exact = \"initial\""),
            key("snapshots", "snapshots = { every = 0.01 }"),
            key("probe", "probe = { points = [200] }"),
        ],
    ),
    (
        "output.probe",
        &[
            key("points", "points = [200]"),
            key("lower", "lower = [-0.5]"),
            key("upper", "upper = [0.5]"),
        ],
    ),
    (
        "tolerance",
        &[
            key("state", "[tolerance.state]"),
            key("reconstruction", "[tolerance.reconstruction]"),
        ],
    ),
];
