//! A malformed snapshot is refused, or does no harm.

use oorandom::Rand32;
use serde_json::{Value, json};

use super::crowd::Crowd;
use super::rapier::math::DIM;
use super::rapier::prelude::{Cuboid, SharedShape};
use super::{PairFilter, Settings, UnisizeBroadPhase};

const COUNT: usize = 120;

/// How many damaged snapshots are tried.
const TRIALS: usize = 4000;

/// A crowd of which few move, at a moment when no part of the snapshot is empty.
fn crowd(filter: PairFilter) -> (Crowd, UnisizeBroadPhase) {
    let mut crowd = Crowd::new(COUNT, 8.0, 0.2);
    let [capsule, cuboid] = [
        SharedShape::capsule_y(0.5, 0.2),
        SharedShape::new(Cuboid::new([0.4; DIM].into())),
    ];
    for (i, &handle) in crowd.handles.iter().enumerate() {
        match i % 3 {
            0 => crowd.colliders[handle].set_shape(capsule.clone()),
            1 => crowd.colliders[handle].set_shape(cuboid.clone()),
            _ => {}
        }
    }
    let settings = Settings::default().with_filter(filter);
    let mut broad_phase = UnisizeBroadPhase::with_settings(settings);
    for update in 0..500 {
        crowd.update(&mut broad_phase);
        let value = serde_json::to_value(&broad_phase).unwrap();
        let is_near = !list(&mut value["table"]["tracker"]["near"].clone()).is_empty();
        if update > 10 && is_near == (filter == PairFilter::Shapes) {
            return (crowd, broad_phase);
        }
        crowd.advance(if update < 10 { 1 } else { 17 });
    }
    panic!("there is no such moment");
}

/// Goes on for a while, and validates after each update.
fn go_on(mut crowd: Crowd, mut broad_phase: UnisizeBroadPhase) {
    broad_phase.validate();
    for stride in [13, 7, 1, 50, 1] {
        crowd.advance(stride);
        crowd.update(&mut broad_phase);
        broad_phase.validate();
    }
}

#[test]
fn changed_bytes_do_no_harm() {
    for filter in [PairFilter::Off, PairFilter::Shapes] {
        change_bytes(filter);
    }
}

fn change_bytes(filter: PairFilter) {
    let (crowd, broad_phase) = crowd(filter);
    let bytes = postcard::to_stdvec(&broad_phase).unwrap();
    let mut random = Rand32::new(5);
    let mut read = 0;
    for _ in 0..TRIALS {
        let mut bytes = bytes.clone();
        for _ in 0..=random.rand_range(0..3) {
            let i = random.rand_range(0..bytes.len() as u32) as usize;
            bytes[i] = match random.rand_range(0..4) {
                0 => 0,
                1 => 255,
                2 => bytes[i] ^ 1 << random.rand_range(0..8),
                _ => random.rand_u32() as u8,
            };
        }
        if random.rand_range(0..50) == 0 {
            bytes.truncate(random.rand_range(0..bytes.len() as u32) as usize);
        }
        if let Ok(changed) = postcard::from_bytes::<UnisizeBroadPhase>(&bytes) {
            read += 1;
            if read % 8 == 0 {
                go_on(crowd.clone(), changed);
            } else {
                changed.validate();
            }
        }
    }
    // Most bytes are those of coordinates and of the numbers of volumes, whose low ones may be any; changes to others are detected.
    let most = TRIALS * 3 / 4;
    assert!((TRIALS / 100..most).contains(&read), "{read} were read");
}

/// What is wrong once a field was changed.
fn complaint(before: &Value, change: Change) -> String {
    let mut value = before.clone();
    change(&mut value);
    assert_ne!(value, *before, "nothing was changed");
    let outcome = serde_json::from_value::<UnisizeBroadPhase>(value);
    outcome.expect_err("it is accepted").to_string()
}

type Change = fn(&mut Value);

fn list(value: &mut Value) -> &mut Vec<Value> {
    value.as_array_mut().expect("it is a list")
}

fn tracker(value: &mut Value) -> &mut Value {
    &mut value["table"]["tracker"]
}

fn colliders(value: &mut Value) -> &mut Vec<Value> {
    list(&mut value["table"]["colliders"])
}

fn near(value: &mut Value) -> &mut Vec<Value> {
    list(&mut tracker(value)["near"])
}

fn volumes(value: &mut Value) -> &mut Vec<Value> {
    list(&mut tracker(value)["volumes"]["by_slot"])
}

/// The first volume of a kind.
fn volume<'a>(value: &'a mut Value, kind: &str) -> &'a mut Value {
    let mut all = volumes(value).iter_mut();
    all.find(|volume| volume[0] == kind)
        .expect("there are some of each kind")
}

/// The slot of the first proxy.
fn first_slot(value: &mut Value) -> usize {
    let boxes = list(&mut tracker(value)["boxes"]).iter();
    let slot = boxes.enumerate().find(|(_, aabb)| !aabb.is_null());
    slot.expect("there are proxies").0
}

/// What the error must say, and the damage.
const DAMAGES: [(&str, Change); 23] = [
    ("no collider", |value| drop(colliders(value).pop())),
    ("more colliders than slots", |value| {
        colliders(value).push(json!([null, {"without_volume": null}]))
    }),
    ("no collider", |value| {
        let slot = first_slot(value);
        colliders(value)[slot][0] = Value::Null;
    }),
    ("not valid", |value| {
        let slot = first_slot(value);
        let aabb = &mut tracker(value)["boxes"][slot];
        aabb["mins"][0] = json!(aabb["maxs"][0].as_f64().unwrap() + 1.0);
    }),
    ("one filter key", |value| {
        drop(list(&mut tracker(value)["keys"]).pop());
    }),
    ("near", |value| near(value).push(json!([0, 1_000_000]))),
    ("near", |value| {
        near(value).push(json!([u32::MAX, u32::MAX]))
    }),
    ("near", |value| {
        let first = near(value)[0].clone();
        near(value).push(first);
    }),
    ("near", |value| list(&mut near(value)[0]).reverse()),
    ("not a distance", |value| {
        tracker(value)["volumes"]["skin"] = json!(-1.0);
    }),
    ("not a distance", |value| {
        tracker(value)["volumes"]["reach"] = json!(-1.0);
    }),
    ("not one volume", |value| drop(volumes(value).pop())),
    ("not one volume", |value| {
        let one = volumes(value)[0].clone();
        volumes(value).push(one);
    }),
    ("other numbers", |value| {
        list(&mut volume(value, "Cuboid")[2]).pop();
    }),
    ("other numbers", |value| {
        volume(value, "Capsule")[0] = json!("Cuboid")
    }),
    ("other numbers", |value| {
        volume(value, "Ball")[0] = json!("Capsule")
    }),
    ("other numbers", |value| {
        volume(value, "Ball")[2][0] = json!(-0.5);
    }),
    ("other numbers", |value| {
        volume(value, "Ball")[0] = json!("Box")
    }),
    ("other numbers", |value| {
        volume(value, "Ball")[0] = json!("BoxUntilRead")
    }),
    // They meet all whose boxes they overlap.
    ("although its volumes meet", |value| {
        volumes(value).fill(json!(["Box", false, []]));
    }),
    ("out of range", |value| {
        tracker(value)["revolumed"] = json!([1_000_000]);
    }),
    ("", |value| volume(value, "Ball")[0] = json!("Sphere")),
    (
        "format 1, and this version of unisize reads format 16",
        |value| {
            value["format"] = json!(1);
        },
    ),
];

/// Of a snapshot without volumes.
const DAMAGES_WITHOUT_VOLUMES: [(&str, Change); 3] = [
    // All boxes that overlap are pairs.
    ("near", |value| near(value).push(json!([0, 1]))),
    ("not one volume", |value| {
        *volumes(value) = vec![json!(["Box", false, []])];
    }),
    ("none is in use", |value| {
        tracker(value)["revolumed"] = json!([0])
    }),
];

#[test]
fn damages_are_named() {
    for (filter, damages) in [
        (PairFilter::Shapes, &DAMAGES[..]),
        (PairFilter::Off, &DAMAGES_WITHOUT_VOLUMES),
    ] {
        let (crowd, broad_phase) = crowd(filter);
        let value = serde_json::to_value(&broad_phase).unwrap();
        go_on(crowd, serde_json::from_value(value.clone()).unwrap());
        for &(part, change) in damages {
            let said = complaint(&value, change);
            assert!(said.contains(part), "{said}, and not {part}");
        }
    }
}

/// Whether the pair was touched or not: both would be compared by volumes that there are not.
#[test]
fn a_pair_that_is_near_without_volumes_is_named() {
    let (_, broad_phase) = crowd(PairFilter::Off);
    let value = serde_json::to_value(&broad_phase).unwrap();
    let mut pairs = 0;
    for pair in broad_phase.pairs() {
        let slots = [pair.collider1, pair.collider2].map(|handle| handle.into_raw_parts().0);
        let mut damaged = value.clone();
        near(&mut damaged).push(json!([slots[0].min(slots[1]), slots[0].max(slots[1])]));
        let outcome = serde_json::from_value::<UnisizeBroadPhase>(damaged);
        let said = outcome.expect_err("it is accepted").to_string();
        assert!(said.contains("a pair is near"), "{said}");
        pairs += 1;
    }
    assert!(pairs > 10);
}

#[test]
fn counters_may_be_any_number() {
    let (crowd, broad_phase) = crowd(PairFilter::Off);
    let mut value = serde_json::to_value(&broad_phase).unwrap();
    value["table"]["tracker"]["full_searches"] = json!(u64::MAX);
    value["table"]["stats"]["updates"] = json!(u64::MAX);
    let before = serde_json::from_value::<UnisizeBroadPhase>(value).unwrap();
    assert_eq!(before.stats().full_searches, u64::MAX);
    let mut after = before.clone();
    let mut moved = crowd.clone();
    while after.stats().full_searches == u64::MAX {
        moved.advance(1);
        moved.update(&mut after);
    }
    assert_eq!(after.stats().full_searches, 0);
    go_on(crowd, before);
}

/// Before anything is read that the other version may have otherwise.
#[test]
fn another_format_is_named_at_once() {
    let json = json!({ "format": 77 }).to_string();
    let said = serde_json::from_str::<UnisizeBroadPhase>(&json).unwrap_err();
    assert!(said.to_string().contains("format 77"), "{said}");
}
