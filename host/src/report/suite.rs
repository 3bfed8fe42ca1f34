//! The accuracy of many runs as a table: Markdown to keep beside the sources, HTML to look at.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::Serialize;

use crate::io::escaped;

impl SuiteRow {
    /// Whether there was no run: the note says why.
    pub fn is_refused(&self) -> bool {
        self.particles == 0
    }

    /// Why there was none, or what was measured.
    fn refusal(&self) -> Option<&str> {
        self.note.as_deref().filter(|_| self.is_refused())
    }
}

/// One run of the suite.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SuiteRow {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the scalar.
    pub scalar: String,
    /// Dimension of space.
    pub dimension: usize,
    /// Number of particles.
    pub particles: usize,
    /// Steps made.
    pub steps: u64,
    /// Wall-clock seconds of the stepping.
    pub seconds: f64,
    /// The smallest time step.
    pub smallest_step: f64,
    /// What was measured, and what it must come to.
    pub checks: Vec<Check>,
    /// Drift of the energy, relative.
    pub energy_drift: f64,
    /// Drift of the momentum, relative to what the scenario names.
    pub momentum_drift: f64,
    /// Digest of the last state.
    pub digest: String,
    /// What a careful reader should know.
    pub note: Option<String>,
    /// The picture: a path relative to the table, `/` between folders.
    pub picture: Option<String>,
}

/// A number with a bound.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// What was measured: "density L1".
    pub what: String,
    /// What came out.
    pub measured: f64,
    /// What it must keep to.
    pub bound: f64,
    /// Where the bound comes from.
    pub reason: String,
    /// The bound is the least, not the most.
    pub lower: bool,
}

impl Check {
    /// Whether the bound is kept; a NaN keeps none.
    pub fn holds(&self) -> bool {
        match self.lower {
            true => self.measured >= self.bound,
            false => self.measured <= self.bound,
        }
    }

    /// The bound with its direction.
    fn limit(&self) -> String {
        let relation = if self.lower { "≥" } else { "≤" };
        format!("{relation} {}", number(self.bound))
    }

    /// The measured number; with all its digits where fewer would hide that the bound is missed.
    fn measured(&self) -> String {
        let short = number(self.measured);
        match !self.holds() && short == number(self.bound) {
            true => format!("{:?}", self.measured),
            false => short,
        }
    }
}

/// The check in a few words, marked where its bound is missed.
impl std::fmt::Display for Check {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mark = if self.holds() { "" } else { FAILED };
        write!(
            f,
            "{mark}{} {} ({})",
            self.what,
            self.measured(),
            self.limit()
        )
    }
}

/// How many checks of all rows miss their bound.
pub fn failures(rows: &[SuiteRow]) -> usize {
    let checks = rows.iter().flat_map(|row| &row.checks);
    checks.filter(|check| !check.holds()).count()
}

/// The mark of a check that misses its bound.
const FAILED: &str = "✗";

/// The table as Markdown. No wall-clock time: equal runs give equal text.
///
/// `command`: what to type to make it again.
pub fn markdown(rows: &[SuiteRow], command: &str) -> String {
    let mut text = format!("# Accuracy\n\n{}.\n\nMade by\n\n", verdict(rows));
    for line in command.lines() {
        let _ = writeln!(text, "    {line}");
    }
    for (dimension, rows) in by_dimension(rows) {
        let _ = write!(
            text,
            "\n## {dimension}D\n\n\
             | scenario | scalar | particles | steps | measured (bound) | energy drift | \
             momentum drift | digest |\n|---|---|--:|--:|---|--:|--:|---|\n"
        );
        for row in &rows {
            let _ = writeln!(text, "{}", markdown_row(row));
        }
        for (scenario, rows) in by_scenario(&rows) {
            let _ = write!(text, "\n### {}\n\n", plain(scenario));
            for (bound, reason) in reasons(&rows) {
                let _ = writeln!(text, "- {}: {}", plain(&bound), plain(reason));
            }
            for note in notes(&rows) {
                let _ = writeln!(text, "- {}", plain(&note));
            }
            for (scalar, picture) in pictures(&rows) {
                let words = plain(&format!("{scenario}, {scalar}"));
                let _ = write!(text, "\n![{words}]({})\n", link(picture));
            }
        }
    }
    text
}

fn markdown_row(row: &SuiteRow) -> String {
    let check = |check: &Check| {
        let words = format!("{} {} ({})", check.what, check.measured(), check.limit());
        match check.holds() {
            true => plain(&words),
            false => format!("**{FAILED} {}**", plain(&words)),
        }
    };
    let mut checks: Vec<String> = row.checks.iter().map(check).collect();
    checks.extend(row.refusal().map(plain));
    if row.is_refused() {
        let (scenario, scalar) = (plain(&row.scenario), plain(&row.scalar));
        let words = checks.join("<br>");
        return format!("| {scenario} | {scalar} | | | {words} | | | |");
    }
    format!(
        "| {} | {} | {} | {} | {} | {} | {} | {} |",
        plain(&row.scenario),
        plain(&row.scalar),
        row.particles,
        row.steps,
        checks.join("<br>"),
        drift(row.energy_drift),
        drift(row.momentum_drift),
        plain(&row.digest)
    )
}

/// The table as a page of its own, with the pictures beside it.
///
/// `command`: what to type to make it again.
pub fn html(rows: &[SuiteRow], command: &str) -> String {
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>motes: accuracy</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>Accuracy</h1>\n<p class=\"{}\">{}.</p>\n<p>Made by</p>\n<pre>{}</pre>\n",
        if failures(rows) == 0 { "good" } else { "bad" },
        verdict(rows),
        escaped(command.trim_end())
    );
    for (dimension, rows) in by_dimension(rows) {
        let _ = write!(
            text,
            "<h2>{dimension}D</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>scenario</th>\
             <th>scalar</th><th>particles</th><th>steps</th><th>smallest step</th>\
             <th>measured (bound)</th><th>energy drift</th><th>momentum drift</th>\
             <th>seconds</th><th>digest</th></tr></thead>\n<tbody>\n"
        );
        for row in &rows {
            text.push_str(&html_row(row));
        }
        text.push_str("</tbody>\n</table></div>\n");
        for (scenario, rows) in by_scenario(&rows) {
            let _ = write!(text, "<section>\n<h3>{}</h3>\n<ul>\n", escaped(scenario));
            for (bound, reason) in reasons(&rows) {
                let (bound, reason) = (escaped(&bound), escaped(reason));
                let _ = writeln!(text, "<li><b>{bound}</b>: {reason}</li>");
            }
            for note in notes(&rows) {
                let _ = writeln!(text, "<li class=\"note\">{}</li>", escaped(&note));
            }
            text.push_str("</ul>\n");
            for (scalar, picture) in pictures(&rows) {
                let words = escaped(&format!("{scenario}, {scalar}"));
                let _ = writeln!(
                    text,
                    "<figure><img src=\"{}\" alt=\"{words}\" loading=\"lazy\">\
                     <figcaption>{words}</figcaption></figure>",
                    link(picture)
                );
            }
            text.push_str("</section>\n");
        }
    }
    text + "</body>\n</html>\n"
}

fn html_row(row: &SuiteRow) -> String {
    let check = |check: &Check| {
        let words = format!("{} {} ", check.what, check.measured());
        let (words, limit) = (escaped(&words), check.limit());
        match check.holds() {
            true => format!("<div>{words}<i>({limit})</i></div>"),
            false => format!("<div class=\"bad\">{FAILED} {words}<i>({limit})</i></div>"),
        }
    };
    let checks: String = row.checks.iter().map(check).collect();
    if row.is_refused() {
        let words = row.refusal().map(escaped).unwrap_or_default();
        return format!(
            "<tr><td>{}</td><td>{}</td><td></td><td></td><td></td><td>{checks}{words}</td><td></td>\
             <td></td><td></td><td></td></tr>\n",
            escaped(&row.scenario),
            escaped(&row.scalar)
        );
    }
    format!(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>\
         <td class=\"n\">{}</td><td>{checks}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>\
         <td class=\"n\">{}</td><td><code>{}</code></td></tr>\n",
        escaped(&row.scenario),
        escaped(&row.scalar),
        row.particles,
        row.steps,
        number(row.smallest_step),
        drift(row.energy_drift),
        drift(row.momentum_drift),
        number(row.seconds),
        escaped(&row.digest)
    )
}

const STYLE: &str = "\
:root { color-scheme: light dark; --line: #d0d0d0; --bad: #b3261e; --good: #1b6e3c; }
@media (prefers-color-scheme: dark) { :root { --line: #4a4a4a; --bad: #ff8a80; --good: #7ddc9f; } }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 76rem; margin: 2rem auto; padding: 0 1rem; }
h2 { margin-top: 2.5rem; }
pre { overflow-x: auto; padding: .6rem .8rem; border: 1px solid var(--line); border-radius: 4px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .875rem; }
th, td { text-align: left; vertical-align: top; padding: .35rem .7rem; white-space: nowrap; }
tr { border-bottom: 1px solid var(--line); }
.n { text-align: right; font-variant-numeric: tabular-nums; }
i { font-style: normal; opacity: .7; }
.bad { color: var(--bad); font-weight: 600; }
.good { color: var(--good); }
figure { margin: 1rem 0; }
img { max-width: 100%; height: auto; background: white; border: 1px solid var(--line); }
figcaption { font-size: .875rem; opacity: .7; }
";

/// How many checks there are, and how many fail.
pub fn verdict(rows: &[SuiteRow]) -> String {
    let checks: usize = rows.iter().map(|row| row.checks.len()).sum();
    let refused = rows.iter().filter(|row| row.is_refused()).count();
    let runs = match refused {
        0 => format!("{} runs", rows.len()),
        refused => format!("{} runs, {refused} not made", rows.len() - refused),
    };
    match failures(rows) {
        0 => format!("{runs}, {checks} checks, all kept"),
        failed => format!("{runs}, {checks} checks, {failed} failed {FAILED}"),
    }
}

/// Rows of one dimension, in the order given.
fn by_dimension(rows: &[SuiteRow]) -> BTreeMap<usize, Vec<&SuiteRow>> {
    let mut groups: BTreeMap<usize, Vec<&SuiteRow>> = BTreeMap::new();
    for row in rows {
        groups.entry(row.dimension).or_default().push(row);
    }
    groups
}

/// Scenarios in the order in which they first come, with their rows.
fn by_scenario<'a>(rows: &[&'a SuiteRow]) -> Vec<(&'a str, Vec<&'a SuiteRow>)> {
    let mut groups: Vec<(&str, Vec<&SuiteRow>)> = Vec::new();
    for row in rows {
        match groups.iter_mut().find(|(name, _)| *name == row.scenario) {
            Some((_, rows)) => rows.push(row),
            None => groups.push((&row.scenario, vec![row])),
        }
    }
    groups
}

/// Every bound once, with its reason; with the scalars it holds for where those are not all.
fn reasons<'a>(rows: &[&'a SuiteRow]) -> Vec<(String, &'a str)> {
    let mut bounds: Vec<((String, &str), Vec<&str>)> = Vec::new();
    for row in rows {
        for check in &row.checks {
            let bound = format!("{} {}", check.what, check.limit());
            note_down(&mut bounds, (bound, &check.reason), &row.scalar);
        }
    }
    let named = |((bound, reason), scalars): ((String, _), Vec<&str>)| match all(rows, &scalars) {
        true => (bound, reason),
        false => (format!("{bound}, {}", scalars.join(", ")), reason),
    };
    bounds.into_iter().map(named).collect()
}

/// Every note once, with the scalars it is about where those are not all.
fn notes(rows: &[&SuiteRow]) -> Vec<String> {
    let mut notes: Vec<(&str, Vec<&str>)> = Vec::new();
    for row in rows {
        if let Some(note) = &row.note {
            note_down(&mut notes, note, &row.scalar);
        }
    }
    let named = |(note, scalars): (&str, Vec<&str>)| match all(rows, &scalars) {
        true => note.to_owned(),
        false => format!("{}: {note}", scalars.join(", ")),
    };
    notes.into_iter().map(named).collect()
}

/// Adds a scalar to those of a text, once.
fn note_down<'a, T: PartialEq>(texts: &mut Vec<(T, Vec<&'a str>)>, text: T, scalar: &'a str) {
    match texts.iter_mut().find(|(known, _)| *known == text) {
        Some((_, scalars)) if scalars.contains(&scalar) => {}
        Some((_, scalars)) => scalars.push(scalar),
        None => texts.push((text, vec![scalar])),
    }
}

/// Whether the scalars are all that the rows have.
fn all(rows: &[&SuiteRow], scalars: &[&str]) -> bool {
    rows.iter()
        .all(|row| scalars.contains(&row.scalar.as_str()))
}

/// The pictures with their scalars.
fn pictures<'a>(rows: &[&'a SuiteRow]) -> impl Iterator<Item = (&'a str, &'a str)> {
    let picture = |row: &&'a SuiteRow| Some((row.scalar.as_str(), row.picture.as_deref()?));
    rows.iter().filter_map(picture)
}

/// A drift; nothing where the equations have no such sum.
fn drift(value: f64) -> String {
    match value.is_nan() {
        true => String::new(),
        false => number(value),
    }
}

/// A number with 4 digits; those that say nothing left out.
fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || !value.is_finite() {
        return format!("{}", value + 0.0);
    }
    if !(1e-3..1e5).contains(&size) {
        let text = format!("{value:.3e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", trimmed(digits));
    }
    let decimals = 3 - size.log10().floor() as i32;
    let text = format!("{value:.*}", decimals.max(0) as usize);
    trimmed(&text).to_owned()
}

/// Without the zeros at the end of a fraction.
fn trimmed(digits: &str) -> &str {
    match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.'),
        false => digits,
    }
}

/// Text that Markdown takes as it is, on one line.
fn plain(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => plain.push_str("&amp;"),
            '<' => plain.push_str("&lt;"),
            '>' => plain.push_str("&gt;"),
            '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '#' | '~' => plain.extend(['\\', c]),
            c if c.is_control() => plain.push(' '),
            c => plain.push(c),
        }
    }
    plain
}

/// A relative path as a link, for Markdown and HTML.
fn link(path: &str) -> String {
    let mut link = String::new();
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' | b'/' => {
                link.push(char::from(byte));
            }
            _ => {
                let _ = write!(link, "%{byte:02X}");
            }
        }
    }
    link
}

#[cfg(test)]
mod tests;
