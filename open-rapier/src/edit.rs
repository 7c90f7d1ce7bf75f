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

#[cfg(test)]
mod tests {
    use super::*;

    fn edit(times: usize, change: Change) -> Edit {
        Edit {
            file: "src/lib.rs",
            purpose: "a test",
            find: "tree",
            times,
            change,
        }
    }

    #[test]
    fn changes() {
        let apply = |change| edit(1, change).apply("a tree", "rapier3d").unwrap();
        assert_eq!(
            apply(Change::Replace("bvh of {package}")),
            "a bvh of rapier3d"
        );
        assert_eq!(apply(Change::Before("big ")), "a big tree");
        assert_eq!(apply(Change::After("s")), "a trees");
    }

    #[test]
    fn counts() {
        for (text, times) in [("a bush", 1), ("tree by tree", 1), ("one tree", 2)] {
            let error = edit(times, Change::Replace("bvh")).apply(text, "rapier3d");
            assert!(
                error
                    .unwrap_err()
                    .to_string()
                    .starts_with("src/lib.rs: expected")
            );
        }
        let both = edit(2, Change::Replace("bvh")).apply("tree by tree", "rapier3d");
        assert_eq!(both.unwrap(), "bvh by bvh");
    }
}
