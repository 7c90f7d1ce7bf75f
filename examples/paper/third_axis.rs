//! The extension to three dimensions: how the extra interval test holds up as scenes get thicker and larger.

use crate::race::{race, unit_boxes};
use crate::table::{count, digits};
use crate::{Run, method};
use anyhow::Result;
use unisize::{Aabb, GridSweep, PairFinder};
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
        run.table
            .add("third-axis", &row, "pairs of the first two axes", flat);
        let share = 100.0 * pairs as f64 / flat as f64;
        run.table.add("third-axis", &row, "of them pairs, %", share);
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
    let mut methods = method::all().split_off(1);
    let next = |boxes: &mut Vec<_>| {
        drifting.advance();
        unit_boxes(drifting.mins(), boxes);
    };
    let outcome = race(&mut methods, run.choose(2, FRAMES), next)?;
    let pairs = outcome.pairs.last().copied().unwrap_or_default();
    run.table.add(part, row, "pairs", pairs);
    for (method, times) in methods.iter().zip(&outcome.times) {
        run.table
            .add(part, row, format!("{}, ms", method.name), times.median());
    }
    Ok(pairs)
}

/// How many pairs overlap on the first two axes: those that need the extra interval test.
fn flat_pairs(drifting: &DriftingBoxes<3>) -> Result<usize> {
    let flat: Vec<_> = drifting.mins().iter().map(|&[x, y, _]| [x, y]).collect();
    let (mut boxes, mut pairs) = (Vec::<Aabb<f32, 2>>::new(), Vec::new());
    unit_boxes(&flat, &mut boxes);
    GridSweep::default().find_pairs(&boxes, &mut pairs)?;
    Ok(pairs.len())
}
