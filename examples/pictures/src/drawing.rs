//! A drawing, and how a picture is made of it.

use crate::camera::Camera;
use crate::ground::Ground;
use crate::light::Light;
use crate::raster::{Lens, Raster, View};
use crate::shape::{Figure, Ray, Shape, Solid};
use crate::{Color, Picture, palette};
use anyhow::Result;
use glam::{Mat3, Quat, Vec3};

/// Samples along each side of a pixel.
const SAMPLES: usize = 3;

/// Rows of pixels that are made at once.
const ROWS: usize = 16;

/// A scene to be pictured: bodies in space, figures in the plane, and a ground below.
///
/// Bodies in space are lit, and cast shadows. Figures in the plane have their colour as it is: they lie on the plane of the
/// first two axes, the later on top of the earlier, and are best seen with [`Camera::top_down`].
#[derive(Clone, Debug)]
pub struct Drawing {
    figures: Vec<Figure>,
    /// Its height, and the distance between the lines of its grid.
    ground: Option<[f32; 2]>,
    /// Of the upper and of the lower edge.
    background: [Color; 2],
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
            figures: Vec::new(),
            ground: None,
            background: [palette::SKY, palette::HORIZON],
        }
    }

    /// Sets the colours of the background, at the upper and at the lower edge.
    pub fn background(&mut self, upper: Color, lower: Color) {
        self.background = [upper, lower];
    }

    /// Adds a ground at this height with a grid of lines one unit of length apart. There is one ground at most.
    pub fn ground(&mut self, height: f32) {
        self.ground = Some([height, 1.0]);
    }

    /// Adds a sphere.
    pub fn sphere(&mut self, center: [f32; 3], radius: f32, color: Color) {
        self.add(Solid::Sphere { center, radius }, color, true);
    }

    /// Adds a capsule: all within `radius` of the line between two ends.
    pub fn capsule(&mut self, ends: [[f32; 3]; 2], radius: f32, color: Color) {
        self.add(Solid::Capsule { ends, radius }, color, true);
    }

    /// Adds a box of these half extents, turned by a quaternion with the real part last.
    pub fn cuboid(&mut self, center: [f32; 3], half: [f32; 3], rotation: [f32; 4], color: Color) {
        let axes = Mat3::from_quat(Quat::from_array(rotation).normalize());
        let half_edges = [0, 1, 2].map(|axis| (axes.col(axis) * half[axis]).into());
        self.add(Solid::Cuboid { center, half_edges }, color, true);
    }

    /// Adds a disc in the plane.
    pub fn disc(&mut self, center: [f32; 2], radius: f32, color: Color) {
        self.add(Solid::Disc { center, radius }, color, false);
    }

    /// Adds a rectangle of these half extents in the plane, turned by an angle in radians.
    pub fn rectangle(&mut self, [x, y]: [f32; 2], half: [f32; 2], angle: f32, color: Color) {
        let (sine, cosine) = angle.sin_cos();
        let solid = Solid::Cuboid {
            center: [x, y, 0.0],
            half_edges: [
                [half[0] * cosine, half[0] * sine, 0.0],
                [-half[1] * sine, half[1] * cosine, 0.0],
                [0.0; 3],
            ],
        };
        self.add(solid, color, false);
    }

    fn add(&mut self, solid: Solid, color: Color, is_lit: bool) {
        self.figures.push(Figure {
            solid,
            color,
            is_lit,
        });
    }

    /// The bodies, in the order in which they were added.
    pub fn figures(&self) -> impl Iterator<Item = Figure> + '_ {
        self.figures.iter().copied()
    }

    /// The height of the ground and the distance between the lines of its grid, if there is one.
    pub fn ground_and_pitch(&self) -> Option<[f32; 2]> {
        self.ground
    }

    /// The colours of the background, at the upper and at the lower edge.
    pub fn background_colors(&self) -> [Color; 2] {
        self.background
    }

    /// Makes a picture of this width and height in pixels. **O(bodies + samples covered)**.
    ///
    /// # Errors
    /// If there can be no picture of this size.
    pub fn picture(&self, camera: &Camera, size: [usize; 2]) -> Result<Picture> {
        Picture::check_size(size)?;
        let view = camera.view();
        let seen = self.figures.iter().filter_map(|figure| {
            let shape = Shape::seen(figure, &view)?;
            Some((shape, figure.color.light()))
        });
        let (shapes, colors) = seen.unzip();
        let lit = || self.figures.iter().filter(|figure| figure.is_lit);
        let is_lit = self.ground.is_some() || lit().next().is_some();
        let scene = Scene {
            colors,
            view,
            raster: Raster {
                lens: view.lens,
                width: size[0] * SAMPLES,
                height: size[1] * SAMPLES,
            },
            background: self.background.map(Color::light),
            light: is_lit.then(|| Light::new(lit(), camera, size)),
            ground: self.ground.map(|ground| Ground::new(ground, camera)),
            shapes,
        };
        let pixels = scene
            .raster
            .see(&scene.shapes, ROWS * SAMPLES, |first, samples| {
                scene.shade(first, samples)
            });
        Ok(Picture::new(size, pixels.concat()))
    }
}

/// A drawing as a camera sees it.
struct Scene {
    shapes: Vec<Shape>,
    /// How much light of each colour each shape reflects.
    colors: Vec<Vec3>,
    view: View,
    raster: Raster,
    background: [Vec3; 2],
    light: Option<Light>,
    ground: Option<Ground>,
}

impl Scene {
    /// Turns the samples of a band into pixels, the means of their light.
    fn shade(&self, first_row: usize, samples: &[(f32, Option<u32>)]) -> Vec<Vec3> {
        let width = self.raster.width;
        let mut pixels = vec![Vec3::ZERO; samples.len() / (SAMPLES * SAMPLES)];
        for (index, &(depth, body)) in samples.iter().enumerate() {
            let (row, column) = (index / width, index % width);
            let place = [column as f32 + 0.5, (first_row + row) as f32 + 0.5];
            let pixel = row / SAMPLES * (width / SAMPLES) + column / SAMPLES;
            pixels[pixel] += self.sample(place, depth, body) / (SAMPLES * SAMPLES) as f32;
        }
        pixels
    }

    /// The light that comes from a sample.
    fn sample(&self, place: [f32; 2], depth: f32, body: Option<u32>) -> Vec3 {
        let ray = self.raster.ray(place[0], place[1]);
        let [upper, lower] = self.background;
        let behind = match body {
            None => upper.lerp(lower, place[1] / self.raster.height as f32),
            Some(body) => self.body_light(&ray, body as usize),
        };
        match self.ground_light(&ray) {
            Some((ground_depth, light, opacity)) if ground_depth < depth => {
                behind.lerp(light, opacity)
            }
            _ => behind,
        }
    }

    fn body_light(&self, ray: &Ray, body: usize) -> Vec3 {
        let shape = &self.shapes[body];
        match (&self.light, shape.hit(ray)) {
            (Some(light), Some((depth, normal))) if !shape.is_flat => {
                let point = self.view.world_point(ray.at(depth));
                self.colors[body] * light.at(point, self.view.world_direction(normal))
            }
            _ => self.colors[body],
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
