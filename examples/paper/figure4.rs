//! Figure 4: squares that converge on the centre, frame by frame.

use crate::method;
use crate::page::Page;
use crate::progress::progress_bar;
use crate::published::CONVERGING;
use crate::race::{race, unit_boxes};
use crate::rapier;
use crate::table::{Table, digits};
use anyhow::Result;
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_charts::{Axis, Chart, Panel, Series, color};
use unisize_pictures::{Camera, Drawing, Legend, palette, thousands};
use unisize_scenes::ConvergingBoxes;

const COUNT: usize = 100_000;
const FRAMES: usize = 2 * ConvergingBoxes::HALF_WAY;

const QUICK_COUNT: usize = 1000;
const QUICK_FRAMES: usize = 25;

/// The number of frames that are drawn.
const PICTURES: usize = 4;
const PICTURE_SIZE: [usize; 2] = [420, 300];

/// A square with this many pairs has the last colour of the palette.
const CROWDED: f32 = 24.0;

pub(crate) fn run(page: &Page, quick: bool) -> Result<()> {
    let (count, frames) = if quick {
        (QUICK_COUNT, QUICK_FRAMES)
    } else {
        (COUNT, FRAMES)
    };
    let bar = progress_bar(frames as u64 + 1);
    bar.set_message("converging");
    let mut boxes = ConvergingBoxes::new(count, 7);
    let mut methods = method::all();
    methods.splice(0..0, rapier::hierarchies(boxes.mins()));
    let next = |frame: &mut Vec<_>| {
        unit_boxes(boxes.mins(), frame);
        boxes.advance();
    };
    let outcome = race(&mut methods, frames, next, |_| bar.inc(1))?;
    draw_frames(page, count, frames)?;
    bar.finish_and_clear();

    let mut table = Table::new([
        "",
        "worst, ms",
        "average, ms",
        "median, ms",
        "worst / median",
    ]);
    let mut row = vec!["the paper, laptop of 2014".to_owned()];
    row.extend(CONVERGING.map(digits));
    row.push(digits(CONVERGING[0] / CONVERGING[2]));
    table.push(row);
    let mut lines = Vec::new();
    for (method, times) in methods.iter().zip(&outcome.times) {
        let (worst, median) = (times.worst(), times.median());
        let mut row = vec![method.name().to_owned()];
        row.extend([worst, times.mean(), median, worst / median].map(digits));
        table.push(row);
        let points = (1..).zip(times.frames());
        let points = points.map(|(frame, &ms)| (f64::from(frame), ms));
        lines.push(Series::new(method.name(), method.color(), points));
    }
    let pairs = (1..).zip(&outcome.pairs);
    let pairs = pairs.map(|(frame, &pairs)| (f64::from(frame), pairs as f64 / 1e3));
    // The slowest comes first in the table, the fastest in the legend.
    lines.reverse();
    let panel = Panel::new("", Axis::linear("frame"), Axis::log("milliseconds"), lines).right(
        Axis::linear("thousands of pairs"),
        Series::new("pairs (right)", color::PALE, pairs),
    );
    let title = format!("{count} squares converge on the centre");
    Chart::new(title, [panel]).write_svg(&page.picture("figure4.svg"))?;
    page.put("figure4", &table)
}

/// Draws four frames at even intervals, as cubes on a plane coloured by how many others they overlap.
fn draw_frames(page: &Page, count: usize, frames: usize) -> Result<()> {
    let mut boxes = ConvergingBoxes::new(count, 7);
    let camera = Camera::orbit([0.0; 3], boxes.half_side() * 4.2)
        .turned(0.6)
        .raised(0.75);
    let interval = frames / (PICTURES + 1);
    for picture in 1..=PICTURES {
        (0..interval).for_each(|_| boxes.advance());
        let mut squares: Vec<Aabb<f32, 2>> = Vec::new();
        unit_boxes(boxes.mins(), &mut squares);
        let mut pairs = Vec::new();
        GridSweep::default().find_pairs(&squares, &mut pairs)?;
        let mut degrees = vec![0.0_f32; count];
        for index in pairs.iter().flatten() {
            degrees[*index as usize] += 1.0;
        }
        let mut drawing = Drawing::new();
        for (&[x, y], degree) in boxes.mins().iter().zip(degrees) {
            let center = [x + 0.5, 0.5, y + 0.5];
            let color = palette::by_share(degree / CROWDED);
            drawing.cuboid(center, [0.5; 3], [0.0, 0.0, 0.0, 1.0], color);
        }
        let frame = picture * interval;
        let legend = Legend::new(format!("frame {frame}")).fact("pairs", thousands(pairs.len()));
        let mut image = drawing.picture(&camera, PICTURE_SIZE)?;
        image.legend(&legend);
        // Named by its place in the row, so that a quick run has the same names.
        image.write_png(&page.picture(&format!("figure4-{picture}.png")))?;
    }
    Ok(())
}
