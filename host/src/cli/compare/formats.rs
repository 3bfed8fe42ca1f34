//! Which formats are compared, and the command that asks for them.

use crate::cli::Failure;
use crate::cli::arguments::{CompareArguments, scalar};
use crate::run::ScalarName;
use crate::scenario::shortened;

/// The formats asked for; without any all that the build has.
///
/// # Errors
/// A name that no format has, one twice, or a range of bits without formats.
pub(super) fn chosen(names: &[String], bits: Option<&str>) -> Result<Vec<ScalarName>, Failure> {
    if let Some(text) = bits {
        return within(text);
    }
    if names.is_empty() {
        return Ok(ScalarName::ALL.iter().map(|row| row.0).collect());
    }
    let mut scalars = Vec::new();
    for name in names {
        let scalar = scalar(name)?;
        if scalars.contains(&scalar) {
            return Err(Failure::Input(miette::miette!(
                help = "give each format once",
                "--scalars has {name} twice"
            )));
        }
        scalars.push(scalar);
    }
    Ok(scalars)
}

/// f64 and the fixed-point formats with so many bits behind the point, the coarsest last.
fn within(text: &str) -> Result<Vec<ScalarName>, Failure> {
    let ends = text.split_once("..");
    let number = |text: &str| text.trim().parse::<u32>().ok();
    let ends = ends.and_then(|(least, most)| Some((number(least)?, number(most)?)));
    let Some((least, most)) = ends.filter(|(least, most)| least <= most) else {
        return Err(Failure::Input(miette::miette!(
            help = "give two whole numbers, the smaller first, such as --bits 8..28; both count",
            "--bits {} is no range",
            shortened(text)
        )));
    };
    let mut fixed = fixed();
    fixed.retain(|scalar| (least..=most).contains(&scalar.fraction_bits()));
    if fixed.is_empty() {
        return Err(Failure::Input(miette::miette!(
            help = has(),
            "no format of this build has {least} to {most} bits behind the point"
        )));
    }
    fixed.insert(0, ScalarName::F64);
    Ok(fixed)
}

/// The fixed-point formats of the build, the coarsest last.
fn fixed() -> Vec<ScalarName> {
    let all = ScalarName::ALL.iter().map(|row| row.0);
    let mut fixed: Vec<ScalarName> = all.filter(|scalar| scalar.is_fixed()).collect();
    fixed.sort_by_key(|scalar| std::cmp::Reverse(scalar.fraction_bits()));
    fixed
}

/// What the build has of them, and how to have more.
fn has() -> String {
    let names: Vec<&str> = fixed().iter().map(|scalar| scalar.name()).collect();
    let names = match names.is_empty() {
        true => "no fixed point".to_owned(),
        false => names.join(", "),
    };
    format!("this build has {names}{}", ScalarName::more())
}

/// What who asks for a sweep should know: that it is over the formats of the build, where there are more.
pub(super) fn note(bits: Option<&str>) -> Option<String> {
    let is_part = bits.is_some() && !ScalarName::more().is_empty();
    is_part.then(|| format!("a sweep takes formats that are compiled: {}", has()))
}

/// The command line that asks for the same, for a report.
pub(super) fn command(arguments: &CompareArguments) -> String {
    let CompareArguments {
        scenario,
        scalars,
        bits,
        field,
        particles,
        overrides,
        ..
    } = arguments;
    let mut words = vec![format!("motes compare {}", word(scenario))];
    if !scalars.is_empty() {
        words.push(format!("--scalars {}", scalars.join(",")));
    }
    words.extend(bits.iter().map(|bits| format!("--bits {bits}")));
    words.extend(field.iter().map(|field| format!("--field {field}")));
    words.extend(particles.iter().map(|count| format!("-n {count}")));
    let changes = overrides.iter();
    words.extend(changes.map(|change| format!("--set {}", word(change))));
    words.join(" ")
}

/// A word as a shell takes it, on one line.
fn word(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-=,/+".contains(c);
    match text.chars().all(is_plain) {
        true => text,
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::word;

    #[test]
    fn a_word_is_one_for_a_shell_and_stays_on_its_line() {
        assert_eq!(word("time.end=0.1"), "time.end=0.1");
        assert_eq!(
            word("motion={ kind = \"rest\" }"),
            "'motion={ kind = \"rest\" }'"
        );
        assert_eq!(word("it's\n| a"), "'it'\\''s | a'");
    }
}
