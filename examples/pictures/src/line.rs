//! Lines on top of a picture.

use crate::{Color, Picture};
use glam::{Vec2, Vec3};

/// A line in the world.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub(crate) ends: [Vec3; 2],
    /// In pixels.
    pub(crate) width: f32,
    pub(crate) color: Color,
    pub(crate) opacity: f32,
}

impl Line {
    /// Draws it between two places of the picture.
    pub(crate) fn draw(&self, ends: [[f32; 2]; 2], picture: &mut Picture) {
        let [start, end] = ends.map(Vec2::from);
        let way = end - start;
        let reach = self.width / 2.0 + 0.5;
        let (lo, hi) = (start.min(end) - reach, start.max(end) + reach);
        let [width, height] = picture.size().map(|side| side as f32);
        // Conversions saturate, so nothing is drawn far outside.
        let rows = lo.y.clamp(0.0, height) as usize..hi.y.ceil().clamp(0.0, height) as usize;
        let columns = lo.x.clamp(0.0, width) as usize..hi.x.ceil().clamp(0.0, width) as usize;
        for row in rows {
            for column in columns.clone() {
                let place = Vec2::new(column as f32 + 0.5, row as f32 + 0.5) - start;
                let share = (place.dot(way) / way.length_squared())
                    .max(0.0)
                    .clamp(0.0, 1.0);
                let coverage = (reach - (place - way * share).length()).clamp(0.0, 1.0);
                // Thinner than a pixel is fainter.
                let coverage = coverage * self.width.min(1.0);
                picture.blend(column, row, self.color, coverage * self.opacity);
            }
        }
    }
}
