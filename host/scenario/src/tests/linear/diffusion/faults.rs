//! Every fault of convection-diffusion names the value, shows the line and tells the cure.

use super::*;

const D: &str = "diffusivity = 0.5";
const START: &str = "kind = \"uniform\"\nstate = [1.0]";
const END: &str = "end = 0.5";

/// Replacement in [`SLAB`]; the line it is reported on; the value, and the cure.
#[rustfmt::skip]
const SLAB_FAULTS: &[Case] = &[
    // Species and their diffusivities.
    (D, "", "[system]", "`diffusivity` is missing in [system]", "`diffusivity = 0.01`"),
    (D, "diffusivity = -0.5", "diffusivity", "system.diffusivity = -0.5", "0 or a positive"),
    (D, "diffusivity = \"low\"", "diffusivity", "system.diffusivity = \"low\": there is no `low` here", "did you mean `log`?"),
    (D, "diffusivity = [0.5, 0.5]", "diffusivity", "its length is 2, species = 1", "one number a species, or one for all"),
    (D, "diffusivity = [-0.5]", "diffusivity", "system.diffusivity.0 = -0.5", "0 or a positive"),
    (D, "diffusivity = 0.5\nspecies = []", "species", "the number of species is 0, need 1 to 4", "[\"u\", \"v\"]"),
    (D, "diffusivity = 0.5\nspecies = [\"a\", \"b\", \"c\", \"d\", \"e\"]", "species", "the number of species is 5", "one name a species"),
    (D, "diffusivity = 0.5\nspecies = [\"a\", \"a\"]", "species", "system.species.1 = \"a\" does not fit: another one has the same name", "a name of its own"),
    (D, "diffusivity = 0.5\nspecies = [\"state\"]", "species", "system.species.0 = \"state\"", "not a column of the results"),
    (D, "diffusivity = 0.5\nspecies = \"u\"", "species", "system.species = \"u\" is text, need a list of names", "species = [\"u\"]"),
    (D, "diffusivity = 0.5\ndecay = 1.0", "decay", "convection-diffusion has no decay", "takes species, diffusivity, form"),
    // Forms.
    (D, "diffusivity = 0.5\nform = \"mixd\"", "form", "system.form = \"mixd\" is unknown", "did you mean `mixed`? known: direct, mixed"),
    (D, "diffusivity = 0.5\nmean = \"geometric\"", "mean", "system.mean = \"geometric\"", "known: arithmetic, harmonic"),
    (D, "diffusivity = 0.5\nform = \"mixed\"\nmean = \"harmonic\"", "mean", "the mixed form takes b at a particle", "set form = \"direct\""),
    // What b depends on.
    (D, "diffusivity = 0.5\nprofile = { kind = \"cubic\" }", "profile", "system.profile.kind = \"cubic\"", "known: uniform, parabola, layers"),
    (D, "diffusivity = 0.5\nprofile = { kind = \"parabola\", radius = 0 }", "profile", "system.profile.radius = 0 ", "larger than 0"),
    (D, "diffusivity = 0.5\nprofile = { kind = \"parabola\", bounds = [0.0] }", "profile", "parabola has no bounds", "parabola takes center, radius"),
    (D, "diffusivity = 0.5\nprofile = { kind = \"parabola\", center = [0.0] }", "profile", "system.profile.center = [0.0] is a list", "`center = 0.0`"),
    (D, "diffusivity = 0.5\nprofile = { kind = \"layers\", factors = [1.0] }", "profile", "`bounds` is missing in [system.profile]", "`bounds = [0.0]`"),
    (D, "diffusivity = 0.5\nprofile = { kind = \"layers\", bounds = [], factors = [1.0] }", "profile", "layers without a bound", "kind = \"uniform\""),
    (D, "diffusivity = 0.5\nprofile = { kind = \"layers\", bounds = [1.0, 1.0], factors = [1.0, 1.0, 1.0] }", "profile", "system.profile.bounds.1 = 1.0 does not fit: it is not above the bound before it, 1", "ascending"),
    (D, "diffusivity = 0.5\nprofile = { kind = \"layers\", bounds = [0.0], factors = [1.0] }", "profile", "its length is 1, the bounds make 2 layers", "one more than bounds"),
    (D, "diffusivity = 0.5\nprofile = { kind = \"layers\", bounds = [0.0], factors = [1.0, 0.0] }", "profile", "system.profile.factors.1 = 0.0", "larger than 0"),
    (D, "diffusivity = 0.5\nmodulation = { amplitude = 1.1, rate = 1.0 }", "modulation", "system.modulation.amplitude = 1.1", "below 0"),
    (D, "diffusivity = 0.5\nmodulation = { amplitude = 0.5 }", "modulation", "`rate` is missing in [system.modulation]", "`rate = 1.0`"),
    (D, "diffusivity = 0.5\ntensor = [[1.0]]", "tensor", "dimension = 1: there is one direction", "take `tensor` out"),
    // Reactions.
    (D, "diffusivity = 0.5\nreaction = { kind = \"cubic\" }", "reaction", "system.reaction.kind = \"cubic\"", "known: none, linear, logistic, gray-scott"),
    (D, "diffusivity = 0.5\nreaction = { kind = \"linear\" }", "reaction", "`matrix` is missing in [system.reaction]", "`matrix = [[-1.0]]`"),
    (D, "diffusivity = 0.5\nreaction = { kind = \"linear\", matrix = [[1.0], [1.0]] }", "reaction", "the number of its rows is 2, species = 1", "another number of species"),
    (D, "diffusivity = 0.5\nreaction = { kind = \"linear\", matrix = [[1.0]], source = [1.0, 2.0] }", "reaction", "its length is 2, species = 1", "one number a species"),
    (D, "diffusivity = 0.5\nreaction = { kind = \"linear\", matrix = [[1.0]], rate = 1.0 }", "reaction", "linear has no rate", "linear takes matrix, source"),
    (D, "diffusivity = 0.5\nreaction = { kind = \"logistic\", rate = -1, capacity = 1 }", "reaction", "system.reaction.rate = -1", "0 or a positive"),
    (D, "diffusivity = 0.5\nreaction = { kind = \"logistic\", rate = 1, capacity = 0 }", "reaction", "system.reaction.capacity = 0", "larger than 0"),
    (D, "diffusivity = 0.5\nreaction = { kind = \"gray-scott\", feed = 0.037, kill = 0.06 }", "reaction", "gray-scott is of two species, there are 1", "species = [\"u\", \"v\"]"),
    // Motion.
    (D, "diffusivity = 0.5\n[motion]\nkind = \"still\"", "kind = \"still\"", "diffusion runs on particles that follow the velocity", "take [motion] out"),
    (D, "diffusivity = 0.5\nvelocity = { kind = \"uniform\", velocity = [1.0] }", "velocity", "it crosses the lower wall along x", "\"free\""),
    // The initial state.
    (START, "kind = \"plane-wave\"\nwave = [1]", "kind", "convection-diffusion has no such state in dimension = 1", "has here: gaussian, modes, uniform, band, legendre, spots"),
    (START, "kind = \"uniform\"", "[initial]", "`state` is missing", "`state = [1.0, 0.0]`"),
    (START, "kind = \"uniform\"\nstate = [1.0, 2.0]", "state", "its length is 2, components = 1", "one number a component"),
    (START, "kind = \"band\"\nlength = 0.5\nwidth = 0.0", "width", "initial.width = 0.0", "larger than 0"),
    (START, "kind = \"band\"\nlength = 0.5\nwidth = 0.1\ncenter = [0.0]", "center", "initial.center = [0.0] is a list, need a number", "`center = 0.0`"),
    (START, "kind = \"band\"\nwidth = 0.1", "[initial]", "`length` is missing in [initial]", "`length = 0.5`"),
    (START, "kind = \"legendre\"\ndegree = 3", "kind", "it goes with a parabola, the profile is uniform", "profile = { kind = \"parabola\" }"),
    (START, "kind = \"spots\"\nbackground = [0.0]\nspot = [1.0]\ncenters = []\nwidth = 0.1", "centers", "spots without a centre", "one point at least"),
    (START, "kind = \"spots\"\nbackground = [0.0]\nspot = [1.0]\ncenters = [[7.0]]\nwidth = 0.1", "centers", "initial.centers.0 = 7 lies outside the domain", "move it inside"),
    (START, "kind = \"spots\"\nbackground = [0.0]\nspot = [1.0]\ncenters = [0.0]\nwidth = 0.1", "centers", "initial.centers.0 = 0.0", "need a list"),
    ("sides = [\"mirror\"]", "sides = [\"inflow\"]", "sides", "gas can come in at one side only", "outflow"),
    // Time.
    (END, "end = 0.5\nstages = 4", "stages", "time.stages = 4 does not fit: it is even", "an odd number"),
    (END, "end = 0.5\nstages = 1", "stages", "time.stages = 1 is out of range: need 3 to 255, odd", "an odd number"),
    (END, "end = 0.5\nstages = 257", "stages", "time.stages = 257", "an odd number"),
    (END, "end = 0.5\nstages = 9\nstep = 0.1", "stages", "from which the number of stages follows", "keep one: step (a time) or stages"),
    (END, "end = 0.5\nmethod = \"rk4\"\nstages = 9", "stages", "the number of stages of rk4 is its own", "method = \"rkl2\""),
];

/// The same in [`SHEET`].
#[rustfmt::skip]
const SHEET_FAULTS: &[Case] = &[
    ("[0.0, 0.5]]", "[0.2, 0.5]]", "tensor", "row 1 has 0.2 in column 0, row 0 has 0 in column 1", "make it symmetric"),
    ("tensor = [[1.0, 0.0], [0.0, 0.5]]", "tensor = [[1.0, 0.3], [0.3, 0.5]]", "tensor", "row 1 has off-diagonals, and there is a wall across y", "\"periodic\" or \"free\""),
    ("tensor = [[1.0, 0.0], [0.0, 0.5]]", "tensor = [[1.0, 0.8], [0.8, 0.5]]", "tensor", "a negative eigenvalue", "smaller"),
    ("tensor = [[1.0, 0.0], [0.0, 0.5]]", "tensor = [[1.0, 0.0], [0.0, -0.5]]", "tensor", "a negative eigenvalue", "smaller"),
    ("tensor = [[1.0, 0.0], [0.0, 0.5]]", "tensor = [[1.0, 0.3]]", "tensor", "the number of its rows is 1, dimension = 2", "2 rows of 2 numbers, or another dimension"),
    ("background = [1.0, 0.0]", "background = [1.0]", "background", "initial.background = [1.0]", "one number a component"),
    ("kill = 0.06", "kill = -0.06", "reaction", "system.reaction.kill = -0.06", "0 or a positive"),
    // Walls.
    ("axis = \"y\"\nend = \"lower\"", "axis = \"x\"\nend = \"lower\"", "end = \"lower\"", "wall.0.end = \"lower\" does not fit: there is no wall at the lower side along x", "domain.sides to \"mirror\""),
    ("axis = \"y\"", "axis = \"z\"", "axis", "wall.0.axis = \"z\" does not fit: dimension = 2", "the directions are: x, y"),
    ("axis = \"y\"", "axis = 1", "axis", "wall.0.axis = 1 is a whole number, need text", "`axis = \"x\"`"),
    ("axis = \"y\"\nend = \"lower\"\n", "axis = \"y\"\n", "[[wall]]", "`end` is missing in [[wall]] 0 (numbered from 0)", "`end = \"lower\"`"),
    ("end = \"lower\"", "end = \"left\"", "end = \"left\"", "wall.0.end = \"left\" is unknown", "known: lower, upper"),
    ("end = \"upper\"", "end = \"lower\"", "end = \"lower\"", "wall.1.end = \"lower\" does not fit: wall 0 says already what v meets there", "keep one of the two"),
    ("species = \"v\"", "species = \"w\"", "species", "wall.1.species = \"w\" is unknown", "known: u, v"),
    ("kind = \"value\"", "kind = \"dirichlet\"", "kind", "wall.0.kind = \"dirichlet\"", "known: no-flux, value, flux, exchange"),
    ("value = 2.0\n", "", "[[wall]]", "`value` is missing in [[wall]] 0", "`value = 1.0`"),
    ("value = 2.0", "flux = 2.0", "flux", "value has no flux", "value takes value, series"),
    ("kind = \"value\"\n", "kind = \"no-flux\"\n", "value = 2.0", "no-flux has no value", "takes nothing"),
    ("value = 2.0", "value = 2.0\nseries = { file = \"a.csv\", column = \"t\" }", "series", "`value` is there too", "keep one: `value`, a number, or `series`"),
    ("value = 2.0", "series = { file = \"a.csv\" }", "series", "`column` is missing in [[wall]] 0.series", "`column = \"temperature\"`"),
    ("value = 2.0", "series = { colum = \"t\" }", "series", "unknown key `colum`", "did you mean `column`?"),
    ("value = 2.0", "value = nan", "value", "wall.0.value = nan is not a finite number", "an ordinary number"),
    ("rate = 0.1", "rate = -0.1", "rate", "wall.1.rate = -0.1", "0 or a positive"),
    ("outside = -1.0", "", "[[wall]]", "`outside` is missing in [[wall]] 1", "`outside = 20.0`"),
    ("kind = \"value\"", "heat = 1\nkind = \"value\"", "heat", "unknown key `heat` in [[wall]] 0", "axis, end, species, kind"),
];

#[test]
fn every_fault_names_the_value_the_line_and_the_cure() {
    for (text, faults) in [(SLAB, SLAB_FAULTS), (SHEET, SHEET_FAULTS)] {
        for (from, to, line, value, cure) in faults {
            let changed = changed(text, &[(from, to)]);
            let error = linear(&changed, &[]).expect_err(to);
            assert_report_holds(&error, &[value, cure, "mine.toml:"]);
            let (number, _) = error.line_and_column().unwrap();
            let shown = changed.lines().nth(number - 1).unwrap();
            assert!(shown.contains(line), "{to:?} was reported on {shown:?}");
        }
    }
}

/// Modes have no slope at a wall, and so no wall that lets something through.
#[test]
fn modes_need_periodic_sides_or_closed_walls() {
    let modes = "kind = \"modes\"\nwave = [1]\nstate = [1.0]";
    let text = changed(SLAB, &[(START, modes)]);
    read(&text);
    let free = linear(&text, &["domain.sides=[\"free\"]"]).unwrap_err();
    let parts = [
        "initial.kind = \"modes\"",
        "no slope at a wall",
        "\"periodic\" or \"mirror\"",
    ];
    assert_report_holds(&free, &parts);
    let wall = "[[wall]]\naxis = \"x\"\nend = \"lower\"\nkind = \"flux\"\nflux = 1.0\n[initial]";
    let open = changed(&text, &[("[initial]", wall)]);
    assert_report_holds(&linear(&open, &[]).unwrap_err(), &parts);
}

#[test]
fn what_is_of_convection_diffusion_is_refused_elsewhere() {
    let wall = format!("{LINE}[[wall]]\naxis = \"x\"\nend = \"lower\"\nkind = \"no-flux\"\n");
    let error = linear(&wall, &[]).unwrap_err();
    let parts = ["the walls of acoustics are mirrors", "take [[wall]] out"];
    assert_report_holds(&error, &parts);
    let error = linear(LINE, &["time.method=rkl2"]).unwrap_err();
    let parts = [
        "time.method = \"rkl2\"",
        "imaginary one, where waves are",
        "choose rk4 or ssp-rk3",
    ];
    assert_report_holds(&error, &parts);
    let error = linear(LINE, &["time.stages=9"]).unwrap_err();
    assert_report_holds(&error, &["time.stages = 9", "of rk4 is its own"]);
    let error = linear(LINE, &["system.diffusivity=1"]).unwrap_err();
    assert_report_holds(&error, &["acoustics has no diffusivity"]);
    let uniform = LINE.replace("\"exp-sine\"", "\"uniform\"\nstate = [1.0, 0.0]");
    let error = linear(&uniform, &[]).unwrap_err();
    assert_report_holds(&error, &["acoustics has no such state"]);
    let gas = File::new(format!("{SOD}[[wall]]\naxis = \"x\"\nkind = \"value\"\n"));
    let error = gas.read(&[]).unwrap_err();
    assert_report_holds(&error, &["`kind` in [[wall]]", "goes with a linear system"]);
}

/// A tensor of rank one is on the edge of what is allowed, whatever rounding makes of it.
#[test]
fn a_tensor_may_have_eigenvalues_of_0() {
    let cube = changed(
        SLAB,
        &[
            ("dimension = 1", "dimension = 3"),
            ("lower = [-1.0]", "lower = [0.0, 0.0, 0.0]"),
            ("upper = [3.0]", "upper = [1.0, 1.0, 1.0]"),
            ("[\"mirror\"]", "[\"periodic\", \"free\", \"free\"]"),
        ],
    );
    let with = |rows: [[f64; 3]; 3]| {
        let tensor = format!("{D}\ntensor = {rows:?}");
        linear(&changed(&cube, &[(D, &tensor)]), &[])
    };
    let all = [
        [0.6, 0.8, 0.0],
        [0.1, 0.3, 0.0],
        [1e-5, 0.0, 7.0],
        [0.0, 1.0, 0.0],
        [0.1, 0.7, -0.3],
    ];
    for v in all {
        with(v.map(|x| v.map(|y| x * y))).unwrap();
    }
    // Every pair is fine, all three together are not: eigenvalues 1.6, 1.6, -0.2.
    let error = with([[1.0, -0.6, -0.6], [-0.6, 1.0, -0.6], [-0.6, -0.6, 1.0]]).unwrap_err();
    assert_report_holds(&error, &["a negative eigenvalue"]);
}
