//! Sequences in the steps of Rapier's own pipelines, which make the lists.

use super::super::rapier::prelude::*;
use super::super::suite::World;
use super::super::suite::checked::CheckedBroadPhase;
use crate::ops::Sequence;
use crate::random_values::check;
use crate::strategies::{SEQUENCES, sequences};

#[test]
fn steps_of_the_collision_pipeline() {
    check(SEQUENCES, &sequences(), play_collisions);
}

#[test]
fn steps_of_the_physics_pipeline() {
    check(SEQUENCES, &sequences(), play_physics);
}

/// Plays a sequence with one step for each of its updates, and one more without changes.
fn play(sequence: &Sequence, world: &mut World, mut step: impl FnMut(&mut World)) {
    for ops in &sequence.updates {
        for &op in ops {
            world.apply(op);
        }
        step(world);
    }
    step(world);
}

fn play_collisions(sequence: &Sequence) {
    let mut broad_phase = CheckedBroadPhase::new(sequence);
    let mut narrow_phase = NarrowPhase::new();
    let mut pipeline = CollisionPipeline::new();
    let mut world = World::new(sequence.length_unit.into());
    play(sequence, &mut world, |world| {
        pipeline.step(
            0.002 * world.params.length_unit,
            &mut broad_phase,
            &mut narrow_phase,
            &mut world.bodies,
            &mut world.colliders,
            &(),
            &(),
        );
    });
}

fn play_physics(sequence: &Sequence) {
    let mut broad_phase = CheckedBroadPhase::new(sequence);
    let mut narrow_phase = NarrowPhase::new();
    let mut pipeline = PhysicsPipeline::new();
    let mut ccd_solver = CCDSolver::new();
    let mut world = World::new(sequence.length_unit.into());
    world.engine_follows_bodies = true;
    play(sequence, &mut world, |world| {
        pipeline.step(
            &Vector::zeros(),
            &world.params,
            &mut world.islands,
            &mut broad_phase,
            &mut narrow_phase,
            &mut world.bodies,
            &mut world.colliders,
            &mut world.joints,
            &mut world.multibody_joints,
            &mut ccd_solver,
            &(),
            &(),
        );
    });
}
