//! How time grows with the work that has to be done.

use serde_json::Value;
use std::io;
use unisize_report::Report;

/// One method in one case, at some number of boxes.
pub(crate) struct Figures {
    pub(crate) count: usize,
    /// The least that has to be processed: boxes, pairs and events.
    pub(crate) work: f64,
    pub(crate) seconds: f64,
    /// Whether it took so long that a larger number is not tried.
    pub(crate) is_long: bool,
    /// What else is told of it.
    pub(crate) others: Vec<(&'static str, Value)>,
}

/// Measures with these numbers until it takes long, and reports the last one under this name of a case. The slope is that of log time
/// over log work, between the two largest numbers: 1 where they grow in proportion.
pub(crate) fn measure(
    case: &[(&'static str, Value)],
    counts: &[usize],
    run: impl Fn(usize) -> Option<Figures>,
    report: &mut Report,
) -> io::Result<()> {
    let mut all: Vec<Figures> = Vec::new();
    for &count in counts {
        if !all.last().is_some_and(|last| last.is_long) {
            all.extend(run(count));
        }
    }
    let slope = match &all[..] {
        [.., before, last] => {
            Some((last.seconds / before.seconds).ln() / (last.work / before.work).ln())
        }
        _ => None,
    };
    let Some(last) = all.last() else {
        return Ok(());
    };
    let mut row = case.to_vec();
    row.push(("count", last.count.into()));
    row.extend(last.others.iter().cloned());
    row.extend([
        ("ns_per_work", (last.seconds / last.work * 1e9).into()),
        ("slope_of_time", slope.into()),
    ]);
    report.row(&row)
}
