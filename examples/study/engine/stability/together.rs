//! Both broad phases in one world, which Rapier's drives: after each step they must hold the same pairs.
//!
//! Pairs that the narrow phase drops anyway do not count. The contacts of a world follow from the other pairs alone, so where
//! these agree, contacts do.

use super::contender::Contender;
use super::scenes::rapier::prelude::*;
use super::scenes::{Observed, OwnBroadPhase, Steppable, Tee, World, install};
use super::simulate_steps;
use super::stage::Stage;
use crate::stability::case::Case;
use crate::stability::caught::caught;
use crate::stability::probe::Found;

/// Compares the pairs held until the first difference. If something panics, the same steps are run with Rapier's own alone: if that
/// panics as well, there is nothing to compare, and if not, the panic is a difference.
pub(super) fn compare(candidate: Contender, case: &Case, seed: u64) -> Found {
    let mut steps = 0;
    let run = || {
        let mut stage = Stage::build(case, seed);
        // With events in order, the world takes the same course with Rapier's own alone.
        let heard = Observed::new(OwnBroadPhase::new()).with_held().sorted();
        let unheard = candidate.observed().with_held();
        let mut tee = install(Tee::new(heard, unheard));
        (1..=case.steps()).find_map(|step| {
            steps = step;
            stage.world.step(tee.for_step(), &(), &());
            let difference = between(&stage.world, &tee.heard, &tee.unheard)?;
            Some(format!("step {step}: {difference}"))
        })
    };
    match caught(run) {
        Ok(None) => Found::Equal,
        Ok(Some(difference)) => Found::Difference(difference),
        Err(message) => {
            match simulate_steps(Contender::RapierInOrder, case, seed, steps).measured {
                Ok(_) => Found::Difference(format!("a panic: {message}")),
                Err(_) => Found::Panic,
            }
        }
    }
}

/// How the pairs of two broad phases differ in this world, if they do.
fn between<A, B>(world: &World, default: &Observed<A>, ours: &Observed<B>) -> Option<String> {
    if let Some(event) = ours.held_fault() {
        return Some(format!("unisize reports {event:?}, which changes nothing"));
    }
    let matters = |pair: &ColliderPair| {
        let colliders = [pair.collider1, pair.collider2].map(|handle| world.colliders.get(handle));
        match colliders {
            [Some(a), Some(b)] => world.may_touch(a, b),
            // Nobody should hold what is not there.
            _ => true,
        }
    };
    let only_default = default.held().iter().filter(|&&pair| !ours.holds(pair));
    let only_ours = ours.held().iter().filter(|&&pair| !default.holds(pair));
    let [default, ours] = [
        only_default
            .filter(|pair| matters(pair))
            .collect::<Vec<_>>(),
        only_ours.filter(|pair| matters(pair)).collect(),
    ];
    let pair = default.iter().chain(&ours).next()?;
    Some(format!(
        "{} pairs are held by Rapier's alone and {} by unisize alone, such as {pair:?}",
        default.len(),
        ours.len()
    ))
}

#[cfg(test)]
mod tests {
    use super::{Contender, Observed, OwnBroadPhase, Stage, Steppable};
    use super::{between, compare, install, simulate_steps};
    use crate::stability::family::Family;
    use crate::stability::probe::Found;

    /// Boxes at the largest speed that there is make some versions of Rapier panic.
    #[test]
    fn a_panic_is_whose_it_is() {
        let extremes = Family::named("extremes");
        let case = extremes.case(extremes.range[1]);
        let steps = case.steps();
        let alone = simulate_steps(Contender::RapierInOrder, &case, 1, steps);
        let found = compare(Contender::Ours, &case, 1);
        assert_eq!(found == Found::Panic, alone.measured.is_err(), "{found:?}");
        // One that panics before Rapier's is not excused by what comes later.
        let found = compare(Contender::Panicking, &case, 1);
        assert!(matches!(found, Found::Difference(_)), "{found:?}");
    }

    #[test]
    fn what_one_holds_alone_is_a_difference() {
        let case = Family::named("stacks").case(10.0);
        let mut stage = Stage::build(&case, 1);
        let mut default = install(Observed::new(OwnBroadPhase::new()).with_held());
        stage.world.step(default.for_step(), &(), &());
        let default: &Observed<OwnBroadPhase> = &default;
        // It has not heard of anything yet.
        let ours = Contender::Ours.observed().with_held();
        let found = between(&stage.world, default, &ours).unwrap();
        assert!(found.contains("and 0 by unisize alone"), "{found}");
        assert_eq!(between(&stage.world, default, default), None);
    }
}
