//! Table 1: drifting squares at several numbers and densities, by all methods.

use crate::Run;
use crate::published::LINES;
use crate::race::{self, drift, race};
use crate::table::count;
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
        let row = row(density, n);
        let mut drifting = DriftingBoxes::<2>::new(n, density, 7);
        let mut methods = race::methods();
        let next = |boxes: &mut _| drift(&mut drifting, boxes);
        let outcome = race(&mut methods, run.choose(2, FRAMES), next)?;
        run.table.add("table1", &row, "pairs", outcome.pairs[0]);
        let mut add = |column: &str, value| run.table.add("table1", &row, column, value);
        add("paper: Bar92", bar92);
        add("paper: KMZ13", kmz13);
        add("paper: theirs", theirs);
        for (method, times) in methods.iter().zip(&outcome.times) {
            add(method.name, times.median());
        }
    }
    Ok(())
}
