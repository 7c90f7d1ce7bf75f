//! Balls above a box without a lid.

use bevy::prelude::*;
use bevy_rapier3d::prelude::*;

use crate::BALLS;

/// Spawns the box and the balls, in layers that are shifted, so that they do not come to rest on top of each other.
pub(crate) fn spawn(mut commands: Commands) {
    let side = f64::from(BALLS).cbrt().ceil() as u32;
    let half = 0.6 * side as f32 + 1.0;
    let walls = [
        (Vec3::NEG_Y, Vec3::new(half, 0.5, half)),
        (Vec3::X * half, Vec3::new(0.5, 2.0 * half, half)),
        (Vec3::NEG_X * half, Vec3::new(0.5, 2.0 * half, half)),
        (Vec3::Z * half, Vec3::new(half, 2.0 * half, 0.5)),
        (Vec3::NEG_Z * half, Vec3::new(half, 2.0 * half, 0.5)),
    ];
    for (center, half) in walls {
        commands.spawn((
            RigidBody::Fixed,
            Collider::cuboid(half.x, half.y, half.z),
            Transform::from_translation(center),
        ));
    }
    let middle = 0.5 * side as f32;
    for i in 0..BALLS {
        let [x, y, z] = [i % side, i / (side * side), i / side % side].map(|x| x as f32);
        let shift = 0.25 * (y % 3.0) - 0.25;
        let position = Vec3::new(
            1.15 * (x - middle) + shift,
            1.0 + 1.15 * y,
            1.15 * (z - middle) - 0.5 * shift,
        );
        commands.spawn((
            RigidBody::Dynamic,
            Collider::ball(0.5),
            Restitution::coefficient(0.5),
            Transform::from_translation(position),
        ));
    }
}
