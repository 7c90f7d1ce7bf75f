//! Figure 4: squares that converge on the centre, frame by frame.

use crate::published::CONVERGING;
use crate::race::{self, race, unit_boxes};
use crate::run::Run;
use anyhow::Result;
use unisize_scenes::ConvergingBoxes;

const COUNT: usize = 100_000;
const FRAMES: usize = 2 * ConvergingBoxes::HALF_WAY;

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    let (count, frames) = run.choose((1000, 25), (COUNT, FRAMES));
    let mut boxes = ConvergingBoxes::new(count, 7);
    let mut methods = race::methods();
    let next = |frame: &mut Vec<_>| {
        unit_boxes(boxes.mins(), frame);
        boxes.advance();
    };
    let outcome = race(&mut methods, frames, next)?;
    let mut add = |row: &str, [worst, average, median]: [f64; 3]| {
        let columns = [
            ("worst_ms", worst.into()),
            ("average_ms", average.into()),
            ("median_ms", median.into()),
            ("worst_over_median", (worst / median).into()),
        ];
        run.row("figure4", row, &columns)
    };
    add("the paper, laptop of 2014", CONVERGING)?;
    for (method, times) in methods.iter().zip(&outcome.times) {
        add(method.name, [times.worst(), times.mean(), times.median()])?;
    }
    Ok(())
}
