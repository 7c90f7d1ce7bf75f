//! A named line through points.

use plotters::prelude::*;

/// Points of one colour, joined by a line.
#[derive(Clone, Debug)]
pub struct Series {
    pub(crate) name: String,
    pub(crate) points: Vec<(f64, f64)>,
    /// Whether its name is beside its points.
    pub(crate) is_labelled: bool,
    color: RGBColor,
    stroke: u32,
    mark: Mark,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Mark {
    /// A filled circle of this radius.
    Dot(i32),
    /// A circle.
    Ring,
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
            is_labelled: false,
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

    /// With rings in place of dots, and without a line.
    pub fn ringed(mut self) -> Self {
        self.mark = Mark::Ring;
        self
    }

    /// With its name beside each point.
    pub fn labelled(mut self) -> Self {
        self.is_labelled = true;
        self
    }

    pub(crate) fn has_marks(&self) -> bool {
        self.points.len() <= MARKED
    }

    pub(crate) fn has_line(&self) -> bool {
        self.mark != Mark::Ring
    }

    pub(crate) fn color(&self) -> RGBColor {
        self.color
    }

    pub(crate) fn line_style(&self) -> ShapeStyle {
        self.color.stroke_width(self.stroke)
    }

    pub(crate) fn radius(&self) -> i32 {
        match self.mark {
            Mark::Dot(radius) => radius,
            Mark::Ring => RING_RADIUS,
        }
    }

    /// The mark of a point.
    pub(crate) fn mark<C>(&self, center: C) -> Circle<C, i32> {
        let style = match self.mark {
            Mark::Ring => self.color.stroke_width(2),
            _ => self.color.filled(),
        };
        Circle::new(center, self.radius(), style)
    }
}

#[cfg(test)]
mod tests {
    use super::Series;
    use crate::color;

    #[test]
    fn rings_are_not_joined() {
        let series = || Series::new("x", color::RED, [(1.0, 2.0), (2.0, 3.0)]);
        let has = |series: Series| (series.has_line(), series.has_marks());
        assert_eq!(has(series()), (true, true));
        assert_eq!(has(series().ringed()), (false, true));
        let many = Series::new("x", color::RED, (0..50).map(|x| (x.into(), 1.0)));
        assert_eq!(has(many), (true, false));
    }
}
