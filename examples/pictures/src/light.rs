//! The sun, with the shadows that it casts, and the light of the sky.

use crate::band::{Band, covers};
use crate::camera::{Lens, Raster, View};
use crate::shape::Shape;
use glam::Vec3;
use rayon::prelude::*;

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
    /// Light with the shadows of these bodies within `reach` of a point, for a picture of this size.
    pub(crate) fn new(bodies: &[Shape], middle: Vec3, reach: f32, size: [usize; 2]) -> Self {
        let side = (SIDE * size[0].max(size[1])).clamp(SIDES[0], SIDES[1]);
        let view = View::new(middle, -SUN.normalize(), Lens::Parallel(reach));
        let raster = Raster {
            lens: view.lens,
            width: side,
            height: side,
        };
        let shapes: Vec<_> = bodies
            .par_iter()
            .map(|body| body.moved(|point| view.point(point), |way| view.direction(way)))
            .collect();
        let bands = covers(&raster, &shapes, ROWS);
        let depths = bands
            .par_iter()
            .enumerate()
            .flat_map_iter(|(band, covers)| {
                let rows = band * ROWS..((band + 1) * ROWS).min(side);
                Band::see(&raster, &shapes, covers, rows).depths
            })
            .collect();
        Self {
            view,
            raster,
            depths,
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
        // Most places are all in the light or all in the shadow.
        let corners = [
            [0, 0],
            [-BLUR, -BLUR],
            [-BLUR, BLUR],
            [BLUR, -BLUR],
            [BLUR, BLUR],
        ];
        match corners
            .into_iter()
            .filter(|&corner| is_dark(corner))
            .count()
        {
            0 => return 1.0,
            5 => return 0.0,
            _ => {}
        }
        let window = (-BLUR..=BLUR).flat_map(|down| (-BLUR..=BLUR).map(move |right| [right, down]));
        let dark = window.filter(|&place| is_dark(place)).count();
        1.0 - dark as f32 / (2 * BLUR + 1).pow(2) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::Light;
    use crate::shape::Shape;
    use glam::Vec3;

    #[test]
    fn a_body_casts_a_shadow_away_from_the_sun() {
        let ball = Shape::Sphere {
            center: Vec3::new(0.0, 2.0, 0.0),
            radius: 0.5,
        };
        let light = Light::new(&[ball], Vec3::ZERO, 5.0, [640, 360]);
        let ground = |x: f32, z: f32| light.at(Vec3::new(x, 0.0, z), Vec3::Y).y;
        let shadow = ground(0.9, -0.93);
        let lit = ground(-0.9, 0.93);
        assert!(shadow < 0.6 * lit, "{shadow} {lit}");
        assert_eq!(ground(30.0, 30.0), lit, "outside of what the sun sees");
        assert!(light.at(Vec3::ZERO, -Vec3::Y).y < shadow, "below");
    }
}
