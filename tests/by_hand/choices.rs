//! How many searches for all pairs the broad phase makes, and when it looks at a shape again.

use super::*;

/// Balls on a lattice in the xy plane, of which all or some move.
struct Plane {
    desk: Desk,
    handles: Vec<ColliderHandle>,
    updates: usize,
}

impl Plane {
    fn new() -> Self {
        let settings = Settings::default().with_filter(PairFilter::Groups);
        let mut desk = Desk::with_settings(settings.with_margin(0.01));
        let handles = (0..2500).map(|_| desk.ball(0.45, [0.0; 2])).collect();
        let mut plane = Self {
            desk,
            handles,
            updates: 0,
        };
        plane.advance(1);
        plane
    }

    /// Moves every `stride`-th ball, and lists it. Returns the number of full searches so far.
    fn advance(&mut self, stride: usize) -> u64 {
        let mut listed = Vec::new();
        for (i, &handle) in self.handles.iter().enumerate().step_by(stride) {
            let shift = 0.02 * self.updates as Real;
            let place = [(i % 50) as Real + shift, (i / 50) as Real];
            self.desk.place(handle, place);
            listed.push(handle);
        }
        self.desk.update(&listed, &[]);
        self.updates += 1;
        self.desk.broad_phase.stats().full_searches
    }
}

#[test]
fn foresight_saves_searches() {
    let mut plane = Plane::new();
    (0..19).for_each(|_| _ = plane.advance(1));
    let searches = plane.advance(1);
    assert!(searches < 10, "{searches}");
}

#[test]
fn a_few_moving_boxes_are_a_layer() {
    let mut plane = Plane::new();
    assert_eq!(plane.advance(100), 1);
}

#[test]
fn a_shape_that_is_replaced_or_changed_in_place_has_another_box() {
    let in_place = |collider: &mut Collider, radius: Real| {
        let ball = collider.shape_mut().as_ball_mut();
        ball.expect("it is a ball").radius = radius;
    };
    let by_a_ball = |collider: &mut Collider, radius| collider.set_shape(SharedShape::ball(radius));
    let by_another = |collider: &mut Collider, radius: Real| {
        collider.set_shape(SharedShape::capsule_x(radius / 2.0, radius / 2.0));
    };
    for change in [in_place, by_a_ball, by_another] {
        let mut desk = Desk::default();
        let [changing, other] = [0.0, 10.0].map(|x| desk.ball(0.5, [x, 0.0]));
        desk.update(&[changing, other], &[]);
        for (radius, pairs) in [(1.0, 0), (5.0, 0), (11.0, 1)] {
            change(&mut desk.colliders[changing], radius);
            desk.update(&[changing], &[]);
            assert_eq!(desk.counts()[2], pairs);
        }
    }
}
