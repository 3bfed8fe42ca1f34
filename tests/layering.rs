//! Imports run one way: a folder may use those before it, never those after it.

use std::path::{Path, PathBuf};

/// The layers of the core, lowest first.
const CORE: [&str; 12] = [
    "numbered",
    "error",
    "scalar",
    "digest",
    "cutoff",
    "domain",
    "neighbours",
    "pairs",
    "material",
    "cloud",
    "equation",
    "integrator",
];

/// The layers of the generic part of the host, lowest first; all of them lie above the scenarios.
const SOLVER: [&str; 10] = [
    "units",
    "sums",
    "symmetriser",
    "engine",
    "exact",
    "flows",
    "run",
    "setup",
    "families",
    "compiled",
];

/// The layers of the program, lowest first; all of them lie above the solver.
const HOST: [&str; 12] = [
    "scalars",
    "run",
    "experiment",
    "study",
    "export",
    "io",
    "snapshots",
    "benchmark",
    "report",
    "suite",
    "cli",
    "main",
];

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

/// Every `crate::LAYER` of a file lies in its own layer or below.
fn check(root: &str, layers: &[&str]) {
    let mut uses = 0;
    for file in sources(Path::new(root)) {
        let relative = file.strip_prefix(root).unwrap();
        let first = relative
            .components()
            .next()
            .unwrap()
            .as_os_str()
            .to_str()
            .unwrap();
        let layer = first.trim_end_matches(".rs");
        if layer == "lib" {
            continue;
        }
        let place = |name: &str| layers.iter().position(|layer| *layer == name);
        let own = place(layer).unwrap_or_else(|| panic!("{layer} is in no layer: add it here"));
        let text = std::fs::read_to_string(&file).unwrap();
        for part in text.split("crate::").skip(1) {
            let name: String = part
                .chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect();
            let Some(used) = place(&name) else { continue };
            uses += 1;
            assert!(used <= own, "{} uses crate::{name}", file.display());
        }
    }
    assert!(uses > 10, "the imports of {root} were not found");
}

#[test]
fn the_core_is_layered() {
    check("core/src", &CORE);
}

#[test]
fn the_solver_is_layered() {
    check("host/solver/src", &SOLVER);
}

#[test]
fn the_host_is_layered() {
    check("host/src", &HOST);
}
