//! Input that contradicts itself or the run, and warnings that must not be there.

mod command;

use std::path::Path;

use command::{failure, stdout};
use serde_json::Value;

/// The JSON of a run of a scenario of this text.
fn run(folder: &Path, text: &str, more: &[&str]) -> Value {
    std::fs::write(folder.join("mine.toml"), text).unwrap();
    let arguments = [&["run", "mine.toml", "--json"], more].concat();
    serde_json::from_str(&stdout(folder, &arguments)).unwrap()
}

fn warnings(json: &Value) -> Vec<String> {
    let warnings = json["warnings"].as_array().unwrap().iter();
    warnings
        .map(|warning| warning.as_str().unwrap().to_owned())
        .collect()
}

/// A slab of tracer from a file, in a periodic box or between walls.
fn tracer(side: &str, kind: &str) -> String {
    format!(
        "name = \"cloud\"\ndimension = 1\n[domain]\nlower = [0.0]\nupper = [1.0]\nsides = [\"{side}\"]\n\
         [system]\n{kind}\n[resolution]\narrangement = \"file\"\nfile = \"cloud.csv\"\n\
         [time]\nend = 0.01\n"
    )
}

const DIFFUSION: &str = "kind = \"convection-diffusion\"\ndiffusivity = 0.1";
const TRANSPORT: &str = "kind = \"transport\"\nvelocity = { kind = \"uniform\", velocity = [1.0] }";

fn cloud(folder: &Path, count: u32, weight: impl Fn(u32) -> f64, more: &str) {
    let step = 1.0 / f64::from(count);
    let row = |k: u32| format!("{},{},1\n", step * (f64::from(k) + 0.25), weight(k));
    let rows: String = (0..count).map(row).collect();
    std::fs::write(
        folder.join("cloud.csv"),
        format!("position,weight,u\n{rows}{more}"),
    )
    .unwrap();
}

#[test]
fn twins_of_a_system_are_named_in_every_family() {
    let folder = tempfile::tempdir().unwrap();
    for (side, kind, twin, parts) in [
        (
            "periodic",
            TRANSPORT,
            "0.005",
            "line 52: the particle at 0.005 lies where that of line 2 lies",
        ),
        (
            "periodic",
            DIFFUSION,
            "0.225",
            "line 52: the particle at 0.225 lies where that of line 13 lies",
        ),
        // By a rounding.
        (
            "mirror",
            DIFFUSION,
            "0.5050000000001",
            "where that of line 27 lies, at 0.505",
        ),
    ] {
        cloud(folder.path(), 50, |_| 0.02, &format!("{twin},0.02,1\n"));
        std::fs::write(folder.path().join("mine.toml"), tracer(side, kind)).unwrap();
        let report = failure(folder.path(), &["run", "mine.toml"], 2);
        let line = report.replace("\n  │ ", " ");
        assert!(line.contains(parts), "no {parts:?} in\n{report}");
        assert!(line.contains("keep one particle a place"), "{report}");
    }
}

/// The sum is right, so that only neighbours tell.
#[test]
fn weights_that_are_not_the_room_of_a_particle_are_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let warned = |weight: &dyn Fn(u32) -> f64| {
        cloud(folder.path(), 100, weight, "");
        let json = run(folder.path(), &tracer("periodic", DIFFUSION), &[]);
        let warnings = warnings(&json);
        warnings
            .iter()
            .filter(|warning| warning.contains("neighbours leave"))
            .count()
    };
    assert_eq!(warned(&|_| 0.01), 0);
    assert_eq!(
        warned(&|k| 0.01 + 0.005 * (0.0628 * f64::from(k)).sin() * 0.5),
        0
    );
    assert_eq!(warned(&|k| if k == 20 { 1e-5 } else { 0.01 }), 1);
    assert_eq!(warned(&|_| 0.1), 1);
}

/// Hours of data that are given in seconds.
#[test]
fn a_series_in_another_unit_is_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let text = tracer("mirror", DIFFUSION)
        + "[[wall]]\naxis = \"x\"\nend = \"lower\"\nkind = \"value\"\n\
           series = { file = \"day.csv\", column = \"u\" }\n";
    let warned = |unit: f64| {
        cloud(folder.path(), 50, |_| 0.02, "");
        let row = |k: u32| format!("{},1\n", unit * f64::from(k));
        let rows: String = (0..49).map(row).collect();
        std::fs::write(folder.path().join("day.csv"), format!("time,u\n{rows}")).unwrap();
        warnings(&run(folder.path(), &text, &[])).concat()
    };
    assert!(!warned(0.001).contains("unit of time"));
    let said = warned(3.6);
    assert!(
        said.contains("meets 1 of the 49 rows of `day.csv`"),
        "{said}"
    );
    assert!(said.contains("are they in another unit of time?"), "{said}");
}

/// A column of liquid or gas at rest, and one that moves: what their energy is compared with is not 0.
#[test]
fn a_gas_whose_energy_plays_no_part_gives_no_alarm() {
    let folder = tempfile::tempdir().unwrap();
    for material in [
        "equation-of-state = \"isothermal\"\nsound-speed = 1.5",
        "equation-of-state = \"tait\"\ndensity = 1.0\nsound-speed = 5.0\nexponent = 7",
    ] {
        for velocity in ["0.0", "0.2"] {
            for more in ["", "[force]\nacceleration = [-0.1]\n"] {
                let text = format!(
                    "name = \"calm\"\ndimension = 1\n[domain]\nlower = [0.0]\nupper = [1.0]\n\
                     sides = [\"mirror\"]\n[[region]]\nlower = [0.0]\nupper = [1.0]\ndensity = 1.02\n\
                     velocity = [{velocity}]\n[material]\n{material}\n[resolution]\nparticles = 100\n\
                     arrangement = \"equal-mass\"\n{more}[time]\nend = 0.5\n"
                );
                for scalar in ["f64", "f32"] {
                    let json = run(folder.path(), &text, &["--scalar", scalar]);
                    assert_eq!(
                        warnings(&json),
                        [""; 0],
                        "{material} {velocity} {more} {scalar}"
                    );
                    let drift = json["drift"]["energy"].as_f64().unwrap();
                    assert!(drift.abs() < 1e-3, "{material} {velocity}: {drift}");
                }
            }
        }
    }
}

/// A step that is too large in floats is no overflow.
#[test]
fn a_float_run_is_not_told_of_fixed_point() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [
        "run",
        "sod",
        "-n",
        "200",
        "--json",
        "--set",
        "time.courant=1",
        "--set",
        "viscosity.beta=20",
    ];
    let json: Value = serde_json::from_str(&stdout(folder.path(), &arguments)).unwrap();
    for warning in warnings(&json) {
        assert!(
            !warning.contains("overflow") && !warning.contains("fixed point"),
            "{warning}"
        );
    }
}

/// Two streams that meet, and a membrane: the error against the exact solution falls with the
/// spacing, in the fan, at the shocks and of the energy that is kept account of.
#[test]
fn isothermal_and_tait_tubes_converge_to_their_riemann_problem() {
    for material in [
        "equation-of-state = \"isothermal\"\nsound-speed = 1.0",
        "equation-of-state = \"tait\"\ndensity = 1.0\nsound-speed = 2.0\nexponent = 3",
    ] {
        for [left, right] in [["1.6", "1.1"], ["3.0", "1.1"]] {
            let text = |particles: u32| {
                format!(
                    "name = \"tube\"\ndimension = 1\n[domain]\nlower = [-1.0]\nupper = [1.0]\n\
                     sides = [\"mirror\"]\n[[region]]\nlower = [-1.0]\nupper = [0.0]\ndensity = {left}\n\
                     velocity = [0.0]\n[[region]]\nlower = [0.0]\nupper = [1.0]\ndensity = {right}\n\
                     velocity = [0.0]\n[material]\n{material}\n[resolution]\nparticles = {particles}\n\
                     arrangement = \"equal-mass\"\n[time]\nend = 0.15\n[output]\nexact = \"riemann\"\n\
                     window = {{ lower = [-0.6], upper = [0.6] }}\n"
                )
            };
            let folder = tempfile::tempdir().unwrap();
            let errors = [200, 400].map(|particles| {
                let json = run(folder.path(), &text(particles), &[]);
                ["density", "velocity", "pressure", "energy"]
                    .map(|field| json["errors"][field]["l1"].as_f64().unwrap())
            });
            for (coarse, fine) in errors[0].iter().zip(&errors[1]) {
                let ratio = coarse / fine;
                assert!((1.5..2.6).contains(&ratio), "{material} {left}: {errors:?}");
            }
            assert!(errors[1][0] < 0.02, "{material} {left}: {errors:?}");
        }
    }
}
