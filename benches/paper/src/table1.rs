//! Table 1: drifting squares at several numbers and densities, by all methods.

use crate::published::LINES;
use crate::race::{self, drift, race};
use crate::run::{Run, count};
use anyhow::Result;
use unisize_scenes::DriftingBoxes;

/// Frames of which the median is taken.
const FRAMES: usize = 5;

/// The row of squares of this density.
pub(crate) fn row(density: f64, n: usize) -> String {
    format!("d = {density}, n = {}", count(n))
}

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    for (density, size, [bar92, kmz13, theirs], _) in LINES {
        let n = run.squares(size);
        let mut drifting = DriftingBoxes::<2>::new(n, density, 7);
        let mut methods = race::methods();
        let next = |boxes: &mut _| drift(&mut drifting, boxes);
        let outcome = race(&mut methods, run.choose(2, FRAMES), next)?;
        let mut columns = vec![
            ("pairs", outcome.pairs[0].into()),
            ("bar92", bar92.into()),
            ("kmz13", kmz13.into()),
            ("theirs", theirs.into()),
        ];
        columns.extend(outcome.medians(&methods));
        run.row("table1", &row(density, n), &columns)?;
    }
    Ok(())
}
