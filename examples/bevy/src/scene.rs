//! Balls above a box without a lid.

use bevy::prelude::*;
use bevy_rapier3d::prelude::*;

/// Spawns the box and this many balls, in layers that are shifted, so that they do not come to rest on top of each other.
pub(crate) fn spawn(mut commands: Commands, balls: u32) {
    let side = (f64::from(balls).cbrt().ceil() as u32).max(1);
    let half = 0.6 * side as f32 + 1.0;
    let walls = [
        (Vec3::NEG_Y, Vec3::new(half, 0.5, half)),
        (Vec3::X * half, Vec3::new(0.5, 2.0 * half, half)),
        (Vec3::NEG_X * half, Vec3::new(0.5, 2.0 * half, half)),
        (Vec3::Z * half, Vec3::new(half, 2.0 * half, 0.5)),
        (Vec3::NEG_Z * half, Vec3::new(half, 2.0 * half, 0.5)),
    ];
    for (center, size) in walls {
        commands.spawn((
            RigidBody::Fixed,
            Collider::cuboid(size.x, size.y, size.z),
            Transform::from_translation(center),
        ));
    }
    for ball in 0..balls {
        let place =
            [ball % side, ball / side % side, ball / (side * side)].map(|place| place as f32);
        let shift = 0.25 * (place[2] % 3.0) - 0.25;
        let position = Vec3::new(
            1.15 * (place[0] - 0.5 * side as f32) + shift,
            1.0 + 1.15 * place[2],
            1.15 * (place[1] - 0.5 * side as f32) - 0.5 * shift,
        );
        commands.spawn((
            RigidBody::Dynamic,
            Collider::ball(0.5),
            Restitution::coefficient(0.5),
            Transform::from_translation(position),
        ));
    }
}
