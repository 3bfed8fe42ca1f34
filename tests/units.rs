//! Units of length, time and value change nothing: the same relative errors in floats, the same
//! bits where rounding leaves them to be.

#[path = "runs/mod.rs"]
mod runs;

use motes::scenario::AnyScenario;
use runs::{any_scenario, try_experiment};

/// What one unit of before is of length, time and value.
type Scales = [f64; 3];

/// A scenario in other units: `--set`, and the sizes of the fields that are compared.
type Scaled = (Vec<String>, Vec<(&'static str, f64)>);

/// Sound on a moving cloud; pressure keeps its unit.
fn acoustics([length, time, _]: Scales) -> Scaled {
    let speed = length / time;
    let changes = vec![
        format!("domain.upper=[{length:e}]"),
        format!("system.sound-speed={speed:e}"),
        format!("system.density={:e}", 1.0 / (speed * speed)),
        format!("motion.amplitude={:e}", 0.2 * speed),
        format!("time.end={:e}", 0.25 * time),
        "resolution.particles=128".to_owned(),
    ];
    (changes, vec![("pressure", 1.0), ("velocity_x", speed)])
}

/// A lossy line: losses, which have a time of their own.
fn telegraph([length, time, value]: Scales) -> Scaled {
    let changes = vec![
        format!("domain.upper=[{length:e}]"),
        format!("system.inductance={:e}", time / length),
        format!("system.capacitance={:e}", time / length),
        format!("system.resistance={:e}", 1.0 / length),
        format!("system.conductance={:e}", 0.25 / length),
        format!("motion.amplitude={:e}", 0.1 * length / time),
        format!("initial.amplitude={value:e}"),
        format!("time.end={time:e}"),
        "resolution.particles=128".to_owned(),
    ];
    (changes, vec![("state", value)])
}

/// A slab between a closed wall and one that exchanges.
fn robin([length, time, value]: Scales) -> Scaled {
    let changes = vec![
        format!("domain.upper=[{length:e}]"),
        format!("system.diffusivity={:e}", 0.1 * length * length / time),
        format!("wall.1.rate={:e}", 0.2 * length / time),
        format!("initial.state=[{value:e}]"),
        format!("time.end={:e}", 3.0 * time),
        "resolution.particles=60".to_owned(),
    ];
    (changes, vec![("state", value), ("reconstruction", value)])
}

/// Layers between walls that are held.
fn layers([length, time, value]: Scales) -> Scaled {
    let changes = vec![
        format!("domain.lower=[{:e}]", -length),
        format!("domain.upper=[{length:e}]"),
        format!("system.diffusivity={:e}", 0.1 * length * length / time),
        format!("wall.0.value={value:e}"),
        format!("time.end={:e}", time),
        "resolution.particles=60".to_owned(),
    ];
    (changes, vec![("state", value)])
}

/// Heat in the plane on an uneven cloud.
fn plane([length, time, value]: Scales) -> Scaled {
    let AnyScenario::Linear(heat) = any_scenario("heat2d", &[]) else {
        panic!("heat2d is a gas");
    };
    let end = heat.time.end;
    let motes::scenario::linear::System::ConvectionDiffusion(of) = &heat.system else {
        panic!("heat2d does not diffuse");
    };
    let Some(motes::scenario::linear::Initial::Gaussian { width, .. }) = heat.initial else {
        panic!("heat2d does not begin with a Gaussian");
    };
    let changes = vec![
        format!("domain.lower=[{0:e}, {0:e}]", -length),
        format!("domain.upper=[{length:e}, {length:e}]"),
        format!(
            "system.diffusivity={:e}",
            of.diffusivity[0] * length * length / time
        ),
        format!("initial.width={:e}", width * length),
        format!("initial.amplitude={value:e}"),
        format!("time.end={:e}", end * time),
        "resolution.particles=400".to_owned(),
    ];
    (changes, vec![("state", value)])
}

/// A tube of gas; `value` is of pressure.
fn tube([length, time, value]: Scales) -> Scaled {
    let speed = length / time;
    let density = value / (speed * speed);
    let changes = vec![
        format!("domain.lower=[{:e}]", -length),
        format!("domain.upper=[{length:e}]"),
        format!("region.0.lower=[{:e}]", -length),
        format!("region.1.upper=[{length:e}]"),
        format!("region.0.density={density:e}"),
        format!("region.1.density={:e}", 0.125 * density),
        format!("region.0.pressure={value:e}"),
        format!("region.1.pressure={:e}", 0.1 * value),
        format!(
            "output.window={{ lower = [{:e}], upper = [{:e}] }}",
            -0.5 * length,
            0.5 * length
        ),
        format!("time.end={:e}", 0.2 * time),
        "resolution.particles=225".to_owned(),
    ];
    let fields = vec![
        ("density", density),
        ("velocity", speed),
        ("pressure", value),
    ];
    (changes, fields)
}

type Case = (&'static str, fn(Scales) -> Scaled, &'static [&'static str]);

const CASES: [Case; 10] = [
    ("acoustics1d", acoustics, &[]),
    ("telegraph", telegraph, &[]),
    ("robin-wall", robin, &[]),
    ("robin-wall", robin, &["system.form=mixed"]),
    ("layered-wall", layers, &[]),
    (
        "layered-wall",
        layers,
        &["system.form=mixed", "system.mean=arithmetic"],
    ),
    ("heat2d", plane, &[]),
    ("heat2d", plane, &["system.form=mixed"]),
    ("sod", tube, &[]),
    ("sod", tube, &["cut-off.theta=0.9"]),
];

/// Errors over the size of their fields, warnings, and the digest.
fn run(case: &Case, scales: Scales, scalar: &str) -> (Vec<f64>, Vec<String>, String) {
    let (name, scaled, more) = case;
    let (changes, fields) = scaled(scales);
    let changes: Vec<&str> = changes
        .iter()
        .map(String::as_str)
        .chain(more.iter().copied())
        .collect();
    let experiment = try_experiment(any_scenario(name, &changes), scalar, 1);
    let experiment = experiment.unwrap_or_else(|error| panic!("{name} {scales:?}: {error}"));
    let errors = experiment.errors.unwrap();
    let errors = fields.iter().map(|(field, size)| errors[*field].l2 / size);
    (
        errors.collect(),
        experiment.doubts,
        format!("{:?}", experiment.outcome.digest),
    )
}

const HERE: Scales = [1.0; 3];

/// Nine decades either way, all at once and each by itself.
const UNITS: [Scales; 7] = [
    [1e-9, 1e9, 1e-9],
    [1e9, 1e-9, 1e9],
    [1e3, 1.0, 1.0],
    [1e-9, 1.0, 1.0],
    [1.0, 1e9, 1.0],
    [1.0, 1.0, 1e-9],
    [1e9, 1e9, 1e9],
];

#[test]
fn relative_errors_do_not_depend_on_units() {
    for case in &CASES {
        let (here, doubts, _) = run(case, HERE, "f64");
        for scales in UNITS {
            let (there, told, _) = run(case, scales, "f64");
            for (one, other) in here.iter().zip(&there) {
                assert!(
                    (other / one - 1.0).abs() < 1e-6,
                    "{} {:?} in {scales:?}: {there:?}, {here:?} before",
                    case.0,
                    case.2
                );
            }
            assert_eq!(told, doubts, "{} in {scales:?}", case.0);
        }
    }
}

/// Powers of two of length and time cost no bit in one dimension, in any scalar.
#[test]
fn powers_of_two_change_no_digest() {
    for case in CASES
        .iter()
        .filter(|case| ["robin-wall", "layered-wall", "sod"].contains(&case.0))
    {
        for scalar in ["f64", "f32"] {
            let (_, _, here) = run(case, HERE, scalar);
            for scales in [[1024.0, 1.0, 1.0], [1.0 / 1048576.0, 32.0, 1.0]] {
                let (_, _, there) = run(case, scales, scalar);
                assert_eq!(there, here, "{} in {scales:?}, {scalar}", case.0);
            }
        }
    }
}

/// In fixed point powers of ten do not either: what they leave in the last bits of an `f64` is
/// rounded away.
#[cfg(feature = "fixed-point")]
#[test]
fn powers_of_ten_change_no_digest_in_fixed_point() {
    for case in CASES
        .iter()
        .filter(|case| ["robin-wall", "layered-wall"].contains(&case.0))
    {
        if case.2.contains(&"system.form=mixed") {
            continue;
        }
        for scalar in ["q31.32", "q12.19"] {
            let (_, _, here) = run(case, HERE, scalar);
            for scales in [
                [1e3, 1.0, 1.0],
                [1e-9, 1.0, 1.0],
                [1e9, 1e-9, 1.0],
                [1e3, 3600.0, 1.0],
            ] {
                let (_, _, there) = run(case, scales, scalar);
                assert_eq!(there, here, "{} in {scales:?}, {scalar}", case.0);
            }
        }
    }
}

/// A width that is given too small or too large for its cloud is told, at rest and where the cloud
/// is drawn apart.
#[test]
fn a_width_that_does_not_fit_is_told() {
    let told = |name: &str, changes: &[&str]| {
        let experiment = try_experiment(any_scenario(name, changes), "f64", 1).unwrap();
        experiment.doubts.join(" ")
    };
    for (name, changes, part) in [
        ("wall-day", ["cut-off.epsilon=0.0016"], "no integrals"),
        ("telegraph", ["cut-off.epsilon=0.0025"], "no integrals"),
        ("telegraph", ["cut-off.eta=0.25"], "no integrals"),
        ("robin-wall", ["cut-off.epsilon=0.2"], "smears"),
    ] {
        let doubts = told(name, &changes);
        assert!(doubts.contains(part), "{name} {changes:?}: {doubts}");
        assert_eq!(told(name, &[]), "", "{name}");
    }
}
