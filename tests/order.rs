//! The order of particles: two digests, of which one does not know it.

mod command;

use std::path::Path;

use command::stdout;
use serde_json::Value;

const GAS: &str = "name = \"order\"\ndimension = 2\n[domain]\nlower = [0.0, 0.0]\nupper = [1.0, 1.0]\n\
                   sides = [\"periodic\", \"mirror\"]\n[material]\nequation-of-state = \"ideal-gas\"\n\
                   gamma = 1.4\n[resolution]\narrangement = \"file\"\nfile = \"cloud.csv\"\n\
                   [time]\nend = 0.05\n";
const TRACER: &str = "name = \"order\"\ndimension = 2\n[domain]\nlower = [0.0, 0.0]\n\
                      upper = [1.0, 1.0]\nsides = [\"periodic\", \"mirror\"]\n[system]\n\
                      kind = \"convection-diffusion\"\ndiffusivity = 0.1\n[resolution]\n\
                      arrangement = \"file\"\nfile = \"cloud.csv\"\n[cut-off]\nepsilon = 0.1\n\
                      [time]\nend = 0.05\n";

/// Points of a lattice, moved a little, in an order that `stride`, without a factor in common with 196,
/// gives; all masses unequal unless told.
fn cloud(folder: &Path, stride: usize, is_alike: bool) {
    let row = |place: usize| {
        let id = place * stride % 196;
        let (i, j) = (id / 14, id % 14);
        let off = |k: usize| 0.02 * ((k * k % 7) as f64 / 7.0 - 0.5);
        let x = (i as f64 + 0.5) / 14.0 + off(id + 1);
        let y = (j as f64 + 0.5) / 14.0 + off(3 * id + 2);
        let part = if is_alike { 0.0 } else { 1e-4 * id as f64 };
        let mass = (1.0 + part) / 196.0;
        format!(
            "{x},{y},{},0.1,{mass},2.5,{mass},{}\n",
            0.3 * part,
            1.0 + part
        )
    };
    let rows: String = (0..196).map(row).collect();
    let heading = "position_x,position_y,velocity_x,velocity_y,mass,energy,weight,u";
    std::fs::write(folder.join("cloud.csv"), format!("{heading}\n{rows}")).unwrap();
}

fn digests(folder: &Path, text: &str, scalar: &str) -> [String; 2] {
    std::fs::write(folder.join("mine.toml"), text).unwrap();
    let arguments = ["run", "mine.toml", "--json", "--scalar", scalar];
    let json: Value = serde_json::from_str(&stdout(folder, &arguments)).unwrap();
    ["digest", "digest_unordered"].map(|key| json[key].as_str().unwrap().to_owned())
}

/// In fixed point sums do not depend on the order of their terms: the rows of a shuffled cloud are the
/// same, and so is the sum of their digests.
#[cfg(feature = "fixed-point")]
#[test]
fn a_shuffled_cloud_has_the_same_unordered_digest_in_fixed_point() {
    let folder = tempfile::tempdir().unwrap();
    for (text, scalar) in [(GAS, "q12.19"), (GAS, "q31.32"), (TRACER, "q12.19")] {
        let [first, second, third] = [1, 5, 145].map(|stride| {
            cloud(folder.path(), stride, false);
            digests(folder.path(), text, scalar)
        });
        assert_ne!(first[0], second[0], "{scalar}");
        assert_eq!(first[1], second[1], "{scalar}");
        assert_eq!(first[1], third[1], "{scalar}");
        // Another cloud has another.
        cloud(folder.path(), 1, true);
        assert_ne!(digests(folder.path(), text, scalar)[1], first[1]);
    }
}

/// In floats sums depend on the order of their terms, which is that of cells and, inside a cell, of ids:
/// a run again has both digests, another cloud neither.
#[test]
fn in_floats_a_run_again_has_both_digests_and_another_cloud_neither() {
    let folder = tempfile::tempdir().unwrap();
    for text in [GAS, TRACER] {
        cloud(folder.path(), 1, false);
        let first = digests(folder.path(), text, "f64");
        assert_eq!(digests(folder.path(), text, "f64"), first);
        assert_ne!(first[0], first[1]);
        cloud(folder.path(), 1, true);
        let other = digests(folder.path(), text, "f64");
        assert!(other[0] != first[0] && other[1] != first[1]);
    }
}
