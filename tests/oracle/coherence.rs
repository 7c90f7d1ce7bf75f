//! What a finder keeps from one list may only make it faster on the next: boxes that drift, jump, change their sizes, come and go.

use std::array::from_fn;

use unisize::{Aabb, PairFinder};

use crate::boxes::sized;
use crate::check::{compare, find};
use crate::numbers::Number;
use crate::random::Random;

/// Sequences of lists, unless `PROPTEST_CASES` says otherwise.
const SEQUENCES: u64 = 64;

/// How many boxes there are at most.
const MOST: usize = 150;

/// A box that begins anywhere, in half of all cases at whole numbers and with a whole size, so that boxes often touch.
fn anywhere<R: Number, const D: usize>(random: &mut Random) -> Aabb<R, D> {
    let is_whole = random.chance(0.5);
    let mut number = |most: f64| {
        let x = random.between(0.0, most);
        if is_whole { x.round() } else { x }
    };
    sized(from_fn(|_| number(12.0)), [number(2.0); D])
}

fn moved<R: Number, const D: usize>(aabb: &mut Aabb<R, D>, mut by: impl FnMut() -> f64) {
    for k in 0..D {
        let by = R::from_f64(by());
        (aabb.mins[k], aabb.maxs[k]) = (aabb.mins[k] + by, aabb.maxs[k] + by);
    }
}

/// Changes the boxes in one of eight ways.
fn change<R: Number, const D: usize>(random: &mut Random, boxes: &mut Vec<Aabb<R, D>>) {
    match random.below(8) {
        0 => {}
        1 => {
            let most = random.pick(&[1e-6, 0.01, 0.1, 1.0]);
            boxes
                .iter_mut()
                .for_each(|it| moved(it, || random.between(-most, most)));
        }
        // So that many endpoints become equal.
        2 => boxes
            .iter_mut()
            .for_each(|it| moved(it, || random.whole(-1, 1))),
        3 => {
            let share = random.pick(&[0.02, 0.3, 1.0]);
            for aabb in boxes {
                if random.chance(share) {
                    *aabb = anywhere(random);
                }
            }
        }
        // Mirrored: every order is reversed.
        4 => {
            for aabb in boxes {
                let mirrored = |corner: [R; D]| corner.map(|x| R::from_f64(0.0) - x);
                *aabb = Aabb::new(mirrored(aabb.maxs), mirrored(aabb.mins));
            }
        }
        5 => random.shuffle(boxes),
        6 => {
            let share = random.pick(&[0.02, 1.0]);
            for aabb in boxes {
                if random.chance(share) {
                    let size = R::from_f64(random.pick(&[0.0, 0.5, 1.0, 2.0, 24.0]));
                    aabb.maxs = aabb.mins.map(|x| x + size);
                }
            }
        }
        _ => {
            let number = random.below(MOST + 1);
            boxes.truncate(number);
            boxes.resize_with(number, || anywhere(random));
        }
    }
}

/// Checks a finder that is kept through sequences of lists.
pub(crate) fn check<F: PairFinder<R, D> + Default, R: Number, const D: usize>() {
    let sequences = std::env::var("PROPTEST_CASES").map(|cases| cases.parse());
    for seed in 0..sequences.map_or(SEQUENCES, |cases| cases.expect("a number")) {
        let mut random = Random::new(seed);
        let mut finder = F::default();
        let number = random.below(MOST + 1);
        let mut boxes: Vec<Aabb<R, D>> = (0..number).map(|_| anywhere(&mut random)).collect();
        for step in 0..12 {
            let pairs = find(&mut finder, &boxes).expect("all boxes are sound");
            if let Err(what) = compare(&boxes, &pairs) {
                panic!("seed {seed}, list {step}: {what}");
            }
            let fresh = find(&mut F::default(), &boxes).expect("all boxes are sound");
            assert!(
                pairs == fresh,
                "seed {seed}, list {step}: a new finder has another order"
            );
            change(&mut random, &mut boxes);
        }
    }
}
