//! What comes in through walls, as runs tell it: in the time series, in JSON and in the summary; and
//! layers, which are resistances however thin.

mod runs;

use motes::experiment::{Experiment, ExperimentError};
use motes::report::summary::Summary;
use motes::scenario::{AnyScenario, Source};

/// A box of length 100 each way between walls.
fn made(dimension: usize, parts: &str, changes: &[&str]) -> Result<Experiment, ExperimentError> {
    made_in("f64", dimension, parts, changes)
}

fn made_in(
    scalar: &str,
    dimension: usize,
    parts: &str,
    changes: &[&str],
) -> Result<Experiment, ExperimentError> {
    let of = |part: &str| vec![part; dimension].join(", ");
    let (lower, upper, sides) = (of("-50.0"), of("50.0"), of("\"mirror\""));
    let text = format!(
        "name = \"box\"\ndescription = \"between walls\"\ndimension = {dimension}\n\
         [domain]\nlower = [{lower}]\nupper = [{upper}]\nsides = [{sides}]\n\
         [system]\nkind = \"convection-diffusion\"\n{parts}\n"
    );
    let changes: Vec<String> = changes.iter().map(|&change| change.to_owned()).collect();
    let scenario = AnyScenario::read(Source::Text(text), &changes).unwrap();
    runs::try_experiment(scenario, scalar, 2)
}

fn column(experiment: &Experiment, name: &str) -> Vec<f64> {
    let column = experiment.outcome.series.of(name);
    assert!(!column.is_empty(), "no column {name}");
    column
}

/// Two species, one of which decays into the other, through walls of every kind.
const MANY: &str = r#"
species = ["a", "b"]
diffusivity = [30.0, 50.0]
reaction = { kind = "linear", matrix = [[-0.1, 0.0], [0.1, -0.02]], source = [0.0, 0.0] }
[[wall]]
axis = "x"
end = "lower"
kind = "flux"
flux = -3.0
species = "a"
[[wall]]
axis = "x"
end = "upper"
kind = "exchange"
rate = 2.0
outside = -1.0
[[wall]]
axis = "y"
end = "lower"
kind = "value"
value = 4.0
species = "b"
[initial]
kind = "uniform"
state = [2.0, 1.0]
[resolution]
particles = 400
[time]
end = 5.0
[output]
samples = 10
"#;

/// At every row of the series the sum of each species is what it was, and what has come in since.
#[test]
fn the_series_balances() {
    for form in ["direct", "mixed"] {
        for epsilon in ["3.7", "6.0"] {
            let form = format!("system.form={form}");
            let epsilon = format!("cut-off.epsilon={epsilon}");
            let experiment = made(2, MANY, &[&form, &epsilon]).unwrap();
            for (species, walls) in [
                ("a", &["inflow_x_lower_a", "inflow_x_upper_a"]),
                ("b", &["inflow_x_upper_b", "inflow_y_lower_b"]),
            ] {
                let total = column(&experiment, &format!("total_{species}"));
                let reacted = column(&experiment, &format!("reactions_{species}"));
                let inflows = walls.map(|wall| column(&experiment, wall));
                for i in 0..total.len() {
                    let came = reacted[i] + inflows[0][i] + inflows[1][i];
                    let off = total[i] - total[0] - came;
                    assert!(off.abs() < 1e-11 * total[0], "{form} {species} {i}: {off}");
                }
                assert!(inflows.iter().flatten().all(|inflow| inflow.is_finite()));
                assert!(inflows[0].last().unwrap().abs() > 1.0);
            }
            // Flux times area times time: 3 x 100 x 5.
            let given = column(&experiment, "inflow_x_lower_a");
            assert!((given.last().unwrap() / 1500.0 - 1.0).abs() < 1e-12);
            // A closed wall has its column too.
            let closed = column(&experiment, "inflow_y_upper_a");
            assert!(closed.iter().all(|inflow| *inflow == 0.0));
        }
    }
}

/// JSON has for each species what its sum changed by, and why.
#[test]
fn json_and_summary_have_the_balance() {
    let experiment = made(2, MANY, &[]).unwrap();
    let summary = Summary::new(&experiment, "f64", 2);
    let json = serde_json::to_value(&summary).unwrap();
    let balance = json["balance"].as_array().unwrap();
    assert_eq!(balance.len(), 2);
    let of = |value: &serde_json::Value| value.as_f64().unwrap();
    let first = &balance[0];
    assert_eq!(first["component"], "a");
    let walls = of(&first["walls"]["x_lower"]) + of(&first["walls"]["x_upper"]);
    let off = of(&first["change"]) - walls - of(&first["reactions"]);
    assert!(off.abs() < 1e-7 && off == of(&first["residual"]), "{off}");
    assert!(summary.to_string().contains("\nbalance    a "));
    // Nothing to say where there is no wall.
    let ring = runs::experiment(runs::any_scenario("advection-dominated", &[]), "f64", 1);
    let json = serde_json::to_value(Summary::new(&ring, "f64", 1)).unwrap();
    assert!(json.get("balance").is_none());
}

/// What reacts in all particles together no number of the format holds; and what grows beyond the format
/// is refused, by every method.
#[cfg(feature = "fixed-point")]
#[test]
fn large_reactions_are_counted_or_refused_in_fixed_point() {
    const GROWTH: &str = "diffusivity = 100.0\n\
         reaction = { kind = \"logistic\", rate = 3.0, capacity = 8000.0 }\n\
         [initial]\nkind = \"uniform\"\nstate = [1000.0]\n\
         [resolution]\nparticles = 40\n[time]\nend = 5.0\n";
    let experiment = made_in("q15.16", 1, GROWTH, &[]).unwrap();
    let total = column(&experiment, "total_u");
    let reacted = column(&experiment, "reactions_u");
    for i in 0..total.len() {
        let off = total[i] - total[0] - reacted[i];
        assert!(off.abs() < 1e-5 * total[i], "{i}: {off} of {}", total[i]);
    }
    assert!(total.last().unwrap() > &(7.0 * total[0]));
    for method in ["rkl2", "rk4"] {
        let method = format!("time.method={method}");
        let linear = "system.reaction={kind=\"linear\",matrix=[[2.0]],source=[0.0]}";
        let error = made_in("q15.16", 1, GROWTH, &[&method, linear])
            .err()
            .unwrap();
        let message = error.to_string();
        assert!(message.contains("range of the number format"), "{message}");
    }
}

/// A sheet of insulation between two slabs, of that thickness, held at 30 and 10; flux and temperatures at
/// its faces are those of resistances in series.
fn sheet(thickness: f64, contrast: f64, dimension: usize, changes: &[&str]) -> Result<f64, String> {
    let (lower, upper) = (7.3 - 0.5 * thickness, 7.3 + 0.5 * thickness);
    let parts = format!(
        "diffusivity = 40.0\n\
         profile = {{ kind = \"layers\", bounds = [{lower}, {upper}], factors = [1.0, {contrast}, 1.0] }}\n\
         [[wall]]\naxis = \"x\"\nend = \"lower\"\nkind = \"value\"\nvalue = 30.0\n\
         [[wall]]\naxis = \"x\"\nend = \"upper\"\nkind = \"value\"\nvalue = 10.0\n\
         [initial]\nkind = \"uniform\"\nstate = [20.0]\n\
         [resolution]\nparticles = {}\n[time]\nend = 2000.0\nstages = 101\n",
        60u32.pow(dimension as u32)
    );
    let experiment = made(dimension, &parts, changes).map_err(|error| error.to_string())?;
    let resistance = (100.0 - thickness + thickness / contrast) / 40.0;
    let flux = 20.0 / resistance;
    let expected = |x: f64| match x < 7.3 {
        true => 30.0 - flux * (x + 50.0) / 40.0,
        false => 10.0 + flux * (50.0 - x) / 40.0,
    };
    let places = match dimension {
        1 => experiment.simulation.column("position").unwrap(),
        _ => experiment.simulation.column("position_x").unwrap(),
    };
    let values = experiment.simulation.column("u").unwrap();
    let outside = places.iter().zip(values);
    let outside = outside.filter(|(x, _)| (**x - 7.3).abs() > 0.5 * thickness);
    Ok(outside.fold(0.0f64, |worst, (&x, u)| worst.max((u - expected(x)).abs())) / 20.0)
}

#[test]
fn a_sheet_of_any_thickness_is_a_resistance() {
    // The spacing is 1.67.
    for (thickness, contrast) in [(0.1, 1e-3), (0.7, 1e-3), (3.0, 0.01), (3.0, 1e-3)] {
        let off = sheet(thickness, contrast, 1, &[]).unwrap();
        assert!(off < 1e-3, "{thickness}, {contrast}: {off}");
    }
}

/// What would jump over it is refused, and the cure is named.
#[test]
fn what_would_jump_over_a_sheet_is_refused() {
    for change in ["system.form=mixed", "system.mean=arithmetic"] {
        let error = sheet(1.0, 1e-3, 1, &[change]).unwrap_err();
        assert!(error.contains("of what they resist"), "{error}");
    }
    // Thick layers are not.
    assert!(sheet(60.0, 0.5, 1, &["system.mean=arithmetic"]).is_ok());
}
