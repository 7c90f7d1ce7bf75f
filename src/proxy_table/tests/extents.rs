//! Margins and reaches that change from update to update.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::{
    Aabb, BoxSource, Colliders, Id, Lists, MARGIN, Memo, PairFilter, Reading, Side, Volume, finish,
    table,
};

/// Colliders that count how often they are read.
struct Counted {
    colliders: Colliders,
    reach: f32,
    reads: AtomicUsize,
}

impl BoxSource<f32, 2> for Counted {
    type Handle = Id;
    type Memo = Memo;
    type Key = Side;

    fn reach(&self) -> f32 {
        self.reach
    }

    fn has_changed_unmoved(&self, _: Id, _: &Memo, _: &Side) -> bool {
        true
    }

    fn has_keys(&self) -> bool {
        true
    }

    fn read(&self, id: Id, memo: &mut Memo) -> Option<Reading<f32, 2, Side>> {
        self.colliders.read(id, memo)
    }

    fn volume(&self, id: Id, memo: &Memo, extension: f32) -> Volume<f32, 2> {
        self.reads.fetch_add(1, Ordering::Relaxed);
        self.colliders.volume(id, memo, extension)
    }
}

/// The number of volumes that updates read, one after the other, with these margins and reaches. No collider is listed but one, which stays where it is.
fn reads<const N: usize>(extents: [[f32; 2]; N]) -> [usize; N] {
    let aabb = |slot: u32| Aabb::new([slot as f32, 0.0], [slot as f32 + 0.5, 1.0]);
    let ids: [Id; 100] = core::array::from_fn(|slot| (slot as u32, 0));
    let mut table = table(PairFilter::Shapes);
    let mut source = Counted {
        colliders: ids
            .iter()
            .map(|&(slot, _)| (0, Some((aabb(slot), Side(0)))))
            .collect(),
        reach: 0.0,
        reads: AtomicUsize::new(0),
    };
    table.update(&Lists::new(&ids, &[]), &source, MARGIN);
    finish(&mut table, &source);
    extents.map(|[margin, reach]| {
        (source.reach, source.reads) = (reach, AtomicUsize::new(0));
        table.update(&Lists::new(&ids[..1], &[]), &source, margin);
        finish(&mut table, &source);
        source.reads.load(Ordering::Relaxed)
    })
}

#[test]
fn volumes_are_read_again_only_when_they_reach_farther_than_ever() {
    // Each of two pairs of extents has the larger reach or the larger margin.
    let [small, large] = [[0.25, 2.0], [0.5, 1.0]];
    assert_eq!(
        reads([small, large, small, large, small, large]),
        [100, 100, 0, 0, 0, 0]
    );
    let infinite = [f32::INFINITY; 2];
    let nan = [f32::NAN; 2];
    assert_eq!(
        reads([nan, infinite, large, infinite, nan, large]),
        [0, 100, 0, 0, 0, 0]
    );
}

#[test]
fn extents_that_grow_in_every_update_have_volumes_read_a_few_times() {
    let growing: [_; 64] = core::array::from_fn(|i| [1.0 + i as f32 / 16.0; 2]);
    let reads = reads(growing);
    let again = reads.iter().filter(|&&reads| reads > 0).count();
    // At 1, 1 1/16, 2 1/16 and 4 3/16.
    assert_eq!(again, 4, "{reads:?}");
}
