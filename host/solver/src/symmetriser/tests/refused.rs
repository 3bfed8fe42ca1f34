//! Systems that have none, and what is no system.

use super::*;

#[test]
fn a_rotation_is_not_hyperbolic() {
    let error = refusal(&[flat([[0.0, 1.0], [-1.0, 0.0]])]);
    let SymmetriserError::NotHyperbolic {
        direction,
        eigenvalue,
    } = &error
    else {
        panic!("{error:?}");
    };
    assert_eq!(direction, &[1.0]);
    assert!(eigenvalue[0].abs() < 1e-12 && (eigenvalue[1].abs() - 1.0).abs() < 1e-12);
    assert!(error.to_string().contains("[1.0]"), "{error}");
}

#[test]
fn a_cycle_is_not_hyperbolic_though_the_iteration_stands_still_on_it() {
    for p in [3, 4, 5, 8] {
        let cycle = DMatrix::from_fn(p, p, |i, j| f64::from(u8::from((i + 1) % p == j)));
        let error = refusal(&[rows(&cycle)]);
        let SymmetriserError::NotHyperbolic { eigenvalue, .. } = error else {
            panic!("{p}: {error:?}");
        };
        assert!(
            (libm::hypot(eigenvalue[0], eigenvalue[1]) - 1.0).abs() < 1e-9,
            "{eigenvalue:?}"
        );
    }
}

#[test]
fn a_jordan_block_is_not_diagonalisable_in_any_basis() {
    let direction = vec![1.0];
    let block = flat([[1.0, 1.0], [0.0, 1.0]]);
    let expected = SymmetriserError::NotDiagonalisable { direction };
    assert_eq!(refusal(&[block]), expected);
    let mut random = Random(3);
    for p in [2, 3, 5] {
        // A block of two, and eigenvalues apart from it.
        let mut block = DMatrix::from_fn(p, p, |i, j| if i == j { i as f64 } else { 0.0 });
        block[(1, 1)] = 0.0;
        block[(0, 1)] = 1.0;
        let basis = random.matrix(p) + DMatrix::identity(p, p) * 2.0;
        let seen = basis.clone().try_inverse().unwrap() * block * basis;
        assert_eq!(refusal(&[rows(&seen)]), expected, "{p}");
    }
}

#[test]
fn a_pair_that_is_hyperbolic_along_each_axis_only_is_refused_where_it_fails() {
    // n·A = [[c, s], [-s, 3s - c]]: the discriminant (2c - 3s)² - 4s² is negative for directions
    // about (3, 2).
    let (first, second) = (
        flat([[1.0, 0.0], [0.0, -1.0]]),
        flat([[0.0, 1.0], [-1.0, 3.0]]),
    );
    for single in [&first, &second] {
        assert!(Symmetriser::of(std::slice::from_ref(single)).is_ok());
    }
    let error = refusal(&[first, second]);
    let SymmetriserError::NotHyperbolic {
        direction,
        eigenvalue,
    } = error
    else {
        panic!("{error:?}");
    };
    let [c, s] = direction[..] else { panic!() };
    assert!((c * c + s * s - 1.0).abs() < 1e-14);
    let discriminant = (2.0 * c - 3.0 * s).powi(2) - 4.0 * s * s;
    assert!(discriminant < -1.0, "{direction:?}");
    assert!(
        (eigenvalue[1].powi(2) + 0.25 * discriminant).abs() < 1e-12,
        "{eigenvalue:?}"
    );
}

#[test]
fn a_pair_that_is_hyperbolic_along_an_axis_only_in_part_is_refused() {
    // Real eigenvalues everywhere, a Jordan block along y.
    let error = refusal(&[
        flat([[1.0, 0.0], [0.0, 1.0]]),
        flat([[0.0, 1.0], [0.0, 0.0]]),
    ]);
    assert_eq!(
        error,
        SymmetriserError::NotDiagonalisable {
            direction: vec![0.0, 1.0]
        }
    );
}

#[test]
fn a_strictly_hyperbolic_pair_that_nothing_symmetrises_is_refused_as_such() {
    // Spin one: n·A has the eigenvalues -1, 0, 1 for every n; a corner moves them by less than
    // their distance, so they stay real and apart. P must be diagonal, and then the corner is
    // not symmetric.
    let r = libm::sqrt(0.5);
    let error = refusal(&[
        flat([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, -1.0]]),
        flat([[0.0, r, 0.2], [r, 0.0, r], [0.0, r, 0.0]]),
    ]);
    assert_eq!(error, SymmetriserError::NotSymmetrisable);
}

#[test]
fn what_is_no_system_is_refused() {
    let square = vec![1.0; 4];
    for (matrices, entries) in [
        (vec![], 0),
        (vec![vec![]], 0),
        (vec![vec![1.0; 3]], 3),
        (vec![square.clone(), vec![1.0; 9]], 9),
        (vec![square.clone(); 4], 4),
    ] {
        let error = refusal(&matrices);
        let SymmetriserError::Shape { entries: told, .. } = error else {
            panic!("{error:?}");
        };
        assert_eq!(told, entries);
    }
    let mut broken = square;
    broken[2] = f64::INFINITY;
    let text = refusal(&[vec![1.0; 4], broken]).to_string();
    assert_eq!(text, "A^2[1][0] = inf is not finite");
}
