//! What a finder keeps from one list may only make it faster on the next: boxes that drift, jump, change their sizes,
//! come and go.

use std::any::type_name;

use crate::numbers::Number;
use proptest::collection::vec;
use proptest::prelude::{ProptestConfig, Strategy, any, prop_assert, prop_oneof};
use proptest::sample::select;
use proptest::strategy::Just;
use proptest::test_runner::{TestCaseError, TestRunner};
use unisize::{Aabb, PairFinder};
use unisize_reference::CoherentSweepAndPrune;

use crate::check::{expected_pairs, find};
use crate::random::Random;
use crate::report;

/// How many boxes there are at most.
const MOST: usize = 150;

/// Where boxes begin, at most, on each axis. Half of all steps are whole, so boxes often touch.
const EXTENT: f64 = 12.0;

/// What happens to the boxes from one list to the next.
#[derive(Clone, Copy, Debug)]
enum Change {
    /// Nothing.
    Stay,
    /// Each moves on each axis by this much or less, either way.
    Drift(f64),
    /// Each moves by one in some direction, so that many endpoints become equal.
    Step,
    /// Some move anywhere, with this probability each.
    Jump(f64),
    /// They are mirrored: every order is reversed.
    Mirror,
    /// Their indices are shuffled.
    Shuffle,
    /// Some become larger or smaller, with this probability each.
    Resize(f64),
    /// There are more or fewer.
    Number(usize),
}

fn changes() -> impl Strategy<Value = Vec<(Change, u64)>> {
    let change = prop_oneof![
        1 => Just(Change::Stay),
        4 => select(vec![1e-6, 0.01, 0.1, 1.0]).prop_map(Change::Drift),
        3 => Just(Change::Step),
        3 => select(vec![0.02, 0.3, 1.0]).prop_map(Change::Jump),
        1 => Just(Change::Mirror),
        1 => Just(Change::Shuffle),
        2 => select(vec![0.02, 1.0]).prop_map(Change::Resize),
        2 => (0..=MOST).prop_map(Change::Number),
    ];
    vec((change, any::<u64>()), 1..12)
}

/// A box that begins anywhere, in half of all cases at whole numbers and with a whole size.
fn anywhere<R: Number, const D: usize>(random: &mut Random) -> Aabb<R, D> {
    let is_whole = random.chance(0.5);
    let mut number = |most: f64| {
        let x = random.between(0.0, most);
        R::from_f64(if is_whole { x.round() } else { x })
    };
    let mins = std::array::from_fn(|_| number(EXTENT));
    let size = number(2.0);
    Aabb::new(mins, mins.map(|x| x + size))
}

fn apply<R: Number, const D: usize>(
    change: Change,
    random: &mut Random,
    boxes: &mut Vec<Aabb<R, D>>,
) {
    let shifted = |aabb: &Aabb<R, D>, mut by: Box<dyn FnMut() -> f64 + '_>| {
        let by: [R; D] = std::array::from_fn(|_| R::from_f64(by()));
        Aabb::new(
            std::array::from_fn(|k| aabb.mins[k] + by[k]),
            std::array::from_fn(|k| aabb.maxs[k] + by[k]),
        )
    };
    match change {
        Change::Stay => {}
        Change::Drift(most) => {
            for aabb in boxes {
                *aabb = shifted(aabb, Box::new(|| random.between(-most, most)));
            }
        }
        Change::Step => {
            for aabb in boxes {
                *aabb = shifted(aabb, Box::new(|| random.whole(-1, 1)));
            }
        }
        Change::Jump(probability) => {
            for aabb in boxes {
                if random.chance(probability) {
                    *aabb = anywhere(random);
                }
            }
        }
        Change::Mirror => {
            for aabb in boxes {
                let mirrored = |corner: [R; D]| corner.map(|x| R::from_f64(0.0) - x);
                *aabb = Aabb::new(mirrored(aabb.maxs), mirrored(aabb.mins));
            }
        }
        Change::Shuffle => random.shuffle(boxes),
        Change::Resize(probability) => {
            for aabb in boxes {
                if random.chance(probability) {
                    let size = R::from_f64(random.pick(&[0.0, 0.5, 1.0, 2.0, 2.0 * EXTENT]));
                    aabb.maxs = aabb.mins.map(|x| x + size);
                }
            }
        }
        Change::Number(number) => {
            boxes.truncate(number);
            boxes.resize_with(number, || anywhere(random));
        }
    }
}

/// Checks a finder that is kept through 256 sequences of lists, or as many as `PROPTEST_CASES` says.
fn check<F, R, const D: usize>()
where
    F: PairFinder<R, D> + Default,
    R: Number,
{
    let config = ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let sequences = (0..=MOST, any::<u64>(), changes());
    let result = TestRunner::new(config).run(&sequences, |(number, seed, changes)| {
        let mut random = Random::new(seed);
        let mut boxes: Vec<Aabb<R, D>> = (0..number).map(|_| anywhere(&mut random)).collect();
        let mut finder = F::default();
        find(&mut finder, &boxes).map_err(TestCaseError::fail)?;
        for (change, seed) in changes {
            apply(change, &mut Random::new(seed), &mut boxes);
            let pairs = find(&mut finder, &boxes).map_err(TestCaseError::fail)?;
            report::compare(&boxes, &expected_pairs(&boxes), &pairs)
                .map_err(TestCaseError::fail)?;
            let fresh = find(&mut F::default(), &boxes).map_err(TestCaseError::fail)?;
            prop_assert!(pairs == fresh, "a new finder has another order: {boxes:?}");
        }
        Ok(())
    });
    if let Err(error) = result {
        panic!("{} is wrong: {error}", type_name::<F>());
    }
}

#[test]
fn coherent_sweep_and_prune_f32_2() {
    check::<CoherentSweepAndPrune<f32, 2>, f32, 2>();
}

#[test]
fn coherent_sweep_and_prune_f32_3() {
    check::<CoherentSweepAndPrune<f32, 3>, f32, 3>();
}

#[test]
fn coherent_sweep_and_prune_f64_2() {
    check::<CoherentSweepAndPrune<f64, 2>, f64, 2>();
}

#[test]
fn coherent_sweep_and_prune_f64_3() {
    check::<CoherentSweepAndPrune<f64, 3>, f64, 3>();
}
