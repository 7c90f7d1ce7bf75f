//! Held pairs whose candidates are retired and whose boxes overlap, until the search has found them again.

use std::collections::HashSet;
use std::hash::{BuildHasherDefault, Hasher};

/// A set of [packed](crate::pair_tracker::changes::pack) pairs.
pub(super) type RetiredPairs = HashSet<u64, BuildHasherDefault<Fibonacci>>;

/// Fibonacci hashing (Knuth, The Art of Computer Programming, 6.4).
#[derive(Clone, Copy, Default)]
pub(super) struct Fibonacci(u64);

impl Hasher for Fibonacci {
    fn write(&mut self, _: &[u8]) {
        unreachable!("a packed pair is one number");
    }

    #[inline(always)]
    fn write_u64(&mut self, pair: u64) {
        // A table takes the lowest bits of a hash, and a product has its best ones at the top.
        self.0 = pair.wrapping_mul(0x9e37_79b9_7f4a_7c15).swap_bytes();
    }

    fn finish(&self) -> u64 {
        self.0
    }
}
