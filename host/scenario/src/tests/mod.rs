//! Every fault of a scenario names the value, shows the line and tells the cure.

use std::path::PathBuf;

use miette::{GraphicalReportHandler, GraphicalTheme};

use super::*;

mod format;
mod formulas;
mod linear;
mod set;

const SOD: &str = BUILT_IN[0].text;

/// A scenario text in a file of its own, kept until dropped.
struct File {
    folder: tempfile::TempDir,
}

impl File {
    fn new(bytes: impl AsRef<[u8]>) -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("mine.toml"), bytes).unwrap();
        Self { folder }
    }

    fn path(&self) -> PathBuf {
        self.folder.path().join("mine.toml")
    }

    fn read(&self, overrides: &[&str]) -> Result<Scenario, ScenarioError> {
        let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
        Scenario::read(Source::File(self.path()), &overrides)
    }
}

fn sod(overrides: &[&str]) -> Result<Scenario, ScenarioError> {
    let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
    Scenario::read(Source::from("sod"), &overrides)
}

/// The report as the command line prints it, on lines wide enough not to wrap.
fn report(error: &ScenarioError) -> String {
    let mut text = String::new();
    GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor())
        .with_width(500)
        .render_report(&mut text, error)
        .unwrap();
    text
}

#[track_caller]
fn assert_report_holds(error: &ScenarioError, parts: &[&str]) {
    let text = report(error);
    for part in parts {
        assert!(text.contains(part), "no {part:?} in\n{text}");
    }
}

#[test]
fn the_built_in_sod_tube_reads_as_published() {
    let sod = sod(&[]).unwrap();
    assert_eq!((sod.name.as_str(), sod.dimension), ("sod", 1));
    assert_eq!(sod.text, SOD);
    assert_eq!(sod.domain.sides, [[Side::Mirror; 2]]);
    let state = |region: &Region| (region.density, region.velocity[0], region.pressure);
    let states: Vec<_> = sod.regions.iter().map(state).collect();
    assert_eq!(states, [(1.0, 0.0, 1.0), (0.125, 0.0, 0.1)]);
    assert_eq!(sod.materials.len(), 1);
    assert_eq!(
        sod.materials[0].law,
        EquationOfState::IdealGas { gamma: 1.4 }
    );
    assert_eq!(sod.cut_off.shape, motes_core::cutoff::Named::CubicSpline);
    assert_eq!(
        sod.cut_off.width,
        Width::Adaptive {
            eta: 1.0,
            theta: 1.0
        }
    );
    assert_eq!(sod.resolution.particles, 900);
    assert_eq!((sod.time.end, sod.time.courant), (0.2, 0.3));
    assert_eq!(sod.output.exact, Some(Exact::Riemann));
    assert_eq!(sod.output.window.lower, [-0.5]);
}

#[test]
fn every_built_in_scenario_reads_and_carries_its_own_name() {
    for built_in in BUILT_IN {
        let scenario = AnyScenario::read(Source::from(built_in.name), &[]).unwrap();
        assert_eq!(scenario.name(), built_in.name);
        assert!(!scenario.description().is_empty());
        assert_eq!(scenario.text(), built_in.text);
    }
}

#[test]
fn what_is_optional_takes_its_default() {
    let without_output = SOD.split("# Optional, and so").next().unwrap();
    let text = without_output
        .replace("courant = 0.3", "")
        .replace("[units]", "")
        .replace("length = \"1\"", "")
        .replace("mass = \"1\"", "")
        .replace("time = \"1\"", "");
    let scenario = File::new(text).read(&[]).unwrap();
    assert_eq!(scenario.time.courant, 0.3);
    assert_eq!(scenario.units.mass, "1");
    assert_eq!(scenario.output.samples, 100);
    assert_eq!(scenario.output.exact, None);
    assert_eq!(scenario.output.window, scenario.domain.extent);
}

/// Without a cut-off and a viscosity: those of sod in one dimension, Wendland's in two.
#[test]
fn the_usual_cut_off_is_that_of_the_dimension() {
    let without = |text: &str| {
        let (head, rest) = text.split_once("[cut-off]").unwrap();
        format!("{head}[time]{}", rest.split_once("[time]").unwrap().1)
    };
    let line = File::new(without(SOD)).read(&[]).unwrap();
    let sod = sod(&[]).unwrap();
    assert_eq!(line.cut_off, sod.cut_off);
    assert_eq!(line.viscosity, sod.viscosity);
    let text = built_in("sod2d").unwrap().text;
    let plane = File::new(without(text)).read(&[]).unwrap();
    assert_eq!(plane.cut_off.shape, motes_core::cutoff::Named::WendlandC2);
    let sod2d = Scenario::read(Source::from("sod2d"), &[]).unwrap();
    assert_eq!(plane.cut_off, sod2d.cut_off);
}

#[test]
fn an_argument_is_a_file_if_it_ends_in_toml_or_has_a_separator() {
    for file in ["sod.toml", "./sod", "runs/sod"] {
        assert_eq!(Source::from(file), Source::File(PathBuf::from(file)));
    }
    assert_eq!(Source::from("sod"), Source::BuiltIn("sod".to_owned()));
}

#[test]
fn set_changes_one_value_and_keeps_the_comments() {
    let changed = sod(&[
        "material.gamma=2",
        "region.0.density=3",
        "viscosity.kind=none",
        "output.window.lower=[-0.25]",
        "cut-off.epsilon=0.01",
        "units.length=m",
    ])
    .unwrap();
    assert_eq!(
        changed.materials[0].law,
        EquationOfState::IdealGas { gamma: 2.0 }
    );
    assert_eq!(changed.regions[0].density, 3.0);
    assert_eq!(changed.viscosity.kind, ViscosityKind::None);
    assert_eq!(changed.output.window.lower, [-0.25]);
    assert_eq!(changed.cut_off.width, Width::Constant { epsilon: 0.01 });
    assert_eq!(changed.units.length, "m");
    assert!(
        changed
            .text
            .contains("gamma = 2                       # > 1; 1.4 for air")
    );
    let again = File::new(&changed.text).read(&[]).unwrap();
    assert_eq!(again, changed, "the text is the whole scenario");
}

#[test]
fn set_makes_a_section_that_the_file_leaves_out() {
    let file = File::new(SOD.split("# Optional, and so").next().unwrap());
    let scenario = file
        .read(&[
            "output.samples=7",
            "output.window={ lower = [0], upper = [1] }",
        ])
        .unwrap();
    assert_eq!(scenario.output.samples, 7);
    assert_eq!(scenario.output.window.lower, [0.0]);
}

/// Replacement in the text of `sod`; the line it is reported on; the value, and the cure.
type Case = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    &'static str,
);

#[rustfmt::skip]
const FAULTS: &[Case] = &[
    // Syntax and types.
    ("gamma = 1.4", "gamma = ", "gamma = ", "not TOML", "a line is `key = value`"),
    ("end = 0.2", "end = 0.2\nend = 0.3", "end = 0.3", "duplicate key", "a line is"),
    ("gamma = 1.4", "gama = 1.4", "gama", "unknown key `gama` in [material]", "did you mean `gamma`? the keys in [material] are: equation-of-state, gamma"),
    ("[cut-off]", "[cut_off]", "[cut_off]", "unknown key `cut_off` at the top", "did you mean `cut-off`?"),
    ("density = 0.125", "rho = 0.125", "rho", "`rho` in [[region]] 1", "lower, upper, center, radius, material, density, velocity, pressure"),
    ("samples = 100", "sample = 100", "sample", "`sample` in [output]", "did you mean `samples`?"),
    ("gamma = 1.4", "", "[material]", "`gamma` is missing in [material]", "`gamma = 1.4`"),
    ("[viscosity]", "", "kind", "unknown key `kind`", "the keys in [cut-off]"),
    ("gamma = 1.4", "gamma = \"1.4\"", "gamma", "material.gamma = \"1.4\" is text, need a number", "`gamma = 1.4`"),
    ("lower = [-1.0]", "lower = -1.0", "lower", "domain.lower = -1.0", "`lower = [-1.0]`"),
    ("particles = 900 ", "particles = 900.5 ", "particles", "900.5 is a number with a fraction, need a whole number", "`particles = 900`"),
    ("sides = [\"mirror\"]", "sides = [true]", "sides", "domain.sides.0 = true is a truth value", "`sides = [\"mirror\"]`"),
    // Numbers.
    ("gamma = 1.4", "gamma = nan", "gamma", "material.gamma = nan is not a finite", "an ordinary number"),
    ("end = 0.2", "end = inf", "end", "time.end = inf", "an ordinary number"),
    ("end = 0.2", "end = 1e999", "end", "time.end = 1e999", "an ordinary number"),
    ("velocity = [0.0]", "velocity = [nan]", "velocity", "region.0.velocity.0 = nan", "an ordinary number"),
    ("gamma = 1.4", "gamma = 1", "gamma", "material.gamma = 1 is out of range: need > 1", "1.4 for air"),
    ("density = 0.125", "density = 0", "density", "region.1.density = 0 ", "larger than 0"),
    ("pressure = 0.1", "pressure = -0.1", "pressure", "region.1.pressure = -0.1", "larger than 0"),
    ("alpha = 1.0", "alpha = -1.0", "alpha", "viscosity.alpha = -1.0", "damping"),
    ("beta = 2.0", "beta = -2.0", "beta", "viscosity.beta = -2.0", "damping"),
    ("eta = 1.0", "eta = 0.0", "eta", "cut-off.eta = 0.0", "larger than 0"),
    ("courant = 0.3 ", "courant = 1.5 ", "courant", "time.courant = 1.5", "0.3 is safe"),
    ("courant = 0.3 ", "courant = 0 ", "courant", "need > 0 and at most 1", "0.3 is safe"),
    ("end = 0.2", "end = -0.1", "end", "time.end = -0.1", "0 or a positive number"),
    ("particles = 900 ", "particles = 0 ", "particles", "resolution.particles = 0", "number of particles"),
    ("particles = 900 ", "particles = -9 ", "particles", "resolution.particles = -9", "number of particles"),
    ("samples = 100", "samples = 0", "samples", "output.samples = 0", "rows of the time series"),
    ("dimension = 1 ", "dimension = 4 ", "dimension", "dimension = 4", "1, 2 or 3"),
    // Boxes.
    ("dimension = 1 ", "dimension = 2 ", "lower = [-1.0]", "domain.lower has length 1, need 2", "dimension = 2"),
    ("velocity = [0.0]", "velocity = [0.0, 0.0]", "velocity", "region.0.velocity has length 2", "dimension = 1"),
    ("upper = [1.0]", "upper = [-1.0]", "upper", "domain is empty: upper = -1 is not above lower = -1 along x", "make domain.upper larger"),
    ("upper = [0.0]", "upper = [-3.0]", "upper", "region.0 is empty", "make region.0.upper larger"),
    ("upper = [0.0]", "upper = [3.0]", "upper", "region.0.upper = 3 lies outside the domain: [-1, 1] along x", "enlarge domain.lower"),
    ("lower = [0.0]", "lower = [-0.25]", "lower", "region.1 overlaps region.0: both hold x in [-0.25, 0]", "may touch but not overlap"),
    ("upper = [0.5]", "upper = [5]", "window", "output.window.upper = 5 lies outside", "enlarge domain.lower"),
    ("sides = [\"mirror\"]", "sides = [[\"periodic\", \"free\"]]", "sides", "domain.sides.0 = [\"periodic\", \"free\"] is periodic at one end", "for the direction"),
    ("sides = [\"mirror\"]", "sides = [[\"free\"]]", "sides", "need a name or a pair of names", "`sides = [\"mirror\"]`"),
    // Choices.
    ("sides = [\"mirror\"]", "sides = [\"miror\"]", "sides", "domain.sides.0 = \"miror\" is unknown", "did you mean `mirror`? known: periodic, mirror, free"),
    ("name = \"cubic-spline\"", "name = \"cubic\"", "name", "cut-off.name = \"cubic\"", "known: cubic-spline, quintic-spline, wendland-c2, wendland-c4, wendland-c6, root-free"),
    ("kind = \"pairwise\"", "kind = \"von-neumann\"", "kind", "viscosity.kind = \"von-neumann\"", "did you mean `von_neumann`? known: pairwise, gingold_monaghan, von_neumann, limited, none"),
    ("equation-of-state = \"ideal-gas\"", "equation-of-state = \"gas\"", "equation-of-state", "\"gas\" is unknown", "known: ideal-gas, stiffened-gas, isothermal, tait"),
    ("arrangement = \"equal-mass\"", "arrangement = \"grid\"", "arrangement", "\"grid\" is unknown", "known: equal-mass, square, hexagonal, cubic, close-packed, sampled, glass, file"),
    ("exact = \"riemann\"", "exact = \"sod\"", "exact", "output.exact = \"sod\"", "known: riemann, sedov, profile, reference"),
    ("name = \"sod\"", "name = \"../sod\"", "name", "name = \"../sod\" is not a plain name", "letters, digits"),
    ("eta = 1.0", "eta = 1.2\nepsilon = 0.01", "epsilon", "both eta and epsilon", "keep one"),
    ("eta = 1.0", "", "[cut-off]", "neither eta nor epsilon", "add `eta = 1.2`"),
    ("lower = [0.0]", "lower = [0.25]", "exact", "the two regions do not touch", "exactly two regions"),
];

#[test]
fn every_fault_names_the_value_the_line_and_the_cure() {
    for (from, to, line, value, cure) in FAULTS {
        assert!(SOD.contains(from), "{from:?} is not in sod.toml");
        let file = File::new(SOD.replacen(from, to, 1));
        let error = file.read(&[]).expect_err(to);
        let (number, column) = error.line_and_column().unwrap();
        let place = format!("mine.toml:{number}:{column}]");
        assert_report_holds(&error, &[value, cure, &place]);
        let text = SOD.replacen(from, to, 1);
        let shown = text.lines().nth(number - 1).unwrap();
        assert!(shown.contains(line), "{to:?} was reported on {shown:?}");
        assert_report_holds(&error, &[shown]);
    }
}

#[test]
fn a_missing_section_is_reported_at_the_end_of_the_file() {
    let head = SOD.split("[material]").next().unwrap();
    let error = File::new(head).read(&[]).unwrap_err();
    let last = head.trim_end().lines().count();
    assert_eq!(error.line_and_column().unwrap().0, last);
    assert_report_holds(&error, &["`material` is missing at the top", "[material]"]);
}

#[test]
fn a_third_region_is_no_riemann_problem() {
    let third = "[[region]]\nlower = [0.5]\nupper = [1.0]\ndensity = 1\nvelocity = [0]\npressure = 1\n\n[material]";
    let text = SOD.replace("[material]", third);
    let text = text.replacen(
        "upper = [1.0]\ndensity = 0.125",
        "upper = [0.5]\ndensity = 0.125",
        1,
    );
    let error = File::new(text).read(&[]).unwrap_err();
    assert_report_holds(&error, &["the number of regions is 3", "leave `exact` out"]);
}

#[test]
fn a_faulty_set_names_the_flag_and_the_cure() {
    for (set, value, cure) in [
        (
            "material.gama=2",
            "unknown key `gama` in [material]",
            "did you mean `gamma`?",
        ),
        (
            "materials.gamma=2",
            "unknown key `materials`",
            "did you mean `material`?",
        ),
        ("gamma=2", "unknown key `gamma` at the top", "material"),
        ("material.gamma.x=2", "unknown key `x`", "the keys"),
        (
            "material.gamma",
            "not of the form section.key=value",
            "--set material.gamma=1.4",
        ),
        ("=2", "not of the form", "--set material.gamma=1.4"),
        (
            "material.gamma=",
            "not of the form",
            "--set material.gamma=1.4",
        ),
        (
            "material=2",
            "names a section",
            "--set material.equation-of-state=...",
        ),
        ("region.0=2", "names a section", "--set region.0.lower=..."),
        ("region=2", "names a section", "--set region.0.lower=..."),
        ("region=[1]", "names a section", "--set region.0.lower=..."),
        (
            "region.2.density=2",
            "there is no region 2, the file has 2",
            "from 0 to 1",
        ),
        (
            "region.density=2",
            "there is no region density",
            "from 0 to 1",
        ),
        (
            "region.0.rho=2",
            "unknown key `rho` in [[region]] 0",
            "density",
        ),
        (
            "description=two words",
            "`two words` is not a value",
            "description=\"two words\"",
        ),
    ] {
        let error = sod(&[set]).expect_err(set);
        assert_report_holds(&error, &["--set", set, value, cure, "[--set:1:1]"]);
    }
}

#[test]
fn a_value_out_of_range_from_set_shows_the_changed_line() {
    let error = sod(&["material.gamma=0.9"]).unwrap_err();
    let line = "gamma = 0.9                       # > 1";
    assert_report_holds(
        &error,
        &["material.gamma = 0.9", "sod (built in) after --set:", line],
    );
}

#[test]
fn an_unreadable_source_tells_what_to_do() {
    let unknown = Scenario::read(Source::from("sodd"), &[]).unwrap_err();
    let parts = [
        "`sodd`",
        "did you mean `sod`?",
        "built-in scenarios: sod",
        ".toml",
    ];
    assert_report_holds(&unknown, &parts);

    let missing = Scenario::read(Source::from("no/such.toml"), &[]).unwrap_err();
    assert_report_holds(&missing, &["no file `no/such.toml`", "motes list"]);

    let folder = tempfile::tempdir().unwrap();
    let directory = Scenario::read(Source::File(folder.path().to_owned()), &[]).unwrap_err();
    assert_report_holds(&directory, &["is a directory", "give the .toml file"]);

    let latin = File::new(b"name = \"sod\"\ndescription = \"caf\xe9\"\n");
    let not_utf8 = latin.read(&[]).unwrap_err();
    assert_eq!(not_utf8.line_and_column(), Some((2, 19)));
    assert_report_holds(
        &not_utf8,
        &["0xe9", "mine.toml:2:19", "save the file as UTF-8"],
    );
}

#[test]
fn an_empty_file_reports_a_missing_key_and_line_ends_do_not_matter() {
    for empty in ["", "\n", "# nothing\n\n"] {
        let error = File::new(empty).read(&[]).unwrap_err();
        assert_report_holds(&error, &["`name` is missing", "mine.toml:1:", "my-tube"]);
    }
    let windows = File::new(SOD.replace('\n', "\r\n")).read(&[]).unwrap();
    assert_eq!(windows.regions, sod(&[]).unwrap().regions);
    let marked = File::new(format!("\u{feff}{SOD}")).read(&["time.end=0.1"]);
    assert_eq!(marked.unwrap().time.end, 0.1);
}

/// What may never begin or never end is not read.
#[cfg(unix)]
#[test]
fn a_pipe_a_device_and_a_text_without_end_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let read = |path: &std::path::Path| {
        let error = AnyScenario::read(Source::File(path.to_owned()), &[]).unwrap_err();
        format!("{error}: {}", error.problem().help())
    };
    let pipe = folder.path().join("pipe.toml");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    for path in [&*pipe, std::path::Path::new("/dev/zero")] {
        let text = read(path);
        assert!(
            text.contains("pipe or a device") && text.contains("into a file"),
            "{text}"
        );
    }
    let long = folder.path().join("long.toml");
    let file = std::fs::File::create(&long).unwrap();
    file.set_len((1 << 24) + 1).unwrap();
    assert!(read(&long).contains("16777216 bytes"), "{}", read(&long));
    // A file that a scenario names, likewise.
    let wall = BUILT_IN
        .iter()
        .find(|built_in| built_in.name == "wall-day")
        .unwrap();
    let text = wall.text.replace("\"wall-day.csv\"", "\"pipe.toml\"");
    let scenario = folder.path().join("wall.toml");
    std::fs::write(&scenario, text).unwrap();
    let text = read(&scenario);
    assert!(text.contains("pipe or a device"), "{text}");
}

/// Wherever a value stands in a message.
#[test]
fn a_value_of_50_000_characters_is_not_repeated_whole() {
    let long = "x".repeat(50_000);
    let number = "9".repeat(50_000);
    let name = |text: &str| BUILT_IN.iter().find(|one| one.name == text).unwrap().text;
    let texts = [
        name("sod").replace("name = \"sod\"", &format!("name = \"{long} \"")),
        name("sod").replace("kind = \"pairwise\"", &format!("kind = \"{long}\"")),
        name("sod").replace("[time]", &format!("[time]\n{long} = 1")),
        name("sod").replace("[time]", &format!("[{long}]\na = 1\n[time]")),
        name("sod").replace("gamma = 1.4", &format!("gamma = -{number}")),
        name("sod").replace("gamma = 1.4", &format!("gamma = \"{long}\"")),
        name("sod").replace("gamma = 1.4", &format!("gamma = {long}")),
        name("wall-day").replace("axis = \"x\"", &format!("axis = \"{long}\"")),
        name("wall-day").replace("\"wall-day.csv\"", &format!("\"{long}\"")),
        name("wall-day").replace("column = \"temperature\"", &format!("column = \"{long}\"")),
        name("wall-day").replace(
            "species = [",
            &format!("species = [\"{long}\", \"{long}\", "),
        ),
    ];
    let mut all = Vec::new();
    for (i, text) in texts.into_iter().enumerate() {
        assert!(text.len() > 50_000, "{i} is as it was");
        all.push(AnyScenario::read(Source::Text(text), &[]));
    }
    let sets = [
        format!("material.gamma={long}"),
        format!("material.{long}=1"),
        format!("{long}.gamma=1"),
        format!("region.{number}.density=1"),
        long.clone(),
        format!("viscosity.kind=({long}"),
    ];
    all.extend(sets.map(|set| AnyScenario::read(Source::from("sod"), &[set])));
    all.push(AnyScenario::read(Source::BuiltIn(long.clone()), &[]));
    all.push(AnyScenario::read(Source::File(long.into()), &[]));
    for (i, read) in all.into_iter().enumerate() {
        let error = read.expect_err(&format!("{i} is a scenario"));
        let report = report(&error);
        assert!(
            report.len() < 3000,
            "{i}: {} characters: {:.400}",
            report.len(),
            report
        );
    }
}

#[test]
fn whole_numbers_may_have_a_point_and_fractions_may_not() {
    let read = |value: &str| sod(&[&format!("resolution.particles={value}")]);
    for whole in ["900", "900.0", "9e2", "9_00"] {
        assert_eq!(read(whole).unwrap().resolution.particles, 900, "{whole}");
    }
    for other in ["900.5", "1e300", "nan", "\"900\""] {
        assert!(read(other).is_err(), "{other}");
    }
}

/// What docs/scenario.md says of `[viscosity]` holds key by key.
#[test]
fn a_viscosity_that_is_set_takes_the_rest_of_its_defaults() {
    let text = BUILT_IN.iter().find(|one| one.name == "sod").unwrap().text;
    let start = text.find("[viscosity]").unwrap();
    let end = start + text[start + 1..].find("\n[").unwrap() + 1;
    let without = format!("{}{}", &text[..start], &text[end..]);
    let read = |set: &str| {
        let source = Source::Text(without.clone());
        Scenario::read(source, &[set.to_owned()]).unwrap().viscosity
    };
    let limited = read("viscosity.kind=limited");
    assert_eq!(
        (limited.kind, limited.alpha, limited.beta),
        (ViscosityKind::Limited, 1.0, 2.0)
    );
    let weak = read("viscosity.alpha=0.5");
    assert_eq!(
        (weak.kind, weak.alpha, weak.beta),
        (ViscosityKind::Pairwise, 0.5, 2.0)
    );
}

#[test]
fn other_separators_than_commas_are_told() {
    let folder = tempfile::tempdir().unwrap();
    for (separator, name) in [(";", "`;`"), ("\t", "tabs")] {
        let path = folder.path().join("cloud.csv");
        let text = ["position", "mass\n0.5", "1\n"].join(separator);
        std::fs::write(&path, text).unwrap();
        let read = table::read(&path, |table| table.required("mass", "need mass"));
        let error = read.map(|_| ()).unwrap_err();
        let help = miette::Diagnostic::help(&*error).unwrap().to_string();
        assert!(help.contains(&format!("separated by {name}")), "{help}");
    }
}
