//! The ranks of the endpoints on the first axis, such that no interval includes another.
//!
//! The sweep relies on Claim 1 of the paper: in the order of the endpoints, no interval includes another. In other words, the high
//! endpoints are in the order of their objects' low endpoints. Counting achieves that: *the k-th high endpoint belongs to the object of
//! the k-th low endpoint.*
//!
//! - Boxes of one size have their high endpoints in that order anyway, except for equal ones. Where coordinates are large, `x + size`
//!   rounds different `x` to one number, and a stable sort puts equal endpoints in the order of their objects, which may be wrong. Then
//!   it is enough to reassign the equal endpoints.
//! - Boxes of different sizes are widened: an interval ends no earlier than any that begins before it. No smaller widening suffices. It
//!   never exceeds widening to a common length `s`, since no interval that begins at or before `x` ends beyond `x + s`. It takes no
//!   arithmetic, so it cannot round, overflow or meet `∞ - ∞`.

/// Sets `ranks[i]` to the ranks of the low and the high endpoint of object `i`. Returns whether no interval had to be widened.
///
/// `keys` are the endpoints, with lows at `i` and highs at `i + n`; no low exceeds its high. `order` has their indices in stable order.
/// If no interval was widened, two objects overlap on the axis exactly if one of them has just one rank between the two ranks of the
/// other. Otherwise the overlapping objects are among these pairs. Ranks are below `2n`, and no two are equal. `lows` is scratch memory.
///
/// Computes in **O(n)** time.
pub(super) fn rank_endpoints<K: Copy + Ord>(
    keys: &[K],
    order: &[u32],
    lows: &mut Vec<u32>,
    ranks: &mut Vec<[u32; 2]>,
) -> bool {
    let n = keys.len() / 2;
    ranks.resize(n, [0; 2]);
    lows.clear();
    // The number of high endpoints so far: always fewer than lows, because a box begins before it ends.
    let mut ended = 0;
    for (rank, &endpoint) in (0..).zip(order) {
        let endpoint = endpoint as usize;
        if endpoint < n {
            ranks[endpoint][0] = rank;
            lows.push(endpoint as u32);
        } else {
            let object = lows[ended] as usize;
            if object + n != endpoint && keys[object + n] != keys[endpoint] {
                lows.clear();
                lows.extend(order.iter().filter(|&&endpoint| (endpoint as usize) < n));
                rank_widened(keys, lows, ranks);
                return false;
            }
            ranks[object][1] = rank;
            ended += 1;
        }
    }
    true
}

/// The same for widened intervals. Both kinds of endpoints are in the order of `lows`, so merging them is enough.
fn rank_widened<K: Copy + Ord>(keys: &[K], lows: &[u32], ranks: &mut [[u32; 2]]) {
    let n = lows.len();
    let high = |k: usize| keys[lows[k] as usize + n];
    let (mut rank, mut ended, mut reach) = (0, 0, high(0));
    for &object in lows {
        let low = keys[object as usize];
        // Stops before this object at the latest, because it does not end before it begins.
        while reach < low {
            ranks[lows[ended] as usize][1] = rank;
            rank += 1;
            ended += 1;
            reach = reach.max(high(ended));
        }
        ranks[object as usize][0] = rank;
        rank += 1;
    }
    for &object in &lows[ended..] {
        ranks[object as usize][1] = rank;
        rank += 1;
    }
}
