//! Scenes in WebAssembly: worlds on Rapier's own broad phase or on unisize, which a page steps, clocks and draws.
//!
//! A [`Side`] is one world. The page makes two that differ in the broad phase alone. `engine` is one source, compiled once for each
//! of the four flavours of Rapier; [`World`] hides which it is. Each version is a feature, so that a page need not load both. What is drawn
//! leaves as a [`Drawing`]: arrays of numbers that a graphics card takes as they are.

#[cfg(feature = "check")]
mod check;
mod drawing;
#[cfg(feature = "check")]
#[path = "../../../tests/golden/hash.rs"]
mod hash;

#[cfg(feature = "check")]
pub use check::{first_difference, golden, scenes};

use drawing::Drawing;
use unisize_scenes::SceneKind;
use wasm_bindgen::prelude::*;

/// A flavour of Rapier, if its version is on.
macro_rules! engine {
    ($name:ident, $scenes:ident, $rapier:ident, $feature:literal, $version:literal) => {
        #[cfg(feature = $feature)]
        #[path = "engine"]
        mod $name {
            use unisize::$rapier::UnisizeBroadPhase;
            use unisize_scenes::$scenes as scenes;
            use $rapier as rapier;

            #[cfg(feature = "check")]
            pub(crate) mod check;
            #[path = $version]
            mod version;
            pub(crate) mod world;
        }
    };
}

engine! { dim2_027, dim2, rapier2d_027, "rapier-027", "rapier_027.rs" }
engine! { dim3_027, dim3, rapier3d_027, "rapier-027", "rapier_027.rs" }
engine! { dim2_036, dim2_036, rapier2d_036, "rapier-036", "rapier_036.rs" }
engine! { dim3_036, dim3_036, rapier3d_036, "rapier-036", "rapier_036.rs" }

/// A function of the engine of this name, `rapier2d-027` or another; returns a sentence if there is none.
macro_rules! for_engine {
    ($engine:expr, $module:ident :: $item:ident) => {
        match $engine {
            #[cfg(feature = "rapier-027")]
            "rapier2d-027" => crate::dim2_027::$module::$item,
            #[cfg(feature = "rapier-027")]
            "rapier3d-027" => crate::dim3_027::$module::$item,
            #[cfg(feature = "rapier-036")]
            "rapier2d-036" => crate::dim2_036::$module::$item,
            #[cfg(feature = "rapier-036")]
            "rapier3d-036" => crate::dim3_036::$module::$item,
            other => return Err(JsError::new(&format!("there is no engine {other}"))),
        }
    };
}
#[cfg(feature = "check")]
use for_engine;

/// The scene of this name.
fn kind(scene: &str) -> Result<SceneKind, JsError> {
    SceneKind::from_name(scene).ok_or_else(|| JsError::new(&format!("there is no scene {scene}")))
}

/// A scene on one broad phase, whichever Rapier it is of. [`Side`] says what is returned.
trait World {
    fn step(&mut self) -> f64;
    fn body_count(&self) -> usize;
    fn pair_count(&self) -> usize;
    fn contact_count(&self) -> usize;
    fn positions(&self) -> Vec<f32>;
    fn bounds(&self) -> [f32; 6];
    fn draw(&self, drawing: &mut Drawing);
    fn box_lines(&self) -> Vec<f32>;
    fn fat_box_lines(&self) -> Vec<f32>;
    fn searches(&self) -> [f64; 3];
    fn pair_lines(&self, touching: bool) -> Vec<f32>;
}

/// A world on one broad phase.
#[wasm_bindgen]
pub struct Side {
    world: Box<dyn World>,
    drawing: Drawing,
}

#[wasm_bindgen]
impl Side {
    /// Builds the scene of this name on `rapier2d-027` or another engine, with unisize or with Rapier's own broad phase.
    ///
    /// # Errors
    ///
    /// A sentence if there is no such engine or scene.
    #[wasm_bindgen(constructor)]
    pub fn new(
        engine: &str,
        with_unisize: bool,
        scene: &str,
        bodies: usize,
        seed: u32,
    ) -> Result<Side, JsError> {
        let build = for_engine!(engine, world::build);
        Ok(Self {
            world: build(kind(scene)?, bodies, seed.into(), with_unisize),
            drawing: Drawing::default(),
        })
    }

    /// Runs the script of the scene and advances the world by one time step. Returns the milliseconds of the broad phase.
    pub fn step(&mut self) -> f64 {
        self.world.step()
    }

    /// The number of bodies that are not fixed.
    pub fn bodies(&self) -> usize {
        self.world.body_count()
    }

    /// The number of pairs that the narrow phase looks at in each step.
    pub fn pairs(&self) -> usize {
        self.world.pair_count()
    }

    /// The number of pairs with a contact that the solver sees.
    pub fn contacts(&self) -> usize {
        self.world.contact_count()
    }

    /// The coordinates of all bodies, one after the other.
    pub fn positions(&self) -> Vec<f32> {
        self.world.positions()
    }

    /// The corners of the box around everything whose size is finite, the lower one first, each with three coordinates.
    pub fn bounds(&self) -> Vec<f32> {
        self.world.bounds().to_vec()
    }

    /// Draws the world as it is now. Returns the number of batches.
    pub fn draw(&mut self) -> usize {
        self.drawing.clear();
        self.world.draw(&mut self.drawing);
        self.drawing.batches.len()
    }

    /// What the bodies of a batch are: `ball`, `cuboid`, `capsule`, `rock`, which is a fixed ball, or `wall`.
    pub fn batch_shape(&self, batch: usize) -> String {
        self.drawing.batches[batch].shape.name().to_owned()
    }

    /// How long the straight part of the capsules of a batch is, in radii.
    pub fn batch_length(&self, batch: usize) -> f32 {
        self.drawing.batches[batch].shape.length()
    }

    /// Sixteen numbers for each body of a batch: the images of the three unit vectors, each and a zero, and where it is, with its
    /// brightness.
    pub fn batch_places(&self, batch: usize) -> Vec<f32> {
        self.drawing.batches[batch].places.clone()
    }

    /// The ends of the edges of the boxes of the colliders that move.
    pub fn box_lines(&self) -> Vec<f32> {
        self.world.box_lines()
    }

    /// The ends of the edges of the boxes that unisize has searched by, drawn ahead of the motion of the colliders; none on the other side.
    pub fn fat_box_lines(&self) -> Vec<f32> {
        self.world.fat_box_lines()
    }

    /// How unisize searches: how many moves ahead its boxes reach, the searches for all pairs so far, and the updates so far; zeros on the
    /// other side.
    pub fn searches(&self) -> Vec<f64> {
        self.world.searches().to_vec()
    }

    /// The ends of a line for each pair of the narrow phase: pairs without contact, or those with one.
    pub fn pair_lines(&self, touching: bool) -> Vec<f32> {
        self.world.pair_lines(touching)
    }
}

/// Makes a panic an exception with the text of the panic, instead of one without.
#[wasm_bindgen(start)]
pub fn report_panics() {
    std::panic::set_hook(Box::new(|panic| {
        wasm_bindgen::throw_str(&panic.to_string())
    }));
}
