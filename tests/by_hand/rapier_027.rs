//! Boxes that are not finite, which Rapier 0.27 treats like any other.

use super::hostile::two_balls;
use super::*;

#[test]
fn infinite_boxes_form_pairs() {
    let (mut desk, [small, all]) = two_balls();
    desk.colliders[all].set_shape(SharedShape::ball(Real::INFINITY));
    let [far, beside] = [[Real::INFINITY, 0.0]; 2].map(|centre| desk.ball(0.5, centre));
    let mut events = desk.update(&[small, all, far, beside], &[]);
    events.sort_by_key(|event| event.1.map(|handle| handle.into_raw_parts()));
    let pairs = [[small, all], [all, far], [all, beside], [far, beside]];
    assert_eq!(events, pairs.map(|pair| (true, pair)));
    desk.place(far, [Real::NEG_INFINITY, 0.0]);
    assert_eq!(desk.update(&[far], &[]), [(false, [far, beside])]);
    // Infinity minus infinity is NaN.
    desk.place(all, [Real::INFINITY, 0.0]);
    assert_eq!(desk.update(&[all], &[]).len(), 3);
    assert_eq!(desk.counts(), [3, 1, 0]);
}

#[test]
fn an_infinite_margin_gives_infinite_boxes() {
    let (mut desk, [a, b]) = two_balls();
    let settings = desk.broad_phase.settings().with_margin(Real::INFINITY);
    desk.broad_phase = UnisizeBroadPhase::with_settings(settings);
    assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])]);
    // An infinite bound gets no margin, because infinity minus infinity is NaN.
    desk.place(a, [Real::INFINITY, 0.0]);
    assert_eq!(desk.update(&[a], &[]), [(false, [a, b])]);
    desk.place(b, [1.9, 0.0]);
    assert_eq!(desk.update(&[b], &[]), [(true, [a, b])]);
    assert_eq!(desk.counts(), [2, 0, 1]);
}

#[test]
fn an_infinite_length_unit_gives_infinite_boxes() {
    let (mut desk, [a, b]) = two_balls();
    desk.params.length_unit = Real::INFINITY;
    assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])]);
    desk.place(b, [20.0, 0.0]);
    assert_eq!(desk.update(&[b], &[]), []);
}
