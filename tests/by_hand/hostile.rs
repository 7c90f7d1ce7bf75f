//! Unusual numbers: inverted and infinite boxes, denormals, invalid lengths. `tests/sequences` has invalid lists, and poses with NaN.

use super::*;

/// Two balls that overlap.
fn two_balls() -> (Desk, [ColliderHandle; 2]) {
    let mut desk = Desk::with_settings(Settings::default().with_filter(PairFilter::Off));
    let balls = [0.0, 0.9].map(|x| desk.ball(0.5, [x, 0.0]));
    (desk, balls)
}

#[test]
fn inverted_boxes_are_refused_until_they_are_valid() {
    let (mut desk, [a, b]) = two_balls();
    desk.colliders[b].set_shape(SharedShape::ball(-0.5));
    assert_eq!(desk.update(&[a, b], &[]), []);
    assert_eq!(desk.counts(), [1, 1, 0]);
    desk.colliders[b].set_shape(SharedShape::ball(0.5));
    assert_eq!(desk.update(&[b], &[]), [(true, [a, b])]);
    desk.colliders[b].set_shape(SharedShape::ball(-0.5));
    assert_eq!(desk.update(&[b], &[]), [(false, [a, b])]);
    assert_eq!(desk.update(&[], &[b]), []);
    assert_eq!(desk.counts(), [1, 0, 0]);
}

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
fn denormals_and_negative_zeros_compare_as_numbers() {
    let mut desk = Desk::with_settings(Settings::default().with_filter(PairFilter::Off));
    // Without prediction and margin, the boxes are those of the shapes.
    desk.params.length_unit = 0.0;
    let least = Real::from_bits(1);
    let points = [-0.0, 0.0, least, -least, 2.0 * least].map(|x| desk.ball(0.0, [x, 0.0]));
    let zeros = [points[0], points[1]];
    assert_eq!(desk.update(&points, &[]), [(true, zeros)]);
    let ball = desk.ball(least, [0.0, 0.0]);
    let mut met = desk.update(&[ball], &[]);
    met.sort_by_key(|event| event.1.map(|handle| handle.into_raw_parts()));
    let expected = [0, 1, 2, 3].map(|i| (true, [points[i], ball]));
    assert_eq!(met, expected);
    // A change from -0 to 0 ends no pair.
    desk.place(points[0], [0.0, 0.0]);
    assert_eq!(desk.update(&[points[0]], &[]), []);
}

#[test]
fn invalid_length_units_give_no_margin() {
    let units = [Real::NAN, -1.0, 0.0].map(|unit| (unit, 1));
    // The margin is so large that all boxes overlap.
    let large = [Real::INFINITY, Real::MAX].map(|unit| (unit, 0));
    for (unit, ended) in units.into_iter().chain(large) {
        let (mut desk, [a, b]) = two_balls();
        desk.params.length_unit = unit;
        assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])], "{unit}");
        desk.place(b, [20.0, 0.0]);
        assert_eq!(desk.update(&[b], &[]).len(), ended, "{unit}");
    }
}

/// The product of two negative numbers is positive.
#[test]
fn a_negative_margin_and_a_negative_length_unit_give_no_margin() {
    let (mut desk, [a, b]) = two_balls();
    let settings = desk.broad_phase.settings().with_margin(-100.0);
    desk.broad_phase = UnisizeBroadPhase::with_settings(settings);
    desk.params.length_unit = -1.0;
    assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])]);
    desk.place(b, [20.0, 0.0]);
    assert_eq!(desk.update(&[b], &[]), [(false, [a, b])]);
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

/// With such skins, Rapier panics on a compound shape.
#[test]
fn invalid_contact_skins_do_not_loosen_boxes() {
    for skin in [-1.0, Real::NAN, 0.0] {
        let (mut desk, [a, b]) = two_balls();
        let pair = [(Default::default(), SharedShape::ball(0.5))];
        desk.colliders[a].set_shape(SharedShape::compound(pair.to_vec()));
        for ball in [a, b] {
            desk.colliders[ball].set_contact_skin(skin);
        }
        assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])], "{skin}");
        desk.place(b, [1.1, 0.0]);
        assert_eq!(desk.update(&[b], &[]), [(false, [a, b])], "{skin}");
    }
}

#[test]
fn a_body_may_have_a_hundred_thousand_colliders() {
    let mut desk = Desk::default();
    let body = desk.bodies.insert(RigidBodyBuilder::dynamic());
    let last = 99_999;
    let mut colliders: Vec<_> = (0..=last)
        .map(|i| {
            let centre = [2.0 * i as Real, 0.0];
            let part = desk.ball(0.5, centre);
            desk.colliders
                .set_parent(part, Some(body), &mut desk.bodies);
            desk.place(part, centre);
            part
        })
        .collect();
    let ends = [colliders[0], colliders[last]];
    let other = desk.ball(0.5, [-0.9, 0.0]);
    colliders.push(other);
    assert_eq!(desk.update(&colliders, &[]), [(true, [ends[0], other])]);
    desk.place(other, [2.0 * last as Real + 0.9, 0.0]);
    let moved = [(false, [ends[0], other]), (true, [ends[1], other])];
    assert_eq!(desk.update(&[other], &[]), moved);
    assert_eq!(desk.update(&[], &colliders[..=last]), []);
    assert_eq!(desk.counts(), [1, 0, 0]);
}
