//! Random sequences, by proptest, which also shrinks those that fail.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use crate::ops::{
    ANGLES, BodyKind, FAR, FAR_INDICES, FILTERS, GROUP_BITS, Groups, LARGE, LENGTH_UNITS, LENGTHS,
    List, MARGINS, NEAR, NORMALS, NewCollider, Op, Parent, SKINS, SMALL, Sequence, Shape, Triple,
    Types,
};

pub(crate) fn sequences() -> impl Strategy<Value = Sequence> {
    let opening = vec((new_colliders(), parents()), 0..20);
    let updates = vec(vec(ops(), 0..7), 1..12);
    let length_unit = prop_oneof![4 => Just(LENGTH_UNITS[0]), 1 => select(&LENGTH_UNITS[..])];
    let margin = prop_oneof![4 => Just(MARGINS[0]), 3 => select(&MARGINS[..])];
    let foresight =
        prop_oneof![4 => Just(None), 1 => select(&[Some(0), Some(3), Some(u16::MAX)][..])];
    let layers = prop::bool::weighted(0.8);
    let filter = select(&FILTERS[..]);
    (
        length_unit,
        margin,
        foresight,
        layers,
        filter,
        opening,
        updates,
    )
        .prop_map(
            |(length_unit, margin, foresight, layers, filter, opening, mut updates)| {
                let opening = opening.into_iter();
                let opening = opening.map(|(collider, parent)| Op::Insert(collider, parent));
                updates.insert(0, opening.collect());
                Sequence {
                    length_unit,
                    margin,
                    foresight,
                    layers,
                    filter,
                    updates,
                }
            },
        )
}

fn ops() -> impl Strategy<Value = Op> {
    let pick = || 0..64_usize;
    let (small, large) = (
        triples(select(&SMALL[..])),
        triples(select(&LARGE[..])).boxed(),
    );
    let list = || select(&[List::Modified, List::Removed][..]);
    let bogus = prop_oneof![1 => 0..40_u32, 3 => select(&FAR_INDICES[..])];
    let existing = prop_oneof![
        6 => (pick(), small).prop_map(|(i, by)| Op::Move(i, by)),
        6 => (pick(), large.clone()).prop_map(|(i, by)| Op::Move(i, by)),
        2 => (pick(), large.clone()).prop_map(|(i, by)| Op::Shift(i, by)),
        2 => (pick(), places()).prop_map(|(i, to)| Op::Teleport(i, to)),
        4 => (pick(), triples(select(&ANGLES[..]))).prop_map(|(i, by)| Op::Turn(i, by)),
        1 => (pick(), any::<bool>()).prop_map(|(i, on)| Op::Hook(i, on)),
        2 => pick().prop_map(Op::Spoil),
        2 => (pick(), shapes()).prop_map(|(i, shape)| Op::Resize(i, shape)),
        1 => (pick(), select(&SKINS[..])).prop_map(|(i, s)| Op::Skin(i, s)),
        1 => (pick(), any::<bool>()).prop_map(|(i, on)| Op::Sensor(i, on)),
        3 => (pick(), any::<bool>()).prop_map(|(i, on)| Op::Enable(i, on)),
        3 => (pick(), groups()).prop_map(|(i, groups)| Op::Regroup(i, groups)),
        2 => (pick(), types()).prop_map(|(i, types)| Op::Retype(i, types)),
    ];
    let of_bodies = prop_oneof![
        1 => (pick(), any::<bool>()).prop_map(|(i, on)| Op::EnableBody(i, on)),
        1 => (pick(), body_kinds()).prop_map(|(i, kind)| Op::BodyType(i, kind)),
        1 => (pick(), large).prop_map(|(i, velocity)| Op::Push(i, velocity)),
        3 => (pick(), proptest::option::of(pick())).prop_map(|(i, to)| Op::Reparent(i, to)),
        1 => (pick(), any::<bool>()).prop_map(|(body, with_colliders)| Op::RemoveBody {
            body,
            with_colliders
        }),
    ];
    let in_and_out = prop_oneof![
        3 => (new_colliders(), parents()).prop_map(|(new, parent)| Op::Insert(new, parent)),
        3 => pick().prop_map(Op::Remove),
        1 => (pick(), new_colliders()).prop_map(|(i, new)| Op::Replace(i, new)),
    ];
    let listed = prop_oneof![
        (list(), pick()).prop_map(|(list, i)| Op::ListAgain(list, i)),
        (list(), pick()).prop_map(|(list, i)| Op::ListStale(list, i)),
        (list(), bogus, 0..4_u32).prop_map(|(list, index, g)| Op::ListBogus(list, index, g)),
    ];
    let length_unit = select(&LENGTH_UNITS[..]).prop_map(Op::LengthUnit);
    let (small, large) = (triples(select(&SMALL[..])), triples(select(&LARGE[..])));
    let slot = prop_oneof![3 => 0..40_u32, 1 => select(&FAR_INDICES[..])];
    let handed_over = prop_oneof![
        4 => (pick(), small).prop_map(|(i, by)| Op::Carry(i, by)),
        6 => (pick(), large).prop_map(|(i, by)| Op::Carry(i, by)),
        1 => (pick(), places()).prop_map(|(i, at)| Op::HandOver(i, Some(at))),
        1 => pick().prop_map(|i| Op::HandOver(i, None)),
        1 => (pick(), places()).prop_map(|(i, at)| Op::HandOverStale(i, at)),
        1 => (slot, 0..4_u32, places()).prop_map(|(i, g, at)| Op::HandOverBogus(i, g, at)),
    ];
    prop_oneof![
        16 => existing,
        6 => of_bodies,
        6 => in_and_out,
        2 => listed,
        6 => handed_over,
        1 => length_unit
    ]
}

fn triples(length: impl Strategy<Value = f32> + Clone) -> impl Strategy<Value = Triple> {
    [length.clone(), length.clone(), length]
}

fn places() -> impl Strategy<Value = Triple> {
    prop_oneof![12 => triples(select(&NEAR[..])), 1 => triples(select(&FAR[..]))]
}

fn lengths() -> impl Strategy<Value = f32> + Clone {
    select(&LENGTHS[..])
}

fn shapes() -> impl Strategy<Value = Shape> {
    let normal = triples(select(&NORMALS[..]));
    prop_oneof![
        4 => lengths().prop_map(Shape::Ball),
        4 => triples(lengths()).prop_map(Shape::Cuboid),
        2 => (lengths(), lengths()).prop_map(|(half, radius)| Shape::Capsule(half, radius)),
        2 => (lengths(), lengths()).prop_map(|(radius, gap)| Shape::Compound(radius, gap)),
        1 => normal.prop_map(Shape::HalfSpace),
    ]
}

fn groups() -> impl Strategy<Value = Groups> {
    let bits = || select(&GROUP_BITS[..]);
    let groups = (bits(), bits()).prop_map(|(memberships, filter)| Groups {
        memberships,
        filter,
    });
    let all = Groups {
        memberships: u32::MAX,
        filter: u32::MAX,
    };
    prop_oneof![2 => Just(all), 1 => groups]
}

fn types() -> impl Strategy<Value = Types> {
    prop_oneof![4 => Just(Types::Usual), 2 => Just(Types::All), 1 => Just(Types::None)]
}

fn body_kinds() -> impl Strategy<Value = BodyKind> {
    prop_oneof![
        3 => Just(BodyKind::Dynamic),
        1 => Just(BodyKind::Fixed),
        1 => Just(BodyKind::KinematicPosition),
        1 => Just(BodyKind::KinematicVelocity),
    ]
}

fn parents() -> impl Strategy<Value = Parent> {
    prop_oneof![
        1 => Just(Parent::None),
        4 => body_kinds().prop_map(Parent::New),
        2 => (0..64_usize).prop_map(Parent::Existing),
    ]
}

fn new_colliders() -> impl Strategy<Value = NewCollider> {
    let flags = (prop::bool::weighted(0.2), prop::bool::weighted(0.9));
    (shapes(), places(), flags, groups(), types()).prop_map(
        |(shape, at, (sensor, enabled), groups, types)| NewCollider {
            shape,
            at,
            sensor,
            enabled,
            groups,
            types,
        },
    )
}
