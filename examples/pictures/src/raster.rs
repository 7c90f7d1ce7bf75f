//! A view of bodies as samples: which body is seen where, and how deep.
//!
//! Pictures are made band by band, so that threads can share the work and the samples of a large picture need not be in
//! memory at once.

use crate::shape::{Ray, Shape};
use glam::Vec3;
use rayon::prelude::*;
use std::ops::Range;

/// How wide a view is: half the height of what it shows, for each unit of depth or at any depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Lens {
    Perspective(f32),
    Parallel(f32),
}

/// The near plane of a perspective view.
const NEAR: f32 = 1e-3;

/// A point to see from, with the axes of what is seen: right, up, and into the depth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    origin: Vec3,
    axes: [Vec3; 3],
    pub(crate) lens: Lens,
}

impl View {
    /// A view along `forward`, a unit vector.
    pub(crate) fn new(origin: Vec3, forward: Vec3, lens: Lens) -> Self {
        // Looking straight down, any horizontal axis will do.
        let right = forward.cross(Vec3::Y).try_normalize().unwrap_or(Vec3::X);
        Self {
            origin,
            axes: [right, right.cross(forward), forward],
            lens,
        }
    }

    /// A point of the world in the coordinates of the view.
    pub(crate) fn point(&self, point: Vec3) -> Vec3 {
        self.direction(point - self.origin)
    }

    /// A direction of the world in the coordinates of the view.
    pub(crate) fn direction(&self, direction: Vec3) -> Vec3 {
        Vec3::from(self.axes.map(|axis| axis.dot(direction)))
    }

    /// A direction in the coordinates of the view, in those of the world.
    pub(crate) fn world_direction(&self, direction: Vec3) -> Vec3 {
        let [right, up, forward] = self.axes;
        right * direction.x + up * direction.y + forward * direction.z
    }

    /// A point in the coordinates of the view, in those of the world.
    pub(crate) fn world_point(&self, point: Vec3) -> Vec3 {
        self.origin + self.world_direction(point)
    }
}

/// A view with a raster of samples.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Raster {
    pub(crate) lens: Lens,
    pub(crate) width: usize,
    pub(crate) height: usize,
}

impl Raster {
    /// The ray through a place on the raster; samples are at halves.
    #[inline]
    pub(crate) fn ray(&self, x: f32, y: f32) -> Ray {
        let half = self.height as f32 / 2.0;
        let place = Vec3::new(x - self.width as f32 / 2.0, half - y, 0.0) / half;
        match self.lens {
            Lens::Perspective(slope) => Ray {
                origin: Vec3::ZERO,
                direction: place * slope + Vec3::Z,
            },
            Lens::Parallel(extent) => Ray {
                origin: place * extent,
                direction: Vec3::Z,
            },
        }
    }

    /// Where a point is on the raster, if it can be seen.
    pub(crate) fn place(&self, point: Vec3) -> Option<[f32; 2]> {
        let scale = self.samples_per_unit(point.z)?;
        Some([
            self.width as f32 / 2.0 + point.x * scale,
            self.height as f32 / 2.0 - point.y * scale,
        ])
    }

    /// The samples per unit of length at this depth; `None` if that is too near to be seen.
    fn samples_per_unit(&self, depth: f32) -> Option<f32> {
        let half = self.height as f32 / 2.0;
        match self.lens {
            Lens::Perspective(slope) => (depth >= NEAR).then(|| half / slope / depth),
            Lens::Parallel(extent) => Some(half / extent),
        }
    }

    /// The columns and rows of samples that something between two corners may cover. `None` if there are none.
    fn cover(&self, lo: Vec3, hi: Vec3) -> Option<[Range<usize>; 2]> {
        let far = self.samples_per_unit(hi.z)?;
        let near = self.samples_per_unit(lo.z.max(NEAR))?;
        let span = |lo: f32, hi: f32, count: usize| {
            // Something to the left is leftmost where it is near, something to the right where it is far.
            let middle = count as f32 / 2.0;
            let lo = middle + (lo * near).min(lo * far);
            let hi = middle + (hi * near).max(hi * far);
            // Conversions saturate, and NaN becomes 0.
            let first = (lo - 0.5).ceil().max(0.0) as usize;
            let end = ((hi - 0.5).floor() + 1.0).max(0.0) as usize;
            (first < end.min(count)).then(|| first..end.min(count))
        };
        Some([
            span(lo.x, hi.x, self.width)?,
            span(-hi.y, -lo.y, self.height)?,
        ])
    }

    /// What is seen, in bands of this many rows: `finish` is given the first row of a band, and the depth of each of its
    /// samples with the body there, infinity and `None` where there is none.
    pub(crate) fn see<T: Send>(
        &self,
        shapes: &[Shape],
        rows_of_band: usize,
        finish: impl Fn(usize, &[(f32, Option<u32>)]) -> T + Sync,
    ) -> Vec<T> {
        let mut bands = vec![Vec::new(); self.height.div_ceil(rows_of_band)];
        for (body, shape) in (0..).zip(shapes) {
            let (lo, hi) = shape.extent();
            if let Some([columns, rows]) = self.cover(lo, hi) {
                let nearest = if shape.is_flat { -(body as f32) } else { lo.z };
                for band in &mut bands[rows.start / rows_of_band..rows.end.div_ceil(rows_of_band)] {
                    band.push((nearest, body, columns.clone(), rows.clone()));
                }
            }
        }
        let band = |(band, mut covers): (usize, Vec<Cover>)| {
            // The nearest first: most hidden samples are then rejected before their shape is tested.
            covers.sort_by(|a, b| a.0.total_cmp(&b.0));
            let first = band * rows_of_band;
            let rows = first..(first + rows_of_band).min(self.height);
            let mut samples = vec![(f32::INFINITY, None); rows.len() * self.width];
            for cover in &covers {
                self.see_body(&shapes[cover.1 as usize], cover, &rows, &mut samples);
            }
            finish(first, &samples)
        };
        bands.into_par_iter().enumerate().map(band).collect()
    }

    /// Puts a body into the samples of some rows in which nothing is nearer.
    fn see_body(
        &self,
        shape: &Shape,
        &(nearest, body, ref columns, ref covered): &Cover,
        rows: &Range<usize>,
        samples: &mut [(f32, Option<u32>)],
    ) {
        for row in rows.start.max(covered.start)..rows.end.min(covered.end) {
            for column in columns.clone() {
                let sample = &mut samples[(row - rows.start) * self.width + column];
                if nearest > sample.0 {
                    continue;
                }
                let ray = self.ray(column as f32 + 0.5, row as f32 + 0.5);
                let Some((depth, _)) = shape.hit(&ray) else {
                    continue;
                };
                // Of those in the plane, the later is on top.
                let depth = if shape.is_flat { nearest } else { depth };
                let is_seen = depth >= NEAR || matches!(self.lens, Lens::Parallel(_));
                if is_seen && depth < sample.0 {
                    *sample = (depth, Some(body));
                }
            }
        }
    }
}

/// How near a body is at least, its number, and the columns and rows that it may cover.
type Cover = (f32, u32, Range<usize>, Range<usize>);
