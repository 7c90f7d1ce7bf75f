//! Random inputs, from proptest, which also shrinks those that fail.

use proptest::array::uniform;
use proptest::collection::vec;
use proptest::prelude::{Just, ProptestConfig, Strategy, any, prop_oneof};
use proptest::sample::select;
use proptest::strategy::BoxedStrategy;
use proptest::test_runner::{TestCaseError, TestError, TestRunner};
use unisize::{Aabb, PairFinder};

use crate::boxes::between;
use crate::check::{fail, holds};
use crate::numbers::{Number, alphabet};

/// How many lists are tried, unless `PROPTEST_CASES` says otherwise.
const LISTS: u32 = 64;

/// Checks random lists of boxes.
pub(crate) fn check<F: PairFinder<R, D> + Default, R: Number, const D: usize>() {
    let mut config = ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = LISTS;
    }
    let result = TestRunner::new(config).run(&lists::<R, D>(), |boxes| {
        holds::<F, R, D>(&boxes).map_err(TestCaseError::fail)
    });
    match result {
        Ok(()) => {}
        Err(TestError::Fail(what, boxes)) => {
            fail::<F, R, D>(what.message(), &boxes, |few| holds::<F, R, D>(few).is_err())
        }
        Err(error) => panic!("{error}"),
    }
}

/// Lists of boxes: all from the alphabet, all from ordinary numbers, or of every kind.
fn lists<R: Number, const D: usize>() -> impl Strategy<Value = Vec<Aabb<R, D>>> {
    let of = |coordinate| vec(boxes(coordinate), 0..200);
    let alphabet = select(alphabet()).boxed();
    prop_oneof![of(alphabet), of(ordinary()), of(anything())]
}

/// Boxes with corners from `coordinate`: between any two, or with sides from 0 to 2.
fn boxes<R: Number, const D: usize>(
    coordinate: BoxedStrategy<R>,
) -> impl Strategy<Value = Aabb<R, D>> {
    let pair = (coordinate.clone(), coordinate.clone());
    let any_two = pair.prop_map(|(a, b)| if a <= b { (a, b) } else { (b, a) });
    let sides = prop_oneof![Just(0.0), Just(1.0), 0.0..2.0_f64];
    let sized = (coordinate, sides).prop_map(|(low, side)| (low, low + R::from_f64(side)));
    uniform(prop_oneof![1 => any_two, 4 => sized]).prop_map(between)
}

/// Numbers as in scenes: whole and not.
fn ordinary<R: Number>() -> BoxedStrategy<R> {
    let whole = (-8..8_i32).prop_map(f64::from);
    let numbers = prop_oneof![1 => whole, 3 => -8.0..8.0_f64];
    numbers.prop_map(R::from_f64).boxed()
}

/// Numbers of every magnitude, ordinary ones, and the alphabet.
fn anything<R: Number>() -> BoxedStrategy<R> {
    let decades = R::LARGEST.to_f64().log10();
    let wild = (any::<bool>(), -decades..decades).prop_map(|(negative, decade)| {
        let size = 10_f64.powf(decade);
        R::from_f64(if negative { -size } else { size })
    });
    prop_oneof![1 => select(alphabet()), 6 => ordinary(), 2 => wild].boxed()
}
