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
    change_bytes(PairFilter::Off);
}

#[test]
fn changed_bytes_do_no_harm_where_there_are_volumes() {
    change_bytes(PairFilter::Shapes);
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

/// Changes one field of a snapshot, named by its path, and returns the error.
fn complaint(change: impl Fn(&mut Value)) -> String {
    complaint_with(PairFilter::Off, change)
}

fn complaint_with(filter: PairFilter, change: impl Fn(&mut Value)) -> String {
    let (crowd, broad_phase) = crowd(filter);
    let mut value = serde_json::to_value(&broad_phase).unwrap();
    let same: UnisizeBroadPhase = serde_json::from_value(value.clone()).unwrap();
    go_on(crowd, same);
    let before = value.clone();
    change(&mut value);
    assert_ne!(value, before, "nothing was changed");
    let outcome = serde_json::from_value::<UnisizeBroadPhase>(value);
    outcome.expect_err("it is accepted").to_string()
}

fn list(value: &mut Value) -> &mut Vec<Value> {
    value.as_array_mut().expect("it is a list")
}

/// The first proxy.
fn proxy(value: &mut Value) -> &mut Value {
    let mut proxies = list(&mut value["table"]["tracker"]["proxies"]).iter_mut();
    proxies
        .find(|proxy| !proxy.is_null())
        .expect("there are proxies")
}

#[test]
fn lengths_must_agree() {
    let fewer = complaint(|value| drop(list(&mut value["table"]["generations"]).pop()));
    assert!(fewer.contains("no collider"), "{fewer}");
    let more = complaint(|value| list(&mut value["table"]["generations"]).push(json!(7)));
    assert!(more.contains("generations"), "{more}");
}

#[test]
fn every_box_has_a_collider() {
    let unknown = complaint(|value| {
        let proxies = list(&mut value["table"]["tracker"]["proxies"]).iter();
        let slot = proxies.enumerate().find(|(_, proxy)| !proxy.is_null());
        let slot = slot.expect("there are proxies").0;
        value["table"]["generations"][slot] = Value::Null;
    });
    assert!(unknown.contains("no collider"), "{unknown}");
}

#[test]
fn boxes_must_be_valid() {
    let inverted = complaint(|value| {
        let aabb = &mut proxy(value)["aabb"];
        aabb["mins"][0] = json!(aabb["maxs"][0].as_f64().unwrap() + 1.0);
    });
    assert!(inverted.contains("not valid"), "{inverted}");
}

#[test]
fn pairs_that_are_near_must_overlap() {
    fn near(value: &mut Value) -> &mut Vec<Value> {
        list(&mut value["table"]["tracker"]["near"])
    }
    type Change = fn(&mut Value);
    let damages: [Change; 4] = [
        |value| near(value).push(json!([0, 1_000_000])),
        |value| near(value).push(json!([u32::MAX, u32::MAX])),
        |value| {
            let first = near(value)[0].clone();
            near(value).push(first);
        },
        |value| list(&mut near(value)[0]).reverse(),
    ];
    for change in damages {
        let said = complaint_with(PairFilter::Shapes, change);
        assert!(said.contains("near"), "{said}");
    }
    // All boxes that overlap are pairs where there are no volumes.
    let unused = complaint(|value| near(value).push(json!([0, 1])));
    assert!(unused.contains("near"), "{unused}");
}

#[test]
fn volumes_must_fit() {
    fn volumes(value: &mut Value) -> &mut Vec<Value> {
        list(&mut value["table"]["tracker"]["volumes"]["by_slot"])
    }
    fn first<'a>(value: &'a mut Value, kind: &str) -> &'a mut Value {
        let mut all = volumes(value).iter_mut();
        all.find(|volume| volume[0] == kind)
            .expect("there are some of each kind")
    }
    type Change = fn(&mut Value);
    let damages: [(&str, Change); 9] = [
        ("not a distance", |value| {
            value["table"]["tracker"]["volumes"]["margin"] = json!(-1.0);
        }),
        ("not one volume", |value| drop(volumes(value).pop())),
        ("not one volume", |value| {
            let one = volumes(value)[0].clone();
            volumes(value).push(one);
        }),
        ("lacks a number", |value| {
            list(&mut first(value, "Cuboid")[2]).pop();
        }),
        ("lacks a number", |value| {
            first(value, "Capsule")[0] = json!("Cuboid");
        }),
        ("lacks a number", |value| {
            first(value, "Ball")[0] = json!("Capsule");
        }),
        // They meet all whose boxes they overlap.
        ("although its volumes meet", |value| {
            volumes(value).fill(json!(["Box", false, []]));
        }),
        ("out of range", |value| {
            value["table"]["tracker"]["stirred"] = json!([1_000_000]);
        }),
        ("", |value| first(value, "Ball")[0] = json!("Sphere")),
    ];
    for (part, change) in damages {
        let said = complaint_with(PairFilter::Shapes, change);
        assert!(said.contains(part), "{said}");
    }
    let unused = complaint(|value| {
        value["table"]["tracker"]["volumes"]["by_slot"] = json!([["Box", false, []]]);
    });
    assert!(unused.contains("not one volume"), "{unused}");
    let unused = complaint(|value| value["table"]["tracker"]["stirred"] = json!([0]));
    assert!(unused.contains("none is in use"), "{unused}");
}

#[test]
fn counters_may_be_any_number() {
    let (crowd, broad_phase) = crowd(PairFilter::Off);
    let mut value = serde_json::to_value(&broad_phase).unwrap();
    value["table"]["tracker"]["full_runs"] = json!(u64::MAX);
    value["table"]["stats"]["updates"] = json!(u64::MAX);
    let before = serde_json::from_value::<UnisizeBroadPhase>(value).unwrap();
    assert_eq!(before.stats().full_runs, u64::MAX);
    let mut after = before.clone();
    let mut moved = crowd.clone();
    while after.stats().full_runs == u64::MAX {
        moved.advance(1);
        moved.update(&mut after);
    }
    assert_eq!(after.stats().full_runs, 0);
    go_on(crowd, before);
}

#[test]
fn another_format_is_named() {
    let other = complaint(|value| value["format"] = json!(1));
    assert!(
        other.contains("format 1") && other.contains("reads format 9"),
        "{other}"
    );
    // Before anything is read that the other version may have otherwise.
    let mut bytes = postcard::to_stdvec(&crowd(PairFilter::Off).1).unwrap();
    bytes[0] = 77;
    bytes.truncate(1);
    assert!(postcard::from_bytes::<UnisizeBroadPhase>(&bytes).is_err());
    let json = json!({ "format": 77 }).to_string();
    let said = serde_json::from_str::<UnisizeBroadPhase>(&json).unwrap_err();
    assert!(said.to_string().contains("format 77"), "{said}");
}
