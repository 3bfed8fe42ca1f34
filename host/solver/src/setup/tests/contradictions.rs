//! Clouds that contradict themselves: two particles in one place, volumes that are not the room.

use miette::{GraphicalReportHandler, GraphicalTheme};

use super::super::random::Random;
use super::*;

/// A cloud in the unit box: rows, and what reading them comes to.
fn read(
    dimension: usize,
    side: &str,
    heading: &str,
    rows: &[String],
) -> Result<(Vec<Placed>, Vec<String>), SetupError> {
    let vector = |x: f64| format!("{:?}", vec![x; dimension]);
    let corners = format!("lower = {}\nupper = {}\n", vector(0.0), vector(1.0));
    let domain = format!("{corners}sides = {:?}", vec![side; dimension]);
    let resolution = "arrangement = \"file\"\nfile = \"cloud.csv\"";
    let text = text(dimension, &domain, IDEAL, resolution);
    let cloud = format!("{heading}\n{}\n", rows.join("\n"));
    let (scenario, _folder) = scenario_beside(&text, &cloud);
    placed(&scenario)
}

#[track_caller]
fn assert_refused<T>(result: Result<T, SetupError>, parts: &[&str]) {
    let Err(error) = result else {
        panic!("nothing wrong: {parts:?}");
    };
    let mut report = String::new();
    GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor())
        .with_width(2000)
        .render_report(&mut report, &error)
        .unwrap();
    for part in parts {
        assert!(report.contains(part), "no {part:?} in\n{report}");
    }
}

/// The middles of the cells of the unit box, moved at random by a part of a cell.
fn lattice(dimension: usize, along: usize, jitter: f64) -> Vec<[f64; 3]> {
    let mut random = Random::new(7);
    let count = along.pow(dimension as u32);
    let cell = |id: usize, i: usize| (id / along.pow(i as u32)) % along;
    let mut point = |id: usize| {
        let mut x = [0.0; 3];
        for (i, x) in x.iter_mut().enumerate().take(dimension) {
            *x = (cell(id, i) as f64 + 0.5 + jitter * random.signed()) / along as f64;
        }
        x
    };
    (0..count).map(&mut point).collect()
}

/// Columns of positions and velocities, and more.
fn heading(dimension: usize, more: &str) -> String {
    let axes = || ["x", "y", "z"].into_iter().take(dimension);
    let mut columns: Vec<String> = axes().map(|axis| format!("position_{axis}")).collect();
    columns.extend(axes().map(|axis| format!("velocity_{axis}")));
    columns.push(more.to_owned());
    columns.join(",")
}

/// A row of a particle at rest.
fn row(dimension: usize, x: &[f64; 3], more: &str) -> String {
    let position: Vec<String> = x[..dimension].iter().map(f64::to_string).collect();
    format!("{},{}{more}", position.join(","), "0,".repeat(dimension))
}

#[test]
fn two_particles_in_one_place_are_named_with_their_lines_in_every_dimension() {
    for (dimension, along) in [(1, 40), (2, 9), (3, 5)] {
        let points = lattice(dimension, along, 0.3);
        let heading = heading(dimension, "mass,energy");
        let rows = |points: &[[f64; 3]]| -> Vec<String> {
            points.iter().map(|x| row(dimension, x, "0.1,2")).collect()
        };
        let side = "periodic";
        read(dimension, side, &heading, &rows(&points)).unwrap();
        // Exactly, and by a millionth of a spacing less than that which tells two apart.
        for off in [0.0, 5e-7 / along as f64] {
            let mut twins = points.clone();
            let mut twin = points[11];
            twin[0] += off;
            twins.push(twin);
            let last = twins.len() + 1;
            let parts = [
                &format!("line {last}: the particle at "),
                "lies where that of line 13 lies",
                "keep one particle a place",
                &format!("cloud.csv:{last}:1"),
            ];
            assert_refused(read(dimension, side, &heading, &rows(&twins)), &parts);
        }
        // Three of each.
        let tripled = [&points[..], &points, &points].concat();
        let (line, first) = (points.len() + 2, 2);
        let parts = [
            &*format!("line {line}: "),
            &format!("that of line {first} lies"),
            &format!(
                "so do {} of {} particles",
                2 * points.len(),
                3 * points.len()
            ),
        ];
        assert_refused(read(dimension, side, &heading, &rows(&tripled)), &parts);
    }
}

/// Both ends of a period are one place; between walls they are not.
#[test]
fn both_ends_of_a_period_are_one_place() {
    let rows: Vec<String> = (0..=25)
        .map(|k| format!("{},0,0.04,2", 0.04 * f64::from(k)))
        .collect();
    let heading = "position,velocity,mass,energy";
    let parts = [
        "line 27: the particle at 1 lies where that of line 2 lies, at 0",
        "the sides along x are periodic",
        "the lower end or the upper, not both",
    ];
    assert_refused(read(1, "periodic", heading, &rows), &parts);
    read(1, "mirror", heading, &rows).unwrap();
    // A corner that is all corners, and one a rounding off.
    for corner in [[1.0, 1.0], [1.0, 1e-9], [1.0 - 1e-9, 0.0]] {
        let mut points = lattice(2, 8, 0.2);
        points.push([0.0; 3]);
        points.push([corner[0], corner[1], 0.0]);
        let rows: Vec<String> = points.iter().map(|x| row(2, x, "0.1,2")).collect();
        let heading = self::heading(2, "mass,energy");
        assert_refused(
            read(2, "periodic", &heading, &rows),
            &["line 67", "that of line 66 lies, at (0, 0)"],
        );
    }
}

/// Densities that are all wrong by a factor are refused, with both values; those of a sound cloud, also
/// a jittered one between any sides, pass without a word.
#[test]
fn densities_that_contradict_masses_and_spacing_are_refused() {
    for (dimension, along) in [(1, 60), (2, 14), (3, 8)] {
        let heading = heading(dimension, "mass,density,pressure");
        for side in ["periodic", "mirror", "free"] {
            for jitter in [0.0, 0.4] {
                let points = lattice(dimension, along, jitter);
                let mass = 3.0 / points.len() as f64;
                let cloud = |density: f64| {
                    let row = |x| row(dimension, x, &format!("{mass},{density},1"));
                    let rows: Vec<String> = points.iter().map(row).collect();
                    read(dimension, side, &heading, &rows)
                };
                let (_, doubts) = cloud(3.0).unwrap();
                assert_eq!(doubts, [""; 0], "{dimension}D {side} {jitter}");
                for factor in [1e-3, 0.1, 10.0, 1e3] {
                    let density = 3.0 * factor;
                    let parts = [
                        &format!("density = {density} with mass = {mass}"),
                        "its neighbours leave it",
                        "and so it is for most particles",
                        "summed from masses and places",
                        "cloud.csv:",
                    ];
                    assert_refused(cloud(density), &parts);
                }
            }
        }
    }
}

/// One row among many is a warning that names its line; the density that its neighbours leave it is
/// that of the rest.
#[test]
fn one_density_that_contradicts_the_rest_is_a_warning() {
    let points = lattice(2, 20, 0.1);
    let heading = heading(2, "mass,density,pressure");
    for factor in [1e-3, 1e3] {
        let row = |(id, x): (usize, &[f64; 3])| {
            let density = if id == 210 { 2.0 * factor } else { 2.0 };
            row(2, x, &format!("0.005,{density},1"))
        };
        let rows: Vec<String> = points.iter().enumerate().map(row).collect();
        let (_, doubts) = read(2, "periodic", &heading, &rows).unwrap();
        let [doubt] = &doubts[..] else {
            panic!("{doubts:?}");
        };
        assert!(doubt.starts_with("line 212: density = "), "{doubt}");
        let said = doubt.split("a density of ").nth(1).unwrap();
        let said: f64 = said.split(';').next().unwrap().parse().unwrap();
        assert!((said / 2.0 - 1.0).abs() < 0.3, "{doubt}");
    }
}

/// Equal masses at a jump of the density by 1000, in vacuum: sound, whatever the spacings are.
#[test]
fn a_jump_of_the_density_and_a_vacuum_are_no_contradiction() {
    let mut rows = Vec::new();
    let mut x = 0.2;
    for (count, spacing) in [(200, 1e-4), (100, 1e-3), (10, 0.03)] {
        for _ in 0..count {
            rows.push(format!("{},0,1,{},1", x + 0.5 * spacing, 1.0 / spacing));
            x += spacing;
        }
    }
    let (_, doubts) = read(1, "free", "position,velocity,mass,density,pressure", &rows).unwrap();
    assert_eq!(doubts, [""; 0]);
}
