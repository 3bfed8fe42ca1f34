//! `--set` changes what it names and no other byte, however the text is written.

use super::*;
use crate::document::Document;
use crate::files::Files;

#[track_caller]
fn changed(text: &str, argument: &str) -> String {
    let document = Document::parse(text, Files::Shipped).unwrap();
    crate::set::changed(&document, argument).unwrap()
}

/// A text, a change, and the text after it.
type Case = (&'static str, &'static str, &'static str);

#[rustfmt::skip]
const CASES: &[Case] = &[
    // Lines: the value changes, its comment stays.
    ("[time]\nend = 1 # s\n", "time.end=2", "[time]\nend = 2 # s\n"),
    ("[time] # no key yet\n\n[units]\n", "time.end=2", "[time] # no key yet\nend = 2\n\n[units]\n"),
    ("[cut-off]\n# a spline\nname = 'a' # M4\neta = 1 # one\ntheta = 0.5\n\n[time]", "cut-off.epsilon=0.01",
     "[cut-off]\n# a spline\nname = 'a' # M4\nepsilon = 0.01\n\n[time]"),
    ("[system]\r\n[time]\r\nend = 1\r\nstep = 1\r\n", "time.stages=9", "[system]\r\n[time]\r\nend = 1\r\nstages = 9\r\n"),
    ("[domain]\nlower = [\n  1, # from here\n]\n", "domain.upper=[2]", "[domain]\nlower = [\n  1, # from here\n]\nupper = [2]\n"),
    ("\u{feff}[time]\n", "name=a", "\u{feff}name = \"a\"\n[time]\n"),
    ("name = 'a'\n[time]\n", "dimension=1", "name = 'a'\ndimension = 1\n[time]\n"),
    // Braces: commas follow what goes.
    ("cut-off = { name = 'a', eta = 1, theta = 0.5 }", "cut-off.epsilon=2", "cut-off = { name = 'a', epsilon = 2 }"),
    ("cut-off = { eta = 1, theta = 0.5, name = 'a' }", "cut-off.epsilon=2", "cut-off = { name = 'a', epsilon = 2 }"),
    ("cut-off = { eta = 1 }", "cut-off.epsilon=2", "cut-off = { epsilon = 2 }"),
    ("cut-off = {}", "cut-off.epsilon=2", "cut-off = { epsilon = 2 }"),
    ("output = { snapshots.every = 1, samples = 3 }", "output.snapshots.steps=2", "output = { samples = 3, snapshots.steps = 2 }"),
    // Key by key.
    ("cut-off.eta = 1 # one\nname = 'a'\n", "cut-off.name=b", "cut-off.eta = 1 # one\ncut-off.name = \"b\"\nname = 'a'\n"),
    ("[output]\nsnapshots.every = 1\nsamples = 3\n", "output.snapshots.steps=2", "[output]\nsnapshots.steps = 2\nsamples = 3\n"),
    // Sections that are not there.
    ("name = 'a'", "output.samples=3", "name = 'a'\n\n[output]\nsamples = 3\n"),
    ("name = 'a'\n", "output.window.lower=[0]", "name = 'a'\n\n[output]\nwindow = { lower = [0] }\n"),
    ("[output]\nsamples = 3\n", "output.window.lower=[0]", "[output]\nsamples = 3\nwindow = { lower = [0] }\n"),
    ("[tolerance.density]\nl1 = 1\n", "tolerance.velocity.l1=2", "[tolerance.density]\nl1 = 1\n\n[tolerance]\nvelocity = { l1 = 2 }\n"),
    // A section for a section.
    ("[output]\nsamples = 3\n[output.window] # here\nlower = [0] # x\n# after\n[time]\n", "output.window={ lower = [1] }",
     "[output]\nsamples = 3\nwindow = { lower = [1] }\n# after\n[time]\n"),
    // Lists.
    ("[[region]]\ndensity = 1\n[[region]]\n# none\n", "region.1.density=2", "[[region]]\ndensity = 1\n[[region]]\ndensity = 2\n# none\n"),
    ("material = [{ gamma = 1.4 }, { gamma = 2 }]", "material.1.gamma=3", "material = [{ gamma = 1.4 }, { gamma = 3 }]"),
];

#[test]
fn a_change_keeps_every_other_byte() {
    for (text, argument, expected) in CASES {
        let after = changed(text, argument);
        assert_eq!(after, *expected, "{argument} in\n{text}");
        let document = Document::parse(&after, Files::Shipped);
        assert!(document.is_ok(), "{argument} gives\n{after}");
        assert_eq!(changed(&after, argument), after, "made twice: {argument}");
    }
}

#[test]
fn a_value_cannot_bring_in_lines() {
    for value in ["1\n[output]", "1 # why", "two words", "[1", "1, 2"] {
        let error = sod(&[&format!("time.end={value}")]).expect_err(value);
        assert_report_holds(&error, &["is not a value"]);
    }
}

#[test]
fn a_text_that_is_not_toml_is_not_changed() {
    let error = File::new("[time\n").read(&["time.end=1"]).unwrap_err();
    assert_report_holds(&error, &["not TOML", "mine.toml:1:6]"]);
}
