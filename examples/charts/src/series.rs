//! A named line through points.

use plotters::prelude::*;

/// Points of one colour, joined by a line.
#[derive(Clone, Debug)]
pub struct Series {
    pub(crate) name: String,
    pub(crate) points: Vec<(f64, f64)>,
    /// The labels of the first points; an empty one is not drawn.
    pub(crate) labels: Vec<String>,
    /// The lower and the upper bound of each point; none without a band.
    pub(crate) band: Vec<(f64, f64)>,
    color: RGBColor,
    stroke: u32,
    mark: Mark,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Mark {
    /// A filled circle of this radius.
    Dot(i32),
    /// A circle around the mark of another series.
    Ring,
    /// A filled shape of this radius with corners.
    Polygon(Shape, i32),
    /// Nothing.
    None,
}

/// The shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// With a side at the bottom.
    Square,
    /// With a side at the bottom.
    Triangle,
    /// A square on its corner.
    Diamond,
}

const RING_RADIUS: i32 = 8;

/// With more points than this, a line has no marks.
const MARKED: usize = 40;

impl Series {
    /// A line with a dot at every point, unless there are many.
    pub fn new(
        name: impl Into<String>,
        color: RGBColor,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        Self {
            name: name.into(),
            points: points.into_iter().collect(),
            labels: Vec::new(),
            band: Vec::new(),
            color,
            stroke: 2,
            mark: Mark::Dot(3),
        }
    }

    /// With a thicker line and larger dots.
    pub fn bold(mut self) -> Self {
        (self.stroke, self.mark) = (4, Mark::Dot(5));
        self
    }

    /// With a ring around each point, to mark points of other series.
    pub fn ringed(mut self) -> Self {
        self.mark = Mark::Ring;
        self
    }

    /// With marks of another shape than a dot.
    pub fn shaped(mut self, shape: Shape) -> Self {
        self.mark = Mark::Polygon(shape, self.radius() + 1);
        self
    }

    /// Without a line between its points.
    pub fn unjoined(mut self) -> Self {
        self.stroke = 0;
        self
    }

    /// Without marks at its points.
    pub fn unmarked(mut self) -> Self {
        self.mark = Mark::None;
        self
    }

    /// With a label beside each point, in the order of the points; an empty one is left out.
    pub fn labelled(mut self, labels: impl IntoIterator<Item = String>) -> Self {
        self.labels = labels.into_iter().collect();
        self
    }

    pub(crate) fn has_marks(&self) -> bool {
        self.points.len() <= MARKED && self.mark != Mark::None
    }

    pub(crate) fn has_line(&self) -> bool {
        self.mark != Mark::Ring && self.stroke > 0
    }

    pub(crate) fn color(&self) -> RGBColor {
        self.color
    }

    pub(crate) fn line_style(&self) -> ShapeStyle {
        self.color.stroke_width(self.stroke)
    }

    pub(crate) fn radius(&self) -> i32 {
        match self.mark {
            Mark::Dot(radius) | Mark::Polygon(_, radius) => radius,
            Mark::Ring => RING_RADIUS,
            Mark::None => 0,
        }
    }

    /// The mark of a point, if it is round.
    pub(crate) fn mark<C>(&self, center: C) -> Circle<C, i32> {
        let style = match self.mark {
            Mark::Ring => self.color.stroke_width(2),
            _ => self.color.filled(),
        };
        Circle::new(center, self.radius(), style)
    }

    /// The mark of a point, if it has corners: around the point, in pixels.
    pub(crate) fn polygon(&self) -> Option<impl Fn() -> Polygon<(i32, i32)>> {
        let style = self.color.filled();
        match self.mark {
            Mark::Polygon(shape, radius) => {
                Some(move || Polygon::new(shape.corners(radius), style))
            }
            _ => None,
        }
    }
}

impl Shape {
    /// The corners around a centre, in pixels; y goes down.
    fn corners(self, radius: i32) -> Vec<(i32, i32)> {
        let r = radius;
        match self {
            Self::Square => vec![(-r, -r), (r, -r), (r, r), (-r, r)],
            Self::Triangle => vec![(0, -r - 1), (r + 1, r), (-r - 1, r)],
            Self::Diamond => vec![(0, -r - 1), (r + 1, 0), (0, r + 1), (-r - 1, 0)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Series, Shape};
    use crate::color;

    #[test]
    fn lines_and_marks_can_be_left_out() {
        let series = || Series::new("x", color::RED, [(1.0, 2.0), (2.0, 3.0)]);
        let has = |series: Series| (series.has_line(), series.has_marks());
        assert_eq!(has(series()), (true, true));
        assert_eq!(has(series().unjoined()), (false, true));
        assert_eq!(has(series().unmarked()), (true, false));
        assert_eq!(has(series().ringed()), (false, true));
        let shaped = series().shaped(Shape::Square);
        assert!(shaped.polygon().is_some() && series().polygon().is_none());
        assert_eq!(has(shaped), (true, true));
    }
}
