//! The charts in SVG: what each method misses, against its time; a panel for each scene.

use super::family::Family;
use super::front::staircase;
use super::study::{Figures, Study};
use anyhow::Result;
use std::path::{Path, PathBuf};
use unisize_charts::{Axis, Chart, Panel, Series, color};

const COLUMNS: usize = 3;

/// How wide the band is in which nothing is missed, in powers of ten.
const BAND: f64 = 2.0;

/// Everything is missed.
const ALL: f64 = 100.0;

/// Draws all studies that there are, and returns the files.
pub(super) fn draw(folder: &Path, studies: &[Study]) -> Result<Vec<PathBuf>> {
    let mut charts = Vec::new();
    for dim in [2, 3] {
        let of_dim: Vec<_> = (studies.iter())
            .filter(|study| study.dim == dim && !study.is_fast)
            .collect();
        let title = format!("Contacts missed for speed, {dim}D: left is exact, low is fast");
        let chart = chart(title, &of_dim)
            .note("In the grey band nothing is missed; each family has a column there. Nothing lies below or to the left of the black line.")
            .note("What is updated every 2nd, 4th or 8th step (the label) has margins of 0.01, 0.05, 0.2 and 0.5 sizes: the wider, the fewer contacts are missed.")
            .note("A quantile of the sizes as the common size: 0.5, 0.75, 0.9, 0.99 (the label), and the largest. Time is that of broad and narrow phase.");
        charts.push((format!("missed-{dim}d.svg"), chart, of_dim.len()));
    }
    let fast: Vec<_> = studies.iter().filter(|study| study.is_fast).collect();
    let title = "Fast things: what meets during a step and is missed; left is exact, low is fast";
    let chart = chart(title.to_owned(), &fast)
        .note("Swept boxes reach from the beginning of the step to its end; all others are those at its end.")
        .note("In the grey band nothing is missed; each family has a column there. Nothing lies below or to the left of the black line.");
    charts.push(("missed-bullets.svg".to_owned(), chart, fast.len()));

    let mut files = Vec::new();
    for (name, chart, _) in charts.into_iter().filter(|&(_, _, panels)| panels > 0) {
        let file = folder.join(name);
        chart.write_svg(&file)?;
        files.push(file);
    }
    Ok(files)
}

fn chart(title: String, studies: &[&Study]) -> Chart {
    let missed = studies.iter().flat_map(|study| &study.figures);
    let missed = missed.map(percent).filter(|&percent| percent > 0.0);
    // The band ends at a power of ten, so that ticks are.
    let end = 10_f64.powf(missed.fold(1.0, f64::min).log10().floor());
    let band = [end / 10_f64.powf(BAND), end];
    Chart::new(title, studies.iter().map(|study| panel(study, band)))
        .columns(COLUMNS)
        .own_ranges()
}

/// All methods in one scene. What misses nothing is shown in this band of the axis.
fn panel(study: &Study, band: [f64; 2]) -> Panel {
    let families = Family::all(study.is_fast);
    let columns = families.len() as f64;
    let series = |(column, family): (f64, &Family)| {
        let share = (column + 0.5) / columns;
        let exact = band[0] * (band[1] / band[0]).powf(share);
        let members = study.figures.iter().filter(|f| family.has(&f.method));
        let members: Vec<_> = members.collect();
        let points = members.iter().map(|figures| {
            let x = match figures.misses_nothing() {
                true => exact,
                false => percent(figures),
            };
            (x, study.relative(figures))
        });
        let labels = members
            .iter()
            .map(|figures| match figures.misses_nothing() {
                true => String::new(),
                false => (family.label)(&figures.method),
            });
        let labels = once_in_a_row(labels);
        let mut series = Series::new(family.name, family.color, points).labelled(labels);
        if family.is_bold {
            series = series.bold();
        }
        if let Some(shape) = family.shape {
            series = series.shaped(shape);
        }
        if !family.is_line {
            series = series.unjoined();
        }
        (!members.is_empty()).then_some(series)
    };
    let numbered = (0..).map(f64::from).zip(&families);
    let mut all: Vec<_> = numbered.filter_map(series).collect();

    let front = study.front().into_iter();
    let mut front: Vec<_> = front
        .map(|figures| (percent(figures).max(band[0]), study.relative(figures)))
        .collect();
    if let Some(&(_, fastest)) = front.last() {
        front.push((ALL, fastest));
    }
    let front = Series::new("the Pareto front", color::BLACK, staircase(&front));
    all.push(front.bold().unmarked());
    let met = match study.is_fast {
        false => "contacts missed, % of those that touch",
        true => "contacts missed, % of those during the step",
    };
    Panel::new(
        format!("{}, {} bodies", study.title(), study.bodies),
        Axis::log(met).with_zero_between(band[0], band[1]),
        Axis::log("time over unisize's default"),
        all,
    )
}

/// Each label once where several follow each other.
fn once_in_a_row(labels: impl Iterator<Item = String>) -> Vec<String> {
    let mut last = String::new();
    let labels = labels.map(|label| {
        let is_new = label != last;
        last.clone_from(&label);
        if is_new { label } else { String::new() }
    });
    labels.collect()
}

fn percent(figures: &Figures) -> f64 {
    100.0 * figures.share_missed()
}

#[cfg(test)]
mod tests {
    use super::once_in_a_row;

    #[test]
    fn labels_are_not_repeated() {
        let labels = ["2", "2", "", "4", "4"].map(str::to_owned);
        let once = once_in_a_row(labels.into_iter());
        assert_eq!(once, ["2", "", "", "4", ""]);
    }
}
