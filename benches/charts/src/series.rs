//! A named line through points.

use crate::mark::{Dot, Mark};
use plotters::prelude::*;

/// Points of one colour and shape, joined by a line.
#[derive(Clone, Debug)]
pub struct Series {
    pub(crate) name: String,
    pub(crate) points: Vec<(f64, f64)>,
    /// Whether its name is beside its points.
    pub(crate) is_labelled: bool,
    /// The radius of its marks.
    pub(crate) radius: i32,
    color: RGBColor,
    mark: Mark,
    stroke: u32,
}

/// With more points than this, a line has no marks.
const MARKED: usize = 40;

impl Series {
    /// A line with a mark at every point, unless there are many. The colour decides the shape of the marks.
    pub fn new(
        name: impl Into<String>,
        color: RGBColor,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        Self {
            name: name.into(),
            points: points.into_iter().collect(),
            is_labelled: false,
            radius: 5,
            color,
            mark: Mark::of(color),
            stroke: 2,
        }
    }

    /// With a thicker line and larger marks.
    pub fn bold(mut self) -> Self {
        (self.stroke, self.radius) = (4, 7);
        self
    }

    /// With outlines as marks.
    pub fn hollow(mut self) -> Self {
        self.mark = self.mark.hollow();
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

    pub(crate) fn line_style(&self) -> ShapeStyle {
        self.color.stroke_width(self.stroke)
    }

    /// The mark of a point.
    pub(crate) fn mark<C>(&self, center: C) -> Dot<C> {
        Dot {
            center,
            mark: self.mark,
            radius: self.radius,
            color: self.color,
        }
    }
}
