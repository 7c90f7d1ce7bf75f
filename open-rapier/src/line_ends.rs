//! Line ends and the byte-order mark of a manifest, which `toml_edit` drops: whoever has them wants them back.

const MARK: char = '\u{feff}';

pub(crate) fn without_mark(text: &str) -> &str {
    text.strip_prefix(MARK).unwrap_or(text)
}

/// `new`, with the lines of `old` as they are there: all but those of the one place in which the two differ, which end like the
/// line before them.
pub(crate) fn keep(old: &str, new: &str) -> String {
    let mark = &old[..old.len() - without_mark(old).len()];
    let old: Vec<_> = without_mark(old).split_inclusive('\n').collect();
    let new = new.replace("\r\n", "\n");
    let new: Vec<_> = new.split_inclusive('\n').collect();

    let same = |(old, new): &(&&str, &&str)| old.replace("\r\n", "\n") == **new;
    let head = old.iter().zip(&new).take_while(same).count();
    let (rest, changed) = (&old[head..], &new[head..]);
    let tail = rest.iter().rev().zip(changed.iter().rev());
    let tail = tail.take_while(same).count();

    let before = old[..head].last().or(old.first());
    let mut changed = changed[..changed.len() - tail].concat();
    if before.is_some_and(|line| line.ends_with("\r\n")) {
        changed = changed.replace('\n', "\r\n");
    }
    let rest = rest[rest.len() - tail..].concat();
    [mark, &old[..head].concat(), &changed, &rest].concat()
}

#[cfg(test)]
mod tests {
    use super::keep;

    #[test]
    fn keeps_what_was_not_changed() {
        for (old, new, expected) in [
            ("", "a\n", "a\n"),
            ("a\n", "a\nb\n", "a\nb\n"),
            ("a\r\n", "a\nb\n", "a\r\nb\r\n"),
            ("a\r\nc", "a\nc\nb\n", "a\r\nc\r\nb\r\n"),
            (
                "\u{feff}a\r\nb\nc\r\n",
                "a\nb\nx\nc\n",
                "\u{feff}a\r\nb\nx\nc\r\n",
            ),
            ("a\nb\r\nc\n", "a\nx\nc\n", "a\nx\nc\n"),
            ("a\r\na\n", "a\na\na\n", "a\r\na\na\n"),
            ("a\r\nb\n", "a\nb\n", "a\r\nb\n"),
        ] {
            assert_eq!(keep(old, new), expected, "{old:?}");
        }
    }
}
