//! What is written of each value, threshold and shift, as a line of JSON.

use super::Outcome;
use super::probe::Exact;
use super::shift::{Cost, Kept, Shift};
use super::verdict::{Failures, Verdict};
use crate::statistics::Share;
use serde::Serialize;

/// A value that was tried.
#[derive(Serialize)]
pub(super) struct ProbeRow<'a> {
    dimension: u8,
    family: &'a str,
    parameter: &'a str,
    value: f64,
    rapier_failures: Failures,
    unisize_failures: Failures,
    verdict: Verdict,
    in_order: &'a Exact,
    pairs: &'a Exact,
}

impl<'a> ProbeRow<'a> {
    pub(super) fn of(outcome: &'a Outcome, index: usize, cases: usize) -> Self {
        let probe = &outcome.probes[&index];
        let criterion = outcome.family.criterion;
        let [rapier_failures, unisize_failures] = probe.failures(criterion);
        Self {
            dimension: outcome.dim,
            family: outcome.family.name,
            parameter: outcome.family.parameter,
            value: outcome.values[index],
            rapier_failures,
            unisize_failures,
            verdict: probe.verdict(criterion, cases),
            in_order: &probe.in_order,
            pairs: &probe.pairs,
        }
    }
}

/// The threshold of a family; nothing where the first value fails already.
#[derive(Serialize)]
pub(super) struct ThresholdRow<'a> {
    dimension: u8,
    family: &'a str,
    parameter: &'a str,
    neither_fails_up_to: Option<f64>,
    rapier: Option<f64>,
    unisize: Option<f64>,
    next: Option<f64>,
    /// Of the starts at the threshold, on either broad phase.
    failures_at_threshold: Option<Share>,
}

impl<'a> ThresholdRow<'a> {
    pub(super) fn of(outcome: &'a Outcome) -> Self {
        let value = |index: usize| outcome.values[index];
        let share = |index: usize| Share::of(0, outcome.probes[&index].ours.len());
        Self {
            dimension: outcome.dim,
            family: outcome.family.name,
            parameter: outcome.family.parameter,
            neither_fails_up_to: outcome.neither().map(value),
            rapier: outcome.thresholds[0].map(value),
            unisize: outcome.thresholds[1].map(value),
            next: outcome.failing().map(value),
            failures_at_threshold: outcome.neither().map(share),
        }
    }
}

/// A world that was shifted.
#[derive(Serialize)]
pub(super) struct ShiftRow {
    dimension: u8,
    scene: String,
    bodies: usize,
    ordinary: Cost,
    shift: Cost,
    aftermath: Cost,
    touching: Kept,
    difference: Option<String>,
}

impl ShiftRow {
    pub(super) fn of(shift: &Shift, dim: u8) -> Self {
        let [ordinary, of_shift, aftermath] = shift.costs();
        Self {
            dimension: dim,
            scene: shift.scenery.name(),
            bodies: shift.bodies,
            ordinary,
            shift: of_shift,
            aftermath,
            touching: shift.kept,
            difference: shift.difference.clone(),
        }
    }
}
