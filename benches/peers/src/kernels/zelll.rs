//! zelll: cell lists, made for particles, not boxes.
//!
//! Boxes of one size overlap only if their lower corners lie no farther apart than that size on each axis. So
//! the corners are the particles, the cells are a little larger than the boxes, and every pair of corners in
//! neighbouring cells is compared box with box. With boxes of different sizes it would not work at all.

use super::contender::{Family, Setting};
use unisize_scenes::DriftingBoxes;
use zelll::{CellGrid, ParticleLike};

/// Sides of a cell in sides of a box. The first is as small as rounding allows: the upper corners of these
/// boxes are rounded, and so is the number of a cell.
const CELL_SIZES: [f32; 3] = [1.001, 1.5, 2.0];

/// zelll at its best size of a cell.
pub(crate) fn family<const D: usize>() -> Family<D> {
    Family::new("zelll", CELL_SIZES.map(setting))
}

fn setting<const D: usize>(size: f32) -> Setting<D> {
    Setting::listing(format!("cells of {size}"), move || {
        let mut grid: Option<CellGrid<Particle<D>, D, f32>> = None;
        move |frame, pairs| {
            let particle = |(index, &corners)| Particle { corners, index };
            let particles = (0..).zip(&frame.corners).map(particle);
            match &mut grid {
                Some(grid) => grid.rebuild_mut(particles, None),
                none => {
                    let cutoff = size * DriftingBoxes::<D>::SIZE;
                    *none = Some(CellGrid::new(particles, cutoff));
                }
            }
            for (a, b) in grid.iter().flat_map(CellGrid::particle_pairs) {
                if a.intersects(b) {
                    pairs.push([a.index, b.index]);
                }
            }
            Ok(())
        }
    })
}

#[derive(Clone, Copy)]
struct Particle<const D: usize> {
    corners: [[f32; D]; 2],
    index: u32,
}

impl<const D: usize> Default for Particle<D> {
    fn default() -> Self {
        Self {
            corners: [[0.0; D]; 2],
            index: 0,
        }
    }
}

impl<const D: usize> ParticleLike<[f32; D]> for Particle<D> {
    fn coords(&self) -> [f32; D] {
        self.corners[0]
    }
}

impl<const D: usize> Particle<D> {
    fn intersects(&self, other: &Self) -> bool {
        let ([a_mins, a_maxs], [b_mins, b_maxs]) = (&self.corners, &other.corners);
        let mut overlaps = true;
        for k in 0..D {
            overlaps &= (a_mins[k] <= b_maxs[k]) & (b_mins[k] <= a_maxs[k]);
        }
        overlaps
    }
}
