//! Small worlds at their limits, in one flavour of Rapier.

use super::{flavour, ours, scenes, space, version};

mod build;
mod contender;
mod stage;
mod together;

use crate::stability::case::Case;
use crate::stability::caught::caught;
use crate::stability::end::End;
use crate::stability::probe::{Found, Probe, Seeds};
use contender::Contender;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use stage::Stage;

/// Runs a case from all its starts, on the threads of the current pool.
pub(crate) fn probe(case: &Case, seeds: &Seeds) -> Probe {
    probe_of(Contender::Ours, case, seeds)
}

fn probe_of(candidate: Contender, case: &Case, seeds: &Seeds) -> Probe {
    let ends = |contender| {
        let all = seeds.all.clone().into_par_iter();
        all.map(|seed| simulate(contender, case, seed)).collect()
    };
    let exact = |check: fn(Contender, &Case, u64) -> Found| {
        let exact = seeds.exact.clone().into_par_iter();
        let found = exact.map(|seed| check(candidate, case, seed).of_seed(seed));
        found.collect::<Vec<_>>().into_iter().collect()
    };
    Probe {
        default: ends(Contender::Rapier),
        ours: ends(candidate),
        in_order: exact(in_order),
        pairs: exact(together::compare),
    }
}

/// Compares the ends of a case if the events of each update are sorted.
fn in_order(candidate: Contender, case: &Case, seed: u64) -> Found {
    let [default, ours] = [Contender::RapierInOrder, candidate.in_order()]
        .map(|contender| simulate(contender, case, seed));
    match ours.compare(&default) {
        // Rapier 0.36 sweeps fast bodies through the tree, which has its answers in an order of its own.
        Found::Difference(_) if candidate == Contender::Ours => {
            let on_its_tree = simulate(Contender::OursOnRapiersTree, case, seed);
            match on_its_tree.compare(&default) {
                Found::Equal => Found::ByTree,
                _ => ours.compare(&default),
            }
        }
        found => found,
    }
}

/// One run of a case on one broad phase.
fn simulate(contender: Contender, case: &Case, seed: u64) -> End {
    simulate_steps(contender, case, seed, case.steps())
}

/// So many steps of it.
fn simulate_steps(contender: Contender, case: &Case, seed: u64, steps: usize) -> End {
    let run = || {
        let mut stage = Stage::build(case, seed);
        let mut broad_phase = contender.create();
        for _ in 0..steps {
            stage.world.step(broad_phase.for_step(), &(), &());
        }
        stage.measure()
    };
    End {
        measured: caught(run),
    }
}

#[cfg(test)]
mod tests {
    use super::contender::Contender;
    use super::{Seeds, probe_of};
    use crate::stability::family::Family;

    fn seeds() -> Seeds {
        Seeds {
            all: 1..10,
            exact: 1..2,
        }
    }

    /// What reports no pairs lets everything fall through everything.
    #[test]
    fn a_broken_broad_phase_fails_alone() {
        for name in ["stacks", "mass-ratios", "spins"] {
            let family = Family::named(name);
            let case = family.case(family.range[0]);
            let probe = probe_of(Contender::Blind, &case, &seeds());
            assert!(probe.ours_fails_alone(family.criterion, 2), "{name}");
            assert!(probe.in_order.difference.is_some());
            assert!(!probe.is_sound(family.criterion, 100));
        }
    }

    #[test]
    fn a_panic_is_not_put_down_to_rapier() {
        let family = Family::named("stacks");
        let probe = probe_of(Contender::Panicking, &family.case(5.0), &seeds());
        for check in [&probe.in_order, &probe.pairs] {
            assert_eq!(check.panicked, 0);
            let difference = check.difference.as_ref().unwrap();
            assert!(difference.contains("a panic: on purpose"), "{difference}");
        }
        assert!(probe.panic_alone().is_some());
        assert!(!probe.is_sound(family.criterion, 1));
    }

    #[test]
    fn unisize_does_what_rapier_does() {
        for family in &Family::ALL {
            let values = family.values(5);
            let case = family.case(values[values.len() / 2]).lasting_at_most(0.5);
            let probe = probe_of(Contender::Ours, &case, &seeds());
            assert_eq!(probe.in_order.difference, None, "{}", family.name);
            assert_eq!(probe.pairs.difference, None, "{}", family.name);
            assert!(probe.is_sound(family.criterion, 1), "{}", family.name);
        }
    }
}
