//! The comparison reports nothing where there is nothing, and every kind of fault where there is one.

use super::rapier::prelude::*;
use super::version::{self, BroadPhase, OwnBroadPhase};
use super::{Candidate, Comparison, Outcome};
use crate::SceneKind;
use std::sync::{Arc, Mutex};

/// What a broad phase may do wrong.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fault {
    /// Nothing.
    None,
    /// Every hundredth new pair with a moving body goes unreported.
    ForgetsSome,
    /// No pair is ever reported.
    AddsNothing,
    /// New pairs are reported twice.
    AddsTwice,
    /// Ended pairs are reported twice.
    DeletesTwice,
    /// The end of a pair goes unreported.
    NeverDeletes,
    /// The list of pairs lacks the last.
    ListsTooFew,
    /// The list of pairs has the last twice.
    ListsTwice,
}

/// Rapier's broad phase with a fault.
struct Faulty {
    inner: OwnBroadPhase,
    fault: Fault,
    list: Vec<ColliderPair>,
    added: usize,
    updates: usize,
    forgotten: Arc<Mutex<Vec<(usize, ColliderPair)>>>,
}

impl Faulty {
    fn new(fault: Fault) -> Self {
        Self {
            inner: OwnBroadPhase::new(),
            fault,
            list: Vec::new(),
            added: 0,
            updates: 0,
            forgotten: Arc::default(),
        }
    }

    fn list(&self) -> Vec<ColliderPair> {
        let mut list = self.list.clone();
        match self.fault {
            Fault::ListsTooFew => drop(list.pop()),
            Fault::ListsTwice => list.extend(self.list.last()),
            _ => {}
        }
        list
    }

    /// How often an event is sent.
    fn copies(&mut self, added: bool, pair: ColliderPair, moves: bool) -> usize {
        match (self.fault, added) {
            (Fault::AddsNothing, true) | (Fault::NeverDeletes, false) => 0,
            (Fault::AddsTwice, true) | (Fault::DeletesTwice, false) => 2,
            (Fault::ForgetsSome, true) if moves => {
                self.added += 1;
                if self.added % 100 != 0 {
                    return 1;
                }
                self.forgotten.lock().unwrap().push((self.updates, pair));
                0
            }
            _ => 1,
        }
    }
}

impl BroadPhase for Faulty {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let mut inner_events = Vec::new();
        self.inner.update(
            params,
            colliders,
            bodies,
            modified,
            removed,
            &mut inner_events,
        );
        self.list.retain(|pair| {
            !removed.contains(&pair.collider1) && !removed.contains(&pair.collider2)
        });
        for event in inner_events {
            let (added, pair) = match event {
                BroadPhasePairEvent::AddPair(pair) => (true, pair),
                BroadPhasePairEvent::DeletePair(pair) => (false, pair),
            };
            if !added && !self.list.contains(&pair) {
                // Later versions also report the ends of pairs of what was removed.
                continue;
            }
            let moves = [pair.collider1, pair.collider2].iter().any(|&handle| {
                let parent = colliders.get(handle).and_then(Collider::parent);
                parent.is_some_and(|body| bodies[body].is_dynamic())
            });
            for _ in 0..self.copies(added, pair, moves) {
                if added {
                    self.list.push(pair);
                    events.push(BroadPhasePairEvent::AddPair(pair));
                } else {
                    self.list.retain(|&listed| listed != pair);
                    events.push(BroadPhasePairEvent::DeletePair(pair));
                }
            }
        }
        self.updates += 1;
    }

    version::when_boxes_are_handed_over! {
        fn set_aabbs(&mut self, params: &IntegrationParameters, colliders: &ColliderSet, boxes: &[(ColliderHandle, Aabb)]) {
            self.inner.set_aabbs(params, colliders, boxes);
        }

        fn bvh(&self) -> &Bvh {
            self.inner.bvh()
        }

        // A copy is sound.
        fn clone_box(&self) -> Box<dyn BroadPhase> {
            self.inner.clone_box()
        }
    }
}

fn comparison(kind: SceneKind) -> Comparison {
    Comparison {
        steps: 40,
        repeats: 0,
        ..Comparison::new(kind, 150, 3)
    }
}

fn run(fault: Fault) -> Outcome {
    let candidate = Candidate::new(move || Faulty::new(fault)).with_pairs(Faulty::list);
    // Long enough that pairs end.
    let comparison = Comparison {
        steps: 80,
        ..comparison(SceneKind::FallingBalls)
    };
    comparison.run(&candidate, |_| {})
}

#[test]
fn default_equals_itself() {
    for kind in SceneKind::ALL {
        let candidate = Candidate::new(|| Faulty::new(Fault::None)).with_pairs(Faulty::list);
        let outcome = comparison(kind).run(&candidate, |_| {});
        assert_eq!(outcome.first_difference, None, "{}", kind.name());
        assert_eq!(outcome.pairs.default, outcome.pairs.candidate);
        assert_eq!(outcome.contact_checks, 40);
        let timing = outcome.timing;
        assert_eq!(timing.default.updates, timing.candidate.updates);
        assert!(timing.default.updates >= 40 * version::UPDATES);
        assert_eq!(timing.default.busy_updates, timing.candidate.busy_updates);
    }
}

#[test]
fn independent_runs_are_sane() {
    let candidate = Candidate::new(OwnBroadPhase::new);
    let mut steps = 0;
    let outcome = Comparison {
        repeats: 2,
        contacts_every: 7,
        ..comparison(SceneKind::FallingBalls)
    }
    .run(&candidate, |step| {
        steps += 1;
        assert_eq!(step, steps);
    });
    assert_eq!(steps, 240);
    assert!(outcome.is_equal());
    assert_eq!(outcome.contact_checks, 6);
    assert_eq!(outcome.independent.len(), 2);
    for runs in &outcome.independent {
        assert_eq!(runs.candidate.verdict, Ok(()));
        assert_eq!(runs.default.sanity.bodies, runs.candidate.sanity.bodies);
        assert!(runs.ratio() > 0.0 && runs.ratio().is_finite());
    }
    let clocked = outcome.clocked.expect("a clocked run");
    assert!(clocked.limit() > 1.0 && clocked.limit().is_finite());
}

#[test]
fn a_forgotten_pair_is_named() {
    let forgotten = Arc::new(Mutex::new(Vec::new()));
    let shared = forgotten.clone();
    let candidate = Candidate::new(move || Faulty {
        forgotten: shared.clone(),
        ..Faulty::new(Fault::ForgetsSome)
    });
    let outcome = comparison(SceneKind::FallingBalls).run(&candidate, |_| {});
    let difference = outcome.first_difference.expect("a difference");

    let forgotten = forgotten.lock().unwrap();
    let step_of = |update: usize| update / version::UPDATES + 1;
    let step = step_of(forgotten[0].0);
    let named = forgotten
        .iter()
        .filter(|&&(update, _)| step_of(update) == step)
        .map(|&(_, pair)| pair)
        .any(|pair| {
            [pair.collider1, pair.collider2].iter().all(|handle| {
                let (index, generation) = handle.into_raw_parts();
                difference.contains(&format!("{index}:{generation} ("))
            })
        });
    assert!(named, "{difference}");
    assert!(
        difference.starts_with(&format!("step {step}: ")),
        "{difference}"
    );
    assert!(
        difference.contains("is held by the default and not by the candidate"),
        "{difference}"
    );
}

#[test]
fn every_fault_is_reported() {
    for (fault, words) in [
        (
            Fault::AddsNothing,
            "held by the default and not by the candidate",
        ),
        (Fault::AddsTwice, "as new, which it holds already"),
        (Fault::DeletesTwice, "as ended, which it does not hold"),
        (
            Fault::NeverDeletes,
            "held by the candidate and not by the default",
        ),
        (Fault::ListsTooFew, "does not list it"),
        (Fault::ListsTwice, "twice"),
    ] {
        let outcome = run(fault);
        let difference = outcome.first_difference.expect(words);
        assert!(difference.starts_with("step "), "{difference}");
        assert!(difference.contains(words), "{difference}");
        if matches!(fault, Fault::AddsTwice | Fault::DeletesTwice) {
            assert!(outcome.redundant_events.candidate > 0);
        }
        assert_eq!(outcome.redundant_events.default, 0);
    }
}

#[test]
fn a_broken_invariant_is_reported() {
    let candidate =
        Candidate::new(OwnBroadPhase::new).with_validation(|_| panic!("box {} is askew", 17));
    let outcome = comparison(SceneKind::FallingBalls).run(&candidate, |_| {});
    let difference = outcome.first_difference.expect("a difference");
    assert!(difference.starts_with("step 1: "), "{difference}");
    assert!(difference.contains("box 17 is askew"), "{difference}");
}
