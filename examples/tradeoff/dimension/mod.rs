//! The measurements in one dimension: one source, compiled once for each.

use super::{newest, ours, scenes};

mod anew;
mod broad_phases;
mod common_box;
mod contestant;
mod film;
#[path = "../missed/dimension/mod.rs"]
mod missed;
mod replay;
mod truth;

pub(crate) use missed::study as missed;

use crate::method::Method;
use crate::options::Options;
use crate::study::Study;
use scenes::rapier::{math::DIM, prelude::*};
use unisize_scenes::SceneKind;

/// Measures in one scene; `on_step` is called after each step that is measured or simulated.
pub(crate) fn study(kind: SceneKind, options: &Options, mut on_step: impl FnMut()) -> Study {
    let (bodies, course_bodies) = (options.bodies(kind), options.course_bodies(kind));
    let mut scene = scenes::Scene::build(kind, bodies, options.seed);
    // Some scenes pour their bodies in.
    scene.prepare();
    let typical_size = typical_size(&scene);
    let methods = Method::all(bodies);
    let figures = replay::run(kind, options, &methods, typical_size, &mut on_step);
    let courses = film::courses(kind, options, typical_size, &mut on_step);
    Study {
        scene: kind.name(),
        dim: DIM as u8,
        bodies,
        steps: options.steps(),
        typical_size,
        default_margin: ours::UnisizeBroadPhase::DEFAULT_MARGIN,
        course_bodies,
        figures,
        courses,
    }
}

/// The median of the largest extents of all colliders that can move.
fn typical_size(scene: &scenes::Scene) -> Real {
    let world = &scene.world;
    let can_move = |collider: &&Collider| {
        let body = collider.parent().map(|parent| &world.bodies[parent]);
        body.is_some_and(|body| !body.is_fixed())
    };
    let colliders = world.colliders.iter().map(|(_, collider)| collider);
    let size = |collider: &Collider| collider.shape().compute_local_aabb().extents().max();
    let mut sizes: Vec<_> = colliders.filter(can_move).map(size).collect();
    sizes.sort_by(Real::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
}
