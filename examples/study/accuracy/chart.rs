//! The charts in SVG: error against computing time, a panel for each scene, a curve for each method, and a point for each time
//! step.

use super::FREQUENCIES;
use super::ensembles::Ensembles;
use crate::finder::Finder;
use crate::{FINDERS, RAPIER};
use unisize_charts::{Axis, Chart, Panel, Series};

/// The chart of one dimension.
pub(crate) fn chart(dim: u8, studies: &[Ensembles]) -> Chart {
    let title = format!(
        "Error against computing time, {dim}D, Rapier {RAPIER}: low is accurate, left is fast"
    );
    let of_dim = studies.iter().filter(|study| study.dim == dim);
    Chart::new(title, of_dim.map(panel))
        .note("The points of a curve: time steps of 1/30, 1/60, 1/120 and 1/240 s, from the left to the right; medians of the starts.")
}

/// All methods in one scene, by the first of its errors.
fn panel(study: &Ensembles) -> Panel {
    let mut finders = FINDERS.to_vec();
    // The first one is drawn above all others.
    finders.sort_by_key(|&finder| (!finder.is_exact(), finder != Finder::DEFAULT));
    let points = |finder: Finder| {
        FREQUENCIES.map(|frequency| {
            let ms = study.milliseconds(finder, frequency);
            (ms, study.error(finder, frequency, 0))
        })
    };
    let series = finders
        .into_iter()
        .map(|finder| Series::new(finder.name(), finder.color(), points(finder)));
    Panel::new(
        format!("{}, {} bodies", study.title(), study.bodies),
        Axis::log("ms of computing for one simulated second"),
        Axis::log(study.errors().first().copied().unwrap_or_default()),
        series,
    )
}
