//! Boxes that are hard for one method or another, without an engine. The laboratory includes them as well.

#[macro_use]
mod named;

mod aimed;
mod hard_boxes;
mod mixture;
mod needles;
pub(crate) mod random;
mod worst_mixtures;

pub use aimed::Aimed;
pub use hard_boxes::HardBoxes;
pub use mixture::Mixture;
pub use needles::Needles;
