//! What the broad phase chooses by itself shows in its statistics, and its settings can fix it.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, dynamic};
use super::{Settings, UnisizeBroadPhase};

/// Balls on a lattice in the plane of the first two axes that all move on, or one of them.
struct Plane {
    params: IntegrationParameters,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    handles: Vec<ColliderHandle>,
    broad_phase: UnisizeBroadPhase,
}

impl Plane {
    fn new(settings: Settings) -> Self {
        let mut plane = Self {
            params: IntegrationParameters::default(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            handles: Vec::new(),
            broad_phase: UnisizeBroadPhase::with_settings(settings),
        };
        for i in 0..2500 {
            let mut place = Vector::zeros();
            place.x = (i % 50) as Real;
            place.y = (i / 50) as Real;
            let ball = ColliderBuilder::ball(0.45).translation(place);
            let handle = plane.colliders.insert(ball);
            plane.handles.push(handle);
        }
        plane.advance(1);
        plane
    }

    /// Moves one ball in `stride`, and lists it.
    fn advance(&mut self, stride: usize) {
        let listed: Vec<_> = self.handles.iter().copied().step_by(stride).collect();
        for &handle in &listed {
            let collider = &mut self.colliders[handle];
            let place = collider.translation() + Vector::x() * 0.02;
            collider.set_translation(place);
        }
        let mut events = Vec::new();
        self.broad_phase.update(
            &self.params,
            &self.colliders,
            &self.bodies,
            &listed,
            &[],
            &mut events,
        );
        self.broad_phase.validate();
    }
}

#[test]
fn a_planar_scene_of_one_size_is_one_class_and_not_cut_across() {
    let plane = Plane::new(Settings::default());
    let stats = plane.broad_phase.stats();
    assert_eq!(stats.classes, 1);
    assert!(stats.strips[0] > 1);
    assert_eq!(stats.strips[1], 1);
}

#[test]
fn sizes_that_differ_much_are_several_classes() {
    let mut plane = Plane::new(Settings::default());
    for &handle in plane.handles.iter().step_by(10) {
        plane.colliders[handle].set_shape(SharedShape::ball(9.0));
    }
    plane.advance(1);
    assert!(plane.broad_phase.stats().classes > 1);
}

#[test]
fn looking_ahead_spares_searches_and_can_be_fixed() {
    let runs_with = |foresight| {
        let mut plane = Plane::new(Settings::default().with_foresight(foresight));
        (0..20).for_each(|_| plane.advance(1));
        let stats = plane.broad_phase.stats();
        (stats.full_runs, stats.foresight)
    };
    assert_eq!(runs_with(Some(0)), (21, 0));
    let (runs, foresight) = runs_with(Some(5));
    assert!(runs < 10, "{runs}");
    assert_eq!(foresight, 5);
    let (runs, foresight) = runs_with(None);
    assert!(runs < 10, "{runs}");
    assert!(foresight > 0);
}

#[test]
fn few_movers_are_a_layer_unless_there_are_to_be_none() {
    let outcome_with = |layers| {
        let mut plane = Plane::new(Settings::default().with_foresight(0).with_layers(layers));
        plane.advance(100);
        let stats = plane.broad_phase.stats();
        (stats.full_runs, stats.above_base)
    };
    assert_eq!(outcome_with(true), (1, 25));
    assert_eq!(outcome_with(false), (2, 0));
}

#[test]
fn a_step_makes_two_updates() {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    let (body, _) = twins.insert(dynamic(0.0, 0.5), cube());
    for step in 1..10 {
        twins.step();
        // There is nothing to list before the second step and after it.
        assert_eq!(twins.unisize.stats().updates, step + 1);
    }
    twins.change_body(body, |body| body.set_linvel(at(1.0, 0.0), true));
    twins.change_body(body, |body| body.set_translation(at(1.0, 0.5), true));
    twins.step();
    assert_eq!(twins.unisize.stats().updates, 12);
}
