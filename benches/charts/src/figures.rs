//! The charts of the documentation.

use crate::rows::Row;
use anyhow::{Result, ensure};
use std::collections::BTreeSet;
use unisize_charts::{Axis, Chart, Panel, RGBColor, Series, color};

/// Contacts that methods miss against the time that they take. What missed nothing, but could have, is hollow.
pub(crate) fn missed(rows: &[Row]) -> Result<Chart> {
    let methods = rows.iter().filter(|row| row.is("kind", "method"));
    let series = methods.map(|row| {
        let name = row.text("method")?;
        let missed = row.number("missed_percent")?;
        let series = Series::new(name, color_of(name), [(missed, row.number("both")?)]).labelled();
        Ok(match name {
            "unisize" => series.bold(),
            _ if missed == 0.0 && !row.is("cannot_miss", true) => series.hollow(),
            _ => series,
        })
    });
    let panel = Panel::new(
        "",
        Axis::log("touching pairs that are missed in the worst scene, %")
            .with_zero("misses no contact"),
        Axis::log("time of broad and narrow phase, unisize = 1"),
        series.collect::<Result<Vec<_>>>()?,
    );
    let title = "Missed contacts against time: left is exact, low is fast";
    Ok(Chart::new(title, [panel]).without_legend())
}

/// Errors against computing time, a panel for each scene of one dimension, a curve for each method, and a point for each time step.
pub(crate) fn accuracy(rows: &[Row], dim: u64) -> Result<Chart> {
    let rows: Vec<_> = rows
        .iter()
        .filter(|row| row.is("kind", "curve") && row.is("dimension", dim))
        .collect();
    ensure!(!rows.is_empty(), "no curves of {dim}D");
    let panels = distinct(&rows, "scene")?.into_iter().map(|scene| {
        let rows: Vec<_> = rows
            .iter()
            .copied()
            .filter(|row| row.is("scene", scene))
            .collect();
        // Stretched joints say little: a missed contact takes load off them.
        let (error, title) = match rows.iter().any(|row| row.number("strayed").is_ok()) {
            true => ("strayed", "largest distance from its place, sizes"),
            false => ("penetration", "largest penetration, sizes"),
        };
        let mut methods = distinct(&rows, "method")?;
        // The first one is drawn above all others.
        let is_exact = |method| {
            rows.iter()
                .any(|row| row.is("method", method) && row.is("cannot_miss", true))
        };
        methods.sort_by_key(|&method| (!is_exact(method), method != "unisize"));
        let series = methods.into_iter().map(|method| {
            let of_method = rows.iter().filter(|row| row.is("method", method));
            let points = of_method.map(|row| Ok((row.number("ms")?, row.number(error)?)));
            Ok(Series::new(
                method,
                color_of(method),
                points.collect::<Result<Vec<_>>>()?,
            ))
        });
        Ok(Panel::new(
            format!("{scene}, {} bodies", rows[0].number("bodies")?),
            Axis::log("ms of computing per simulated second"),
            Axis::log(title),
            series.collect::<Result<Vec<_>>>()?,
        ))
    });
    let title =
        format!("Error against computing time, {dim}D, Rapier 0.27: low is accurate, left is fast");
    let note = "Points of a curve, from left to right: time steps of 1/30, 1/60, 1/120 and 1/240 s. Medians over the starts.";
    Ok(Chart::new(title, panels.collect::<Result<Vec<_>>>()?).note(note))
}

/// Nanoseconds per box over the number of boxes, a panel for each dimension at the higher of its densities.
pub(crate) fn peers(rows: &[Row]) -> Result<Chart> {
    let all: Vec<_> = rows.iter().collect();
    let mut names = distinct(&all, "contender")?;
    names.sort_by_key(|name| !name.starts_with("unisize"));
    let panels = [2, 3].map(|dim| {
        let rows: Vec<_> = rows.iter().filter(|row| row.is("dim", dim)).collect();
        let densities = rows.iter().map(|row| row.number("density"));
        let density = densities
            .collect::<Result<Vec<_>>>()?
            .into_iter()
            .fold(0.0, f64::max);
        let mut others = color::OTHERS.iter();
        let series = names.iter().map(|&name| {
            let color = match name {
                "unisize GridSweep" => color::RED,
                _ if name.starts_with("unisize") => color::SALMON,
                _ => *others.next().unwrap_or(&color::BLACK),
            };
            let of_name = rows.iter().filter(|row| {
                row.is("contender", name) && row.number("density").ok() == Some(density)
            });
            let points = of_name.map(|row| {
                let count = row.number("count")?;
                Ok((count, row.number("typical_ms")? * 1e6 / count))
            });
            let series = Series::new(name, color, points.collect::<Result<Vec<_>>>()?);
            Ok(if color == color::RED {
                series.bold()
            } else {
                series
            })
        });
        Ok(Panel::new(
            format!("{dim}D, density {density}"),
            Axis::log("n"),
            Axis::log("nanoseconds per box"),
            series.collect::<Result<Vec<_>>>()?,
        ))
    });
    let panels = panels.into_iter().collect::<Result<Vec<_>>>()?;
    Ok(Chart::new(
        "All overlapping pairs of n boxes (low is fast)",
        panels,
    ))
}

/// The model of a cluster: a line for the frames on each network, and one for the part of them that the network takes.
pub(crate) fn mpi(rows: &[Row]) -> Result<Chart> {
    let model: Vec<_> = rows.iter().filter(|row| row.is("what", "model")).collect();
    let colors = [[color::GREEN, color::MINT], [color::PURPLE, color::OCHRE]];
    let mut series = Vec::new();
    for (network, colors) in distinct(&model, "network")?.into_iter().zip(colors) {
        for ((field, part), color) in [
            ("frame_ms", "the frame"),
            ("network_ms", "the network's part of it"),
        ]
        .into_iter()
        .zip(colors)
        {
            let of_network = model.iter().filter(|row| row.is("network", network));
            let points = of_network.map(|row| Ok((row.number("processes")?, row.number(field)?)));
            series.push(Series::new(
                format!("{network}: {part}"),
                color,
                points.collect::<Result<Vec<_>>>()?,
            ));
        }
    }
    let panel = Panel::new(
        "",
        Axis::log("processes"),
        Axis::log("milliseconds"),
        series,
    );
    Ok(Chart::new(
        "A frame of 10⁹ boxes in 3D, by the model",
        [panel],
    ))
}

/// The different texts of a field, in the order of the rows.
fn distinct<'a>(rows: &[&'a Row], field: &str) -> Result<Vec<&'a str>> {
    let mut seen = BTreeSet::new();
    let texts = rows
        .iter()
        .map(|row| row.text(field))
        .collect::<Result<Vec<_>>>()?;
    Ok(texts
        .into_iter()
        .filter(|text| seen.insert(*text))
        .collect())
}

/// The colour of a method of the studies.
fn color_of(method: &str) -> RGBColor {
    match method {
        "unisize" => color::RED,
        "Rapier's" => color::BLUE,
        _ if method.starts_with("unisize") => color::SALMON,
        _ if method.starts_with("every") => color::PURPLE,
        "hash grid, cells of the largest" => color::GREEN,
        _ if method.starts_with("hash grid") => color::OCHRE,
        _ => color::GREY,
    }
}
