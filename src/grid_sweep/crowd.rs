//! A crowd: the entries of a tube that take too many comparisons.
//!
//! They are much smaller than most boxes, say, or lie where the sample saw nothing. A kernel of their own searches them with a grid
//! chosen for them alone. So kernels contain each other: a kernel has classes, a class has slabs, and the tubes of a slab may have
//! crowds.

use super::GridSweep;
use super::emitter::Emitter;
use super::entry::Entry;
use super::search::Search;
use crate::aabb::Aabb;
use crate::real::Real;

/// The entries of a tube, and the kernel that has searched them.
#[derive(Clone, Debug)]
pub(super) struct Crowd<R, const D: usize> {
    entries: Vec<Entry<R, D>>,
    pub(super) kernel: GridSweep<R, D>,
}

impl<R: Real, const D: usize> Crowd<R, D> {
    /// Emits the pairs among the entries of a tube.
    pub(super) fn search(
        entries: &[Entry<R, D>],
        room: f64,
        keeps: bool,
        emitter: &mut Emitter,
    ) -> Self {
        let boxes: Vec<_> = entries.iter().map(|entry| entry.aabb).collect();
        let owners = entries.iter().map(|entry| entry.owner).collect();
        let mut kernel = GridSweep::default();
        emitter.nest(owners, |names, pairs, tally, most| {
            let mut search = Search {
                room: Some(room),
                keeps,
                names: Some(names),
                most,
                tally,
                ..Search::new(&boxes, pairs)
            };
            // Invalid boxes do not reach a tube.
            let _ = kernel.search(None, &mut search);
            search.tally
        });
        Self {
            entries: entries.to_vec(),
            kernel,
        }
    }

    /// Calls `visit` with each entry that overlaps a box. Returns the comparisons, with visits of tubes in units of comparisons. Stops early
    /// if they exceed the budget and some for each of those entries, so that the budget of the caller is exceeded as well.
    pub(super) fn visit_overlapping(
        &self,
        aabb: &Aabb<R, D>,
        budget: usize,
        visit: impl FnMut(&Entry<R, D>),
    ) -> usize {
        /// The greatest index, so that it comes last in a pair.
        const QUERY: u32 = super::MAX_BOXES as u32;
        let mut pairs = Vec::new();
        let mut emitter = Emitter::new(&mut pairs, usize::MAX);
        emitter.begin_task(budget);
        self.kernel.look_up_box(aabb, QUERY, &mut emitter);
        let compared = emitter.finish().compared;
        let found = pairs.iter().map(|&[i, _]| &self.entries[i as usize]);
        found.for_each(visit);
        compared
    }
}
