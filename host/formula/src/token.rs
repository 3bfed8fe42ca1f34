//! Text to numbers, names and signs.

use std::ops::Range;

use crate::error::{FormulaError, FormulaFault};

/// What a formula is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Token<'a> {
    Number(f64),
    Name(&'a str),
    Sign(&'static str),
}

/// All signs, longer ones before those that they begin with.
const SIGNS: [&str; 19] = [
    "<=", ">=", "==", "!=", "&&", "||", "**", "<", ">", "!", "+", "-", "*", "/", "^", "(", ")",
    ",", "%",
];

/// The most bytes of a formula.
const LONGEST: usize = 10_000;

/// The tokens of a text, each with its bytes.
pub(crate) fn tokens(text: &str) -> Result<Vec<(Token<'_>, Range<usize>)>, FormulaError> {
    if text.len() > LONGEST {
        let fault = FormulaFault::TooMuch("10000 characters");
        return Err(FormulaError::new(fault, 0..text.len()));
    }
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let (token, length) = if first.is_whitespace() {
            at += first.len_utf8();
            continue;
        } else if first.is_ascii_digit() || first == '.' {
            number(rest, at)?
        } else if is_letter(first) {
            let length = rest.find(|c| !is_letter(c) && !c.is_ascii_digit());
            let length = length.unwrap_or(rest.len());
            (Token::Name(&rest[..length]), length)
        } else {
            let sign = SIGNS.iter().find(|sign| rest.starts_with(**sign));
            let Some(sign) = sign else {
                let span = at..at + first.len_utf8();
                return Err(FormulaError::new(FormulaFault::Character(first), span));
            };
            (Token::Sign(sign), sign.len())
        };
        tokens.push((token, at..at + length));
        at += length;
    }
    Ok(tokens)
}

/// Whether a name may begin with it.
pub(crate) fn is_letter(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

/// A number at the front: digits with a point, and a power of ten.
fn number(rest: &str, at: usize) -> Result<(Token<'_>, usize), FormulaError> {
    let bytes = rest.as_bytes();
    let digits = |from: usize| {
        let count = bytes[from..]
            .iter()
            .take_while(|b| b.is_ascii_digit())
            .count();
        from + count
    };
    let mut end = digits(0);
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    // `2*e` has no power, `2e` is refused as `2` beside `e`.
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let signed = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if bytes.get(signed).is_some_and(u8::is_ascii_digit) {
            end = digits(signed);
        }
    }
    // 1.2.3 is one slip, not two numbers.
    if bytes.get(end) == Some(&b'.') {
        let all = bytes
            .iter()
            .take_while(|b| b.is_ascii_digit() || **b == b'.');
        let length = all.count();
        let fault = FormulaFault::Number(rest[..length].to_owned());
        return Err(FormulaError::new(fault, at..at + length));
    }
    let digits = &rest[..end];
    match digits.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok((Token::Number(value), end)),
        Ok(_) => {
            let fault = FormulaFault::TooLarge(digits.to_owned());
            Err(FormulaError::new(fault, at..at + end))
        }
        Err(_) => {
            let fault = FormulaFault::Number(digits.to_owned());
            Err(FormulaError::new(fault, at..at + end))
        }
    }
}
