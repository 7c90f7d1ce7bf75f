//! Sets that a program clones and puts back later, while the broad phase goes on: rollback in a game, undo in an editor.

use super::super::rapier::prelude::*;
use super::super::scenes::groups;
use super::super::{UnisizeBroadPhase, World, version};
use super::{Playground, broad_phases};

/// What is cloned.
struct Saved {
    worlds: [World; 2],
    bodies: Vec<RigidBodyHandle>,
    colliders: Vec<ColliderHandle>,
}

/// All of a world that decides what comes next, except its broad phase.
fn saved(world: &World) -> World {
    World {
        params: world.params,
        islands: world.islands.clone(),
        narrow_phase: world.narrow_phase.clone(),
        bodies: world.bodies.clone(),
        colliders: world.colliders.clone(),
        impulse_joints: world.impulse_joints.clone(),
        multibody_joints: world.multibody_joints.clone(),
        ccd_solver: world.ccd_solver.clone(),
        ..World::new(world.gravity)
    }
}

impl Playground {
    /// Makes some steps that will not have been. Returns whether all bodies have moved alike.
    pub(super) fn roll_back(&mut self) -> bool {
        let kept = Saved {
            worlds: [&self.twins.ours, &self.twins.theirs].map(saved),
            bodies: self.bodies.clone(),
            colliders: self.colliders.clone(),
        };
        let mut moved_alike = true;
        for _ in 0..1 + self.random.below(3) {
            for _ in 0..self.random.below(3) {
                self.change_what_is_undone();
            }
            moved_alike = moved_alike && self.step();
        }
        [self.twins.ours, self.twins.theirs] = kept.worlds;
        (self.bodies, self.colliders) = (kept.bodies, kept.colliders);
        if version::CAN_SETS_BE_PUT_BACK {
            self.has_gone_back = true;
        } else {
            (self.ours, self.theirs) = broad_phases(self.filter);
            self.twins.both(|world| {
                world.narrow_phase = NarrowPhase::new();
                UnisizeBroadPhase::mark_all_modified(&mut world.colliders);
            });
        }
        moved_alike
    }

    fn change_what_is_undone(&mut self) {
        let index = self.random.below(self.bodies.len());
        let collider = self.colliders[index];
        let parent = self.body();
        match self.random.below(5) {
            0 => self.change_type(),
            1 => self.change(|it| it.set_collision_groups(groups(Group::NONE, Group::NONE))),
            2 => self.twins.set_parent(collider, Some(parent)),
            3 => self.change(|it| it.set_active_collision_types(ActiveCollisionTypes::empty())),
            // Not the collider of another, too.
            _ if self.twins.ours.bodies[self.bodies[index]].colliders() == [collider] => {
                self.replace(index);
            }
            _ => {}
        }
    }
}
