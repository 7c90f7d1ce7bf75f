//! What a restored broad phase tells as the one that was written does.

/// What a broad phase holds, and what its last update did; not how it did it, which is another way in a restored one.
pub(super) fn told(stats: &unisize::Stats) -> ([usize; 3], [usize; 4], u64) {
    let held = [stats.proxies, stats.refused, stats.pairs];
    let done = [stats.listed, stats.moved, stats.added, stats.deleted];
    (held, done, stats.updates)
}
