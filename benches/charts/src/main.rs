//! Draws the charts of docs/figures from what is stored in benches/results. With --check, it writes nothing and fails if a chart
//! differs. `.ci/chart` calls it.

mod figures;
mod rows;

use anyhow::{Context, Result, bail};
use rows::Row;
use std::path::Path;

fn main() -> Result<()> {
    let is_check = match &std::env::args().skip(1).collect::<Vec<_>>()[..] {
        [] => false,
        [option] if option == "--check" => true,
        _ => bail!("the only option is --check"),
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |name| Row::read(&root.join("benches/results"), name);
    let charts = [
        ("missed-0-27", figures::missed(&read("missed")?)?),
        (
            "accuracy-3d-0-27",
            figures::accuracy(&read("accuracy-0.27")?, 3)?,
        ),
        ("peers-kernels", figures::peers(&read("peers")?)?),
        ("mpi", figures::mpi(&read("mpi")?)?),
    ];
    let mut differing = Vec::new();
    for (name, chart) in &charts {
        let file = root.join("docs/figures").join(name).with_extension("svg");
        match is_check {
            false => chart.write_svg(&file)?,
            true => {
                let old = std::fs::read_to_string(&file)
                    .with_context(|| format!("cannot read {name}.svg"))?;
                differing.extend((old != chart.svg()?).then_some(*name));
            }
        }
    }
    if !differing.is_empty() {
        bail!(
            "{} differ from benches/results; run .ci/chart",
            differing.join(", ")
        );
    }
    Ok(())
}
