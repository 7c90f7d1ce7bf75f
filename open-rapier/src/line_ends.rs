//! Line ends and the byte-order mark of a manifest, which `toml_edit` drops: whoever has them wants them back.

const MARK: &str = "\u{feff}";

pub(crate) fn without_mark(text: &str) -> &str {
    text.strip_prefix(MARK).unwrap_or(text)
}

/// `new`, with the byte-order mark of `old`, if it has one, and the line ends of its first line.
pub(crate) fn keep(old: &str, new: &str) -> String {
    let mark = if old.starts_with(MARK) { MARK } else { "" };
    let new = new.replace("\r\n", "\n");
    let first = old.split_inclusive('\n').next();
    match first.is_some_and(|line| line.ends_with("\r\n")) {
        true => format!("{mark}{}", new.replace('\n', "\r\n")),
        false => format!("{mark}{new}"),
    }
}
