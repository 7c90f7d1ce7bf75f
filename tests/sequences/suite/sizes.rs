//! Shapes of one size, and shapes of any smaller size in the same place, down to the smallest numbers: with `PairFilter::Shapes`, all that
//! intersect are held.

use unisize::PairFilter;

use super::rapier::prelude::*;
use super::{Settings, UnisizeBroadPhase, rotation, version};

/// Shapes of about this size in many rotations.
fn turned_shapes(size: Real) -> impl Iterator<Item = Collider> {
    let scaled = |numbers: [Real; 3]| -> [Real; DIM] { std::array::from_fn(|k| size * numbers[k]) };
    let [a, b, c] = [[-0.4, -0.2, 0.1], [0.5, 0.3, -0.2], [-0.1, 0.4, 0.2]];
    let [a, b, c] = [a, b, c].map(|corner| version::Point::from(scaled(corner)));
    let cuboid = |half| SharedShape::new(Cuboid::new(scaled(half).into()));
    let shapes = [
        SharedShape::ball(0.4 * size),
        cuboid([0.3, 0.5, 0.4]),
        cuboid([0.3, 0.0, 0.4]),
        SharedShape::capsule(a, b, 0.2 * size),
        SharedShape::segment(a, b),
        SharedShape::triangle(a, b, c),
    ];
    (0..24).map(move |i| {
        let shape = shapes[i % shapes.len()].clone();
        let i = i as f32;
        let pose = rotation([0.37 * i, 1.3 * i - 5.0, 0.11 * i]);
        let all = ActiveCollisionTypes::all();
        let collider = ColliderBuilder::new(shape).active_collision_types(all);
        collider.position(pose).build()
    })
}

#[test]
fn shapes_that_intersect_are_held_at_every_size() {
    // No distance but that of the shapes counts.
    let params = IntegrationParameters {
        length_unit: 0.0,
        ..Default::default()
    };
    let exponents = match Real::MANTISSA_DIGITS {
        24 => 0..46,
        _ => 0..324,
    };
    let mut count = 0;
    for size in exponents.map(|exponent| (10.0 as Real).powi(-exponent)) {
        let settings = Settings::default().with_filter(PairFilter::Shapes);
        let mut broad_phase = UnisizeBroadPhase::with_settings(settings);
        let mut colliders = ColliderSet::new();
        let all: Vec<_> = [size, size, 1.0]
            .into_iter()
            .flat_map(turned_shapes)
            .collect();
        let handles: Vec<_> = all.iter().map(|it| colliders.insert(it.clone())).collect();
        let (bodies, mut events) = (RigidBodySet::new(), Vec::new());
        broad_phase.update(&params, &colliders, &bodies, &handles, &[], &mut events);
        let mut held = [[false; 72]; 72];
        for pair in broad_phase.pairs() {
            let pair = [pair.collider1, pair.collider2];
            let [i, j] = pair.map(|handle| handle.into_raw_parts().0 as usize);
            held[i][j] = true;
        }
        for (i, a) in all.iter().enumerate() {
            for (j, b) in all.iter().enumerate().skip(i + 1) {
                let overlap = a.compute_aabb().intersects(&b.compute_aabb());
                if overlap && version::intersect(a, b) {
                    assert!(held[i][j], "{size}: {i} and {j}");
                    count += 1;
                }
            }
        }
    }
    assert!(count > 10_000);
}
