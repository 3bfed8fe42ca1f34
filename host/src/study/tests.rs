//! Orders, predictions and warnings of made-up errors.

use super::*;

/// A level with errors that a function of h gives.
fn level(n: usize, error: impl Fn(f64) -> f64) -> Level {
    let h = 1.0 / n as f64;
    Level {
        n,
        h,
        eps: 0.7 * h.powf(0.75),
        l1: error(h),
        l2: 2.0 * error(h),
        linf: 3.0 * error(h).sqrt(),
    }
}

fn study(counts: &[usize], theory: Option<Theory>, error: impl Fn(f64) -> f64) -> Study {
    let level = |n| Ok::<_, ()>(level(n, &error));
    Study::run(counts, ErrorNorm::L2, theory, level).unwrap()
}

/// The quintic spline: m = 4, s = 1.
const M6: Theory = Theory {
    order_r: 2,
    smoothness: 5,
    theta: 0.75,
};

#[test]
fn an_exact_power_gives_its_exact_order_between_all_and_any_levels() {
    for order in [0.5, 1.0, 1.5, 2.0, 4.0] {
        let mut study = study(&[32, 64, 128, 256], None, |h| 5.0 * h.powf(order));
        let fit = study.fit().unwrap();
        assert!((fit.exponent - order).abs() < 1e-12, "{fit:?}");
        assert!((fit.factor / 10.0 - 1.0).abs() < 1e-12, "{fit:?}");
        assert!((fit.at(0.01) / (10.0 * 0.01f64.powf(order)) - 1.0).abs() < 1e-12);
        assert_eq!(study.orders().len(), 3);
        for local in study.orders() {
            assert!((local.unwrap() - order).abs() < 1e-12);
        }
        assert_eq!(study.warnings(), [""; 0]);
        study.norm = ErrorNorm::Linf;
        assert!((study.fit().unwrap().exponent - 0.5 * order).abs() < 1e-12);
        let width = study.width().unwrap();
        assert!((width.exponent - 0.75).abs() < 1e-12 && (width.factor - 0.7).abs() < 1e-12);
    }
}

#[test]
fn errors_about_a_power_give_the_order_of_the_best_line() {
    // Two up, two down, in a pattern with no slope of its own.
    let signs = [1.0f64, -1.0, -1.0, 1.0];
    let scatter =
        |h: f64| h.powf(1.5) * (0.3 * signs[(1.0 / h / 32.0).log2().round() as usize]).exp();
    let study = study(&[32, 64, 128, 256], None, scatter);
    assert!((study.fit().unwrap().exponent - 1.5).abs() < 1e-12);
    let first = 1.5 + 0.6 / 2f64.ln();
    assert!((study.orders()[0].unwrap() - first).abs() < 1e-12);
}

#[test]
fn the_theorem_predicts_r_theta_and_guarantees_less() {
    assert_eq!((M6.predicted_order(), M6.guaranteed_order()), (1.5, 0.25));
    // Where the first term is the smaller order: theta = m/(m + s + r) and below.
    let wide = Theory { theta: 0.5, ..M6 };
    assert_eq!(
        (wide.predicted_order(), wide.guaranteed_order()),
        (1.0, 1.0)
    );
    let m4 = Theory {
        smoothness: 3,
        ..M6
    };
    assert_eq!(m4.guaranteed_order(), -0.25);
}

#[test]
fn a_width_in_proportion_to_the_spacing_is_warned_about() {
    let tight = Theory { theta: 1.0, ..M6 };
    let warnings = study(&[32, 64, 128], Some(tight), |h| h * h).warnings();
    let [warning] = &warnings[..] else {
        panic!("{warnings:?}");
    };
    assert!(
        warning.contains("theta = 1") && warning.contains("theta < 1"),
        "{warning}"
    );
    assert!(
        study(&[32, 64, 128], Some(M6), |h| h * h)
            .warnings()
            .is_empty()
    );
    // No theorem, no threshold.
    assert!(study(&[32, 64, 128], None, |h| h * h).warnings().is_empty());
}

#[test]
fn a_floor_under_the_error_is_warned_about() {
    let floor = |h: f64| 100.0 * h.powf(1.5) + 0.02;
    let flagged = |counts: &[usize]| {
        let warnings = study(counts, Some(M6), floor).warnings();
        warnings.iter().any(|text| text.contains("quadrature term"))
    };
    // Local orders 1.4 and 0.7, then 0.3: half of 1.5 is between.
    assert!(!flagged(&[32, 64, 128]));
    assert!(flagged(&[32, 64, 128, 256, 512]));
    // Without a theorem: what falls slowly falls.
    for (order, stalls) in [(-1.0, true), (0.0, true), (0.5, false)] {
        let warnings = study(&[32, 64, 128], None, |h| h.powf(order)).warnings();
        assert_eq!(warnings.len(), usize::from(stalls), "{order}: {warnings:?}");
        assert!(
            !stalls || warnings[0].contains("stopped falling"),
            "{warnings:?}"
        );
    }
}

#[test]
fn too_few_levels_and_errors_of_zero_are_warned_about() {
    let warnings = study(&[32, 64], None, |h| h).warnings();
    assert!(
        warnings.len() == 1 && warnings[0].contains("from 2 levels"),
        "{warnings:?}"
    );
    for error in [0.0, f64::NAN, f64::INFINITY] {
        let study = study(
            &[32, 64, 128],
            Some(M6),
            |h| if h < 0.01 { error } else { h },
        );
        assert_eq!(study.fit(), None);
        assert_eq!(study.orders()[1], None);
        assert!(study.warnings()[0].contains("no order"));
    }
    let same = study(&[32, 32, 32], None, |h| h);
    assert_eq!((same.fit(), same.orders()), (None, vec![None, None]));
}

#[test]
fn a_ladder_doubles_the_resolution_and_ends_at_the_scenarios_own() {
    assert_eq!(coarsest(200, 4, 1), 25);
    assert_eq!(ladder(25, 4, 1), Some(vec![25, 50, 100, 200]));
    assert_eq!(coarsest(16384, 2, 2), 4096);
    assert_eq!(ladder(4096, 2, 2), Some(vec![4096, 16384]));
    assert_eq!(ladder(100, 3, 3), Some(vec![100, 800, 6400]));
    assert_eq!(
        (
            coarsest(100, 9, 1),
            coarsest(100, 99, 2),
            coarsest(100, 1, 3)
        ),
        (16, 64, 256)
    );
    assert_eq!(ladder(16, 100, 1), None);
}

#[test]
fn the_levels_are_made_in_order_and_the_first_failure_ends_the_study() {
    let mut seen = Vec::new();
    let result = Study::run(&[10, 20, 30], ErrorNorm::L1, None, |n| {
        seen.push(n);
        if n < 20 { Ok(level(n, |h| h)) } else { Err(n) }
    });
    assert_eq!((result, seen), (Err(20), vec![10, 20]));
}

#[test]
fn the_norms_have_names() {
    for norm in ErrorNorm::ALL {
        assert_eq!(ErrorNorm::from_name(norm.name()), Some(norm));
    }
    assert_eq!(ErrorNorm::from_name("l3"), None);
}
