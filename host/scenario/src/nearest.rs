//! The known name nearest to a mistyped one.

/// The nearest of `known` to `name`, if it is near enough to be a slip:
/// at most one edit in three characters, `_` and `-` and case being equal.
pub(super) fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let folded = fold(name);
    // Every letter is one slip from every other.
    let slips = (folded.len() / 3).max(usize::from(folded.len() > 1));
    known
        .into_iter()
        .map(|candidate| (edits(&folded, &fold(candidate)), candidate))
        .filter(|(distance, _)| *distance <= slips)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

fn fold(name: &str) -> Vec<char> {
    let lower = name.to_lowercase().replace('_', "-");
    lower.chars().collect()
}

/// Levenshtein distance: insertions, deletions and replacements from `a` to `b`.
fn edits(a: &[char], b: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, to) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(from != to);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_counts_insertions_deletions_and_replacements() {
        for (a, b, expected) in [("kitten", "sitting", 3), ("", "abc", 3), ("ab", "ab", 0)] {
            assert_eq!(edits(&fold(a), &fold(b)), expected, "{a} -> {b}");
        }
    }

    #[test]
    fn a_slip_finds_its_name_and_another_word_finds_none() {
        let known = ["gamma", "equation-of-state"];
        assert_eq!(nearest("gama", known), Some("gamma"));
        assert_eq!(
            nearest("equation_of_state", known),
            Some("equation-of-state")
        );
        assert_eq!(nearest("density", known), None);
        assert_eq!(nearest("q", ["x", "y"]), None);
        assert_eq!(nearest("X", ["x", "y"]), Some("x"));
    }
}
