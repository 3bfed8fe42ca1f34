use super::*;

fn check(what: &str, measured: f64, bound: f64) -> Check {
    Check {
        what: what.to_owned(),
        measured,
        bound,
        reason: format!("theorem of {what}"),
        lower: false,
    }
}

fn row(scenario: &str, scalar: &str, dimension: usize) -> SuiteRow {
    SuiteRow {
        scenario: scenario.to_owned(),
        scalar: scalar.to_owned(),
        dimension,
        particles: 16384,
        steps: 1200,
        seconds: 12.75,
        smallest_step: 1.25e-4,
        checks: vec![check("density L1", 0.0123456, 0.02)],
        energy_drift: -3.21e-9,
        momentum_drift: 0.0,
        digest: "0123456789abcdef".to_owned(),
        note: None,
        picture: Some(format!("pictures/{scenario}.svg")),
    }
}

/// The rows of the tables: from a line that starts with `| ` those that are not headings.
fn table_rows(text: &str) -> Vec<&str> {
    let rows = text.lines().filter(|line| line.starts_with("| "));
    rows.filter(|line| !line.starts_with("| scenario"))
        .collect()
}

/// The cells of a row, `\|` being no end.
fn cells(row: &str) -> usize {
    row.replace("\\|", "").matches('|').count() - 1
}

#[test]
fn a_bound_is_kept_from_its_side_and_by_no_nan() {
    for (measured, lower, holds) in [
        (1.0, false, true),
        (1.0, true, true),
        (1.1, false, false),
        (1.1, true, true),
        (0.9, false, true),
        (0.9, true, false),
        (f64::NAN, false, false),
        (f64::NAN, true, false),
    ] {
        let check = Check {
            lower,
            ..check("order", measured, 1.0)
        };
        assert_eq!(check.holds(), holds, "{check:?}");
    }
}

#[test]
fn a_check_that_fails_is_marked_where_it_stands_and_counted() {
    let mut rows = vec![row("sod", "f64", 1), row("sod", "f32", 1)];
    let good = (markdown(&rows, "c"), html(&rows, "c"));
    assert_eq!(failures(&rows), 0);
    for text in [&good.0, &good.1] {
        assert!(text.contains("2 runs, 2 checks, all kept") && !text.contains(FAILED));
    }
    rows[1].checks.push(check("velocity L1", 0.05, 0.04));
    rows[1].checks.push(check("pressure L1", f64::NAN, 0.04));
    assert_eq!(failures(&rows), 2);
    let (markdown, html) = (markdown(&rows, "c"), html(&rows, "c"));
    let table = table_rows(&markdown);
    assert!(!table[0].contains(FAILED));
    assert!(table[1].contains("density L1 0.01235 (≤ 0.02)<br>**✗ velocity L1 0.05 (≤ 0.04)**"));
    assert!(table[1].contains("**✗ pressure L1 NaN (≤ 0.04)**"));
    assert!(html.contains("<div class=\"bad\">✗ velocity L1 0.05 <i>(≤ 0.04)</i></div>"));
    for text in [&markdown, &html] {
        assert!(text.contains("2 runs, 4 checks, 2 failed ✗"));
        // Two in the table, one in the verdict.
        assert_eq!(text.matches(FAILED).count(), 3);
    }
}

#[test]
fn a_bound_missed_by_less_than_the_digits_shown_is_seen_to_be_missed() {
    let close = check("density L1", 0.020000001, 0.02);
    assert_eq!(close.measured(), "0.020000001");
    assert_eq!(check("density L1", 0.019999999, 0.02).measured(), "0.02");
}

#[test]
fn the_markdown_has_one_row_for_each_run_in_a_table_for_each_dimension() {
    let mut rows = Vec::new();
    for (scenario, dimension) in [("noh", 2), ("sod", 1), ("sedov", 2)] {
        for scalar in ["f32", "f64", "q31.32"] {
            rows.push(row(scenario, scalar, dimension));
        }
    }
    let text = markdown(&rows, "c");
    let table = table_rows(&text);
    assert_eq!(table.len(), rows.len());
    for row in &rows {
        let start = format!("| {} | {} | 16384 | 1200 |", row.scenario, row.scalar);
        let found = table.iter().filter(|line| line.starts_with(&start)).count();
        assert_eq!(found, 1, "{start}");
    }
    assert!(table.iter().all(|row| cells(row) == 8));
    let place = |part: &str| text.find(part).unwrap();
    assert_eq!(text.matches("\n## ").count(), 2);
    assert!(place("## 1D") < place("| sod |") && place("| sod |") < place("## 2D"));
    assert!(place("## 2D") < place("| noh |") && place("| noh |") < place("| sedov |"));
}

#[test]
fn equal_runs_give_equal_markdown_however_long_they_took() {
    let rows = [row("sod", "f64", 1), row("noh", "f64", 2)];
    let mut slower = rows.clone();
    slower.iter_mut().for_each(|row| row.seconds *= 3.7);
    assert_eq!(markdown(&rows, "c"), markdown(&slower, "c"));
    assert_eq!(html(&rows, "c"), html(&rows, "c"));
    assert_ne!(html(&rows, "c"), html(&slower, "c"));
}

#[test]
fn each_bound_has_its_reason_once_and_each_picture_its_link() {
    let mut rows = vec![row("sod", "f64", 1), row("sod", "f32", 1)];
    rows[1].checks.push(check("velocity L1", 0.01, 0.04));
    rows[1].note = Some("coarse".to_owned());
    rows[1].picture = None;
    let text = markdown(&rows, "c");
    assert_eq!(
        text.matches("- density L1 ≤ 0.02: theorem of density L1\n")
            .count(),
        1
    );
    assert!(text.contains("- velocity L1 ≤ 0.04, f32: theorem of velocity L1\n"));
    assert!(text.contains("- f32: coarse\n"));
    assert_eq!(text.matches("![sod, f64](pictures/sod.svg)").count(), 1);
    assert_eq!(text.matches("![").count(), 1);
    let text = html(&rows, "c");
    assert_eq!(text.matches("theorem of density L1").count(), 1);
    assert_eq!(text.matches("<img src=\"pictures/sod.svg\"").count(), 1);
}

#[test]
fn words_and_paths_cannot_break_out_of_their_place() {
    let nasty = "a|b <script>\n*c* `d` [e] & \"f\" \\|";
    let mut bad = row(nasty, "f64", 1);
    bad.note = Some(nasty.to_owned());
    bad.checks[0].what = nasty.to_owned();
    bad.checks[0].reason = nasty.to_owned();
    bad.picture = Some("a b/(c)\".svg".to_owned());
    let rows = [bad];
    let text = markdown(&rows, "one <two>\nthree");
    assert_eq!(table_rows(&text).len(), 1);
    assert_eq!(cells(&table_rows(&text)[0].replace("\\\\", "")), 8);
    assert!(!text.contains("<script>") && text.contains("](a%20b/%28c%29%22.svg)"));
    assert!(text.contains("\n    one <two>\n    three\n"));
    let text = html(&rows, "one <two>\nthree");
    assert!(!text.contains("<script") && text.contains("src=\"a%20b/%28c%29%22.svg\""));
    assert!(text.contains("<pre>one &lt;two&gt;\nthree</pre>"));
    for tag in [
        "table", "section", "ul", "li", "figure", "body", "tr", "td", "div",
    ] {
        let opened = text.matches(&format!("<{tag}>")).count();
        let opened = opened + text.matches(&format!("<{tag} ")).count();
        assert_eq!(opened, text.matches(&format!("</{tag}>")).count(), "{tag}");
    }
}

#[test]
fn numbers_have_four_digits_and_no_empty_zeros() {
    for (value, expected) in [
        (0.0, "0"),
        (-0.0, "0"),
        (0.02, "0.02"),
        (0.0123456, "0.01235"),
        (-1.5, "-1.5"),
        (99999.0, "99999"),
        (123.456, "123.5"),
        (100000.0, "1e5"),
        (9.99996e-4, "1e-3"),
        (-3.2145e-9, "-3.215e-9"),
        (1e-300, "1e-300"),
        (f64::NAN, "NaN"),
        (f64::INFINITY, "inf"),
    ] {
        let found = number(value);
        assert_eq!(found, expected);
        if value.is_finite() && value != 0.0 {
            let read: f64 = found.parse().unwrap();
            assert!((read / value - 1.0).abs() <= 0.5e-3, "{found} for {value}");
        }
    }
}

#[test]
fn a_row_is_written_with_its_names_for_programs() {
    let value = serde_json::to_value(row("sod", "f64", 1)).unwrap();
    assert_eq!(value["scenario"], "sod");
    assert_eq!(value["checks"][0]["bound"], 0.02);
    assert_eq!(value["checks"][0]["lower"], false);
    assert!(value["note"].is_null());
}
