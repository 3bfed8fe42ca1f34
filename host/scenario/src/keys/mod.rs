//! Which keys a scenario may have: the one list that reading, `--set` and the
//! error texts share.

mod gas;
mod linear;

use std::borrow::Cow;

/// The sections of which a file may have several, numbered from 0.
pub(super) const LISTS: [&str; 4] = ["region", "material", "deposit", "wall"];

/// A key that a section may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Key {
    /// Its name in the file.
    pub name: &'static str,
    /// A line that could stand in a file.
    pub example: &'static str,
}

const fn key(name: &'static str, example: &'static str) -> Key {
    Key { name, example }
}

/// What a scenario describes: `[system]` decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// A gas.
    Gas,
    /// A linear first-order system.
    Linear,
}

impl Family {
    /// The family of a file.
    pub(super) fn of(has_system: bool) -> Self {
        if has_system { Self::Linear } else { Self::Gas }
    }

    pub(super) fn other(self) -> Self {
        Self::of(self == Self::Gas)
    }
}

type Sections = &'static [(&'static str, &'static [Key])];

/// The section of the keys above all sections.
pub(super) const ROOT: &str = "";

/// The section of definitions: its keys have any name.
pub(super) const DEFINE: &str = "define";

/// The section of the largest errors.
pub(super) const TOLERANCE: &str = "tolerance";

/// The sections that are the same in every scenario.
const SHARED: Sections = &[
    (
        "units",
        &[
            key("length", "length = \"m\""),
            key("mass", "mass = \"kg\""),
            key("time", "time = \"s\""),
        ],
    ),
    // Any name.
    ("define", &[key("k", "k = \"2*pi\"")]),
    (
        "domain",
        &[
            key("lower", "lower = [-1.0]"),
            key("upper", "upper = [1.0]"),
            key("sides", "sides = [\"mirror\"]"),
        ],
    ),
    (
        "cut-off",
        &[
            key("name", "name = \"cubic-spline\""),
            key("eta", "eta = 1.2"),
            key("theta", "theta = 0.75"),
            key("epsilon", "epsilon = 0.01"),
        ],
    ),
    (
        "output.window",
        &[
            key("lower", "lower = [-0.5]"),
            key("upper", "upper = [0.5]"),
        ],
    ),
    (
        "output.snapshots",
        &[
            key("every", "every = 0.01"),
            key("steps", "steps = 10"),
            key("format", "format = \"vtu\""),
        ],
    ),
    (
        "tolerance.FIELD",
        &[
            key("l1", "l1 = 0.0035"),
            key("l2", "l2 = 0.01"),
            key("linf", "linf = 0.1"),
            key("mean", "mean = 0.0035"),
            key("rms", "rms = 0.01"),
            key("relative_l1", "relative_l1 = 0.01"),
            key("mass_l1", "mass_l1 = 0.01"),
            key("reason", "reason = \"1.05 of what 900 particles give\""),
        ],
    ),
];

/// The sections of a family, each with its keys.
pub(super) fn sections(
    family: Family,
) -> impl Iterator<Item = &'static (&'static str, &'static [Key])> {
    let own = match family {
        Family::Gas => gas::SECTIONS,
        Family::Linear => linear::SECTIONS,
    };
    SHARED.iter().chain(own)
}

/// The keys of a section (`""` for those above all sections; `region.3` is a
/// `region`, `wall.0.series` a `wall.series`, `tolerance.density` a `tolerance.FIELD`); none if
/// there is no such section.
pub(super) fn keys_of(family: Family, section: &str) -> &'static [Key] {
    let kind = match section.split_once('.') {
        Some((TOLERANCE, field)) if !field.contains('.') => Cow::Borrowed("tolerance.FIELD"),
        _ => without_number(section),
    };
    sections(family)
        .find(|(name, _)| *name == kind)
        .map_or(&[], |(_, keys)| keys)
}

/// A section of a list without its number.
fn without_number(section: &str) -> Cow<'_, str> {
    let mut parts = section.splitn(3, '.');
    match (parts.next(), parts.next(), parts.next()) {
        (Some(list), Some(index), inner)
            if LISTS.contains(&list) && index.bytes().all(|b| b.is_ascii_digit()) =>
        {
            inner.map_or(Cow::Borrowed(list), |inner| Cow::Owned(path(list, inner)))
        }
        _ => Cow::Borrowed(section),
    }
}

/// Whether a section has a key of that name.
pub(super) fn has(family: Family, section: &str, name: &str) -> bool {
    // The components of a system have names of their own, and so have definitions.
    let is_component = family == Family::Linear && section == TOLERANCE;
    is_component || section == DEFINE || names(family, section).any(|known| known == name)
}

/// Whether a key is a section or a plain value, as the file likes.
pub(super) fn is_either(path: &str) -> bool {
    matches!(path, "output.exact" | "system.velocity")
}

/// The names of the keys of a section.
pub(super) fn names(family: Family, section: &str) -> impl Iterator<Item = &'static str> {
    keys_of(family, section).iter().map(|key| key.name)
}

/// The line to write for a key given by its section and name.
pub(super) fn example(family: Family, section: &str, name: &str) -> &'static str {
    keys_of(family, section)
        .iter()
        .find(|key| key.name == name)
        .map_or("", |key| key.example)
}

/// The path of a key: `section.key`, or `key` above all sections.
pub(super) fn path(section: &str, key: &str) -> String {
    if section.is_empty() {
        key.to_owned()
    } else {
        format!("{section}.{key}")
    }
}
