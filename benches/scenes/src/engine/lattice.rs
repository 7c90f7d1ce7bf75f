//! Places for bodies that must not overlap at the start: the cells of a regular grid.

use super::rapier::{math::DIM, prelude::*};
use super::space::{UP, Vector, power, vector};

/// A grid of cells, as wide along each horizontal axis, filled layer by layer from the bottom.
#[derive(Clone)]
pub(super) struct Lattice {
    /// How many cells there are along each horizontal axis.
    pub(super) columns: usize,
    /// How many layers there are.
    pub(super) layers: usize,
    spacing: Real,
}

impl Lattice {
    /// The cells for `count` bodies in a heap whose height is about `aspect` times its width.
    pub(super) fn heap(count: usize, spacing: Real, aspect: Real) -> Self {
        let exact = power(count.max(1) as Real / aspect, 1.0 / DIM as Real);
        Self::with_columns(count, spacing, exact.ceil() as usize)
    }

    /// The cells for `count` bodies in layers of this many columns along each horizontal axis.
    pub(super) fn with_columns(count: usize, spacing: Real, columns: usize) -> Self {
        let columns = columns.max(1);
        let layers = count.max(1).div_ceil(columns.pow(DIM as u32 - 1));
        Self {
            columns,
            layers,
            spacing,
        }
    }

    /// The cells for `count` bodies in one layer: a row in the plane, and a square in space.
    pub(super) fn layer(count: usize, spacing: Real) -> Self {
        let columns = match DIM {
            2 => count,
            _ => (count as f64).sqrt().ceil() as usize,
        };
        Self::with_columns(count, spacing, columns)
    }

    /// Half of the width.
    pub(super) fn half_width(&self) -> Real {
        self.columns as Real * self.spacing / 2.0
    }

    /// The height of all layers.
    pub(super) fn height(&self) -> Real {
        self.layers as Real * self.spacing
    }

    /// How many cells are in a layer.
    pub(super) fn per_layer(&self) -> usize {
        self.columns.pow(DIM as u32 - 1)
    }

    /// The center of a cell: around zero along the horizontal axes, and above zero.
    pub(super) fn center(&self, index: usize) -> Vector {
        let layer = index / self.per_layer();
        let mut rest = index % self.per_layer();
        vector(|axis| {
            if axis == UP {
                return (layer as Real + 0.5) * self.spacing;
            }
            let cell = rest % self.columns;
            rest /= self.columns;
            (cell as Real + 0.5) * self.spacing - self.half_width()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::space::length;
    use super::{DIM, Lattice, UP};

    #[test]
    fn cells_are_apart_and_inside() {
        let lattices = [0, 1, 2, 17, 100].into_iter().flat_map(|count| {
            [
                (count, Lattice::heap(count, 1.5, 0.5)),
                (count, Lattice::layer(count, 1.5)),
            ]
        });
        for (count, lattice) in lattices {
            let centers: Vec<_> = (0..count).map(|index| lattice.center(index)).collect();
            for (index, center) in centers.iter().enumerate() {
                for axis in (0..DIM).filter(|&axis| axis != UP) {
                    assert!(center[axis].abs() < lattice.half_width());
                }
                assert!(center[UP] > 0.0 && center[UP] < lattice.height());
                for other in &centers[..index] {
                    assert!(length(*center - *other) > 1.49);
                }
            }
        }
    }
}
