//! `docs/paper.md` says where each equation is: it is there, and so is the test it names.

use std::fs::read_to_string;

#[test]
fn every_equation_is_where_the_map_says() {
    let map = read_to_string("docs/paper.md").unwrap();
    let mut rows = 0;
    let names = ["| (", "| Theorem", "| Remark"];
    for line in map
        .lines()
        .filter(|line| names.iter().any(|name| line.starts_with(name)) && line.contains(".rs"))
    {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [equation, _, file, test] = cells[..] else {
            panic!("a row of the map has equation, meaning, file and test: {line}");
        };
        let source = read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert!(source.contains(equation), "{file} does not name {equation}");
        let (test_file, name) = test.split_once("::").unwrap_or((test, ""));
        let tests =
            read_to_string(test_file).unwrap_or_else(|error| panic!("{test_file}: {error}"));
        let defined = [format!("fn {name}("), format!("macro_rules! {name} ")];
        assert!(
            !name.is_empty() && defined.iter().any(|text| tests.contains(text)),
            "{test_file} has no test {name}"
        );
        rows += 1;
    }
    assert!(rows >= 26, "the map has {rows} rows");
}

/// Every slip of the paper that was found is listed.
#[test]
fn all_slips_are_listed() {
    let map = read_to_string("docs/paper.md").unwrap();
    let slips = map.split("## Slips").nth(1).unwrap();
    for equation in ["(3.10)", "(3.11)", "(3.12)", "(4.6)", "(2.8)", "(1.21)"] {
        assert!(slips.contains(&format!("| {equation} |")), "{equation}");
    }
}
