//! A world that is worth looking at: what the examples film. One source for both dimensions.

use super::scenes::World;
use super::scenes::rapier::prelude::ColliderPair;
use unisize_pictures::{Camera, Drawing};

/// A broad phase that knows which pairs it holds.
pub(crate) trait HeldPairs {
    /// The pairs, in the same order in every run.
    fn pairs(&self) -> Vec<ColliderPair>;
}

/// A world that is worth looking at.
pub(crate) trait Show {
    /// The name of the example.
    const NAME: &'static str;
    /// A sentence for the help text.
    const ABOUT: &'static str;
    /// The default number of bodies.
    const BODIES: usize;
    /// The default number of steps.
    const STEPS: usize;
    /// Steps per frame of a film.
    const STEPS_PER_FRAME: usize;
    /// The step at which filming begins.
    const FILMED_FROM: usize = 0;
    /// Whether pairs are reported to Rapier, so that bodies push each other. If not, they are only counted.
    const CONTACTS: bool = true;
    /// The number of colours of an animation.
    const COLORS: usize = 255;
    /// Changes of a pixel that an animation leaves out; see `Animation::tolerance`.
    const TOLERANCE: u8;

    /// The world before the first step, with about this many bodies.
    fn build(bodies: usize) -> Self;

    /// The world.
    fn world(&mut self) -> &mut World;

    /// Called before each step: whatever happens besides physics.
    fn prepare(&mut self, _step: usize, _broad_phase: &dyn HeldPairs) {}

    /// The number of bodies that move.
    fn bodies(&self) -> usize;

    /// The best view of it.
    fn camera(&self) -> Camera;

    /// Draws the world.
    fn draw(&self, drawing: &mut Drawing, broad_phase: &dyn HeldPairs);
}
