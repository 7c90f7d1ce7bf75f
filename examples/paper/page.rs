//! The page of all results.

use crate::table::Table;
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};

/// The page as it is in the repository.
const TEXT: &str = include_str!("../../docs/paper.md");

/// `paper.md` in a folder, and the folder `paper` beside it.
pub(crate) struct Page {
    file: PathBuf,
    pictures: PathBuf,
}

impl Page {
    /// The page in this folder; a new one starts with the text of the repository.
    pub(crate) fn open(folder: &Path) -> Result<Self> {
        let page = Self {
            file: folder.join("paper.md"),
            pictures: folder.join("paper"),
        };
        let cannot = || format!("cannot create {}", page.pictures.display());
        fs::create_dir_all(&page.pictures).with_context(cannot)?;
        if !page.file.exists() {
            page.write(TEXT)?;
        }
        Ok(page)
    }

    /// Where a picture goes.
    pub(crate) fn picture(&self, name: &str) -> PathBuf {
        self.pictures.join(name)
    }

    /// Prints a table, and writes it into the page between the comments with this name.
    pub(crate) fn put(&self, name: &str, table: &Table) -> Result<()> {
        println!("{name}\n\n{table}");
        let text = fs::read_to_string(&self.file)
            .with_context(|| format!("cannot read {}", self.file.display()))?;
        let text = replaced(&text, name, &table.to_string());
        self.write(&text.with_context(|| format!("in {}", self.file.display()))?)
    }

    fn write(&self, text: &str) -> Result<()> {
        fs::write(&self.file, text).with_context(|| format!("cannot write {}", self.file.display()))
    }
}

/// The text with another block between the two comments of this name.
fn replaced(text: &str, name: &str, block: &str) -> Result<String> {
    let [begin, end] = ["begin", "end"].map(|which| format!("<!-- {which} {name} -->\n"));
    let mut parts = text.split(&begin);
    let (before, rest) = (parts.next().unwrap_or_default(), parts.next());
    ensure!(parts.next().is_none(), "{name} begins more than once");
    let rest = rest.with_context(|| format!("there is no place for {name}"))?;
    let (_, after) = rest
        .split_once(&end)
        .with_context(|| format!("{name} does not end"))?;
    Ok([before, &begin, block, &end, after].concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_replaces_what_was_there() {
        let text = "a\n<!-- begin x -->\nold\n<!-- end x -->\nb\n";
        let new = replaced(text, "x", "new\n").unwrap();
        assert_eq!(new, "a\n<!-- begin x -->\nnew\n<!-- end x -->\nb\n");
        assert_eq!(replaced(&new, "x", "new\n").unwrap(), new);
        assert!(replaced(text, "y", "").is_err());
        assert!(replaced("<!-- begin x -->\n", "x", "").is_err());
    }

    #[test]
    fn the_page_has_a_place_for_everything() {
        for name in [
            "table1",
            "table1-ratios",
            "figure3",
            "figure4",
            "third-axis",
            "third-axis-growth",
            "threads",
            "cache",
            "continuous",
            "continuous-rapier",
            "stampede",
            "chains",
            "backbone",
        ] {
            assert!(replaced(TEXT, name, "").is_ok(), "{name}");
        }
    }
}
