//! The same questions to both.

use super::*;

#[test]
fn the_same_answers() {
    let mut random = Rand32::new(7);
    let mut world = PhysicsWorld {
        gravity: Vector::ZERO,
        ..PhysicsWorld::default()
    };
    for _ in 0..200 {
        let body = body(&mut random).translation(within(&mut random, 8.0));
        world.insert(body, collider(&mut random));
    }
    world.step();
    let all: Vec<_> = world.colliders.iter().map(|(handle, _)| handle).collect();
    let mut ours = UnisizeBroadPhase::new();
    ours.update(
        &world.integration_parameters,
        &world.colliders,
        &world.bodies,
        &all,
        &[],
        &mut Vec::new(),
    );
    let dispatcher = world.narrow_phase.query_dispatcher();
    let filter = QueryFilter::default();
    let pipelines = [
        ours.as_query_pipeline(dispatcher, &world.bodies, &world.colliders, filter),
        world
            .broad_phase
            .as_query_pipeline(dispatcher, &world.bodies, &world.colliders, filter),
    ];
    let [mut rays, mut points, mut meetings] = [0; 3];
    for _ in 0..500 {
        let (from, to) = (within(&mut random, 10.0), within(&mut random, 1.0));
        let ray = Ray::new(from, to);
        // If a ray begins inside several, any may be returned.
        let cast = |asked: QueryPipeline| {
            let hit = asked.cast_ray(&ray, 20.0, true);
            hit.map(|(handle, time)| (time, (time > 0.0).then_some(handle)))
        };
        let [ours, theirs] = pipelines.map(cast);
        assert_eq!(ours, theirs);
        rays += usize::from(ours.is_some());

        let at = |asked: QueryPipeline| -> BTreeSet<_> {
            let found = asked.intersect_point(from);
            found.map(|(handle, _)| handle.into_raw_parts()).collect()
        };
        let [ours, theirs] = pipelines.map(at);
        assert_eq!(ours, theirs);
        points += ours.len();

        let ball = Ball::new(1.0);
        let around = |asked: QueryPipeline| -> BTreeSet<_> {
            let found = asked.intersect_shape(Pose::from_translation(from), &ball);
            found.map(|(handle, _)| handle.into_raw_parts()).collect()
        };
        let [ours, theirs] = pipelines.map(around);
        assert_eq!(ours, theirs);
        meetings += ours.len();
    }
    assert!(
        rays > 100 && points > 10 && meetings > 100,
        "{rays} {points} {meetings}"
    );
}
