//! How many searches for all pairs the broad phase makes.

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
