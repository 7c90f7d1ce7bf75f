//! Single colliders that are not handled like the others in their lists.

use super::{
    Aabb, Colliders, Lists, MARGIN, PairFilter, Side, Volume, finish, table, with_threads,
};

#[test]
fn the_boxes_after_an_unusual_one_are_set_in_parts_as_well() {
    let aabb = |slot: u32| Aabb::new([2.0 * slot as f32, 0.0], [2.0 * slot as f32 + 1.0, 1.0]);
    let mut boxes: Vec<_> = (0..20_000).map(|slot| ((slot, 0), aabb(slot))).collect();
    let colliders = boxes.iter().map(|&(_, aabb)| (0, Some((aabb, Side(0)))));
    let colliders: Colliders = colliders.collect();
    let ids: Vec<_> = boxes.iter().map(|&(id, _)| id).collect();
    let mut table = table(PairFilter::Groups);
    table.update(&Lists::new(&ids, &[]), &colliders, MARGIN);
    finish(&mut table);
    // One is that of a later collider, and the former one still has a box after that.
    boxes[7].0.1 = 1;
    boxes.push(((7, 0), aabb(7)));
    with_threads(2, || {
        let section = table.section(boxes.len());
        assert!(section.parts() > 1);
        let unusual = table.follow_in_parts(section, &boxes, MARGIN, &|_, _, _| Volume::BOX);
        assert!(unusual == [7, 20_000], "{}", unusual.len());
    });
}

#[test]
fn a_reinserted_collider_is_not_slow() {
    let ids = [(4, 0), (9, 0)];
    let mut colliders: Colliders = vec![(0, None); 10];
    let place = |colliders: &mut Colliders, slot: usize, at: f32| {
        let aabb = Aabb::new([at; 2], [at + 1.0; 2]);
        colliders[slot].1 = Some((aabb, Side(0)));
    };
    // Balls on a diagonal, apart by less than a sixteenth of the margin.
    place(&mut colliders, 4, 0.0);
    place(&mut colliders, 9, 0.5_f32.sqrt() + 0.002);
    let mut table = table(PairFilter::Shapes);
    table.update(&Lists::new(&ids, &[]), &colliders, MARGIN);
    assert_eq!(finish(&mut table), []);
    // The first move leaves the box, which then gets a margin; the second does not.
    for (at, reinserted) in [(-0.001, &[][..]), (-0.0012, &ids[..1])] {
        place(&mut colliders, 4, at);
        let lists = Lists {
            reinserted,
            ..Lists::new(&ids[..1], &[])
        };
        table.update(&lists, &colliders, MARGIN);
        assert_eq!(finish(&mut table), []);
    }
}
