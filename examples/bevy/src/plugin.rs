//! All that a game needs.

use bevy::prelude::*;
use bevy_rapier3d::prelude::RapierContextSimulation;
use bevy_rapier3d::rapier::geometry::DefaultBroadPhase;

/// Gives every Rapier context the broad phase that this function makes, as soon as the context is there:
/// `BroadPhasePlugin(|| DefaultBroadPhase::custom(UnisizeBroadPhase::new()))`.
pub(crate) struct BroadPhasePlugin(pub(crate) fn() -> DefaultBroadPhase);

impl Plugin for BroadPhasePlugin {
    fn build(&self, app: &mut App) {
        let make = self.0;
        app.add_observer(
            move |added: On<Add<RapierContextSimulation>>,
                  mut contexts: Query<&mut RapierContextSimulation>| {
                if let Ok(mut context) = contexts.get_mut(added.entity) {
                    context.broad_phase = make();
                }
            },
        );
    }
}
