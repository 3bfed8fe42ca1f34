//! Formulas in scenarios: what they compute is what the names say that they replace, manufactured
//! solutions are approached with the orders of Theorem 2, and what cannot be is refused with its place.

mod runs;

use motes::experiment::ExperimentError;
use motes::scenario::{AnyScenario, Source};

/// A scenario of that text with changes.
fn scenario(text: &str, changes: &[&str]) -> AnyScenario {
    let changes: Vec<String> = changes.iter().map(|change| (*change).to_owned()).collect();
    AnyScenario::read(Source::Text(text.to_owned()), &changes).unwrap()
}

/// A component of a run at its end.
fn column(scenario: AnyScenario, scalar: &str, component: &str) -> Vec<f64> {
    let experiment = runs::experiment(scenario, scalar, 2);
    experiment.simulation.column(component).unwrap()
}

/// The TOML of the examples of a page.
fn examples(page: &str) -> Vec<String> {
    let blocks = page.split("```toml\n").skip(1);
    blocks
        .map(|block| block.split("```").next().unwrap().to_owned())
        .collect()
}

#[test]
fn every_example_of_the_page_runs_and_has_a_small_error() {
    let examples = examples(include_str!("../docs/formulas.md"));
    assert_eq!(examples.len(), 3);
    for text in examples {
        let scenario = scenario(&text, &[]);
        let name = scenario.name().to_owned();
        // The third has no solution; the front of a bistable reaction is a matter of its own below.
        let most = match name.as_str() {
            // Of first order at the worst: 2 pi/400 of the wave.
            "density-wave" => 0.2 * 2.0 * std::f64::consts::PI / 400.0,
            // Of order r theta = 3: (2 pi)^4/4! eps^4, eps = 400^-0.75.
            "acoustics-in-a-medium" => 1e-5,
            "bistable" => f64::INFINITY,
            other => panic!("{other} has no bound"),
        };
        let experiment = runs::experiment(scenario, "f64", 2);
        let warnings = experiment.simulation.warnings(&experiment.outcome);
        assert!(
            warnings.is_empty() && experiment.doubts.is_empty(),
            "{name}: {warnings:?}"
        );
        let errors = experiment.errors.unwrap_or_default();
        for (field, norms) in &errors {
            assert!(norms.l2 < most, "{name}: {field} {}", norms.l2);
        }
        assert_eq!(errors.is_empty(), name == "bistable");
    }
}

/// `u_t = u_xx + u (1 - u)(u - a)` has the front `u = 1/(1 + e^((x - c t)/√2))`, `c = (1 - 2a)/√2`
/// (Huxley; Murray, Mathematical Biology I, 2002, section 13.4).
#[test]
fn a_reaction_of_formulas_moves_its_front_at_the_speed_that_is_known() {
    let text = examples(include_str!("../docs/formulas.md"))[2].clone();
    let exact = "output.exact=[\"1/(1 + exp((x - 8 - 0.4/sqrt(2)*t)/sqrt(2)))\"]";
    let changes = [
        "system.diffusivity=1",
        "initial.state=\"1/(1 + exp((x - 8)/sqrt(2)))\"",
        exact,
    ];
    let experiment = runs::experiment(scenario(&text, &changes), "f64", 2);
    let errors = experiment.errors.unwrap();
    // The front has moved by 2.83; the walls, 8 lengths away, and the 400 particles leave 1e-3 of it.
    assert!(errors["u"].linf < 3e-3, "{}", errors["u"].linf);
}

/// Orders of Theorem 2, `r theta`, with matrices of place and time on a cloud that is squeezed.
#[test]
fn manufactured_solutions_are_approached_with_the_orders_of_theorem_2() {
    for (shape, eta, order, counts) in [
        ("quintic-spline", "0.7", 1.5, [1024, 2304, 4096]),
        ("smooth-4", "1.0", 3.0, [1024, 2304, 4096]),
    ] {
        let shape = format!("cut-off.name={shape}");
        let eta = format!("cut-off.eta={eta}");
        let errors = counts.map(|count| {
            let count = format!("resolution.particles={count}");
            runs::run("manufactured", "f64", 2, &[&shape, &eta, &count]).errors["state"].l2
        });
        let slope = |a: usize, b: usize| {
            let spacings = f64::from(counts[b]) / f64::from(counts[a]);
            2.0 * (errors[a] / errors[b]).ln() / spacings.ln()
        };
        for (a, b) in [(0, 1), (1, 2), (0, 2)] {
            let found = slope(a, b);
            assert!(
                (found - order).abs() < 0.1,
                "{shape}: {errors:?}, order {found}, expected {order}"
            );
        }
    }
}

/// The source that is made of a solution is that of the system as the core has it: with any other
/// coefficient the error would be of the size of the solution.
#[test]
fn every_system_is_solved_by_what_is_manufactured_for_it() {
    let waves = [
        "sin(k*(x + y) - t)",
        "exp(-t)*cos(k*x)",
        "cos(k*y + t)",
        "sin(k*x)*sin(k*y)",
        "cos(k*(x - y) - t)",
    ];
    let line = ["sin(k*x - t)", "exp(-t)*cos(k*x)"];
    let species = ["2 + sin(k*(x + y) - t)", "1 + 0.5*exp(-t)*cos(k*x)"];
    for (dimension, system, state) in [
        (
            1,
            "kind = \"telegraph\"\ninductance = 0.5\ncapacitance = 2.0\nresistance = 0.7\nconductance = 0.3",
            &line[..],
        ),
        (
            1,
            "kind = \"acoustics\"\ndensity = 2.0\nsound-speed = 1.5",
            &line,
        ),
        (
            1,
            "kind = \"matrices\"\ncomponents = 2\nflux = [[[0.5, 2], [0.5, -0.2]]]\ndecay = [[1, 0.5], [-0.3, 0]]",
            &line,
        ),
        (
            1,
            "kind = \"linearised-gas\"\ndensity = 2.0\npressure = 1.0\ngamma = 1.4\nvelocity = [0.3]",
            &["sin(k*x - t)", "cos(k*x)", "exp(-t)*cos(k*x)"],
        ),
        (
            2,
            "kind = \"transport\"\nvelocity = { kind = \"wave\", amplitude = 0.2 }\ndecay = 0.4",
            &waves[..1],
        ),
        (
            2,
            "kind = \"acoustics\"\ndensity = 2.0\nsound-speed = 1.5",
            &waves[..3],
        ),
        (
            2,
            "kind = \"shallow-water\"\ngravity = 2.0\ndepth = 0.7\ncoriolis = 1.3",
            &waves[..3],
        ),
        (
            2,
            "kind = \"maxwell-te\"\npermittivity = 2.0\npermeability = 0.7",
            &waves[..3],
        ),
        (
            2,
            "kind = \"elastic-waves\"\ndensity = 2.0\nlambda = 0.7\nmu = 0.4",
            &waves,
        ),
        (
            2,
            "kind = \"linearised-gas\"\ndensity = 2.0\npressure = 1.0\ngamma = 1.4\nvelocity = [0.3, -0.2]",
            &waves[..4],
        ),
        (
            2,
            "kind = \"convection-diffusion\"\ndiffusivity = 0.02\ntensor = [[1.0, 0.3], [0.3, 0.6]]\nvelocity = { kind = \"wave\", amplitude = 0.2 }\nmodulation = { amplitude = 0.5, rate = 3.0 }",
            &species[..1],
        ),
        (
            2,
            "kind = \"convection-diffusion\"\ndiffusivity = 0.02\nreaction = { kind = \"logistic\", rate = 2.0, capacity = 3.0 }",
            &species[..1],
        ),
        (
            2,
            "kind = \"convection-diffusion\"\nspecies = [\"a\", \"b\"]\ndiffusivity = [0.02, 0.01]\nreaction = { kind = \"gray-scott\", feed = 0.4, kill = 0.6 }",
            &species,
        ),
        (
            2,
            "kind = \"convection-diffusion\"\nspecies = [\"a\", \"b\"]\ndiffusivity = [0.02, 0.01]\nreaction = { kind = \"linear\", matrix = [[-1.0, 0.5], [0.2, 0.3]], source = [0.4, -0.7] }",
            &species,
        ),
        (
            2,
            "kind = \"convection-diffusion\"\nspecies = [\"a\", \"b\"]\ndiffusivity = [0.02, 0.01]\nreaction = { kind = \"formula\", rates = [\"a*b\", \"u0 - b^2\"] }",
            &species,
        ),
    ] {
        let list = |of: &str| format!("[{}]", vec![of; dimension].join(", "));
        let state: Vec<String> = state.iter().map(|of| format!("\"{of}\"")).collect();
        let text = format!(
            "name = \"made\"\ndimension = {dimension}\n[define]\nk = \"2*pi\"\n[domain]\nlower = {}\nupper = {}\n\
             sides = {}\n[system]\n{system}\n[motion]\nkind = \"{}\"\n[initial]\nkind = \"manufactured\"\n\
             state = [{}]\n[resolution]\nparticles = {}\n[cut-off]\nname = \"smooth-4\"\neta = 1.0\ntheta = 0.75\n\
             [time]\nend = 0.3\n[output]\nexact = \"initial\"\n",
            list("0.0"),
            list("1.0"),
            list("\"periodic\""),
            if system.contains("diffusion") {
                "flow"
            } else {
                "still"
            },
            state.join(", "),
            [100, 1024][dimension - 1],
        );
        let errors = runs::experiment(scenario(&text, &[]), "f64", 2)
            .errors
            .unwrap();
        // (2 pi eps)^4/8 of waves of one length, eps = 0.074 in the plane: 0.6 % at most.
        let error = errors["state"].relative_l1.unwrap();
        assert!(error < 0.01, "{system}: {error}");
    }
}

/// A manufactured solution in three dimensions, of a system or of convection-diffusion.
fn in_space(system: &str, state: &str, time: &str) -> String {
    format!(
        r#"
        name = "in-space"
        dimension = 3
        [define]
        k = "2*pi"
        [domain]
        lower = [0.0, 0.0, 0.0]
        upper = [1.0, 1.0, 1.0]
        sides = ["periodic", "periodic", "periodic"]
        {system}
        [initial]
        kind = "manufactured"
        state = {state}
        [resolution]
        particles = 4096
        [cut-off]
        name = "quintic-spline"
        eta = 0.7
        theta = 0.75
        [time]
        {time}
        [output]
        exact = "initial"
        "#
    )
}

/// Orders of Theorems 2 and 3 in three dimensions, on clouds that are squeezed.
#[test]
fn the_orders_of_theorems_2_and_3_are_seen_in_space() {
    let flow = r#"["0.1*sin(k*x)", "0.1*sin(k*y)*cos(t)", "0.1"]"#;
    let sound = in_space(
        &format!("[system]\nkind = \"acoustics\"\n[motion]\nkind = \"formula\"\nvelocity = {flow}"),
        r#"["sin(k*(x + y) - t)", "cos(k*x)*sin(k*z)", "exp(-t)*cos(k*y)", "sin(k*z - t)"]"#,
        "end = 0.2",
    );
    let heat = in_space(
        &format!(
            "[system]\nkind = \"convection-diffusion\"\n\
             diffusivity = \"0.02*(1 + 0.3*sin(k*x)*cos(t))\"\nvelocity = {flow}"
        ),
        r#""sin(k*(x + y) - t) + cos(k*x)*sin(k*z)""#,
        "end = 0.1\nstep = 0.00625",
    );
    for text in [&sound, &heat] {
        for (shape, eta, order, counts) in [
            ("quintic-spline", "0.7", 1.5, [13824u32, 32768]),
            ("smooth-4", "1.0", 3.0, [13824, 27000]),
        ] {
            let errors = counts.map(|count| {
                let changes = [
                    &format!("cut-off.name={shape}"),
                    &format!("cut-off.eta={eta}"),
                    &format!("resolution.particles={count}"),
                ];
                let scenario = scenario(text, &changes.map(String::as_str));
                runs::experiment(scenario, "f64", 2).errors.unwrap()["state"].l2
            });
            let finer = f64::from(counts[1]) / f64::from(counts[0]);
            let found = 3.0 * (errors[0] / errors[1]).ln() / finer.ln();
            // So coarse, a tenth more than in the plane.
            assert!(
                (found - order).abs() < 0.2,
                "{shape}: {errors:?}, order {found}, expected {order}"
            );
        }
    }
}

/// The text of a built-in scenario without its exact solution, with parts replaced.
fn text(name: &str, replaced: &[(&str, &str)]) -> String {
    let built_in = motes::scenario::built_in(name).unwrap().text;
    let end = built_in.find("[output]").unwrap();
    replaced
        .iter()
        .fold(built_in[..end].to_owned(), |text, (from, to)| {
            assert!(text.contains(from), "{from:?} is not in {name}");
            text.replacen(from, to, 1)
        })
}

/// A formula that says what a name says gives the same to rounding, in steps of the same length.
#[test]
fn a_formula_gives_what_the_name_gives_that_it_replaces() {
    let legendre = "kind = \"legendre\"             # amplitude P_degree((x - center)/radius)\ndegree = 3\namplitude = 1.0";
    for (name, component, changes, formulas) in [
        (
            "transport-rotation",
            "u",
            &[
                "time.end=0.25",
                "motion.kind=still",
                "resolution.particles=900",
                "time.step=0.005",
            ][..],
            &[(
                "velocity = { kind = \"rotation\", rate = 6.283185307179586 }",
                "velocity = [\"-2*pi*y\", \"2*pi*x\"]",
            )][..],
        ),
        (
            "transport-rotation",
            "u",
            &[
                "time.end=0.25",
                "resolution.particles=900",
                "time.step=0.005",
            ],
            &[(
                "[motion]\nkind = \"flow\"",
                "[motion]\nkind = \"formula\"\nvelocity = [\"-2*pi*y\", \"2*pi*x\"]",
            )],
        ),
        (
            "variable-diffusivity",
            "u",
            &["time.end=0.2", "time.step=0.001"],
            &[
                (
                    "diffusivity = 0.1 ",
                    "diffusivity = \"0.1*(1 - x^2)*(1 + 0.5*sin(2*pi*t))\" ",
                ),
                ("profile = ", "# "),
                ("modulation = ", "# "),
                (legendre, "kind = \"formula\"\nstate = \"(5*x^3 - 3*x)/2\""),
            ],
        ),
        (
            "decay-chain",
            "daughter",
            &["time.end=0.2", "time.step=0.001"],
            &[
                ("kind = \"linear\"", "kind = \"formula\""),
                (
                    "matrix = [[-2.0, 0.0, 0.0], [2.0, -0.5, 0.0], [0.0, 0.5, 0.0]]",
                    "rates = [\"-2*parent\", \"2*parent - 0.5*u1\", \"0.5*daughter\"]",
                ),
                ("source = [0.0, 0.0, 0.0]", "#"),
            ],
        ),
    ] {
        let named = column(scenario(&text(name, &[]), changes), "f64", component);
        let given = column(scenario(&text(name, formulas), changes), "f64", component);
        let largest = named.iter().fold(0.0f64, |largest, u| largest.max(u.abs()));
        assert!(largest > 0.1, "{name}");
        for (k, (a, b)) in named.iter().zip(&given).enumerate() {
            assert!(
                (a - b).abs() < 1e-11 * largest,
                "{name}, particle {k}: {a}, {b}"
            );
        }
    }
}

/// What formulas compute is rounded once to the scalar: results differ by its rounding alone.
#[test]
fn formulas_run_in_every_scalar() {
    let l2 = |name: &str, scalar: &str| runs::run(name, scalar, 2, &[]).errors["state"].l2;
    for name in ["manufactured", "unsteady-diffusion"] {
        let exact = l2(name, "f64");
        assert!((l2(name, "f32") / exact - 1.0).abs() < 0.01, "{name}");
        if cfg!(feature = "fixed-point") {
            assert!((l2(name, "q31.32") / exact - 1.0).abs() < 0.01, "{name}");
        }
    }
}

#[test]
fn what_formulas_may_not_be_is_refused_with_the_place() {
    let page = include_str!("../docs/formulas.md");
    let examples = examples(page);
    for (text, change, words) in [
        (
            &examples[0],
            "profile.density=\"x - 0.5\"",
            "at t = 0 the density is -0.4",
        ),
        (
            &examples[0],
            "profile.pressure=\"-rho(x)\"",
            "the pressure is -1.",
        ),
        (
            &examples[0],
            "profile.velocity=[\"log(-x)\"]",
            "the velocity is NaN at x = [",
        ),
        (
            &examples[1],
            "initial.state=[\"1/0\", 0]",
            "at t = 0 u0 = inf at x = [0.00",
        ),
        (
            &examples[1],
            "define.c=\"sqrt(x - 1)\"",
            "at x = [0.0], t = 0: A^1[0][1] = NaN is not finite",
        ),
        (
            &examples[1],
            "system.flux=[[[0, \"c\"], [\"-c\", 0]]]",
            "at x = [0.0], t = 0: the system is not hyperbolic",
        ),
        (
            &examples[1],
            "motion.velocity=[\"sqrt(0.5 - x)\"]",
            "a velocity or its slope is NaN at x = [0.50",
        ),
        (
            &examples[1],
            "initial={ kind = \"manufactured\", state = [\"sqrt(0.2 - t)\", 0] }",
            "system.source is NaN at x = [0.0], t = 0.25",
        ),
        (
            &examples[2],
            "system.diffusivity=\"x - t\"",
            "the diffusivity of u is -",
        ),
    ] {
        let error = runs::try_experiment(scenario(text, &[change]), "f64", 1);
        let Err(error @ ExperimentError::Plan(_)) = error else {
            panic!("{change} is not refused as a plan");
        };
        assert!(error.to_string().contains(words), "{change}: {error}");
    }
}

#[test]
fn coefficients_that_jump_between_particles_are_told() {
    let examples = examples(include_str!("../docs/formulas.md"));
    for (text, change, words) in [
        (
            &examples[1],
            "define.c=\"if(x < 0.5, 1, 2)\"",
            "an entry of system.flux changes by 50 %",
        ),
        (
            &examples[2],
            "system.diffusivity=\"if(x < 3, 1, 5)\"",
            "system.diffusivity changes by 80 %",
        ),
    ] {
        let changes = [change, "initial.kind=formula", "time.end=0"];
        let text = text.replace("exact = \"initial\"", "samples = 1");
        let experiment = runs::experiment(scenario(&text, &changes), "f64", 1);
        assert_eq!(runs::told(&experiment, words).len(), 1, "{change}");
    }
}

/// A gas with a free end runs out into nothing, which the finite-volume reference does not.
#[test]
fn a_reference_that_the_ends_spoil_is_told() {
    let told = |lower: &str| {
        let experiment = runs::experiment(
            runs::any_scenario(
                "shu-osher",
                &[
                    lower,
                    "resolution.particles=400",
                    "time.end=0.5",
                    "output.window={ lower = [-6.0], upper = [4.0] }",
                ],
            ),
            "f64",
            2,
        );
        runs::told(&experiment, "gas runs out at the lower end").len()
    };
    assert_eq!(
        (told("domain.lower=[-8.0]"), told("domain.lower=[-9.0]")),
        (1, 0)
    );
}

/// Regions with formulas are the profile that says the same with `if`.
#[test]
fn regions_of_formulas_are_the_profile_that_chooses_among_them() {
    let text = &examples(include_str!("../docs/formulas.md"))[0];
    let (start, end) = (
        text.find("[profile]").unwrap(),
        text.find("[material]").unwrap(),
    );
    let with = |gas: &str| format!("{}{gas}{}", &text[..start], &text[end..]);
    let profile = with(
        "[profile]\nkind = \"formula\"\ndensity = \"if(x <= 0.5, rho(x), 2)\"\npressure = \"if(x <= 0.5, 1, 1 + x)\"\n",
    );
    let regions = with(
        "[[region]]\nlower = [0.0]\nupper = [0.5]\ndensity = \"rho(x)\"\nvelocity = [0]\npressure = 1\n\
         [[region]]\nlower = [0.5]\nupper = [1.0]\ndensity = 2\nvelocity = [0]\npressure = \"1 + x\"\n",
    );
    let digest = |text: &str| {
        runs::experiment(scenario(text, &[]), "f64", 2)
            .outcome
            .digest
    };
    assert_eq!(digest(&profile), digest(&regions));
}

/// A slab whose walls swing, against the series of its exact solution.
#[test]
fn walls_that_formulas_drive_give_the_known_solution() {
    let text = r#"
        name = "swinging-slab"
        dimension = 1
        [domain]
        lower = [0.0]
        upper = [1.0]
        sides = ["mirror"]
        [system]
        kind = "convection-diffusion"
        diffusivity = 0.1
        [[wall]]
        axis = "x"
        end = "lower"
        kind = "value"
        value = "sin(2*pi*t)"
        [[wall]]
        axis = "x"
        end = "upper"
        kind = "exchange"
        rate = 0.3
        outside = "1 - exp(-3*t)"
        [initial]
        kind = "uniform"
        state = [0.0]
        [resolution]
        particles = 200
        [cut-off]
        name = "quintic-spline"
        eta = 0.8
        [time]
        end = 1.0
        [output]
        exact = "initial"
    "#;
    for (scalar, form) in [("f64", "direct"), ("f64", "mixed"), ("f32", "direct")] {
        let form = format!("system.form={form}");
        let experiment = runs::experiment(scenario(text, &[&form]), scalar, 2);
        let error = experiment.errors.unwrap()["u"].l2;
        // As of walls that numbers drive: first order in the spacing next to them.
        assert!(error < 2e-3, "{scalar} {form}: {error}");
    }
}
