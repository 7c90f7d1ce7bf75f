//! All results of a run.

use crate::row::Row;

/// All results of a run, in the order of the tables.
#[derive(Clone, Debug, Default)]
pub(super) struct Report {
    pub(super) rows: Vec<Row>,
}

impl Report {
    pub(super) fn of_dim(&self, dim: u8) -> impl Iterator<Item = &Row> + Clone {
        self.rows.iter().filter(move |row| row.dim == dim)
    }

    pub(super) fn differing(&self) -> usize {
        self.rows.iter().filter(|row| !row.equal).count()
    }

    pub(super) fn is_equal(&self) -> bool {
        self.differing() == 0
    }
}
