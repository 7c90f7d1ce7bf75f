//! Runs one comparison: one source, compiled once in each dimension.

use super::{DIM, ours, scenes};
use crate::case::Case;
use crate::options::{Kernel, Options, name};
use crate::row::{End, Limit, Rays, Repeat, Row, Sides, Times, Total, WholeSteps};
use crate::spread::Spread;
use ours::{Settings, UnisizeBroadPhase};
use scenes::{Both, Candidate, Clocked, Comparison, Independent, QueryAccess, Tally, Timing};
use std::time::Duration;
use unisize::PairFilter;

/// Compares in one case; `on_step` is called after each simulated step.
pub(crate) fn compare(case: Case, options: &Options, mut on_step: impl FnMut(usize)) -> Row {
    let comparison = Comparison {
        steps: options.steps(),
        contacts_every: options.contacts_every,
        rays: options.rays,
        repeats: options.repeats(),
        ..Comparison::new(case.kind, options.bodies(case), options.seed)
    };
    let filter = PairFilter::from(options.filter);
    let outcome = match filter {
        PairFilter::Shapes => {
            // The default's pairs are all of those whose boxes overlap: so first, it is these that must be the same.
            let boxes = Comparison {
                repeats: 0,
                ..comparison
            };
            let mut boxes = boxes.run(&candidate(options, crate::FILTER_OF_DEFAULT), &mut on_step);
            let shapes = candidate(options, filter).leaving_out_more();
            let mut outcome = comparison.run(&shapes, |step| on_step(comparison.steps + step));
            outcome.first_difference = boxes.first_difference.take().or(outcome.first_difference);
            outcome
        }
        _ => comparison.run(&candidate(options, filter), on_step),
    };
    Row {
        rapier: crate::RAPIER,
        scene: case.name(),
        dim: DIM,
        steps: outcome.steps,
        bodies: outcome.bodies,
        colliders: outcome.colliders,
        seed: options.seed,
        kernel: name(options.kernel),
        filter: name(options.filter),
        threads: options.threads,
        equal: outcome.is_equal(),
        ratio: outcome.ratio(),
        pairs: sides(&outcome.pairs, |&count| count),
        pairs_with_dropped: sides(&outcome.pairs_with_dropped, |&count| count),
        contacts: total(outcome.contacts),
        intersections: total(outcome.intersections),
        contact_checks: outcome.contact_checks,
        rays: Rays {
            a_step: options.rays,
            cast: outcome.rays.cast,
            hits: outcome.rays.hits,
        },
        redundant_events: sides(&outcome.redundant_events, |&count| count),
        broad_phase: sides(&outcome.timing, |timing| times(timing, outcome.steps)),
        whole_steps: outcome
            .clocked
            .and_then(|clocked| whole_steps(&outcome.independent, clocked, outcome.steps)),
        first_difference: outcome.first_difference,
    }
}

fn candidate(options: &Options, filter: PairFilter) -> Candidate<UnisizeBroadPhase> {
    let kernel = match options.kernel {
        Kernel::GridSweep => ours::Kernel::GridSweep,
        Kernel::RankSweep => ours::Kernel::RankSweep,
        Kernel::BruteForce => ours::Kernel::BruteForce,
    };
    let settings = Settings::default().with_kernel(kernel).with_filter(filter);
    let candidate = Candidate::new(move || UnisizeBroadPhase::with_settings(settings))
        .with_pairs(|ours: &UnisizeBroadPhase| ours.pairs().collect())
        .with_queries(QueryAccess::new(
            UnisizeBroadPhase::as_query_pipeline,
            UnisizeBroadPhase::as_query_pipeline_mut,
        ));
    if options.validate {
        candidate.with_validation(UnisizeBroadPhase::validate)
    } else {
        candidate
    }
}

fn sides<T, U>(both: &Both<T>, convert: impl Fn(&T) -> U) -> Sides<U> {
    Sides {
        default: convert(&both.default),
        ours: convert(&both.candidate),
    }
}

fn whole_steps(runs: &[Both<Independent>], clocked: Clocked, steps: usize) -> Option<WholeSteps> {
    let repeats: Vec<_> = runs
        .iter()
        .map(|runs| Repeat {
            seed: runs.default.seed,
            ratio: runs.ratio(),
            end: sides(runs, |run| end(run, steps)),
        })
        .collect();
    let spread = |figure: fn(&Repeat) -> f64| Spread::of(repeats.iter().map(figure));
    Some(WholeSteps {
        ms_per_step: Sides {
            default: spread(|repeat| repeat.end.default.ms_per_step)?.median,
            ours: spread(|repeat| repeat.end.ours.ms_per_step)?.median,
        },
        ratio: spread(|repeat| repeat.ratio)?,
        limit: Limit {
            ms_per_step: ms(clocked.elapsed) / steps as f64,
            ms_of_broad_phase: ms(clocked.broad_phase) / steps as f64,
            ratio: clocked.limit(),
        },
        repeats,
    })
}

fn total(tally: Tally) -> Total {
    Total {
        at_end: tally.at_end,
        over_all_steps: tally.total,
    }
}

fn ms(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e3
}

fn times(timing: &Timing, steps: usize) -> Times {
    Times {
        ms_per_step: ms(timing.total) / steps as f64,
        ms_per_busy_update: ms(timing.mean_busy()),
        ms_worst_update: ms(timing.worst),
        updates: timing.updates,
        busy_updates: timing.busy_updates,
    }
}

fn end(run: &Independent, steps: usize) -> End {
    let sanity = &run.sanity;
    End {
        complaint: run.verdict.clone().err(),
        bodies: sanity.bodies,
        asleep: sanity.sleeping,
        outside: sanity.fallen_through,
        not_finite: sanity.not_finite,
        energy: sanity.energy(),
        max_rope_stretch: sanity.max_rope_stretch,
        pairs_without_contact: run.pairs_without_contact,
        ms_per_step: ms(run.elapsed) / steps as f64,
        ms_of_rays: ms(run.casting) / steps as f64,
    }
}
