//! The broad phase by itself, among many colliders, with all kinds of updates before and after it is saved.

use super::crowd::Crowd;
use super::rapier::math::{DIM, Real};
use super::{Kernel, Settings, UnisizeBroadPhase, told};

/// One collider in this many moves, for twenty updates each: all of them, hardly any, and what lies between.
const STRIDES: [usize; 12] = [1, 200, 1, 2, 3, 250, 20, 100, 5, 30, 1, 300];

/// The number of updates between two round trips. It divides neither twenty nor the interval between two full runs.
const APART: usize = 7;

/// What is written, except how often there was a search for all pairs.
fn decisive(broad_phase: &UnisizeBroadPhase) -> serde_json::Value {
    let mut value = serde_json::to_value(broad_phase).expect("it can be written");
    value["table"]["tracker"]["full_runs"] = serde_json::Value::Null;
    value
}

fn drift(kernel: Kernel, count: usize, speed: Real) {
    let settings = Settings::default().with_kernel(kernel);
    let side = (count as f64 * if DIM == 2 { 1.5 } else { 2.5 }).powf(1.0 / DIM as f64);
    let mut crowd = Crowd::new(count, side as Real, speed);
    crowd.put_on_bodies();
    let mut ours = UnisizeBroadPhase::with_settings(settings);
    let mut twin = UnisizeBroadPhase::with_settings(settings);
    let (mut pairs, mut above_base) = (0, 0);
    for update in 0..20 * STRIDES.len() {
        if update % APART == 1 {
            let bytes = postcard::to_stdvec(&ours).expect("it can be written");
            // The twin has been restored before, more often each time.
            assert!(decisive(&twin) == decisive(&ours));
            twin = postcard::from_bytes(&bytes).expect("it can be read");
            twin.validate();
        }
        let expected = crowd.update(&mut ours);
        assert!(crowd.update(&mut twin) == expected, "update {update}");
        assert_eq!(told(&ours.stats()), told(&twin.stats()));
        pairs += ours.stats().pairs;
        above_base = above_base.max(ours.stats().above_base);
        crowd.advance(STRIDES[update / 20]);
    }
    assert!(pairs > 100 * count, "{pairs} pairs");
    assert!(ours.stats().refused > 0);
    assert!(above_base > count / 20 || kernel != Kernel::GridSweep);
}

#[test]
fn grid_sweep() {
    for speed in [0.01, 0.1, 0.4] {
        drift(Kernel::GridSweep, 2000, speed);
    }
}

/// Its slot is the last one, and never had a box.
#[test]
fn one_that_was_refused_from_the_start_is_kept() {
    let mut crowd = Crowd::new(40, 5.0, 0.1);
    crowd.spoil_last();
    let mut ours = UnisizeBroadPhase::new();
    crowd.update(&mut ours);
    assert_eq!(ours.stats().refused, 1);
    let bytes = postcard::to_stdvec(&ours).expect("it can be written");
    let mut twin: UnisizeBroadPhase = postcard::from_bytes(&bytes).expect("it can be read");
    twin.validate();
    for _ in 0..10 {
        crowd.advance(1);
        let expected = crowd.update(&mut ours);
        assert_eq!(crowd.update(&mut twin), expected);
        assert_eq!(told(&ours.stats()), told(&twin.stats()));
    }
    assert_eq!(ours.stats().refused, 0);
}

#[test]
fn rank_sweep() {
    drift(Kernel::RankSweep, 300, 0.1);
}

#[test]
fn brute_force() {
    drift(Kernel::BruteForce, 300, 0.1);
}
