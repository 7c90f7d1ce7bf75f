//! The extension to three dimensions: how the extra interval test holds up as scenes get thicker and larger.

use crate::race::{self, drift, race, unit_boxes};
use crate::run::{Run, count};
use anyhow::Result;
use serde_json::Value;
use unisize::{GridSweep, PairFinder};
use unisize_scenes::DriftingBoxes;

const DENSITY: f64 = 0.2;
const FRAMES: usize = 5;

/// The heights of the layers, in cubes; a cube-shaped environment is added as the last.
const THICKNESSES: [f64; 7] = [1.0, 1.5, 2.0, 4.0, 8.0, 16.0, 32.0];

/// The number of cubes in a layer, and those in a fully three-dimensional scene.
const COUNT: usize = 1 << 16;
pub(crate) const COUNTS: [usize; 4] = [1 << 12, 1 << 14, 1 << 16, 1 << 18];

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    let n = run.choose(1 << 10, COUNT);
    let cube = (n as f64 / DENSITY).cbrt();
    for thickness in THICKNESSES.into_iter().filter(|&t| t < cube).chain([cube]) {
        let mut drifting = DriftingBoxes::<3>::in_layer(n, DENSITY, thickness, 7);
        let (pairs, mut columns) = measure_methods(run, &mut drifting)?;
        let flat = flat_pairs(&drifting)?;
        columns.push(("flat_pairs", flat.into()));
        columns.push(("percent", (100.0 * pairs as f64 / flat as f64).into()));
        run.row(
            "third-axis",
            &format!("{thickness:.1} cubes thick"),
            &columns,
        )?;
    }
    for &n in &COUNTS[..run.choose(2, COUNTS.len())] {
        let mut drifting = DriftingBoxes::<3>::new(n, DENSITY, 7);
        let (_, columns) = measure_methods(run, &mut drifting)?;
        run.row("third-axis-growth", &count(n), &columns)?;
    }
    Ok(())
}

/// The number of pairs in the last frame, and the columns of that and of the times of our methods.
fn measure_methods(
    run: &Run,
    drifting: &mut DriftingBoxes<3>,
) -> Result<(usize, Vec<(&'static str, Value)>)> {
    let mut methods = race::methods().split_off(1);
    let next = |boxes: &mut _| drift(drifting, boxes);
    let outcome = race(&mut methods, run.choose(2, FRAMES), next)?;
    let pairs = outcome.pairs.last().copied().unwrap_or_default();
    let mut columns = vec![("pairs", pairs.into())];
    columns.extend(outcome.medians(&methods));
    Ok((pairs, columns))
}

/// How many pairs overlap on the first two axes: those that need the extra interval test.
fn flat_pairs(drifting: &DriftingBoxes<3>) -> Result<usize> {
    let flat: Vec<_> = drifting.mins().iter().map(|&[x, y, _]| [x, y]).collect();
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    unit_boxes(&flat, &mut boxes);
    GridSweep::<f32, 2>::default().find_pairs(&boxes, &mut pairs)?;
    Ok(pairs.len())
}
