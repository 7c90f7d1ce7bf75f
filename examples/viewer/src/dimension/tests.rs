//! Broad phases that replace each other during a simulation.

use super::Live;
use super::live::list_all;
use super::rapier::prelude::ContactPair;
use super::show::{HeldPairs, Show};
use super::{Pour, Ropes};
use super::watched::Watched;
use crate::choice::Choice;
use crate::setup::{KernelName, RAPIERS_MARGIN, Setup};
use crate::stage::Stage;

fn setup(choice: Choice, times_both: bool, kernel: KernelName) -> Setup {
    Setup {
        choice,
        times_both,
        kernel,
        margin: RAPIERS_MARGIN,
    }
}

#[test]
fn both_agree_whatever_came_before() {
    let mut stage = Live::<Pour>::new(200, &setup(Choice::Default, false, KernelName::GridSweep));
    for choice in [Choice::Unisize, Choice::Default] {
        for kernel in KernelName::ALL {
            for times_both in [false, true] {
                stage.change(&setup(choice, times_both, kernel));
                for _ in 0..20 {
                    let sample = stage.step();
                    let takes_part = |side| times_both || side == choice;
                    assert_eq!(sample.unisize.is_some(), takes_part(Choice::Unisize));
                    assert_eq!(sample.default.is_some(), takes_part(Choice::Default));
                    assert_eq!(stage.agree(), times_both.then_some(true));
                }
                assert!(!stage.pair_lines().is_empty());
            }
        }
    }
    assert_eq!(stage.steps(), 240);
}

/// Rapier must not keep pairs that no broad phase will end.
#[test]
fn pairs_are_inherited_or_ended() {
    let wide = Setup {
        margin: 0.1,
        ..setup(Choice::Unisize, false, KernelName::GridSweep)
    };
    let mut ropes = Ropes::build(80);
    let mut watched = Watched::new(&wide, true);
    let mut step = |watched: &mut Watched, lists_all: bool| {
        let world = ropes.world();
        if lists_all {
            list_all(&mut world.colliders);
        }
        world.step(watched, &(), &());
        let held = watched.pairs();
        let contacts = world.narrow_phase.contact_pairs();
        let is_held = |pair: &ContactPair| {
            held.iter().any(|held| {
                let held = [held.collider1, held.collider2];
                held.contains(&pair.collider1) && held.contains(&pair.collider2)
            })
        };
        let (held, orphans): (Vec<_>, Vec<_>) = contacts.partition(|pair| is_held(pair));
        [held.len(), orphans.len()]
    };
    for _ in 0..60 {
        assert_eq!(step(&mut watched, false)[1], 0);
    }
    let [before, _] = step(&mut watched, false);
    for choice in [Choice::Default, Choice::Unisize] {
        watched.succeeded_by(&setup(choice, false, KernelName::GridSweep));
        let [after, orphans] = step(&mut watched, true);
        assert_eq!(orphans, 0);
        assert!(0 < after && after < before);
    }
}
