//! Small worlds at their limits, in one flavour of Rapier.

use super::{ours, scenes, space};

mod build;
mod stage;

use super::scenes::rapier::prelude::*;
use super::scenes::{BroadPhase, Observed, OwnBroadPhase, Steppable, World, install, on_own_tree};
use crate::stability::case::Case;
use crate::stability::caught::caught;
use crate::stability::probe::{End, Found, Probe};
use ours::{Settings, UnisizeBroadPhase};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use stage::Stage;
use std::ops::Range;

/// Runs a case from all of these starts, and compares the two broad phases step by step from the first `compared` ones. The work is
/// split across the threads of the current pool.
pub(crate) fn probe(case: &Case, starts: Range<u64>, compared: u64) -> Probe {
    let ours = |settings| Observed::new(UnisizeBroadPhase::with_settings(settings));
    probe_of(case, starts, compared, ours)
}

/// Like [`probe`], with another broad phase in the place of unisize.
fn probe_of<B: BroadPhase>(
    case: &Case,
    starts: Range<u64>,
    compared: u64,
    ours: impl Fn(Settings) -> Observed<B> + Sync,
) -> Probe {
    let compared = starts.start..starts.end.min(starts.start + compared);
    let ends = starts.into_par_iter().map(|seed| {
        let default = end(case, seed, DefaultBroadPhase::new);
        let ours = end(case, seed, || install(ours(Settings::default())));
        [default, ours]
    });
    let found = compared.into_par_iter().map(|seed| {
        let settings = Settings::default().with_filter(crate::FILTER_OF_DEFAULT);
        let on_tree = || Observed::new(on_own_tree(ours(settings)));
        match side_by_side(case, seed, || ours(settings)) {
            // Rapier 0.36 sweeps fast bodies through the tree, and the order of the tree's answers counts.
            found @ Found::Difference(_) => match side_by_side(case, seed, on_tree) {
                Found::Equal => Found::ByTree,
                _ => found.of_seed(seed),
            },
            found => found,
        }
    });
    Probe {
        ends: ends.collect(),
        equality: found.collect::<Vec<_>>().into_iter().collect(),
    }
}

/// How a world ends on a broad phase.
fn end<S: Steppable>(case: &Case, seed: u64, create: impl FnOnce() -> S) -> End {
    let run = || {
        let (mut stage, mut broad_phase) = (Stage::build(case, seed), create());
        for _ in 0..case.steps() {
            stage.world.step(broad_phase.for_step(), &(), &());
        }
        stage.has_failed()
    };
    match caught(run) {
        Ok(false) => End::Holds,
        Ok(true) => End::Fails,
        Err(message) => End::Panics(message),
    }
}

/// Steps two worlds side by side, on Rapier's own broad phase and on another one, with the events of each update in order. Both must
/// hold the same pairs after each step, and all bodies must be equal to the bit at the end.
fn side_by_side<B: BroadPhase>(
    case: &Case,
    seed: u64,
    ours: impl FnOnce() -> Observed<B>,
) -> Found {
    let panic = |message| Found::Difference(format!("a panic: {message}"));
    let mut stages = [Stage::build(case, seed), Stage::build(case, seed)];
    let mut default = install(Observed::new(OwnBroadPhase::new()).sorted().with_held());
    let mut ours = match caught(|| install(ours().sorted().with_held())) {
        Ok(ours) => ours,
        Err(message) => return panic(message),
    };
    for step in 1..=case.steps() {
        let [with_default, with_ours] = &mut stages;
        if caught(|| with_default.world.step(default.for_step(), &(), &())).is_err() {
            return Found::Panic;
        }
        if let Err(message) = caught(|| with_ours.world.step(ours.for_step(), &(), &())) {
            return panic(message);
        }
        if let Some(difference) = between(&with_default.world, &default, &ours) {
            return Found::Difference(format!("step {step}: {difference}"));
        }
    }
    let [default, ours] = stages.map(|stage| stage.motions());
    let mut pairs = default.iter().zip(&ours);
    match pairs.find(|(default, ours)| default != ours) {
        None => Found::Equal,
        Some((default, ours)) => Found::Difference(format!("at the end {default} and {ours}")),
    }
}

/// The difference between the pairs of two broad phases. Pairs that the narrow phase drops anyway do not count.
fn between<A, B>(world: &World, default: &Observed<A>, ours: &Observed<B>) -> Option<String> {
    if let Some(event) = ours.held_fault() {
        return Some(format!("unisize reports {event:?}, which changes nothing"));
    }
    let matters = |pair: &&ColliderPair| {
        let colliders = [pair.collider1, pair.collider2].map(|handle| world.colliders.get(handle));
        match colliders {
            [Some(a), Some(b)] => world.may_touch(a, b),
            // No broad phase should hold a pair of a removed collider.
            _ => true,
        }
    };
    let mut only_default = default.held().iter().filter(|&&pair| !ours.holds(pair));
    let mut only_ours = ours.held().iter().filter(|&&pair| !default.holds(pair));
    match (only_default.find(matters), only_ours.find(matters)) {
        (None, None) => None,
        (default, ours) => Some(format!(
            "Rapier's alone holds {default:?}, and unisize alone {ours:?}"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes::Seldom;
    use super::*;
    use crate::stability::family::Family;

    const STARTS: Range<u64> = 1..10;

    fn unisize(settings: Settings) -> Observed<UnisizeBroadPhase> {
        Observed::new(UnisizeBroadPhase::with_settings(settings))
    }

    /// Without pairs, all bodies fall through each other.
    #[test]
    fn a_broken_broad_phase_fails_alone() {
        for name in ["stacks", "mass-ratios", "spins"] {
            let family = Family::named(name);
            let case = family.case(family.range[0]);
            let probe = probe_of(&case, STARTS, 1, |settings| unisize(settings).silent());
            assert!(probe.alone().is_worse(2), "{name}");
            assert_eq!(probe.equality.differing, 1);
            assert!(!probe.is_sound(100));
        }
    }

    #[test]
    fn a_panic_is_not_put_down_to_rapier() {
        let case = Family::named("stacks").case(5.0);
        let panicking = |_| -> Observed<UnisizeBroadPhase> { panic!("on purpose") };
        let probe = probe_of(&case, STARTS, 1, panicking);
        assert_eq!(probe.equality.panicked, 0);
        let difference = probe.equality.difference.as_ref().unwrap();
        assert!(difference.contains("a panic: on purpose"), "{difference}");
        assert!(probe.panic_alone().is_some() && !probe.is_sound(1));
    }

    /// A pair that comes a step late is a difference, even if the colliders do not touch yet.
    #[test]
    fn one_pair_that_is_late_is_a_difference() {
        let case = Family::named("spins").case(10.0);
        let unisize = UnisizeBroadPhase::with_settings;
        let late = |settings| Observed::new(Seldom::new(unisize(settings), 3));
        let probe = probe_of(&case, 1..2, 1, late);
        assert!(!probe.is_sound(1));
        let difference = probe.equality.difference.unwrap();
        assert!(difference.contains("alone holds Some"), "{difference}");
    }

    /// Boxes at the largest finite speed make some versions of Rapier panic.
    #[test]
    fn a_panic_is_whose_it_is() {
        let extremes = Family::named("extremes");
        let case = extremes.case(extremes.range[1]);
        let settings = Settings::default().with_filter(crate::FILTER_OF_DEFAULT);
        let alone = end(&case, 1, || {
            install(Observed::new(OwnBroadPhase::new()).sorted())
        });
        let found = side_by_side(&case, 1, || unisize(settings));
        let panics = matches!(alone, End::Panics(_));
        assert_eq!(found == Found::Panic, panics, "{found:?}");
    }

    #[test]
    fn unisize_does_what_rapier_does() {
        for family in &Family::ALL {
            let values = family.values(5);
            let case = family.case(values[values.len() / 2]).lasting_at_most(0.5);
            let probe = probe(&case, STARTS, 1);
            assert_eq!(probe.equality.difference, None, "{}", family.name);
            assert!(probe.is_sound(1), "{}", family.name);
        }
    }
}
