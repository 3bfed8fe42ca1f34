//! The grid of cells, in boxes that are almost too short for it.

use motes_core::domain::{Axis, Domain, Side};
use motes_core::error::Error;
use motes_core::neighbours::Grid;

fn axis(length: f64, sides: [Side; 2]) -> Axis<f64> {
    Axis {
        lower: 0.0,
        upper: length,
        sides,
    }
}

/// What becomes of two particles in a box with these sides in y, free in x.
fn fit(sides: [Side; 2], length: f64, far: f64, reach: f64) -> Result<Grid<f64, 2>, Error> {
    let domain = Domain {
        axes: [axis(far, [Side::Free; 2]), axis(length, sides)],
    };
    Grid::fit(
        &domain,
        &[[0.0, 0.25 * length], [far, 0.75 * length]],
        reach,
    )
}

/// A particle at one wall meets its image behind the other from one length on.
#[test]
fn walls_nearer_than_one_reach_are_refused() {
    let walls = [Side::Mirror; 2];
    let refused = Err(Error::WallsTooNear { axis: 1 });
    assert!(fit(walls, 2.0, 1.0, 1.96).is_ok());
    assert_eq!(fit(walls, 2.0, 1.0, 2.01).map(|_| ()), refused);
    // One wall has no image of an image.
    assert!(fit([Side::Mirror, Side::Free], 2.0, 1.0, 2.01).is_ok());
}

#[test]
fn periods_below_three_reaches_are_refused() {
    let period = [Side::Periodic; 2];
    let refused = Err(Error::PeriodTooShort { axis: 1 });
    assert!(fit(period, 6.0, 1.0, 1.96).is_ok());
    assert_eq!(fit(period, 6.0, 1.0, 2.01).map(|_| ()), refused);
}

/// Cells that grow because there are few particles grow along the free direction only: a third
/// of the period, four cells, is as much as a reach needs.
#[test]
fn a_sparse_cloud_does_not_shorten_its_period() {
    let grid = fit([Side::Periodic; 2], 4.0, 10_000.0, 1.0).unwrap();
    assert_eq!(grid.count(1), 12);
    assert!(grid.count(0) >= 4 && grid.cells() <= 4 * 2 + 128);
}
