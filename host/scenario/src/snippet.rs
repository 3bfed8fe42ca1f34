//! The stretch of a text that a message shows, cut where its lines are long.

use std::ops::Range;

use miette::{
    LabeledSpan, MietteError, MietteSpanContents, NamedSource, SourceCode, SourceSpan, SpanContents,
};

/// Characters of a value that a message repeats.
const MOST_OF_VALUE: usize = 60;

/// Characters of a sentence that a value stands in.
const MOST_OF_SENTENCE: usize = 400;

/// A value as a message repeats it: its beginning, and how long it is, where it is long.
pub fn shortened(text: &str) -> String {
    cut(text, MOST_OF_VALUE)
}

/// The same of a sentence that values stand in.
pub fn shortened_sentence(text: &str) -> String {
    cut(text, MOST_OF_SENTENCE)
}

fn cut(text: &str, most: usize) -> String {
    // A value a little longer than that is shorter than what would stand for its end.
    match text.char_indices().nth(most + 30) {
        None => text.to_owned(),
        Some(_) => {
            let shown: String = text.chars().take(most).collect();
            format!("{shown}... ({} characters)", text.chars().count())
        }
    }
}

/// A named text with the bytes that a message is about.
#[derive(Debug)]
pub(super) struct Snippet {
    text: NamedSource<String>,
    span: Range<usize>,
}

/// Bytes of a line that are shown before and behind the place.
const AROUND: usize = 60;

/// Bytes of lines that are shown whole.
const SHORT: usize = 400;

impl Snippet {
    pub fn new(name: String, text: String, span: Range<usize>) -> Self {
        let text = NamedSource::new(name, text);
        Self { text, span }
    }

    /// Line and column of the place, each from 1.
    pub fn line_and_column(&self) -> Option<(usize, usize)> {
        let before = self.text.inner().get(..self.span.start)?;
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = 1 + before.matches('\n').count();
        Some((line, 1 + before[line_start..].chars().count()))
    }

    /// The place, as far as it is shown.
    pub fn label(&self) -> LabeledSpan {
        let Range { start, end } = self.span;
        let end = self.boundary(end.min(start + AROUND));
        LabeledSpan::at(start..end.max(start), "here")
    }

    /// The last place between characters that is not behind a byte.
    fn boundary(&self, mut byte: usize) -> usize {
        let text = self.text.inner();
        byte = byte.min(text.len());
        while !text.is_char_boundary(byte) {
            byte -= 1;
        }
        byte
    }
}

impl SourceCode for Snippet {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let whole = self.text.read_span(span, before, after)?;
        if whole.data().len() <= SHORT {
            return Ok(whole);
        }
        // The part of its line around the place.
        let text = self.text.inner();
        let place = self.boundary(span.offset());
        let line = text[..place].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = text[place..]
            .find('\n')
            .map_or(text.len(), |end| place + end);
        let start = self.boundary(place.saturating_sub(AROUND)).max(line);
        let end = self.boundary((place + span.len()).max(place + AROUND));
        let end = end.min(line_end.max(place + span.len()));
        Ok(Box::new(MietteSpanContents::new_named(
            self.text.name().to_owned(),
            &text.as_bytes()[start..end],
            (start, end - start).into(),
            text[..start].matches('\n').count(),
            text[line..start].chars().count(),
            1,
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_long_is_cut_and_says_how_long_it_was() {
        assert_eq!(shortened("0.5"), "0.5");
        let short = shortened(&"ä".repeat(50_000));
        assert!(short.chars().count() < 90, "{short}");
        assert!(short.ends_with("(50000 characters)"));
    }

    #[test]
    fn a_long_line_is_shown_around_its_place_and_a_short_one_with_its_neighbours() {
        let long = format!("a = 1\nb = \"{}\"\nc = 2\n", "é".repeat(50_000));
        let place = 11..long.len() - 7;
        let snippet = Snippet::new("x.toml".to_owned(), long, place);
        let label = snippet.label();
        let shown = snippet.read_span(label.inner(), 1, 1).unwrap();
        let text = std::str::from_utf8(shown.data()).unwrap();
        assert!(text.len() < 200 && text.starts_with("b = \""), "{text}");
        assert_eq!((shown.line(), shown.column()), (1, 0));
        assert_eq!(snippet.line_and_column(), Some((2, 6)));
        let short = Snippet::new(
            "x.toml".to_owned(),
            "a = 1\nb = 2\nc = 3\n".to_owned(),
            10..11,
        );
        let shown = short.read_span(short.label().inner(), 1, 1).unwrap();
        assert_eq!(shown.data(), b"a = 1\nb = 2\nc = 3\n");
    }
}
