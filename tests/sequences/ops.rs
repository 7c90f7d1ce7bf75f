//! What can happen to colliders between two updates, in words that serve two and three dimensions.
//!
//! Lengths come from short tables, so that boxes often touch exactly, stay just inside their margin or leave
//! it by a little. Colliders and bodies are named by a number that is taken modulo how many there are, so that
//! every sequence, and every shortened one, makes sense.

use std::fmt;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

/// Coordinates; the last is unused in two dimensions.
pub(crate) type Triple = [f32; 3];

/// A collider or a body, counted modulo how many there are.
pub(crate) type Pick = usize;

#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Ball(f32),
    Cuboid(Triple),
    /// Half the height of its axis, and its radius.
    Capsule(f32, f32),
    /// Two balls of this radius, this far apart on each axis.
    Compound(f32, f32),
    HalfSpace(Triple),
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum BodyKind {
    Dynamic,
    Fixed,
    KinematicPosition,
    KinematicVelocity,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Parent {
    None,
    New(BodyKind),
    Existing(Pick),
}

/// Which collision groups a collider is in and meets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Groups {
    pub(crate) memberships: u32,
    pub(crate) filter: u32,
}

/// Which types of bodies a collider meets.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Types {
    Usual,
    All,
    None,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct NewCollider {
    pub(crate) shape: Shape,
    pub(crate) at: Triple,
    pub(crate) sensor: bool,
    pub(crate) enabled: bool,
    pub(crate) groups: Groups,
    pub(crate) types: Types,
}

/// One of the two lists that an update is given.
#[derive(Clone, Copy, Debug)]
pub(crate) enum List {
    Modified,
    Removed,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Op {
    Insert(NewCollider, Parent),
    /// Moves a collider, with its body if it has one.
    Move(Pick, Triple),
    /// Moves a collider with respect to its body.
    Shift(Pick, Triple),
    /// Puts a collider, or its body, at rest somewhere.
    Teleport(Pick, Triple),
    /// Makes the pose of a collider, or of its body, not a number.
    Spoil(Pick),
    Resize(Pick, Shape),
    Skin(Pick, f32),
    Sensor(Pick, bool),
    Enable(Pick, bool),
    EnableBody(Pick, bool),
    Regroup(Pick, Groups),
    Retype(Pick, Types),
    BodyType(Pick, BodyKind),
    Push(Pick, Triple),
    Reparent(Pick, Option<Pick>),
    Remove(Pick),
    /// Removes a collider and inserts another, which gets the same index.
    Replace(Pick, NewCollider),
    RemoveBody {
        body: Pick,
        with_colliders: bool,
    },
    /// Lists a collider once more. This and the following are for lists made by hand.
    ListAgain(List, Pick),
    /// Lists a collider that was removed some time ago.
    ListStale(List, Pick),
    /// Lists a handle that never existed.
    ListBogus(List, u32, u32),
}

/// What happens from an empty world on.
#[derive(Clone)]
pub(crate) struct Sequence {
    pub(crate) length_unit: f32,
    /// The margin in the settings.
    pub(crate) margin: f32,
    pub(crate) updates: Vec<Vec<Op>>,
}

impl fmt::Debug for Sequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "length unit {}, margin {}",
            self.length_unit, self.margin
        )?;
        for (i, ops) in self.updates.iter().enumerate() {
            writeln!(f, "update {i}")?;
            for op in ops {
                writeln!(f, "    {op:?}")?;
            }
        }
        Ok(())
    }
}

pub(crate) fn sequences() -> impl Strategy<Value = Sequence> {
    let opening = vec((new_colliders(), parents()), 0..20);
    let updates = vec(vec(ops(), 0..7), 1..12);
    let length_unit = prop_oneof![6 => Just(1.0_f32), 1 => Just(0.1), 1 => Just(10.0)];
    let margin = prop_oneof![6 => Just(0.01_f32), 1 => Just(0.0), 1 => Just(0.1), 1 => Just(-1.0)];
    (length_unit, margin, opening, updates).prop_map(
        |(length_unit, margin, opening, mut updates)| {
            let opening = opening.into_iter();
            let opening = opening.map(|(collider, parent)| Op::Insert(collider, parent));
            updates.insert(0, opening.collect());
            Sequence {
                length_unit,
                margin,
                updates,
            }
        },
    )
}

fn ops() -> impl Strategy<Value = Op> {
    let pick = || 0..64_usize;
    let small = select(&[0.0_f32, 0.001, -0.001, 0.005, -0.009, 0.01, 0.011, -0.02][..]);
    let large = select(&[0.0_f32, 0.25, -0.25, 0.5, -0.5, 1.0, -1.0, 2.5, -2.5][..]);
    let (small, large) = (triples(small), triples(large).boxed());
    let list = || select(&[List::Modified, List::Removed][..]);
    let bogus = prop_oneof![0..40_u32, Just(1 << 20), Just(u32::MAX - 1), Just(u32::MAX)];
    let existing = prop_oneof![
        6 => (pick(), small).prop_map(|(i, by)| Op::Move(i, by)),
        6 => (pick(), large.clone()).prop_map(|(i, by)| Op::Move(i, by)),
        2 => (pick(), large.clone()).prop_map(|(i, by)| Op::Shift(i, by)),
        2 => (pick(), places()).prop_map(|(i, to)| Op::Teleport(i, to)),
        2 => pick().prop_map(Op::Spoil),
        2 => (pick(), shapes()).prop_map(|(i, shape)| Op::Resize(i, shape)),
        1 => (pick(), select(&[0.0_f32, 0.005, 0.1, 1.0][..])).prop_map(|(i, s)| Op::Skin(i, s)),
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
    prop_oneof![8 => existing, 3 => of_bodies, 3 => in_and_out, 1 => listed]
}

fn triples(length: impl Strategy<Value = f32> + Clone) -> impl Strategy<Value = Triple> {
    [length.clone(), length.clone(), length]
}

fn places() -> impl Strategy<Value = Triple> {
    let near = select(&[0.0_f32, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5, 2.0, 3.0][..]);
    let far = select(&[0.0_f32, 1.0e3, -1.0e6, 1.0e18][..]);
    prop_oneof![12 => triples(near), 1 => triples(far)]
}

fn lengths() -> impl Strategy<Value = f32> + Clone {
    select(&[0.25_f32, 0.1, 0.5, 0.499, 1.0, 3.0][..])
}

fn shapes() -> impl Strategy<Value = Shape> {
    let normal = triples(select(&[0.0_f32, 1.0, -1.0][..]));
    prop_oneof![
        4 => lengths().prop_map(Shape::Ball),
        4 => triples(lengths()).prop_map(Shape::Cuboid),
        2 => (lengths(), lengths()).prop_map(|(half, radius)| Shape::Capsule(half, radius)),
        2 => (lengths(), lengths()).prop_map(|(radius, gap)| Shape::Compound(radius, gap)),
        1 => normal.prop_map(Shape::HalfSpace),
    ]
}

fn groups() -> impl Strategy<Value = Groups> {
    let bits = || select(&[u32::MAX, 1, 2, 0][..]);
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
