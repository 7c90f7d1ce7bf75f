//! The ground: a plane with a grid that fades into the background.

use crate::shape::Ray;
use crate::{Camera, Color, palette};
use glam::Vec3;

/// The width of a line of the grid, as a share of the distance between lines.
const LINE: f32 = 0.02;

/// A horizontal plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ground {
    height: f32,
    /// The distance between lines of the grid.
    pitch: f32,
    /// The point around which it is seen, and how far away it has faded.
    middle: Vec3,
    reach: f32,
    /// Of the plane, and of the lines.
    colors: [Vec3; 2],
}

/// The ground as seen in a sample.
pub(crate) struct Patch {
    pub(crate) depth: f32,
    pub(crate) point: Vec3,
    /// Its colour in full light.
    pub(crate) color: Vec3,
    /// 1 in the middle, 0 where it has faded.
    pub(crate) opacity: f32,
}

impl Ground {
    /// A ground at this height, with lines this far apart.
    pub(crate) fn new([height, pitch]: [f32; 2], camera: &Camera) -> Self {
        Self {
            height,
            pitch,
            middle: camera.target().with_y(height),
            reach: 2.2 * camera.reach(),
            colors: [palette::GROUND, palette::GRID].map(Color::light),
        }
    }

    /// The part that a ray in the world sees; `footprint` is the width of a sample at depth 1.
    pub(crate) fn patch(&self, ray: &Ray, footprint: f32) -> Option<Patch> {
        let depth = (self.height - ray.origin.y) / ray.direction.y;
        // From above only, and not behind the camera. NaN is neither.
        if !(ray.direction.y < 0.0 && depth > 0.0) {
            return None;
        }
        let point = ray.at(depth);
        let away = point.distance(self.middle) / self.reach;
        let opacity = smooth(1.0 - away);
        if opacity <= 0.0 {
            return None;
        }
        // Seen at a grazing angle, a sample is long.
        let width = footprint * depth * ray.direction.length() / -ray.direction.y;
        let line = [point.x, point.z].map(|place| {
            let from_line = (place / self.pitch - (place / self.pitch).round()).abs() * self.pitch;
            let half = self.pitch * LINE / 2.0;
            let blurred = half.max(width / 2.0);
            smooth(1.0 + (half - from_line) / blurred) * (half / blurred)
        });
        let [plane, grid] = self.colors;
        let color = plane.lerp(grid, line[0].max(line[1]));
        Some(Patch {
            depth,
            point,
            color,
            opacity,
        })
    }
}

/// 0 below 0, 1 above 1, and smooth between.
fn smooth(share: f32) -> f32 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
