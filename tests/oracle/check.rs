//! What must hold for every valid input.

use std::any::type_name;

use crate::numbers::Number;
use unisize::{Aabb, PairFinder};

use crate::guard::guarded;
use crate::inputs::Input;
use crate::placement;
use crate::random::Random;
use crate::report;

/// Every overlapping pair, in ascending order, by a definition of its own: boxes overlap unless, on some
/// axis, one ends before the other begins.
///
/// It shares no code with the library, so that `BruteForce` can be tested like every other kernel.
pub(crate) fn expected_pairs<R: Number, const D: usize>(boxes: &[Aabb<R, D>]) -> Vec<[u32; 2]> {
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

/// Checks every input, then fails with a report on those that went wrong.
pub(crate) fn every<F, R, const D: usize>(inputs: &[Input<R, D>])
where
    F: PairFinder<R, D> + Default,
    R: Number,
{
    let failed: Vec<_> = inputs
        .iter()
        .filter(|input| holds::<F, R, D>(&input.boxes).is_err())
        .collect();
    let reports: Vec<_> = failed
        .iter()
        .take(3)
        .map(|input| {
            let boxes = report::fewest(&input.boxes, |boxes| holds::<F, R, D>(boxes).is_err());
            report::on(&input.name, &input.boxes, &boxes, holds::<F, R, D>)
        })
        .collect();
    assert!(
        failed.is_empty(),
        "{} is wrong on {} of {} inputs\n\n{}\n\nall of them: {:#?}",
        type_name::<F>(),
        failed.len(),
        inputs.len(),
        reports.join("\n\n"),
        failed.iter().map(|input| &input.name).collect::<Vec<_>>(),
    );
}

/// Checks that a finder that has seen all earlier inputs answers each input as a new one does.
pub(crate) fn one_finder_serves<F, R, const D: usize>(inputs: &[Input<R, D>])
where
    F: PairFinder<R, D> + Default,
    R: Number,
{
    let mut veteran = F::default();
    for Input { name, boxes } in inputs {
        let fresh = find(&mut F::default(), boxes).expect(name);
        let pairs = find(&mut veteran, boxes).expect(name);
        assert!(
            pairs == fresh,
            "{}: after other inputs the answer is another on: {name}",
            type_name::<F>()
        );
    }
}

/// An error that says what does not hold for these boxes, if anything.
pub(crate) fn holds<F, R, const D: usize>(boxes: &[Aabb<R, D>]) -> Result<(), String>
where
    F: PairFinder<R, D> + Default,
    R: Number,
{
    let mut finder = F::default();
    let first = find(&mut finder, boxes)?;
    report::compare(boxes, &expected_pairs(boxes), &first)?;

    let same = |when: &str, pairs: Vec<[u32; 2]>| {
        if pairs == first {
            return Ok(());
        }
        let mut sorted = [pairs, first.clone()];
        sorted.iter_mut().for_each(|pairs| pairs.sort_unstable());
        let what = if sorted[0] == sorted[1] {
            "order"
        } else {
            "set"
        };
        Err(format!("{when}, the {what} of the pairs is another"))
    };
    same("called again", find(&mut finder, boxes)?)?;
    same("by a new finder", find(&mut F::default(), boxes)?)?;
    find(&mut finder, &placement::uniform(1, boxes.len() + 65, 0.8))?;
    same("after a larger input", find(&mut finder, boxes)?)?;
    find(&mut finder, &boxes[boxes.len() / 2..])?;
    same("after a smaller input", find(&mut finder, boxes)?)?;

    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    Random::new(2).shuffle(&mut order);
    let shuffled: Vec<_> = order.iter().map(|&i| boxes[i as usize]).collect();
    report::compare(
        &shuffled,
        &expected_pairs(&shuffled),
        &find(&mut finder, &shuffled)?,
    )
    .map_err(|what| format!("in another order of the boxes: {what}"))
}

/// The finder's answer, into a list that already holds something; or the error.
pub(crate) fn find<F, R, const D: usize>(
    finder: &mut F,
    boxes: &[Aabb<R, D>],
) -> Result<Vec<[u32; 2]>, String>
where
    F: PairFinder<R, D>,
    R: Number,
{
    let mut pairs = JUNK.to_vec();
    guarded(|| finder.find_pairs(boxes, &mut pairs))?.map_err(|e| format!("refused: {e}"))?;
    Ok(pairs)
}

/// What a list of pairs holds before a finder replaces it.
pub(crate) const JUNK: [[u32; 2]; 5] = [[7, 7], [u32::MAX, 0], [1, 0], [0, 1], [3, 5]];
