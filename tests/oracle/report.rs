//! Failures in few words: how many pairs are wrong, and the fewest boxes that show it.

use core::fmt::Write;
use std::time::{Duration, Instant};

use crate::numbers::Number;
use unisize::Aabb;

/// How many wrong pairs of each kind a report shows.
const PAIRS_SHOWN: usize = 6;
/// How many boxes a report shows.
const BOXES_SHOWN: usize = 32;

/// An error that says how `pairs` differ from the `expected` ones, which ascend, if they do.
pub(crate) fn compare<R: Number, const D: usize>(
    boxes: &[Aabb<R, D>],
    expected: &[[u32; 2]],
    pairs: &[[u32; 2]],
) -> Result<(), String> {
    let mut sorted = pairs.to_vec();
    sorted.sort_unstable();
    if sorted == expected {
        return Ok(());
    }
    let lacks = |list: &[[u32; 2]], pair: &[u32; 2]| list.binary_search(pair).is_err();
    let unordered: Vec<_> = pairs.iter().filter(|[a, b]| a >= b).collect();
    let repeated: Vec<_> = sorted
        .windows(2)
        .filter(|w| w[0] == w[1])
        .map(|w| &w[0])
        .collect();
    let missing: Vec<_> = expected.iter().filter(|p| lacks(&sorted, p)).collect();
    let spurious: Vec<_> = sorted.iter().filter(|p| lacks(expected, p)).collect();
    let mut text = format!("{} pairs expected, {} found", expected.len(), pairs.len());
    for (what, wrong) in [
        ("missing", missing),
        ("spurious", spurious),
        ("repeated", repeated),
        ("not smaller index first", unordered),
    ] {
        if !wrong.is_empty() {
            write!(text, "; {} {what}:", wrong.len()).expect("a string takes text");
        }
        for &&[a, b] in wrong.iter().take(PAIRS_SHOWN) {
            let shown = |i: u32| boxes.get(i as usize).map_or("no such box".into(), show);
            write!(text, "\n  [{a}, {b}]: {} and {}", shown(a), shown(b))
                .expect("a string takes text");
        }
    }
    Err(text)
}

/// A few of the boxes for which `fails` still is true: as few as leaving out finds in some seconds.
pub(crate) fn fewest<R: Number, const D: usize>(
    boxes: &[Aabb<R, D>],
    fails: impl Fn(&[Aabb<R, D>]) -> bool,
) -> Vec<Aabb<R, D>> {
    let end = Instant::now() + Duration::from_secs(5);
    let mut kept = boxes.to_vec();
    let mut chunk = kept.len();
    while chunk > 0 {
        let mut start = 0;
        while start < kept.len() && Instant::now() < end {
            let mut fewer = kept.clone();
            fewer.drain(start..kept.len().min(start + chunk));
            if fails(&fewer) {
                kept = fewer;
            } else {
                start += chunk;
            }
        }
        chunk /= 2;
    }
    kept
}

/// What went wrong with the input called `name`, and with the `few` of its boxes that still show it.
pub(crate) fn on<R: Number, const D: usize>(
    name: &str,
    all: &[Aabb<R, D>],
    few: &[Aabb<R, D>],
    holds: impl Fn(&[Aabb<R, D>]) -> Result<(), String>,
) -> String {
    let what = |boxes| {
        holds(boxes)
            .err()
            .unwrap_or("not wrong when tried again".into())
    };
    let mut text = format!("{name} ({} boxes): {}", all.len(), what(all));
    if few.len() < all.len() {
        write!(text, "\nwith {} of them: {}", few.len(), what(few)).expect("a string takes text");
    }
    for (i, b) in few.iter().enumerate().take(BOXES_SHOWN) {
        write!(text, "\n  {i}: {}", show(b)).expect("a string takes text");
    }
    text
}

/// The box as the call that makes it.
fn show<R: Number, const D: usize>(b: &Aabb<R, D>) -> String {
    format!("Aabb::new({:?}, {:?})", b.mins, b.maxs)
}
