//! Flow at small Mach numbers: a background pressure that forces leave out, and what it must not change.

mod runs;

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::path::Path;

use motes::experiment::Experiment;
use motes::scenario::{AnyScenario, Scenario, Source};
use runs::{any_scenario, experiment, run};

/// `ln(K(0)/K(T))` of the kinetic energy K.
fn decay(experiment: &Experiment) -> f64 {
    let energies = experiment.outcome.series.of("kinetic_energy");
    let [first, .., last] = energies[..] else {
        panic!("no series")
    };
    (first / last).ln()
}

/// Taylor and Green's vortices lose their energy by `e^(-16 pi² nu t)`. 64 x 64, where the bound is 2 %, is a case of
/// the suite.
#[test]
fn vortices_decay_by_viscosity_alone() {
    let few = "resolution.particles=1024";
    let exact = 16.0 * PI * PI * 0.01;
    for (scalar, changes) in [("f64", &[few][..]), ("f32", &[few, "time.energy=exact"])] {
        let experiment = experiment(any_scenario("taylor-green", changes), scalar, 1);
        let (rate, outcome) = (decay(&experiment) / exact, &experiment.outcome);
        assert!((rate - 1.0).abs() < 0.02, "{scalar}: {rate} of the rate");
        let [momentum, energy] = ["momentum", "energy"].map(|name| outcome.drift_of(name).abs());
        // Of f32 its rounding; by leap-frog the square of the step.
        let [most, drift] = if scalar == "f64" {
            [1e-15, 1e-7]
        } else {
            [2e-7, 1e-6]
        };
        assert!(momentum < most, "{scalar}: momentum {momentum:e}");
        assert!(energy < drift, "{scalar}: energy {energy:e}");
        assert!(experiment.simulation.doubts(outcome).is_empty());
    }
}

/// With all of the pressure they lose it to disorder, and that is told.
#[test]
fn with_all_of_the_pressure_they_melt() {
    let changes = ["resolution.particles=1024", "force.background=0"];
    let experiment = experiment(any_scenario("taylor-green", &changes), "f64", 1);
    let rate = decay(&experiment) / (16.0 * PI * PI * 0.01);
    assert!(
        rate > 1.1,
        "{rate} of the rate: the warning has no ground any more"
    );
    let doubts = experiment.simulation.doubts(&experiment.outcome).join("\n");
    assert!(doubts.contains("force.background = 70"), "{doubts}");
}

/// The forces of the pressure that is left do the work that the energies lose, in every form of the energy.
#[test]
fn energy_is_kept_with_a_background() {
    for form in ["exact", "total"] {
        let energy = format!("time.energy={form}");
        let changes = ["resolution.particles=400", "time.end=0.1", &energy];
        let outcome = runs::outcome("taylor-green", "f64", 1, &changes);
        let drift = outcome.drift_of("energy").abs();
        assert!(drift < 1e-14, "{form}: {drift:e}");
    }
}

/// Sound has the speed of the whole pressure: what is left of its error, dispersion, falls with the square of the
/// spacing.
#[test]
fn sound_is_as_fast_with_a_background() {
    let [coarse, fine] = ["50", "100"].map(|particles| {
        let particles = format!("resolution.particles={particles}");
        run(
            "sound-wave",
            "f64",
            1,
            &[&particles, "force.background=0.59"],
        )
    });
    for (field, norms) in &fine.errors {
        let order = (coarse.errors[field].l1 / norms.l1).log2();
        assert!(order > 1.9, "{field}: order {order}");
    }
    // Of 1e-6.
    assert!(fine.l1("velocity") < 4e-9, "{:e}", fine.l1("velocity"));
}

/// A shock is no less one: the errors of Sod's tube are within its bounds with half of the lower pressure left out.
#[test]
fn shocks_are_kept_with_a_background() {
    let plain = run("sod", "f64", 1, &[]);
    let other = run("sod", "f64", 1, &["force.background=0.05"]);
    for field in ["density", "velocity", "pressure"] {
        let (found, right) = (other.l1(field), plain.l1(field));
        assert!(found < 1.1 * right, "{field}: {found:e}, {right:e} without");
    }
}

/// A square lattice of `side²` particles in a unit square as a file, and a scenario of it.
fn lattice(
    folder: &Path,
    side: usize,
    more: &str,
    state: impl Fn([f64; 2]) -> [f64; 3],
) -> Scenario {
    let mut rows = "position_x,position_y,velocity_x,velocity_y,mass,density,pressure\n".to_owned();
    for cell in 0..side * side {
        let [x, y] = [cell % side, cell / side].map(|i| (i as f64 + 0.5) / side as f64);
        let [velocity, density, pressure] = state([x, y]);
        let mass = density / (side * side) as f64;
        writeln!(rows, "{x},{y},0,{velocity},{mass},{density},{pressure}").unwrap();
    }
    std::fs::write(folder.join("cloud.csv"), rows).unwrap();
    let text = format!(
        "name = \"cloud\"\ndimension = 2\n[domain]\nlower = [0.0, 0.0]\nupper = [1.0, 1.0]\n\
         sides = [\"periodic\", \"periodic\"]\n[resolution]\narrangement = \"file\"\nfile = \"cloud.csv\"\n\
         [viscosity]\nkind = \"none\"\n{more}"
    );
    let file = folder.join("cloud.toml");
    std::fs::write(&file, text).unwrap();
    Scenario::read(Source::from(file.to_str().unwrap()), &[]).unwrap()
}

fn gas(scenario: Scenario) -> Experiment {
    experiment(AnyScenario::Gas(Box::new(scenario)), "f64", 1)
}

/// A shear wave decays by `nu k²` with and without a background, of every equation of state.
#[test]
fn a_shear_wave_is_damped_alike() {
    let folder = tempfile::tempdir().unwrap();
    let exact = 2.0 * 0.1 * 4.0 * PI * PI * 0.1;
    for (material, background) in [
        ("equation-of-state = \"ideal-gas\"\ngamma = 1.4", 0.0),
        ("equation-of-state = \"ideal-gas\"\ngamma = 1.4", 0.95),
        (
            "equation-of-state = \"isothermal\"\nsound-speed = 1.0",
            0.95,
        ),
        (
            "equation-of-state = \"tait\"\ndensity = 0.9\nsound-speed = 1.0\nexponent = 7",
            0.1,
        ),
    ] {
        let more = format!(
            "[material]\n{material}\n[diffusion]\nviscosity = 0.1\n[force]\nbackground = {background}\n\
             [time]\nend = 0.1\n"
        );
        let pressure = if material.contains("tait") {
            0.140_025
        } else {
            1.0
        };
        let wave = |[x, _]: [f64; 2]| [1e-4 * (2.0 * PI * x).sin(), 1.0, pressure];
        let rate = decay(&gas(lattice(folder.path(), 32, &more, wave))) / exact;
        assert!(
            (rate - 1.0).abs() < 0.01,
            "{material}, {background}: {rate}"
        );
    }
}

/// Pressures and energies are those of the gas, not of what forces leave; heat is conducted along the energy.
#[test]
fn what_is_shown_has_the_background() {
    let folder = tempfile::tempdir().unwrap();
    let run = |background: f64| {
        let more = format!(
            "[material]\nequation-of-state = \"ideal-gas\"\ngamma = 1.4\n[diffusion]\nheat = 0.1\n\
             [force]\nbackground = {background}\n[time]\nend = 0.1\n"
        );
        let warm = |[x, _]: [f64; 2]| [0.0, 1.0 + 0.01 * (2.0 * PI * x).sin(), 1.0];
        let experiment = gas(lattice(folder.path(), 24, &more, warm));
        ["pressure", "energy"].map(|name| experiment.simulation.spread(name).unwrap())
    };
    let [[p, e], [pressure, energy]] = [0.0, 0.9].map(run);
    assert!(
        (pressure.mean - p.mean).abs() < 1e-5,
        "{}, {}",
        pressure.mean,
        p.mean
    );
    let [right, found] = [e.max - e.min, energy.max - energy.min];
    // Of 0.05 at the start.
    assert!(
        right < 0.04 && (found / right - 1.0).abs() < 0.02,
        "{found}, {right}"
    );
}

#[test]
fn an_open_domain_is_refused() {
    let changes = ["force.background=0.05", "domain.sides=[\"free\"]"].map(String::from);
    let error = Scenario::read(Source::from("sod"), &changes).unwrap_err();
    let text = format!("{:?}", miette::Report::new(error));
    for part in ["force.background", "open along x", "take `background` out"] {
        assert!(text.contains(part), "{part}: {text}");
    }
}
