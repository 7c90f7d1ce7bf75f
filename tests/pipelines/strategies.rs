//! Random worlds and questions, by proptest, which also shrinks those that fail.

use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;

use crate::questions::{
    Body, Cast, Change, DEFAULT_MARGIN, Filter, GROUP_BITS, Inquiry, LENGTHS, Line, NUMBERS,
    NewCollider, OTHER_MARGINS, Pick, Pose, Question, REACHES, Round, Shape, Triple,
};

pub(crate) fn inquiries() -> impl Strategy<Value = Inquiry> {
    let opening = prop_oneof![
        4 => vec(new_colliders(), 0..6),
        3 => vec(new_colliders(), 6..40),
        1 => vec(new_colliders(), 40..250),
    ];
    let margin = prop_oneof![3 => Just(DEFAULT_MARGIN), 2 => select(&OTHER_MARGINS[..])];
    (margin, opening, vec(rounds(), 1..4)).prop_map(|(margin, opening, mut rounds)| {
        rounds[0].changes = opening.into_iter().map(Change::Insert).collect();
        Inquiry { margin, rounds }
    })
}

fn rounds() -> impl Strategy<Value = Round> {
    let questions = vec((questions(), filters()), 1..24);
    (vec(changes(), 0..12), 1..5_usize, questions).prop_map(|(changes, steps, questions)| Round {
        changes,
        steps,
        questions,
    })
}

fn changes() -> impl Strategy<Value = Change> {
    prop_oneof![
        4 => new_colliders().prop_map(Change::Insert),
        4 => picks().prop_map(Change::Remove),
        2 => (picks(), any::<bool>()).prop_map(|(i, on)| Change::Enable(i, on)),
        2 => (picks(), poses()).prop_map(|(i, to)| Change::Place(i, to)),
        1 => (picks(), shapes()).prop_map(|(i, shape)| Change::Resize(i, shape)),
        1 => (picks(), any::<bool>()).prop_map(|(i, on)| Change::Sensor(i, on)),
    ]
}

fn new_colliders() -> impl Strategy<Value = NewCollider> {
    let flags = (prop::bool::weighted(0.2), prop::bool::weighted(0.9));
    let body = option::weighted(
        0.8,
        select(&[Body::Dynamic, Body::Dynamic, Body::Fixed, Body::Kinematic][..]),
    );
    let groups = select(&GROUP_BITS[..]);
    (shapes(), poses(), velocities(), body, flags, groups).prop_map(
        |(shape, pose, velocity, body, (sensor, enabled), groups)| NewCollider {
            shape,
            pose,
            velocity,
            body,
            sensor,
            enabled,
            groups,
        },
    )
}

fn picks() -> impl Strategy<Value = Pick> {
    0..256_usize
}

fn lengths() -> impl Strategy<Value = f32> + Clone {
    prop_oneof![select(&LENGTHS[..]), 0.05..2.0_f32]
}

fn triples<S: Strategy<Value = f32> + Clone>(number: S) -> [S; 3] {
    [number.clone(), number.clone(), number]
}

fn places() -> impl Strategy<Value = Triple> {
    prop_oneof![
        6 => triples(select(&NUMBERS[..])),
        6 => triples(-12.0..12.0_f32),
        1 => triples(-300.0..300.0_f32),
    ]
}

/// Places that are not the centre of anything: the point nearest to the centre of a ball is NaN in Parry.
fn points() -> impl Strategy<Value = Triple> {
    places().prop_map(|[x, y, z]| [x + 0.013, y - 0.017, z + 0.011])
}

fn velocities() -> impl Strategy<Value = Triple> {
    prop_oneof![triples(select(&NUMBERS[..])), triples(-5.0..5.0_f32)]
}

/// A velocity or a direction that leads somewhere, in two dimensions as well.
fn directions() -> impl Strategy<Value = Triple> {
    velocities().prop_map(|[x, y, z]| [if x == 0.0 && y == 0.0 { 1.0 } else { x }, y, z])
}

fn turns() -> impl Strategy<Value = f32> {
    prop_oneof![Just(0.0_f32), -3.0..3.0_f32]
}

fn poses() -> impl Strategy<Value = Pose> {
    (places(), turns()).prop_map(|(at, turn)| Pose { at, turn })
}

/// Shapes that can be cast.
fn probes() -> impl Strategy<Value = Shape> {
    prop_oneof![
        4 => lengths().prop_map(Shape::Ball),
        4 => triples(lengths()).prop_map(Shape::Cuboid),
        2 => (lengths(), lengths()).prop_map(|(half, radius)| Shape::Capsule(half, radius)),
        1 => (lengths(), lengths()).prop_map(|(radius, gap)| Shape::Compound(radius, gap)),
    ]
}

fn shapes() -> impl Strategy<Value = Shape> {
    prop_oneof![
        28 => probes(),
        3 => lengths().prop_map(Shape::Mesh),
    ]
}

fn filters() -> impl Strategy<Value = Filter> {
    let rarely = 0.15;
    let flags = prop_oneof![3 => Just(0), 1 => 0..32_u32];
    let groups = option::weighted(rarely, select(&GROUP_BITS[..]));
    let excluded = (
        option::weighted(rarely, picks()),
        option::weighted(rarely, picks()),
    );
    let multiples = option::weighted(rarely, 1..4_u32);
    (flags, groups, excluded, multiples).prop_map(
        |(flags, groups, (collider, body_of), multiples)| Filter {
            flags,
            groups,
            collider,
            body_of,
            multiples,
        },
    )
}

fn casts() -> impl Strategy<Value = Cast> {
    let target_distance = prop_oneof![Just(0.0_f32), Just(0.1), Just(1.0)];
    let end = (select(&REACHES[..]), any::<bool>(), target_distance);
    (probes(), poses(), directions(), end).prop_map(
        |(shape, pose, velocity, (reach, stop_at_penetration, target_distance))| Cast {
            shape,
            pose,
            velocity,
            reach,
            stop_at_penetration,
            target_distance,
        },
    )
}

fn questions() -> impl Strategy<Value = Question> {
    let line = (places(), directions(), select(&REACHES[..]), any::<bool>());
    let line = line.prop_map(|(origin, direction, reach, solid)| Line {
        origin,
        direction,
        reach,
        solid,
    });
    prop_oneof![
        4 => line.prop_map(Question::Ray),
        4 => (points(), any::<bool>()).prop_map(|(at, solid)| Question::Point(at, solid)),
        3 => (probes(), poses()).prop_map(|(shape, pose)| Question::Shape(shape, pose)),
        2 => (places(), triples(lengths())).prop_map(|(at, half)| Question::Region(at, half)),
        3 => casts().prop_map(Question::Cast),
    ]
}
