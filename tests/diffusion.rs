//! Convection-diffusion as it is shipped: accuracy in f64 and f32, both forms, the same bits on any
//! number of threads, sums, walls, steps, and what is told of doubtful results.

mod systems;

use motes::experiment::Experiment;
use motes::run::RunError;
use systems::{
    assert_same_bits, assert_tolerances, built_in, errors, experiment, run, scenario, stopped, told,
};

fn done(name: &str, changes: &[&str]) -> Experiment {
    experiment(scenario(name, changes), "f64", 2).unwrap()
}

/// The smallest and the largest value of a component at the end.
fn range(experiment: &Experiment, component: &str) -> (f64, f64) {
    let spread = experiment.simulation.spread(component).unwrap();
    (spread.min, spread.max)
}

/// The name of a component.
fn component(experiment: &Experiment, number: usize) -> String {
    let mut fields = experiment.simulation.description().compared();
    fields.nth(number).unwrap().name.clone()
}

/// The values of a one-dimensional run: places, and the first component.
fn profile(experiment: &Experiment) -> (Vec<f64>, Vec<f64>) {
    let column = |name: &str| experiment.simulation.column(name).unwrap();
    (column("position"), column(&component(experiment, 0)))
}

#[test]
fn every_problem_keeps_its_tolerance_in_f64_and_f32() {
    let all = built_in(true);
    assert_eq!(all.len(), 13);
    for scenario in all
        .iter()
        .filter(|scenario| scenario.output.exact.is_some())
    {
        assert_tolerances(scenario);
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for scenario in &built_in(true) {
        let end = format!("time.end={:e}", scenario.time.end / 50.0);
        for form in ["system.form=direct", "system.form=mixed"] {
            assert_same_bits(scenario, &["resolution.particles=900", &end, form]);
        }
    }
}

/// On an uneven cloud, epsilon = 0.7 h^0.75: both forms converge as the cut-off does, `r theta = 1.5`.
#[test]
fn both_forms_have_the_predicted_order() {
    for form in ["direct", "mixed"] {
        let form = format!("system.form={form}");
        let counts = [1296u32, 2916, 6561];
        let errors = counts.map(|count| {
            let count = format!("resolution.particles={count}");
            errors("heat2d", "f64", &[&form, &count])["state"].l2
        });
        // From each to the next the spacing is two thirds.
        let order = (errors[0] / errors[2]).ln() / 2.25f64.ln();
        assert!(
            (order - 1.5).abs() < 0.2,
            "{form}: {errors:?}, order {order}, expected 1.5"
        );
    }
}

#[test]
fn sums_are_conserved_to_rounding() {
    for (name, scalar, bound) in [
        ("heat1d", "f64", 1e-14),
        ("heat2d", "f64", 1e-14),
        ("shear-gaussian", "f64", 1e-14),
        ("variable-diffusivity", "f64", 1e-14),
        ("heat1d", "f32", 1e-6),
    ] {
        for form in ["system.form=direct", "system.form=mixed"] {
            let outcome = run(name, scalar, 2, &[form]);
            assert!(outcome.is_conserving, "{name}");
            let drift = outcome.drift[0].1;
            assert!(drift.abs() < bound, "{name} {form} in {scalar}: {drift}");
        }
    }
    // What comes in through a wall, or reacts, is no drift.
    for name in ["robin-wall", "decay-chain", "gray-scott"] {
        let short = format!("time.end={}", scenario(name, &[]).time.end / 100.0);
        let few = ["resolution.particles=400", &short];
        assert!(!run(name, "f64", 1, &few).is_conserving, "{name}");
    }
}

#[cfg(feature = "fixed-point")]
#[test]
fn in_fixed_point_the_sums_of_runge_kutta_steps_are_exact() {
    for scalar in ["q12.19", "q15.16", "q31.32"] {
        for method in ["time.method=ssp-rk3", "time.method=rk4"] {
            for form in ["system.form=direct", "system.form=mixed"] {
                let scenario = scenario("heat1d", &[method, form]);
                let experiment = experiment(scenario, scalar, 2).unwrap();
                assert!(experiment.outcome.is_conserving);
                let drift: Vec<f64> = experiment.outcome.drift.iter().map(|(_, x)| *x).collect();
                assert_eq!(drift, [0.0], "{scalar}");
                let error = experiment.errors.unwrap()["state"].l2;
                assert!(error < 5e-3, "{scalar} {method} {form}: {error}");
            }
        }
    }
}

/// A band carried around a ring: no wiggles at any Peclet number, and without diffusion nothing is
/// smeared at all.
#[test]
fn fronts_stay_sharp_and_smooth_at_every_peclet_number() {
    for diffusivity in ["1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "0"] {
        let changed = format!("system.diffusivity={diffusivity}");
        let experiment = done("advection-dominated", &[&changed]);
        let (smallest, largest) = range(&experiment, &component(&experiment, 0));
        assert!(
            smallest >= -1e-12 && largest <= 1.0 + 1e-12,
            "b = {diffusivity}: {smallest} to {largest}"
        );
        let error = experiment.errors.unwrap()["state"].linf;
        let bound = if diffusivity == "0" { 1e-12 } else { 3e-3 };
        assert!(error < bound, "b = {diffusivity}: {error}");
    }
}

/// Through a jump of the diffusivity by ten the steady flux is the same on both sides: that of the
/// two resistances in series.
#[test]
fn the_flux_through_layers_is_continuous() {
    let (positions, values) = profile(&done("layered-wall", &["time.end=20"]));
    let at = |x: f64| {
        let near = positions.iter().position(|p| *p > x).unwrap();
        (positions[near], values[near])
    };
    let flux = |lower: f64, upper: f64, b: f64| {
        let ((x, u), (y, v)) = (at(lower), at(upper));
        -b * (v - u) / (y - x)
    };
    // 1/(1/0.1 + 1/1).
    let expected = 1.0 / 11.0;
    for (lower, upper, b) in [(-0.9, -0.1, 0.1), (0.1, 0.9, 1.0)] {
        let flux = flux(lower, upper, b);
        let off = (flux / expected - 1.0).abs();
        assert!(off < 1e-5, "from {lower} to {upper}: {flux}, {expected}");
    }
}

/// Spots of v grow into a pattern that fills a part of the square, within the bounds of the
/// reaction.
#[test]
fn gray_scott_makes_a_pattern() {
    let few = ["resolution.particles=4096", "time.end=1000"];
    let experiment = experiment(scenario("gray-scott", &few), "f32", 2).unwrap();
    let names = [0, 1].map(|number| component(&experiment, number));
    for name in &names {
        let (smallest, largest) = range(&experiment, name);
        assert!(smallest > -1e-3 && largest < 1.001, "{smallest} {largest}");
    }
    let covered = experiment.outcome.series.of(&format!("total_{}", names[1]));
    let growth = covered.last().unwrap() / covered[0];
    assert!(growth > 2.0, "v grew by {growth} only");
    let (_, largest) = range(&experiment, &names[1]);
    assert!(largest > 0.25, "no stripes: v <= {largest}");
}

/// A state of waves of two spacings: the mixed form keeps it and says so, the direct form has damped
/// it.
#[test]
fn waves_that_the_mixed_form_does_not_see_are_told() {
    let told = |form: &str| {
        let changes = ["initial.width=0.008", "time.end=0.01", form];
        let experiment = done("heat1d", &changes);
        let told = experiment.doubts.join(" ").contains("mixed form");
        (told, experiment.outcome.undamped)
    };
    let (warned, undamped) = told("system.form=mixed");
    assert!(warned && undamped > 0.1, "{undamped}");
    assert_eq!(told("system.form=direct"), (false, 0.0));
    // A state that is resolved is not complained of.
    let smooth = done("heat1d", &["system.form=mixed"]);
    assert!(
        smooth.outcome.undamped < 2e-3,
        "{}",
        smooth.outcome.undamped
    );
    assert_eq!(smooth.doubts, [""; 0]);
}

/// What turns species into one another for ever takes no energy and gives none: a step that is too long
/// for it is found out, and one that is not is accurate.
#[test]
fn a_reaction_that_turns_is_made_or_refused() {
    let turn = "system.reaction.matrix=[[0.0,100.0,0.0],[-100.0,0.0,0.0],[0.0,0.0,0.0]]";
    let run = |step: &str| {
        let changes = [turn, "system.diffusivity=0.01", step];
        experiment(scenario("decay-chain", &changes), "f64", 1)
    };
    let error = stopped(run("time.step=0.02"));
    assert!(matches!(error, RunError::Growth { .. }), "{error}");
    let errors = run("time.step=0.001").unwrap().errors.unwrap();
    assert!(errors["state"].l2 < 5e-2, "{errors:?}");
}

/// A number that drives a wall and that the format does not hold is refused, not cut off.
#[cfg(feature = "fixed-point")]
#[test]
fn what_drives_a_wall_fits_the_format() {
    let hot = scenario("layered-wall", &["wall.0.value=1e5"]);
    let error = experiment(hot, "q12.19", 1).err().unwrap().to_string();
    assert!(error.contains("what drives a wall is 1.000e5"), "{error}");
}

/// Steps may be given: the stages follow from b, epsilon and the step, and the error is that of a
/// method of second order.
#[test]
fn stages_follow_from_the_step() {
    let with = |step: &str| {
        let outcome = run("decay-chain", "f64", 1, &[step]);
        (outcome.evaluations / outcome.steps, outcome)
    };
    let (few, fine) = with("time.step=0.01");
    let (many, coarse) = with("time.step=0.04");
    // s² grows with the step.
    let ratio = (many * many) as f64 / (few * few) as f64;
    assert!((2.0..6.0).contains(&ratio), "{few} and {many} stages");
    assert!(coarse.steps < fine.steps);
    let long = scenario("heat1d", &["time.method=rk4", "time.step=0.1"]);
    let RunError::Step { limit, .. } = stopped(experiment(long, "f64", 1)) else {
        panic!("a step of 0.1 is not stable");
    };
    let below = format!("time.step={}", 0.99 * limit);
    run("heat1d", "f64", 1, &["time.method=rk4", &below]);
}

/// For an error that is a sixth larger, the one of space alone, the stabilised method takes less than a
/// tenth of the right-hand sides of SSP-RK3 where diffusion is stiff.
#[test]
fn the_stabilised_method_saves_nine_tenths_of_the_work() {
    let stiff = |changes: &[&str]| {
        let experiment = done("layered-wall", changes);
        let error = experiment.errors.unwrap()["state"].l2;
        (experiment.outcome.evaluations, error)
    };
    let (stabilised, error) = stiff(&["time.step=0.04"]);
    let (explicit, reference) = stiff(&["time.method=ssp-rk3", "time.courant=1"]);
    println!(
        "right-hand sides: {stabilised} of RKL2 with an error of {error:.2e}, {explicit} of SSP-RK3 \
         with {reference:.2e}"
    );
    assert!(error < 8e-6, "{error} against {reference}");
    assert!(error < 1.17 * reference, "{error} against {reference}");
    assert!(
        10 * stabilised <= explicit,
        "{stabilised} against {explicit}"
    );
}

/// The wall in the weather: the exact solution at its face, driven by the same series.
#[test]
fn a_wall_follows_a_measured_series() {
    let experiment = done("wall-day", &[]);
    let exact = experiment.exact.as_ref().unwrap();
    let (positions, values) = profile(&experiment);
    let rows = positions.iter().zip(&values);
    let worst = rows.fold(0.0f64, |worst, (&x, value)| {
        let exact = exact.at([x, 0.0, 0.0], experiment.outcome.time)[0];
        worst.max((value - exact).abs())
    });
    assert!(worst < 0.05, "{worst} degrees");
    // The weather has come through: the wall is not what it was without.
    let (_, calm) = profile(&done("wall-day", &["wall.0.rate=0"]));
    let moved = (calm[0] - values[0]).abs();
    assert!(moved > 1.0, "{moved}");
}

/// Diffusion makes nothing that there was not. The mixed form of a sharp band does; the direct form,
/// a source or a flux that brings more in give no cause to say so.
#[test]
fn a_state_beyond_the_maximum_principle_is_told() {
    let beyond = |name: &str, changes: &[&str]| {
        let experiment = done(name, changes);
        told(&experiment, "diffusion alone")
    };
    let narrow = ["initial.width=0.01"];
    let mixed = beyond("heat1d", &[&narrow[..], &["system.form=mixed"]].concat());
    assert_eq!(mixed.len(), 1, "{mixed:?}");
    assert!(
        mixed[0].contains("below the") && mixed[0].contains("direct"),
        "{mixed:?}"
    );
    assert_eq!(beyond("heat1d", &narrow), Vec::<String>::new());
    for name in [
        "heat1d",
        "wall-day",
        "robin-wall",
        "layered-wall",
        "decay-chain",
    ] {
        assert_eq!(beyond(name, &[]), Vec::<String>::new(), "{name}");
    }
}

/// Of a state of a thousandth a format with sixteen fractional bits holds but two digits, and says so.
#[cfg(feature = "fixed-point")]
#[test]
fn values_of_which_a_format_holds_few_digits_are_told() {
    let told = |name: &str, scalar: &str, changes: &[&str]| {
        let experiment = experiment(scenario(name, changes), scalar, 1).unwrap();
        told(&experiment, "last place")
    };
    let small = told("heat1d", "q15.16", &["initial.amplitude=1e-3"]);
    assert_eq!(small.len(), 1, "{small:?}");
    assert!(small[0].starts_with("u is at most 9.9"), "{small:?}");
    let none = Vec::<String>::new();
    assert_eq!(told("heat1d", "q15.16", &[]), none);
    assert_eq!(told("heat1d", "q31.32", &["initial.amplitude=1e-3"]), none);
    assert_eq!(told("heat1d", "f32", &["initial.amplitude=1e-3"]), none);
    for name in ["acoustics1d", "telegraph", "wall-day"] {
        assert_eq!(told(name, "q15.16", &[]), none, "{name}");
    }
}
