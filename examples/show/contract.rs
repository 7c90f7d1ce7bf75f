//! What a world has to offer to be shown. The viewer (`examples/viewer`) shows the same worlds, live.

use super::Watched;
use super::scenes::World;
use unisize_pictures::{Camera, Drawing};

/// A world that is worth looking at.
pub(crate) trait Show {
    /// The name of the example.
    const NAME: &'static str;
    /// What happens, in one sentence.
    const ABOUT: &'static str;
    /// How many bodies there are unless it is said otherwise.
    const BODIES: usize;
    /// How many steps are simulated unless it is said otherwise.
    const STEPS: usize;
    /// How many of them there are to a frame of a film.
    const STEPS_PER_FRAME: usize;
    /// The step from which on it is filmed.
    const FILMED_FROM: usize = 0;
    /// Whether Rapier hears of pairs, so that bodies that touch push each other. If not, they are only counted.
    const CONTACTS: bool = true;
    /// How many colours an animation has.
    const COLORS: usize = 255;
    /// Which changes of a pixel an animation does without; see `Animation::tolerance`.
    const TOLERANCE: u8;

    /// The world before the first step, with about so many bodies.
    fn build(bodies: usize) -> Self;

    /// The world.
    fn world(&mut self) -> &mut World;

    /// What happens before a step, beside physics.
    fn prepare(&mut self, _step: usize, _broad_phase: &Watched) {}

    /// How many bodies move.
    fn bodies(&self) -> usize;

    /// Where it is best seen from.
    fn camera(&self) -> Camera;

    /// What is seen.
    fn draw(&self, drawing: &mut Drawing, broad_phase: &Watched);
}
