//! Scenes in WebAssembly: worlds on Rapier's own broad phase or on unisize, which a page steps, times and draws.
//!
//! A [`Side`] is one world. The page makes two, which differ in the broad phase only. The source is compiled once for each flavour of Rapier,
//! with the feature of that name: the page loads the one that it needs.

#[cfg(feature = "check")]
mod check;
mod drawing;
#[cfg(feature = "check")]
#[path = "../../../tests/golden/hash.rs"]
mod hash;
#[cfg(any(feature = "rapier2d-027", feature = "rapier3d-027"))]
#[path = "rapier_027.rs"]
mod version;
#[cfg(any(feature = "rapier2d-036", feature = "rapier3d-036"))]
#[path = "rapier_036.rs"]
mod version;

#[cfg(feature = "check")]
pub use check::{first_difference, golden, scenes};

use unisize_scenes::SceneKind;
use wasm_bindgen::prelude::*;
#[cfg(feature = "rapier2d-027")]
use {rapier2d_027 as rapier, unisize::rapier2d_027 as adapter, unisize_scenes::dim2 as engine};
#[cfg(feature = "rapier2d-036")]
use {
    rapier2d_036 as rapier, unisize::rapier2d_036 as adapter, unisize_scenes::dim2_036 as engine,
};
#[cfg(feature = "rapier3d-027")]
use {rapier3d_027 as rapier, unisize::rapier3d_027 as adapter, unisize_scenes::dim3 as engine};
#[cfg(feature = "rapier3d-036")]
use {
    rapier3d_036 as rapier, unisize::rapier3d_036 as adapter, unisize_scenes::dim3_036 as engine,
};

use adapter::UnisizeBroadPhase;
use drawing::{Batch, SLAB};
use engine::{Installed, Scene, Steppable, install};
use rapier::math::DIM;
use rapier::prelude::{Collider, DefaultBroadPhase};

/// Finds the scene of this name.
fn kind(scene: &str) -> Result<SceneKind, JsError> {
    SceneKind::from_name(scene).ok_or_else(|| JsError::new(&format!("there is no scene {scene}")))
}

enum BroadPhase {
    RapiersOwn(DefaultBroadPhase),
    Unisize(Installed<UnisizeBroadPhase>),
}

/// A world on one broad phase.
#[wasm_bindgen]
pub struct Side {
    scene: Scene,
    broad_phase: BroadPhase,
    batches: Vec<Batch>,
}

#[wasm_bindgen]
impl Side {
    /// Builds the scene of this name, on unisize or on Rapier's own broad phase.
    ///
    /// # Errors
    ///
    /// If there is no such scene.
    #[wasm_bindgen(constructor)]
    pub fn new(with_unisize: bool, scene: &str, bodies: usize, seed: u32) -> Result<Side, JsError> {
        let scene = Scene::build(kind(scene)?, bodies, seed.into());
        let broad_phase = match with_unisize {
            true => BroadPhase::Unisize(install(UnisizeBroadPhase::new())),
            false => BroadPhase::RapiersOwn(DefaultBroadPhase::new()),
        };
        let batches = vec![];
        Ok(Self {
            scene,
            broad_phase,
            batches,
        })
    }

    /// Runs the script of the scene and advances the world by one time step. Returns the milliseconds of the broad phase.
    pub fn step(&mut self) -> f64 {
        let broad_phase = match &mut self.broad_phase {
            BroadPhase::RapiersOwn(own) => own.for_step(),
            BroadPhase::Unisize(unisize) => unisize.for_step(),
        };
        self.scene.step(broad_phase, &(), &());
        version::broad_phase_ms(&self.scene.world.pipeline.counters)
    }

    fn unisize(&self) -> Option<&UnisizeBroadPhase> {
        match &self.broad_phase {
            BroadPhase::RapiersOwn(_) => None,
            BroadPhase::Unisize(unisize) => Some(unisize),
        }
    }

    /// The number of bodies that are not fixed.
    pub fn bodies(&self) -> usize {
        let bodies = self.scene.world.bodies.iter();
        bodies.filter(|(_, body)| !body.is_fixed()).count()
    }

    /// The number of pairs in the narrow phase.
    pub fn pairs(&self) -> usize {
        let narrow_phase = &self.scene.world.narrow_phase;
        narrow_phase.contact_pairs().count() + narrow_phase.intersection_pairs().count()
    }

    /// The number of pairs with a contact that the solver receives.
    pub fn contacts(&self) -> usize {
        let pairs = self.scene.world.narrow_phase.contact_pairs();
        pairs.filter(|pair| version::is_touching(pair)).count()
    }

    /// The coordinates of all bodies.
    pub fn positions(&self) -> Vec<f32> {
        let bodies = self.scene.world.bodies.iter();
        let positions = bodies.map(|(_, body)| version::translation(body.position()));
        let coordinates = positions.flat_map(|place| (0..DIM).map(move |axis| place[axis]));
        coordinates.collect()
    }

    /// The mins and maxs of a box around all colliders of finite size, with three coordinates each.
    pub fn bounds(&self) -> Vec<f32> {
        let mut bounds = [f32::MAX, f32::MAX, f32::MAX, f32::MIN, f32::MIN, f32::MIN];
        for (_, collider) in self.scene.world.colliders.iter() {
            if collider.shape().as_halfspace().is_none() {
                let corners = drawing::corners(&collider.compute_aabb());
                for axis in 0..3 {
                    bounds[axis] = bounds[axis].min(corners[axis]);
                    bounds[axis + 3] = bounds[axis + 3].max(corners[axis + 3]);
                }
            }
        }
        bounds.to_vec()
    }

    /// Draws the world. Returns the number of batches, which have the bodies of one shape each.
    pub fn draw(&mut self) -> usize {
        drawing::draw(&self.scene.world, &mut self.batches);
        self.batches.len()
    }

    /// The shape of the bodies of a batch: `ball`, `cuboid`, `capsule`, `rock` (a fixed ball) or `wall` (a fixed cuboid).
    pub fn batch_shape(&self, batch: usize) -> String {
        self.batches[batch].shape.to_owned()
    }

    /// The length of the straight part of the capsules of a batch, in radii.
    pub fn batch_length(&self, batch: usize) -> f32 {
        self.batches[batch].length
    }

    /// Sixteen numbers for each body of a batch: the images of the three unit vectors, each with a zero, and the position with the brightness.
    pub fn batch_places(&self, batch: usize) -> Vec<f32> {
        self.batches[batch].places.clone()
    }

    /// The ends of the edges of the boxes of moving colliders.
    pub fn box_lines(&self) -> Vec<f32> {
        let world = &self.scene.world;
        let is_moving = |collider: &&Collider| {
            let parent = collider.parent();
            parent.is_some_and(|parent| !world.bodies[parent].is_fixed())
        };
        let colliders = world.colliders.iter().map(|(_, collider)| collider);
        let boxes = colliders.filter(is_moving).map(Collider::compute_aabb);
        boxes.flat_map(|aabb| drawing::edges(&aabb)).collect()
    }

    /// The ends of the edges of the boxes that unisize has searched by, which reach ahead of the motion. None on Rapier's own broad phase.
    pub fn fat_box_lines(&self) -> Vec<f32> {
        let unisize = self.unisize().into_iter();
        let boxes = unisize.flat_map(UnisizeBroadPhase::fat_boxes);
        let finite = boxes.filter(|aabb| aabb.extents()[0] < SLAB[0]);
        finite.flat_map(|aabb| drawing::edges(&aabb)).collect()
    }

    /// The numbers of full searches and of updates so far. Zeros on Rapier's own broad phase.
    pub fn searches(&self) -> Vec<f64> {
        let Some(unisize) = self.unisize() else {
            return vec![0.0; 2];
        };
        let stats = unisize.stats();
        [stats.full_searches, stats.updates].map(|count| count as f64).into()
    }

    /// The ends of a line for each pair of the narrow phase, of those with a contact or of those without.
    pub fn pair_lines(&self, touching: bool) -> Vec<f32> {
        let colliders = &self.scene.world.colliders;
        let pairs = self.scene.world.narrow_phase.contact_pairs();
        let pairs = pairs.filter(|pair| version::is_touching(pair) == touching);
        let pairs = pairs.map(|pair| [&colliders[pair.collider1], &colliders[pair.collider2]]);
        pairs.flat_map(drawing::ends).collect()
    }
}

/// Turns a panic into an exception with the text of the panic.
#[wasm_bindgen(start)]
pub fn report_panics() {
    std::panic::set_hook(Box::new(|panic| {
        wasm_bindgen::throw_str(&panic.to_string())
    }));
}
