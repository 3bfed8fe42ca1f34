//! Systems that have a symmetriser.

use super::*;

/// Pressure and velocity, a background velocity, density and bulk modulus.
fn acoustics(dimension: usize, background: [f64; 3], density: f64, modulus: f64) -> Vec<Vec<f64>> {
    let p = dimension + 1;
    let along = |axis: usize| {
        let mut a = DMatrix::identity(p, p) * background[axis];
        a[(0, axis + 1)] = modulus;
        a[(axis + 1, 0)] = 1.0 / density;
        rows(&a)
    };
    (0..dimension).map(along).collect()
}

/// Density, velocity and pressure of a gas about a state, in two dimensions.
fn gas(density: f64, velocity: [f64; 2], pressure: f64, gamma: f64) -> Vec<Vec<f64>> {
    let along = |axis: usize| {
        let mut a = DMatrix::identity(4, 4) * velocity[axis];
        a[(0, 1 + axis)] = density;
        a[(1 + axis, 3)] = 1.0 / density;
        a[(3, 1 + axis)] = gamma * pressure;
        rows(&a)
    };
    vec![along(0), along(1)]
}

/// Depth and velocity of shallow water about a state.
fn shallow_water(depth: f64, velocity: [f64; 2], gravity: f64) -> Vec<Vec<f64>> {
    let [u, v] = velocity;
    vec![
        flat([[u, depth, 0.0], [gravity, u, 0.0], [0.0, 0.0, u]]),
        flat([[v, 0.0, depth], [0.0, v, 0.0], [gravity, 0.0, v]]),
    ]
}

/// Velocity v_x, v_y and stress σ_xx, σ_yy, σ_xy of an elastic solid.
fn elastic(density: f64, lambda: f64, mu: f64) -> Vec<Vec<f64>> {
    let (r, l, m) = (-1.0 / density, -lambda, -mu);
    let s = l + 2.0 * m;
    let o = 0.0;
    vec![
        flat([
            [o, o, r, o, o],
            [o, o, o, o, r],
            [s, o, o, o, o],
            [l, o, o, o, o],
            [o, m, o, o, o],
        ]),
        flat([
            [o, o, o, o, r],
            [o, o, o, r, o],
            [o, l, o, o, o],
            [o, s, o, o, o],
            [m, o, o, o, o],
        ]),
    ]
}

/// The Jacobian of the Euler equations in density, momentum and energy: one dimension.
fn conserved_gas(velocity: f64, sound: f64, gamma: f64) -> Vec<Vec<f64>> {
    let (u, g) = (velocity, gamma - 1.0);
    let enthalpy = sound * sound / g + 0.5 * u * u;
    vec![flat([
        [0.0, 1.0, 0.0],
        [0.5 * (gamma - 3.0) * u * u, (3.0 - gamma) * u, g],
        [
            u * (0.5 * g * u * u - enthalpy),
            enthalpy - g * u * u,
            gamma * u,
        ],
    ])]
}

#[test]
fn systems_of_physics_have_one_in_any_units_and_the_speed_of_their_waves() {
    let steel = libm::sqrt((1.1e11 + 2.0 * 8.2e10) / 7850.0);
    let cases: [(&str, Vec<Vec<f64>>, f64); 12] = [
        ("acoustics 1D", acoustics(1, [0.0; 3], 1.0, 4.0), 2.0),
        (
            "air 1D",
            acoustics(1, [0.0; 3], 1.2, 1.42e5),
            libm::sqrt(1.42e5 / 1.2),
        ),
        ("water 2D", acoustics(2, [0.0; 3], 1000.0, 2.25e9), 1500.0),
        ("acoustics 3D", acoustics(3, [0.0; 3], 0.25, 9.0), 6.0),
        ("in a wind", acoustics(2, [3.0, 4.0, 0.0], 1.0, 4.0), 7.0),
        (
            "telegraph",
            vec![flat([[0.0, 1.0 / 1e-10], [1.0 / 2.5e-7, 0.0]])],
            2e8,
        ),
        ("shallow water", shallow_water(10.0, [0.0; 2], 10.0), 10.0),
        ("a river", shallow_water(2.5, [6.0, -8.0], 10.0), 15.0),
        ("gas", gas(1.4, [0.0; 2], 1.0, 1.4), 1.0),
        ("hypersonic gas", gas(1.4, [0.0, 30.0], 1.0, 1.4), 31.0),
        ("conserved gas", conserved_gas(3.0, 1.0, 1.4), 4.0),
        ("steel", elastic(7850.0, 1.1e11, 8.2e10), steel),
    ];
    for (what, matrices, speed) in cases {
        let found = Symmetriser::of(&matrices).unwrap_or_else(|error| panic!("{what}: {error}"));
        assert_symmetrises(&found, &matrices, what);
        let margin = [1e-12, 3.1e-5, 4e-3][matrices.len() - 1];
        let ratio = found.speed / speed - 1.0;
        assert!(
            (-1e-12..margin).contains(&ratio),
            "{what}: {} for {speed}",
            found.speed
        );
    }
}

#[test]
fn the_energy_of_sound_is_found_up_to_its_factor() {
    // p²/K + ρ v²: P = diag(1/K, ρ, ρ) to trace 3.
    let (density, modulus) = (1000.0, 2.25e9);
    let found = Symmetriser::of(&acoustics(2, [0.0; 3], density, modulus)).unwrap();
    let trace = 1.0 / modulus + 2.0 * density;
    let expected = [1.0 / modulus, density, density].map(|x| 3.0 * x / trace);
    for (i, x) in expected.iter().enumerate() {
        let entry = found.matrix[4 * i];
        assert!((entry / x - 1.0).abs() < 1e-12, "{entry:e} for {x:e}");
    }
    let condition = density * modulus;
    assert!(
        (found.condition / condition - 1.0).abs() < 1e-12,
        "{}",
        found.condition
    );
}

#[test]
fn symmetric_matrices_have_the_identity_to_the_bit() {
    let mut random = Random(1);
    for (p, dimension) in [(1, 1), (2, 1), (3, 2), (5, 3), (8, 3)] {
        let symmetric = |_| {
            let a = random.matrix(p);
            rows(&(&a + a.transpose()))
        };
        let matrices: Vec<_> = (0..dimension).map(symmetric).collect();
        let found = Symmetriser::of(&matrices).unwrap();
        let identity: Vec<f64> = (0..p * p)
            .map(|k| f64::from(u8::from(k % (p + 1) == 0)))
            .collect();
        assert_eq!((found.matrix, found.condition), (identity, 1.0), "{p}");
    }
}

#[test]
fn random_symmetrisable_systems_are_always_found() {
    let mut random = Random(7);
    for round in 0..60 {
        let (p, dimension) = (2 + round % 7, 1 + round % 3);
        let root = random.matrix(p);
        // Eigenvalues from 0.03 to p.
        let made = &root * root.transpose() + DMatrix::identity(p, p) * 0.03;
        let inverse = made.clone().try_inverse().unwrap();
        let symmetric: Vec<_> = (0..dimension)
            .map(|_| random.matrix(p))
            .map(|s| &s + s.transpose())
            .collect();
        let matrices: Vec<_> = symmetric.iter().map(|s| rows(&(&inverse * s))).collect();
        let what = format!("round {round}, {dimension}D, p = {p}");
        let found = Symmetriser::of(&matrices).unwrap_or_else(|error| panic!("{what}: {error}"));
        assert_symmetrises(&found, &matrices, &what);
        // With p > 2 and more than one matrix there is no other: what made it is found.
        if p > 2 && dimension > 1 {
            let made = &made * (p as f64 / made.trace());
            let off = (DMatrix::from_row_slice(p, p, &found.matrix) - &made).norm();
            assert!(off < 1e-9 * made.norm(), "{what}: {off:e}");
        }
    }
}

#[test]
fn the_best_conditioned_of_a_space_is_found() {
    // Unknowns of a diagonal matrix seen in others: all P = T^-T diag T^-1 will do.
    // [[1, 1], [0, 2]] has the eigenvectors (1, 0), (1, 1): P = [[a, -a], [-a, a + b]]. With
    // trace 2a + b = 2 the determinant is a (2 - 2a): largest for a = 1/2, where
    // P = [[1, -1], [-1, 3]]/2 has the eigenvalues 1 -+ √2/2.
    let found = Symmetriser::of(&[flat([[1.0, 1.0], [0.0, 2.0]])]).unwrap();
    let expected = [0.5, -0.5, -0.5, 1.5];
    let best = (1.0 + libm::sqrt(0.5)) / (1.0 - libm::sqrt(0.5));
    assert!(
        (found.condition / best - 1.0).abs() < 1e-3,
        "{}",
        found.condition
    );
    for (x, expected) in found.matrix.iter().zip(expected) {
        assert!((x - expected).abs() < 0.05, "{:?}", found.matrix);
    }
    assert_eq!(found.speed, 2.0);
}

#[test]
fn systems_of_physics_are_found_in_any_unknowns() {
    let mut random = Random(11);
    for (what, matrices) in [
        ("acoustics", acoustics(3, [1.0, 0.0, 0.0], 0.25, 9.0)),
        ("elastic", elastic(2.0, 1.0, 3.0)),
        ("gas", gas(1.4, [0.5, 2.0], 1.0, 1.4)),
    ] {
        let p = matrices[0].len().isqrt();
        for _ in 0..5 {
            let basis = random.matrix(p) + DMatrix::identity(p, p);
            let inverse = basis.clone().try_inverse().unwrap();
            let seen = |a: &Vec<f64>| rows(&(&inverse * DMatrix::from_row_slice(p, p, a) * &basis));
            let seen: Vec<_> = matrices.iter().map(seen).collect();
            let found = Symmetriser::of(&seen).unwrap_or_else(|error| panic!("{what}: {error}"));
            assert_symmetrises(&found, &seen, what);
            let speed = Symmetriser::of(&matrices).unwrap().speed;
            assert!(
                (found.speed / speed - 1.0).abs() < 1e-9,
                "{what}: {}",
                found.speed
            );
        }
    }
}

#[test]
fn what_is_found_does_not_change_from_call_to_call() {
    let matrices = elastic(7850.0, 1.1e11, 8.2e10);
    assert_eq!(Symmetriser::of(&matrices), Symmetriser::of(&matrices));
}
