//! The ranks of the endpoints of the first axis, such that no interval includes another.
//!
//! The sweep rests on the paper's Claim 1: in the order of the endpoints, no interval includes another. This says no
//! more than that the high endpoints come in the order of their objects' low endpoints, so it is established by
//! counting: *the k-th high endpoint belongs to the object of the k-th low endpoint.*
//!
//! - Boxes of one size have their high endpoints in that order anyway, except for equal ones: where coordinates are
//!   large, `x + size` rounds different `x` to one number, and the order of object ids, which a stable sort gives, may
//!   be the wrong one. Then it is enough to reassign the equal endpoints.
//! - Boxes of different sizes are widened until it holds: an interval ends no earlier than any that begins before it.
//!   That is the least widening that suffices. It never exceeds widening to a common length `s`, since no interval that
//!   begins at or before `x` ends beyond `x + s`. It takes no arithmetic, so it cannot round, overflow or meet `∞ - ∞`.

/// Sets `ranks[i]` to the ranks of the low and the high endpoint of object `i`, and returns whether nothing had to be
/// widened.
///
/// `keys` are the endpoints, lows at `i` and highs at `i + n`, each low at most its high; `order` are their indexes in
/// stable order. If nothing was widened, two objects overlap on the axis exactly if one of them has just one rank
/// between the two ranks of the other; otherwise those that overlap are among these pairs. Ranks differ, and are below
/// `2n`. `lows` is scratch memory.
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
    // How many high endpoints there were: always fewer than lows, because a box begins before it ends.
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

/// The same for widened intervals: both kinds of endpoints have the order of `lows`, so they need only be merged.
fn rank_widened<K: Copy + Ord>(keys: &[K], lows: &[u32], ranks: &mut [[u32; 2]]) {
    let n = lows.len();
    let high = |k: usize| keys[lows[k] as usize + n];
    let (mut rank, mut ended, mut reach) = (0, 0, high(0));
    for &object in lows {
        let low = keys[object as usize];
        // Stops before this object at the latest: its own end is not less than its beginning.
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
