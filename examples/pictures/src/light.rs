//! The sun, with the shadows that it casts, and the light of the sky.

use crate::Camera;
use crate::raster::{Lens, Raster, View};
use crate::shape::{Figure, Shape};
use glam::Vec3;

/// Samples of the sun's view, in width and height, per pixel of the longer side of the picture,
const SIDE: usize = 2;

/// and the least and the most of them.
const SIDES: [usize; 2] = [256, 2048];

/// Rows of it that are made at once.
const ROWS: usize = 64;

/// Shadows are blurred over this many samples to each side.
const BLUR: isize = 2;

/// Towards the sun: over the left shoulder of a camera that is a little turned.
const SUN: Vec3 = Vec3::new(-0.38, 0.84, 0.39);

/// The light of the sun, of the sky above and of the ground below.
const SUNLIGHT: Vec3 = Vec3::new(0.86, 0.82, 0.74);
const SKYLIGHT: Vec3 = Vec3::new(0.36, 0.39, 0.44);
const BOUNCED: Vec3 = Vec3::new(0.16, 0.16, 0.17);

/// The light in a scene.
pub(crate) struct Light {
    view: View,
    raster: Raster,
    /// How far from the sun the first body is, for each sample.
    depths: Vec<f32>,
    /// The width of a sample in units of length.
    pitch: f32,
}

impl Light {
    /// Light with the shadows of these bodies, for a picture of this size.
    pub(crate) fn new<'a>(
        bodies: impl Iterator<Item = &'a Figure>,
        camera: &Camera,
        size: [usize; 2],
    ) -> Self {
        let side = (SIDE * size[0].max(size[1])).clamp(SIDES[0], SIDES[1]);
        let reach = camera.reach();
        let view = View::new(camera.target(), -SUN.normalize(), Lens::Parallel(reach));
        let raster = Raster {
            lens: view.lens,
            width: side,
            height: side,
        };
        let shapes: Vec<_> = bodies.filter_map(|body| Shape::seen(body, &view)).collect();
        let depths = raster.see(&shapes, ROWS, |_, samples| {
            samples.iter().map(|&(depth, _)| depth).collect::<Vec<_>>()
        });
        Self {
            view,
            raster,
            depths: depths.concat(),
            pitch: 2.0 * reach / side as f32,
        }
    }

    /// The light that falls on a surface with this unit normal.
    pub(crate) fn at(&self, point: Vec3, normal: Vec3) -> Vec3 {
        let sky = BOUNCED.lerp(SKYLIGHT, 0.5 + 0.5 * normal.y);
        let facing = normal.dot(SUN) / SUN.length();
        if facing <= 0.0 {
            return sky;
        }
        sky + SUNLIGHT * (facing * self.sunlit_share(point, normal))
    }

    /// How much of the sun a point sees, 0 to 1.
    fn sunlit_share(&self, point: Vec3, normal: Vec3) -> f32 {
        // A step away from the surface, which would otherwise shadow itself.
        let blur = (BLUR as f32 + 0.5) * self.pitch;
        let seen = self.view.point(point + normal * (1.5 * blur));
        let Some([x, y]) = self.raster.place(seen) else {
            return 1.0;
        };
        let (x, y) = (x.floor() as isize, y.floor() as isize);
        let side = self.raster.width;
        let inside = 0..side as isize;
        let is_dark = |[right, down]: [isize; 2]| {
            let (column, row) = (x.saturating_add(right), y.saturating_add(down));
            inside.contains(&row)
                && inside.contains(&column)
                && self.depths[row as usize * side + column as usize] < seen.z - 0.5 * blur
        };
        let window = (-BLUR..=BLUR).flat_map(|down| (-BLUR..=BLUR).map(move |right| [right, down]));
        let dark = window.filter(|&place| is_dark(place)).count();
        1.0 - dark as f32 / (2 * BLUR + 1).pow(2) as f32
    }
}
