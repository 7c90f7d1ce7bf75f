//! One box against boxes that are already sorted.
//!
//! This is how boxes much larger than the rest meet the rest: a box that spans more than two strips on an
//! axis gets no entries, because there could be any number of them. And it is how a few boxes that have
//! moved meet the many that have not.
//!
//! Entries are sorted by `mins[0]`, and the running maximum of `maxs[0]` ascends too. So in each occupied
//! tube that the box spans, a binary search finds the first entry to look at, for boxes of any sizes.
//!
//! A box may span many tubes, and other boxes may have entries in several of them. Their pair is reported in the tube where the later of
//! both begins, along each axis. Where no tubes share a number, or for a box that is at most two strips wide, that is where not both are
//! ghosts on the same axis, as in the sweep.

use super::emitter::Emitter;
use super::grid::{Grid, TubeSpan};
use super::owner::Owner;
use super::tubes::{Entry, NOWHERE, Tube, Tubes};
use crate::aabb::{Aabb, max, min};
use crate::lanes::LANES;
use crate::real::Real;
use crate::tuning::kernel::{PASSED_OVER, VISIT};

/// A box that is looked up.
pub(super) struct Query<'a, R, const D: usize> {
    pub(super) aabb: &'a Aabb<R, D>,
    pub(super) index: u32,
    /// The grid of the tubes.
    pub(super) grid: &'a Grid<R>,
    /// The first strips of all tubes, if each has a number of its own.
    pub(super) first: Option<[u32; 2]>,
    /// The tubes that it spans.
    pub(super) span: TubeSpan,
}

impl<R: Real, const D: usize> Query<'_, R, D> {
    /// Whether the pair with an entry that it overlaps, of a box, is to be reported in the tube of these strips; `None`: in whatever tube it
    /// has been found, if each tube is visited once.
    #[inline(always)]
    fn reports(&self, owner: Owner, aabb: &Aabb<R, D>, strips: Option<[u32; 2]>) -> bool {
        let home = self.grid.tube_span(aabb).first;
        let later = [0, 1].map(|cut| home[cut].max(self.span.first[cut]));
        later == owner.strips(home) && strips.is_none_or(|strips| strips == later)
    }
}

impl<R: Real, const D: usize> Tubes<R, D> {
    /// Whether [`look_up`](Self::look_up) may be called.
    pub(super) fn is_prepared(&self) -> bool {
        self.running_maxs.len() == self.owners.len()
    }

    /// Prepares for [`look_up`](Self::look_up), until the next run, if it is not prepared.
    pub(super) fn prepare_lookup(&mut self) {
        self.bounds = Some(Aabb {
            mins: self
                .mins
                .each_ref()
                .map(|column| fold(column, R::INFINITY, min)),
            maxs: self
                .maxs
                .each_ref()
                .map(|column| fold(column, R::NEG_INFINITY, max)),
        });
        self.table.resize(self.range.len(), NOWHERE);
        self.running_maxs.extend_from_slice(&self.maxs[0]);
        for (position, tube) in (0..).zip(&mut self.tubes) {
            self.table[(tube.number - self.range.start) as usize] = position;
            let mut running = R::NEG_INFINITY;
            for max in &mut self.running_maxs[tube.start as usize..tube.end as usize] {
                running = if *max > running { *max } else { running };
                *max = running;
            }
            tube.reach = [self.mins[0][tube.start as usize], running];
        }
        self.crowds
            .iter_mut()
            .for_each(|(_, crowd)| crowd.prepare_lookup());
    }

    /// Reports the entries of all tubes that overlap a box.
    pub(super) fn look_up_everywhere(&self, query: &Query<R, D>, emitter: &mut Emitter) {
        for tube in &self.tubes {
            let strips = query
                .first
                .map(|first| query.grid.strips(tube.number, first));
            if strips.is_none_or(|strips| query.span.contains(strips)) {
                self.look_up_in(tube, query, strips, emitter);
            }
        }
    }

    /// Reports the entries of a tube of the range, in these strips, that overlap a box.
    #[inline(always)]
    pub(super) fn look_up(
        &self,
        number: u32,
        strips: [u32; 2],
        query: &Query<R, D>,
        emitter: &mut Emitter,
    ) {
        let position = self.table[(number - self.range.start) as usize];
        if let Some(tube) = self.tubes.get(position as usize) {
            self.look_up_in(tube, query, Some(strips), emitter);
        }
    }

    #[inline(always)]
    fn look_up_in(
        &self,
        tube: &Tube<R>,
        query: &Query<R, D>,
        strips: Option<[u32; 2]>,
        emitter: &mut Emitter,
    ) {
        let Query { aabb, index, .. } = query;
        let [first, last] = tube.reach;
        if (aabb.maxs[0] < first) | (aabb.mins[0] > last) {
            emitter.compared += PASSED_OVER;
            return;
        }
        if let Some(crowd) = self.crowd(tube.number) {
            let compared = crowd.look_up(aabb, |Entry { owner, aabb }| {
                let is_reported = query.reports(*owner, aabb, strips);
                emitter.emit_one(Owner(*index), *owner, is_reported);
            });
            emitter.compared += VISIT + compared;
            return;
        }
        let maxs = &self.running_maxs[tube.start as usize..tube.end as usize];
        let start = tube.start as usize + maxs.partition_point(|&max| max < aabb.mins[0]);
        let columns = self.columns();
        let is_small = query.span.beyond().iter().all(|&beyond| beyond <= 1);
        if let (Some(strips), true) = (strips, is_small || query.first.is_some()) {
            let owner = Owner::of(*index, strips, query.span.first);
            emitter.compared += VISIT + columns.report(start, aabb, owner, emitter);
            return;
        }
        let compared = columns.find(start, aabb, |i| {
            let owner = self.owners[i];
            let is_reported = query.reports(owner, &columns.entry(i), strips);
            emitter.emit_one(Owner(*index), owner, is_reported);
        });
        emitter.compared += VISIT + compared;
    }
}

/// The least or the greatest of numbers and a first one; there may be NaN among them. Eight in a row do not wait for each other.
#[inline(always)]
fn fold<R: Real>(numbers: &[R], first: R, choose: impl Fn(R, R) -> R) -> R {
    let mut eight = [first; LANES];
    let chunks = numbers.chunks_exact(LANES);
    let rest = chunks.remainder();
    for chunk in chunks {
        eight = core::array::from_fn(|lane| choose(chunk[lane], eight[lane]));
    }
    let all = eight.into_iter().chain(rest.iter().copied());
    all.fold(first, |chosen, number| choose(number, chosen))
}
