//! A gas has the density that its file says, in whatever arrangement it starts.

mod runs;

/// A box of gas in millimetres and tonnes.
fn uniform(arrangement: &str, dimension: usize, along: usize) -> String {
    let vector = |x: &str| vec![x; dimension].join(", ");
    let (none, side) = (vector("0.0"), vector("12.0"));
    let (particles, sides) = (along.pow(dimension as u32), vector("\"periodic\""));
    format!(
        "name = \"uniform\"\ndimension = {dimension}\n\
         [domain]\nlower = [{none}]\nupper = [{side}]\nsides = [{sides}]\n\
         [[region]]\nlower = [{none}]\nupper = [{side}]\ndensity = 7.8e-9\nvelocity = [{none}]\npressure = 0.1\n\
         [material]\nequation-of-state = \"ideal-gas\"\ngamma = 1.4\n\
         [resolution]\nparticles = {particles}\narrangement = \"{arrangement}\"\n[time]\nend = 1e-9\n"
    )
}

#[test]
fn the_density_at_the_start_is_that_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("uniform.toml");
    for (arrangement, dimension, along) in [
        ("equal-mass", 1, 40),
        ("square", 2, 24),
        ("hexagonal", 2, 24),
        ("glass", 2, 32),
        ("cubic", 3, 12),
        ("close-packed", 3, 12),
        ("glass", 3, 12),
    ] {
        std::fs::write(&file, uniform(arrangement, dimension, along)).unwrap();
        let scenario = runs::any_scenario(file.to_str().unwrap(), &[]);
        let simulation = runs::experiment(scenario, "f64", 1).simulation;
        let density = simulation.spread("density").unwrap().mean / 7.8e-9;
        assert!(
            (density - 1.0).abs() < 1e-3,
            "{arrangement} in {dimension}D: {density}"
        );
    }
}
