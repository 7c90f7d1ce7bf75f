//! The choices of the broad phase appear in its diagnostics, and overrides fix them.

use super::*;
use unisize::{Diagnostics, Overrides};

/// Balls on a lattice in the xy plane, of which all or some move.
struct Plane {
    desk: Desk,
    handles: Vec<ColliderHandle>,
    updates: usize,
}

impl Plane {
    fn new(overrides: Overrides) -> Self {
        let settings = Settings::default().with_filter(PairFilter::Groups);
        let mut desk = Desk::with_settings(settings.with_margin(0.01));
        desk.broad_phase.set_overrides(overrides);
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

    fn diagnostics(&self) -> Diagnostics {
        self.desk.broad_phase.diagnostics()
    }
}

#[test]
fn foresight_saves_searches_and_can_be_fixed() {
    let runs_with = |foresight| {
        let mut plane = Plane::new(Overrides {
            foresight,
            ..Overrides::default()
        });
        (0..19).for_each(|_| _ = plane.advance(1));
        (plane.advance(1), plane.diagnostics().foresight)
    };
    assert_eq!(runs_with(Some(0)), (21, 0));
    let (runs, foresight) = runs_with(Some(5));
    assert!(runs < 10 && foresight == 5, "{runs} with {foresight}");
    let (runs, foresight) = runs_with(None);
    assert!(runs < 10 && foresight > 0, "{runs} with {foresight}");
}

#[test]
fn a_few_moving_boxes_are_a_layer_unless_every_search_is_full() {
    for (full_searches_only, expected) in [(false, 1), (true, 2)] {
        let mut plane = Plane::new(Overrides {
            foresight: Some(0),
            full_searches_only,
        });
        assert_eq!(plane.advance(100), expected);
    }
}
