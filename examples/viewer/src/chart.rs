//! The running chart of milliseconds.

use crate::history::{History, Sample};
use egui_plot::{AxisHints, GridMark, Line, LineStyle, Plot};
use kiss3d::egui::{Color32, Rangef, RichText, Sense, Shape, Stroke, Ui, vec2};

/// The colours of the broad phases, from Okabe and Ito's palette for the colour-blind; they differ in lightness too.
pub(crate) const UNISIZE: Color32 = Color32::from_rgb(0x56, 0xb4, 0xe9);
pub(crate) const DEFAULT: Color32 = Color32::from_rgb(0xe6, 0x9f, 0x00);

/// The height of a chart in points, the length of a dash.
const HEIGHT: f32 = 140.0;
const DASH: f32 = 6.0;

/// About how many grid lines there are.
const LINES: f64 = 4.0;

/// The height of the chart over the usual maximum, and its least height in milliseconds. Rare values, as when something else ran
/// on the machine, are cut off.
const HEADROOM: f64 = 1.4;
const LEAST: f64 = 0.01;

/// Reads a value from a sample.
type Read = fn(&Sample) -> Option<f64>;

/// The whole step with unisize, and with Rapier's own broad phase.
const STEP: [Read; 2] = [
    |sample| Some(sample.unisize? + sample.rest),
    |sample| Some(sample.default? + sample.rest),
];

const BROAD_PHASE: [Read; 2] = [|sample| sample.unisize, |sample| sample.default];

/// Draws a chart of the broad phase and one of the whole step.
pub(crate) fn show(ui: &mut Ui, history: &History) {
    for (id, title, read) in [
        ("broad phase", "Broad phase", BROAD_PHASE),
        ("step", "Whole step", STEP),
    ] {
        ui.add_space(2.0);
        ui.horizontal(|ui| {
            ui.label(RichText::new(title).strong());
            for series in SERIES {
                series.show_in_legend(ui);
            }
        });
        show_lines(ui, id, history, read);
    }
}

fn show_lines(ui: &mut Ui, id: &str, history: &History, read: [Read; 2]) {
    let [first, last] = history.range().map(|step| step as f64);
    let maximum = history.usual_maximum(&read).unwrap_or_default();
    let milliseconds = AxisHints::new_y()
        .label("ms")
        .min_thickness(34.0)
        .label_spacing(Rangef::new(10.0, 12.0))
        .formatter(|mark, _| format_milliseconds(mark.value));
    Plot::new(id)
        .height(HEIGHT)
        .custom_x_axes(vec![AxisHints::new_x().label("step")])
        .custom_y_axes(vec![milliseconds])
        .y_grid_spacer(|input| {
            let [low, high] = [input.bounds.0, input.bounds.1];
            let step_size = round_step((high - low) / LINES);
            let lines = (low / step_size).ceil() as i64..=(high / step_size).floor() as i64;
            let mark = |line: i64| GridMark {
                value: line as f64 * step_size,
                step_size,
            };
            lines.map(mark).collect()
        })
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .show(ui, |plot| {
            plot.set_plot_bounds_x(first..=last);
            plot.set_plot_bounds_y(0.0..=(HEADROOM * maximum).max(LEAST));
            for (series, read) in SERIES.iter().zip(read) {
                let points = history.points(read);
                if !points.is_empty() {
                    let line = Line::new(series.name, points).color(series.color);
                    plot.line(line.style(series.style()).width(1.5));
                }
            }
        });
}

/// A line of a chart.
struct Series {
    name: &'static str,
    color: Color32,
    is_dashed: bool,
}

const SERIES: [Series; 2] = [
    Series {
        name: "unisize",
        color: UNISIZE,
        is_dashed: false,
    },
    Series {
        name: "Rapier's default",
        color: DEFAULT,
        is_dashed: true,
    },
];

impl Series {
    fn style(&self) -> LineStyle {
        if self.is_dashed {
            LineStyle::Dashed { length: DASH }
        } else {
            LineStyle::Solid
        }
    }

    /// A sample of the line, and its name.
    fn show_in_legend(&self, ui: &mut Ui) {
        ui.add_space(4.0);
        let (rect, _) = ui.allocate_exact_size(vec2(20.0, 10.0), Sense::hover());
        let ends = [rect.left_center(), rect.right_center()];
        let stroke = Stroke::new(2.0, self.color);
        if self.is_dashed {
            ui.painter()
                .extend(Shape::dashed_line(&ends, stroke, DASH, DASH / 2.0));
        } else {
            ui.painter().line_segment(ends, stroke);
        }
        ui.label(RichText::new(self.name).color(self.color));
    }
}

/// The means over the last steps of the broad phase and of the whole step, for unisize and for the default.
pub(crate) fn means(history: &History, count: usize) -> [[Option<f64>; 2]; 2] {
    [BROAD_PHASE, STEP].map(|read| read.map(|read| history.mean(count, read)))
}

/// The smallest number of at least this size that is 1, 2 or 5 times a power of ten.
fn round_step(least: f64) -> f64 {
    let power = 10.0_f64.powf(least.log10().floor());
    let steps = [1.0, 2.0, 5.0].map(|step| step * power);
    // Rounding must not make a step of 2 one of 5.
    let step = steps.into_iter().find(|step| *step >= least * 0.999);
    step.unwrap_or(10.0 * power)
}

fn format_milliseconds(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::{format_milliseconds, means, round_step};
    use crate::history::{History, Sample};

    #[test]
    fn a_step_is_the_rest_and_one_broad_phase() {
        let mut history = History::new(8);
        history.push(Sample {
            unisize: Some(1.0),
            default: None,
            rest: 10.0,
        });
        assert_eq!(means(&history, 4), [[Some(1.0), None], [Some(11.0), None]]);
        history.push(Sample {
            unisize: Some(3.0),
            default: Some(7.0),
            rest: 20.0,
        });
        assert_eq!(
            means(&history, 4),
            [[Some(2.0), Some(7.0)], [Some(17.0), Some(27.0)]]
        );
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(format_milliseconds(0.0), "0");
        assert_eq!(format_milliseconds(0.5), "0.5");
        assert_eq!(format_milliseconds(0.25), "0.25");
        assert_eq!(format_milliseconds(20.0), "20");
        // As a multiple of a step comes out.
        assert_eq!(format_milliseconds(3.0 * 0.1), "0.3");
    }

    #[test]
    fn steps_are_round() {
        for (least, step) in [
            (0.3, 0.5),
            (0.5, 0.5),
            (1.01, 2.0),
            (2.1, 5.0),
            (70.0, 100.0),
        ] {
            assert!((round_step(least) - step).abs() < 1e-9, "{least}");
        }
    }
}
