//! Families of methods, as the charts show them: one colour, one kind of mark, and perhaps a line through the variants.

use super::method::{Feed, INTERVALS, Method, Search};
use unisize_charts::{RGBColor, Shape, color};

/// A family of methods.
pub(super) struct Family {
    pub(super) name: &'static str,
    pub(super) color: RGBColor,
    /// A dot if there is none.
    pub(super) shape: Option<Shape>,
    pub(super) is_bold: bool,
    /// Whether its variants lie along a line.
    pub(super) is_line: bool,
    /// What is written beside a point that misses something.
    pub(super) label: fn(&Method) -> String,
    has: Box<dyn Fn(&Method) -> bool>,
}

impl Family {
    fn new(
        name: &'static str,
        color: RGBColor,
        shape: Option<Shape>,
        has: impl Fn(&Method) -> bool + 'static,
    ) -> Self {
        Self {
            name,
            color,
            shape,
            is_bold: false,
            is_line: false,
            label: |_| String::new(),
            has: Box::new(has),
        }
    }

    fn bold(self) -> Self {
        Self {
            is_bold: true,
            ..self
        }
    }

    fn line(self, label: fn(&Method) -> String) -> Self {
        Self {
            is_line: true,
            label,
            ..self
        }
    }

    pub(super) fn has(&self, method: &Method) -> bool {
        (self.has)(method)
    }

    /// The families of a chart, in the order of its legend. What is above covers what is below.
    pub(super) fn all(is_fast: bool) -> Vec<Self> {
        match is_fast {
            false => usual(),
            true => fast(),
        }
    }
}

fn usual() -> Vec<Family> {
    const SQUARE: Option<Shape> = Some(Shape::Square);
    let mut families = vec![
        Family::new("unisize, default settings", color::RED, None, |method| {
            *method == plain(Search::DEFAULT)
        })
        .bold(),
        Family::new(
            "unisize, other kernels, foresights, no margin",
            color::SALMON,
            None,
            |method| method.is_setting() && method.search != Search::DEFAULT,
        ),
        Family::new("Rapier 0.27", color::BLUE, SQUARE, |method| {
            *method == plain(Search::Rapier027)
        }),
        rapier_036("Rapier 0.36"),
        common_box("paper's kernel, one size: a quantile"),
        hash_grid("hash grid of centres"),
    ];
    for (name, color, shape, search) in [
        (
            "unisize, updated every 2nd, 4th, 8th step",
            color::PINK,
            None,
            Search::DEFAULT,
        ),
        (
            "Rapier 0.27, updated every 2nd, 4th, 8th step",
            color::SKY,
            SQUARE,
            Search::Rapier027,
        ),
    ] {
        for interval in INTERVALS {
            let family = Family::new(name, color, shape, move |method| {
                method.search == search && method.feed.interval == interval
            });
            families.push(family.line(|method| method.feed.interval.to_string()));
        }
    }
    families
}

fn fast() -> Vec<Family> {
    let swept = |method: &Method| method.feed.swept;
    vec![
        Family::new(
            "unisize, default settings, swept boxes",
            color::RED,
            None,
            move |method| swept(method) && method.search == Search::DEFAULT,
        )
        .bold(),
        Family::new(
            "unisize, other settings, swept boxes",
            color::SALMON,
            None,
            move |method| swept(method) && method.is_setting() && method.search != Search::DEFAULT,
        ),
        Family::new(
            "Rapier 0.27, swept boxes",
            color::BLUE,
            Some(Shape::Square),
            move |method| swept(method) && method.search == Search::Rapier027,
        ),
        Family::new("Rapier 0.27", color::SKY, Some(Shape::Square), |method| {
            *method == plain(Search::Rapier027)
        }),
        rapier_036("Rapier 0.36"),
        common_box("paper's kernel, one size"),
        hash_grid("hash grid of centres"),
        Family::new(
            "unisize, boxes with margins, in sizes",
            color::PINK,
            None,
            |method| method.search == Search::DEFAULT && !method.feed.swept,
        )
        .line(|method| method.feed.margin.to_string()),
    ]
}

fn plain(search: Search) -> Method {
    Method {
        search,
        feed: Feed::PLAIN,
    }
}

fn rapier_036(name: &'static str) -> Family {
    Family::new(name, color::PURPLE, Some(Shape::Square), |method| {
        method.search == Search::Rapier036
    })
}

fn common_box(name: &'static str) -> Family {
    let has = |method: &Method| matches!(method.search, Search::CommonBox(_));
    Family::new(name, color::GREEN, Some(Shape::Triangle), has).line(|method| match method.search {
        Search::CommonBox(share) if share < 1.0 => share.to_string(),
        _ => String::new(),
    })
}

fn hash_grid(name: &'static str) -> Family {
    Family::new(name, color::OCHRE, Some(Shape::Diamond), |method| {
        method.search == Search::HashGrid
    })
}

#[cfg(test)]
mod tests {
    use super::{Family, Method};

    #[test]
    fn every_method_is_of_one_family() {
        for (is_fast, methods) in [
            (false, Method::all(100)),
            (true, Method::for_fast_things(100)),
        ] {
            let families = Family::all(is_fast);
            for method in methods {
                let of = families.iter().filter(|family| family.has(&method));
                assert_eq!(of.count(), 1, "{method:?}");
            }
        }
    }
}
