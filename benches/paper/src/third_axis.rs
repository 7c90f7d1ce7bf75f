//! The extension to three dimensions: how the extra interval test holds up as scenes get thicker and larger.

use crate::Run;
use crate::race::{self, drift, race, unit_boxes};
use crate::table::{count, digits};
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
        let row = format!("{} cubes thick", digits(thickness));
        let pairs = measure_methods(run, "third-axis", &row, &mut drifting)?;
        let flat = flat_pairs(&drifting)?;
        let share = 100.0 * pairs as f64 / flat as f64;
        let mut add = |column, value| run.table.add("third-axis", &row, column, value);
        add("pairs of the first two axes", Value::from(flat));
        add("of them pairs, %", share.into());
    }
    for &n in &COUNTS[..run.choose(2, COUNTS.len())] {
        let mut drifting = DriftingBoxes::<3>::new(n, DENSITY, 7);
        measure_methods(run, "third-axis-growth", &count(n), &mut drifting)?;
    }
    Ok(())
}

/// Adds the times of all methods, and returns the number of pairs in the last frame.
fn measure_methods(
    run: &mut Run,
    part: &'static str,
    row: &str,
    drifting: &mut DriftingBoxes<3>,
) -> Result<usize> {
    let mut methods = race::methods().split_off(1);
    let next = |boxes: &mut _| drift(drifting, boxes);
    let outcome = race(&mut methods, run.choose(2, FRAMES), next)?;
    let pairs = outcome.pairs.last().copied().unwrap_or_default();
    run.table.add(part, row, "pairs", pairs);
    for (method, times) in methods.iter().zip(&outcome.times) {
        let column = format!("{}, ms", method.name);
        run.table.add(part, row, column, times.median());
    }
    Ok(pairs)
}

/// How many pairs overlap on the first two axes: those that need the extra interval test.
fn flat_pairs(drifting: &DriftingBoxes<3>) -> Result<usize> {
    let flat: Vec<_> = drifting.mins().iter().map(|&[x, y, _]| [x, y]).collect();
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    unit_boxes(&flat, &mut boxes);
    GridSweep::<f32, 2>::default().find_pairs(&boxes, &mut pairs)?;
    Ok(pairs.len())
}
