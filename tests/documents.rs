//! Numbers in README and docs against the commands that print them: a line
//!
//! ```text
//! <!-- check `motes run sod --scalar f32`: errors.density.l1 = 0.002773, steps = 1059 -->
//! ```
//!
//! behind a paragraph or a table says that `motes run sod --scalar f32 --json` prints these members, as
//! rounded, and that the numbers stand in the text before. `warnings ~ words` says that a warning
//! has these words. Commands are those of under a second; a scalar that the build lacks is left out.

use std::path::{Path, PathBuf};

use serde_json::Value;

mod command;

/// A check of a document.
struct Check<'a> {
    command: &'a str,
    member: &'a str,
    /// `=` or `~`.
    relation: char,
    number: &'a str,
}

const MARK: &str = "<!-- check `";

/// The checks of a document, each with the text before it.
fn checks(text: &str) -> Vec<(&str, Check<'_>)> {
    let mut checks = Vec::new();
    for (place, _) in text.match_indices(MARK) {
        let rest = &text[place + MARK.len()..];
        let (rest, _) = rest.split_once("-->").expect("a check has an end");
        let (command, members) = rest.split_once("`:").expect("a command, then `:`");
        for member in members.split(", ") {
            let relation = if member.contains(" ~ ") { '~' } else { '=' };
            let (member, number) = member.split_once(relation).expect("MEMBER = NUMBER");
            checks.push((
                &text[..place],
                Check {
                    command,
                    member: member.trim(),
                    relation,
                    number: number.trim(),
                },
            ));
        }
    }
    checks
}

/// What a document shows: without comments.
fn shown(text: &str) -> String {
    let parts = text.split("<!--").enumerate();
    let visible = |(i, part): (usize, &str)| match i {
        0 => part.to_owned(),
        _ => part
            .split_once("-->")
            .map_or("", |(_, after)| after)
            .to_owned(),
    };
    parts.map(visible).collect()
}

/// The number with the digits of a text: `0.002773` has four, `1.5e-3` two.
fn rounded(value: f64, like: &str) -> f64 {
    let digits = like.split(['e', 'E']).next().unwrap_or(like);
    let digits = digits.trim_start_matches(['-', '0', '.']);
    let count = digits.chars().filter(char::is_ascii_digit).count();
    format!("{value:.*e}", count.saturating_sub(1))
        .parse()
        .unwrap()
}

fn documents() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let docs = std::fs::read_dir(root.join("docs")).unwrap();
    let mut all: Vec<PathBuf> = docs.map(|entry| entry.unwrap().path()).collect();
    all.push(root.join("README.md"));
    all.retain(|path| path.extension().is_some_and(|kind| kind == "md"));
    all.sort();
    all
}

#[test]
fn numbers_of_the_documents_are_what_the_commands_beside_them_print() {
    let folder = tempfile::tempdir().unwrap();
    let (mut made, mut seen) = (0, std::collections::BTreeMap::<String, Value>::new());
    for path in documents() {
        let text = std::fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().display();
        for (before, check) in checks(&text) {
            let shown = shown(before);
            assert!(
                shown.contains(check.number),
                "{name}: {} does not stand before its check",
                check.number
            );
            let lacks = check.command.contains("--scalar") && cfg!(not(feature = "fixed-point"));
            if lacks && !check.command.contains("--scalar f") {
                continue;
            }
            let printed = seen.entry(check.command.to_owned()).or_insert_with(|| {
                let mut words = check.command.split(' ');
                assert_eq!(words.next(), Some("motes"), "{name}: {}", check.command);
                let arguments: Vec<&str> = words.chain(["--json"]).collect();
                let text = command::stdout(folder.path(), &arguments);
                serde_json::from_str(&text).unwrap()
            });
            let member =
                check
                    .member
                    .split('.')
                    .fold(&*printed, |value, key| match key.parse::<usize>() {
                        Ok(place) => &value[place],
                        Err(_) => &value[key],
                    });
            let told = format!("{name}: `{}`: {} is {member}", check.command, check.member);
            match check.relation {
                '~' => {
                    let warnings = member.as_array().unwrap_or_else(|| panic!("{told}"));
                    let mut texts = warnings.iter().filter_map(Value::as_str);
                    assert!(texts.any(|text| text.contains(check.number)), "{told}");
                }
                _ => {
                    let value = member.as_f64().unwrap_or_else(|| panic!("{told}"));
                    let number: f64 = check.number.parse().unwrap();
                    let same = rounded(value, check.number) == number;
                    assert!(same, "{told}, not {}", check.number);
                }
            }
            made += 1;
        }
    }
    assert!(made >= 8, "{made} checks");
}

/// Every block of Rust of the pages that start from nothing stands in a program that is compiled.
#[test]
fn code_of_the_pages_stands_in_the_examples() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |file: &str| std::fs::read_to_string(root.join(file)).unwrap();
    let examples = ["own_system", "own_field", "own_problem", "device"];
    let examples = examples.map(|name| read(&format!("examples/{name}.rs")));
    let mut seen = 0;
    for page in ["docs/own-system.md", "docs/own-device.md"] {
        let text = read(page);
        for block in text.split("```rust\n").skip(1) {
            let (code, _) = block.split_once("```").expect("a block has an end");
            let stands = examples.iter().any(|example| example.contains(code));
            assert!(stands, "{page}: no example has\n{code}");
            seen += 1;
        }
    }
    assert_eq!(seen, 12);
}

/// The instructions that `docs/numbers.md` tells of are those of the table that `./check.sh devices` keeps.
#[test]
fn instructions_in_the_numbers_are_those_of_the_table() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let numbers = std::fs::read_to_string(root.join("docs/numbers.md")).unwrap();
    let numbers = numbers.split_whitespace().collect::<Vec<_>>().join(" ");
    let table = std::fs::read_to_string(root.join("embedded/instructions.csv")).unwrap();
    for scalar in ["f32", "q15.16"] {
        let row = format!("thumbv7em-none-eabihf,acoustics1d,64,{scalar},rk4,");
        let row = table
            .lines()
            .find_map(|line| line.strip_prefix(&row))
            .unwrap();
        let first: u64 = row.split(',').next().unwrap().parse().unwrap();
        let thousands = (first + 500) / 1000;
        let number = match thousands {
            0..1000 => format!("{thousands},000"),
            _ => format!("{},{:03},000", thousands / 1000, thousands % 1000),
        };
        let words = match scalar {
            "f32" => format!("takes {number} instructions in f32"),
            _ => format!("and {number} in {scalar}"),
        };
        assert!(
            numbers.contains(&words),
            "docs/numbers.md does not say {words:?}"
        );
    }
}

#[test]
fn rounding_is_to_the_digits_of_the_text() {
    assert_eq!(rounded(0.00277251, "0.002773"), 0.002773);
    assert_eq!(rounded(0.00800049, "0.00800"), 0.008);
    assert_eq!(rounded(-1.449e-3, "-1.4e-3"), -1.4e-3);
    assert_eq!(rounded(1059.0, "1059"), 1059.0);
    let text = "a 1 <!-- check `motes run sod`: steps = 2, warnings ~ far -->";
    let all = checks(text);
    assert_eq!(all.len(), 2);
    assert_eq!(
        (all[0].0, all[0].1.number, all[1].1.relation),
        ("a 1 ", "2", '~')
    );
    assert_eq!(shown("a <!-- b --> c"), "a  c");
}
