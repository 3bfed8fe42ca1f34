//! Every fault of a linear system names the value, shows the line and tells the cure.

use super::*;

#[test]
fn a_family_is_not_taken_for_the_other() {
    let acoustics = Scenario::read(Source::from("acoustics1d"), &[]).unwrap_err();
    let parts = ["this scenario describes a linear system", "[system]"];
    assert_report_holds(&acoustics, &parts);
    let text = built_in("acoustics1d").unwrap().text;
    let (line, _) = acoustics.line_and_column().unwrap();
    assert_eq!(text.lines().nth(line - 1).unwrap(), "[system]");
    let sod = LinearScenario::read(Source::from("sod"), &[]).unwrap_err();
    assert_report_holds(&sod, &["this scenario describes a gas", "[system]"]);
    for (name, family) in [("sod", Family::Gas), ("telegraph", Family::Linear)] {
        let scenario = AnyScenario::read(Source::from(name), &[]).unwrap();
        assert_eq!((scenario.name(), scenario.family()), (name, family));
        assert_eq!(scenario.text(), built_in(name).unwrap().text);
    }
}

#[test]
fn a_key_of_the_other_family_is_named() {
    for (lines, key, cure) in [
        ("[[region]]\n", "`region` at the top", "[initial] says"),
        (
            "[profile]\n",
            "`profile` at the top",
            "take `profile` out: [initial]",
        ),
        (
            "[material]\n",
            "`material` at the top",
            "[system] holds the constants",
        ),
        ("[viscosity]\n", "`viscosity` at the top", "no shocks"),
        ("[weights]\n", "`weights` at the top", "carries its weight"),
        (
            "[force]\n",
            "`force` at the top",
            "makes this scenario a linear system",
        ),
    ] {
        let error = linear(&format!("{LINE}{lines}"), &[]).unwrap_err();
        assert_report_holds(&error, &[key, "goes with a gas", cure]);
    }
    let share = LINE.replace("particles = 100", "particles = 100\nshare = \"mass\"");
    let error = linear(&share, &[]).unwrap_err();
    assert_report_holds(&error, &["`share` in [resolution] goes with a gas"]);

    for (from, to, key) in [
        ("[material]", "[motion]\n[material]", "`motion` at the top"),
        ("end = 0.2", "end = 0.2\nstep = 0.1", "`step` in [time]"),
    ] {
        let error = File::new(SOD.replace(from, to)).read(&[]).unwrap_err();
        assert_report_holds(&error, &[key, "goes with a linear system", "add [system]"]);
    }
    let error = built_in_linear("telegraph", &["viscosity.alpha=1"]).unwrap_err();
    assert_report_holds(&error, &["unknown key `viscosity`", "system, motion"]);
}

/// Replacement in [`LINE`]; the line it is reported on; the value, and the cure.
#[rustfmt::skip]
const LINE_FAULTS: &[Case] = &[
    ("sides = [\"periodic\"]", "sides = [[\"inflow\", \"outflow\"]]", "sides", "domain.sides.0 = [\"inflow\", \"outflow\"] does not fit: inflow and outflow are of a gas", "\"periodic\", \"mirror\" or \"free\""),
    ("[initial]\nkind = \"exp-sine\"\n", "", "end", "`initial` is missing", "`[initial]`"),
    // The system.
    ("\"acoustics\"", "\"acustics\"", "kind", "system.kind = \"acustics\" is unknown", "did you mean `acoustics`? known: transport, acoustics, telegraph"),
    ("\"acoustics\"", "\"acoustics\"\ndensity = 0.0", "density", "system.density = 0.0", "larger than 0"),
    ("\"acoustics\"", "\"acoustics\"\nspeed = 1.0", "speed", "unknown key `speed` in [system]", "the keys in [system] are"),
    ("\"acoustics\"", "\"acoustics\"\nmu = 1.0", "mu", "acoustics has no mu", "acoustics takes density, sound-speed"),
    ("\"acoustics\"", "\"maxwell-te\"", "kind", "maxwell-te has dimension 2 only, dimension = 1", "set dimension = 2"),
    ("\"acoustics\"", "\"telegraph\"\ncapacitance = 1.0", "[system]", "`inductance` is missing in [system]", "`inductance = 1.0`"),
    ("\"acoustics\"", "\"telegraph\"\ninductance = 1.0\ncapacitance = 1.0\nresistance = -1.0", "resistance", "system.resistance = -1.0", "0 or a positive"),
    ("\"acoustics\"", "\"linearised-gas\"\ndensity = 1.0\npressure = 1.0\ngamma = 1.0", "gamma", "system.gamma = 1.0", "need > 1"),
    ("\"acoustics\"", "\"transport\"\ndecay = 1.0", "[system]", "`velocity` is missing in [system]", "kind = \"rotation\""),
    ("\"acoustics\"", "\"transport\"\nvelocity = 1.0", "velocity", "system.velocity = 1.0 is a number with a fraction, need a section", "kind = \"rotation\""),
    // The motion.
    ("[system]", "[motion]\nkind = \"swirl\"\n[system]", "kind", "motion.kind = \"swirl\" is unknown", "known: still, uniform, rotation"),
    ("[system]", "[motion]\nkind = \"flow\"\n[system]", "kind", "acoustics has no velocity that could be followed", "\"still\""),
    ("[system]", "[motion]\nkind = \"wave\"\nrate = 1.0\n[system]", "rate", "wave has no rate", "wave takes amplitude"),
    ("[system]", "[motion]\nkind = \"shear\"\nrate = 1.0\n[system]", "kind", "two directions at least", "another dimension"),
    ("[system]", "[motion]\nkind = \"compression\"\nrate = 1.0\n[system]", "kind", "it differs at the two periodic sides along x", "\"free\""),
    // The initial state.
    ("\"exp-sine\"", "\"exp-sin\"", "kind", "initial.kind = \"exp-sin\" is unknown", "did you mean `exp-sine`?"),
    ("\"exp-sine\"", "\"modes\"", "kind", "acoustics has no such state in dimension = 1", "acoustics has here: gaussian, exp-sine, plane-wave"),
    ("\"exp-sine\"", "\"gaussian\"", "[initial]", "`width` is missing in [initial]", "`width = 0.1`"),
    ("\"exp-sine\"", "\"gaussian\"\nwidth = -1.0", "width", "initial.width = -1.0", "larger than 0"),
    ("\"exp-sine\"", "\"exp-sine\"\nwidth = 1.0", "width", "exp-sine has no width", "exp-sine takes nothing"),
    ("\"exp-sine\"", "\"plane-wave\"\nwave = [0]", "wave", "initial.wave = [0] does not fit: a wave without wavelengths", "not 0"),
    ("\"exp-sine\"", "\"plane-wave\"\nwave = [1.5]", "wave", "initial.wave.0 = 1.5", "need a whole number"),
    ("\"exp-sine\"", "\"plane-wave\"\nwave = [1, 1]", "wave", "initial.wave has length 2, need 1", "dimension = 1"),
    ("\"exp-sine\"", "\"plane-wave\"\nwave = [9999999]", "wave", "initial.wave.0 = 9999999 is out of range", "number of wavelengths"),
    ("sides = [\"periodic\"]", "sides = [\"free\"]", "kind = \"exp-sine\"", "it has whole wavelengths", "set all of domain.sides to \"periodic\""),
    // The particles.
    ("particles = 100", "particles = 100\narrangement = \"glass\"", "arrangement", "\"glass\" is unknown", "known: lattice, distorted, low-discrepancy, file"),
    ("particles = 100", "particles = 100\namplitude = 0.1", "amplitude", "a lattice has no amplitude", "a lattice takes particles"),
    ("particles = 100", "particles = 100\narrangement = \"distorted\"\namplitude = 0.16", "amplitude", "need > 0 and at most 0.15", "0.05"),
    ("particles = 100", "particles = 100\narrangement = \"distorted\"\namplitude = 0", "amplitude", "need > 0 and at most 0.15", "0.05"),
    ("particles = 100", "arrangement = \"file\"", "[resolution]", "`file` is missing", "cloud.csv"),
    ("particles = 100", "particles = 100\narrangement = \"file\"\nfile = \"a.csv\"", "particles", "has no particles", "takes file"),
    ("particles = 100", "", "[resolution]", "`particles` is missing", "`particles = 1000`"),
    // The cut-off.
    ("[time]", "[cut-off]\ntheta = 1.5\n[time]", "theta", "cut-off.theta = 1.5", "need > 0 and at most 1"),
    ("[time]", "[cut-off]\neta = 0.7\nepsilon = 0.1\n[time]", "epsilon", "both eta and epsilon", "keep one"),
    ("[time]", "[cut-off]\ntheta = 0.5\nepsilon = 0.1\n[time]", "theta", "epsilon is a width of its own", "epsilon alone"),
    // Time.
    ("end = 0.5", "end = -0.1", "end", "time.end = -0.1", "0 or a positive number"),
    ("end = 0.5", "end = 0.5\nmethod = \"euler\"", "method", "time.method = \"euler\"", "known: rk4, ssp-rk3, rkl2"),
    ("end = 0.5", "end = 0.5\ncourant = 2", "courant", "time.courant = 2", "at most 1"),
    ("end = 0.5", "end = 0.5\nstep = 0", "step", "time.step = 0", "larger than 0"),
    ("end = 0.5", "end = 0.5\ngrowth-margin = 0", "growth-margin", "time.growth-margin = 0", "larger than 0"),
    // Output.
    ("[time]", "[output]\nexact = \"riemann\"\n[time]", "exact", "output.exact = \"riemann\"", "known: initial"),
    ("[time]", "[output]\nprobe = { lower = [0.0] }\n[time]", "probe", "`points` is missing in [output.probe]", "`points = [200]`"),
    ("[time]", "[output]\nprobe = { points = [0] }\n[time]", "probe", "output.probe.points.0 = 0", "points along each direction"),
    ("[time]", "[output]\nprobe = { points = [3], upper = [3.0] }\n[time]", "probe", "output.probe.upper = 3 lies outside the domain", "move it inside"),
    ("[time]", "[output]\nprobe = { points = [3], lower = [1.0], upper = [1.0] }\n[time]", "probe", "the probe reaches from 1 to 1", "larger than lower"),
    ("[time]", "[tolerance.state]\nl1 = 1\nreason = \"x\"\n[time]", "[tolerance", "no output.exact", "add `exact`"),
    ("[time]", "[output]\nexact = \"initial\"\n[tolerance.presure]\nl1 = 1\nreason = \"x\"\n[time]", "presure", "unknown key `presure` in [tolerance]", "did you mean `pressure`? the keys in [tolerance] are: state, reconstruction, pressure, velocity_x"),
    ("[time]", "[output]\nexact = \"initial\"\n[tolerance.state]\nl1 = 1\n[time]", "[tolerance.state]", "`reason` is missing", "reason ="),
];

/// The same in [`PLANE`].
#[rustfmt::skip]
const PLANE_FAULTS: &[Case] = &[
    ("sides = [\"free\", \"free\"]", "sides = [\"free\", \"mirror\"]", "velocity", "system.velocity.kind = \"rotation\" does not fit: it crosses the lower wall along y", "\"free\""),
    ("sides = [\"free\", \"free\"]", "sides = [\"periodic\", \"free\"]", "velocity", "it differs at the two periodic sides along x", "the sides along x"),
    ("kind = \"rotation\", rate = 2.0", "kind = \"rotation\"", "velocity", "`rate` is missing in [system.velocity]", "`rate = 1.0`"),
    ("kind = \"rotation\", rate = 2.0", "kind = \"uniform\", velocity = [1.0]", "velocity", "system.velocity.velocity has length 1, need 2", "dimension = 2"),
    ("kind = \"transport\"\nvelocity = { kind = \"rotation\", rate = 2.0 }", "kind = \"telegraph\"", "kind", "telegraph has dimension 1 only, dimension = 2", "set dimension = 1"),
    ("kind = \"transport\"\nvelocity = { kind = \"rotation\", rate = 2.0 }", "kind = \"elastic-waves\"\ndensity = 1\nlambda = -1.0\nmu = 0.5", "lambda", "lambda + mu = -0.5 is not above 0", "above -mu"),
    ("kind = \"transport\"\nvelocity = { kind = \"rotation\", rate = 2.0 }", "kind = \"maxwell-te\"\npermittivity = 1\npermeability = 1", "gaussian", "maxwell-te has no such state", "maxwell-te has here: standing-wave"),
];

#[test]
fn every_fault_names_the_value_the_line_and_the_cure() {
    for (text, faults) in [(LINE, LINE_FAULTS), (PLANE, PLANE_FAULTS)] {
        for (from, to, line, value, cure) in faults {
            assert!(text.contains(from), "{from:?} is not in the scenario");
            let changed = text.replacen(from, to, 1);
            let error = linear(&changed, &[]).expect_err(to);
            assert_report_holds(&error, &[value, cure, "mine.toml:"]);
            let (number, _) = error.line_and_column().unwrap();
            let shown = changed.lines().nth(number - 1).unwrap();
            assert!(shown.contains(line), "{to:?} was reported on {shown:?}");
        }
    }
}

/// Fields and sides: what goes together, with the direction at fault where it does not.
#[test]
fn a_field_goes_with_the_sides_it_meets() {
    let with = |field: &str, x: &str, y: &str| {
        let text = PLANE
            .replace("kind = \"rotation\", rate = 2.0", field)
            .replace("[\"free\", \"free\"]", &format!("[\"{x}\", \"{y}\"]"));
        linear(&text, &[]).map_err(|error| report(&error))
    };
    let shear = "kind = \"shear\", rate = 1.0";
    let compression = "kind = \"compression\", rate = 1.0";
    let along_x = "kind = \"uniform\", velocity = [1.0, 0.0]";
    let wave = "kind = \"wave\", amplitude = 0.1";
    for (field, x, y) in [
        ("kind = \"still\"", "mirror", "periodic"),
        (shear, "free", "mirror"),
        (shear, "free", "free"),
        (compression, "free", "free"),
        ("kind = \"compression\", rate = 0.0", "periodic", "mirror"),
        (along_x, "periodic", "mirror"),
        (along_x, "free", "periodic"),
        (wave, "mirror", "mirror"),
        (wave, "periodic", "free"),
    ] {
        with(field, x, y).unwrap();
    }
    for (field, x, y, fault) in [
        (shear, "free", "periodic", "periodic sides along y"),
        (shear, "periodic", "free", "periodic sides along x"),
        (shear, "mirror", "free", "wall along x"),
        (compression, "free", "mirror", "wall along y"),
        (along_x, "mirror", "free", "wall along x"),
    ] {
        let report = with(field, x, y).expect_err(field);
        assert!(report.contains(fault), "no {fault:?} in\n{report}");
    }
    let stream = ["domain.sides=[\"periodic\", \"mirror\"]"];
    let error = built_in_linear("linearised-gas", &stream).unwrap_err();
    assert_report_holds(&error, &["system.velocity", "the lower wall along y"]);
}

#[test]
fn a_round_pulse_of_sound_runs_in_the_open() {
    let closed = ["domain.sides=[\"periodic\", \"periodic\"]"];
    let error = built_in_linear("acoustics2d", &closed).unwrap_err();
    assert_report_holds(&error, &["initial.kind", "all of domain.sides to \"free\""]);
    let line = LINE.replace("\"exp-sine\"", "\"gaussian\"\nwidth = 0.1");
    linear(&line, &[]).unwrap();
    let walls = linear(&line, &["domain.sides=[\"mirror\"]"]).unwrap_err();
    assert_report_holds(&walls, &["initial.kind", "all of domain.sides to \"free\""]);
}

#[test]
fn a_matrix_of_another_size_is_named_with_its_row() {
    let wide = "flux = [[[0.0, 1.0, 2.0], [1.0, 0.0]]]";
    let high = "flux = [[[0.0, 1.0], [1.0, 0.0], [0.0, 0.0]]]";
    let many = "flux = [[[0.0, 1.0], [1.0, 0.0]], [[0.0, 1.0], [1.0, 0.0]]]";
    for (lines, parts) in [
        (
            wide,
            ["system.flux.0.0 =", "of this row is 3, components = 2"],
        ),
        (
            high,
            ["system.flux.0 =", "of its rows is 3, components = 2"],
        ),
        (many, ["system.flux =", "of matrices is 2, dimension = 1"]),
        (
            "flux = [[0.0, 1.0], [1.0, 0.0]]",
            ["system.flux =", "of matrices is 2, dimension = 1"],
        ),
        (
            "flux = [[0.0, 1.0]]",
            ["system.flux.0.0 = 0.0", "need a row: a list of numbers"],
        ),
        (
            "flux = [[[0.0, \"a\"], [1.0, 0.0]]]",
            ["system.flux.0.0.1 = \"a\"", "there is no `a` here"],
        ),
        (
            &format!("{FLUX}\ndecay = [[1.0, 0.0], [1.0]]"),
            ["system.decay.1 =", "of this row is 1, components = 2"],
        ),
        (
            &format!("{FLUX}\nnames = [\"a\"]"),
            ["system.names", "the number of names is 1, components = 2"],
        ),
        (
            &format!("{FLUX}\nnames = [\"a\", \"a\"]"),
            ["system.names.1 = \"a\"", "the same name"],
        ),
        (
            &format!("{FLUX}\nnames = [\"a\", \"weight\"]"),
            ["system.names.1 = \"weight\"", "some are taken"],
        ),
        ("", ["`flux` is missing in [system]", "flux = [[["]),
    ] {
        let error = linear(&matrices(lines), &[]).expect_err(lines);
        assert_report_holds(&error, &parts);
    }
    let nine = matrices(FLUX).replace("components = 2", "components = 9");
    let error = linear(&nine, &[]).unwrap_err();
    assert_report_holds(&error, &["system.components = 9", "1 to 8"]);
    let short = matrices(FLUX).replace("state = [1.0, 0.5]", "state = [1.0]");
    let error = linear(&short, &[]).unwrap_err();
    assert_report_holds(
        &error,
        &["initial.state = [1.0]", "its length is 1, components = 2"],
    );
}
