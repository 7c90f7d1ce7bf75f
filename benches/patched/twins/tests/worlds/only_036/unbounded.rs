//! Boxes that are infinite, which Rapier's own broad phase skips: the collider keeps the box that it had, or has none, and nobody is
//! disabled for it.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, dynamic, fixed};
use super::{World, scenes};

/// A row of balls far from the origin that do not touch.
fn balls(twins: &mut Twins, count: usize) -> Vec<ColliderHandle> {
    let place = |i| dynamic(100.0 + 3.0 * i as Real, 0.0);
    let balls = (0..count).map(|i| twins.insert(place(i), ColliderBuilder::ball(1.0)).1);
    balls.collect()
}

/// Panics unless these are enabled, and no two colliders are a pair.
fn check_alone(twins: &Twins, balls: &[ColliderHandle]) {
    let colliders = &twins.ours.colliders;
    assert!(balls.iter().all(|&ball| colliders[ball].is_enabled()));
    for world in [&twins.ours, &twins.theirs] {
        assert_eq!(world.narrow_phase.contact_pairs().count(), 0);
    }
}

#[test]
fn an_infinite_skin() {
    let mut twins = Twins::weightless();
    let balls = balls(&mut twins, 100);
    twins.step();
    for body in [dynamic(0.0, 0.0), fixed(0.0, 5.0)] {
        let skin = ColliderBuilder::ball(1.0).contact_skin(Real::INFINITY);
        twins.insert(body, skin);
        twins.steps(3);
        check_alone(&twins, &balls);
    }
}

#[test]
fn a_box_that_overflows_once_it_is_loosened() {
    let mut twins = Twins::weightless();
    let balls = balls(&mut twins, 100);
    twins.step();
    let huge = ColliderBuilder::ball(0.9 * Real::MAX).contact_skin(0.9 * Real::MAX);
    twins.insert(fixed(0.0, 0.0), huge);
    twins.steps(3);
    check_alone(&twins, &balls);
}

#[test]
fn a_collider_keeps_the_box_that_it_had() {
    for skin in [Real::INFINITY, 0.9 * Real::MAX] {
        let mut twins = Twins::heavy();
        let (_, block) = twins.insert(fixed(0.0, 0.0), cube());
        let (_, ball) = twins.insert(dynamic(0.0, 3.0), ColliderBuilder::ball(0.5));
        let far = balls(&mut twins, 20);
        twins.step();
        twins.change(block, |collider| {
            collider.set_contact_skin(skin);
            collider.set_shape(SharedShape::ball(0.9 * Real::MAX));
        });
        twins.steps(20);
        let stats = twins.unisize.stats();
        assert_eq!([stats.proxies, stats.refused], [22, 0]);
        twins.change(block, |collider| {
            collider.set_contact_skin(0.0);
            collider.set_shape(SharedShape::ball(0.5));
        });
        twins.step_until(|seen| seen.touches(block, ball));
        assert!(
            far.iter()
                .all(|&ball| twins.ours.colliders[ball].is_enabled())
        );
    }
}

#[test]
fn a_soft_body_whose_motion_overflows() {
    let mut twins = Twins::weightless();
    let balls = balls(&mut twins, 100);
    twins.both(|world| scenes::insert_soft_body(world, at(0.0, 0.0), 1.0));
    twins.step();
    let speed = 0.1 * Real::MAX;
    twins.both(|world: &mut World| {
        for (_, body) in world.soft_bodies.iter_mut() {
            body.set_particle_velocity(0, at(speed, 0.0));
        }
    });
    twins.steps(3);
    check_alone(&twins, &balls);
}
