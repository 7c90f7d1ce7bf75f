//! The charts in SVG: error against computing time, a panel for each scene, a curve for each method, and a point for each time
//! step.

use super::case::{Method, Scalar};
use super::ensembles::Ensembles;
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
    let of_dim = studies.iter().filter(|study| study.dim == dim);
    Chart::new(title, of_dim.map(panel))
        .columns(COLUMNS)
        .own_ranges()
        .note("The points of a curve are the time steps: 1/30, 1/60, 1/120 and 1/240 s, from the left to the right. Each is the median")
        .note("of the starts, and the band is its 95 % interval.")
}

/// All methods in one scene, by the first of its errors.
fn panel(study: &Ensembles) -> Panel {
    let mut methods = study.methods.clone();
    // The first one is drawn above all others.
    methods.sort_by_key(|method| {
        let Method { finder, scalar } = *method;
        let is_default = finder == Finder::DEFAULT;
        (!finder.is_exact(), scalar != Scalar::F32, !is_default)
    });
    let error = |method: Method, frequency: u32| study.error(method, frequency, 0);
    let errors = (methods.iter())
        .flat_map(|&method| study.frequencies.iter().map(move |&of| error(method, of)))
        .flat_map(|error| [error.value, error.low]);
    let errors: Vec<_> = errors.collect();
    let mut axis = Axis::log(study.errors().first().copied().unwrap_or_default());
    if errors.contains(&0.0) {
        let positive = errors.into_iter().filter(|error| *error > 0.0);
        let least = positive.fold(1.0, f64::min);
        axis = axis.with_zero_between(least / ZERO[0], least / ZERO[1]);
    }
    let series = methods.into_iter().map(|method| {
        let frequencies = || study.frequencies.iter();
        let points = frequencies().map(|&of| {
            let ms = study.milliseconds(method, of).value;
            (ms, error(method, of).value)
        });
        let band = frequencies().map(|&of| (error(method, of).low, error(method, of).high));
        Series::new(method.name(), color(method), points).banded(band)
    });
    Panel::new(
        format!("{}, {} bodies", study.title(), study.bodies),
        Axis::log("ms of computing for one simulated second"),
        axis,
        series,
    )
}

fn color(method: Method) -> RGBColor {
    match (method.finder, method.scalar) {
        (Finder::Unisize(_), Scalar::F64) => color::SALMON,
        (Finder::Rapier, Scalar::F64) => color::SKY,
        (finder, _) => finder.color(),
    }
}
