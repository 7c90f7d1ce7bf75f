//! An edit of a text: what is looked for, how often it must be there, and what becomes of it.

use anyhow::{Result, ensure};

/// What becomes of the text that was found.
pub(crate) enum Change {
    Replace(&'static str),
    Before(&'static str),
    After(&'static str),
}

/// One line of the tables in `seam.rs`.
pub(crate) struct Edit {
    /// The file, from the folder of the package.
    pub(crate) file: &'static str,
    /// What the edit is for, as the note in the copy tells it.
    pub(crate) purpose: &'static str,
    /// The text that is looked for.
    pub(crate) find: &'static str,
    /// How often it must occur: fewer or more means that this is not the text the edit was written for.
    pub(crate) times: usize,
    /// What becomes of it. `{package}` stands for the package's name.
    pub(crate) change: Change,
}

impl Edit {
    /// The text with every occurrence edited.
    pub(crate) fn apply(&self, text: &str, package: &str) -> Result<String> {
        let found = text.matches(self.find).count();
        ensure!(
            found == self.times,
            "{}: expected {} of the text below, found {found}; nothing was written\n{}",
            self.file,
            self.times,
            self.find,
        );
        let new = match self.change {
            Change::Replace(new) => new.to_owned(),
            Change::Before(new) => format!("{new}{}", self.find),
            Change::After(new) => format!("{}{new}", self.find),
        };
        Ok(text.replace(self.find, &new.replace("{package}", package)))
    }
}
