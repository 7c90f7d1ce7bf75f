//! Figure 4: squares that converge on the centre, frame by frame.

use crate::Run;
use crate::published::CONVERGING;
use crate::race::{self, race, unit_boxes};
use anyhow::Result;
use unisize_charts::{Axis, Chart, Panel, Series};
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
        for (column, value) in [
            ("worst, ms", worst),
            ("average, ms", average),
            ("median, ms", median),
            ("worst / median", worst / median),
        ] {
            run.table.add("figure4", row, column, value);
        }
    };
    add("the paper, laptop of 2014", CONVERGING);
    let mut curves = Vec::new();
    for (method, times) in methods.iter().zip(&outcome.times) {
        add(method.name, [times.worst(), times.mean(), times.median()]);
        let points = (1..).map(f64::from).zip(times.0.iter().copied());
        curves.push(Series::new(method.name, method.color, points));
    }
    // The slowest comes first in the table, the fastest in the legend.
    curves.reverse();
    let panel = Panel::new("", Axis::linear("frame"), Axis::log("milliseconds"), curves);
    let title = format!("{count} squares converge on the centre");
    Chart::new(title, [panel]).write_svg(&run.pictures.join("figure4.svg"))
}
