//! Boxes that are not finite, which Rapier 0.36 skips: the collider keeps the box that it had, or has none.

use super::hostile::two_balls;
use super::*;

#[test]
fn colliders_without_a_finite_box_keep_theirs() {
    let (mut desk, [small, other]) = two_balls();
    assert_eq!(desk.update(&[small, other], &[]), [(true, [small, other])]);
    let far = desk.ball(0.5, [50.0, 0.0]);
    let new = desk.ball(Real::INFINITY, [50.0, 0.0]);
    // The last one is infinite only once it is loosened.
    for radius in [Real::INFINITY, Real::NAN, Real::MAX] {
        desk.colliders[other].set_shape(SharedShape::ball(radius));
        desk.colliders[other].set_contact_skin(Real::MAX);
        assert_eq!(desk.update(&[other, far, new], &[]), []);
        assert_eq!(desk.counts(), [3, 1, 1]);
    }
    desk.place(small, [20.0, 0.0]);
    assert_eq!(desk.update(&[small], &[]), [(false, [small, other])]);
    for ball in [other, new] {
        desk.colliders[ball].set_contact_skin(0.0);
        desk.colliders[ball].set_shape(SharedShape::ball(0.5));
    }
    desk.place(other, [20.9, 0.0]);
    let met = [(true, [small, other]), (true, [far, new])];
    assert_eq!(desk.update(&[other, new], &[]), met);
}

#[test]
fn an_infinite_margin_gives_infinite_boxes() {
    let (mut desk, [a, b]) = two_balls();
    let settings = desk.broad_phase.settings().with_margin(Real::INFINITY);
    desk.broad_phase = UnisizeBroadPhase::with_settings(settings);
    assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])]);
    desk.place(b, [1.9, 0.0]);
    assert_eq!(desk.update(&[b], &[]), []);
    desk.place(a, [20.0, 0.0]);
    assert_eq!(desk.update(&[a], &[]), []);
    assert_eq!(desk.counts(), [2, 0, 1]);
}

#[test]
fn with_an_infinite_length_unit_no_box_is_finite() {
    let (mut desk, [a, b]) = two_balls();
    desk.params.length_unit = Real::INFINITY;
    assert_eq!(desk.update(&[a, b], &[]), []);
    assert_eq!(desk.counts(), [0, 2, 0]);
}
