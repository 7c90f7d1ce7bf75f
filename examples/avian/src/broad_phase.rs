//! Avian's broad phase on `GridSweep`: a plugin in the place of `BvhBroadPhasePlugin`.

use std::time::Instant;

use avian3d::collider_tree::{
    ColliderTreeProxyFlags, ColliderTreeProxyKey, ColliderTreeType, ColliderTrees, MovedProxies,
};
use avian3d::collision::CollisionDiagnostics;
use avian3d::collision::contact_types::ContactEdgeFlags;
use avian3d::dynamics::joints::joint_graph::JointGraph;
use avian3d::prelude::*;
use bevy::prelude::*;
use unisize::{Aabb, GridSweep, PairFinder};

/// Has `GridSweep` find the pairs. Collision hooks are not asked.
pub(crate) struct UnisizeBroadPhasePlugin;

impl Plugin for UnisizeBroadPhasePlugin {
    fn build(&self, app: &mut App) {
        let system = collect_pairs.in_set(BroadPhaseSystems::CollectCollisions);
        app.add_systems(PhysicsSchedule, system);
    }
}

/// Kept between steps, for its memory.
#[derive(Default)]
struct Search {
    finder: GridSweep<f32, 3>,
    boxes: Vec<Aabb<f32, 3>>,
    keys: Vec<ColliderTreeProxyKey>,
    pairs: Vec<[u32; 2]>,
}

/// Adds to the contact graph all pairs whose enlarged boxes overlap, and of which one has left its enlarged box.
fn collect_pairs(
    mut search: Local<Search>,
    colliders: Query<(&ColliderTreeProxyKey, &EnlargedAabb)>,
    trees: Res<ColliderTrees>,
    moved: Res<MovedProxies>,
    joints: Res<JointGraph>,
    mut graph: ResMut<ContactGraph>,
    mut diagnostics: ResMut<CollisionDiagnostics>,
) -> Result {
    let began = Instant::now();
    if moved.proxies().is_empty() {
        return Ok(());
    }
    let Search {
        finder,
        boxes,
        keys,
        pairs,
    } = &mut *search;
    boxes.clear();
    keys.clear();
    for (&key, enlarged) in &colliders {
        let ColliderAabb { min, max } = enlarged.get();
        boxes.push(Aabb::new(min.to_array(), max.to_array()));
        keys.push(key);
    }
    pairs.clear();
    finder.find_pairs(boxes, pairs)?;
    for &pair in &*pairs {
        let [key1, key2] = pair.map(|i| keys[i as usize]);
        if !(moved.contains(key1) || moved.contains(key2)) {
            continue;
        }
        let (Some(proxy1), Some(proxy2)) = (trees.get_proxy(key1), trees.get_proxy(key2)) else {
            continue;
        };
        let flags = proxy1.flags.union(proxy2.flags);
        let is_sensor = flags.contains(ColliderTreeProxyFlags::SENSOR);
        let are_static = [key1, key2].map(|key| key.tree_type() == ColliderTreeType::Static);
        if (are_static == [true; 2] && !is_sensor)
            || proxy1.body == proxy2.body
            || !proxy1.layers.interacts_with(proxy2.layers)
            || graph.contains(proxy1.collider, proxy2.collider)
        {
            continue;
        }
        if let (Some(body1), Some(body2)) = (proxy1.body, proxy2.body) {
            let mut between = joints.joints_between(body1, body2);
            if between.any(|joint| joint.collision_disabled) {
                continue;
            }
        }
        let mut edge = ContactEdge::new(proxy1.collider, proxy2.collider);
        (edge.body1, edge.body2) = (proxy1.body, proxy2.body);
        let has = |flag| flags.contains(flag);
        edge.flags.set(
            ContactEdgeFlags::CONTACT_EVENTS,
            has(ColliderTreeProxyFlags::CONTACT_EVENTS),
        );
        graph.add_edge_with(edge, |contact| {
            (contact.body1, contact.body2) = (proxy1.body, proxy2.body);
            let is_solved = !has(ColliderTreeProxyFlags::BODY_DISABLED) && !is_sensor;
            contact
                .flags
                .set(ContactPairFlags::GENERATE_CONSTRAINTS, is_solved);
        });
    }
    diagnostics.broad_phase += began.elapsed();
    Ok(())
}
