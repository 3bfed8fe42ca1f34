//! The levels of a convergence study as a table.

use std::path::Path;

use super::table::{WriteError, whole};
use crate::study::Study;

/// Writes a row a level, the coarsest first: `n`, `h`, `eps`, the errors, and the order from the
/// level before in the norm of the study, which stays empty where there is none.
pub fn write_levels(path: &Path, study: &Study) -> Result<(), WriteError> {
    let orders = std::iter::once(None).chain(study.orders());
    whole(path, |file| {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["n", "h", "eps", "l1", "l2", "linf", "order"])?;
        for (level, order) in study.levels.iter().zip(orders) {
            let numbers = [level.h, level.eps, level.l1, level.l2, level.linf];
            let mut row = vec![level.n.to_string()];
            row.extend(numbers.map(|x| x.to_string()));
            row.push(order.map_or(String::new(), |order| order.to_string()));
            writer.write_record(row)?;
        }
        writer.flush()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::{ErrorNorm, Level};

    #[test]
    fn the_table_has_a_row_a_level_and_no_order_at_the_first() {
        let level = |n: usize| {
            let h = 1.0 / n as f64;
            Ok::<_, ()>(Level {
                n,
                h,
                eps: 1.5 * h,
                l1: h * h,
                l2: h,
                linf: 0.5,
            })
        };
        let study = Study::run(&[2, 4], ErrorNorm::L1, None, level).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("converge.csv");
        write_levels(&path, &study).unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        let expected = "n,h,eps,l1,l2,linf,order\n2,0.5,0.75,0.25,0.5,0.5,\n\
                        4,0.25,0.375,0.0625,0.25,0.5,2\n";
        assert_eq!(text, expected);
    }
}
