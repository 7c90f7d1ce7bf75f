//! What must hold for every valid input.

use std::any::type_name;

use crate::boxes::uniform;
use crate::inputs::Input;
use crate::numbers::Number;
use crate::random::Random;
use unisize::{Aabb, PairFinder};

/// Every overlapping pair, in ascending order, by a definition of its own: boxes overlap unless, on some
/// axis, one ends before the other begins.
///
/// It shares no code with the library, so that `BruteForce` can be tested like every other kernel.
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

/// Checks every input, and that a finder that has seen all earlier ones answers as a new one does.
pub(crate) fn every<F: PairFinder<R, D> + Default, R: Number, const D: usize>(
    inputs: &[Input<R, D>],
) {
    let mut veteran = F::default();
    for Input { name, boxes } in inputs {
        let outcome =
            holds::<F, R, D>(boxes).and_then(|first| match find(&mut veteran, boxes)? == first {
                true => Ok(()),
                false => Err("after other inputs it answers otherwise".to_owned()),
            });
        if let Err(what) = outcome {
            let kernel = type_name::<F>();
            panic!("{kernel} is wrong on {} boxes, {name}: {what}", boxes.len());
        }
    }
}

/// The pairs of these boxes, or an error that says what does not hold.
fn holds<F: PairFinder<R, D> + Default, R: Number, const D: usize>(
    boxes: &[Aabb<R, D>],
) -> Result<Vec<[u32; 2]>, String> {
    let mut finder = F::default();
    let first = find(&mut finder, boxes)?;
    compare(boxes, &first)?;

    let same = |when: &str, pairs: Vec<[u32; 2]>| match pairs == first {
        true => Ok(()),
        false => Err(format!("{when}, the pairs or their order are others")),
    };
    same("called again", find(&mut finder, boxes)?)?;
    same("by a new finder", find(&mut F::default(), boxes)?)?;
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

/// An error that says how pairs differ from those of the oracle, if they do: each once, the smaller index first.
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
        "{counts}; missing {missing:?}, wrong {wrong:?}, or some are found twice"
    ))
}

/// The finder's answer, into a list that already holds something; or the error.
pub(crate) fn find<F: PairFinder<R, D>, R: Number, const D: usize>(
    finder: &mut F,
    boxes: &[Aabb<R, D>],
) -> Result<Vec<[u32; 2]>, String> {
    let mut pairs = JUNK.to_vec();
    let outcome = finder.find_pairs(boxes, &mut pairs);
    outcome.map_err(|error| format!("refused: {error}"))?;
    Ok(pairs)
}

/// What a list of pairs holds before a finder replaces it.
pub(crate) const JUNK: [[u32; 2]; 5] = [[7, 7], [u32::MAX, 0], [1, 0], [0, 1], [3, 5]];
