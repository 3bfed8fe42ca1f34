//! Every section beyond those of the shock tube: what it reads as, and its faults.

use super::*;

/// A two-dimensional scenario with one box, to be changed by the tests.
const BOX: &str = r#"
name = "box"
dimension = 2
[domain]
lower = [0.0, 0.0]
upper = [1.0, 1.0]
sides = ["periodic", "periodic"]
[[region]]
lower = [0.0, 0.0]
upper = [1.0, 1.0]
density = 1.0
velocity = [0.0, 0.0]
pressure = 1.0
[material]
equation-of-state = "ideal-gas"
gamma = 1.4
[resolution]
particles = 100
arrangement = "square"
[cut-off]
name = "wendland-c2"
eta = 1.5
[viscosity]
kind = "limited"
alpha = 1.0
beta = 2.0
[time]
end = 0.1
"#;

/// Two materials, named.
const MATERIALS: &str = r#"[[material]]
name = "air"
equation-of-state = "ideal-gas"
gamma = 1.4
[[material]]
name = "water"
equation-of-state = "tait"
density = 1000.0
sound-speed = 10.0
exponent = 7
"#;

const ONE_MATERIAL: &str = "[material]\nequation-of-state = \"ideal-gas\"\ngamma = 1.4\n";
const STATE: &str = "density = 1.0\nvelocity = [0.0, 0.0]\npressure = 1.0\n";
const CORNERS: &str = "lower = [0.0, 0.0]\nupper = [1.0, 1.0]\n";
const DISC: &str = "[[region]]\ncenter = [0.5, 0.5]\nradius = 0.25\n";
const DEPOSIT: &str = "[[deposit]]\ncenter = [0.5, 0.5]\nradius = 0.1\nenergy = 2.0\n";

/// [`BOX`] after replacements, each of which must apply.
#[track_caller]
fn changed(changes: &[(&str, &str)]) -> String {
    changes.iter().fold(BOX.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from:?} is not in the scenario");
        text.replacen(from, to, 1)
    })
}

#[track_caller]
fn read(text: &str) -> Scenario {
    match File::new(text).read(&[]) {
        Ok(scenario) => scenario,
        Err(error) => panic!("{}", report(&error)),
    }
}

/// `BOX` with a profile in place of its region.
fn with_profile(profile: &str) -> String {
    let region = format!("[[region]]\n{CORNERS}{STATE}");
    changed(&[(&region, profile)])
}

#[test]
fn what_is_left_out_means_none_of_it() {
    let scenario = read(BOX);
    assert_eq!(scenario.weights, Weights::Mass);
    assert_eq!(scenario.gradient, GradientKind::Plain);
    assert_eq!(scenario.conduction, 0.0);
    assert_eq!(
        scenario.diffusion,
        Diffusion {
            viscosity: 0.0,
            bulk_viscosity: 0.0,
            heat: 0.0
        }
    );
    assert_eq!(scenario.acceleration, [0.0, 0.0]);
    assert_eq!(scenario.time.energy, EnergyRule::LeapFrog);
    assert_eq!(
        (scenario.viscosity.switch, scenario.viscosity.balsara),
        (None, false)
    );
    assert_eq!(scenario.materials[0].name, "ideal-gas");
    let resolution = &scenario.resolution;
    assert_eq!((resolution.share, resolution.rotation), (Share::Mass, None));
    assert_eq!(resolution.anchor, Anchor::Middle);
    assert_eq!((resolution.seed, resolution.jitter), (1, 0.0));
    assert_eq!(
        (&scenario.output.ring, scenario.output.snapshots),
        (&None, None)
    );
    assert!(scenario.deposits.is_empty() && scenario.tolerances.is_empty());
    assert_eq!(scenario.profile, None);
}

#[test]
fn every_section_reads_as_written() {
    let more = "[weights]\nrule = \"number\"\n[gradient]\nkind = \"linear-exact\"\n[conduction]\nalpha = 0.5\n\
        [diffusion]\nviscosity = 0.01\nbulk-viscosity = 0.03\nheat = 0.02\n[force]\nacceleration = [0.0, -9.81]\n\
        [output]\nexact = \"sedov\"\nring = { inner = 0.05, outer = 0.35, center = [0.5, 0.5] }\n\
        snapshots = { steps = 10, format = \"csv\" }\n\
        [tolerance.density]\nl1 = 0.01\nlinf = 0.5\nreason = \"measured\"\n\
        [tolerance.energy]\nl2 = 0.02\nreason = \"guessed\"\n";
    let switch = "beta = 2.0\nswitch = { minimum = 0.1, decay = 0.2 }\nbalsara = true";
    let lattice = "arrangement = \"square\"\nshare = \"volume\"\nrotation = [2, 4]\nanchor = \"corner\"\nseed = 7\njitter = 0.25";
    let text = changed(&[
        ("[material]", &format!("{DEPOSIT}[material]")),
        ("beta = 2.0", switch),
        ("arrangement = \"square\"", lattice),
        (
            "end = 0.1\n",
            &format!("end = 0.1\nenergy = \"exact\"\n{more}"),
        ),
    ]);
    let scenario = read(&text);
    assert_eq!(scenario.weights, Weights::Number);
    assert_eq!(scenario.gradient, GradientKind::LinearExact);
    assert_eq!(scenario.conduction, 0.5);
    assert_eq!(
        scenario.diffusion,
        Diffusion {
            viscosity: 0.01,
            bulk_viscosity: 0.03,
            heat: 0.02
        }
    );
    assert_eq!(scenario.acceleration, [0.0, -9.81]);
    assert_eq!(scenario.time.energy, EnergyRule::Exact);
    assert_eq!(scenario.viscosity.kind, ViscosityKind::Limited);
    assert_eq!(
        scenario.viscosity.switch,
        Some(Switch {
            minimum: 0.1,
            decay: 0.2
        })
    );
    assert!(scenario.viscosity.balsara);
    let resolution = &scenario.resolution;
    assert_eq!(
        (resolution.share, resolution.rotation),
        (Share::Volume, Some([1, 2]))
    );
    assert_eq!(resolution.anchor, Anchor::Corner);
    assert_eq!((resolution.seed, resolution.jitter), (7, 0.25));
    assert_eq!(scenario.output.exact, Some(Exact::Sedov));
    let ring = scenario.output.ring.as_ref().unwrap();
    assert_eq!(
        (ring.inner, ring.outer, &ring.center),
        (0.05, 0.35, &vec![0.5, 0.5])
    );
    let snapshots = scenario.output.snapshots.unwrap();
    assert_eq!(snapshots.interval, Interval::Steps(10));
    assert_eq!(snapshots.format, SnapshotFormat::Csv);
    assert_eq!(
        (
            scenario.deposits[0].energy,
            scenario.deposits[0].ball.radius
        ),
        (2.0, 0.1)
    );
    let tolerances: Vec<_> = scenario
        .tolerances
        .iter()
        .map(|t| (t.field, t.norm, t.value))
        .collect();
    assert_eq!(
        tolerances,
        [
            (Field::Density, Norm::L1, 0.01),
            (Field::Density, Norm::Linf, 0.5),
            (Field::Energy, Norm::L2, 0.02)
        ]
    );
    assert_eq!(scenario.tolerances[2].reason, "guessed");
}

#[test]
fn materials_give_the_pressure_that_their_law_says() {
    let text = changed(&[
        (ONE_MATERIAL, MATERIALS),
        (
            STATE,
            "density = 1100.0\nvelocity = [0.0, 0.0]\nmaterial = \"water\"\n",
        ),
    ]);
    let scenario = read(&text);
    assert_eq!(scenario.regions[0].material, 1);
    // B = 1000 * 10^2 / 7 and 1.1^7 = 1.9487171, by hand.
    let expected = 1e5 / 7.0 * (1.948_717_1 - 1.0);
    let relative = scenario.regions[0].pressure / expected - 1.0;
    assert!(relative.abs() < 1e-14, "{relative:e}");

    let isothermal = "[material]\nequation-of-state = \"isothermal\"\nsound-speed = 3.0\n";
    let scenario = read(&changed(&[
        (ONE_MATERIAL, isothermal),
        ("pressure = 1.0\n", ""),
    ]));
    assert_eq!(scenario.regions[0].pressure, 9.0);
}

#[test]
fn pressure_and_energy_are_inverse_where_the_energy_plays_a_part() {
    let laws = [
        EquationOfState::IdealGas { gamma: 1.4 },
        EquationOfState::StiffenedGas {
            gamma: 4.4,
            pressure_at_infinity: 6e8,
        },
    ];
    for law in laws {
        let energy = law.energy(1000.0, 1e5);
        let pressure = law.pressure(1000.0, energy);
        assert!((pressure / 1e5 - 1.0).abs() < 1e-11, "{law:?}: {pressure}");
    }
    // (1e5 + 4.4 * 6e8) / (3.4 * 1000), by hand.
    let energy = laws[1].energy(1000.0, 1e5);
    assert!((energy / 776_500.0 - 1.0).abs() < 1e-15, "{energy}");
}

#[test]
fn a_stiffened_gas_may_be_under_tension_down_to_its_limit() {
    let stiff = "[material]\nequation-of-state = \"stiffened-gas\"\ngamma = 4.4\npressure-at-infinity = 2.0\n";
    let at = |pressure: &str| {
        let pressure = format!("pressure = {pressure}\n");
        File::new(changed(&[
            (ONE_MATERIAL, stiff),
            ("pressure = 1.0\n", &pressure),
        ]))
        .read(&[])
    };
    assert_eq!(at("-1.5").unwrap().regions[0].pressure, -1.5);
    let error = at("-2.0").unwrap_err();
    assert_report_holds(&error, &["region.0.pressure = -2.0", "> -2", "above minus"]);
}

#[test]
fn a_ball_lies_on_a_box_and_boxes_still_may_not_overlap() {
    let scenario = read(&changed(&[(
        "[material]",
        &format!("{DISC}{STATE}[material]"),
    )]));
    let ball = scenario.regions[1].ball.as_ref().unwrap();
    assert_eq!(
        (ball.radius, ball.center.as_slice()),
        (0.25, [0.5, 0.5].as_slice())
    );
    assert_eq!(scenario.regions[1].extent.lower, [0.25, 0.25]);

    let second = format!("{DISC}{STATE}[[region]]\n{CORNERS}{STATE}[material]");
    let error = File::new(changed(&[("[material]", &second)]))
        .read(&[])
        .unwrap_err();
    assert_report_holds(&error, &["region.2 overlaps region.0"]);
}

#[test]
fn every_profile_reads() {
    let cases = [
        (
            "kind = \"noh\"\ndensity = 1.0\nspeed = 2.0\npressure = 1e-6",
            Profile::Noh {
                density: 1.0,
                speed: 2.0,
                pressure: 1e-6,
            },
        ),
        (
            "kind = \"sound-wave\"\namplitude = 1e-3\ndensity = 1.0\npressure = 0.6",
            Profile::SoundWave {
                amplitude: 1e-3,
                density: 1.0,
                pressure: 0.6,
            },
        ),
        (
            "kind = \"yee-vortex\"\nstrength = 5.0",
            Profile::YeeVortex {
                strength: 5.0,
                velocity: vec![0.0; 2],
            },
        ),
        (
            "kind = \"gresho\"\nvelocity = [1.0, 0.0]\nmach = 0.1",
            Profile::Gresho {
                velocity: vec![1.0, 0.0],
                mach: Some(0.1),
            },
        ),
        ("kind = \"kelvin-helmholtz\"", Profile::KelvinHelmholtz),
        (
            "kind = \"taylor-green\"\ndensity = 1.0\nspeed = 0.5\npressure = 9.0",
            Profile::TaylorGreen {
                density: 1.0,
                speed: 0.5,
                pressure: 9.0,
            },
        ),
    ];
    for (text, profile) in cases {
        let text = with_profile(&format!("[profile]\n{text}\n"));
        let text = text.replace("arrangement = \"square\"", "arrangement = \"sampled\"");
        assert_eq!(read(&text).profile, Some(profile));
    }
}

#[test]
fn a_riemann_problem_may_lie_along_any_direction() {
    let halves = |direction: usize| {
        let (mut upper, mut lower) = ([1.0, 1.0], [0.0, 0.0]);
        (upper[direction], lower[direction]) = (0.5, 0.5);
        let second = format!("{STATE}[[region]]\nlower = {lower:?}\nupper = [1.0, 1.0]\n{STATE}");
        let region = format!("[[region]]\nlower = [0.0, 0.0]\nupper = {upper:?}\n");
        let text = changed(&[
            (STATE, &second),
            (&format!("[[region]]\n{CORNERS}"), &region),
        ]);
        format!("{text}[output]\nexact = \"riemann\"\n")
    };
    for direction in 0..2 {
        assert_eq!(
            read(&halves(direction)).riemann_direction(),
            Some(direction)
        );
    }
    let narrow = halves(0).replace("lower = [0.5, 0.0]", "lower = [0.5, 0.25]");
    let error = File::new(narrow).read(&[]).unwrap_err();
    assert_report_holds(
        &error,
        &["output.exact = \"riemann\"", "unequal stretches along y"],
    );
}

#[test]
fn a_file_is_looked_for_beside_the_scenario_and_needs_no_region() {
    let file = "arrangement = \"file\"\nfile = \"clouds/a.csv\"";
    let region = format!("[[region]]\n{CORNERS}{STATE}");
    let text = changed(&[
        ("particles = 100\narrangement = \"square\"", file),
        (&region, ""),
    ]);
    let place = File::new(text);
    let scenario = place.read(&[]).unwrap();
    let expected = place.path().parent().unwrap().join("clouds/a.csv");
    assert_eq!(scenario.resolution.arrangement, Arrangement::File(expected));
}

#[test]
fn set_reaches_every_list_and_every_table_in_braces() {
    let text = changed(&[
        (ONE_MATERIAL, MATERIALS),
        ("arrangement = \"square\"", "arrangement = \"hexagonal\""),
    ]);
    let file = File::new(text);
    let scenario = file
        .read(&[
            "material.0.gamma=2",
            "material.1.exponent=3",
            "region.0.material=air",
            "viscosity.switch.minimum=0.5",
            "viscosity.switch.decay=1",
            "output.snapshots={ every = 0.1 }",
            "output.snapshots.steps=3",
            "resolution.jitter=0.1",
            "force.acceleration=[1, 2]",
        ])
        .unwrap();
    assert_eq!(
        scenario.materials[0].law,
        EquationOfState::IdealGas { gamma: 2.0 }
    );
    assert!(matches!(
        scenario.materials[1].law,
        EquationOfState::Tait { exponent: 3, .. }
    ));
    assert_eq!(
        scenario.viscosity.switch,
        Some(Switch {
            minimum: 0.5,
            decay: 1.0
        })
    );
    assert_eq!(
        scenario.output.snapshots.unwrap().interval,
        Interval::Steps(3)
    );
    assert_eq!(scenario.resolution.jitter, 0.1);
    assert_eq!(scenario.acceleration, [1.0, 2.0]);
    for (set, value, cure) in [
        (
            "material.gamma=2",
            "there is no material gamma, the file has 2",
            "from 0 to 1",
        ),
        (
            "material.2.gamma=2",
            "there is no material 2",
            "from 0 to 1",
        ),
        (
            "deposit.0.energy=2",
            "there is no deposit 0",
            "add a [[deposit]]",
        ),
        (
            "tolerance.densty.l1=1",
            "unknown key `densty` in [tolerance]",
            "did you mean `density`?",
        ),
        (
            "viscosity.switch.decai=1",
            "unknown key `decai` in [viscosity.switch]",
            "decay",
        ),
    ] {
        let error = file.read(&[set]).expect_err(set);
        assert_report_holds(&error, &[set, value, cure]);
    }
    let tolerance = [
        "output.exact=sedov",
        "tolerance.density={ l1 = 1, reason = 'why' }",
    ];
    let with_deposit = File::new(changed(&[("[material]", &format!("{DEPOSIT}[material]"))]));
    assert_eq!(with_deposit.read(&tolerance).unwrap().tolerances.len(), 1);
}

/// Replacement in [`BOX`]; the line it is reported on; the value, and the cure.
#[rustfmt::skip]
const FAULTS: &[Case] = &[
    // Materials.
    ("gamma = 1.4", "gamma = 1.4\nsound-speed = 1.0", "sound-speed", "material.sound-speed = 1.0 does not fit: ideal-gas has no sound-speed", "ideal-gas takes gamma"),
    ("\"ideal-gas\"\ngamma = 1.4", "\"tait\"\ndensity = 1.0\nsound-speed = 1.0\nexponent = 16", "exponent", "material.exponent = 16", "7 for water"),
    ("\"ideal-gas\"\ngamma = 1.4", "\"tait\"\ndensity = 1.0\nsound-speed = 1.0\nexponent = 7.1", "exponent", "a number with a fraction", "`exponent = 7`"),
    ("\"ideal-gas\"\ngamma = 1.4", "\"isothermal\"\nsound-speed = 0.0", "sound-speed", "material.sound-speed = 0.0", "larger than 0"),
    ("\"ideal-gas\"\ngamma = 1.4", "\"isothermal\"\nsound-speed = 2.0", "pressure", "region.0.pressure = 1.0 does not fit: isothermal gives 4", "take `pressure` out"),
    ("\"ideal-gas\"\n", "\"stiffened-gas\"\npressure-at-infinity = -1.0\n", "pressure-at-infinity", "material.pressure-at-infinity = -1.0", "0 or a positive"),
    ("density = 1.0\n", "density = 1.0\nmaterial = \"air\"\n", "material", "region.0.material = \"air\" is unknown", "known: ideal-gas"),
    // Open sides.
    ("sides = [\"periodic\", \"periodic\"]", "sides = [[\"inflow\", \"outflow\"], \"periodic\"]", "sides", "there is no [inflow]", "add [inflow] with density"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"inflow\", \"periodic\"]", "sides", "domain.sides.0 = \"inflow\" does not fit: gas can come in at one side only", "[[\"inflow\", \"outflow\"]]"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"outflow\", [\"inflow\", \"free\"]]", "sides", "domain.sides.1 = [\"inflow\", \"free\"] does not fit: gas comes in or goes out along x already", "to one direction"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [[\"periodic\", \"outflow\"], \"periodic\"]", "sides", "periodic at one end", "for the direction"),
    ("[material]", "[inflow]\ndensity = 1.0\nvelocity = [1.0, 0.0]\npressure = 1.0\n[material]", "[inflow]", "no side of the domain is an inflow", "take [inflow] out"),
    ("[material]", "[outflow]\npressure = 1.0\n[material]", "[outflow]", "no side of the domain is an outflow", "take [outflow] out"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"outflow\", \"periodic\"]\n[outflow]\npressure = -1.0", "pressure", "outflow.pressure = -1.0", "larger than 0"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"outflow\", \"periodic\"]\n[outflow]\nvelocity = [1.0, 0.0]", "velocity", "outflow.velocity = [1.0, 0.0] does not fit: gas goes out at both sides along x", "take `velocity` out"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [[\"mirror\", \"outflow\"], \"periodic\"]\n[outflow]\nvelocity = [-1.0, 0.0]", "velocity", "it goes out at the upper side along x", "a positive number along x"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", [\"outflow\", \"mirror\"]]\n[outflow]\nvelocity = [0.0, 1.0]", "velocity", "it goes out at the lower side along y", "a negative number along y"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"outflow\", \"periodic\"]\n[outflow]\npresure = 1.0", "presure", "presure", "did you mean `pressure`?"),
    // Walls.
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", \"periodic\"]\n[diffusion]\nviscosity = 0.1\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"none\"", "end", "there is no wall at the upper side along y", "set the side along y in domain.sides to"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", \"mirror\"]\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"none\"", "slip", "wall.0.slip = \"none\" does not fit: diffusion.viscosity = 0", "give `viscosity` in [diffusion]"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", \"mirror\"]\n[diffusion]\nviscosity = 0.1\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"none\"\nvelocity = [1.0, 0.5]", "velocity", "wall.0.velocity = [1.0, 0.5] does not fit: the wall lies across y", "make the component along y 0"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", \"mirror\"]\n[diffusion]\nviscosity = 0.1\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"none\"\nvelocity = [1.0]", "velocity", "wall.0.velocity has length 1", "dimension = 2"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", \"mirror\"]\n[diffusion]\nviscosity = 0.1\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"free\"\nvelocity = [1.0, 0.0]", "velocity", "free has no velocity", "free takes"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", \"mirror\"]\n[diffusion]\nviscosity = 0.1\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"some\"", "slip", "wall.0.slip = \"some\"", "known: none, free"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", \"mirror\"]\n[diffusion]\nviscosity = 0.1\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"none\"\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"none\"", "end", "wall.1.end = \"upper\" does not fit: wall 0 is the same one", "keep one of the two"),
    ("sides = [\"periodic\", \"periodic\"]", "sides = [\"periodic\", \"mirror\"]\n[diffusion]\nviscosity = 0.1\n[[wall]]\naxis = \"y\"\nend = \"upper\"\nslip = \"none\"\n[output]\nexact = \"channel\"", "exact", "there are no two walls that the gas sticks to", "both ends of one direction"),
    // Regions, profiles, deposits.
    ("lower = [0.0, 0.0]\nupper = [1.0, 1.0]\ndensity", "center = [0.5, 0.5]\nradius = 0.1\nupper = [1.0, 1.0]\ndensity", "upper", "a ball has no upper", "a ball takes center, radius"),
    ("lower = [0.0, 0.0]\nupper = [1.0, 1.0]\ndensity", "center = [0.5, 0.5]\ndensity", "[[region]]", "`radius` is missing in [[region]] 0", "`radius = 0.1`"),
    ("lower = [0.0, 0.0]\nupper = [1.0, 1.0]\ndensity", "center = [0.5, 1.5]\nradius = 0.1\ndensity", "center", "region.0.center = 1.5 lies outside the domain: [0, 1] along y", "move it inside"),
    ("[material]", "[profile]\nkind = \"noh\"\n[material]", "[profile]", "both [profile] and [[region]]", "keep one"),
    ("[material]", "[[deposit]]\ncenter = [0.5, 0.5]\nradius = 0.0\nenergy = 1.0\n[material]", "radius", "deposit.0.radius = 0.0", "larger than 0"),
    ("[material]", "[[deposit]]\ncenter = [0.5, 0.5]\nradius = 0.1\nenergy = -1.0\n[material]", "energy", "deposit.0.energy = -1.0", "larger than 0"),
    // Resolution.
    ("\"square\"", "\"cubic\"", "arrangement", "a lattice of 3 dimensions, dimension = 2", "square or hexagonal"),
    ("\"square\"", "\"sampled\"", "arrangement", "the density of a [profile]", "equal-mass"),
    ("\"square\"", "\"glass\"\njitter = 0.1", "jitter", "random places of its own", "take `jitter` out"),
    ("\"square\"", "\"square\"\njitter = 0.5", "jitter", "resolution.jitter = 0.5", "could meet"),
    ("\"square\"", "\"square\"\nseed = -1", "seed", "resolution.seed = -1", "any whole number"),
    ("\"square\"", "\"square\"\nrotation = [1]", "rotation", "need a pair of whole numbers", "`rotation = [1, 2]`"),
    ("\"square\"", "\"square\"\nrotation = [1, 1001]", "rotation", "resolution.rotation.1 = 1001", "small whole number"),
    ("\"square\"", "\"hexagonal\"\nrotation = [1, 2]", "rotation", "only square lattices between periodic sides", "take `rotation` out"),
    ("\"square\"", "\"glass\"\nanchor = \"corner\"", "anchor", "only lattices between periodic sides can begin in a corner", "take `anchor` out"),
    ("\"square\"", "\"square\"\nanchor = \"centre\"", "anchor", "resolution.anchor = \"centre\"", "middle"),
    ("\"square\"", "\"square\"\nfile = \"a.csv\"", "file", "the arrangement is \"square\"", "arrangement = \"file\""),
    ("\"square\"", "\"file\"\nfile = \"a.csv\"", "particles", "has no particles", "takes file"),
    ("\"square\"", "\"equal-mass\"\nshare = \"volume\"", "share", "gives equal masses", "choose a lattice"),
    // The method.
    ("[time]", "[weights]\nrule = \"masses\"\n[time]", "rule", "weights.rule = \"masses\"", "did you mean `mass`?"),
    ("beta = 2.0", "beta = 2.0\nswitch = { minimum = 2.0, decay = 0.1 }", "switch", "viscosity.switch.minimum = 2.0 does not fit: viscosity.alpha = 1", "at most viscosity.alpha"),
    ("beta = 2.0", "beta = 2.0\nswitch = { minimum = 0.0, decay = 0.0 }", "switch", "viscosity.switch.decay = 0.0", "larger than 0"),
    ("beta = 2.0", "beta = 2.0\nbalsara = 1", "balsara", "need true or false", "`balsara = true`"),
    ("[time]", "[conduction]\nalpha = -1.0\n[time]", "alpha", "conduction.alpha = -1.0", "0 or a positive"),
    ("[time]", "[diffusion]\nheat = -1.0\n[time]", "heat", "diffusion.heat = -1.0", "0 or a positive"),
    ("[time]", "[diffusion]\nbulk-viscosity = -1.0\n[time]", "bulk-viscosity", "diffusion.bulk-viscosity = -1.0", "0 or a positive"),
    ("[time]", "[force]\nacceleration = [1.0]\n[time]", "acceleration", "force.acceleration has length 1", "dimension = 2"),
    ("end = 0.1", "end = 0.1\nenergy = \"leap-frog\"", "energy", "time.energy = \"leap-frog\"", "known: leapfrog, exact, total"),
    // Output.
    ("[time]", "[output]\nexact = \"sedov\"\n[time]", "exact", "the number of regions is 1, that of deposits 0", "one deposit"),
    ("[time]", "[output]\nexact = \"profile\"\n[time]", "exact", "there is no [profile]", "kind noh"),
    ("[time]", "[output]\nexact = \"reference\"\n[time]", "exact", "dimension = 2", "needs dimension = 1"),
    ("[time]", "[output]\nring = { inner = 0.2, outer = 0.1 }\n[time]", "ring", "output.ring.outer = 0.1", "above the inner"),
    ("[time]", "[output]\nsnapshots = { every = 0.0 }\n[time]", "snapshots", "output.snapshots.every = 0.0", "larger than 0"),
    ("[time]", "[output]\nsnapshots = { every = 0.1, steps = 2 }\n[time]", "snapshots", "output.snapshots.steps = 2", "keep one"),
    ("[time]", "[output]\nsnapshots = { format = \"vtu\" }\n[time]", "snapshots", "`every` is missing", "`every = 0.01`"),
    ("[time]", "[tolerance.density]\nl1 = 0.1\nreason = \"r\"\n[time]", "[tolerance.density]", "no output.exact", "add `exact`"),
];

#[test]
fn every_fault_of_the_further_sections_names_the_value_the_line_and_the_cure() {
    for (from, to, line, value, cure) in FAULTS {
        let text = changed(&[(from, to)]);
        let error = File::new(&text).read(&[]).expect_err(to);
        assert_report_holds(&error, &[value, cure, "mine.toml:"]);
        let (number, _) = error.line_and_column().unwrap();
        let shown = text.lines().nth(number - 1).unwrap();
        assert!(shown.contains(line), "{to:?} was reported on {shown:?}");
    }
}

/// [`BOX`] with a stream along x.
fn stream(sides: &str, inflow: &str) -> String {
    changed(&[
        (
            "sides = [\"periodic\", \"periodic\"]",
            &format!("sides = [{sides}, \"periodic\"]"),
        ),
        ("[material]", &format!("[inflow]\n{inflow}[material]")),
    ])
}

#[test]
fn an_inflow_reads_from_either_side_and_points_into_the_domain() {
    let state = |u: &str| format!("density = 2.0\nvelocity = [{u}, 0.5]\npressure = 3.0\n");
    let scenario = read(&stream("[\"inflow\", \"outflow\"]", &state("1.5")));
    assert_eq!(scenario.domain.sides[0], [Side::Inflow, Side::Outflow]);
    assert_eq!(scenario.domain.inflow(), Some((0, 0)));
    let inflow = scenario.inflow.unwrap();
    assert_eq!(
        (inflow.density, inflow.pressure, inflow.material),
        (2.0, 3.0, 0)
    );
    assert_eq!(inflow.velocity, [1.5, 0.5]);

    let above = read(&stream("[\"outflow\", \"inflow\"]", &state("-1.5")));
    assert_eq!(above.domain.inflow(), Some((0, 1)));
    for (sides, u, sign) in [
        (
            "[\"outflow\", \"inflow\"]",
            "1.5",
            "a negative number along x",
        ),
        ("[\"inflow\", \"free\"]", "0.0", "a positive number along x"),
    ] {
        let error = File::new(stream(sides, &state(u))).read(&[]).unwrap_err();
        assert_report_holds(&error, &["inflow.velocity = [", "it comes in at the", sign]);
    }
    let error = File::new(stream("[\"inflow\", \"outflow\"]", "density = 0.0\n"))
        .read(&[])
        .unwrap_err();
    assert_report_holds(&error, &["inflow.density = 0.0", "larger than 0"]);
    let set = File::new(stream("[\"inflow\", \"outflow\"]", &state("1.5")))
        .read(&["inflow.velocity=[2.5, 0.0]"])
        .unwrap();
    assert_eq!(set.inflow.unwrap().velocity, [2.5, 0.0]);
}

#[test]
fn an_outflow_reads_what_is_far_beyond_it() {
    let sides = |outflow: &str| {
        changed(&[(
            "sides = [\"periodic\", \"periodic\"]",
            &format!("sides = [[\"mirror\", \"outflow\"], \"periodic\"]\n{outflow}"),
        )])
    };
    assert_eq!(read(&sides("")).outflow, Outflow::default());
    let both = read(&sides("[outflow]\npressure = 2.0\nvelocity = [0.5, 0.1]\n"));
    let expected = Outflow {
        pressure: Some(2.0),
        velocity: Some(vec![0.5, 0.1]),
    };
    assert_eq!(both.outflow, expected);
    let set = File::new(sides(""))
        .read(&["outflow.pressure=3.0"])
        .unwrap();
    assert_eq!(set.outflow.pressure, Some(3.0));
}

#[test]
fn the_reference_solution_knows_no_inflow() {
    let sides = r#"domain.sides=[["inflow", "outflow"]]"#;
    let set = [
        sides,
        "inflow.density=1",
        "inflow.velocity=[1.0]",
        "inflow.pressure=1",
    ];
    sod(&set).unwrap();
    let error = sod(&[&set[..], &["output.exact=reference"]].concat()).unwrap_err();
    assert_report_holds(
        &error,
        &[
            "output.exact = \"reference\"",
            "no inflow",
            "leave `exact` out",
        ],
    );
}

/// A `[profile]` in place of the region; what the report holds.
#[rustfmt::skip]
const PROFILE_FAULTS: &[(&str, &[&str])] = &[
    ("[profile]\nkind = \"noe\"\n", &["profile.kind = \"noe\"", "did you mean `noh`?"]),
    ("[profile]\nkind = \"noh\"\nspeed = 1.0\npressure = 1.0\n", &["`density` is missing in [profile]", "`density = 1.0`"]),
    ("[profile]\nkind = \"noh\"\nmach = 1.0\n", &["profile.mach = 1.0", "noh takes density, speed, pressure"]),
    ("[profile]\nkind = \"kelvin-helmholtz\"\nspeed = 1.0\n", &["kelvin-helmholtz takes nothing"]),
    ("[profile]\nkind = \"yee-vortex\"\nstrength = 50.0\n", &["profile.strength = 50.0", "temperature at the centre"]),
    ("[profile]\nkind = \"gresho\"\nmach = 0.0\n", &["profile.mach = 0.0", "larger than 0"]),
    ("[profile]\nkind = \"sound-wave\"\namplitude = 0.9\ndensity = 1.0\npressure = 1.0\n", &["takes the pressure to 0", "below 1/gamma"]),
    ("[profile]\nkind = \"kelvin-helmholtz\"\n", &["equal masses do not make the density", "share = \"volume\""]),
    ("", &["neither [[region]] nor [profile]", "add a [[region]]"]),
];

#[test]
fn every_fault_of_a_profile_tells_the_cure() {
    for (profile, parts) in PROFILE_FAULTS {
        let error = File::new(with_profile(profile))
            .read(&[])
            .expect_err(profile);
        assert_report_holds(&error, parts);
    }
    let cold = with_profile("[profile]\nkind = \"noh\"\n").replace(
        ONE_MATERIAL,
        "[material]\nequation-of-state = \"isothermal\"\nsound-speed = 1.0\n",
    );
    let error = File::new(cold).read(&[]).unwrap_err();
    assert_report_holds(
        &error,
        &["profile.kind = \"noh\"", "first material is isothermal"],
    );
}

#[test]
fn materials_need_names_of_their_own() {
    let twice = MATERIALS.replace("\"water\"", "\"air\"");
    let error = File::new(changed(&[(ONE_MATERIAL, &twice)]))
        .read(&[])
        .unwrap_err();
    assert_report_holds(
        &error,
        &["material.1.name = \"air\"", "material.0 has the same name"],
    );
    let nameless = MATERIALS.replace("name = \"water\"\n", "");
    let error = File::new(changed(&[(ONE_MATERIAL, &nameless)]))
        .read(&[])
        .unwrap_err();
    assert_report_holds(
        &error,
        &["`name` is missing in [[material]] 1", "`name = \"water\"`"],
    );
}

#[test]
fn a_tolerance_needs_a_reason_and_a_norm() {
    let with = |lines: &str| {
        let text = changed(&[("[material]", &format!("{DEPOSIT}[material]"))]);
        let text = format!("{text}[output]\nexact = \"sedov\"\n[tolerance.density]\n{lines}");
        File::new(text).read(&[]).unwrap_err()
    };
    assert_report_holds(
        &with("l1 = 0.1\n"),
        &["`reason` is missing in [tolerance.density]"],
    );
    assert_report_holds(
        &with("l1 = 0.1\nreason = \" \"\n"),
        &["tolerance.density.reason", "it is empty"],
    );
    assert_report_holds(
        &with("reason = \"why\"\n"),
        &["`l1` is missing in [tolerance.density]"],
    );
    assert_report_holds(
        &with("l1 = 0.0\nreason = \"why\"\n"),
        &["tolerance.density.l1 = 0.0"],
    );
}

pub(super) const PAGE: &str = include_str!("../../../../docs/scenario.md");

#[test]
fn the_page_names_every_key_and_every_choice() {
    let families = [Family::Gas, Family::Linear];
    for (section, keys) in families.into_iter().flat_map(keys::sections) {
        for key in keys.iter().filter(|_| *section != "tolerance") {
            let marked = [format!("`{}`", key.name), format!("[{}]", key.name)];
            let named = marked.iter().any(|marked| PAGE.contains(marked));
            assert!(
                named || key.name == "tolerance",
                "docs/scenario.md lacks {} of [{section}]",
                key.name
            );
        }
    }
    let choices = [
        "mirror periodic free inflow outflow ideal-gas stiffened-gas isothermal tait noh sound-wave yee-vortex",
        "gresho kelvin-helmholtz equal-mass square hexagonal cubic close-packed sampled glass file",
        "mass volume number plain linear-exact pairwise gingold_monaghan von_neumann limited none leapfrog exact",
        "total riemann sedov profile reference vtu csv",
        "transport acoustics telegraph shallow-water maxwell-te elastic-waves linearised-gas matrices convection-diffusion",
        "still uniform rotation shear compression wave flow gaussian exp-sine plane-wave standing-wave modes",
        "lattice distorted low-discrepancy rk4 ssp-rk3 rkl2 initial",
        "band legendre spots",
        "direct mixed arithmetic harmonic parabola layers linear logistic gray-scott",
        "no-flux value flux exchange lower upper x y z",
    ];
    for choice in choices.iter().flat_map(|line| line.split(' ')) {
        assert!(
            PAGE.contains(&format!("\"{choice}\"")),
            "docs/scenario.md lacks {choice}"
        );
    }
}

#[test]
fn the_example_of_the_page_reads() {
    let example = PAGE.split("```toml\n").nth(1).unwrap();
    let scenario = read(example.split("```").next().unwrap());
    assert_eq!(scenario.regions.len(), 3);
    assert_eq!(scenario.regions[2].material, 1);
    assert_eq!(scenario.resolution.share, Share::Volume);
}

/// Of every field in every norm, in `--set` as in a file; about a center only where there is one.
#[test]
fn tolerances_take_every_field_and_norm_that_json_gives() {
    let fields = [
        "density",
        "velocity",
        "pressure",
        "energy",
        "momentum",
        "total_energy",
        "velocity_radial",
        "velocity_azimuthal",
    ];
    let norms = ["l1", "l2", "linf", "mean", "rms", "relative_l1", "mass_l1"];
    let of = |field: &str| {
        let values = norms.map(|norm| format!("{norm} = 0.5"));
        format!(
            "tolerance.{field}={{ {}, reason = 'why' }}",
            values.join(", ")
        )
    };
    let all = fields.map(of);
    let gresho = Scenario::read(Source::from("gresho"), &all).unwrap();
    assert_eq!(gresho.tolerances.len(), fields.len() * norms.len());
    let told: Vec<_> = gresho.tolerances.iter().map(|t| t.field.name()).collect();
    assert!(fields.iter().all(|field| told.contains(field)), "{told:?}");
    for field in ["velocity_radial", "velocity_azimuthal"] {
        let error = sod(&[&of(field)]).unwrap_err();
        assert_report_holds(
            &error,
            &["not round about a point", "give a bound of `velocity`"],
        );
    }
    assert!(sod(&[&of("momentum")]).is_ok());
}

#[test]
fn walls_that_a_gas_sticks_to_are_read() {
    let wall = |rest: &str| format!("[[wall]]\naxis = \"y\"\n{rest}\n");
    let lower = wall("end = \"lower\"\nslip = \"none\"");
    let upper = wall("end = \"upper\"\nslip = \"none\"\nvelocity = [2.0, 0.0]");
    let sides = "sides = [\"periodic\", \"mirror\"]\n[diffusion]\nviscosity = 0.1\n";
    let text = changed(&[(
        "sides = [\"periodic\", \"periodic\"]",
        &format!("{sides}{lower}{upper}"),
    )]);
    let scenario = File::new(&text).read(&[]).unwrap();
    assert_eq!(scenario.walls[0], [None, None]);
    assert_eq!(
        scenario.walls[1],
        [Some(vec![0.0; 2]), Some(vec![2.0, 0.0])]
    );
    assert_eq!(scenario.channel(), Ok(1));
    let slower = File::new(&text)
        .read(&["wall.1.velocity=[0.5, 0.0]"])
        .unwrap();
    assert_eq!(slower.walls[1][1], Some(vec![0.5, 0.0]));
    let free = File::new(&text).read(&["wall.0.slip=free"]).unwrap();
    assert_eq!(free.walls[1][0], None);
    // Nothing lies along the wall of a tube.
    let error = sod(&["diffusion.viscosity=0.1", "wall.0.slip=none"]).unwrap_err();
    assert_report_holds(&error, &["wall.0"]);
    let tube = format!(
        "{SOD}\n[diffusion]\nviscosity = 0.1\n{}",
        lower.replace("\"y\"", "\"x\"")
    );
    let error = File::new(tube).read(&[]).unwrap_err();
    assert_report_holds(
        &error,
        &[
            "dimension = 1: nothing lies along a wall",
            "take this [[wall]] out",
        ],
    );
}
