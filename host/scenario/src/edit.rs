//! Changes to TOML text in place, by the bytes that the parser found: what is not changed keeps its
//! comments, its blanks and its order.

use std::borrow::Cow;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::document::Document;
use crate::keys;

/// New text for some bytes.
#[derive(Debug)]
pub(super) struct Edit {
    range: Range<usize>,
    text: String,
}

/// The text with all changes, of which no two have a byte in common.
pub(super) fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    // From the end, so that the bytes before stay where they are; of two that begin at the same
    // byte the one that takes something out goes first, or it would take out the other.
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    let mut text = text.to_owned();
    for edit in edits.iter().rev() {
        text.replace_range(edit.range.clone(), &edit.text);
    }
    text
}

/// A table of a document, and how it is written.
#[derive(Clone)]
pub(super) struct Spot<'a> {
    text: &'a str,
    table: &'a DeTable<'a>,
    form: Form<'a>,
    /// The section: `output.window`.
    path: String,
    /// What stands before each of its keys where it is written as `window.lower = ...`.
    prefix: String,
}

#[derive(Clone)]
enum Form<'a> {
    /// Lines: below a header, or above all headers.
    Lines { header: Option<Range<usize>> },
    /// Entries of a table in braces.
    Braces {
        all: &'a DeTable<'a>,
        range: Range<usize>,
    },
    /// None of its own: it is only named in headers, as `tolerance` is in `[tolerance.density]`.
    Implied,
}

/// A key as TOML writes it: in quotes where it has more than letters, digits, `-` and `_`, as a
/// definition of a function has.
pub(super) fn written_key(key: &str) -> Cow<'_, str> {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    match key.chars().all(is_bare) {
        true => Cow::Borrowed(key),
        false => Cow::Owned(format!("{key:?}")),
    }
}

impl<'a> Spot<'a> {
    /// The keys above all sections.
    pub fn root(document: &'a Document<'a>) -> Self {
        Self {
            text: document.text,
            table: &document.table,
            form: Form::Lines { header: None },
            path: String::new(),
            prefix: String::new(),
        }
    }

    fn entry(&self, key: &str) -> Option<(Range<usize>, &'a Spanned<DeValue<'a>>)> {
        let mut entries = self.table.iter();
        let (name, value) = entries.find(|(name, _)| name.get_ref() == key)?;
        Some((name.span(), value))
    }

    /// Whether its keys are those above all sections.
    pub fn is_root(&self) -> bool {
        self.path.is_empty()
    }

    /// Whether it has a key.
    pub fn has(&self, key: &str) -> bool {
        self.entry(key).is_some()
    }

    /// The table under a key, if it is one.
    pub fn inner(&self, key: &str) -> Option<Spot<'a>> {
        let (_, value) = self.entry(key)?;
        self.opened(keys::path(&self.path, key), key, value)
    }

    /// The table of this number in a list, if there are as many, and how many there are.
    pub fn numbered(&self, list: &str, index: &str) -> (usize, Option<Spot<'a>>) {
        let Some(DeValue::Array(values)) = self.entry(list).map(|(_, value)| value.get_ref())
        else {
            return (0, None);
        };
        let number = index.parse::<usize>().ok();
        let value = number.and_then(|number| values.get(number));
        let path = keys::path(list, index);
        let spot = value.and_then(|value| self.opened(path, list, value));
        (values.len(), spot)
    }

    fn opened(&self, path: String, key: &str, value: &'a Spanned<DeValue<'a>>) -> Option<Spot<'a>> {
        let DeValue::Table(table) = value.get_ref() else {
            return None;
        };
        let range = value.span();
        let dotted = || format!("{}{key}.", self.prefix);
        let (form, prefix) = match self.text.as_bytes().get(range.start) {
            Some(b'{') => (Form::Braces { all: table, range }, String::new()),
            Some(b'[') => {
                let header = Some(range);
                (Form::Lines { header }, String::new())
            }
            // The bytes are those of the key: in a header, or before a dot.
            _ => match &self.form {
                Form::Lines { .. } if self.is_in_header(range.start) => {
                    (Form::Implied, String::new())
                }
                form => (form.clone(), dotted()),
            },
        };
        Some(Spot {
            text: self.text,
            table,
            form,
            path,
            prefix,
        })
    }

    fn is_in_header(&self, byte: usize) -> bool {
        let line = self.text[..byte]
            .rfind('\n')
            .map_or(0, |newline| newline + 1);
        let before = self.text[line..byte].trim_start_matches('\u{feff}');
        before.trim_start().starts_with('[')
    }

    /// The changes that put a value under a key in the place of the old one, and take out the
    /// `rivals` of the key. None where the old one is a section with sections in it.
    pub fn put(&self, key: &str, value: &str, rivals: &[&str]) -> Option<Vec<Edit>> {
        let mut out: Vec<Range<usize>> = Vec::new();
        for rival in rivals {
            self.written(rival, &mut out)?;
        }
        let mut edits = Vec::new();
        let mut old = Vec::new();
        self.written(key, &mut old)?;
        let plain = self
            .entry(key)
            .filter(|(_, value)| is_value(self.text, value));
        match plain {
            Some((_, old)) => edits.push(Edit {
                range: old.span(),
                text: value.to_owned(),
            }),
            None => {
                out.extend(old);
                edits.push(self.insertion(key, value, &out));
            }
        }
        edits.extend(self.removals(out));
        Some(edits)
    }

    /// The changes that make a section above which there is nothing, with one key.
    pub fn append(&self, section: &str, key: &str, value: &str) -> Vec<Edit> {
        let newline = newline_of(self.text);
        let end = self.text.len();
        let before = match self.text.ends_with('\n') || self.text.is_empty() {
            true => "",
            false => newline,
        };
        vec![Edit {
            range: end..end,
            text: format!(
                "{before}{newline}[{section}]{newline}{key} = {value}{newline}",
                key = written_key(key)
            ),
        }]
    }

    /// A new entry, behind the last of those that stay.
    fn insertion(&self, key: &str, value: &str, out: &[Range<usize>]) -> Edit {
        let entry = format!("{}{} = {value}", self.prefix, written_key(key));
        let at = |byte: usize, text: String| Edit {
            range: byte..byte,
            text,
        };
        match &self.form {
            Form::Implied => {
                let mut edits = self.append(&self.path, key, value);
                edits.remove(0)
            }
            Form::Lines { header } => {
                let newline = newline_of(self.text);
                let last = last_byte(self.text, self.table).or(header.as_ref().map(|h| h.end));
                match last {
                    Some(byte) => at(line_end(self.text, byte), format!("{newline}{entry}")),
                    None => {
                        let start =
                            self.text.len() - self.text.trim_start_matches('\u{feff}').len();
                        at(start, format!("{entry}{newline}"))
                    }
                }
            }
            Form::Braces { all, range } => {
                let all = entries(self.text, all);
                let kept = all.iter().rfind(|entry| !out.contains(entry));
                match (kept, all.first()) {
                    (Some(last), _) => at(last.end, format!(", {entry}")),
                    // In the place of those that go.
                    (None, Some(first)) => at(first.start, entry),
                    (None, None) => at(range.start + 1, format!(" {entry} ")),
                }
            }
        }
    }

    /// Adds where the entries of a key are written, if there are any: lines whole with their
    /// comments. None where it is a section with sections in it.
    fn written(&self, key: &str, out: &mut Vec<Range<usize>>) -> Option<()> {
        let Some((name, value)) = self.entry(key) else {
            return Some(());
        };
        if is_value(self.text, value) {
            out.push(match self.form {
                Form::Braces { .. } => entry_start(self.text, name.start)..value.span().end,
                _ => whole_lines(self.text, name.start, value.span().end),
            });
            return Some(());
        }
        let inner = self.inner(key)?;
        match &inner.form {
            Form::Implied => None,
            Form::Lines {
                header: Some(header),
            } if inner.prefix.is_empty() => {
                let last = last_byte(self.text, inner.table).unwrap_or(header.end);
                out.push(whole_lines(self.text, header.start, last));
                Some(())
            }
            _ => inner
                .table
                .keys()
                .try_for_each(|key| inner.written(key.get_ref(), out)),
        }
    }

    /// The changes that take out entries, with the commas that go with them.
    fn removals(&self, out: Vec<Range<usize>>) -> Vec<Edit> {
        let removed = |range| Edit {
            range,
            text: String::new(),
        };
        let Form::Braces { all, .. } = &self.form else {
            return out.into_iter().map(removed).collect();
        };
        let all = entries(self.text, all);
        let mut edits = Vec::new();
        let mut first = 0;
        while first < all.len() {
            let run = all[first..].iter().take_while(|entry| out.contains(entry));
            let next = first + run.count();
            if next > first {
                // With the comma before; the first entries with the comma behind.
                let start = match first {
                    0 => all[0].start,
                    _ => all[first - 1].end,
                };
                let end = match all.get(next) {
                    Some(entry) if first == 0 => entry.start,
                    _ => all[next - 1].end,
                };
                edits.push(removed(start..end));
            }
            first = next + 1;
        }
        edits
    }
}

/// Whether it is written behind a `=`: not as a section with a header, not key by key.
fn is_value(text: &str, value: &Spanned<DeValue<'_>>) -> bool {
    let start = value.span().start;
    match value.get_ref() {
        DeValue::Table(_) => text.as_bytes().get(start) == Some(&b'{'),
        // A list of sections has the bytes of its first header.
        DeValue::Array(values) => values
            .first()
            .is_none_or(|first| first.span().start > start),
        _ => true,
    }
}

/// Where the last value of a table ends, sections of their own left out.
fn last_byte(text: &str, table: &DeTable<'_>) -> Option<usize> {
    let ends = table.values().filter_map(|value| match value.get_ref() {
        _ if is_value(text, value) => Some(value.span().end),
        DeValue::Table(dotted) if text.as_bytes().get(value.span().start) != Some(&b'[') => {
            last_byte(text, dotted)
        }
        _ => None,
    });
    ends.max()
}

/// The entries of a table in braces, in the order of the text.
fn entries(text: &str, table: &DeTable<'_>) -> Vec<Range<usize>> {
    fn add(text: &str, table: &DeTable<'_>, all: &mut Vec<Range<usize>>) {
        for (name, value) in table.iter() {
            match value.get_ref() {
                DeValue::Table(dotted) if !is_value(text, value) => add(text, dotted, all),
                _ => all.push(entry_start(text, name.span().start)..value.span().end),
            }
        }
    }
    let mut all = Vec::new();
    add(text, table, &mut all);
    all.sort_by_key(|entry| entry.start);
    all
}

/// Where an entry in braces begins, given a byte of its key: `a` of `a.b = 1`.
fn entry_start(text: &str, byte: usize) -> usize {
    let before = &text[..byte];
    let start = before.rfind(['{', ',']).map_or(0, |mark| mark + 1);
    let blank = text[start..].len() - text[start..].trim_start().len();
    start + blank
}

/// From the end of the line before to the end of the last line.
fn whole_lines(text: &str, first: usize, last: usize) -> Range<usize> {
    let before = text[..first].rfind('\n').unwrap_or(0);
    let before = match text[..before].ends_with('\r') {
        true => before - 1,
        false => before,
    };
    before..line_end(text, last)
}

/// Where the line of a byte ends.
fn line_end(text: &str, byte: usize) -> usize {
    let end = text[byte..].find('\n').map_or(text.len(), |end| byte + end);
    match text[byte..end].ends_with('\r') {
        true => end - 1,
        false => end,
    }
}

/// How the lines of a text end.
fn newline_of(text: &str) -> &'static str {
    if text.contains("\r\n") { "\r\n" } else { "\n" }
}
