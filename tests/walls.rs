//! Walls that a viscous gas sticks to, as scenarios have them: forces, work and their names.

mod runs;

use motes::report::pictures::pictures;
use motes::report::summary::Summary;
use runs::{any_scenario, experiment};

#[test]
fn a_run_tells_the_force_on_every_wall_and_the_work_of_those_that_move() {
    let experiment = experiment(any_scenario("couette", &["time.end=0.2"]), "f64", 1);
    let series = &experiment.outcome.series;
    let last = |name: &str| *series.of(name).last().unwrap_or(&f64::NAN);
    // Friction on the lid: rho nu u/sqrt(pi nu t) per length, of 0.375, while the other wall is far.
    let exact = 0.375 * 0.1 / (std::f64::consts::PI * 0.1 * 0.2).sqrt();
    let lid = -last("force_y_upper_x");
    assert!((lid / exact - 1.0).abs() < 0.03, "{lid} for {exact}");
    assert!(last("force_y_lower_x").abs() < 0.02 * exact);
    let (energies, work) = (series.of("energy"), series.of("work"));
    assert_eq!(work[0], 0.0);
    let change = energies[energies.len() - 1] - energies[0];
    let done = work[work.len() - 1];
    // Twice the integral of the friction, which falls with the root of the time.
    assert!((done / (2.0 * exact * 0.2) - 1.0).abs() < 0.03, "{done}");
    assert!((change - done).abs() < 2e-3 * done, "{change} for {done}");
    let summary = Summary::new(&experiment, "f64", 1);
    let json = serde_json::to_value(&summary).unwrap();
    assert_eq!(json["wall_forces"]["y_upper"][0], -lid);
    assert_eq!(json["wall_forces"]["y_lower"].as_array().unwrap().len(), 2);
    assert!(json["drift"]["energy"].as_f64().unwrap().abs() < 1e-5);
}

#[test]
fn an_acceleration_along_a_period_works_and_does_not_leap() {
    let experiment = experiment(any_scenario("poiseuille", &["time.end=0.5"]), "f64", 1);
    let series = &experiment.outcome.series;
    let (energies, work) = (series.of("energy"), series.of("work"));
    for (energy, work) in energies.iter().zip(&work) {
        let change = energy - energies[0];
        assert!(
            (change - work).abs() < 2e-3 * work.abs() + 1e-9,
            "{change} for {work}"
        );
    }
    assert!(work[work.len() - 1] > 0.01);
}

#[test]
fn a_tube_tells_the_pressure_on_its_ends() {
    let experiment = experiment(any_scenario("sod", &["time.end=0.05"]), "f64", 1);
    let series = &experiment.outcome.series;
    let last = |name: &str| *series.of(name).last().unwrap_or(&f64::NAN);
    // Pressure 1 and 0.1 on ends that nothing has reached.
    assert!((last("force_x_lower") + 1.0).abs() < 1e-3);
    assert!((last("force_x_upper") - 0.1).abs() < 1e-4);
    assert!(series.of("work").is_empty());
}

/// What materials leave out of their pressure acts on walls all the same.
#[test]
fn a_background_pressure_is_part_of_the_force_on_a_wall() {
    let force = |name: &str, heading: &str, changes: &[&str]| {
        let mut all = vec!["time.end=0.02", "force.background=0.08"];
        all.extend(changes);
        let experiment = experiment(any_scenario(name, &all), "f64", 1);
        let series = &experiment.outcome.series;
        *series.of(heading).last().unwrap_or(&f64::NAN)
    };
    let tube = force("sod", "force_x_upper", &[]);
    assert!((tube / 0.1 - 1.0).abs() < 1e-3, "{tube}");
    // A quarter across.
    let walls = "domain.sides=[\"mirror\", \"periodic\"]";
    let few = ["resolution.particles=4000", walls];
    let plane = force("sod2d", "force_x_lower_x", &few) / 0.25;
    assert!((plane + 1.0).abs() < 0.01, "{plane}");
}

/// Over y a stream along x is drawn, not the nothing across the walls; and of vortices the particles beside
/// the line that the exact solution is drawn along, as others have other values.
#[test]
fn pictures_show_what_the_exact_solution_is_about() {
    let figure = |name: &str, changes: &[&str]| {
        let experiment = experiment(any_scenario(name, changes), "f64", 1);
        let pictures = pictures(&experiment).unwrap();
        let figure = pictures.into_iter().find(|(name, _)| *name == "figure.svg");
        figure.unwrap().1
    };
    let points = |figure: &str| figure.matches("<circle").count() - 1;
    let few = ["resolution.particles=384", "time.end=0.01"];
    let stream = figure("couette", &few);
    assert!(stream.contains("velocity_x") && !stream.contains("velocity_y"));
    let all = points(&stream) / 4;
    assert!((340..=400).contains(&all), "{all} of 384 particles");
    let few = ["resolution.particles=1024", "time.end=0.001"];
    let beside = points(&figure("taylor-green", &few)) / 4;
    assert!((16..=64).contains(&beside), "{beside} along 32 spacings");
}
