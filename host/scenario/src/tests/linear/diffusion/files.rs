//! A series of numbers in a file beside the scenario.

use super::*;

/// A wall that the column `t` of a file drives.
const DRIVEN: &str = "[[wall]]\naxis = \"x\"\nend = \"upper\"\nkind = \"value\"\n\
                      series = { file = \"day.csv\", column = \"t\", beyond = \"hold\" }\n[initial]";

/// [`SLAB`] with that wall, beside a file of these bytes.
fn beside(bytes: &[u8]) -> Result<LinearScenario, ScenarioError> {
    let file = File::new(changed(SLAB, &[("[initial]", DRIVEN)]));
    std::fs::write(file.folder.path().join("day.csv"), bytes).unwrap();
    LinearScenario::read(Source::File(file.path()), &[])
}

fn wall_day(overrides: &[&str]) -> Result<LinearScenario, ScenarioError> {
    let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
    LinearScenario::read(Source::from("wall-day"), &overrides)
}

#[test]
fn a_series_reads_the_columns_that_are_named() {
    let check = |bytes: &[u8], times: &[f64], values: &[f64]| {
        let scenario = beside(bytes).unwrap();
        let [WallCondition::Value(Drive::Series(series))] = &diffusion(&scenario).walls[0][1][..]
        else {
            panic!("{:?}", diffusion(&scenario).walls);
        };
        assert_eq!((&series.times[..], &series.values[..]), (times, values));
        assert_eq!(
            (series.file.as_str(), series.text.as_bytes()),
            ("day.csv", bytes)
        );
    };
    check(
        b"t, other, time\n1.5, a, 0\n-2.0, b, 0.5\n",
        &[0.0, 0.5],
        &[1.5, -2.0],
    );
    check(b"time,t\n7,3\n", &[7.0], &[3.0]);
}

/// Text of the file; the value, the line and the cure of the report.
#[rustfmt::skip]
const FAULTS: &[(&str, &[&str])] = &[
    ("", &["there is no column `time`", "need `time` and the column that the scenario names, `t`"]),
    ("t\n1\n", &["there is no column `time`", "the columns are: t"]),
    ("time,x\n0,1\n", &["there is no column `t`", "the columns are: time, x", "day.csv:1:1"]),
    ("time,t\n", &["there are no times in the file", "add a row a time"]),
    ("time,t\n0,a\n", &["line 2, t = a", "need an ordinary number", "day.csv:2:3"]),
    ("time,t\n0,1\n1,nan\n", &["line 3, t = nan", "need an ordinary number", "day.csv:3:3"]),
    ("time,t\ninf,1\n", &["line 2, time = inf", "need an ordinary number", "day.csv:2:1"]),
    ("time,t\n0,1\n0,2\n", &["line 3, time = 0", "need a time after that of the row before, 0", "day.csv:3:1"]),
    ("time,t\n1,1\n0.5,2\n", &["line 3, time = 0.5", "the row before, 1"]),
    ("time,t,t\n0,1,2\n", &["the heading has `t` twice, as columns 2 and 3", "keep one", "day.csv:1:1"]),
    ("time,t,time\n0,1,2\n", &["the heading has `time` twice, as columns 1 and 3"]),
    ("time,t\n0,1\n1\n", &["line 3 has 1 fields, the heading has 2", "a file cut short"]),
];

#[test]
fn every_fault_of_a_series_names_the_value_the_line_and_the_cure() {
    for (text, parts) in FAULTS {
        let error = beside(text.as_bytes()).expect_err(text);
        assert_report_holds(&error, parts);
    }
    let error = beside(b"time,t\n0,\xe9\n").unwrap_err();
    let parts = [
        "wall.0.series.file",
        "day.csv` is not UTF-8",
        "saved as UTF-8",
    ];
    assert_report_holds(&error, &parts);
}

/// The run of [`SLAB`] goes from 0 to 0.5.
#[test]
fn a_series_that_does_not_cover_the_run_names_both_and_the_cure() {
    let read = |rows: &str| {
        let driven = DRIVEN.replace(", beyond = \"hold\"", "");
        let file = File::new(changed(SLAB, &[("[initial]", &driven)]));
        std::fs::write(
            file.folder.path().join("day.csv"),
            format!("time,t\n{rows}"),
        )
        .unwrap();
        LinearScenario::read(Source::File(file.path()), &[])
    };
    for rows in ["0,1\n0.5,2\n", "-3,1\n7,2\n", "0,1\n0.4999999999,2\n"] {
        read(rows).unwrap();
    }
    for (rows, times) in [
        (
            "1.6e9,1\n1600000001,2\n",
            "its times go from 1600000000 to 1600000001",
        ),
        ("0,1\n0.4,2\n", "its times go from 0 to 0.4"),
        ("0.1,1\n2,2\n", "its times go from 0.1 to 2"),
        ("0,1\n", "the only time in it is 0"),
    ] {
        let parts = [
            "wall.0.series.file = \"day.csv\"",
            times,
            "the run from 0 to 0.5",
            "in its unit of time",
            "beyond = \"hold\"",
            "mine.toml:",
        ];
        assert_report_holds(&read(rows).unwrap_err(), &parts);
    }
}

#[test]
fn a_missing_series_tells_where_it_is_looked_for() {
    let text = changed(SLAB, &[("[initial]", DRIVEN)]);
    let error = linear(&text, &[]).unwrap_err();
    let parts = [
        "wall.0.series.file = \"day.csv\"",
        "there is no file",
        "in the folder of the scenario",
        "mine.toml:",
    ];
    assert_report_holds(&error, &parts);
    let copy = built_in_linear("wall-day", &[]).unwrap_err();
    let parts = [
        "wall.0.series.file",
        "`motes show wall-day.csv > ",
        "wall-day.csv`",
    ];
    assert_report_holds(&copy, &parts);
}

#[test]
fn what_comes_with_the_program_reads_beside_a_copy_too() {
    let scenario = wall_day(&[]).unwrap();
    let exchange = &diffusion(&scenario).walls[0][0][0];
    let WallCondition::Exchange {
        outside: Drive::Series(series),
        ..
    } = exchange
    else {
        panic!("{exchange:?}");
    };
    let hours: Vec<f64> = (0..=72).map(f64::from).collect();
    assert_eq!(series.times, hours);
    assert!(series.values.iter().all(|t| (-20.0..40.0).contains(t)));
    let text = built_in("wall-day").unwrap().text;
    let file = File::new(text);
    let series = shipped_file("wall-day.csv").unwrap();
    std::fs::write(file.folder.path().join(series.name), series.text).unwrap();
    let copy = LinearScenario::read(Source::File(file.path()), &[]).unwrap();
    assert_eq!(copy, scenario);

    let error = wall_day(&["wall.0.series.column=humidity"]).unwrap_err();
    let parts = [
        "no column `humidity`",
        "time, temperature",
        "wall-day.csv (built in):1:1",
    ];
    assert_report_holds(&error, &parts);
    let other = wall_day(&["wall.0.series.file=no/such.csv"]).unwrap_err();
    assert_report_holds(&other, &["there is no file `no/such.csv`"]);
}
