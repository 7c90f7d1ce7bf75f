//! How time and memory grow with the work that has to be done.

use crate::report::Report;
use serde_json::Value;
use std::io;

/// One method in one case, at some number of boxes.
pub(crate) struct Figures {
    pub(crate) count: usize,
    /// The least that has to be processed: boxes, pairs and events.
    pub(crate) work: f64,
    pub(crate) seconds: f64,
    pub(crate) bytes: f64,
    /// Whether it took so long that a larger number is not tried.
    pub(crate) is_long: bool,
    /// What else is told of it.
    pub(crate) others: Vec<(&'static str, Value)>,
}

/// What one method takes for the work of the easiest case, to compare with.
#[derive(Default)]
pub(crate) struct Growth {
    easiest: Option<f64>,
}

impl Growth {
    /// Measures with these numbers until it takes long, and reports the last one under this name of a case. The slopes are those of log
    /// time and log memory over log work, between the two largest numbers: 1 where they grow in proportion.
    pub(crate) fn report(
        &mut self,
        case: &[(&'static str, Value)],
        counts: &[usize],
        measure: impl Fn(usize) -> Option<Figures>,
        report: &mut Report,
    ) -> io::Result<()> {
        let mut all: Vec<Figures> = Vec::new();
        for &count in counts {
            if !all.last().is_some_and(|last| last.is_long) {
                all.extend(measure(count));
            }
        }
        let Some(last) = all.last() else {
            return Ok(());
        };
        let slope = |of: fn(&Figures) -> f64| match &all[..] {
            [.., before, last] => {
                Some((of(last) / of(before)).ln() / (last.work / before.work).ln())
            }
            _ => None,
        };
        let each = last.seconds / last.work * 1e9;
        let mut row = case.to_vec();
        row.push(("count", last.count.into()));
        row.extend(last.others.iter().cloned());
        row.extend([
            ("ns_per_work", each.into()),
            (
                "times_easiest",
                (each / *self.easiest.get_or_insert(each)).into(),
            ),
            ("slope_of_time", slope(|figures| figures.seconds).into()),
            ("bytes_a_box", (last.bytes / last.count as f64).into()),
            (
                "slope_of_memory",
                slope(|figures| figures.bytes.max(1.0)).into(),
            ),
        ]);
        report.row(&row)
    }
}
