//! Rapier's debug renderer: the same lines.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};
use super::{World, height_field, hinge, mesh_floor};

/// Every line, in an order of its own: what it belongs to, and its ends and colour to the last bit.
#[derive(Default)]
struct Lines(Vec<(String, String)>);

impl Lines {
    fn of(world: &World, mode: DebugRenderMode) -> Self {
        let mut lines = Self::default();
        DebugRenderPipeline::new(DebugRenderStyle::default(), mode).render(
            &mut lines,
            &world.bodies,
            &world.colliders,
            &world.impulse_joints,
            &world.multibody_joints,
            &world.narrow_phase,
        );
        lines.0.sort_unstable();
        lines
    }
}

impl DebugRenderBackend for Lines {
    fn draw_line(
        &mut self,
        object: DebugRenderObject<'_>,
        a: Point<Real>,
        b: Point<Real>,
        color: DebugColor,
    ) {
        let object = match object {
            DebugRenderObject::RigidBody(handle, _) => format!("{handle:?}"),
            DebugRenderObject::Collider(handle, _) => format!("{handle:?}"),
            DebugRenderObject::ColliderAabb(handle, ..) => format!("box of {handle:?}"),
            DebugRenderObject::ImpulseJoint(handle, _) => format!("{handle:?}"),
            DebugRenderObject::MultibodyJoint(handle, ..) => format!("{handle:?}"),
            DebugRenderObject::ContactPair(pair, ..) => {
                format!("{:?} on {:?}", pair.collider1, pair.collider2)
            }
        };
        self.0.push((object, format!("{a:?} to {b:?}, {color:?}")));
    }
}

/// One of everything that can be drawn.
fn exhibition() -> Twins {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    let shapes = [
        cube(),
        ColliderBuilder::ball(0.5),
        ColliderBuilder::capsule_y(0.3, 0.3),
        cube().sensor(true),
        cube().enabled(false),
        ColliderBuilder::compound(vec![
            (at(-0.5, 0.0).into(), SharedShape::ball(0.3)),
            (at(0.5, 0.0).into(), SharedShape::ball(0.3)),
        ]),
    ];
    for (i, shape) in shapes.into_iter().enumerate() {
        twins.insert(dynamic(4.0 * i as Real, 0.6), shape);
    }
    twins.insert(fixed(-10.0, 0.5), mesh_floor(2.0));
    twins.insert(fixed(-20.0, 0.5), height_field(2.0));
    twins.insert(dynamic(-10.0, 1.2), cube());
    twins.insert(
        RigidBodyBuilder::kinematic_velocity_based().translation(at(0.0, 8.0)),
        cuboid([1.0, 0.2, 1.0]),
    );
    for (x, is_in_reduced_coordinates) in [(-3.0, true), (5.0, false)] {
        let (left, _) = twins.insert(fixed(x, 6.0), cube());
        let (right, _) = twins.insert(dynamic(x + 2.0, 6.0), ColliderBuilder::ball(0.3));
        let joint = hinge().local_anchor2(at(-2.0, 0.0).into());
        twins.both(|world| match is_in_reduced_coordinates {
            true => {
                let joints = &mut world.multibody_joints;
                joints.insert(left, right, joint, true).is_some()
            }
            false => {
                let joints = &mut world.impulse_joints;
                joints.insert(left, right, joint, true).into_raw_parts().1 == 0
            }
        });
    }
    twins
}

#[test]
fn every_mode() {
    let mut twins = exhibition();
    let modes = DebugRenderMode::all()
        .iter()
        .chain([DebugRenderMode::all()]);
    let modes: Vec<_> = modes.collect();
    for steps in [1, 20, 200] {
        twins.steps(steps);
        for &mode in &modes {
            let ours = Lines::of(&twins.ours, mode);
            assert!(!ours.0.is_empty(), "nothing is drawn as {mode:?}");
            assert_eq!(ours.0, Lines::of(&twins.theirs, mode).0, "{mode:?}");
        }
    }
    let asleep = twins
        .ours
        .bodies
        .iter()
        .filter(|(_, body)| body.is_sleeping());
    assert!(asleep.count() > 0);
}
