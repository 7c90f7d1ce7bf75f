//! The extension to three dimensions: how the extra interval test holds up as scenes get thicker.

use crate::method::{self, Method};
use crate::page::Page;
use crate::progress::progress_bar;
use crate::race::{race, unit_boxes};
use crate::table::{Table, count, digits};
use anyhow::Result;
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_charts::{Axis, Chart, Panel, Series};
use unisize_scenes::DriftingBoxes;

const DENSITY: f64 = 0.2;
const FRAMES: usize = 5;

/// The heights of the layers, in cubes; a cube-shaped environment is added as the last.
const THICKNESSES: [f64; 7] = [1.0, 1.5, 2.0, 4.0, 8.0, 16.0, 32.0];

/// The number of cubes in a layer, and those in a fully three-dimensional scene.
const COUNT: usize = 1 << 16;
const COUNTS: [usize; 4] = [1 << 12, 1 << 14, 1 << 16, 1 << 18];

const QUICK_COUNT: usize = 1 << 10;

pub(crate) fn run(page: &Page, quick: bool) -> Result<()> {
    let (n, counts, frames) = if quick {
        (QUICK_COUNT, &COUNTS[..1], 2)
    } else {
        (COUNT, &COUNTS[..], FRAMES)
    };
    let cube = (n as f64 / DENSITY).cbrt();
    let mut thicknesses: Vec<_> = THICKNESSES.into_iter().filter(|&t| t < cube).collect();
    thicknesses.push(cube);
    let bar = progress_bar(((thicknesses.len() + counts.len()) * (frames + 1)) as u64);

    bar.set_message("layers");
    let mut layers = Lines::new();
    let mut table = Table::new(
        [
            "thickness, cubes",
            "pairs",
            "pairs of the first two axes",
            "of them pairs",
        ]
        .map(str::to_owned)
        .into_iter()
        .chain(layers.names.iter().map(|name| format!("{name}, ms"))),
    );
    for thickness in thicknesses {
        let mut drifting = DriftingBoxes::<3>::in_layer(n, DENSITY, thickness, 7);
        let (means, pairs) = layers.measure(thickness, &mut drifting, frames, || bar.inc(1))?;
        let flat = flat_pairs(&drifting)?;
        let mut row = vec![
            digits(thickness),
            pairs.to_string(),
            flat.to_string(),
            format!("{:.0} %", pairs as f64 / flat as f64 * 100.0),
        ];
        row.extend(means.into_iter().map(digits));
        table.push(row);
    }
    page.put("third-axis", &table)?;

    bar.set_message("cubes");
    let mut cubes = Lines::new();
    let mut table = Table::new(
        ["n", "pairs"]
            .map(str::to_owned)
            .into_iter()
            .chain(cubes.names.iter().map(|name| format!("{name}, ms (slope)"))),
    );
    let mut last: Option<(usize, Vec<f64>)> = None;
    for &n in counts {
        let mut drifting = DriftingBoxes::<3>::new(n, DENSITY, 7);
        let (means, pairs) = cubes.measure(n as f64, &mut drifting, frames, || bar.inc(1))?;
        let mut row = vec![count(n), pairs.to_string()];
        row.extend(means.iter().enumerate().map(|(i, &ms)| match &last {
            Some((before, times)) => {
                let slope = (ms / times[i]).ln() / (n as f64 / *before as f64).ln();
                format!("{} ({slope:.2})", digits(ms))
            }
            None => digits(ms),
        }));
        table.push(row);
        last = Some((n, means));
    }
    bar.finish_and_clear();
    page.put("third-axis-growth", &table)?;

    let time = || Axis::log("nanoseconds per cube and pair");
    let thickness = Axis::log("thickness of the layer, in cubes");
    let layered = format!("Layers of {} cubes", count(n));
    let panels = [
        Panel::new(layered, thickness, time(), layers.lines()),
        Panel::new("As high as wide", Axis::log("n"), time(), cubes.lines()),
    ];
    let title = "Cubes in three dimensions, a fifth of the volume";
    Chart::new(title, panels).write_svg(&page.picture("third-axis.svg"))
}

/// The methods that are compared.
fn methods() -> Vec<Box<dyn Method<3>>> {
    vec![
        method::streamed_segment_tree(),
        method::dual_axis_sweep(),
        method::rank_sweep(),
        method::grid_sweep(),
    ]
}

/// The lines of one panel.
struct Lines {
    names: Vec<&'static str>,
    points: Vec<Vec<(f64, f64)>>,
}

impl Lines {
    fn new() -> Self {
        let names: Vec<_> = methods().iter().map(|method| method.name()).collect();
        Self {
            points: vec![Vec::new(); names.len()],
            names,
        }
    }

    /// The milliseconds of each method, and the number of pairs in the last frame.
    fn measure(
        &mut self,
        x: f64,
        drifting: &mut DriftingBoxes<3>,
        frames: usize,
        on_frame: impl Fn(),
    ) -> Result<(Vec<f64>, usize)> {
        let next = |boxes: &mut Vec<_>| {
            drifting.advance();
            unit_boxes(drifting.mins(), boxes);
        };
        let outcome = race(&mut methods(), frames, next, |_| on_frame())?;
        let pairs = outcome.pairs.last().copied().unwrap_or_default();
        let work = (drifting.mins().len() + pairs) as f64;
        let means: Vec<_> = outcome.times.iter().map(|times| times.median()).collect();
        for (points, ms) in self.points.iter_mut().zip(&means) {
            points.push((x, ms * 1e6 / work));
        }
        Ok((means, pairs))
    }

    fn lines(self) -> impl Iterator<Item = Series> {
        let lines = methods().into_iter().zip(self.points).rev();
        lines.map(|(method, points)| Series::new(method.name(), method.color(), points))
    }
}

/// How many pairs overlap on the first two axes: those that need the extra interval test.
fn flat_pairs(drifting: &DriftingBoxes<3>) -> Result<usize> {
    let flat: Vec<_> = drifting.mins().iter().map(|&[x, y, _]| [x, y]).collect();
    let mut boxes: Vec<Aabb<f32, 2>> = Vec::new();
    unit_boxes(&flat, &mut boxes);
    let mut pairs = Vec::new();
    GridSweep::default().find_pairs(&boxes, &mut pairs)?;
    Ok(pairs.len())
}
