//! A search for boxes on which `GridSweep` does much for what it finds: what is told is counted, and no clock decides.
//!
//! It climbs from random mixtures, changing a number or two at a time, to those on which a box is compared with most others, and most tubes
//! are visited, for each box and pair. Where nothing is found that is better, it begins again elsewhere.

use crate::Options;
use std::time::{Duration, Instant};
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_report::Report;
use unisize_scenes::Mixture;

/// How many boxes a mixture has, and how many the worst one has besides, to see how the work grows.
const COUNT: usize = 1 << 14;
const LARGE: usize = 1 << 17;

/// Mixtures with more pairs than this for each box are hard for any method, and take long.
const MOST_PAIRS: usize = 64;

/// After so many changes in vain, the search begins elsewhere.
const PATIENCE: u64 = 60;

/// The most comparisons and visits for each box and pair, for both numbers of boxes.
const BOUND: f64 = 1500.0;

/// Searches in one dimension, for so long.
///
/// # Errors
/// If it finds a mixture above the bound.
pub(crate) fn search<const D: usize>(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    let begin = Instant::now();
    let enough = match options.quick {
        true => Duration::ZERO,
        false => Duration::from_secs(60 * u64::from(options.minutes)),
    };
    let mut worst = (0.0, Mixture::random(0));
    let (mut seed, mut tried) = (u64::from(options.seed), 0);
    while tried == 0 || begin.elapsed() < enough {
        let mut best = (0.0, Mixture::random(seed));
        let mut vain = 0;
        while vain < PATIENCE && (tried == 0 || begin.elapsed() < enough) {
            let mixture = best.1.varied(seed);
            let effort = effort::<D>(&mixture, COUNT).unwrap_or_default();
            (seed, tried, vain) = (seed + 1, tried + 1, vain + 1);
            if effort > best.0 {
                (best, vain) = ((effort, mixture), 0);
            }
        }
        if best.0 > worst.0 {
            worst = best;
        }
        seed += 1;
    }
    let (effort_of_few, mixture) = worst;
    let effort_of_many = effort::<D>(&mixture, LARGE);
    report.row(&[
        ("dim", D.into()),
        ("tried", tried.into()),
        ("boxes", COUNT.into()),
        ("compared_a_box_and_pair", effort_of_few.into()),
        ("more_boxes", LARGE.into()),
        ("compared_a_box_and_pair_then", effort_of_many.into()),
        ("mixture", format!("{mixture:?}").into()),
    ])?;
    let most = effort_of_few.max(effort_of_many.unwrap_or_default());
    anyhow::ensure!(most <= BOUND, "{most} is more than {BOUND}: {mixture:?}");
    Ok(())
}

/// How many boxes are compared with another, and tubes visited, for each box and pair; `None` if there are too many pairs.
fn effort<const D: usize>(mixture: &Mixture, count: usize) -> Option<f64> {
    let boxes = mixture.boxes(count, 7);
    let boxes: Vec<Aabb<f32, D>> = boxes.iter().map(|&[a, b]| Aabb::new(a, b)).collect();
    let (mut kernel, mut pairs) = (GridSweep::default(), Vec::new());
    let found = kernel.find_pairs(&boxes, &mut pairs);
    assert_eq!(found, Ok(()));
    (pairs.len() <= MOST_PAIRS * count)
        .then(|| kernel.compared() as f64 / (count + pairs.len()) as f64)
}
