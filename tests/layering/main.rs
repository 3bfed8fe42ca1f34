//! Imports run one way: a folder may use those before it, never those after it, and no file one that
//! uses it.

mod imports;
mod words;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use imports::Crate;

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
const HOST: [&str; 14] = [
    "scalars",
    "run",
    "experiment",
    "study",
    "precision",
    "export",
    "io",
    "snapshots",
    "checkpoints",
    "benchmark",
    "report",
    "suite",
    "cli",
    "main",
];

/// What every file uses lies in its own layer or below.
fn check(root: &str, layers: &[&str]) {
    let sources = Crate::read(Path::new(root));
    let layer = |file: &Path| {
        let first = file.iter().next().unwrap().to_str().unwrap();
        let name = first.trim_end_matches(".rs");
        let place = layers.iter().position(|layer| *layer == name);
        // The root declares them all.
        (name != "lib").then(|| place.unwrap_or_else(|| panic!("{name} is in no layer: add it")))
    };
    let mut uses = 0;
    for (file, used) in sources.uses() {
        let own = layer(file);
        for used in used {
            let (Some(own), Some(place)) = (own, layer(used)) else {
                continue;
            };
            uses += 1;
            let (file, used) = (file.display(), used.display());
            assert!(
                place <= own,
                "{root}: {file} uses {used}, which is above it"
            );
        }
    }
    assert!(uses > 10, "the imports of {root} were not found");
}

/// Files of which each uses the others, by way of others.
fn circles(root: &str) -> Vec<BTreeSet<String>> {
    let sources = Crate::read(Path::new(root));
    let uses = sources.uses();
    let reached: BTreeMap<&Path, BTreeSet<&Path>> = uses
        .keys()
        .map(|&file| {
            let mut reached = BTreeSet::new();
            let mut open: Vec<&Path> = uses[file].iter().copied().collect();
            while let Some(next) = open.pop() {
                if reached.insert(next) {
                    open.extend(&uses[next]);
                }
            }
            (file, reached)
        })
        .collect();
    let circle = |file: &&Path| -> BTreeSet<String> {
        let both = reached[*file]
            .iter()
            .filter(|&&other| reached[other].contains(*file));
        both.map(|other| format!("{root}/{}", other.display()))
            .collect()
    };
    let circles: BTreeSet<BTreeSet<String>> = uses.keys().map(circle).collect();
    circles
        .into_iter()
        .filter(|circle| !circle.is_empty())
        .collect()
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

/// Circles that are there, a line each with the reason, the root and the files. The list must shrink:
/// a file that is in no circle any more leaves it, and none joins it.
const KNOWN: [(&str, &str, &[&str]); 13] = [
    (
        "a provided method of the trait works on what asks for the trait",
        "core/src/cutoff",
        &["mod.rs", "shape.rs"],
    ),
    (
        "the solver asks its physics, which sum over the solver's particles",
        "core/src/equation/gas",
        &["dynamics.rs", "physics.rs"],
    ),
    (
        "a scenario of any family is checked by each, and each by what all have in common",
        "host/scenario/src",
        &[
            "any.rs",
            "check.rs",
            "gas/inflow.rs",
            "gas/mod.rs",
            "gas/output.rs",
            "linear/mod.rs",
        ],
    ),
    (
        "an entry may be a section, a section has entries",
        "host/scenario/src",
        &["entry.rs", "section.rs"],
    ),
    (
        "the parent has what its parts share",
        "host/scenario/src/keys",
        &["gas.rs", "linear.rs", "mod.rs"],
    ),
    (
        "matrices, fields and tensors are read from what a system is written in",
        "host/scenario/src/linear",
        &[
            "diffusion.rs",
            "field.rs",
            "matrices.rs",
            "reaction.rs",
            "system.rs",
            "tensor.rs",
        ],
    ),
    (
        "the parent has what its parts share",
        "host/solver/src/engine",
        &["kernels.rs", "mod.rs"],
    ),
    (
        "the parent has what its parts share",
        "host/solver/src/exact/diffusion",
        &[
            "slab.rs",
            "slab/driven.rs",
            "slab/eigenmodes.rs",
            "slab/layers.rs",
        ],
    ),
    (
        "the parent has what its parts share",
        "host/solver/src/families",
        &["mod.rs", "table.rs"],
    ),
    (
        "the parent has what its parts share; a line is arranged, and so are its regions",
        "host/solver/src/setup",
        &[
            "arrange.rs",
            "cloud.rs",
            "deposit.rs",
            "line.rs",
            "mod.rs",
            "profile.rs",
            "regions.rs",
        ],
    ),
    (
        "the parent has what its parts share",
        "host/solver/src/symmetriser",
        &["mod.rs", "reason.rs"],
    ),
    (
        "the parent has what its parts share",
        "host/src/cli",
        &[
            "arguments.rs",
            "bench.rs",
            "compare.rs",
            "compare/formats.rs",
            "converge.rs",
            "export.rs",
            "inspect.rs",
            "list.rs",
            "mod.rs",
            "new.rs",
            "run.rs",
            "shell.rs",
            "suite.rs",
        ],
    ),
    (
        "the parent has what its parts share",
        "host/src/study",
        &["level.rs", "mod.rs"],
    ),
];

#[test]
fn no_file_uses_one_that_uses_it() {
    let roots = [
        "core/src",
        "host/scenario/src",
        "host/solver/src",
        "host/src",
    ];
    let found: Vec<BTreeSet<String>> = roots.into_iter().flat_map(circles).collect();
    let known = KNOWN.map(|(_, root, files)| -> BTreeSet<String> {
        files.iter().map(|file| format!("{root}/{file}")).collect()
    });
    for circle in &found {
        let is_known = known.iter().any(|known| circle.is_subset(known));
        assert!(is_known, "these use each other: {circle:#?}");
    }
    for file in known.iter().flatten() {
        let is_found = found.iter().any(|circle| circle.contains(file));
        assert!(is_found, "{file} is in no circle: take it off the list");
    }
}

#[test]
fn imports_of_every_kind_are_seen() {
    let sources = Crate::read(Path::new("core/src"));
    let uses = sources.uses();
    for (file, used) in [
        // `use super::law::{Fields, Law}`, by a name that law.rs has from elsewhere.
        ("pairs/half.rs", "pairs/record.rs"),
        // `use crate::neighbours::{Cells, Run}`, which mod.rs hands on.
        ("pairs/half.rs", "neighbours/runs.rs"),
        // `use crate::record`, an exported macro.
        ("equation/gas/density.rs", "pairs/record.rs"),
        // `use super::super::system::{..}`.
        (
            "equation/linear/systems/acoustics.rs",
            "equation/linear/system.rs",
        ),
        // `use binary::Binary`, of a module below.
        ("scalar/fixed_point.rs", "scalar/fixed_point/binary.rs"),
    ] {
        assert!(
            uses[Path::new(file)].contains(Path::new(used)),
            "{file} uses {used}"
        );
    }
    // It declares and hands on, and uses nothing.
    assert!(uses[Path::new("pairs/mod.rs")].is_empty());
}

#[test]
fn only_code_is_read() {
    let source = r##"
        use a::b; // use c::d;
        /* use e::f; /* use g::h; */ use i::j; */
        const TEXT: &'static str = "use k::l; \" use m::n;";
        const RAW: &str = r#"use o::p; " "#;
        const QUOTE: char = '"'; const SLASH: char = '\\';
        #[cfg(test)]
        mod tests { use q::r; fn f() { {} } }
        use s::t;
    "##;
    let words = words::words(source);
    let uses = words.iter().filter(|word| *word == "use").count();
    assert_eq!(
        (uses, words.contains(&"t".to_owned())),
        (2, true),
        "{words:?}"
    );
}
