//! Draws lines over two logarithmic axes. They come from the standard input in JSON, each as its name and its points:
//!
//! ```text
//! cargo run --package unisize-charts --example lines -- TITLE X Y CHART.svg <<< '[["a line", [[1, 10], [2, 30]]]]'
//! ```

use anyhow::{Result, bail};
use unisize_charts::{Axis, Chart, Panel, Series, color};

fn main() -> Result<()> {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let [title, x, y, svg] = &arguments[..] else {
        bail!("TITLE X Y CHART.svg");
    };
    let lines: Vec<(String, Vec<(f64, f64)>)> = serde_json::from_reader(std::io::stdin())?;
    let colors = color::OURS.into_iter().chain(color::OTHERS).cycle();
    let series = lines.into_iter().zip(colors);
    let series = series.map(|((name, points), color)| Series::new(name, color, points));
    let [x, y] = [x, y].map(Axis::log);
    Chart::new(title, [Panel::new("", x, y, series)]).write_svg(svg.as_ref())
}
