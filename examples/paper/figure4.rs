//! Figure 4: squares that converge on the centre, frame by frame.

use crate::published::CONVERGING;
use crate::race::{race, unit_boxes};
use crate::{Run, method};
use anyhow::Result;
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_charts::{Axis, Chart, Panel, Series, color};
use unisize_pictures::{Camera, Drawing, Legend, palette, thousands};
use unisize_scenes::ConvergingBoxes;

const COUNT: usize = 100_000;
const FRAMES: usize = 2 * ConvergingBoxes::HALF_WAY;

/// The number of frames that are drawn.
const PICTURES: usize = 4;
const PICTURE_SIZE: [usize; 2] = [420, 300];

/// A square with this many pairs has the last colour of the palette.
const CROWDED: f32 = 24.0;

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    let (count, frames) = run.choose((1000, 25), (COUNT, FRAMES));
    let mut boxes = ConvergingBoxes::new(count, 7);
    let mut methods = method::all();
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
        curves.push(Series::new(
            method.name,
            method.color,
            by_frame(times.0.iter().copied()),
        ));
    }
    // The slowest comes first in the table, the fastest in the legend.
    curves.reverse();
    let pairs = outcome.pairs.iter().map(|&pairs| pairs as f64 / 1e3);
    let panel = Panel::new("", Axis::linear("frame"), Axis::log("milliseconds"), curves).right(
        Axis::linear("thousands of pairs"),
        Series::new("pairs (right)", color::PALE, by_frame(pairs)),
    );
    let title = format!("{count} squares converge on the centre");
    Chart::new(title, [panel]).write_svg(&run.pictures.join("figure4.svg"))?;
    draw_frames(run, count, frames)
}

fn by_frame(values: impl Iterator<Item = f64>) -> impl Iterator<Item = (f64, f64)> {
    (1..).map(f64::from).zip(values)
}

/// Draws four frames at even intervals, as cubes on a plane coloured by how many others they overlap.
fn draw_frames(run: &Run, count: usize, frames: usize) -> Result<()> {
    let mut boxes = ConvergingBoxes::new(count, 7);
    let camera = Camera::orbit([0.0; 3], boxes.half_side() * 4.2)
        .turned(0.6)
        .raised(0.75);
    let interval = frames / (PICTURES + 1);
    for picture in 1..=PICTURES {
        (0..interval).for_each(|_| boxes.advance());
        let (mut squares, mut pairs) = (Vec::<Aabb<f32, 2>>::new(), Vec::new());
        unit_boxes(boxes.mins(), &mut squares);
        GridSweep::default().find_pairs(&squares, &mut pairs)?;
        let mut degrees = vec![0.0_f32; count];
        for index in pairs.iter().flatten() {
            degrees[*index as usize] += 1.0;
        }
        let mut drawing = Drawing::new();
        for (&[x, y], degree) in boxes.mins().iter().zip(degrees) {
            let color = palette::by_share(degree / CROWDED);
            drawing.cuboid(
                [x + 0.5, 0.5, y + 0.5],
                [0.5; 3],
                [0.0, 0.0, 0.0, 1.0],
                color,
            );
        }
        let title = format!("frame {}", picture * interval);
        let mut image = drawing.picture(&camera, PICTURE_SIZE)?;
        image.legend(&Legend::new(title).fact("pairs", thousands(pairs.len())));
        // Named by its place in the row, so that a quick run has the same names.
        image.write_png(&run.pictures.join(format!("figure4-{picture}.png")))?;
    }
    Ok(())
}
