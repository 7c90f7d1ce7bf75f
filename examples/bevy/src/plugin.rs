//! The plugin that a game needs.

use bevy::prelude::*;
use bevy_rapier3d::prelude::RapierContextSimulation;
use bevy_rapier3d::rapier::geometry::DefaultBroadPhase;
use unisize::rapier3d_036::UnisizeBroadPhase;

/// Puts unisize into every Rapier context when it is made.
pub(crate) struct UnisizePlugin;

impl Plugin for UnisizePlugin {
    fn build(&self, app: &mut App) {
        app.add_observer(
            |added: On<Add<RapierContextSimulation>>,
             mut contexts: Query<&mut RapierContextSimulation>| {
                if let Ok(mut context) = contexts.get_mut(added.entity) {
                    context.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());
                }
            },
        );
    }
}
