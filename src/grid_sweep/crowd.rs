//! What crowds in one tube: boxes that are much smaller than most, say, or that lie where nobody looked when the grid was chosen.
//!
//! They are searched by a kernel of their own, which chooses a grid for them alone.

use super::GridSweep;
use super::class::Run;
use super::emitter::{Emitter, Tally};
use super::members::Everyone;
use super::tubes::Entry;
use crate::aabb::Aabb;
use crate::parallel::Section;
use crate::real::Real;
use crate::stopwatch::Stopwatch;

/// The entries of a tube, and the kernel that has searched them.
#[derive(Clone, Debug)]
pub(super) struct Crowd<R, const D: usize> {
    entries: Vec<Entry<R, D>>,
    kernel: GridSweep<R, D>,
}

impl<R: Real, const D: usize> Crowd<R, D> {
    /// Finds the pairs among the entries of a tube.
    pub(super) fn search(entries: &[Entry<R, D>], keeps: bool, emitter: &mut Emitter) -> Self {
        let boxes: Vec<_> = entries.iter().map(|entry| entry.aabb).collect();
        let mut kernel = GridSweep::default();
        let mut pairs = Vec::new();
        let mut run = Run {
            boxes: &boxes,
            is_crowd: true,
            slab_count: None,
            section: Section::default(),
            keeps,
            pairs: &mut pairs,
            wanted: None::<fn([u32; 2]) -> bool>,
            most: emitter.most,
            tally: Tally::default(),
            stopwatch: &mut Stopwatch::default(),
        };
        // What is invalid has been refused before it came into a tube.
        let _ = kernel.run(Everyone(boxes.len()), &mut run);
        emitter.compared += run.tally.compared;
        if run.is_over() {
            emitter.give_up(run.tally.emitted);
        }
        for pair in pairs {
            let [a, b] = pair.map(|i| entries[i as usize].owner);
            emitter.emit_one(a, b, true);
        }
        Self {
            entries: entries.to_vec(),
            kernel,
        }
    }

    /// Prepares for [`look_up`](Self::look_up).
    pub(super) fn prepare_lookup(&mut self) {
        self.kernel.prepare_lookup();
    }

    /// Calls `visit` with each entry that overlaps a box. Returns how many were compared with it, and tubes visited.
    pub(super) fn look_up(&self, aabb: &Aabb<R, D>, visit: impl FnMut(&Entry<R, D>)) -> usize {
        /// Above all others, so that it comes last in a pair.
        const QUERY: u32 = super::MAX_BOXES as u32;
        let mut pairs = Vec::new();
        let mut emitter = Emitter::new(&mut pairs, usize::MAX);
        self.kernel.look_up_box(aabb, QUERY, &mut emitter);
        let tally = emitter.finish();
        let found = pairs.iter().map(|&[i, _]| &self.entries[i as usize]);
        found.for_each(visit);
        tally.compared
    }
}
