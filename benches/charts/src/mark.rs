//! The shapes of points. Each colour has one, so that series are distinguishable without their colours too.

use crate::color;
use plotters::element::{Drawable, PointCollection};
use plotters::prelude::*;
use plotters_backend::{BackendCoord, DrawingErrorKind};
use std::iter::{Once, once};

/// The shape of a point, filled or as an outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Circle {
        is_filled: bool,
    },
    Square {
        is_filled: bool,
    },
    Triangle {
        is_filled: bool,
    },
    Diamond {
        is_filled: bool,
    },
    /// A triangle on its tip.
    Wedge {
        is_filled: bool,
    },
    /// Two diagonals.
    Cross,
    /// Two lines along the axes.
    Plus,
}

impl Mark {
    /// The shape that points of a colour have.
    pub(crate) fn of(color: RGBColor) -> Self {
        match color {
            color::RED => Self::Circle { is_filled: true },
            color::SALMON => Self::Circle { is_filled: false },
            color::BLUE => Self::Square { is_filled: true },
            color::SKY => Self::Square { is_filled: false },
            color::GREEN => Self::Triangle { is_filled: true },
            color::MINT => Self::Triangle { is_filled: false },
            color::PURPLE => Self::Diamond { is_filled: true },
            color::OCHRE => Self::Wedge { is_filled: true },
            color::PINK => Self::Diamond { is_filled: false },
            color::ROSE => Self::Wedge { is_filled: false },
            color::GREY => Self::Plus,
            _ => Self::Cross,
        }
    }

    /// The same shape as an outline, where it has one.
    pub(crate) fn hollow(self) -> Self {
        match self {
            Self::Circle { .. } => Self::Circle { is_filled: false },
            Self::Square { .. } => Self::Square { is_filled: false },
            Self::Triangle { .. } => Self::Triangle { is_filled: false },
            Self::Diamond { .. } => Self::Diamond { is_filled: false },
            Self::Wedge { .. } => Self::Wedge { is_filled: false },
            Self::Cross | Self::Plus => self,
        }
    }
}

/// A mark at a place.
pub(crate) struct Dot<C> {
    pub(crate) center: C,
    pub(crate) mark: Mark,
    pub(crate) radius: i32,
    pub(crate) color: RGBColor,
}

impl<'a, C> PointCollection<'a, C> for &'a Dot<C> {
    type Point = &'a C;
    type IntoIter = Once<&'a C>;

    fn point_iter(self) -> Self::IntoIter {
        once(&self.center)
    }
}

impl<C, B: DrawingBackend> Drawable<B> for Dot<C> {
    /// Draws it in pixels. An outline is filled with white, so that no line shows through.
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        mut places: I,
        backend: &mut B,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        let Some((x, y)) = places.next() else {
            return Ok(());
        };
        let r = self.radius;
        let stroke = self.color.stroke_width(2);
        let fill = |is_filled| if is_filled { self.color } else { WHITE }.filled();
        let (corners, is_filled) = match self.mark {
            Mark::Circle { is_filled } => {
                backend.draw_circle((x, y), r as u32, &fill(is_filled), true)?;
                return backend.draw_circle((x, y), r as u32, &stroke, false);
            }
            Mark::Cross => {
                let lines = [(-r, -r), (r, r), (0, 0), (-r, r), (r, -r)];
                return backend.draw_path(lines.map(|(a, b)| (x + a, y + b)), &stroke);
            }
            Mark::Plus => {
                let lines = [(-r, 0), (r, 0), (0, 0), (0, -r), (0, r)];
                return backend.draw_path(lines.map(|(a, b)| (x + a, y + b)), &stroke);
            }
            Mark::Square { is_filled } => (vec![(-r, -r), (r, -r), (r, r), (-r, r)], is_filled),
            Mark::Triangle { is_filled } => (vec![(0, -r - 1), (r + 1, r), (-r - 1, r)], is_filled),
            Mark::Diamond { is_filled } => {
                let r = r + 1;
                (vec![(0, -r), (r, 0), (0, r), (-r, 0)], is_filled)
            }
            Mark::Wedge { is_filled } => (vec![(0, r + 1), (r + 1, -r), (-r - 1, -r)], is_filled),
        };
        let corners: Vec<_> = corners.iter().map(|(a, b)| (x + a, y + b)).collect();
        backend.fill_polygon(corners.clone(), &fill(is_filled))?;
        let around = corners.iter().chain(corners.first()).copied();
        backend.draw_path(around, &stroke)
    }
}

#[cfg(test)]
mod tests {
    use super::Mark;
    use crate::color;

    #[test]
    fn colors_of_one_chart_have_different_shapes() {
        let colors = || {
            color::OURS
                .iter()
                .chain(&color::OTHERS)
                .chain([&color::BLUE, &color::SKY])
        };
        for (i, a) in colors().enumerate() {
            for b in colors().take(i) {
                assert_ne!(Mark::of(*a), Mark::of(*b), "{a:?} and {b:?}");
            }
        }
    }
}
