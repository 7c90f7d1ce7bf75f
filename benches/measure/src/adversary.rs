//! A search for boxes on which `GridSweep` does much work for few pairs. It counts the work, without a clock.
//!
//! It begins with a random arrangement: a mixture, blocks of needles, or boxes in an order that aims at the kernel's samples. By changing a
//! number or two at a time, it climbs to one with the most comparisons of boxes and visits of tubes for each box and pair. If no change
//! makes it worse, it begins again with another one.

use crate::Options;
use std::time::{Duration, Instant};
use unisize::{Aabb, GridSweep, PairFinder, Real};
use unisize_report::Report;
use unisize_scenes::{Aimed, Mixture, Needles};

/// The number of boxes of an arrangement, and the larger number of the worst one, which shows how the work grows.
const COUNT: usize = 1 << 14;
const LARGE: usize = 1 << 17;

/// Arrangements with more pairs than this for each box are hard for any method, and take long.
const MOST_PAIRS: usize = 64;

/// After this many changes in vain, the search begins with another arrangement.
const PATIENCE: u64 = 60;

/// The bound of comparisons and visits for each box and pair, for both numbers of boxes.
const BOUND: f64 = 1200.0;

/// Boxes that the search varies.
#[derive(Clone, Copy, Debug)]
enum Arrangement {
    Mixture(Mixture),
    Needles(Needles),
    Aimed(Aimed),
}

impl Arrangement {
    /// Of each kind by turns.
    fn random(seed: u64) -> Self {
        match seed % 3 {
            0 => Self::Mixture(Mixture::random(seed)),
            1 => Self::Needles(Needles::random(seed)),
            _ => Self::Aimed(Aimed::random(seed)),
        }
    }

    fn varied(self, seed: u64) -> Self {
        match self {
            Self::Mixture(mixture) => Self::Mixture(mixture.varied(seed)),
            Self::Needles(needles) => Self::Needles(needles.varied(seed)),
            Self::Aimed(aimed) => Self::Aimed(aimed.varied(seed)),
        }
    }

    fn boxes<R: Real, const D: usize>(&self, count: usize) -> Vec<Aabb<R, D>> {
        let boxes = match self {
            Self::Mixture(mixture) => mixture.boxes(count, 7),
            Self::Needles(needles) => needles.boxes(count, 7),
            Self::Aimed(aimed) => {
                let is_double = R::from_f64(1e300).to_f64().is_finite();
                return converted(&aimed.boxes(count, if is_double { 1e300 } else { 1e30 }));
            }
        };
        converted(&boxes)
    }
}

fn converted<T: Copy + Into<f64>, R: Real, const D: usize>(
    boxes: &[[[T; D]; 2]],
) -> Vec<Aabb<R, D>> {
    let corner = |corner: [T; D]| corner.map(|x| R::from_f64(x.into()));
    let boxes = boxes.iter();
    boxes
        .map(|&[a, b]| Aabb::new(corner(a), corner(b)))
        .collect()
}

/// Searches with one scalar in one dimension, for the minutes of the options.
///
/// # Errors
/// If it finds an arrangement above the bound.
pub(crate) fn search<R: Real, const D: usize>(
    options: &Options,
    report: &mut Report,
) -> anyhow::Result<()> {
    let begin = Instant::now();
    let enough = match options.quick {
        true => Duration::ZERO,
        false => Duration::from_secs(60 * u64::from(options.minutes)),
    };
    let mut worst = (0.0, Arrangement::random(0));
    let (mut seed, mut tried) = (1, 0);
    for climb in 0.. {
        if tried > 0 && begin.elapsed() >= enough {
            break;
        }
        let mut best = (0.0, Arrangement::random(3 * seed + climb % 3));
        let mut vain = 0;
        while vain < PATIENCE && (tried == 0 || begin.elapsed() < enough) {
            let arrangement = best.1.varied(seed);
            let effort = effort::<R, D>(&arrangement, COUNT).unwrap_or_default();
            (seed, tried, vain) = (seed + 1, tried + 1, vain + 1);
            if effort > best.0 {
                (best, vain) = ((effort, arrangement), 0);
            }
        }
        if best.0 > worst.0 {
            worst = best;
        }
        seed += 1;
    }
    let (effort_of_few, arrangement) = worst;
    let effort_of_many = effort::<R, D>(&arrangement, LARGE);
    report.row(&[
        ("dim", D.into()),
        ("scalar", std::any::type_name::<R>().into()),
        ("tried", tried.into()),
        ("boxes", COUNT.into()),
        ("compared_a_box_and_pair", effort_of_few.into()),
        ("more_boxes", LARGE.into()),
        ("compared_a_box_and_pair_then", effort_of_many.into()),
        ("arrangement", format!("{arrangement:?}").into()),
    ])?;
    let most = effort_of_few.max(effort_of_many.unwrap_or_default());
    anyhow::ensure!(
        most <= BOUND,
        "{most} is more than {BOUND}: {arrangement:?}"
    );
    Ok(())
}

/// The number of comparisons of boxes and of visited tubes for each box and pair; `None` if there are too many pairs.
fn effort<R: Real, const D: usize>(arrangement: &Arrangement, count: usize) -> Option<f64> {
    let boxes = arrangement.boxes::<R, D>(count);
    let (mut kernel, mut pairs) = (GridSweep::default(), Vec::new());
    let found = kernel.find_pairs(&boxes, &mut pairs);
    assert_eq!(found, Ok(()));
    (pairs.len() <= MOST_PAIRS * count)
        .then(|| kernel.compared() as f64 / (count + pairs.len()) as f64)
}
