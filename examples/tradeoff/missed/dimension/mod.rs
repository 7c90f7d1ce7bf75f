//! The measurements of what is missed, in one dimension: one source, compiled once for each.

use super::anew;
use super::broad_phases::AnyBroadPhase;
use super::common_box::CommonBox;
use super::contestant::{Contestant, Lap, Stage};
use super::replay::{WARM_UP, median, shuffle};
use super::truth::{SLACK, Truth, recall};
use super::{newest, ours, scenes};

mod broad_phases;
mod fed;
mod hash_grid;
mod newer;
mod race;
mod reel;
mod straight;

use crate::missed::method::Method;
use crate::missed::study::Study;
use crate::options::Options;
use scenes::rapier::math::DIM;
use unisize_scenes::SceneKind;

/// Measures in one scene; `on_step` is called after each step.
pub(crate) fn study(kind: SceneKind, options: &Options, mut on_step: impl FnMut()) -> Study {
    let bodies = options.bodies(kind);
    let mut scene = scenes::Scene::build(kind, bodies, options.seed);
    // Some scenes pour their bodies in.
    scene.prepare();
    let typical_size = super::typical_size(&scene);
    let is_fast = kind == SceneKind::Bullets;
    let methods = match is_fast {
        false => Method::all(bodies),
        true => Method::for_fast_things(bodies),
    };
    Study {
        scene: kind.name(),
        dim: DIM as u8,
        bodies,
        steps: options.steps(),
        typical_size,
        is_fast,
        figures: race::run(kind, options, &methods, typical_size, &mut on_step),
    }
}
