//! The checks of every valid input.

use std::any::type_name;

use crate::boxes::uniform;
use crate::inputs::Input;
use crate::numbers::Number;
use crate::random::Random;
use unisize::{Aabb, PairFinder};

/// Returns all overlapping pairs in ascending order: boxes overlap unless, on some axis, one ends before the other begins.
///
/// The oracle shares no code with the library, so it can test `BruteForce` like every other kernel.
fn expected_pairs<R: Number, const D: usize>(boxes: &[Aabb<R, D>]) -> Vec<[u32; 2]> {
    let apart = |a: &Aabb<R, D>, b: &Aabb<R, D>| {
        (0..D).any(|k| a.maxs[k] < b.mins[k] || b.maxs[k] < a.mins[k])
    };
    let mut pairs = Vec::new();
    for (i, a) in boxes.iter().enumerate() {
        for (j, b) in boxes[..i].iter().enumerate() {
            if !apart(a, b) {
                pairs.push([j as u32, i as u32]);
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

/// Checks every input, and that a finder used for all earlier inputs returns the same as a new one.
pub(crate) fn every<F: PairFinder<R, D> + Default, R: Number, const D: usize>(
    inputs: &[Input<R, D>],
) {
    let mut used = F::default();
    for Input { name, boxes } in inputs {
        let outcome =
            holds::<F, R, D>(boxes).and_then(|first| match find(&mut used, boxes)? == first {
                true => Ok(()),
                false => Err("after other inputs, the pairs or their order differ".to_owned()),
            });
        if let Err(what) = outcome {
            let kernel = type_name::<F>();
            panic!("{kernel} is wrong on {} boxes, {name}: {what}", boxes.len());
        }
    }
}

/// Returns the pairs of these boxes, or an error with the first check that fails.
fn holds<F: PairFinder<R, D> + Default, R: Number, const D: usize>(
    boxes: &[Aabb<R, D>],
) -> Result<Vec<[u32; 2]>, String> {
    let mut finder = F::default();
    let first = find(&mut finder, boxes)?;
    compare(boxes, &first)?;

    let same = |when: &str, pairs: Vec<[u32; 2]>| match pairs == first {
        true => Ok(()),
        false => Err(format!("{when}, the pairs or their order differ")),
    };
    same("called again", find(&mut finder, boxes)?)?;
    same("with a new finder", find(&mut F::default(), boxes)?)?;
    find(&mut finder, &uniform(1, boxes.len() + 65, 0.8))?;
    same("after a larger input", find(&mut finder, boxes)?)?;
    find(&mut finder, &boxes[boxes.len() / 2..])?;
    same("after a smaller input", find(&mut finder, boxes)?)?;

    let mut shuffled = boxes.to_vec();
    Random::new(2).shuffle(&mut shuffled);
    let found = find(&mut finder, &shuffled)?;
    compare(&shuffled, &found).map_err(|what| format!("in another order of the boxes: {what}"))?;
    Ok(first)
}

/// Returns an error if the pairs are not those of the oracle, each once, with the smaller index first.
fn compare<R: Number, const D: usize>(
    boxes: &[Aabb<R, D>],
    pairs: &[[u32; 2]],
) -> Result<(), String> {
    let expected = expected_pairs(boxes);
    let mut sorted = pairs.to_vec();
    sorted.sort_unstable();
    if sorted == expected {
        return Ok(());
    }
    let first_lacking = |from: &[[u32; 2]], list: &[[u32; 2]]| {
        let mut lacking = list.iter().filter(|pair| !from.contains(pair));
        let pair = lacking.next()?;
        Some((*pair, pair.map(|i| boxes.get(i as usize))))
    };
    let missing = first_lacking(&sorted, &expected);
    let wrong = first_lacking(&expected, &sorted);
    let counts = format!("{} pairs expected, {} found", expected.len(), pairs.len());
    Err(format!(
        "{counts}; missing {missing:?}, wrong {wrong:?}, or found twice"
    ))
}

/// Returns the pairs or the error of the finder. The list that it fills is not empty before.
pub(crate) fn find<F: PairFinder<R, D>, R: Number, const D: usize>(
    finder: &mut F,
    boxes: &[Aabb<R, D>],
) -> Result<Vec<[u32; 2]>, String> {
    let mut pairs = JUNK.to_vec();
    let outcome = finder.find_pairs(boxes, &mut pairs);
    outcome.map_err(|error| format!("refused: {error}"))?;
    Ok(pairs)
}

/// The contents of a list before a finder replaces them.
pub(crate) const JUNK: [[u32; 2]; 5] = [[7, 7], [u32::MAX, 0], [1, 0], [0, 1], [3, 5]];
