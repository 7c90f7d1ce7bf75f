//! Random sequences, by proptest, which also shrinks those that fail. Each operation is made of bytes of its own, read as the fuzzer's
//! are, so that any can be left out, and fewer and smaller bytes make a simpler one.

use proptest::array::{uniform8, uniform32};
use proptest::collection::vec;
use proptest::prelude::{Strategy, any};

use crate::fuzzed::Bytes;
use crate::ops::{Op, Sequence};

/// How many a test plays, unless `PROPTEST_CASES` says otherwise.
pub(crate) const SEQUENCES: u32 = 64;

pub(crate) fn sequences() -> impl Strategy<Value = Sequence> {
    let settings = uniform8(any::<u8>());
    let ops = |most| vec(uniform32(any::<u8>()), 0..most);
    (settings, ops(20), vec(ops(7), 1..12)).prop_map(|(settings, opening, updates)| {
        let mut sequence = Bytes::new(&settings).sequence();
        let opening = opening.iter().map(|bytes| Bytes::new(bytes).insertion());
        sequence.updates = vec![opening.collect()];
        for ops in updates {
            let ops = ops.iter().map(|bytes| Bytes::new(bytes).op());
            sequence.updates.push(ops.collect::<Vec<Op>>());
        }
        sequence
    })
}
