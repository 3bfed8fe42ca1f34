//! Linear systems: what their sections read as, and the defaults.

use super::super::linear::{Arrangement, Exact, Field, Initial, Measured, Method, System};
use super::*;
use crate::fineness;

mod diffusion;
mod faults;

fn linear(text: &str, overrides: &[&str]) -> Result<LinearScenario, ScenarioError> {
    let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
    LinearScenario::read(Source::File(File::new(text).path()), &overrides)
}

fn built_in_linear(name: &str, overrides: &[&str]) -> Result<LinearScenario, ScenarioError> {
    linear(built_in(name).unwrap().text, overrides)
}

#[track_caller]
fn read(text: &str) -> LinearScenario {
    linear(text, &[]).unwrap_or_else(|error| panic!("{}", report(&error)))
}

/// The least that describes acoustics in one dimension.
const LINE: &str = r#"
name = "line"
dimension = 1
[domain]
lower = [0.0]
upper = [2.0]
sides = ["periodic"]
[system]
kind = "acoustics"
[initial]
kind = "exp-sine"
[resolution]
particles = 100
[time]
end = 0.5
"#;

/// The same for transport in two dimensions.
const PLANE: &str = r#"
name = "plane"
dimension = 2
[domain]
lower = [0.0, -1.0]
upper = [1.0, 1.0]
sides = ["free", "free"]
[system]
kind = "transport"
velocity = { kind = "rotation", rate = 2.0 }
[initial]
kind = "gaussian"
width = 0.1
[resolution]
particles = 100
[time]
end = 0.5
"#;

/// The same for matrices in one dimension.
fn matrices(lines: &str) -> String {
    let kind = format!("kind = \"matrices\"\ncomponents = 2\n{lines}");
    let modes = "kind = \"modes\"\nwave = [1]\nstate = [1.0, 0.5]";
    LINE.replace("kind = \"acoustics\"", &kind)
        .replace("kind = \"exp-sine\"", modes)
}

const FLUX: &str = "flux = [[[0.0, 1.0], [1.0, 0.0]]]";

#[test]
fn what_is_left_out_takes_its_default() {
    let scenario = read(LINE);
    assert_eq!(
        scenario.system,
        System::Acoustics {
            density: 1.0,
            sound_speed: 1.0
        }
    );
    assert_eq!(scenario.motion, Field::Still);
    assert_eq!(scenario.initial, Some(Initial::ExpSine));
    assert_eq!(scenario.resolution.arrangement, Arrangement::Lattice);
    assert_eq!(
        scenario.cut_off.shape,
        motes_core::cutoff::Named::QuinticSpline
    );
    assert_eq!(
        scenario.cut_off.width,
        Width::Adaptive {
            eta: 0.7,
            theta: 0.75
        }
    );
    let time = &scenario.time;
    assert_eq!((time.method, time.courant), (Method::Rk4, 0.5));
    assert_eq!((time.step, time.growth_margin), (None, 0.1));
    let output = &scenario.output;
    assert_eq!(output.window, scenario.domain.extent);
    assert_eq!((output.samples, &output.exact), (100, &None));
    assert_eq!((output.snapshots, &output.probe), (None, &None));
    assert!(scenario.tolerances.is_empty());
}

/// A transported quantity takes its particles along; a pulse and a turn are in the middle.
#[test]
fn particles_go_with_what_is_transported() {
    let scenario = read(PLANE);
    let turn = Field::Rotation {
        rate: 2.0,
        center: vec![0.5, 0.0],
    };
    assert_eq!(scenario.motion, turn);
    assert_eq!(
        scenario.system,
        System::Transport {
            velocity: turn,
            decay: 0.0,
            source: 0.0
        }
    );
    assert_eq!(
        scenario.initial,
        Some(Initial::Gaussian {
            center: vec![0.5, 0.0],
            width: 0.1,
            amplitude: 1.0
        })
    );
    let still = linear(PLANE, &["motion.kind=still"]).unwrap();
    assert_eq!(still.motion, Field::Still);
    let flow = linear(PLANE, &["motion.kind=flow"]).unwrap();
    assert_eq!(flow.motion, scenario.motion);
}

#[test]
fn the_components_of_each_system_have_names() {
    let names = |name: &str| {
        let scenario = built_in_linear(name, &[]).unwrap();
        let dimension = scenario.dimension;
        let names = scenario.system.names(dimension);
        assert_eq!(scenario.system.components(dimension), names.len());
        names.join(" ")
    };
    assert_eq!(names("acoustics1d"), "pressure velocity_x");
    assert_eq!(names("acoustics2d"), "pressure velocity_x velocity_y");
    assert_eq!(names("telegraph"), "voltage current");
    assert_eq!(names("shallow-water"), "elevation velocity_x velocity_y");
    assert_eq!(names("maxwell-te"), "electric_x electric_y magnetic_z");
    assert_eq!(
        names("elastic-waves"),
        "velocity_x velocity_y stress_xx stress_yy stress_xy"
    );
    assert_eq!(
        names("linearised-gas"),
        "density velocity_x velocity_y pressure"
    );
    assert_eq!(names("transport-shear"), "u");
    assert_eq!(
        read(&matrices(FLUX)).system.names(1),
        ["u0".to_owned(), "u1".to_owned()]
    );
}

#[test]
fn every_section_reads_as_written() {
    let lines = "flux = [[[0.0, 4.0], [1.0, 0.0]]]\ndecay = [[0.5, 0.0], [0, 0.25]]\n\
                 names = [\"left\", \"right\"]";
    let text = matrices(lines)
        .replace(
            "end = 0.5",
            "end = 0.5\nmethod = \"ssp-rk3\"\ncourant = 0.25\nstep = 0.001\ngrowth-margin = 0.2",
        )
        .replace(
            "particles = 100",
            "particles = 100\narrangement = \"distorted\"\namplitude = 0.15",
        )
        .replace(
            "[system]",
            "[motion]\nkind = \"wave\"\namplitude = 0.2\n[system]",
        );
    let text = format!(
        "{text}[cut-off]\nname = \"wendland-c6\"\neta = 1.5\n\
         [output]\nexact = \"initial\"\nsnapshots = {{ steps = 3 }}\n\
         probe = {{ points = [5], lower = [0.5], upper = [1.5] }}\n\
         [tolerance.right]\nl2 = 0.1\nreason = \"why\"\n\
         [tolerance.state]\nlinf = 0.2\nrms = 0.3\nreason = \"why\"\n"
    );
    let scenario = read(&text);
    let System::Matrices { flux, decay, .. } = &scenario.system else {
        panic!("{:?}", scenario.system);
    };
    assert_eq!(flux, &[[0.0, 4.0, 1.0, 0.0]]);
    assert_eq!(decay, &[0.5, 0.0, 0.0, 0.25]);
    assert_eq!(scenario.motion, Field::Wave { amplitude: 0.2 });
    let modes = Initial::Modes {
        wave: vec![1],
        state: vec![1.0, 0.5],
    };
    assert_eq!(scenario.initial, Some(modes));
    assert_eq!(
        scenario.resolution.arrangement,
        Arrangement::Distorted { amplitude: 0.15 }
    );
    let width = Width::Adaptive {
        eta: 1.5,
        theta: 0.75,
    };
    assert_eq!(scenario.cut_off.width, width);
    let time = &scenario.time;
    assert_eq!((time.method, time.courant), (Method::SspRk3, 0.25));
    assert_eq!((time.step, time.growth_margin), (Some(0.001), 0.2));
    assert_eq!(scenario.output.exact, Some(Exact::Initial));
    let probe = scenario.output.probe.unwrap();
    let places: Vec<f64> = (0..5).map(|i| probe.coordinate(0, i)).collect();
    assert_eq!(places, [0.5, 0.75, 1.0, 1.25, 1.5]);
    let tolerances = scenario.tolerances.iter();
    let tolerances: Vec<_> = tolerances.map(|t| (t.field, t.norm, t.value)).collect();
    assert_eq!(
        tolerances,
        [
            (Measured::State, Norm::Linf, 0.2),
            (Measured::State, Norm::Rms, 0.3),
            (Measured::Component(1), Norm::L2, 0.1)
        ]
    );
}

/// `epsilon = eta L (h/L)^theta`, in numbers by hand: of 16 particles on a line of length 1,
/// 0.7 * 0.0625^0.75 = 0.7 / 8; of the same line in another unit, as many of that unit.
#[test]
fn the_width_is_a_power_of_the_spacing_over_the_length_of_the_domain() {
    let width = read(LINE).cut_off.width;
    for (particles, dimension) in [(16, 1), (256, 2), (4096, 3)] {
        let fineness = fineness(particles, dimension);
        assert!((fineness - 0.0625).abs() < 1e-16);
        for unit in [1e-9, 1.0, 1000.0] {
            let epsilon = width.epsilon(0.0625 * unit, fineness);
            assert!((epsilon / unit - 0.7 / 8.0).abs() < 1e-15);
        }
        let given = Width::Constant { epsilon: 0.3 };
        assert_eq!(given.epsilon(0.0625, fineness), 0.3);
    }
}

#[test]
fn a_probe_of_one_point_is_in_the_middle() {
    let text = format!("{PLANE}[output]\nprobe = {{ points = [2, 1] }}\n");
    let probe = read(&text).output.probe.unwrap();
    let x = [0, 1].map(|i| probe.coordinate(0, i));
    assert_eq!((x, probe.coordinate(1, 0)), ([0.0, 1.0], 0.0));
}

#[test]
fn a_file_of_particles_needs_no_initial_state() {
    let text = LINE
        .replace("[initial]\nkind = \"exp-sine\"\n", "")
        .replace(
            "particles = 100",
            "arrangement = \"file\"\nfile = \"cloud.csv\"",
        );
    let scenario = read(&text);
    assert_eq!((scenario.initial, scenario.resolution.particles), (None, 0));
    let Arrangement::File(file) = scenario.resolution.arrangement else {
        panic!("{:?}", scenario.resolution);
    };
    assert!(file.ends_with("cloud.csv") && file.is_absolute());
    let compared = format!("{text}[output]\nexact = \"initial\"\n");
    let error = linear(&compared, &[]).unwrap_err();
    assert_report_holds(&error, &["output.exact", "there is no [initial]"]);
}

#[test]
fn set_replaces_the_keys_of_a_section() {
    let refused = built_in_linear(
        "acoustics1d",
        &["motion.kind=uniform", "motion.velocity=[0.5]"],
    )
    .unwrap_err();
    let whole = r#"--set 'motion={ kind = "uniform", ... }' replaces the keys of [motion]"#;
    assert_report_holds(&refused, &["uniform has no amplitude", whole]);
    let replaced = built_in_linear(
        "acoustics1d",
        &[r#"motion={ kind = "uniform", velocity = [0.5] }"#],
    )
    .unwrap();
    let velocity = vec![0.5];
    assert_eq!(replaced.motion, Field::Uniform { velocity });
    assert_eq!(
        replaced.name, "acoustics1d",
        "what stands above the sections stays"
    );
}

#[test]
fn set_reaches_every_section_of_a_linear_system() {
    let word = built_in_linear("acoustics1d", &["initial=exp-sine"]).unwrap_err();
    assert_report_holds(&word, &["names a section", "--set initial.kind=..."]);
    let scenario = built_in_linear(
        "acoustics1d",
        &[
            "system.sound-speed=2",
            "motion.kind=still",
            "initial.kind=plane-wave",
            "initial.wave=[-3]",
            "cut-off.epsilon=0.01",
            "time.step=1e-3",
            "output.probe.points=[7]",
            "tolerance.velocity_x.l1=0.5",
            "tolerance.velocity_x.reason=guessed",
        ],
    )
    .unwrap();
    assert_eq!(
        scenario.system,
        System::Acoustics {
            density: 1.0,
            sound_speed: 2.0
        }
    );
    assert_eq!(scenario.motion, Field::Still);
    let wave = Initial::PlaneWave {
        wave: vec![-3],
        amplitude: 1.0,
    };
    assert_eq!(scenario.initial, Some(wave));
    assert_eq!(scenario.cut_off.width, Width::Constant { epsilon: 0.01 });
    assert_eq!(scenario.output.probe.as_ref().unwrap().points, [7]);
    let set = scenario.tolerances.last().unwrap();
    assert_eq!(set.field, Measured::Component(1));
    assert_eq!(read(&scenario.text), scenario, "the text is the scenario");

    let turned = linear(PLANE, &["system.velocity.rate=3"]).unwrap();
    assert!(matches!(turned.motion, Field::Rotation { rate, .. } if rate == 3.0));
    let other = ["system.velocity={ kind = 'uniform', velocity = [1, 0] }"];
    let uniform = linear(PLANE, &other).unwrap();
    let velocity = vec![1.0, 0.0];
    assert_eq!(uniform.motion, Field::Uniform { velocity });
    let stream = ["system.velocity=[1.0, 0.0]", "time.end=2"];
    let gas = built_in_linear("linearised-gas", &stream).unwrap();
    assert!(matches!(gas.system, System::LinearisedGas { velocity, .. } if velocity == [1.0, 0.0]));
}

#[test]
fn the_linear_example_of_the_page_reads() {
    let example = super::format::PAGE.split("```toml\n").nth(2).unwrap();
    let scenario = read(example.split("```").next().unwrap());
    assert_eq!(scenario.system.names(1), ["left", "right"]);
}
