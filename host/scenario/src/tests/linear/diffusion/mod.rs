//! Convection-diffusion: what its sections read as, and the defaults.

use super::*;
use crate::linear::Exact;
use crate::linear::{
    Conductor, ConvectionDiffusion, Drive, Form, Mean, Modulation, Reaction, WallCondition,
};

mod faults;
mod files;
mod solutions;

/// The least that describes diffusion between two walls.
const SLAB: &str = r#"
name = "slab"
dimension = 1
[domain]
lower = [-1.0]
upper = [3.0]
sides = ["mirror"]
[system]
kind = "convection-diffusion"
diffusivity = 0.5
[initial]
kind = "uniform"
state = [1.0]
[resolution]
particles = 100
[time]
end = 0.5
"#;

/// Two species in two dimensions, with every key that there is.
const SHEET: &str = r#"
name = "sheet"
dimension = 2
[domain]
lower = [0.0, 0.0]
upper = [1.0, 1.0]
sides = ["periodic", "mirror"]
[system]
kind = "convection-diffusion"
species = ["u", "v"]
diffusivity = [0.5, 0.25]
form = "direct"
mean = "harmonic"
velocity = { kind = "uniform", velocity = [1.0, 0.0] }
profile = { kind = "layers", bounds = [0.25, 0.5], factors = [1.0, 10.0, 2.0] }
modulation = { amplitude = -0.5, rate = 3.0 }
tensor = [[1.0, 0.0], [0.0, 0.5]]
reaction = { kind = "gray-scott", feed = 0.037, kill = 0.06 }
[[wall]]
axis = "y"
end = "lower"
kind = "value"
value = 2.0
[[wall]]
axis = "y"
end = "upper"
species = "v"
kind = "exchange"
rate = 0.1
outside = -1.0
[motion]
kind = "flow"
[initial]
kind = "spots"
background = [1.0, 0.0]
spot = [0.5, 0.25]
centers = [[0.5, 0.5], [0.25, 0.75]]
width = 0.1
[resolution]
particles = 100
[time]
end = 0.5
method = "rkl2"
stages = 15
"#;

fn diffusion(scenario: &LinearScenario) -> &ConvectionDiffusion {
    match &scenario.system {
        System::ConvectionDiffusion(diffusion) => diffusion,
        other => panic!("{other:?}"),
    }
}

/// `text` after replacements, each of which must apply.
#[track_caller]
fn changed(text: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from:?} is not in the scenario");
        text.replacen(from, to, 1)
    })
}

#[test]
fn what_is_left_out_takes_its_default() {
    let scenario = read(SLAB);
    let closed = || vec![WallCondition::NoFlux];
    assert_eq!(
        *diffusion(&scenario),
        ConvectionDiffusion {
            species: vec!["u".to_owned()],
            form: Form::Direct,
            mean: Mean::Arithmetic,
            velocity: Field::Still,
            diffusivity: vec![0.5],
            profile: Conductor::Uniform,
            modulation: None,
            tensor: None,
            reaction: Reaction::None,
            walls: vec![[closed(), closed()]],
        }
    );
    assert!(diffusion(&scenario).is_closed());
    assert_eq!(scenario.system.name(), "convection-diffusion");
    assert_eq!(scenario.system.wave_speed(), 0.0);
    assert_eq!(scenario.motion, Field::Still);
    let time = &scenario.time;
    assert_eq!((time.method, time.stages), (Method::Rkl2, 9));
    assert_eq!((time.step, time.growth_margin), (None, 0.1));
    let line = read(LINE);
    assert_eq!(line.time.method, Method::Rk4, "of another system");
}

#[test]
fn every_key_reads_as_written() {
    let scenario = read(SHEET);
    let names = ["u".to_owned(), "v".to_owned()];
    assert_eq!(scenario.system.names(2), names);
    let velocity = Field::Uniform {
        velocity: vec![1.0, 0.0],
    };
    assert_eq!(scenario.motion, velocity);
    let exchange = WallCondition::Exchange {
        rate: 0.1,
        outside: Drive::Constant(-1.0),
    };
    let value = WallCondition::Value(Drive::Constant(2.0));
    let closed = || vec![WallCondition::NoFlux; 2];
    let diffusion = diffusion(&scenario);
    assert!(!diffusion.is_closed());
    assert_eq!(
        *diffusion,
        ConvectionDiffusion {
            species: names.to_vec(),
            form: Form::Direct,
            mean: Mean::Harmonic,
            velocity,
            diffusivity: vec![0.5, 0.25],
            profile: Conductor::Layers {
                bounds: vec![0.25, 0.5],
                factors: vec![1.0, 10.0, 2.0],
            },
            modulation: Some(Modulation {
                amplitude: -0.5,
                rate: 3.0
            }),
            tensor: Some(vec![vec![1.0, 0.0], vec![0.0, 0.5]]),
            reaction: Reaction::GrayScott {
                feed: 0.037,
                kill: 0.06
            },
            walls: vec![
                [closed(), closed()],
                [
                    vec![value.clone(), value],
                    vec![WallCondition::NoFlux, exchange]
                ]
            ],
        }
    );
    let spots = Initial::Spots {
        background: vec![1.0, 0.0],
        spot: vec![0.5, 0.25],
        centers: vec![vec![0.5, 0.5], vec![0.25, 0.75]],
        width: 0.1,
    };
    assert_eq!(scenario.initial, Some(spots));
    assert_eq!(
        (scenario.time.method, scenario.time.stages),
        (Method::Rkl2, 15)
    );
}

/// The other choices of each key.
#[test]
fn every_kind_reads_as_written() {
    let of = |line: &str| {
        let text = changed(
            SLAB,
            &[("= 0.5\n[initial]", &format!("= 0.5\n{line}\n[initial]"))],
        );
        diffusion(&read(&text)).clone()
    };
    assert_eq!(of("mean = \"harmonic\"").mean, Mean::Harmonic);
    assert_eq!(of("species = [\"heat\"]").species, ["heat"]);
    let three = "= 0.5\nspecies = [\"a\", \"b\", \"c\"]\n[initial]";
    let three = changed(SLAB, &[("= 0.5\n[initial]", three), ("[1.0]", "[1, 0, 0]")]);
    let three = read(&three);
    assert_eq!(
        diffusion(&three).diffusivity,
        [0.5; 3],
        "one number is for all"
    );
    assert_eq!(
        of("profile = { kind = \"parabola\" }").profile,
        Conductor::Parabola {
            center: 1.0,
            radius: 2.0
        },
        "0 at the sides"
    );
    assert_eq!(
        of("profile = { kind = \"parabola\", center = 0.5, radius = 3 }").profile,
        Conductor::Parabola {
            center: 0.5,
            radius: 3.0
        }
    );
    assert_eq!(
        of("reaction = { kind = \"linear\", matrix = [[-2.0]] }").reaction,
        Reaction::Linear {
            matrix: vec![-2.0],
            source: vec![0.0]
        }
    );
    assert_eq!(
        of("reaction = { kind = \"logistic\", rate = 2.0, capacity = 3.0 }").reaction,
        Reaction::Logistic {
            rate: 2.0,
            capacity: 3.0
        }
    );
    let flux = of("[[wall]]\naxis = \"x\"\nend = \"upper\"\nkind = \"flux\"\nflux = -0.5");
    let flux_in = WallCondition::Flux(Drive::Constant(-0.5));
    assert_eq!(flux.walls, [[vec![WallCondition::NoFlux], vec![flux_in]]]);
    let closed = of("[[wall]]\naxis = \"x\"\nend = \"upper\"\nkind = \"no-flux\"");
    assert!(closed.is_closed());
}

#[test]
fn every_initial_state_reads_as_written() {
    let of = |lines: &str, more: &str| {
        let text = changed(
            SLAB,
            &[
                ("kind = \"uniform\"\nstate = [1.0]", lines),
                ("= 0.5\n[initial]", &format!("= 0.5\n{more}\n[initial]")),
            ],
        );
        read(&text).initial.unwrap()
    };
    let band = |center, amplitude| Initial::Band {
        center,
        length: 0.5,
        width: 0.1,
        amplitude,
    };
    let lines = "kind = \"band\"\nlength = 0.5\nwidth = 0.1";
    assert_eq!(of(lines, ""), band(1.0, 1.0));
    let lines = format!("{lines}\ncenter = 0.25\namplitude = -2");
    assert_eq!(of(&lines, ""), band(0.25, -2.0));
    let legendre = Initial::Legendre {
        degree: 32,
        amplitude: 1.0,
    };
    let parabola = "profile = { kind = \"parabola\" }";
    assert_eq!(of("kind = \"legendre\"\ndegree = 32", parabola), legendre);
    let modes = Initial::Modes {
        wave: vec![2],
        state: vec![3.0],
    };
    assert_eq!(of("kind = \"modes\"\nwave = [2]\nstate = [3.0]", ""), modes);
    let gaussian = Initial::Gaussian {
        center: vec![1.0],
        width: 0.5,
        amplitude: 1.0,
    };
    assert_eq!(of("kind = \"gaussian\"\nwidth = 0.5", ""), gaussian);
}

#[test]
fn set_reaches_every_section_of_convection_diffusion() {
    let scenario = linear(
        SHEET,
        &[
            "system.reaction.feed=0.04",
            "system.profile.factors=[1, 2, 3]",
            "system.modulation.rate=4",
            "wall.0.value=3",
            "wall.1.rate=0.2",
            "time.step=0.01",
        ],
    )
    .unwrap();
    let now = diffusion(&scenario);
    assert!(matches!(now.reaction, Reaction::GrayScott { feed, .. } if feed == 0.04));
    assert!(
        matches!(&now.profile, Conductor::Layers { factors, .. } if *factors == [1.0, 2.0, 3.0])
    );
    assert_eq!(now.modulation.unwrap().rate, 4.0);
    let value = WallCondition::Value(Drive::Constant(3.0));
    assert_eq!(now.walls[1][0], [value.clone(), value]);
    assert!(matches!(now.walls[1][1][1], WallCondition::Exchange { rate, .. } if rate == 0.2));
    // One of the two goes when the other comes.
    assert_eq!((scenario.time.step, scenario.time.stages), (Some(0.01), 9));
    assert_eq!(read(&scenario.text), scenario, "the text is the scenario");
    let other = linear(SHEET, &["time.method=rk4"]).unwrap();
    assert_eq!(other.time.method, Method::Rk4);
    let layers = changed(
        SLAB,
        &[(
            "diffusivity = 0.5",
            "diffusivity = 0.5\nmean = \"harmonic\"",
        )],
    );
    let mixed = linear(&layers, &["system.form=mixed"]).unwrap();
    assert_eq!(diffusion(&mixed).mean, Mean::Arithmetic);
    let plain = linear(
        SHEET,
        &["system.reaction.kind=none", "system.profile.kind=uniform"],
    );
    let plain = plain.unwrap();
    assert_eq!(diffusion(&plain).reaction, Reaction::None);
    assert_eq!(diffusion(&plain).profile, Conductor::Uniform);
    let error = linear(SHEET, &["wall.2.rate=1"]).unwrap_err();
    assert_report_holds(
        &error,
        &["there is no wall 2, the file has 2", "from 0 to 1"],
    );
}

#[test]
fn the_explicit_methods_work_too() {
    for (name, method) in [("rk4", Method::Rk4), ("ssp-rk3", Method::SspRk3)] {
        let scenario = linear(SLAB, &[&format!("time.method={name}")]).unwrap();
        assert_eq!(scenario.time.method, method);
        assert_eq!(method.name(), name);
    }
    for stages in ["3", "255"] {
        let scenario = linear(SLAB, &[&format!("time.stages={stages}")]).unwrap();
        assert_eq!(scenario.time.stages.to_string(), stages);
    }
}

#[test]
fn the_example_of_convection_diffusion_reads() {
    let example = super::super::format::PAGE
        .split("```toml\n")
        .nth(3)
        .unwrap();
    let scenario = read(example.split("```").next().unwrap());
    assert_eq!(scenario.system.names(1), ["temperature"]);
    assert_eq!(scenario.output.exact, Some(Exact::Initial));
}
