//! The choices of the broad phase appear in its statistics, and settings override them.

use super::*;

/// Balls on a lattice in the xy plane, of which all or some move.
struct Plane {
    desk: Desk,
    handles: Vec<ColliderHandle>,
    updates: usize,
}

impl Plane {
    fn new(settings: Settings) -> Self {
        let settings = settings.with_filter(PairFilter::Groups).with_margin(0.01);
        let mut desk = Desk::with_settings(settings);
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
fn large_boxes_get_a_class_of_their_own() {
    let mut plane = Plane::new(Settings::default());
    let stats = plane.desk.broad_phase.stats();
    assert_eq!(stats.classes, 1);
    for &handle in plane.handles.iter().step_by(10) {
        plane.desk.colliders[handle].set_shape(SharedShape::ball(9.0));
    }
    plane.advance(1);
    assert!(plane.desk.broad_phase.stats().classes > 1);
}

#[test]
fn foresight_saves_searches_and_can_be_fixed() {
    let runs_with = |foresight| {
        let mut plane = Plane::new(Settings::default().with_foresight(foresight));
        (0..20).for_each(|_| _ = plane.advance(1));
        let stats = plane.desk.broad_phase.stats();
        (stats.full_searches, stats.foresight)
    };
    assert_eq!(runs_with(Some(0)), (21, 0));
    let (runs, foresight) = runs_with(Some(5));
    assert!(runs < 10 && foresight == 5, "{runs} with {foresight}");
    let (runs, foresight) = runs_with(None);
    assert!(runs < 10 && foresight > 0, "{runs} with {foresight}");
}

#[test]
fn a_few_moving_boxes_are_a_layer_if_layers_are_on() {
    for (layers, expected) in [(true, (1, 25)), (false, (2, 0))] {
        let mut plane = Plane::new(Settings::default().with_foresight(0).with_layers(layers));
        let runs = plane.advance(100);
        assert_eq!((runs, plane.desk.broad_phase.stats().above_base), expected);
    }
}
