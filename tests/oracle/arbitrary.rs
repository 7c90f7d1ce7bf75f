//! Random inputs, from proptest, which also shrinks those that fail.

use core::ops::Range;
use std::any::type_name;

use crate::numbers::Number;
use proptest::array::uniform;
use proptest::collection::vec;
use proptest::prelude::{Just, ProptestConfig, Strategy, any, prop_oneof};
use proptest::sample::select;
use proptest::strategy::BoxedStrategy;
use proptest::test_runner::{TestCaseError, TestError, TestRunner};
use unisize::{Aabb, PairFinder};

use crate::check::holds;
use crate::numbers::alphabet;
use crate::report;

/// How many boxes a list has.
const LENGTHS: Range<usize> = 0..200;

/// Checks 64 lists of boxes, or as many as `PROPTEST_CASES` says.
pub(crate) fn check<F, R, const D: usize>()
where
    F: PairFinder<R, D> + Default,
    R: Number,
{
    let mut config = ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = 64;
    }
    let result = TestRunner::new(config).run(&lists::<R, D>(), |boxes| {
        holds::<F, R, D>(&boxes).map_err(TestCaseError::fail)
    });
    match result {
        Ok(()) => {}
        Err(TestError::Fail(_, boxes)) => {
            let few = report::fewest(&boxes, |boxes| holds::<F, R, D>(boxes).is_err());
            let report = report::on("arbitrary boxes", &boxes, &few, holds::<F, R, D>);
            panic!("{} is wrong\n\n{report}", type_name::<F>());
        }
        Err(error) => panic!("{error}"),
    }
}

/// Lists of boxes: all from the alphabet, all from ordinary numbers, or of every kind.
fn lists<R: Number, const D: usize>() -> BoxedStrategy<Vec<Aabb<R, D>>> {
    prop_oneof![
        vec(boxes(select(alphabet()).boxed()), LENGTHS),
        vec(boxes(ordinary()), LENGTHS),
        vec(boxes(anything()), LENGTHS),
    ]
    .boxed()
}

/// Boxes with corners from `coordinate`: between any two, or with sides from 0 to 2.
fn boxes<R: Number, const D: usize>(
    coordinate: BoxedStrategy<R>,
) -> impl Strategy<Value = Aabb<R, D>> {
    let between = (coordinate.clone(), coordinate.clone())
        .prop_map(|(a, b)| if a <= b { (a, b) } else { (b, a) });
    let sides = prop_oneof![Just(0.0), Just(1.0), 0.0..2.0_f64];
    let sized = (coordinate, sides).prop_map(|(low, side)| (low, low + R::from_f64(side)));
    uniform(prop_oneof![1 => between, 4 => sized])
        .prop_map(|ends: [(R, R); D]| Aabb::new(ends.map(|e| e.0), ends.map(|e| e.1)))
}

/// Numbers as in scenes: whole and not.
fn ordinary<R: Number>() -> BoxedStrategy<R> {
    let whole = (-8..8_i32).prop_map(|x| R::from_f64(f64::from(x)));
    let real = (-8.0..8.0_f64).prop_map(R::from_f64);
    prop_oneof![1 => whole, 3 => real].boxed()
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
