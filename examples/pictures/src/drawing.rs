//! A drawing, and how a picture is made of it.

use crate::band::{Band, NOTHING, covers};
use crate::camera::{Camera, Lens, Raster, View};
use crate::figure::Figure;
use crate::ground::Ground;
use crate::light::Light;
use crate::line::Line;
use crate::shape::{Ray, Shape};
use crate::{Color, Picture, PictureError, palette};
use glam::{Mat3, Quat, Vec3};
use rayon::prelude::*;

/// Samples along each side of a pixel.
const SAMPLES: usize = 3;

/// Rows of pixels that are made at once.
const ROWS: usize = 16;

/// A scene to be pictured: bodies in space, figures in the plane, lines on top of them, and a ground below.
///
/// Bodies in space are lit, and cast shadows. Figures in the plane have their colour as it is: they lie on the plane of the
/// first two axes, the later on top of the earlier, and are best seen with [`Camera::top_down`].
///
/// What is not finite or has no size is not drawn but [counted](Self::skipped).
#[derive(Clone, Debug)]
pub struct Drawing {
    bodies: Vec<Body>,
    lines: Vec<Line>,
    ground: Option<(f32, f32)>,
    /// The light of the upper and of the lower edge.
    background: [Vec3; 2],
    skipped: usize,
}

#[derive(Clone, Copy, Debug)]
struct Body {
    shape: Shape,
    /// How much light of each colour it reflects.
    color: Vec3,
    is_lit: bool,
}

impl Default for Drawing {
    fn default() -> Self {
        Self::new()
    }
}

impl Drawing {
    /// An empty drawing with a dark background.
    pub fn new() -> Self {
        Self {
            bodies: Vec::new(),
            lines: Vec::new(),
            ground: None,
            background: [palette::SKY, palette::HORIZON].map(Color::light),
            skipped: 0,
        }
    }

    /// Sets the colours of the background, at the upper and at the lower edge.
    pub fn background(&mut self, upper: Color, lower: Color) {
        self.background = [upper, lower].map(Color::light);
    }

    /// Adds a ground at this height with a grid of lines one unit of length apart. There is one ground at most.
    pub fn ground(&mut self, height: f32) {
        self.ground_with_grid(height, 1.0);
    }

    /// Adds a ground at this height with a grid of lines `pitch` apart.
    pub fn ground_with_grid(&mut self, height: f32, pitch: f32) {
        if height.is_finite() && pitch.is_finite() && pitch > 0.0 {
            self.ground = Some((height, pitch));
        } else {
            self.skipped += 1;
        }
    }

    /// Adds a sphere.
    pub fn sphere(&mut self, center: [f32; 3], radius: f32, color: Color) {
        let center = Vec3::from(center);
        self.add(Shape::Sphere { center, radius }, color, true);
    }

    /// Adds a capsule: all within `radius` of the line between two ends.
    pub fn capsule(&mut self, ends: [[f32; 3]; 2], radius: f32, color: Color) {
        let [start, end] = ends.map(Vec3::from);
        let half = start.distance(end) / 2.0;
        let shape = Shape::Capsule {
            center: start.midpoint(end),
            axis: (end - start).try_normalize().unwrap_or(Vec3::Y),
            half,
            radius,
        };
        self.add(shape, color, true);
    }

    /// Adds a box of these half extents, turned by a quaternion with the real part last.
    pub fn cuboid(&mut self, center: [f32; 3], half: [f32; 3], rotation: [f32; 4], color: Color) {
        let shape = Shape::Cuboid {
            center: Vec3::from(center),
            axes: Mat3::from_quat(Quat::from_array(rotation).normalize()),
            half: Vec3::from(half),
        };
        self.add(shape, color, true);
    }

    /// Adds a disc in the plane.
    pub fn disc(&mut self, center: [f32; 2], radius: f32, color: Color) {
        let shape = Shape::Disc {
            center: Vec3::new(center[0], center[1], 0.0),
            normal: Vec3::Z,
            radius,
        };
        self.add(shape, color, false);
    }

    /// Adds a rectangle of these half extents in the plane, turned by an angle in radians.
    pub fn rectangle(&mut self, center: [f32; 2], half: [f32; 2], angle: f32, color: Color) {
        let shape = Shape::Cuboid {
            center: Vec3::new(center[0], center[1], 0.0),
            axes: Mat3::from_rotation_z(angle),
            half: Vec3::new(half[0], half[1], 0.0),
        };
        self.add(shape, color, false);
    }

    /// Adds a line on top of all bodies, `width` pixels wide and of an opacity of 0 to 1. One that begins or ends behind
    /// the camera is not seen.
    pub fn line(&mut self, ends: [[f32; 3]; 2], width: f32, color: Color, opacity: f32) {
        let ends = ends.map(Vec3::from);
        if ends.iter().all(|end| end.is_finite()) && width > 0.0 && opacity > 0.0 {
            self.lines.push(Line {
                ends,
                width,
                color,
                opacity,
            });
        } else {
            self.skipped += 1;
        }
    }

    /// How many bodies, lines and grounds were left out because their numbers are not finite or not positive.
    pub fn skipped(&self) -> usize {
        self.skipped
    }

    /// The bodies, in the order in which they were added; those that were skipped are not among them.
    pub fn figures(&self) -> impl Iterator<Item = Figure> + '_ {
        self.bodies.iter().map(|body| Figure {
            solid: body.shape.into(),
            color: Color::from_light(body.color),
            is_lit: body.is_lit,
        })
    }

    /// The height of the ground and the distance between the lines of its grid, if there is one.
    pub fn ground_and_pitch(&self) -> Option<[f32; 2]> {
        self.ground.map(Into::into)
    }

    /// The colours of the background, at the upper and at the lower edge.
    pub fn background_colors(&self) -> [Color; 2] {
        self.background.map(Color::from_light)
    }

    fn add(&mut self, shape: Shape, color: Color, is_lit: bool) {
        if shape.is_sound() {
            self.bodies.push(Body {
                shape,
                color: color.light(),
                is_lit,
            });
        } else {
            self.skipped += 1;
        }
    }

    /// Makes a picture of this width and height in pixels. **O(bodies + samples covered)**.
    ///
    /// # Errors
    /// [`PictureError::Size`] unless both are 1 to [`Picture::MAX_SIDE`].
    pub fn picture(&self, camera: &Camera, size: [usize; 2]) -> Result<Picture, PictureError> {
        let mut picture = Picture::new(size)?;
        let view = camera.view();
        let [width, height] = size.map(|side| side * SAMPLES);
        let raster = Raster {
            lens: view.lens,
            width,
            height,
        };
        let shapes: Vec<_> = self
            .bodies
            .par_iter()
            .map(|body| {
                let shape = body.shape;
                shape.moved(|point| view.point(point), |way| view.direction(way))
            })
            .collect();
        let scene = Scene {
            drawing: self,
            shapes: &shapes,
            view,
            raster,
            light: self.light(camera, size),
            ground: self
                .ground
                .map(|(height, pitch)| Ground::new(height, pitch, camera)),
        };
        let bands = covers(&raster, &shapes, ROWS * SAMPLES);
        picture
            .pixels
            .par_chunks_mut(size[0] * ROWS)
            .zip(bands)
            .enumerate()
            .for_each(|(band, (pixels, covers))| {
                let first_row = band * ROWS * SAMPLES;
                let rows = first_row..(first_row + ROWS * SAMPLES).min(height);
                let samples = Band::see(&raster, &shapes, &covers, rows);
                scene.shade(&samples, first_row, pixels);
            });

        let raster = Raster {
            lens: view.lens,
            width: size[0],
            height: size[1],
        };
        for line in &self.lines {
            let [Some(start), Some(end)] = line.ends.map(|end| raster.place(view.point(end)))
            else {
                continue;
            };
            line.draw([start, end], &mut picture);
        }
        Ok(picture)
    }

    /// The light, if any body is lit.
    fn light(&self, camera: &Camera, size: [usize; 2]) -> Option<Light> {
        let lit: Vec<_> = self
            .bodies
            .iter()
            .filter(|body| body.is_lit)
            .map(|body| body.shape)
            .collect();
        let is_of_use = self.ground.is_some() || !lit.is_empty();
        is_of_use.then(|| Light::new(&lit, camera.target(), camera.reach(), size))
    }
}

/// A drawing as a camera sees it.
struct Scene<'a> {
    drawing: &'a Drawing,
    shapes: &'a [Shape],
    view: View,
    raster: Raster,
    light: Option<Light>,
    ground: Option<Ground>,
}

impl Scene<'_> {
    /// Turns the samples of a band into pixels, the means of their light.
    fn shade(&self, samples: &Band, first_row: usize, pixels: &mut [Vec3]) {
        let width = self.raster.width;
        for (index, (&depth, &body)) in samples.depths.iter().zip(&samples.bodies).enumerate() {
            let (row, column) = (index / width, index % width);
            let place = [column as f32 + 0.5, (first_row + row) as f32 + 0.5];
            let pixel = row / SAMPLES * (width / SAMPLES) + column / SAMPLES;
            pixels[pixel] += self.sample(place, depth, body) / (SAMPLES * SAMPLES) as f32;
        }
    }

    /// The light that comes from a sample.
    fn sample(&self, place: [f32; 2], depth: f32, body: u32) -> Vec3 {
        let ray = self.raster.ray(place[0], place[1]);
        let behind = if body == NOTHING {
            self.background(place[1])
        } else {
            self.body_light(&ray, body as usize)
        };
        match self.ground_light(&ray) {
            Some((ground_depth, light, opacity)) if ground_depth < depth => {
                behind.lerp(light, opacity)
            }
            _ => behind,
        }
    }

    fn background(&self, row: f32) -> Vec3 {
        let [upper, lower] = self.drawing.background;
        upper.lerp(lower, row / self.raster.height as f32)
    }

    fn body_light(&self, ray: &Ray, index: usize) -> Vec3 {
        let body = &self.drawing.bodies[index];
        match (&self.light, self.shapes[index].hit(ray)) {
            (Some(light), Some(hit)) if body.is_lit => {
                let point = self.view.world_point(ray.at(hit.depth));
                body.color * light.at(point, self.view.world_direction(hit.normal))
            }
            _ => body.color,
        }
    }

    /// Depth, light and opacity of the ground, where it is seen.
    fn ground_light(&self, ray: &Ray) -> Option<(f32, Vec3, f32)> {
        let ray = Ray {
            origin: self.view.world_point(ray.origin),
            direction: self.view.world_direction(ray.direction),
        };
        let footprint = match self.raster.lens {
            Lens::Perspective(slope) => 2.0 * slope / self.raster.height as f32,
            Lens::Parallel(_) => 0.0,
        };
        let patch = self.ground.as_ref()?.patch(&ray, footprint)?;
        let light = self.light.as_ref()?.at(patch.point, Vec3::Y);
        Some((patch.depth, patch.color * light, patch.opacity))
    }
}
