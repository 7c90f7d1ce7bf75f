//! Single colliders that are not handled like the others in their lists.

use super::{Aabb, Colliders, Lists, MARGIN, PairFilter, Side, finish, table, with_threads};

#[test]
fn the_boxes_after_an_unusual_one_are_set_in_parts_as_well() {
    let aabb = |slot: u32| Aabb::new([2.0 * slot as f32, 0.0], [2.0 * slot as f32 + 1.0, 1.0]);
    let mut boxes: Vec<_> = (0..20_000).map(|slot| ((slot, 0), aabb(slot))).collect();
    let colliders = boxes.iter().map(|&(_, aabb)| (0, Some((aabb, Side(0)))));
    let colliders: Colliders = colliders.collect();
    let ids: Vec<_> = boxes.iter().map(|&(id, _)| id).collect();
    let mut table = table(PairFilter::Groups);
    table.update(&Lists::new(&ids, &[]), &colliders, MARGIN);
    finish(&mut table, &colliders);
    // One is that of a later collider, and the former one still has a box after that.
    boxes[7].0.1 = 1;
    boxes.push(((7, 0), aabb(7)));
    with_threads(2, || {
        let section = table.reading_section(boxes.len());
        assert!(section.parts() > 1);
        let unusual = table.follow_in_parts(section, &boxes, MARGIN);
        assert!(unusual == [7, 20_000], "{}", unusual.len());
    });
}
