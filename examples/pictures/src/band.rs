//! Which body is seen where: a depth and a body for each sample of a band of rows.
//!
//! Pictures are made band by band, so that threads can share the work and the samples of a large picture need not be in
//! memory at once.

use crate::camera::{Lens, NEAR, Raster};
use crate::shape::Shape;
use rayon::prelude::*;
use std::ops::Range;

/// Stands for no body.
pub(crate) const NOTHING: u32 = u32::MAX;

/// A body with the columns and rows of samples that it may cover, as half-open ranges.
#[derive(Clone, Copy)]
pub(crate) struct Cover {
    body: u32,
    columns: [u32; 2],
    rows: [u32; 2],
    nearest: f32,
}

/// The bodies that reach into each band of `rows` rows, the nearest first: most hidden samples are then rejected before
/// their shape is tested. **O(n log n)**.
pub(crate) fn covers(raster: &Raster, shapes: &[Shape], rows_of_band: usize) -> Vec<Vec<Cover>> {
    let mut bands = vec![Vec::new(); raster.height.div_ceil(rows_of_band)];
    for (body, shape) in (0..NOTHING).zip(shapes) {
        let extent = shape.extent();
        let Some([columns, rows]) = raster.cover(&extent) else {
            continue;
        };
        let cover = Cover {
            body,
            columns: columns.map(|column| column as u32),
            rows: rows.map(|row| row as u32),
            nearest: extent.lo.z,
        };
        for band in &mut bands[rows[0] / rows_of_band..rows[1].div_ceil(rows_of_band)] {
            band.push(cover);
        }
    }
    bands
        .par_iter_mut()
        .for_each(|covers| covers.sort_by(|a, b| a.nearest.total_cmp(&b.nearest)));
    bands
}

/// The samples of some rows.
pub(crate) struct Band {
    /// How deep each sample is; infinite where nothing is seen.
    pub(crate) depths: Vec<f32>,
    /// The body that is seen in each, or [`NOTHING`].
    pub(crate) bodies: Vec<u32>,
}

impl Band {
    /// Sees the bodies that reach into these rows. Of two at the same depth, the later one is seen.
    pub(crate) fn see(
        raster: &Raster,
        shapes: &[Shape],
        covers: &[Cover],
        rows: Range<usize>,
    ) -> Self {
        let mut depths = vec![f32::INFINITY; rows.len() * raster.width];
        let mut bodies = vec![NOTHING; depths.len()];
        let nearest = match raster.lens {
            Lens::Perspective(_) => NEAR,
            Lens::Parallel(_) => f32::NEG_INFINITY,
        };
        for cover in covers {
            let shape = shapes[cover.body as usize];
            let first_row = rows.start.max(cover.rows[0] as usize);
            for row in first_row..rows.end.min(cover.rows[1] as usize) {
                let start = (row - rows.start) * raster.width;
                for column in cover.columns[0] as usize..cover.columns[1] as usize {
                    let sample = start + column;
                    if cover.nearest > depths[sample] {
                        continue;
                    }
                    let ray = raster.ray(column as f32 + 0.5, row as f32 + 0.5);
                    let Some(hit) = shape.hit(&ray) else {
                        continue;
                    };
                    let (before, depth) = (depths[sample], hit.depth);
                    // NaN is neither.
                    let is_on_top = depth < before
                        || depth == before
                            && bodies[sample] != NOTHING
                            && bodies[sample] < cover.body;
                    if is_on_top && depth >= nearest {
                        depths[sample] = hit.depth;
                        bodies[sample] = cover.body;
                    }
                }
            }
        }
        Self { depths, bodies }
    }
}
