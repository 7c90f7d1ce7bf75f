//! Ropes: the scene of that name, whose ropes and obstacles a seed moves a little.

use super::{Case, Ready, Stage, gauge};
use unisize_scenes::SceneKind;

/// The length of a link and its thickness.
const LINK: f64 = 0.5;
const THICKNESS: f64 = 0.2;

pub(super) fn build(case: &Case) -> Stage {
    let world = Ready::build(SceneKind::Ropes, case.bodies, case.seed).world;
    let energy = gauge::energy_gained(&world);
    Stage::new(world)
        .with(gauge::stretch(LINK))
        .with(gauge::penetration(THICKNESS))
        .with(energy)
}
