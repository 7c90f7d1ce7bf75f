//! A named line through points.

use plotters::prelude::*;

/// Points of one colour, joined by a line.
#[derive(Clone, Debug)]
pub struct Series {
    pub(crate) name: String,
    pub(crate) points: Vec<(f64, f64)>,
    /// Whether its name is beside its points.
    pub(crate) is_labelled: bool,
    pub(crate) color: RGBColor,
    /// The radius of its marks.
    pub(crate) radius: i32,
    stroke: u32,
    is_ringed: bool,
}

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
            radius: 3,
            stroke: 2,
            is_ringed: false,
        }
    }

    /// With a thicker line and larger dots.
    pub fn bold(mut self) -> Self {
        (self.stroke, self.radius) = (4, 5);
        self
    }

    /// With rings in place of dots, and without a line.
    pub fn ringed(mut self) -> Self {
        (self.radius, self.is_ringed) = (8, true);
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
        !self.is_ringed
    }

    pub(crate) fn line_style(&self) -> ShapeStyle {
        self.color.stroke_width(self.stroke)
    }

    /// The mark of a point.
    pub(crate) fn mark<C>(&self, center: C) -> Circle<C, i32> {
        let style = match self.is_ringed {
            true => self.color.stroke_width(2),
            false => self.color.filled(),
        };
        Circle::new(center, self.radius, style)
    }
}

#[cfg(test)]
mod tests {
    use super::Series;
    use crate::color;

    #[test]
    fn rings_are_not_joined() {
        let series = |count: i32| Series::new("x", color::RED, (0..count).map(|x| (x.into(), 1.0)));
        let has = |series: Series| (series.has_line(), series.has_marks());
        assert_eq!(has(series(2)), (true, true));
        assert_eq!(has(series(2).ringed()), (false, true));
        assert_eq!(has(series(50)), (true, false));
    }
}
