//! The bodies of a drawing in plain numbers, for programs that draw them by other means.

use crate::Color;
use crate::shape::Shape;

/// A body as it was added to a [`Drawing`](crate::Drawing).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Its shape and place.
    pub solid: Solid,
    /// Its colour.
    pub color: Color,
    /// Whether it is a body in space; one in the plane has its colour as it is.
    pub is_lit: bool,
}

/// The shape and the place of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// All within `radius` of a point.
    Sphere {
        /// The point.
        center: [f32; 3],
        /// The distance.
        radius: f32,
    },
    /// All within `radius` of the line between two points.
    Capsule {
        /// The points.
        ends: [[f32; 3]; 2],
        /// The distance.
        radius: f32,
    },
    /// A box, or a rectangle if the third of its edges has no length.
    Cuboid {
        /// Its middle.
        center: [f32; 3],
        /// Half of each of its edges.
        half_edges: [[f32; 3]; 3],
    },
    /// A disc in the plane of the first two axes.
    Disc {
        /// Its middle.
        center: [f32; 2],
        /// The distance from there to its rim.
        radius: f32,
    },
}

impl From<Shape> for Solid {
    fn from(shape: Shape) -> Self {
        match shape {
            Shape::Sphere { center, radius } => Self::Sphere {
                center: center.into(),
                radius,
            },
            Shape::Capsule {
                center,
                axis,
                half,
                radius,
            } => Self::Capsule {
                ends: [-half, half].map(|along| (center + axis * along).into()),
                radius,
            },
            Shape::Cuboid { center, axes, half } => Self::Cuboid {
                center: center.into(),
                half_edges: [
                    axes.x_axis * half.x,
                    axes.y_axis * half.y,
                    axes.z_axis * half.z,
                ]
                .map(Into::into),
            },
            Shape::Disc { center, radius, .. } => Self::Disc {
                center: [center.x, center.y],
                radius,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Solid;
    use crate::{Color, Drawing};

    #[test]
    fn what_was_added_is_told_in_its_order() {
        let color = Color([1, 2, 3]);
        let mut drawing = Drawing::new();
        drawing.capsule([[0.0, 1.0, 0.0], [0.0, 3.0, 0.0]], 0.5, color);
        drawing.sphere([f32::NAN, 0.0, 0.0], 1.0, color); // Skipped.
        let quarter_about_z = [0.0, 0.0, 0.5_f32.sqrt(), 0.5_f32.sqrt()];
        drawing.cuboid([1.0; 3], [1.0, 2.0, 3.0], quarter_about_z, color);
        drawing.disc([4.0, 5.0], 6.0, color);
        drawing.ground_with_grid(-1.0, 2.0);

        let figures: Vec<_> = drawing.figures().collect();
        assert_eq!(figures.len(), 3);
        assert!(figures.iter().all(|figure| figure.color == color));
        assert_eq!(figures[0].solid, {
            let ends = [[0.0, 1.0, 0.0], [0.0, 3.0, 0.0]];
            Solid::Capsule { ends, radius: 0.5 }
        });
        let Solid::Cuboid { center, half_edges } = figures[1].solid else {
            panic!("a box comes second");
        };
        assert_eq!(center, [1.0; 3]);
        let expected = [[0.0, 1.0, 0.0], [-2.0, 0.0, 0.0], [0.0, 0.0, 3.0]];
        for (edge, expected) in half_edges.iter().flatten().zip(expected.iter().flatten()) {
            assert!((edge - expected).abs() < 1e-5);
        }
        assert!(figures[1].is_lit && !figures[2].is_lit);
        assert_eq!(drawing.ground_and_pitch(), Some([-1.0, 2.0]));
    }
}
