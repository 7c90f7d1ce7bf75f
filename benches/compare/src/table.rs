//! The rows on standard output, and what is said of all rows of one dimension.

use crate::row::Row;
use serde_json::Value;
use unisize_scenes::{Both, End, Repeat};

/// The result of one comparison. Whole steps are of each broad phase alone, queries included, and so are the pairs without contact and the
/// sanity. In all other columns the default drives, and unisize follows.
pub(super) fn cells(row: &Row) -> Vec<(&'static str, Value)> {
    let outcome = &row.outcome;
    let mut cells = vec![
        ("scene", Value::from(row.scene.as_str())),
        ("bodies", outcome.bodies.into()),
        ("colliders", outcome.colliders.into()),
    ];
    if let Some(steps) = &outcome.whole_steps {
        let end = &steps.repeats[0].end;
        let verdict = |of: fn(&Both<End>) -> &End| {
            let mut repeats = steps.repeats.iter();
            let is_sane = repeats.all(|repeat| of(&repeat.end).complaint.is_none());
            if is_sane { "ok" } else { "BAD" }
        };
        let sanity = [verdict(|end| &end.default), verdict(|end| &end.candidate)];
        let without = [&end.default, &end.candidate].map(|end| end.pairs_without_contact);
        cells.extend([
            ("step ms", steps.ms_per_step.default.into()),
            ("ours", steps.ms_per_step.candidate.into()),
            ("ratio", steps.ratio.median.into()),
            ("lower", steps.ratio.lower.into()),
            ("upper", steps.ratio.upper.into()),
            ("limit", steps.limit.ratio.into()),
            ("without contact", without[0].into()),
            ("ours", without[1].into()),
            ("sanity", sanity.join("/").into()),
        ]);
    }
    cells.extend([
        ("pairs", outcome.pairs.default.into()),
        ("ours", outcome.pairs.candidate.into()),
        ("contacts", outcome.contacts_at_end.into()),
        ("intersections", outcome.intersections_at_end.into()),
        ("equal", if row.equal { "yes" } else { "NO" }.into()),
        (
            "broad phase ms",
            outcome.broad_phase.default.ms_per_step.into(),
        ),
        ("ours", outcome.broad_phase.candidate.ms_per_step.into()),
        ("ratio", outcome.ratio.into()),
    ]);
    cells
}

/// The lines beneath the table of one dimension: means, differences, and complaints about a simulation on one broad phase alone.
pub(super) fn footer(rows: &[Row]) -> String {
    let whole_steps = rows
        .iter()
        .filter_map(|row| row.outcome.whole_steps.as_ref());
    let mut lines = vec![format!(
        "\ngeometric mean of the ratios: whole step {:.3}, broad phase {:.2}",
        geometric_mean(whole_steps.map(|whole_steps| whole_steps.ratio.median)),
        geometric_mean(rows.iter().map(|row| row.outcome.ratio)),
    )];
    for row in rows {
        let place = format!("{} {}D", row.scene, row.dim);
        let difference = row.outcome.first_difference.iter();
        lines.extend(difference.map(|what| format!("DIFFERENCE in {place}: {what}")));
        let whole_steps = row.outcome.whole_steps.iter();
        for Repeat { seed, end, .. } in whole_steps.flat_map(|of| &of.repeats) {
            for (name, end) in [("default", &end.default), ("ours", &end.candidate)] {
                let complaint = end.complaint.iter();
                lines.extend(
                    complaint.map(|what| format!("{place} on {name}, seed {seed}: {what}")),
                );
            }
        }
    }
    lines.push(String::new());
    lines.join("\n")
}

/// The geometric mean; NaN of nothing.
fn geometric_mean(ratios: impl Iterator<Item = f64>) -> f64 {
    let logarithms: Vec<_> = ratios.map(f64::ln).collect();
    (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp()
}
