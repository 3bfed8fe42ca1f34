//! Formulas: where they may stand, what they may use, and their faults.

use super::*;
use crate::linear;

/// A gas whose state is given by formulas.
const GAS: &str = r#"
name = "wave"
dimension = 2
[define]
k = "2*pi"
"bump(s)" = "1 + 0.1*sin(k*s)"
[domain]
lower = [0.0, 0.0]
upper = [1.0, 1.0]
sides = ["periodic", "periodic"]
[profile]
kind = "formula"
density = "bump(x)"
velocity = [1, "0.5*r"]
pressure = 2.5
[material]
equation-of-state = "ideal-gas"
gamma = 1.4
[resolution]
particles = 100
arrangement = "square"
share = "volume"
[cut-off]
name = "wendland-c2"
eta = 1.5
[time]
end = 0.1
[output]
exact = { density = "bump(x - t)", velocity = ["1", "0"], pressure = "2.5" }
"#;

/// Heat that begins as a formula says.
const HEAT: &str = r#"
name = "heat"
dimension = 1
[define]
decay = "exp(-t)"
[domain]
lower = [0.0]
upper = [1.0]
sides = ["periodic"]
[system]
kind = "convection-diffusion"
diffusivity = 0.1
[initial]
kind = "formula"
state = "sin(x)*decay"
[resolution]
particles = 100
[cut-off]
name = "cubic-spline"
eta = 1.2
[time]
end = 0.1
[output]
exact = ["sin(x)*decay"]
"#;

fn read(text: &str, changes: &[&str]) -> Result<AnyScenario, ScenarioError> {
    let changes: Vec<String> = changes.iter().map(|change| (*change).to_owned()).collect();
    AnyScenario::read(Source::Text(text.to_owned()), &changes)
}

#[test]
fn a_gas_may_be_what_formulas_say() {
    let AnyScenario::Gas(scenario) = read(GAS, &[]).unwrap() else {
        panic!("a gas");
    };
    let Some(Profile::Formula(pieces)) = &scenario.profile else {
        panic!("formulas");
    };
    let [Piece { state, .. }] = &pieces[..] else {
        panic!("one piece");
    };
    let at = [0.25, 0.0, 0.0, 7.0];
    assert_eq!(state.density.at(&at), 1.1);
    assert_eq!(state.velocity[0].at(&at), 1.0);
    assert_eq!(state.velocity[1].at(&at), 0.125);
    assert_eq!(state.pressure.as_ref().map(|p| p.at(&at)), Some(2.5));
    assert_eq!(scenario.output.exact, Some(Exact::Formula));
    let exact = scenario.output.formulas.unwrap();
    assert_eq!(exact.density.at(&[0.5, 0.0, 0.0, 0.25]), 1.1);
}

#[test]
fn a_system_may_begin_as_formulas_say() {
    let AnyScenario::Linear(scenario) = read(HEAT, &[]).unwrap() else {
        panic!("a system");
    };
    let Some(linear::Initial::Formula { state }) = &scenario.initial else {
        panic!("formulas");
    };
    assert_eq!(state[0].at(&[0.5, 0.0, 0.0, 0.0]), libm::sin(0.5));
    let Some(linear::Exact::Formula(exact)) = &scenario.output.exact else {
        panic!("formulas");
    };
    let expected = libm::sin(0.5) * libm::exp(-2.0);
    assert_eq!(exact[0].at(&[0.5, 0.0, 0.0, 2.0]), expected);
}

#[test]
fn definitions_are_changed_by_set_and_sections_by_plain_values() {
    let AnyScenario::Linear(scenario) = read(HEAT, &["define.decay=\"2*t\""]).unwrap() else {
        panic!("a system");
    };
    let Some(linear::Exact::Formula(exact)) = &scenario.output.exact else {
        panic!("formulas");
    };
    assert_eq!(exact[0].at(&[0.5, 0.0, 0.0, 2.0]), 4.0 * libm::sin(0.5));
    // A function that there was not, in a section that there was and in one that there was not.
    for text in [
        HEAT.to_owned(),
        HEAT.replace("[define]\ndecay = \"exp(-t)\"\n", "")
            .replace("*decay", ""),
    ] {
        let changes = ["define.f(s)=\"3*s\"", "initial.state=\"f(x)\""];
        let AnyScenario::Linear(scenario) = read(&text, &changes).unwrap() else {
            panic!("a system");
        };
        let Some(linear::Initial::Formula { state }) = &scenario.initial else {
            panic!("formulas");
        };
        assert_eq!(state[0].at(&[0.5, 0.0, 0.0, 0.0]), 1.5);
    }
    let error = read(HEAT, &["define=3"]).unwrap_err();
    assert_report_holds(
        &error,
        &["--set define names a section", "any name may be defined"],
    );
    let AnyScenario::Gas(sod) =
        AnyScenario::read(Source::from("sod"), &["output.exact=reference".to_owned()]).unwrap()
    else {
        panic!("a gas");
    };
    assert_eq!(sod.output.exact, Some(Exact::Reference));
}

/// The text below a caret, the message and the cure.
#[test]
fn a_fault_in_a_formula_is_shown_where_it_is() {
    for (text, from, to, under, message, cure) in [
        (
            HEAT,
            "sin(x)*decay\"\n[res",
            "sin(x)*decai\"\n[res",
            "decai",
            "there is no `decai` here",
            "did you mean `decay`?",
        ),
        (
            HEAT,
            "sin(x)*decay\"\n[res",
            "sin(y)\"\n[res",
            "y",
            "there is no `y` here",
            "known here: x, t, decay, r, pi",
        ),
        (
            HEAT,
            "exp(-t)",
            "exp(-t",
            "(",
            "define.decay = \"exp(-t\": this parenthesis is not closed",
            "close it",
        ),
        (
            HEAT,
            "exp(-t)",
            "2*decay",
            "decay",
            "the definition of `decay` needs itself",
            "define it by",
        ),
        (
            HEAT,
            "decay = \"exp(-t)\"",
            "x = 1",
            "1",
            "`x` cannot be defined: it is a variable",
            "use letters",
        ),
        (
            HEAT,
            "decay = \"exp(-t)\"",
            "decay = true",
            "true",
            "define.decay = true is a truth value, need a number, or a formula",
            "",
        ),
        (
            HEAT,
            "[\"sin(x)*decay\"]",
            "[\"1\", \"2\"]",
            "[\"1\", \"2\"]",
            "its length is 2, components = 1",
            "one formula",
        ),
        (
            GAS,
            "\"bump(x)\"\nvel",
            "\"bump(x, y)\"\nvel",
            "bump",
            "`bump` takes (s), found 2",
            "commas",
        ),
        (
            GAS,
            "density = \"bump(x)\"\n",
            "",
            "",
            "`density` is missing in [profile]",
            "add for example",
        ),
        (
            GAS,
            "velocity = [1, \"0.5*r\"]",
            "velocity = [1]",
            "[1]",
            "profile.velocity has length 1, need 2",
            "",
        ),
        (
            GAS,
            "pressure = \"2.5\" }",
            "presure = \"2.5\" }",
            "presure",
            "unknown key `presure` in [output.exact]",
            "did you mean `pressure`?",
        ),
    ] {
        assert!(text.contains(from), "{from:?} is not in the scenario");
        let changed = text.replacen(from, to, 1);
        let error = read(&changed, &[]).unwrap_err();
        assert_report_holds(&error, &[message, cure]);
        let (line, column) = error.line_and_column().unwrap();
        let shown = &changed.lines().nth(line - 1).unwrap()[column - 1..];
        assert!(
            shown.starts_with(under),
            "{shown:?} does not begin with {under:?}"
        );
    }
}

#[test]
fn a_barotropic_gas_takes_no_pressure() {
    let law = "equation-of-state = \"isothermal\"\nsound-speed = 1.0";
    let gas = GAS.replace("equation-of-state = \"ideal-gas\"\ngamma = 1.4", law);
    let error = read(&gas, &[]).unwrap_err();
    assert_report_holds(&error, &["profile.pressure = 2.5", "take `pressure` out"]);
}

/// Two boxes of [`GAS`], the first with a formula.
const BOXES: &str = r#"[[region]]
lower = [0.0, 0.0]
upper = [0.5, 1.0]
density = "bump(x)"
velocity = [1, 0]
pressure = 2.5
[[region]]
lower = [0.5, 0.0]
upper = [1.0, 1.0]
density = 1
velocity = [0, 0]
pressure = 1
"#;

/// [`GAS`] with these regions in the place of its profile.
fn with_regions(regions: &str) -> String {
    let start = GAS.find("[profile]").unwrap();
    let end = GAS.find("[material]").unwrap();
    format!("{}{regions}{}", &GAS[..start], &GAS[end..])
}

#[test]
fn regions_may_be_what_formulas_say() {
    let AnyScenario::Gas(scenario) = read(&with_regions(BOXES), &[]).unwrap() else {
        panic!("a gas");
    };
    let Some(Profile::Formula(pieces)) = &scenario.profile else {
        panic!("formulas");
    };
    assert!(scenario.regions.is_empty());
    assert_eq!(pieces[1].extent.lower, [0.5, 0.0]);
    assert_eq!(pieces[0].state.density.at(&[0.25, 0.0, 0.0, 0.0]), 1.1);
    assert_eq!(pieces[1].state.density.value(), Some(1.0));
    for (from, to, parts) in [
        (
            "upper = [1.0, 1.0]",
            "upper = [0.9, 1.0]",
            ["region.0.density", "the regions fill 0.9 of 1"],
        ),
        (
            "lower = [0.5, 0.0]",
            "lower = [0.4, 0.0]",
            ["region.1 overlaps region.0", "both hold x"],
        ),
        (
            "density = 1\n",
            "density = \"q\"\n",
            ["region.1.density", "there is no `q` here"],
        ),
        (
            "density = 1\n",
            "",
            ["`density` is missing", "[[region]] 1"],
        ),
        (
            "lower = [0.5, 0.0]\nupper = [1.0, 1.0]",
            "center = [0.7, 0.5]\nradius = 0.1",
            ["region.1.radius", "a ball cuts into"],
        ),
    ] {
        assert!(BOXES.contains(from));
        let error = read(&with_regions(&BOXES.replacen(from, to, 1)), &[]).unwrap_err();
        assert_report_holds(&error, &parts);
    }
}

#[test]
fn a_wall_may_be_driven_by_a_formula_of_time_alone() {
    let walls = "sides = [\"mirror\"]\n[[wall]]\naxis = \"x\"\nend = \"lower\"\nkind = \"value\"\nvalue = \"DRIVE\"";
    let with = |drive: &str| HEAT.replace("sides = [\"periodic\"]", &walls.replace("DRIVE", drive));
    let AnyScenario::Linear(scenario) = read(&with("2*t"), &[]).unwrap() else {
        panic!("a system");
    };
    let linear::System::ConvectionDiffusion(of) = &scenario.system else {
        panic!("diffusion");
    };
    let Some(linear::Drive::Formula(drive)) = of.walls[0][0][0].drive() else {
        panic!("a formula");
    };
    assert_eq!(drive.at(&[0.0, 0.0, 0.0, 3.0]), 6.0);
    let error = read(&with("x + t"), &[]).unwrap_err();
    assert_report_holds(
        &error,
        &["wall.0.value = \"x + t\"", "a formula of t alone"],
    );
}

/// What varies from place to place has a kind of its own, and the error names it; a source may be a formula.
#[test]
fn a_system_by_name_refuses_formulas_in_place_of_its_constants() {
    for (name, change) in [
        ("acoustics1d", "system.sound-speed=\"1 + 0.1*x\""),
        ("telegraph", "system.resistance=\"x\""),
        ("transport-rotation", "system.decay=\"0.1*x\""),
        ("shallow-water", "system.depth=\"2 - x\""),
    ] {
        let error = AnyScenario::read(Source::from(name), &[change.to_owned()]).unwrap_err();
        let key = change.split('=').next().unwrap();
        let words = [
            key,
            "the same everywhere",
            "kind = \"matrices\" takes formulas",
        ];
        assert_report_holds(&error, &words);
    }
    let system = "kind = \"transport\"\nvelocity = [\"1 + 0.1*sin(2*pi*x)\"]\nsource = [\"x*t\"]";
    let text = HEAT.replace("kind = \"convection-diffusion\"\ndiffusivity = 0.1", system);
    assert!(text.contains(system));
    read(&text, &[]).unwrap();
}
