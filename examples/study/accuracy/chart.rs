//! The charts in SVG: error against computing time, a panel for each scene, a curve for each method, and a point for each time
//! step.

use super::case::{Method, Scalar};
use super::ensembles::Ensembles;
use super::scene::{Continuous, Scene};
use crate::RAPIER;
use crate::finder::Finder;
use unisize_charts::{Axis, Chart, Panel, RGBColor, Series, color};

const COLUMNS: usize = 4;

/// The places of errors that are zero are below the least of the others by these factors.
const ZERO: [f64; 2] = [30.0, 5.0];

/// The chart of one dimension.
pub(crate) fn chart(dim: u8, studies: &[Ensembles]) -> Chart {
    let title = format!(
        "Error against computing time, {dim}D, Rapier {RAPIER}: low is accurate, left is fast"
    );
    let of_dim: Vec<_> = studies.iter().filter(|study| study.dim == dim).collect();
    // The scenes of one group share a panel.
    let groups = of_dim.chunk_by(|a, b| a.scene.group() == b.scene.group());
    Chart::new(title, groups.map(panel))
        .columns(COLUMNS)
        .own_ranges()
        .note("The points of a curve are the time steps: 1/30, 1/60, 1/120 and 1/240 s, from the left to the right. Each is the median")
        .note("of the starts, and the band is its 95 % interval.")
}

/// All methods in one scene, or in the scenes of a group.
fn panel(studies: &[&Ensembles]) -> Panel {
    let first = studies[0];
    let error = first.errors().first().copied().unwrap_or_default();
    let of_study = |study: &&Ensembles| {
        let curves = curves(study).into_iter();
        curves.map(|curve| (study.scene, curve)).collect::<Vec<_>>()
    };
    let mut curves: Vec<_> = studies.iter().flat_map(of_study).collect();
    let points = curves.iter().flat_map(|(_, curve)| &curve.points);
    let errors = points.flat_map(|point| [point.error, point.low]);
    let (mut least, mut has_zero) = (1.0_f64, false);
    for error in errors {
        match error > 0.0 {
            true => least = least.min(error),
            false => has_zero = true,
        }
    }
    let mut axis = Axis::log(error);
    if has_zero {
        let [low, high] = ZERO.map(|factor| least / factor);
        axis = axis.with_zero_between(low, high);
        // Curves that are all zero, one below the other.
        for (scene, curve) in &mut curves {
            let place = low * (high / low).powf(share(*scene));
            for point in &mut curve.points {
                point.lift(place);
            }
        }
    }
    let series = curves
        .into_iter()
        .map(|(scene, curve)| series(curve, labels(scene)));
    Panel::new(
        format!(
            "{} {}D, {} bodies",
            first.scene.group(),
            first.dim,
            first.bodies
        ),
        Axis::log("ms of computing for one simulated second"),
        axis,
        series,
    )
}

/// Where in the band of zero a scene has its place.
fn share(scene: Scene) -> f64 {
    match scene {
        Scene::Bullets(Continuous::Soft) => 0.7,
        Scene::Bullets(Continuous::Ccd) => 0.25,
        _ => 0.5,
    }
}

/// A curve before it is drawn.
struct Curve {
    method: Method,
    points: Vec<Point>,
}

/// The medians of a time step, with the interval of the error.
#[derive(Clone, Copy)]
struct Point {
    milliseconds: f64,
    error: f64,
    low: f64,
    high: f64,
}

impl Point {
    /// Puts what is zero at this place.
    fn lift(&mut self, place: f64) {
        for error in [&mut self.error, &mut self.low, &mut self.high] {
            if *error == 0.0 {
                *error = place;
            }
        }
    }
}

/// The curves of a scene. Where there are several kinds of continuous collision detection, there are only those that miss nothing.
fn curves(study: &Ensembles) -> Vec<Curve> {
    let is_drawn =
        |method: &&Method| method.finder.is_exact() || !matches!(study.scene, Scene::Bullets(_));
    let point = |method: Method, frequency: u32| {
        let error = study.error(method, frequency, 0);
        Point {
            milliseconds: study.milliseconds(method, frequency).value,
            error: error.value,
            low: error.low,
            high: error.high,
        }
    };
    let curve = |&method: &Method| Curve {
        method,
        points: study
            .frequencies
            .iter()
            .map(|&frequency| point(method, frequency))
            .collect(),
    };
    let mut curves: Vec<_> = study.methods.iter().filter(is_drawn).map(curve).collect();
    // The first one is drawn above all others.
    curves.sort_by_key(|curve| {
        let Method { finder, scalar } = curve.method;
        (
            !finder.is_exact(),
            scalar != Scalar::F32,
            finder != Finder::DEFAULT,
        )
    });
    curves
}

/// The labels at the points of unisize's curve in `f32`.
fn labels(scene: Scene) -> [&'static str; 4] {
    match scene {
        Scene::Bullets(Continuous::Discrete) => ["discrete, 1/30 s", "1/60", "1/120", "1/240"],
        Scene::Bullets(Continuous::Soft) => ["soft CCD", "", "", ""],
        Scene::Bullets(Continuous::Ccd) => ["", "", "", "CCD"],
        _ => ["1/30 s", "1/60", "1/120", "1/240"],
    }
}

fn series(curve: Curve, labels: [&str; 4]) -> Series {
    let points = curve.points.iter();
    let places = points
        .clone()
        .map(|point| (point.milliseconds, point.error));
    let series = Series::new(curve.method.name(), color(curve.method), places)
        .banded(points.map(|point| (point.low, point.high)));
    match (curve.method.finder, curve.method.scalar) {
        (Finder::Unisize(_), Scalar::F32) => series.labelled(labels.map(String::from)),
        _ => series,
    }
}

fn color(method: Method) -> RGBColor {
    match (method.finder, method.scalar) {
        (Finder::Unisize(_), Scalar::F64) => color::SALMON,
        (Finder::Rapier, Scalar::F64) => color::SKY,
        (finder, _) => finder.color(),
    }
}
