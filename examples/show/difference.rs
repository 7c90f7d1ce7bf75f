//! How the pairs of the two broad phases differ.

use super::rivals::{Rivals, key};
use std::collections::BTreeSet;

/// How the pairs of the two broad phases differ, if both take part and they do. Those of unisize must have been asked for.
pub(super) fn difference(rivals: &Rivals) -> Option<String> {
    let (unisize, default) = (rivals.unisize.as_ref()?, rivals.default.as_ref()?);
    let listed: Vec<_> = unisize.inner.pairs().map(key).collect();
    let ours: BTreeSet<_> = listed.iter().copied().collect();
    if ours.len() != listed.len() {
        return Some("unisize lists a pair twice".to_owned());
    }
    let [told, rapiers] = [unisize.held(), default.held()]
        .map(|held| held.iter().copied().map(key).collect::<BTreeSet<_>>());
    if ours != told {
        return Some("the pairs that unisize lists are not those of its events".to_owned());
    }
    let (missing, spurious) = (rapiers.difference(&ours), ours.difference(&rapiers));
    let (missing, spurious): (Vec<_>, Vec<_>) = (missing.collect(), spurious.collect());
    let first = missing.first().or(spurious.first())?;
    Some(format!(
        "unisize misses {} pairs and has {} others; the first is {first:?}",
        missing.len(),
        spurious.len(),
    ))
}
