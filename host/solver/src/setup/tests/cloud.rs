//! Clouds from files, and where their faults are.

use miette::{GraphicalReportHandler, GraphicalTheme};

use super::*;

const MATERIALS: &str = "[[material]]\nname = \"air\"\nequation-of-state = \"ideal-gas\"\ngamma = 1.5\n\
    [[material]]\nname = \"water\"\nequation-of-state = \"isothermal\"\nsound-speed = 2.0\n";

fn read(dimension: usize, materials: &str, cloud: &str) -> Result<Vec<Placed>, SetupError> {
    let vector = |x: f64| format!("{:?}", vec![x; dimension]);
    let domain = format!(
        "lower = {}\nupper = {}\nsides = {:?}",
        vector(0.0),
        vector(1.0),
        vec!["mirror"; dimension]
    );
    let resolution = "arrangement = \"file\"\nfile = \"cloud.csv\"";
    let text = text(dimension, &domain, materials, resolution);
    let (scenario, _folder) = scenario_beside(&text, cloud);
    particles(&scenario)
}

#[test]
fn a_cloud_is_read_in_any_order_of_columns_and_others_are_passed_over() {
    let cloud = "id,mass,position_y,position_x,velocity_x,velocity_y,density,pressure,material,epsilon\n\
                 0,0.5,0.25,0.75,1,-1,2,3,air,nonsense\r\n\
                 1, 1.5 ,0.5,0.5,0,0,4,99,water,\n";
    let particles = read(2, MATERIALS, cloud).unwrap();
    let expected = [
        Placed {
            position: [0.75, 0.25, 0.0],
            velocity: [1.0, -1.0, 0.0],
            mass: 0.5,
            density: 2.0,
            pressure: 3.0,
            energy: 3.0,
            material: 0,
        },
        Placed {
            position: [0.5, 0.5, 0.0],
            velocity: [0.0; 3],
            mass: 1.5,
            density: 4.0,
            // c^2 rho, whatever the file says.
            pressure: 16.0,
            energy: 0.0,
            material: 1,
        },
    ];
    assert_eq!(particles, expected);
}

#[test]
fn what_motes_writes_reads_back_to_the_same_bits() {
    let sod = Scenario::read(Source::from("sod"), &["resolution.particles=90".to_owned()]);
    let before = particles(&sod.unwrap()).unwrap();
    let mut cloud =
        "id,position,velocity,mass,density,pressure,energy,epsilon,neighbours,material\n"
            .to_owned();
    for (id, p) in before.iter().enumerate() {
        let (x, u) = ((p.position[0] + 1.0) / 2.0, p.velocity[0]);
        // Half the room, half the mass.
        let mass = p.mass / 2.0;
        cloud += &format!(
            "{id},{x},{u},{mass},{},{},{},0.1,7,0\n",
            p.density, p.pressure, p.energy
        );
    }
    let after = read(1, IDEAL, &cloud).unwrap();
    assert_eq!(after.len(), before.len());
    for (a, b) in after.iter().zip(&before) {
        assert_eq!(
            a.position[0].to_bits(),
            ((b.position[0] + 1.0) / 2.0).to_bits()
        );
        assert_eq!(
            (2.0 * a.mass, a.density, a.energy),
            (b.mass, b.density, b.energy)
        );
        assert_near(a.pressure, b.pressure, 1e-15);
    }
}

#[test]
fn without_a_density_the_mean_of_the_domain_is_the_first_guess() {
    let cloud = "position,velocity,mass,energy\n0.1,0,1,4\n0.9,0,2,4\n";
    let particles = read(1, IDEAL, cloud).unwrap();
    assert!(particles.iter().all(|p| p.density == 3.0));
    assert_near(particles[0].pressure, 0.4 * 3.0 * 4.0, 1e-15);
}

#[test]
fn every_fault_names_file_line_column_value_and_cure() {
    const HEADING: &str = "position,velocity,mass,energy";
    for (heading, rows, parts) in [
        (
            "position,velocity,energy",
            "0.5,0,1",
            ["no column `mass`", "columns are: position", "cloud.csv:1:1"],
        ),
        (
            "position_y,velocity,mass,energy",
            "0.5,0,1,1",
            ["no column `position_x`", "dimension = 1", "cloud.csv:1:1"],
        ),
        (
            "position,velocity,mass",
            "0.5,0,1",
            [
                "no column `energy` or `pressure`",
                "need position_x",
                "cloud.csv:1:1",
            ],
        ),
        (
            "position,velocity,mass,pressure",
            "0.5,0,1,1",
            ["none of `density`", "need position_x", "cloud.csv:1:1"],
        ),
        (
            HEADING,
            "0.5,0,1,1\n0.6,0,-2.5,1",
            ["line 3, mass = -2.5", "larger than 0", "cloud.csv:3:7"],
        ),
        (
            HEADING,
            "0.5,0,1,1\n0.6,fast,1,1",
            [
                "line 3, velocity = fast",
                "an ordinary number",
                "cloud.csv:3:5",
            ],
        ),
        (
            HEADING,
            "0.5,nan,1,1",
            [
                "line 2, velocity = nan",
                "an ordinary number",
                "cloud.csv:2:5",
            ],
        ),
        (
            HEADING,
            "1.5,0,1,1",
            [
                "line 2, position = 1.5",
                "in the domain: [0, 1]",
                "cloud.csv:2:1",
            ],
        ),
        (
            HEADING,
            "0.5,0,1,0",
            ["line 2, energy = 0", "larger than 0", "cloud.csv:2:9"],
        ),
        (
            HEADING,
            "0.5,0,1,1\n0.6,0,1",
            [
                "line 3 has 3 fields, the heading has 4",
                "cut short",
                "cloud.csv:3:1",
            ],
        ),
        (
            "position,velocity,mass,energy,mass",
            "0.5,0,1,1,1",
            [
                "the heading has `mass` twice, as columns 3 and 5",
                "keep one of the two",
                "cloud.csv:1:1",
            ],
        ),
        (
            "position,velocity,mass,energy,position_x",
            "0.5,0,1,1,0.5",
            [
                "columns 1 and 5, `position` and `position_x`",
                "the same quantity",
                "cloud.csv:1:1",
            ],
        ),
        (
            "position,velocity,mass,energy,Density",
            "0.5,0,1,1,1",
            [
                "column 5 is called `Density`, which is not read as `density`",
                "case counts",
                "cloud.csv:1:1",
            ],
        ),
        (
            HEADING,
            "",
            ["no particles", "a row a particle", "cloud.csv:1:1"],
        ),
        (
            "position,velocity,mass,density,pressure",
            "0.5,0,1,1,-1",
            ["pressure = -1", "above 0", "cloud.csv:2:11"],
        ),
        (
            "position,velocity,mass,energy,material",
            "0.5,0,1,1,oil",
            [
                "material = oil",
                "one of the materials: ideal-gas",
                "cloud.csv:2:11",
            ],
        ),
    ] {
        let error = read(1, IDEAL, &format!("{heading}\n{rows}\n")).expect_err(rows);
        let mut report = String::new();
        GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor())
            .with_width(500)
            .render_report(&mut report, &error)
            .unwrap();
        for part in parts {
            assert!(report.contains(part), "no {part:?} in\n{report}");
        }
    }
}

#[test]
fn a_missing_file_tells_where_it_is_looked_for() {
    let (mut scenario, folder) = scenario_beside(
        &text(
            1,
            "lower = [0.0]\nupper = [1.0]\nsides = [\"free\"]",
            IDEAL,
            "arrangement = \"file\"\nfile = \"cloud.csv\"",
        ),
        "",
    );
    let path = folder.path().join("none.csv");
    scenario.resolution.arrangement = Arrangement::File(path.clone());
    let error = particles(&scenario).unwrap_err().to_string();
    assert!(error.contains(&path.display().to_string()), "{error}");
}

/// The pressure of gamma 1.5, density 2 and energy 3 is 3.
#[test]
fn an_energy_and_a_pressure_that_contradict_each_other_are_refused_with_both() {
    let cloud = |pressure: &str| {
        format!("position,velocity,mass,density,energy,pressure\n0.5,0,1,2,3,{pressure}\n")
    };
    let air = "[material]\nequation-of-state = \"ideal-gas\"\ngamma = 1.5\n";
    // Within what few digits leave, the energy counts.
    for fair in ["3", "3.00001", "2.98"] {
        assert_eq!(read(1, air, &cloud(fair)).unwrap()[0].pressure, 3.0);
    }
    for foul in ["3.1", "2.9", "-3", "3000", "0"] {
        let error = read(1, air, &cloud(foul)).unwrap_err();
        let report = miette::Report::new(error);
        let text = format!("{report}: {}", report.help().unwrap());
        for part in [
            "line 2",
            &format!("pressure = {foul}"),
            "3.000000e0",
            "ideal-gas",
        ] {
            assert!(text.contains(part), "no {part:?} in {text}");
        }
    }
    // Without a density nothing says what the pressure should be.
    let silent = "position,velocity,mass,energy,pressure\n0.5,0,1,3,77\n";
    assert!(read(1, air, silent).is_ok());
}
