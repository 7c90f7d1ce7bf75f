//! The comparison reports nothing where there is nothing, and every kind of fault where there is one.

use super::super::pairs::{PairEvent, handles, in_order};
use super::super::rapier::parry::partitioning::Bvh;
use super::super::rapier::prelude::*;
use super::super::version::OwnBroadPhase;
use super::{AsQueryPipeline, Candidate, Comparison, Observed};
use crate::SceneKind;
use std::sync::{Arc, LazyLock, Mutex};

fn comparison(kind: SceneKind) -> Comparison {
    Comparison {
        steps: 40,
        repeats: 0,
        ..Comparison::new(kind, 150, 3)
    }
}

/// Rapier's own broad phase, with a list of its pairs.
type Listed = Observed<OwnBroadPhase>;

fn listed() -> Listed {
    Observed::new(OwnBroadPhase::new()).with_held()
}

fn list<B>(own: &Observed<B>) -> Vec<ColliderPair> {
    own.held().iter().copied().collect()
}

const QUERIES: AsQueryPipeline<Listed> = |own, dispatcher, bodies, colliders, filter| {
    let own = &own.inner;
    own.as_query_pipeline(dispatcher, bodies, colliders, filter)
};

/// The first difference if events are passed on as often as this says, and the list of pairs is as this leaves it.
fn difference(copies: fn(PairEvent) -> usize, edit: fn(&mut Vec<ColliderPair>)) -> Option<String> {
    let faulty = move || Observed::new(listed().repeating(copies)).with_held();
    let edited = move |faulty: &Observed<Listed>| {
        let mut list = list(faulty);
        edit(&mut list);
        list
    };
    let candidate = Candidate::new(
        faulty,
        edited,
        |faulty, dispatcher, bodies, colliders, filter| {
            let own = &faulty.inner.inner;
            own.as_query_pipeline(dispatcher, bodies, colliders, filter)
        },
    );
    // Long enough that pairs end.
    let comparison = Comparison {
        steps: 80,
        ..comparison(SceneKind::FallingBalls)
    };
    comparison.run(&[candidate]).first_difference
}

#[test]
fn default_equals_itself() {
    for kind in SceneKind::ALL {
        let candidate = Candidate::new(listed, list, QUERIES);
        let comparison = Comparison {
            rays: 10,
            ..comparison(kind)
        };
        let outcome = comparison.run(&[candidate]);
        let name = kind.name();
        assert_eq!(outcome.first_difference, None, "{name}");
        assert_eq!(outcome.pairs.default, outcome.pairs.candidate);
        assert_eq!(outcome.contact_checks, 40);
        let looks = if kind == SceneKind::Player { 16 } else { 0 };
        assert_eq!(outcome.rays.cast, 40 * (10 + looks));
        assert!(outcome.rays.hits > 0, "{name}");
    }
}

#[test]
fn whole_steps_are_sane() {
    let outcome = Comparison {
        repeats: 2,
        rays: 1,
        ..comparison(SceneKind::FallingBalls)
    }
    .run(&[Candidate::new(listed, list, QUERIES)]);
    assert!(outcome.is_equal());
    let whole_steps = outcome.whole_steps.expect("they were asked for");
    let seeds = whole_steps.repeats.iter().map(|repeat| repeat.seed);
    assert_eq!(seeds.collect::<Vec<_>>(), [3, 4]);
    for repeat in &whole_steps.repeats {
        let end = &repeat.end;
        assert_eq!(end.candidate.complaint, None);
        assert_eq!(end.default.bodies, end.candidate.bodies);
        assert!(repeat.ratio > 0.0 && repeat.ratio.is_finite());
        assert!(end.default.ms_per_step > 0.0);
    }
    let limit = whole_steps.limit.ratio;
    assert!(limit > 1.0 && limit.is_finite());
    let times = outcome.broad_phase;
    assert_eq!(times.default.updates, times.candidate.updates);
    // All but the first.
    assert!(times.default.updates >= 39);
    assert!(outcome.ratio > 0.0 && outcome.ratio.is_finite());
}

#[test]
fn whole_steps_are_timed_later_from_one_state() {
    let energies = |before| {
        let comparison = Comparison {
            steps: 1,
            before,
            repeats: 1,
            ..comparison(SceneKind::FallingBalls)
        };
        let outcome = comparison.run(&[Candidate::new(listed, list, QUERIES)]);
        let whole_steps = outcome.whole_steps.expect("they were asked for");
        let end = &whole_steps.repeats[0].end;
        [end.default.energy, end.candidate.energy]
    };
    let [early, late] = [0, 100].map(energies);
    // They have parted for a few steps only.
    assert!((late[0] - late[1]).abs() < 1e-3 * late[0], "{late:?}");
    assert!(late[0] < 0.9 * early[0], "{early:?} {late:?}");
}

#[test]
fn a_ray_that_misses_is_reported() {
    let blind: AsQueryPipeline<Listed> = |_, dispatcher, bodies, colliders, filter| {
        static NOTHING: LazyLock<Bvh> = LazyLock::new(Bvh::new);
        QueryPipeline {
            dispatcher,
            bvh: &NOTHING,
            bodies,
            colliders,
            filter,
        }
    };
    let candidate = Candidate::new(listed, list, blind);
    let comparison = Comparison {
        rays: 10,
        ..comparison(SceneKind::FallingBalls)
    };
    let difference = comparison.run(&[candidate]).first_difference;
    let difference = difference.expect("a difference");
    assert!(difference.contains(": the ray from"), "{difference}");
    assert!(
        difference.contains("and nothing by the candidate"),
        "{difference}"
    );
}

#[test]
fn a_forgotten_pair_is_named() {
    let forgotten = Arc::new(Mutex::new(Vec::new()));
    let log = forgotten.clone();
    let create = move || {
        let (log, mut added) = (log.clone(), 0);
        listed().repeating(move |event| {
            let pair = handles(in_order(event.pair()));
            // Every hundredth new pair with a ball, which comes after walls.
            added += usize::from(event.is_add() && pair[1].0 > 10);
            let is_forgotten = event.is_add() && pair[1].0 > 10 && added % 100 == 0;
            log.lock().unwrap().extend(is_forgotten.then_some(pair));
            usize::from(!is_forgotten)
        })
    };
    let candidates = [Candidate::new(create, list, QUERIES)];
    let mut comparison = comparison(SceneKind::FallingBalls);
    let outcome = comparison.run(&candidates);
    let difference = outcome.first_difference.expect("a difference");
    let named = forgotten.lock().unwrap().iter().any(|pair| {
        let mut ends = pair.iter();
        ends.all(|(index, generation)| difference.contains(&format!("{index}:{generation} (")))
    });
    assert!(named, "{difference}");
    let meaning = "is held by the default and not by the candidate";
    assert!(difference.contains(meaning), "{difference}");

    let step = difference
        .strip_prefix("step ")
        .and_then(|rest| rest.split_once(": "));
    let step: usize = step.unwrap().0.parse().unwrap();
    comparison.steps = step - 1;
    assert!(comparison.run(&candidates).is_equal());
}

#[test]
fn every_fault_is_reported() {
    let sound = |_| 1;
    let faithful = |_: &mut Vec<_>| {};
    let found = [
        difference(|event| usize::from(!event.is_add()), faithful),
        difference(|event| 1 + usize::from(event.is_add()), faithful),
        difference(|event| 2 - usize::from(event.is_add()), faithful),
        difference(|event| usize::from(event.is_add()), faithful),
        difference(sound, |list| list.truncate(list.len().saturating_sub(1))),
        difference(sound, |list| list.extend_from_within(..1.min(list.len()))),
    ];
    let words = [
        "held by the default and not by the candidate",
        "as new, which it holds already",
        "as ended, which it does not hold",
        "held by the candidate and not by the default",
        "does not list it",
        "twice",
    ];
    for (found, words) in found.into_iter().zip(words) {
        let difference = found.expect(words);
        assert!(difference.starts_with("step "), "{difference}");
        assert!(difference.contains(words), "{difference}");
    }
}

#[test]
fn a_broken_invariant_is_reported() {
    let sound = Candidate::new(listed, list, QUERIES);
    let candidate = sound.with_validation(|_| panic!("box {} is askew", 17));
    let outcome = comparison(SceneKind::FallingBalls).run(&[candidate]);
    let difference = outcome.first_difference.expect("a difference");
    assert!(difference.starts_with("step 1: "), "{difference}");
    assert!(difference.contains("box 17 is askew"), "{difference}");
}
