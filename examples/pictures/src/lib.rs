//! Pictures of spheres, capsules and boxes, without a window: PNG files and looping GIFs for documentation.
//!
//! A [`Drawing`] of bodies, seen from a [`Camera`], becomes a [`Picture`], which is saved or added to an [`Animation`].
//! Everything is given as plain numbers; the crate knows no engine.
//!
//! ```
//! use unisize_pictures::{Animation, Camera, Drawing, Legend, palette};
//!
//! let camera = Camera::orbit([0.0, 0.5, 0.0], 6.0).turned(0.7).raised(0.4);
//! let mut animation = Animation::new(255, 6);
//! for step in 0..3 {
//!     let height = 2.0 - 0.4 * step as f32;
//!     let mut drawing = Drawing::new();
//!     drawing.ground(0.0);
//!     drawing.sphere([-1.0, height, 0.0], 0.5, palette::by_index(0));
//!     drawing.capsule([[0.5, 0.3, 0.0], [1.5, 0.3, 0.0]], 0.3, palette::by_index(1));
//!     drawing.cuboid([0.0, 0.4, 1.5], [0.4; 3], [0.0, 0.0, 0.0, 1.0], palette::by_index(2));
//!
//!     let mut picture = drawing.picture(&camera, [160, 90])?;
//!     picture.legend(&Legend::new("unisize").fact("bodies", 3));
//!     animation.push(&picture)?;
//! }
//! let mut gif = Vec::new();
//! animation.write_gif_to(&mut gif)?;
//! assert!(gif.starts_with(b"GIF89a"));
//! # Ok::<(), anyhow::Error>(())
//! ```
//!
//! Each body is intersected exactly with the rays through the samples of the rectangle that it may cover. Every sample has
//! a depth, so bodies may pierce each other in any way. Shadows come from the same method, seen from the sun. Bodies that
//! are not finite, or that have no size, are not drawn.

mod animation;
mod camera;
mod color;
mod drawing;
mod ground;
mod light;
pub mod palette;
mod picture;
mod raster;
mod shape;

pub use animation::Animation;
pub use camera::{Camera, Sight};
pub use color::Color;
pub use drawing::Drawing;
pub use picture::{Legend, Picture, thousands};
pub use shape::{Figure, Solid};
